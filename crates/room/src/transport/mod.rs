//! How light gets from the sky to the sensors (theory/room.md).
//!
//! Everything is followed backwards, from where light is wanted to where it comes from. A [`walk::Walker`] follows one path; points
//! on surfaces, [`nodes`], are shared by all sensors; [`gather`] joins the two into the coefficients of one round, and
//! [`rounds`] runs independent ones until they are good enough.

pub mod any_sun;
mod beams;
pub mod centre;
pub mod coefficients;
mod density;
mod estimate;
mod gather;
mod importance;
mod look_out;
mod nodes;
mod numbers;
mod path;
mod pilot;
mod plan;
mod portals;
pub mod rounds;
mod seen;
mod sensors;
pub mod settings;
mod shade;
mod sky;
mod spread;
pub mod sun;
mod suns;
mod through;
pub mod turners;
mod walk;

/// Which way light took from the sky to the sensor.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Part {
    /// No diffuse reflection and no total internal reflection.
    Direct,
    /// No diffuse reflection, at least one total internal reflection.
    Redirected,
    /// At least one diffuse reflection.
    Interreflected,
    /// More diffuse reflections than the user allowed.
    Lost,
}

/// Light found at the end of one path: how much of a patch's luminance it carries.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Entry {
    pub patch: u32,
    pub part: Part,
    pub value: f64,
}
