//! What a path carries with it: where it is, how it got there, whose random numbers it uses.

use super::Entry;
use super::nodes::NodeDensity;
use super::numbers::Numbers;
use super::suns::Suns;
use crate::scene::Scene;
use crate::surface::Medium;
use crate::tracer::{Place, Ray};
use hemisphere::{SkyBasis, Vec3};
use std::f64::consts::PI;

/// A point of a surface that reflects diffusely, or a sensor, on the side of its normal.
#[derive(Clone, Copy)]
pub struct Vertex {
    pub place: Place,
    /// Unit normal on the side that is lit.
    pub normal: Vec3,
    /// The facet it lies on, or none.
    pub facet: u32,
}

/// The random numbers of one path and the light found on it.
pub struct Path<'a> {
    pub numbers: Numbers,
    pub out: &'a mut Vec<Entry>,
}

impl Path<'_> {
    /// A way that branches off.
    pub fn branch(&mut self) -> Path<'_> {
        Path { numbers: self.numbers.branch(), out: self.out }
    }
}

/// How many points each technique draws, for weighing them against each other.
#[derive(Clone, Copy)]
pub struct Techniques<'a> {
    /// Directions drawn by the cosine law.
    pub directions: f64,
    /// Points drawn on windows.
    pub window_points: u32,
    /// Directions drawn in each patch of the sky, for windows that turn no light.
    pub patch_directions: u32,
    /// Points drawn on surfaces.
    pub nodes: Option<&'a NodeDensity>,
}

/// Where the light comes from.
pub enum Light<'a> {
    /// The sky and the ground, patch by patch.
    Sky(&'a SkyBasis),
    /// The sun at many places in turn.
    Suns(Suns),
}

/// Whence a ray comes, as far as another technique could have found its end.
pub enum Came<'a> {
    /// From a diffuse vertex at this cosine.
    Scattered { cos: f64, techniques: Techniques<'a> },
    /// From a mirror, a window or a boundary: no other technique follows these.
    Specular,
}

/// Where a path stands.
pub struct State<'a> {
    pub ray: Ray,
    /// What its radiance counts for.
    pub beta: f64,
    pub came: Came<'a>,
    pub bounces: u32,
    pub redirected: bool,
    pub medium: Medium,
    /// Whether diffuse vertices look for windows.
    pub looks_out: bool,
}

impl Came<'_> {
    pub fn is_sensor(&self) -> bool {
        matches!(self, Self::Scattered { techniques: Techniques { nodes: Some(_), .. }, .. })
    }

    /// The share of a surface point's light that a drawn direction keeps, the rest being left to the nodes (balance heuristic,
    /// theory/room.md, eq. 6).
    pub fn kept_at_node(&self, scene: &Scene, facet: u32, cos_facet: f64, distance: f64) -> f64 {
        let Self::Scattered { cos, techniques: Techniques { directions, nodes: Some(nodes), .. } } = self else {
            return 1.0;
        };
        let by_direction = directions * cos * cos_facet.abs() / (PI * distance * distance);
        let by_node = nodes.per_m2(scene.facet(facet).surface, cos_facet < 0.0);
        by_direction / (by_direction + by_node)
    }
}
