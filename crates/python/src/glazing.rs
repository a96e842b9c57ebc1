//! What fills a window, for Python: plain glazing by formula, and whatever else walks through the one door.

use crate::arrays::directions;
use crate::errors::{self, mistake};
use numpy::{IntoPyArray, PyArray1, PyArray2, PyReadonlyArray2, ndarray::Array2};
use optics::{ClearGlazing, Glazing, Lobes, Stack};
use pyo3::prelude::*;
use std::sync::Arc;

/// What fills a window. Panels make one of themselves by their method `glazing`.
#[pyclass(name = "Glazing", module = "clerestory._native", frozen)]
pub struct PyGlazing(pub Arc<dyn Glazing>);

fn clear(glazing: Result<ClearGlazing, optics::OpticsError>) -> PyResult<PyGlazing> {
    glazing.map(|glazing| PyGlazing(Arc::new(glazing))).map_err(errors::optics)
}

#[pymethods]
impl PyGlazing {
    /// Nothing in the opening.
    #[staticmethod]
    fn open() -> Self {
        Self(Arc::new(ClearGlazing::open()))
    }

    /// One transmittance for every angle; the rest is absorbed.
    #[staticmethod]
    fn constant(transmittance: f64) -> PyResult<Self> {
        clear(ClearGlazing::constant(transmittance))
    }

    /// A pane of n = 1.52 that transmits this share at normal incidence.
    #[staticmethod]
    fn glass(transmittance: f64) -> PyResult<Self> {
        clear(ClearGlazing::glass(transmittance))
    }

    /// 6 mm clear float glass by the polynomial of Tregenza and Sharples.
    #[staticmethod]
    fn tregenza_sharples() -> Self {
        Self(Arc::new(ClearGlazing::tregenza_sharples()))
    }

    /// A plane-parallel pane with all its inner reflections.
    #[staticmethod]
    fn slab(n: f64, thickness_mm: f64, absorption_per_mm: f64) -> PyResult<Self> {
        clear(ClearGlazing::slab(n, thickness_mm, absorption_per_mm))
    }

    /// Layers with air between, the outermost first.
    #[staticmethod]
    fn stack(layers: Vec<PyRef<'_, PyGlazing>>) -> PyResult<Self> {
        let layers = layers.iter().map(|layer| layer.0.clone()).collect();
        Stack::new(layers).map(|stack| Self(Arc::new(stack))).map_err(errors::optics)
    }

    /// Directions (lobe, 3), powers and total reflections (lobe,), absorbed and residual, of light from one direction in the
    /// element's axes.
    #[allow(clippy::type_complexity)]
    fn lobes<'py>(
        &self,
        py: Python<'py>,
        incident: PyReadonlyArray2<'_, f64>,
    ) -> PyResult<(Bound<'py, PyArray2<f64>>, Bound<'py, PyArray1<f64>>, Bound<'py, PyArray1<u16>>, f64, f64)> {
        let incident = directions("incident", &incident)?;
        let [incident] = incident[..] else { return Err(mistake("incident must be one direction")) };
        let mut lobes = Lobes::default();
        py.detach(|| self.0.lobes(incident, &mut lobes));
        let beams = &lobes.beams;
        let directions = Array2::from_shape_fn((beams.len(), 3), |(i, j)| beams[i].direction.to_array()[j]);
        let powers: Vec<f64> = beams.iter().map(|b| b.power).collect();
        let reflections: Vec<u16> = beams.iter().map(|b| b.total_reflections).collect();
        let (powers, reflections) = (powers.into_pyarray(py), reflections.into_pyarray(py));
        Ok((directions.into_pyarray(py), powers, reflections, lobes.absorbed, lobes.residual))
    }
}

/// Adds the class to the module.
pub fn register(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_class::<PyGlazing>()
}
