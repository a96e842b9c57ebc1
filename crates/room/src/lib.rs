//! Daylight in a room: scenes of surfaces, windows and media, and the daylight coefficients of sensors in them.

#![warn(clippy::unwrap_used, clippy::expect_used)]

mod error;
mod facet;
mod loops;
mod nesting;
mod outline;
mod scene;
mod sunlit;
mod surface;
mod tracer;
mod transport;

pub use error::RoomError;
pub use facet::Facet;
pub use scene::{Scene, SceneBuilder, Surface};
pub use sunlit::{Event, Patch, PathVertex, SunBeam, SunWay, Sunlight, WaySettings, sun_way};
pub use surface::{Kind, Material, Medium};
pub use transport::Part;
pub use transport::any_sun::{AnySun, SunRound};
pub use transport::centre::{CentreCoefficients, centre_coefficients};
pub use transport::coefficients::{DaylightCoefficients, daylight_coefficients};
pub use transport::rounds::Component;
pub use transport::settings::{Progress, Settings};
pub use transport::sun::{SunCoefficients, sun_coefficients};
pub use transport::turners::{Unfollowed, unfollowed_mirrors};
