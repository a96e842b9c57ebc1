//! The crate `panel` for Python: profiles, and panels that say where light goes.

use crate::{
    arrays::{columns, directions},
    errors::{self, mistake},
    glazing::PyGlazing,
};
use numpy::{
    IntoPyArray, PyArray1, PyArray2, PyArray3, PyReadonlyArray1, PyReadonlyArray2,
    ndarray::{Array2, Array3},
};
use panel::{
    Facet, Finish, Media, Optical, Panel, Polarisation, Profile, Sample, Shares, Surface, Vec2, Workspace,
    flux::{Limits, strips},
    shape::{LaserCut, Prismatic, Ridges, pane},
    walk::estimate_shares,
};
use pyo3::prelude::*;
use rayon::prelude::*;
use std::sync::Arc;

/// The repeating cross-section of a panel, checked.
#[pyclass(name = "Profile", module = "clerestory._native", frozen)]
pub struct PyProfile(Arc<Profile>);

fn wrapped(profile: Result<Profile, panel::PanelError>) -> PyResult<PyProfile> {
    profile.map(|p| PyProfile(Arc::new(p))).map_err(errors::panel)
}

#[pymethods]
impl PyProfile {
    /// An acrylic sheet with cuts; sequences repeat.
    #[staticmethod]
    #[pyo3(signature = (*, spacing_mm, thickness_mm, cut_width_mm, cut_tilt_deg, cut_depth_mm, cut_radius_mm, cut_slope_deg, cut_diffuse))]
    #[allow(clippy::too_many_arguments)]
    fn laser_cut(
        spacing_mm: Vec<f64>,
        thickness_mm: f64,
        cut_width_mm: f64,
        cut_tilt_deg: Vec<f64>,
        cut_depth_mm: Option<Vec<f64>>,
        cut_radius_mm: Option<f64>,
        cut_slope_deg: f64,
        cut_diffuse: f64,
    ) -> PyResult<Self> {
        let cut = LaserCut {
            spacing: spacing_mm,
            thickness: thickness_mm,
            cut_width: cut_width_mm,
            cut_tilt_deg,
            cut_depth: cut_depth_mm,
            cut_radius: cut_radius_mm,
            finish: Finish { slope: cut_slope_deg.to_radians(), diffuse: cut_diffuse },
        };
        wrapped(cut.profile())
    }

    /// A sheet with ridges on one side.
    #[staticmethod]
    #[pyo3(signature = (*, pitch_mm, lower_deg, upper_deg, base_mm, ridges))]
    fn prismatic(pitch_mm: f64, lower_deg: f64, upper_deg: f64, base_mm: f64, ridges: &str) -> PyResult<Self> {
        let ridges = match ridges {
            "front" => Ridges::Front,
            "back" => Ridges::Back,
            other => return Err(mistake(format!("ridges must be 'front' or 'back', got {other:?}"))),
        };
        wrapped(Prismatic { pitch: pitch_mm, lower_deg, upper_deg, base: base_mm, ridges }.profile())
    }

    /// A plane-parallel sheet.
    #[staticmethod]
    #[pyo3(signature = (*, thickness_mm))]
    fn pane(thickness_mm: f64) -> PyResult<Self> {
        wrapped(pane(thickness_mm))
    }

    /// Any cross-section: ends (facet, [z0, y0, z1, y1]), bulge (0 straight), media to the left and right (0 air),
    /// the medium of the gap for films (-1 for interfaces).
    #[staticmethod]
    #[pyo3(signature = (*, ends_mm, bulge, left, right, film, pitch_mm))]
    fn drawn(
        ends_mm: PyReadonlyArray2<'_, f64>,
        bulge: Vec<f64>,
        left: Vec<u8>,
        right: Vec<u8>,
        film: Vec<i16>,
        pitch_mm: f64,
    ) -> PyResult<Self> {
        let ends = ends_mm.as_array();
        columns("ends_mm", &ends, 4)?;
        let count = ends.nrows();
        if [bulge.len(), left.len(), right.len(), film.len()] != [count; 4] {
            return Err(mistake(format!("bulge, left, right and film must have one value for each of {count} facets")));
        }
        let facets = (0..count).map(|i| Facet {
            start: Vec2::new(ends[[i, 0]], ends[[i, 1]]),
            end: Vec2::new(ends[[i, 2]], ends[[i, 3]]),
            bulge: bulge[i],
            left: left[i],
            right: right[i],
            surface: u8::try_from(film[i]).map_or(Surface::Interface, Surface::Film),
            finish: Finish::default(),
        });
        wrapped(Profile::new(facets.collect(), pitch_mm))
    }

    /// Height after which the profile repeats.
    #[getter]
    fn pitch_mm(&self) -> f64 {
        self.0.period()
    }

    /// Least and greatest extent across the sheet.
    #[getter]
    fn depth_range_mm(&self) -> (f64, f64) {
        self.0.z_range()
    }

    /// The highest number of a medium; 0 is the air outside.
    #[getter]
    fn highest_medium(&self) -> u8 {
        self.0.highest_medium()
    }

    /// Whether all surfaces are smooth and clear.
    #[getter]
    fn is_smooth(&self) -> bool {
        self.0.is_smooth()
    }

    /// Whether all facets are straight.
    #[getter]
    fn is_straight(&self) -> bool {
        self.0.is_straight()
    }

    /// The facets: ends (facet, [z0, y0, z1, y1]), bulge, medium to the left and right, medium of the gap or -1.
    #[allow(clippy::type_complexity)]
    fn facets<'py>(&self, py: Python<'py>) -> (Bound<'py, PyArray2<f64>>, Vec<f64>, Vec<u8>, Vec<u8>, Vec<i16>) {
        let facets = self.0.facets();
        let ends = Array2::from_shape_fn((facets.len(), 4), |(i, j)| {
            let f = &facets[i];
            [f.start.z, f.start.y, f.end.z, f.end.y][j]
        });
        let gap = |f: &Facet| if let Surface::Film(gap) = f.surface { i16::from(gap) } else { -1 };
        (
            ends.into_pyarray(py),
            facets.iter().map(|f| f.bulge).collect(),
            facets.iter().map(|f| f.left).collect(),
            facets.iter().map(|f| f.right).collect(),
            facets.iter().map(gap).collect(),
        )
    }

    /// The same with each arc drawn by so many straight facets.
    fn flattened(&self, chords: usize) -> PyResult<Self> {
        if chords < 2 {
            return Err(mistake(format!("arc_chords must be 2 or more, got {chords}")));
        }
        wrapped(self.0.flattened(chords))
    }
}

/// A panel at given wavelengths: a profile, its media, and how to follow light through it.
#[pyclass(name = "PanelOptics", module = "clerestory._native", frozen)]
pub struct PyPanel(Panel);

/// The columns of every table of shares, in their order.
const SHARES: [&str; 6] =
    ["transmittance", "reflectance", "absorptance", "transmittance_deflected", "transmittance_undeflected", "residual"];

fn row(s: &Shares) -> [f64; 6] {
    [s.transmittance, s.reflectance, s.absorptance, s.transmittance_deflected, s.transmittance_undeflected, s.residual]
}

fn table(rows: &[[f64; 6]]) -> Array2<f64> {
    Array2::from_shape_fn((rows.len(), 6), |(i, j)| rows[i][j])
}

#[pymethods]
impl PyPanel {
    /// `n` and `absorption_per_mm` have shape (wavelength, medium) without the air; `weights` sums to 1.
    #[new]
    #[pyo3(signature = (profile, *, n, absorption_per_mm, weights, polarisation, tolerance, most_pieces))]
    fn new(
        profile: &PyProfile,
        n: PyReadonlyArray2<'_, f64>,
        absorption_per_mm: PyReadonlyArray2<'_, f64>,
        weights: PyReadonlyArray1<'_, f64>,
        polarisation: &str,
        tolerance: f64,
        most_pieces: u64,
    ) -> PyResult<Self> {
        let (n, absorption, weights) = (n.as_array(), absorption_per_mm.as_array(), weights.as_array());
        if n.shape() != absorption.shape() || n.nrows() != weights.len() {
            return Err(mistake("n, absorption_per_mm and weights must have one row for each wavelength"));
        }
        let polarisation = match polarisation {
            "averaged" => Polarisation::Averaged,
            "resolved" => Polarisation::Resolved,
            other => return Err(mistake(format!("polarisation must be 'resolved' or 'averaged', got {other:?}"))),
        };
        let sample = |i: usize| {
            let media: Vec<_> =
                (0..n.ncols()).map(|j| Optical { n: n[[i, j]], absorption: absorption[[i, j]] }).collect();
            Ok(Sample { media: Media::in_air(&media)?, weight: weights[i] })
        };
        let spectrum: Result<Vec<_>, _> = (0..n.nrows()).map(sample).collect();
        spectrum
            .and_then(|s| Panel::new(profile.0.clone(), s, polarisation, Limits { tolerance, most_pieces }))
            .map(Self)
            .map_err(errors::panel)
    }

    /// Where the light of one plane wave goes: directions (lobe, 3), Stokes vectors (lobe, 4), least total reflections
    /// (lobe,), then absorbed, residual, displaced and walked, and pieces.
    #[allow(clippy::type_complexity)]
    fn lobes<'py>(
        &self,
        py: Python<'py>,
        incident: PyReadonlyArray2<'_, f64>,
    ) -> PyResult<(Bound<'py, PyArray2<f64>>, Bound<'py, PyArray2<f64>>, Bound<'py, PyArray1<u16>>, [f64; 4], u64)>
    {
        let incident = directions("incident", &incident)?;
        let [incident] = incident[..] else { return Err(mistake("incident must be one direction")) };
        let found = py.detach(|| self.0.outcome(incident, &mut Workspace::default())).map_err(errors::panel)?;
        let beams = &found.beams;
        let directions = Array2::from_shape_fn((beams.len(), 3), |(i, j)| beams[i].direction.to_array()[j]);
        let stokes = Array2::from_shape_fn((beams.len(), 4), |(i, j)| beams[i].stokes[j]);
        let reflections: Vec<u16> = beams.iter().map(|b| b.total_reflections).collect();
        let accounts = [found.absorbed, found.residual, found.displaced, found.walked];
        Ok((directions.into_pyarray(py), stokes.into_pyarray(py), reflections.into_pyarray(py), accounts, found.pieces))
    }

    /// How the light of each plane wave divides: (incident, share) in the order of `SHARES`.
    fn shares<'py>(&self, py: Python<'py>, incident: PyReadonlyArray2<'_, f64>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let incident = directions("incident", &incident)?;
        let one = |workspace: &mut Workspace, &d: &_| self.0.shares(d, workspace).map(|s| row(&s));
        let rows: Result<Vec<_>, _> = py.detach(|| incident.par_iter().map_init(Workspace::default, one).collect());
        Ok(table(&rows.map_err(errors::panel)?).into_pyarray(py))
    }

    /// The same by Monte Carlo: shares and their standard errors, both (incident, share), with at least `rays` rays each.
    #[allow(clippy::type_complexity)]
    fn walk_shares<'py>(
        &self,
        py: Python<'py>,
        incident: PyReadonlyArray2<'_, f64>,
        rays: u64,
        seed: u64,
    ) -> PyResult<(Bound<'py, PyArray2<f64>>, Bound<'py, PyArray2<f64>>)> {
        let incident = directions("incident", &incident)?;
        let estimates: Vec<_> = py.detach(|| {
            let walks = self.0.walks();
            // each direction has random numbers of its own
            let one = |(i, &d): (usize, &_)| estimate_shares(walks, d, rays, seed.wrapping_add((i as u64) << 32));
            incident.iter().enumerate().map(one).collect()
        });
        let means: Vec<_> = estimates.iter().map(|e| row(&e.mean)).collect();
        let errors: Vec<_> = estimates.iter().map(|e| row(&e.standard_error)).collect();
        Ok((table(&means).into_pyarray(py), table(&errors).into_pyarray(py)))
    }

    /// Strips of the light that enters between two heights, for drawing: corners (strip, 4, [z, y]), power, medium and total
    /// reflections of each.
    #[allow(clippy::type_complexity)]
    fn section_beams<'py>(
        &self,
        py: Python<'py>,
        incident: PyReadonlyArray2<'_, f64>,
        y_range_mm: (f64, f64),
        least_power: f64,
    ) -> PyResult<(Bound<'py, PyArray3<f64>>, Vec<f64>, Vec<u8>, Vec<u16>)> {
        let incident = directions("incident", &incident)?;
        let [incident] = incident[..] else { return Err(mistake("incident must be one direction")) };
        let media = &self.0.spectrum()[0].media;
        let found = py.detach(|| strips(self.0.profile(), media, incident.vector(), y_range_mm, least_power));
        let corners = Array3::from_shape_fn((found.len(), 4, 2), |(i, j, k)| {
            let corner = found[i].corners[j];
            [corner.z, corner.y][k]
        });
        Ok((
            corners.into_pyarray(py),
            found.iter().map(|s| s.power).collect(),
            found.iter().map(|s| s.medium).collect(),
            found.iter().map(|s| s.total_reflections).collect(),
        ))
    }

    /// The panel as what fills a window.
    fn glazing(&self) -> PyGlazing {
        PyGlazing(Arc::new(self.0.clone()))
    }

    /// Names of the columns of every table of shares.
    #[classattr]
    #[pyo3(name = "SHARES")]
    fn share_names() -> [&'static str; 6] {
        SHARES
    }
}

/// Adds the classes to the module.
pub fn register(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_class::<PyProfile>()?;
    module.add_class::<PyPanel>()
}
