//! A sheet with ridges on one side.

use super::SHEET;
use crate::{
    error::{PanelError, positive},
    facet::{AIR, Facet, MediumId},
    plane::Vec2,
    profile::Profile,
};

/// The side that carries the ridges.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ridges {
    /// Outside.
    Front,
    /// Room side.
    Back,
}

/// Prismatic glazing: ridges along x on a flat base.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Prismatic {
    /// Height of one prism.
    pub pitch: f64,
    /// Angle between the sheet and the facet below the ridge [degrees], in (0, 90].
    pub lower_deg: f64,
    /// Angle between the sheet and the facet above the ridge [degrees], in (0, 90].
    pub upper_deg: f64,
    /// Thickness of the flat sheet under the prisms; may be 0.
    pub base: f64,
    /// Side that carries them.
    pub ridges: Ridges,
}

impl Prismatic {
    /// Height of the ridges above the base: pitch / (cot lower + cot upper) (theory/panels.md, eq. 3).
    pub fn relief(&self) -> f64 {
        self.pitch / (cot(self.lower_deg) + cot(self.upper_deg))
    }

    /// Its cross-section.
    pub fn profile(&self) -> Result<Profile, PanelError> {
        positive("pitch_mm", self.pitch)?;
        for (name, angle) in [("lower_deg", self.lower_deg), ("upper_deg", self.upper_deg)] {
            if !(angle > 0.0 && angle <= 90.0) {
                let rule = "greater than 0 and at most 90".into();
                return Err(PanelError::OutOfRange { name, rule, value: angle });
            }
        }
        if self.lower_deg == 90.0 && self.upper_deg == 90.0 {
            let rule = "less than 90 when lower_deg is 90 (the facets must meet)".into();
            return Err(PanelError::OutOfRange { name: "upper_deg", rule, value: self.upper_deg });
        }
        if !(self.base.is_finite() && self.base >= 0.0) {
            let rule = "0 or a positive number".into();
            return Err(PanelError::OutOfRange { name: "base_mm", rule, value: self.base });
        }
        let (relief, pitch) = (self.relief(), self.pitch);
        let depth = relief + self.base;
        // drawn with the ridges in front, the ridge at z = 0, then mirrored if they are at the back
        let valley = Vec2::new(relief, 0.0);
        let ridge = Vec2::new(0.0, relief * cot(self.lower_deg));
        let line = |from: Vec2, to: Vec2, left: MediumId, right: MediumId| match self.ridges {
            Ridges::Front => Facet::interface(from, to, left, right),
            Ridges::Back => {
                let mirrored = |p: Vec2| Vec2::new(depth - p.z, p.y);
                Facet::interface(mirrored(from), mirrored(to), right, left)
            }
        };
        Profile::new(
            vec![
                line(valley, ridge, AIR, SHEET),
                line(ridge, valley.raised(pitch), AIR, SHEET),
                line(Vec2::new(depth, 0.0), Vec2::new(depth, pitch), SHEET, AIR),
            ],
            pitch,
        )
    }
}

fn cot(degrees: f64) -> f64 {
    if degrees == 90.0 { 0.0 } else { 1.0 / degrees.to_radians().tan() }
}
