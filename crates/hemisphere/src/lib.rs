//! Unit directions, orthonormal frames and well-spread random numbers: the geometry that every other crate rests on.

mod direction;
mod frame;
mod rng;
mod sobol;

pub use direction::Direction;
pub use frame::Frame;
pub use glam::DVec3 as Vec3;
pub use rng::Rng;
pub use sobol::{DIMENSIONS as SOBOL_DIMENSIONS, Sobol};
