//! What fills a window, for Python: plain glazing by formula, and whatever else walks through the one door.

use crate::arrays::directions;
use crate::bsdf::{self, BasisOrName};
use crate::errors::{self, mistake};
use hemisphere::Rng;
use numpy::{IntoPyArray, PyArray1, PyArray2, PyReadonlyArray1, PyReadonlyArray2, ndarray::Array2};
use optics::{ClearGlazing, Glazing, Lobes, Scattered};
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

    /// A BSDF of Klems matrices [1/sr], each (outgoing, incident); a missing one sends out nothing.
    #[staticmethod]
    #[pyo3(signature = (incident_basis, outgoing_basis, transmission_front, transmission_back, reflection_front, reflection_back))]
    fn bsdf_matrix(
        py: Python<'_>,
        incident_basis: BasisOrName<'_>,
        outgoing_basis: BasisOrName<'_>,
        transmission_front: Option<PyReadonlyArray2<'_, f64>>,
        transmission_back: Option<PyReadonlyArray2<'_, f64>>,
        reflection_front: Option<PyReadonlyArray2<'_, f64>>,
        reflection_back: Option<PyReadonlyArray2<'_, f64>>,
    ) -> PyResult<Self> {
        let blocks = [transmission_front, transmission_back, reflection_front, reflection_back];
        bsdf::of_matrices(py, &incident_basis, &outgoing_basis, blocks)
    }

    /// A BSDF of tensor trees of this rank, each by its preorder walk; a missing one sends out nothing.
    #[staticmethod]
    #[pyo3(signature = (rank, transmission_front, transmission_back, reflection_front, reflection_back))]
    fn bsdf_tree(
        py: Python<'_>,
        rank: usize,
        transmission_front: Option<PyReadonlyArray1<'_, f64>>,
        transmission_back: Option<PyReadonlyArray1<'_, f64>>,
        reflection_front: Option<PyReadonlyArray1<'_, f64>>,
        reflection_back: Option<PyReadonlyArray1<'_, f64>>,
    ) -> PyResult<Self> {
        let blocks = [transmission_front, transmission_back, reflection_front, reflection_back];
        bsdf::of_trees(py, rank, blocks)
    }

    /// Averages over the patches of a Klems basis: four tables [1/sr] (outgoing, incident), standard errors of each if the
    /// element was followed by random draws, shares absorbed (side, patch), and accounts by name.
    #[pyo3(signature = (basis, *, tolerance, levels, draws, seed))]
    #[allow(clippy::type_complexity)]
    fn klems<'py>(
        &self,
        py: Python<'py>,
        basis: BasisOrName<'_>,
        tolerance: f64,
        levels: u32,
        draws: u32,
        seed: u64,
    ) -> PyResult<(bsdf::Tables<'py>, Option<bsdf::Tables<'py>>, bsdf::Accounts<'py>)> {
        bsdf::klems(py, &*self.0, &basis, &bsdf::averaging(tolerance, levels, draws, seed))
    }

    /// Averages over the squares of a tensor tree: four preorder walks, and for rank 4 shares absorbed and accounts by name.
    #[pyo3(signature = (rank, log2_resolution, *, merged, tolerance, levels, draws, seed))]
    #[allow(clippy::too_many_arguments)]
    fn tree<'py>(
        &self,
        py: Python<'py>,
        rank: usize,
        log2_resolution: u32,
        merged: f64,
        tolerance: f64,
        levels: u32,
        draws: u32,
        seed: u64,
    ) -> PyResult<bsdf::Trees<'py>> {
        let how = bsdf::averaging(tolerance, levels, draws, seed);
        bsdf::tree(py, &*self.0, (rank, log2_resolution), merged, &how)
    }

    /// Whether all light leaves in beams that are known exactly.
    #[getter]
    fn has_lobes(&self) -> bool {
        optics::has_lobes(&*self.0)
    }

    /// Whether light leaves other than in beams.
    #[getter]
    fn spreads(&self) -> bool {
        self.0.spreads()
    }

    /// The part that is not specular [1/sr], for each pair of directions in which light arrives and leaves, (n,).
    fn bsdf<'py>(
        &self,
        py: Python<'py>,
        incident: PyReadonlyArray2<'_, f64>,
        outgoing: PyReadonlyArray2<'_, f64>,
    ) -> PyResult<Bound<'py, PyArray1<f64>>> {
        let (incident, outgoing) = (directions("incident", &incident)?, directions("outgoing", &outgoing)?);
        if incident.len() != outgoing.len() {
            let (incident, outgoing) = (incident.len(), outgoing.len());
            return Err(mistake(format!(
                "outgoing must be as many directions as incident, {incident}; got {outgoing}"
            )));
        }
        let values = py.detach(|| incident.iter().zip(outgoing).map(|(i, o)| self.0.bsdf(*i, o)).collect::<Vec<_>>());
        Ok(values.into_pyarray(py))
    }

    /// Share of the light from each direction that leaves spread, (n,).
    fn spread<'py>(&self, py: Python<'py>, incident: PyReadonlyArray2<'_, f64>) -> PyResult<Bound<'py, PyArray1<f64>>> {
        let incident = directions("incident", &incident)?;
        let mut lobes = Lobes::default();
        let share = |i: &_| {
            self.0.lobes(*i, &mut lobes);
            lobes.spread
        };
        Ok(py.detach(|| incident.iter().map(share).collect::<Vec<_>>()).into_pyarray(py))
    }

    /// One direction drawn for each incident one in proportion to power, (n, 3); rows of NaN where the light is absorbed.
    fn scatter<'py>(
        &self,
        py: Python<'py>,
        incident: PyReadonlyArray2<'_, f64>,
        seed: u64,
    ) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let incident = directions("incident", &incident)?;
        let draw = |(stream, &i): (usize, &_)| {
            let mut rng = Rng::new(seed, stream as u64);
            match self.0.scatter(i, std::array::from_fn(|_| rng.uniform())) {
                Scattered::Leaves { direction, .. } => direction.to_array(),
                Scattered::Absorbed => [f64::NAN; 3],
            }
        };
        let drawn: Vec<_> = py.detach(|| incident.iter().enumerate().map(draw).collect());
        Ok(Array2::from_shape_fn((drawn.len(), 3), |(i, k)| drawn[i][k]).into_pyarray(py))
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
