//! Unit directions, orthonormal frames, bases of the sky and well-spread random numbers: the geometry that every other crate rests on.

#![warn(clippy::unwrap_used, clippy::expect_used)]

mod basis;
mod direction;
mod frame;
mod rng;
mod sobol;

pub use basis::{Order, PatchBounds, Ring, SkyBasis, towards};
pub use direction::Direction;
pub use frame::Frame;
pub use glam::DVec3 as Vec3;
pub use rng::Rng;
pub use sobol::{DIMENSIONS as SOBOL_DIMENSIONS, Sobol, SobolPoint};
