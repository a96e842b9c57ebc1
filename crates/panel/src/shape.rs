//! The panels people make, as profiles.

mod laser_cut;
mod pane;
mod prismatic;

pub use laser_cut::LaserCut;
pub use pane::pane;
pub use prismatic::{Prismatic, Ridges};

/// The medium of the sheet.
pub const SHEET: crate::facet::MediumId = 1;
