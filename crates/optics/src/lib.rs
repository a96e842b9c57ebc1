//! What smooth boundaries and clear media do to light: Snell, Fresnel, total internal reflection, polarisation,
//! absorption, and the one door, [`Glazing`], by which a room knows a window.

#![warn(clippy::unwrap_used, clippy::expect_used)]

mod averaging;
mod bsdf;
mod error;
pub mod formulas;
mod glazing;
mod interface;
mod medium;
mod stokes;

pub use averaging::{Averaging, Cells, Exchange, Way, has_lobes, isotropic_trees};
pub use bsdf::{Block, Blocks, Bsdf, Matrix, Tree, TreeWriter};
pub use error::OpticsError;
pub use glazing::{
    ClearGlazing, Glazing, LayerShares, LitLobe, LitLobes, Lobe, Lobes, MovingLobes, PolarisedLobe, PolarisedLobes,
    Scattered, Side, Slopes, Stack, StackLobes, Straight, stays_image,
};
pub use interface::{Interface, Split, mirror, refract};
pub use medium::{Absorption, Dispersion, Law, Medium, Table, medium_names};
pub use stokes::{Mueller, Retarder, Stokes, reference_axes};
