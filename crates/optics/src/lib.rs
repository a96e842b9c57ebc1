//! What smooth boundaries and clear media do to light: Snell, Fresnel, total internal reflection, polarisation,
//! absorption, and the one door, [`Glazing`], by which a room knows a window.

mod glazing;
mod interface;
mod stokes;

pub use glazing::{Glazing, Lobe, Lobes, Scattered, Side};
pub use interface::{Interface, Split, mirror, refract};
pub use stokes::{Mueller, Stokes, reference_axes};
