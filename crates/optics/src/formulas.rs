//! Published formulas, each a pure function of its own and named after its authors.
//!
//! Angles come as cosines, as everywhere in this crate; shares of power are 0..=1.

mod edmonds;
mod edmonds_greenup_compagnon;
mod slab;
mod tregenza_sharples;
mod uncoated_glass;

pub use edmonds::{edmonds_deflected_fraction, edmonds_panel_tilt};
pub use edmonds_greenup_compagnon::edmonds_greenup_compagnon;
pub use slab::{Polarisation, Shares, slab, slab_retarders, slab_single_pass};
pub use tregenza_sharples::tregenza_sharples;
pub use uncoated_glass::{UncoatedGlass, uncoated_glass};
