//! Unit directions, orthonormal frames, bases of the sky and well-spread random numbers: the geometry that every other crate rests on.

#![warn(clippy::unwrap_used, clippy::expect_used)]

mod all_weather;
mod basis;
mod direction;
mod disk;
mod frame;
mod klems;
mod rng;
mod sobol;

pub use all_weather::{AllWeather, SkyNodes};
pub use basis::{Order, PatchBounds, Ring, SkyBasis, towards};
pub use direction::Direction;
pub use disk::{disk_to_square, square_to_disk};
pub use frame::Frame;
pub use glam::DVec3 as Vec3;
pub use klems::{KlemsBasis, KlemsRing};
pub use rng::Rng;
pub use sobol::{DIMENSIONS as SOBOL_DIMENSIONS, Sobol, SobolPoint};
