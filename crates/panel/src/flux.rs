//! The exact optics of a panel: finitely many parallel beams, no random numbers.

mod attenuation;
mod density;
mod directions;
mod payload;
mod section;
mod sight;
mod solver;

pub use density::Part;
pub use payload::{Payload, film_reflectance};
pub use section::{Strip, strips};
pub use solver::{Limits, Solver, Wave};
