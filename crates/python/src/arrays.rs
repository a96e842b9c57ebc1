//! Arrays across the border: shapes are checked here and nowhere else.

use crate::errors::mistake;
use hemisphere::{Direction, Vec3};
use numpy::{IntoPyArray, PyArray2, PyReadonlyArray2, ndarray::Array2, ndarray::ArrayView2};
use pyo3::{Bound, PyResult, Python};

/// Rows of three numbers as unit directions.
pub fn directions(name: &str, array: &PyReadonlyArray2<'_, f64>) -> PyResult<Vec<Direction>> {
    let rows = array.as_array();
    columns(name, &rows, 3)?;
    let direction = |row: numpy::ndarray::ArrayView1<'_, f64>| {
        Direction::of(Vec3::new(row[0], row[1], row[2]))
            .ok_or_else(|| mistake(format!("{name} must be vectors of finite length, got {row}")))
    };
    rows.outer_iter().map(direction).collect()
}

/// Refuses a table of another width.
pub fn columns(name: &str, array: &ArrayView2<'_, f64>, count: usize) -> PyResult<()> {
    if array.ncols() == count {
        Ok(())
    } else {
        Err(mistake(format!("{name} must have shape (any, {count}), got {:?}", array.shape())))
    }
}

/// Rows of three numbers as vectors of any length.
pub fn points(name: &str, array: &PyReadonlyArray2<'_, f64>) -> PyResult<Vec<Vec3>> {
    let rows = array.as_array();
    columns(name, &rows, 3)?;
    Ok(rows.outer_iter().map(|row| Vec3::new(row[0], row[1], row[2])).collect())
}

/// Vectors as rows of three numbers.
pub fn vectors<'py>(py: Python<'py>, rows: &[Vec3]) -> Bound<'py, PyArray2<f64>> {
    Array2::from_shape_fn((rows.len(), 3), |(i, k)| rows[i][k]).into_pyarray(py)
}
