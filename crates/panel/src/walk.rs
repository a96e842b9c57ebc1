//! The Monte Carlo walk: rays through exact facets, arcs, ripple and haze.

mod draw;
mod estimate;
mod geometry;
mod ray;

pub use draw::Draw;
pub use estimate::{Estimate, estimate_shares};
pub use ray::{End, Ray, Walk};
