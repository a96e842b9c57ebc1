//! Light-redirecting panels: from the drawing of a cross-section to where every part of the light goes.

#![warn(clippy::unwrap_used, clippy::expect_used)]

mod differential;
pub mod error;
pub mod facet;
mod finish;
pub mod flux;
mod glazing;
pub mod media;
mod panel;
pub mod plane;
pub mod profile;
pub mod shape;
pub mod topology;
pub mod walk;

pub use error::PanelError;
pub use facet::{AIR, Facet, Finish, MediumId, Surface};
pub use media::{Media, Optical};
pub use panel::{Beam, Outcome, Panel, Polarisation, Sample, Shares, Workspace, incident_direction};
pub use plane::Vec2;
pub use profile::Profile;
pub use topology::HalfEdge;
