//! A plain pane.

use super::SHEET;
use crate::{
    error::{PanelError, positive},
    facet::{AIR, Facet},
    plane::Vec2,
    profile::Profile,
};

/// A plane-parallel sheet, `thickness` across.
pub fn pane(thickness: f64) -> Result<Profile, PanelError> {
    positive("thickness_mm", thickness)?;
    let period = thickness;
    Profile::new(
        vec![
            Facet::interface(Vec2::new(0.0, 0.0), Vec2::new(0.0, period), AIR, SHEET),
            Facet::interface(Vec2::new(thickness, 0.0), Vec2::new(thickness, period), SHEET, AIR),
        ],
        period,
    )
}
