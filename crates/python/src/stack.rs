//! Layers one behind the other, for Python.

use crate::arrays::directions;
use crate::errors::{self, mistake};
use crate::glazing::PyGlazing;
use numpy::{IntoPyArray, PyArray1, PyArray2, PyReadonlyArray2, ndarray::Array2};
use optics::Stack;
use pyo3::prelude::*;
use rayon::prelude::*;
use std::sync::Arc;

/// Layers with air between, the outermost first, at one or several wavelengths.
#[pyclass(name = "Stack", module = "clerestory._native", frozen)]
pub struct PyStack(Arc<Stack>);

/// The columns of every table of shares before those of the layers, in their order.
const SHARES: [&str; 4] = ["transmittance", "reflectance", "transmittance_deflected", "residual"];

#[pymethods]
impl PyStack {
    /// `spectrum` has the layers at each wavelength; `weights` sum to 1.
    #[new]
    #[pyo3(signature = (spectrum, *, weights, is_resolved))]
    fn new(spectrum: Vec<Vec<PyRef<'_, PyGlazing>>>, weights: Vec<f64>, is_resolved: bool) -> PyResult<Self> {
        if spectrum.len() != weights.len() {
            return Err(mistake("spectrum and weights must have one entry for each wavelength"));
        }
        let layers = |at: &Vec<PyRef<'_, PyGlazing>>| at.iter().map(|layer| layer.0.clone()).collect();
        let spectrum = spectrum.iter().map(layers).zip(weights).collect();
        Stack::spectral(spectrum, is_resolved).map(|stack| Self(Arc::new(stack))).map_err(errors::optics)
    }

    /// Where the light of one plane wave goes: directions (lobe, 3), Stokes vectors (lobe, 4), least total reflections (lobe,),
    /// absorptance (layer,), then residual, walked and the walk's standard error at most.
    #[allow(clippy::type_complexity)]
    fn lobes<'py>(
        &self,
        py: Python<'py>,
        incident: PyReadonlyArray2<'_, f64>,
    ) -> PyResult<(
        Bound<'py, PyArray2<f64>>,
        Bound<'py, PyArray2<f64>>,
        Bound<'py, PyArray1<u16>>,
        Bound<'py, PyArray1<f64>>,
        [f64; 3],
    )> {
        let incident = directions("incident", &incident)?;
        let [incident] = incident[..] else { return Err(mistake("incident must be one direction")) };
        let found = py.detach(|| self.0.outcome(incident));
        let beams = &found.beams;
        let directions = Array2::from_shape_fn((beams.len(), 3), |(i, j)| beams[i].direction.to_array()[j]);
        let stokes = Array2::from_shape_fn((beams.len(), 4), |(i, j)| beams[i].stokes[j]);
        let reflections: Vec<u16> = beams.iter().map(|b| b.total_reflections).collect();
        Ok((
            directions.into_pyarray(py),
            stokes.into_pyarray(py),
            reflections.into_pyarray(py),
            found.absorptance.into_pyarray(py),
            [found.residual, found.walked, found.walked_variance.sqrt()],
        ))
    }

    /// How the light of each plane wave divides: (incident, share), `SHARES` first, then the absorptance of each layer.
    fn shares<'py>(&self, py: Python<'py>, incident: PyReadonlyArray2<'_, f64>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let incident = directions("incident", &incident)?;
        let rows: Vec<_> = py.detach(|| incident.par_iter().map(|&d| self.0.shares(d)).collect());
        let width = SHARES.len() + self.0.layers();
        let table = Array2::from_shape_fn((rows.len(), width), |(i, j)| {
            let r = &rows[i];
            let shares = [r.transmittance, r.reflectance, r.transmittance_deflected, r.residual];
            shares.get(j).copied().unwrap_or_else(|| r.absorptance[j - SHARES.len()])
        });
        Ok(table.into_pyarray(py))
    }

    /// The stack as what fills a window.
    fn glazing(&self) -> PyGlazing {
        PyGlazing(self.0.clone())
    }

    /// Names of the first columns of every table of shares.
    #[classattr]
    #[pyo3(name = "SHARES")]
    fn share_names() -> [&'static str; 4] {
        SHARES
    }
}

/// Adds the class to the module.
pub fn register(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_class::<PyStack>()
}
