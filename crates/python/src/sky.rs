//! Bases of the sky for Python.

use crate::arrays::vectors;
use crate::errors::mistake;
use hemisphere::{AllWeather, Order, SkyBasis, SkyNodes, Vec3};
use numpy::{IntoPyArray, PyArray1, PyArray2, PyReadonlyArray1, PyReadonlyArray2, ndarray::Array2};
use pyo3::prelude::*;

/// A sky cut into patches, and the ground as the last.
#[pyclass(name = "SkyBasis", module = "clerestory._native", frozen)]
pub struct PySkyBasis(pub SkyBasis);

#[pymethods]
impl PySkyBasis {
    #[new]
    fn new(name: &str) -> PyResult<Self> {
        SkyBasis::named(name).map(Self).ok_or_else(|| {
            mistake(format!(
                "basis must be tregenza145, troplux5221 or reinhart577, reinhart2305, … (reinhart and 144 MF² + 1), got {name:?}; \
                 choose one of these"
            ))
        })
    }

    #[getter]
    fn name(&self) -> &str {
        self.0.name()
    }

    fn __len__(&self) -> usize {
        self.0.patches()
    }

    /// Middle of each patch, (patch, 3).
    #[getter]
    fn centres<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray2<f64>> {
        Array2::from_shape_fn((self.0.patches(), 3), |(p, k)| self.0.centre(p)[k]).into_pyarray(py)
    }

    /// Solid angle of each patch [sr].
    #[getter]
    fn solid_angles<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        (0..self.0.patches()).map(|p| self.0.solid_angle(p)).collect::<Vec<_>>().into_pyarray(py)
    }

    /// Lower and upper altitude, first and last azimuth clockwise from north [rad], (patch, 4).
    #[getter]
    fn bounds<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray2<f64>> {
        Array2::from_shape_fn((self.0.patches(), 4), |(p, k)| {
            let b = self.0.bounds(p);
            [b.altitude_low, b.altitude_high, b.azimuth_low, b.azimuth_high][k]
        })
        .into_pyarray(py)
    }

    /// Our index of each patch in the order of a table.
    fn order<'py>(&self, py: Python<'py>, order: &str) -> PyResult<Bound<'py, PyArray1<i64>>> {
        let order = match order {
            "cie" => Order::Cie,
            "radiance" => Order::Radiance,
            other => {
                return Err(mistake(format!("order must be 'cie' or 'radiance', got {other:?}; choose one of these")));
            }
        };
        Ok(self.0.order(order).into_iter().map(|p| p as i64).collect::<Vec<_>>().into_pyarray(py))
    }

    /// The patch that each direction looks to, (n,).
    fn find<'py>(&self, py: Python<'py>, directions: PyReadonlyArray2<'_, f64>) -> PyResult<Bound<'py, PyArray1<i64>>> {
        let directions = crate::arrays::directions("directions", &directions)?;
        Ok(directions.into_iter().map(|d| self.0.find(*d) as i64).collect::<Vec<_>>().into_pyarray(py))
    }

    /// A direction in each patch, uniform over it for `u` uniform in the unit square, (n, 3).
    fn sample<'py>(
        &self,
        py: Python<'py>,
        patch: PyReadonlyArray1<'_, i64>,
        u: PyReadonlyArray2<'_, f64>,
    ) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let (patch, u) = (patch.as_array(), u.as_array());
        crate::arrays::columns("u", &u, 2)?;
        if patch.len() != u.nrows() {
            return Err(mistake(format!("u must have one row for each patch, got {} for {}", u.nrows(), patch.len())));
        }
        if let Some(wrong) = patch.iter().find(|p| usize::try_from(**p).map_or(true, |p| p >= self.0.patches())) {
            return Err(mistake(format!("patch must lie in 0..{}, got {wrong}", self.0.patches())));
        }
        let drawn: Vec<_> =
            (0..patch.len()).map(|i| self.0.sample(patch[i] as usize, [u[[i, 0]], u[[i, 1]]])).collect();
        Ok(vectors(py, &drawn))
    }

    /// Mean luminance of each patch under skies of parameters a to e (n, 5) with suns (n, 3) that light a horizontal plane with so
    /// much (n,), (n, patch). Rows without light are 0, and so is the ground. `order` 0 takes the luminance of the patches' centres.
    fn all_weather<'py>(
        &self,
        py: Python<'py>,
        parameters: PyReadonlyArray2<'_, f64>,
        suns: PyReadonlyArray2<'_, f64>,
        horizontal: PyReadonlyArray1<'_, f64>,
        order: usize,
    ) -> PyResult<Bound<'py, PyArray2<f32>>> {
        let (parameters, suns, horizontal) = (parameters.as_array(), suns.as_array(), horizontal.as_array());
        crate::arrays::columns("parameters", &parameters, 5)?;
        crate::arrays::columns("suns", &suns, 3)?;
        let times = horizontal.len();
        if parameters.nrows() != times || suns.nrows() != times {
            return Err(mistake(format!(
                "parameters and suns must have a row for each of {times} times, got {} and {}",
                parameters.nrows(),
                suns.nrows()
            )));
        }
        let found = py.detach(|| {
            let nodes = SkyNodes::new(&self.0, order);
            let mut found = Array2::zeros((times, self.0.patches()));
            for (time, mut row) in found.outer_iter_mut().enumerate().filter(|(time, _)| horizontal[*time] > 0.0) {
                let p = parameters.row(time);
                let sky = AllWeather { a: p[0], b: p[1], c: p[2], d: p[3], e: p[4] };
                let sun = Vec3::new(suns[[time, 0]], suns[[time, 1]], suns[[time, 2]]);
                if let Some(means) = row.as_slice_mut() {
                    nodes.patch_means(&sky, sun, horizontal[time], means);
                }
            }
            found
        });
        Ok(found.into_pyarray(py))
    }

    /// Luminances of the overcast sky over its zenith's, and of ground of this reflectance under it, (patch,).
    fn overcast<'py>(&self, py: Python<'py>, ground_reflectance: f64) -> PyResult<Bound<'py, PyArray1<f64>>> {
        if !(0.0..=1.0).contains(&ground_reflectance) {
            return Err(mistake(format!("ground_reflectance must lie in 0..1, got {ground_reflectance}")));
        }
        Ok(self.0.overcast(ground_reflectance).into_pyarray(py))
    }
}

/// Adds the class to the module.
pub fn register(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_class::<PySkyBasis>()
}
