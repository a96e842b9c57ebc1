//! Media and published formulas over arrays. Every array argument of one call has one dimension and one length.

use crate::errors;
use numpy::{IntoPyArray, PyArray1, PyReadonlyArray1};
use optics::formulas::{self, Polarisation};
use optics::{Absorption, Dispersion};
use pyo3::prelude::*;

type Input<'py> = PyReadonlyArray1<'py, f64>;
type Output<'py> = Bound<'py, PyArray1<f64>>;

/// A refractive index and an absorption, at one wavelength or over a spectrum.
#[pyclass(frozen, module = "clerestory._native")]
struct Medium(optics::Medium);

#[pymethods]
impl Medium {
    #[new]
    fn new(
        law: &str,
        coefficients: Vec<f64>,
        wavelength_range_nm: Option<(f64, f64)>,
        quantity: &str,
        values: Vec<f64>,
    ) -> PyResult<Self> {
        let dispersion =
            Dispersion::from_coefficients(law, &coefficients, wavelength_range_nm).map_err(errors::optics)?;
        let absorption = Absorption::from_values(quantity, &values).map_err(errors::optics)?;
        optics::Medium::new(dispersion, absorption).map(Self).map_err(errors::optics)
    }

    #[staticmethod]
    fn named(name: &str) -> PyResult<Self> {
        optics::Medium::named(name).map(Self).map_err(errors::optics)
    }

    #[getter]
    fn dispersion(&self) -> (&'static str, Vec<f64>, Option<(f64, f64)>) {
        let (law, coefficients) = self.0.dispersion().to_coefficients();
        (law, coefficients, self.0.dispersion().range_nm())
    }

    #[getter]
    fn absorption(&self) -> (&'static str, Vec<f64>) {
        self.0.absorption().to_values()
    }

    #[getter]
    fn wavelength_range_nm(&self) -> Option<(f64, f64)> {
        self.0.wavelength_range_nm()
    }

    #[getter]
    fn is_spectral(&self) -> bool {
        self.0.is_spectral()
    }

    fn index<'py>(&self, py: Python<'py>, wavelength_nm: Input<'py>) -> PyResult<Output<'py>> {
        self.each(py, wavelength_nm, optics::Medium::index)
    }

    fn absorption_per_mm<'py>(&self, py: Python<'py>, wavelength_nm: Input<'py>) -> PyResult<Output<'py>> {
        self.each(py, wavelength_nm, optics::Medium::absorption_per_mm)
    }
}

impl Medium {
    fn each<'py>(
        &self,
        py: Python<'py>,
        wavelength_nm: Input<'py>,
        quantity: fn(&optics::Medium, f64) -> Result<f64, optics::OpticsError>,
    ) -> PyResult<Output<'py>> {
        let wavelength_nm = wavelength_nm.as_array().to_vec();
        let values = py
            .detach(|| wavelength_nm.into_iter().map(|w| quantity(&self.0, w)).collect::<Result<Vec<_>, _>>())
            .map_err(errors::optics)?;
        Ok(values.into_pyarray(py))
    }
}

/// The names of the media that have one.
#[pyfunction]
fn medium_names() -> Vec<&'static str> {
    optics::medium_names().collect()
}

/// Who measured a named medium.
#[pyfunction]
fn medium_source(name: &str) -> PyResult<&'static str> {
    optics::Medium::source_of(name).map_err(errors::optics)
}

/// `f` of each row of as many columns as there are arrays, without the interpreter's lock.
fn map<'py, const N: usize, const M: usize>(
    py: Python<'py>,
    columns: [Input<'py>; N],
    f: impl Fn([f64; N]) -> Result<[f64; M], optics::OpticsError> + Send + Sync,
) -> PyResult<[Output<'py>; M]> {
    let columns = columns.map(|column| column.as_array().to_vec());
    let length = columns[0].len();
    if columns.iter().any(|column| column.len() != length) {
        let lengths: Vec<_> = columns.iter().map(Vec::len).collect();
        return Err(errors::mistake(format!("the arrays must have one length, got {lengths:?}; broadcast them first")));
    }
    let results = py.detach(|| {
        let mut results: [Vec<f64>; M] = std::array::from_fn(|_| Vec::with_capacity(length));
        (0..length).try_for_each(|row| {
            let values = f(std::array::from_fn(|column| columns[column][row]))?;
            results.iter_mut().zip(values).for_each(|(result, value)| result.push(value));
            Ok(())
        })?;
        Ok(results)
    });
    Ok(results.map_err(errors::optics)?.map(|result| result.into_pyarray(py)))
}

#[pyfunction]
fn tregenza_sharples<'py>(py: Python<'py>, cos_i: Input<'py>) -> PyResult<Output<'py>> {
    map(py, [cos_i], |[c]| Ok([formulas::tregenza_sharples(c)])).map(|[result]| result)
}

#[pyfunction]
fn edmonds_greenup_compagnon<'py>(py: Python<'py>, cos_i: Input<'py>, n: Input<'py>) -> PyResult<Output<'py>> {
    map(py, [cos_i, n], |[c, n]| Ok([formulas::edmonds_greenup_compagnon(c, n)])).map(|[result]| result)
}

/// Transmittance, reflectance and absorptance of a pane in air.
#[pyfunction]
fn slab<'py>(
    py: Python<'py>,
    cos_i: Input<'py>,
    n: Input<'py>,
    optical_depth: Input<'py>,
    polarisation: &str,
) -> PyResult<[Output<'py>; 3]> {
    let polarisation = match polarisation {
        "resolved" => Polarisation::Resolved,
        "averaged" => Polarisation::Averaged,
        "s" => Polarisation::S,
        "p" => Polarisation::P,
        other => {
            return Err(errors::mistake(format!(
                "polarisation must be \"resolved\", \"averaged\", \"s\" or \"p\", got {other:?}; \
                 \"resolved\" is exact"
            )));
        }
    };
    map(py, [cos_i, n, optical_depth], |[c, n, depth]| {
        let shares = formulas::slab(c, n, depth, polarisation);
        Ok([shares.transmittance, shares.reflectance, shares.absorptance])
    })
}

#[pyfunction]
fn slab_single_pass<'py>(
    py: Python<'py>,
    cos_i: Input<'py>,
    n: Input<'py>,
    optical_depth: Input<'py>,
) -> PyResult<Output<'py>> {
    map(py, [cos_i, n, optical_depth], |[c, n, depth]| Ok([formulas::slab_single_pass(c, n, depth)]))
        .map(|[result]| result)
}

#[pyfunction]
fn edmonds_deflected_fraction<'py>(
    py: Python<'py>,
    cos_i: Input<'py>,
    n: Input<'py>,
    width_over_spacing: Input<'py>,
) -> PyResult<Output<'py>> {
    map(py, [cos_i, n, width_over_spacing], |[c, n, ratio]| Ok([formulas::edmonds_deflected_fraction(c, n, ratio)]))
        .map(|[result]| result)
}

#[pyfunction]
fn edmonds_panel_tilt<'py>(py: Python<'py>, altitude: Input<'py>) -> PyResult<Output<'py>> {
    map(py, [altitude], |[altitude]| Ok([formulas::edmonds_panel_tilt(altitude)])).map(|[result]| result)
}

/// Index and optical depth of an uncoated pane from its normal transmittance and reflectance.
#[pyfunction]
fn uncoated_glass<'py>(
    py: Python<'py>,
    transmittance: Input<'py>,
    reflectance: Input<'py>,
) -> PyResult<[Output<'py>; 2]> {
    map(py, [transmittance, reflectance], |[t, r]| {
        formulas::uncoated_glass(t, r).map(|glass| [glass.n, glass.optical_depth])
    })
}

/// Adds all of this file to the module.
pub fn register(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_class::<Medium>()?;
    module.add_function(wrap_pyfunction!(medium_names, module)?)?;
    module.add_function(wrap_pyfunction!(medium_source, module)?)?;
    module.add_function(wrap_pyfunction!(tregenza_sharples, module)?)?;
    module.add_function(wrap_pyfunction!(edmonds_greenup_compagnon, module)?)?;
    module.add_function(wrap_pyfunction!(slab, module)?)?;
    module.add_function(wrap_pyfunction!(slab_single_pass, module)?)?;
    module.add_function(wrap_pyfunction!(edmonds_deflected_fraction, module)?)?;
    module.add_function(wrap_pyfunction!(edmonds_panel_tilt, module)?)?;
    module.add_function(wrap_pyfunction!(uncoated_glass, module)?)?;
    Ok(())
}
