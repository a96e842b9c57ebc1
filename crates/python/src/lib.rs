//! The native half of the Python package: conversions, no physics. One or two files a crate, added to the module here.

#![warn(clippy::unwrap_used, clippy::expect_used)]

mod arrays;
mod bsdf;
mod errors;
mod glazing;
mod optics;
mod panel;
mod room;
mod scene;
mod sky;
mod stack;
mod sun_way;

use pyo3::prelude::*;

/// Exact light and Monte Carlo walks behind the `clerestory` package.
#[pymodule]
fn _native(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add("__version__", env!("CARGO_PKG_VERSION"))?;
    optics::register(module)?;
    panel::register(module)?;
    glazing::register(module)?;
    bsdf::register(module)?;
    stack::register(module)?;
    sun_way::register(module)?;
    sky::register(module)?;
    scene::register(module)?;
    room::register(module)?;
    sun_way::register(module)?;
    Ok(())
}
