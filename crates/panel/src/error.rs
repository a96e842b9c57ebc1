//! What can be wrong with the drawing of a panel or with a question put to it.

use thiserror::Error;

/// A user's mistake: name, rule, value and way out, in the user's units.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum PanelError {
    /// A size that must be positive is not, or is no number.
    #[error("{name} must be a positive number, got {value}")]
    NotPositive {
        /// Parameter.
        name: &'static str,
        /// What was given.
        value: f64,
    },
    /// A number outside its range.
    #[error("{name} must be {rule}, got {value}")]
    OutOfRange {
        /// Parameter.
        name: &'static str,
        /// The range in words.
        rule: String,
        /// What was given.
        value: f64,
    },
    /// An empty sequence.
    #[error("{name} must have at least one value, got an empty sequence; give a number or a list of numbers")]
    Empty {
        /// Parameter.
        name: &'static str,
    },
    /// The kerf swallows the bar.
    #[error("cut_width_mm must be smaller than spacing_mm ({spacing}), got {width}")]
    CutWiderThanSpacing {
        /// Kerf.
        width: f64,
        /// Distance of the cuts.
        spacing: f64,
    },
    /// Neighbouring cuts meet inside the sheet.
    #[error(
        "cut_tilt_deg makes cuts {first} and {second} cross inside the sheet (tilts {tilt_first}° and {tilt_second}°); \
         use equal tilts, a wider spacing_mm or a smaller cut_depth_mm"
    )]
    CutsCross {
        /// Number of the lower cut, from 1.
        first: usize,
        /// Number of the upper cut.
        second: usize,
        /// Its tilt.
        tilt_first: f64,
        /// Its tilt.
        tilt_second: f64,
    },
    /// A profile without facets.
    #[error("a profile needs at least one facet, got none; draw the outline of the panel's cross-section")]
    NoFacets,
    /// A facet without length, or with a coordinate that is no number.
    #[error("facet {facet} must have two different finite ends, got ({z0}, {y0}) to ({z1}, {y1})")]
    NoLength {
        /// Its number, from 1.
        facet: usize,
        /// Start, across the sheet.
        z0: f64,
        /// Start, height.
        y0: f64,
        /// End, across the sheet.
        z1: f64,
        /// End, height.
        y1: f64,
    },
    /// An arc that is no arc.
    #[error("facet {facet}: the bulge of an arc must be between -1 (half circle) and 1, got {bulge}")]
    Bulge {
        /// Its number, from 1.
        facet: usize,
        /// What was given.
        bulge: f64,
    },
    /// Two facets cross or lie on one another.
    #[error(
        "facet {first} crosses facet {second} near z = {z:.6}, y = {y:.6}; facets may only meet at their ends \
         (mind the copies one pitch above and below)"
    )]
    Crossing {
        /// Number of the one, from 1.
        first: usize,
        /// Number of the other.
        second: usize,
        /// Where, across the sheet.
        z: f64,
        /// Where, height.
        y: f64,
    },
    /// The media around a vertex do not agree.
    #[error(
        "the profile does not close at the end of facet {facet} (z = {z:.6}, y = {y:.6}): medium {one} on one side meets \
         medium {other} of facet {neighbour}; let the outline go on there, or swap the facet's media"
    )]
    Media {
        /// Number of the facet, from 1.
        facet: usize,
        /// Number of the next facet around the vertex.
        neighbour: usize,
        /// Medium of the facet in the sector.
        one: u8,
        /// Medium of the neighbour in the same sector.
        other: u8,
        /// Where, across the sheet.
        z: f64,
        /// Where, height.
        y: f64,
    },
    /// A film whose two sides differ.
    #[error("facet {facet} is an air gap of no width and must have one medium on both sides, got {left} and {right}")]
    FilmMedia {
        /// Its number, from 1.
        facet: usize,
        /// Medium to the left.
        left: u8,
        /// Medium to the right.
        right: u8,
    },
    /// Light finds no panel: a gap that runs straight through, or an outside of several media.
    #[error("the {side} of the profile must face one medium, got media {one} and {other}; close the outline")]
    Outside {
        /// front or back.
        side: &'static str,
        /// One medium met.
        one: u8,
        /// Another.
        other: u8,
    },
    /// Fewer media given than the facets name.
    #[error("the profile names medium {needed}, but only {given} media are given; add its index of refraction")]
    MissingMedium {
        /// Highest number named.
        needed: u8,
        /// How many there are.
        given: usize,
    },
    /// The exact solver takes smooth mirrors only.
    #[error(
        "cut_slope_deg and cut_diffuse must be 0 for method 'exact', got a rough or diffuse cut; \
         use method='monte_carlo', which follows them"
    )]
    RoughCut,
}

/// Refuses anything but a positive number.
pub(crate) fn positive(name: &'static str, value: f64) -> Result<f64, PanelError> {
    if value.is_finite() && value > 0.0 { Ok(value) } else { Err(PanelError::NotPositive { name, value }) }
}

/// Refuses a number outside a closed range.
pub(crate) fn within(name: &'static str, value: f64, least: f64, most: f64) -> Result<f64, PanelError> {
    if value >= least && value <= most {
        Ok(value)
    } else {
        Err(PanelError::OutOfRange { name, rule: format!("between {least} and {most}"), value })
    }
}
