//! The crate `room` for Python: scenes, and the daylight coefficients of sensors in them.

use crate::arrays::{directions, points};
use crate::errors::{self, mistake};
use crate::glazing::PyGlazing;
use crate::sky::PySkyBasis;
use hemisphere::Vec3;
use numpy::{IntoPyArray, PyArray1, PyArray3, PyReadonlyArray1, PyReadonlyArray2, ndarray::Array2, ndarray::Array3};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use room::{Component, Material, Medium, Progress, Scene, SceneBuilder, Settings};

/// Shares of light that an opaque surface reflects, on both sides.
#[pyclass(name = "Material", module = "clerestory._native", frozen)]
pub struct PyMaterial(Material);

#[pymethods]
impl PyMaterial {
    #[new]
    #[pyo3(signature = (diffuse, specular=0.0))]
    fn new(diffuse: f64, specular: f64) -> PyResult<Self> {
        Material { diffuse, specular }.check("material").map(Self).map_err(errors::room)
    }

    #[getter]
    fn diffuse(&self) -> f64 {
        self.0.diffuse
    }

    #[getter]
    fn specular(&self) -> f64 {
        self.0.specular
    }
}

/// A scene being put together.
#[pyclass(name = "SceneBuilder", module = "clerestory._native")]
#[derive(Default)]
pub struct PySceneBuilder(SceneBuilder);

fn triangles(array: &PyReadonlyArray2<'_, i64>) -> PyResult<Vec<[i64; 3]>> {
    let rows = array.as_array();
    if rows.ncols() != 3 {
        return Err(mistake(format!("triangles must have shape (any, 3), got {:?}", rows.shape())));
    }
    Ok(rows.outer_iter().map(|row| [row[0], row[1], row[2]]).collect())
}

#[pymethods]
impl PySceneBuilder {
    #[new]
    fn new() -> Self {
        Self::default()
    }

    /// An opaque polygon with holes.
    #[pyo3(signature = (name, outline, material, holes=Vec::new()))]
    fn polygon(
        &mut self,
        name: &str,
        outline: PyReadonlyArray2<'_, f64>,
        material: &PyMaterial,
        holes: Vec<PyReadonlyArray2<'_, f64>>,
    ) -> PyResult<()> {
        let holes = holes.iter().map(|hole| points(name, hole)).collect::<PyResult<Vec<_>>>()?;
        self.0.polygon(name, &points(name, &outline)?, &holes, material.0).map_err(errors::room)
    }

    /// An opaque triangle mesh.
    fn mesh(
        &mut self,
        name: &str,
        vertices: PyReadonlyArray2<'_, f64>,
        triangles: PyReadonlyArray2<'_, i64>,
        material: &PyMaterial,
    ) -> PyResult<()> {
        let triangles = self::triangles(&triangles)?;
        self.0.mesh(name, &points(name, &vertices)?, &triangles, material.0).map_err(errors::room)
    }

    /// A window whose outline runs anticlockwise as seen from the room.
    #[pyo3(signature = (name, outline, glazing, up=None, wall=None))]
    fn window(
        &mut self,
        name: &str,
        outline: PyReadonlyArray2<'_, f64>,
        glazing: &PyGlazing,
        up: Option<[f64; 3]>,
        wall: Option<&str>,
    ) -> PyResult<()> {
        let outline = points(name, &outline)?;
        self.0.window(name, &outline, glazing.0.clone(), up.map(Vec3::from_array), wall).map_err(errors::room)
    }

    /// A boundary between media, each an index and an absorption per metre; `front` is where the right-hand normal points.
    fn interface(
        &mut self,
        name: &str,
        vertices: PyReadonlyArray2<'_, f64>,
        triangles: PyReadonlyArray2<'_, i64>,
        front: (f64, f64),
        back: (f64, f64),
    ) -> PyResult<()> {
        let triangles = self::triangles(&triangles)?;
        let medium = |(n, absorption_per_m)| Medium { n, absorption_per_m };
        self.0.interface(name, &points(name, &vertices)?, &triangles, medium(front), medium(back)).map_err(errors::room)
    }

    /// Checks the whole, indexes it and freezes it; the builder is empty afterwards.
    fn build(&mut self, py: Python<'_>) -> PyResult<PyScene> {
        let builder = std::mem::take(&mut self.0);
        py.detach(|| builder.build()).map(PyScene).map_err(errors::room)
    }
}

/// A checked, indexed scene.
#[pyclass(name = "Scene", module = "clerestory._native", frozen)]
pub struct PyScene(Scene);

#[pymethods]
impl PyScene {
    /// Names, in the order they were added.
    #[getter]
    fn surfaces(&self) -> Vec<&str> {
        self.0.surfaces.iter().map(|s| s.name.as_str()).collect()
    }

    /// "opaque", "window" or "interface" for each.
    #[getter]
    fn kinds(&self) -> Vec<&'static str> {
        self.0.surfaces.iter().map(|s| s.kind.name()).collect()
    }

    /// Area of each [m²].
    #[getter]
    fn areas<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        self.0.surfaces.iter().map(|s| s.area).collect::<Vec<_>>().into_pyarray(py)
    }

    /// Triangles for drawing, (triangle, corner, 3), and the surface of each.
    fn triangles<'py>(&self, py: Python<'py>) -> (Bound<'py, PyArray3<f64>>, Bound<'py, PyArray1<i64>>) {
        let (mut corners, mut surface) = (Vec::new(), Vec::new());
        for facet in self.0.facets() {
            for triangle in facet.triangles() {
                corners.push(triangle);
                surface.push(i64::from(facet.surface));
            }
        }
        let corners = Array3::from_shape_fn((corners.len(), 3, 3), |(t, c, k)| corners[t][c][k]);
        (corners.into_pyarray(py), surface.into_pyarray(py))
    }

    /// How far each ray goes [m] and which surface it meets; infinity and -1 in the open.
    #[allow(clippy::type_complexity)]
    fn closest<'py>(
        &self,
        py: Python<'py>,
        origins: PyReadonlyArray2<'_, f64>,
        directions: PyReadonlyArray2<'_, f64>,
    ) -> PyResult<(Bound<'py, PyArray1<f64>>, Bound<'py, PyArray1<i64>>)> {
        let (origins, directions) = (points("origins", &origins)?, self::directions("directions", &directions)?);
        if origins.len() != directions.len() {
            let (n, m) = (origins.len(), directions.len());
            return Err(mistake(format!("directions must have one row for each of {n} origins, got {m}")));
        }
        let (distance, surface): (Vec<f64>, Vec<i64>) = py.detach(|| {
            origins
                .iter()
                .zip(&directions)
                .map(|(o, d)| self.0.closest(*o, **d).map_or((f64::INFINITY, -1), |(t, s)| (t, i64::from(s))))
                .unzip()
        });
        Ok((distance.into_pyarray(py), surface.into_pyarray(py)))
    }
}

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
    let (points, normals) = (self::points("points", &points)?, self::points("normals", &normals)?);
    let weights = weights.map(|w| w.as_array().to_vec());
    let settings =
        Settings { seed, rounds, nodes, window_samples, max_bounces, target_relative_error, max_rounds, weights };
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
    let (points, normals) = (self::points("points", &points)?, self::points("normals", &normals)?);
    let found = py.detach(|| room::centre_coefficients(&scene.0, &points, &normals, &basis.0)).map_err(errors::room)?;
    let result = PyDict::new(py);
    result.set_item("direct", table(py, found.direct, found.patches)?)?;
    result.set_item("redirected", table(py, found.redirected, found.patches)?)?;
    Ok(result)
}

/// Illuminance by each sun over the sun's normal illuminance, (sensor, sun); `sun_directions` point to the sun.
#[pyfunction]
#[pyo3(signature = (scene, points, normals, sun_directions, *, seed=0, rounds=8, nodes=1024, disc_samples=1, max_bounces=None,
    threads=None, progress=None))]
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
    threads: Option<usize>,
    progress: Option<Py<PyAny>>,
) -> PyResult<Bound<'py, PyDict>> {
    let (points, normals) = (self::points("points", &points)?, self::points("normals", &normals)?);
    let suns = self::points("sun_directions", &sun_directions)?;
    let settings = Settings { seed, rounds, nodes, max_bounces, ..Settings::default() };
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
    result.set_item("lost", found.lost.map(|lost| table(py, lost, found.suns)).transpose()?)?;
    result.set_item("rounds", found.rounds)?;
    result.set_item("interrupted", found.interrupted)?;
    result.set_item("seconds", found.seconds)?;
    Ok(result)
}

/// Adds all of this file to the module.
pub fn register(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_class::<PyMaterial>()?;
    module.add_class::<PySceneBuilder>()?;
    module.add_class::<PyScene>()?;
    module.add_function(wrap_pyfunction!(daylight_coefficients, module)?)?;
    module.add_function(wrap_pyfunction!(centre_coefficients, module)?)?;
    module.add_function(wrap_pyfunction!(sun_coefficients, module)?)
}
