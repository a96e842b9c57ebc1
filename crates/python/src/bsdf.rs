//! BSDFs for Python: Klems bases, and blocks that become a glazing.

use crate::{
    errors::{self, mistake},
    glazing::PyGlazing,
};
use hemisphere::KlemsBasis;
use numpy::{
    IntoPyArray, PyArray1, PyArray2, PyReadonlyArray1, PyReadonlyArray2,
    ndarray::{Array2, ArrayView2},
};
use optics::{
    Averaging, Block, Blocks, Bsdf, Cells, Exchange, Glazing, Matrix, OpticsError, Side, Tree, Way, isotropic_trees,
};
use pyo3::prelude::*;
use std::sync::Arc;

/// The directions of one side in rings of patches about the normal.
#[pyclass(name = "KlemsBasis", module = "clerestory._native", frozen)]
pub struct PyKlemsBasis(pub KlemsBasis);

#[pymethods]
impl PyKlemsBasis {
    #[new]
    fn new(name: &str) -> PyResult<Self> {
        named(name).map(Self)
    }

    /// Rings of another's making: the least angle of each from the normal [degrees] and its patches.
    #[staticmethod]
    fn of_rings(name: &str, theta_low_deg: Vec<f64>, counts: Vec<usize>) -> PyResult<Self> {
        KlemsBasis::of_rings(name, &theta_low_deg, &counts).map(Self).ok_or_else(|| {
            mistake("theta_low_deg must rise from 0 and end below 90, with a count of at least 1 for each ring")
        })
    }

    #[getter]
    fn name(&self) -> &str {
        self.0.name()
    }

    fn __len__(&self) -> usize {
        self.0.patches()
    }

    /// Angles from the normal between which each ring lies [degrees], (ring, 2).
    #[getter]
    fn theta_bounds_deg<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray2<f64>> {
        let rings = self.0.rings();
        Array2::from_shape_fn((rings.len(), 2), |(i, k)| [rings[i].theta_low, rings[i].theta_high][k].to_degrees())
            .into_pyarray(py)
    }

    /// Patches of each ring.
    #[getter]
    fn counts(&self) -> Vec<usize> {
        self.0.rings().iter().map(|ring| ring.count).collect()
    }

    /// Solid angle of each patch [sr].
    #[getter]
    fn solid_angle<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        (0..self.0.patches()).map(|p| self.0.solid_angle(p)).collect::<Vec<_>>().into_pyarray(py)
    }

    /// Solid angle of each patch weighted by the cosine from the normal [sr].
    #[getter]
    fn projected_solid_angle<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        (0..self.0.patches()).map(|p| self.0.projected_solid_angle(p)).collect::<Vec<_>>().into_pyarray(py)
    }

    /// Middle of each patch on the side z > 0, (patch, 3).
    #[getter]
    fn centres<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray2<f64>> {
        Array2::from_shape_fn((self.0.patches(), 3), |(p, k)| self.0.centre(p)[k]).into_pyarray(py)
    }

    /// The patch that (x, y) of each direction lies in, (n,).
    fn find<'py>(&self, py: Python<'py>, xy: PyReadonlyArray2<'_, f64>) -> PyResult<Bound<'py, PyArray1<i64>>> {
        let xy = xy.as_array();
        crate::arrays::columns("xy", &xy, 2)?;
        Ok(xy.outer_iter().map(|row| self.0.find(row[0], row[1]) as i64).collect::<Vec<_>>().into_pyarray(py))
    }
}

/// A known Klems basis.
pub fn named(name: &str) -> PyResult<KlemsBasis> {
    KlemsBasis::named(name)
        .ok_or_else(|| mistake(format!("basis must be one of {}, got {name:?}", KlemsBasis::NAMES.join(", "))))
}

/// A basis by name, or made before.
#[derive(FromPyObject)]
pub enum BasisOrName<'py> {
    /// One of the known names.
    Name(String),
    /// Any basis.
    Basis(PyRef<'py, PyKlemsBasis>),
}

impl BasisOrName<'_> {
    fn basis(&self) -> PyResult<KlemsBasis> {
        match self {
            Self::Name(name) => named(name),
            Self::Basis(basis) => Ok(basis.0.clone()),
        }
    }
}

/// The glazing of four blocks, transmission front and back, then reflection front and back; a missing one sends out nothing.
fn glazing(blocks: [Option<Result<Block, OpticsError>>; 4]) -> Result<PyGlazing, OpticsError> {
    let [tf, tb, rf, rb] = blocks.map(Option::transpose);
    let front = Blocks { transmission: tf?, reflection: rf? };
    let back = Blocks { transmission: tb?, reflection: rb? };
    Ok(PyGlazing(Arc::new(Bsdf::new(front, back)?)))
}

/// A glazing of Klems matrices [1/sr], each (outgoing, incident).
pub fn of_matrices(
    py: Python<'_>,
    incident: &BasisOrName<'_>,
    outgoing: &BasisOrName<'_>,
    blocks: [Option<PyReadonlyArray2<'_, f64>>; 4],
) -> PyResult<PyGlazing> {
    let (incident, outgoing) = (incident.basis()?, outgoing.basis()?);
    let matrix = |values: ArrayView2<'_, f64>| {
        let (rows, columns) = (outgoing.patches(), incident.patches());
        if values.dim() != (rows, columns) {
            return Err(OpticsError::BsdfShape { rows, columns, got: values.len() });
        }
        let values: Vec<f64> = values.iter().copied().collect();
        Matrix::new(incident.clone(), outgoing.clone(), &values).map(Block::Matrix)
    };
    let views = [0, 1, 2, 3].map(|k: usize| blocks[k].as_ref().map(|b| b.as_array()));
    py.detach(|| glazing(views.map(|view| view.map(matrix)))).map_err(errors::optics)
}

/// A glazing of tensor trees, each by its preorder walk.
pub fn of_trees(py: Python<'_>, rank: usize, blocks: [Option<PyReadonlyArray1<'_, f64>>; 4]) -> PyResult<PyGlazing> {
    let walks = blocks.map(|block| block.map(|walk| walk.as_array().to_vec()));
    let tree = |walk: Vec<f64>| Tree::from_preorder(rank, &walk).map(Block::Tree);
    py.detach(|| glazing(walks.map(|walk| walk.map(tree)))).map_err(errors::optics)
}

/// How closely to average, from Python's words.
pub fn averaging(tolerance: f64, levels: u32, draws: u32, seed: u64) -> Averaging {
    Averaging { tolerance, levels, draws, seed }
}

/// The blocks in the order of every list of them: transmission front and back, reflection front and back.
const BLOCKS: [(Side, Way); 4] = [
    (Side::Front, Way::Transmission),
    (Side::Back, Way::Transmission),
    (Side::Front, Way::Reflection),
    (Side::Back, Way::Reflection),
];

/// Shares absorbed, (side, cell), and the accounts by name.
pub type Accounts<'py> = (Bound<'py, PyArray2<f64>>, Vec<(&'static str, f64)>);

fn accounts<'py>(py: Python<'py>, exchange: &Exchange) -> Accounts<'py> {
    let count = exchange.cells().count();
    let absorbed = Array2::from_shape_fn((2, count), |(side, cell)| exchange.absorbed[side * count + cell]);
    let by_name = vec![
        ("residual", exchange.residual),
        ("change", exchange.change),
        ("asymmetry", exchange.asymmetry),
        ("correction", exchange.correction),
        ("misfit", exchange.misfit),
        ("draws", f64::from(exchange.draws.unwrap_or(0))),
    ];
    (absorbed.into_pyarray(py), by_name)
}

/// Four tables (outgoing, incident).
pub type Tables<'py> = Vec<Bound<'py, PyArray2<f64>>>;

/// Averages over Klems patches: tables [1/sr], their standard errors if drawn, and the accounts.
pub fn klems<'py>(
    py: Python<'py>,
    glazing: &dyn Glazing,
    basis: &BasisOrName<'_>,
    how: &Averaging,
) -> PyResult<(Tables<'py>, Option<Tables<'py>>, Accounts<'py>)> {
    let basis = basis.basis()?;
    if basis.rings().iter().any(|ring| ring.count > 1 && ring.count % 2 == 1) {
        return Err(mistake(
            "basis must have rings of an even number of patches, so that light can turn back; use klems_full",
        ));
    }
    let (exchange, tables, errors) = py.detach(|| {
        let exchange = Exchange::of(glazing, Cells::Klems(basis), how);
        let tables = BLOCKS.map(|(side, way)| exchange.table(side, way));
        let errors = BLOCKS.map(|(side, way)| exchange.standard_error(side, way));
        (exchange, tables, errors)
    });
    let count = exchange.cells().count();
    let array = |table: Vec<f64>| Array2::from_shape_fn((count, count), |(o, i)| table[o * count + i]).into_pyarray(py);
    let errors: Option<Vec<_>> = errors.into_iter().collect();
    let errors = errors.map(|errors| errors.into_iter().map(array).collect());
    Ok((tables.into_iter().map(array).collect(), errors, accounts(py, &exchange)))
}

/// Four preorder walks, and the accounts if there are any.
pub type Trees<'py> = (Vec<Bound<'py, PyArray1<f64>>>, Option<Accounts<'py>>);

/// Averages over the squares of a tensor tree: four preorder walks, and the accounts of a tree of rank 4.
pub fn tree<'py>(
    py: Python<'py>,
    glazing: &dyn Glazing,
    (rank, log2_resolution): (usize, u32),
    merged: f64,
    how: &Averaging,
) -> PyResult<Trees<'py>> {
    let arrays = |walks: [Vec<f64>; 4]| walks.into_iter().map(|walk| walk.into_pyarray(py)).collect();
    match rank {
        3 => {
            let walks = py.detach(|| isotropic_trees(glazing, log2_resolution, how, merged));
            Ok((arrays(walks.map_err(errors::optics)?), None))
        }
        4 => {
            let (exchange, walks) = py.detach(|| {
                let exchange = Exchange::of(glazing, Cells::Grid(log2_resolution), how);
                let walks = BLOCKS.map(|(side, way)| exchange.tree(side, way, merged).unwrap_or_default());
                (exchange, walks)
            });
            Ok((arrays(walks), Some(accounts(py, &exchange))))
        }
        _ => Err(errors::optics(OpticsError::TreeRank { rank })),
    }
}

/// Adds the class to the module.
pub fn register(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_class::<PyKlemsBasis>()
}
