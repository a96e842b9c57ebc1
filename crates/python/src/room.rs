//! Light in the scenes of the crate `room`, for Python: the coefficients of sensors for the sky and for the sun.

use crate::arrays;
use crate::errors::{self, mistake};
use crate::scene::PyScene;
use crate::sky::PySkyBasis;
use numpy::{IntoPyArray, PyArray3, PyReadonlyArray1, PyReadonlyArray2, ndarray::Array2, ndarray::Array3};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use room::{Component, Progress, Settings};

fn table<'py>(py: Python<'py>, values: Vec<f64>, columns: usize) -> PyResult<Bound<'py, PyAny>> {
    let rows = values.len() / columns;
    Array2::from_shape_vec((rows, columns), values).map(|a| a.into_pyarray(py).into_any()).map_err(mistake)
}

fn put(into: &Bound<'_, PyDict>, name: &str, component: Component, columns: usize) -> PyResult<()> {
    let py = into.py();
    into.set_item(name, table(py, component.value, columns)?)?;
    into.set_item(format!("{name}_standard_error"), table(py, component.standard_error, columns)?)
}

/// Asks Python between rounds: signals first, then the caller's own function. Errors are kept for afterwards.
struct Watch {
    progress: Option<Py<PyAny>>,
    raised: Option<PyErr>,
}

impl Watch {
    fn go_on(&mut self, p: Progress) -> bool {
        Python::attach(|py| {
            // Ctrl-C stops the work and keeps what is there
            if let Err(signal) = py.check_signals() {
                if !signal.is_instance_of::<pyo3::exceptions::PyKeyboardInterrupt>(py) {
                    self.raised = Some(signal);
                }
                return false;
            }
            let Some(progress) = &self.progress else { return true };
            match progress.call1(py, (p.rounds, p.expected_rounds, p.worst_relative_error, p.seconds)) {
                Ok(answer) => !answer.bind(py).is(pyo3::types::PyBool::new(py, false)),
                Err(error) => {
                    self.raised = Some(error);
                    false
                }
            }
        })
    }
}

/// Runs `work` on so many threads, or on all there are.
fn on_threads<T: Send>(threads: Option<usize>, work: impl FnOnce() -> T + Send) -> PyResult<T> {
    match threads {
        None => Ok(work()),
        Some(0) => Err(mistake("threads must be 1 or more, got 0; leave it out to use all")),
        Some(n) => Ok(rayon::ThreadPoolBuilder::new().num_threads(n).build().map_err(mistake)?.install(work)),
    }
}

/// Daylight coefficients with their standard errors, (sensor, patch) [sr].
#[pyfunction]
#[pyo3(signature = (scene, points, normals, basis, *, seed=0, rounds=16, nodes=512, window_samples=512, max_bounces=None,
    target_relative_error=None, max_rounds=4096, weights=None, threads=None, progress=None))]
#[allow(clippy::too_many_arguments)]
fn daylight_coefficients<'py>(
    py: Python<'py>,
    scene: &PyScene,
    points: PyReadonlyArray2<'_, f64>,
    normals: PyReadonlyArray2<'_, f64>,
    basis: &PySkyBasis,
    seed: u64,
    rounds: usize,
    nodes: usize,
    window_samples: usize,
    max_bounces: Option<u32>,
    target_relative_error: Option<f64>,
    max_rounds: usize,
    weights: Option<PyReadonlyArray1<'_, f64>>,
    threads: Option<usize>,
    progress: Option<Py<PyAny>>,
) -> PyResult<Bound<'py, PyDict>> {
    let (points, normals) = (arrays::points("points", &points)?, arrays::points("normals", &normals)?);
    let weights = weights.map(|w| w.as_array().to_vec());
    let settings = Settings {
        seed,
        rounds,
        nodes,
        window_samples,
        max_bounces,
        target_relative_error,
        max_rounds,
        weights,
        any_sun: false,
    };
    let mut watch = Watch { progress, raised: None };
    let found = py.detach(|| {
        on_threads(threads, || {
            room::daylight_coefficients(&scene.0, &points, &normals, &basis.0, &settings, |p| watch.go_on(p))
        })
    })?;
    if let Some(raised) = watch.raised {
        return Err(raised);
    }
    let found = found.map_err(errors::room)?;
    let result = PyDict::new(py);
    put(&result, "direct", found.direct, found.patches)?;
    put(&result, "redirected", found.redirected, found.patches)?;
    put(&result, "interreflected", found.interreflected, found.patches)?;
    result.set_item("weighted", found.weighted.value.into_pyarray(py))?;
    result.set_item("weighted_standard_error", found.weighted.standard_error.into_pyarray(py))?;
    result.set_item("lost", found.lost.map(|lost| table(py, lost, found.patches)).transpose()?)?;
    result.set_item("rounds", found.rounds)?;
    result.set_item("interrupted", found.interrupted)?;
    result.set_item("converged", found.converged)?;
    result.set_item("seconds", found.seconds)?;
    Ok(result)
}

/// Direct and redirected coefficients by one ray at each sector's centre, as published, (sensor, patch) [sr].
#[pyfunction]
fn centre_coefficients<'py>(
    py: Python<'py>,
    scene: &PyScene,
    points: PyReadonlyArray2<'_, f64>,
    normals: PyReadonlyArray2<'_, f64>,
    basis: &PySkyBasis,
) -> PyResult<Bound<'py, PyDict>> {
    let (points, normals) = (arrays::points("points", &points)?, arrays::points("normals", &normals)?);
    let found = py.detach(|| room::centre_coefficients(&scene.0, &points, &normals, &basis.0)).map_err(errors::room)?;
    let result = PyDict::new(py);
    result.set_item("direct", table(py, found.direct, found.patches)?)?;
    result.set_item("redirected", table(py, found.redirected, found.patches)?)?;
    Ok(result)
}

/// Illuminance by each sun over the sun's normal illuminance, (sensor, sun); `sun_directions` point to the sun.
#[pyfunction]
#[pyo3(signature = (scene, points, normals, sun_directions, *, seed=0, rounds=8, nodes=1024, disc_samples=1, max_bounces=None,
    any_sun=false, threads=None, progress=None))]
#[allow(clippy::too_many_arguments)]
fn sun_coefficients<'py>(
    py: Python<'py>,
    scene: &PyScene,
    points: PyReadonlyArray2<'_, f64>,
    normals: PyReadonlyArray2<'_, f64>,
    sun_directions: PyReadonlyArray2<'_, f64>,
    seed: u64,
    rounds: usize,
    nodes: usize,
    disc_samples: usize,
    max_bounces: Option<u32>,
    any_sun: bool,
    threads: Option<usize>,
    progress: Option<Py<PyAny>>,
) -> PyResult<Bound<'py, PyDict>> {
    let (points, normals) = (arrays::points("points", &points)?, arrays::points("normals", &normals)?);
    let suns = arrays::points("sun_directions", &sun_directions)?;
    let settings = Settings { seed, rounds, nodes, max_bounces, any_sun, ..Settings::default() };
    let mut watch = Watch { progress, raised: None };
    let found = py.detach(|| {
        on_threads(threads, || {
            let go_on = |p| watch.go_on(p);
            room::sun_coefficients(&scene.0, &points, &normals, &suns, disc_samples, &settings, go_on)
        })
    })?;
    if let Some(raised) = watch.raised {
        return Err(raised);
    }
    let found = found.map_err(errors::room)?;
    let result = PyDict::new(py);
    put(&result, "direct", found.direct, found.suns)?;
    put(&result, "redirected", found.redirected, found.suns)?;
    put(&result, "interreflected", found.interreflected, found.suns)?;
    result.set_item("cut_off", found.cut_off.into_pyarray(py))?;
    result.set_item("lost", found.lost.map(|lost| table(py, lost, found.suns)).transpose()?)?;
    result.set_item("rounds", found.rounds)?;
    result.set_item("interrupted", found.interrupted)?;
    result.set_item("seconds", found.seconds)?;
    Ok(result)
}

/// The light of any one sun on some sensors: rounds of paths that are followed once and kept.
#[pyclass(name = "AnySun", module = "clerestory._native", frozen)]
struct PyAnySun {
    scene: Py<PyScene>,
    kept: room::AnySun,
}

#[pymethods]
impl PyAnySun {
    #[new]
    #[pyo3(signature = (scene, points, normals, *, seeds, rounds, nodes))]
    fn new(
        py: Python<'_>,
        scene: Py<PyScene>,
        points: PyReadonlyArray2<'_, f64>,
        normals: PyReadonlyArray2<'_, f64>,
        seeds: Vec<u64>,
        rounds: usize,
        nodes: usize,
    ) -> PyResult<Self> {
        let (points, normals) = (arrays::points("points", &points)?, arrays::points("normals", &normals)?);
        let settings = Settings { rounds, nodes, ..Settings::default() };
        let inner = scene.get();
        let kept =
            py.detach(|| room::AnySun::new(&inner.0, &points, &normals, &seeds, &settings)).map_err(errors::room)?;
        Ok(Self { scene, kept })
    }

    /// Illuminance by one sun over its normal illuminance in the rounds from `first` up to `end`, (round, part, sensor): direct,
    /// redirected, interreflected. The rounds of one seed follow those of another.
    fn light<'py>(
        &self,
        py: Python<'py>,
        sun_direction: PyReadonlyArray2<'_, f64>,
        first: usize,
        end: usize,
    ) -> PyResult<Bound<'py, PyArray3<f64>>> {
        let towards = arrays::directions("sun_direction", &sun_direction)?;
        let [towards] = towards[..] else { return Err(mistake("sun_direction must be one direction")) };
        let most = self.kept.rounds();
        if first > end || end > most {
            return Err(mistake(format!("rounds must lie in 0..{most}, got {first}..{end}")));
        }
        let scene = &self.scene.get().0;
        let rounds = py.detach(|| self.kept.light(scene, towards, first..end)).map_err(errors::room)?;
        let sensors = rounds.first().map_or(0, Vec::len);
        let table = Array3::from_shape_fn((rounds.len(), 3, sensors), |(round, part, s)| rounds[round][s][part]);
        Ok(table.into_pyarray(py))
    }

    /// Memory of the paths.
    #[getter]
    fn nbytes(&self) -> usize {
        self.kept.bytes()
    }
}

/// Adds all of this file to the module.
pub fn register(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_class::<PyAnySun>()?;
    module.add_function(wrap_pyfunction!(daylight_coefficients, module)?)?;
    module.add_function(wrap_pyfunction!(centre_coefficients, module)?)?;
    module.add_function(wrap_pyfunction!(sun_coefficients, module)?)
}
