//! What a path carries with it: where it is, how it got there, whose random numbers it uses.

use super::density::NodeDensity;
use super::numbers::Numbers;
use super::sky::Sky;
use super::spread::Looked;
use super::suns::Suns;
use super::{Entry, Part};
use crate::scene::Scene;
use crate::surface::Medium;
use crate::tracer::{Place, Ray};
use hemisphere::Vec3;
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
    pub out: &'a mut Found,
}

/// What is found on a path.
#[derive(Default)]
pub struct Found {
    /// Light of the sky.
    pub entries: Vec<Entry>,
    /// Light of nodes.
    pub links: Vec<Link>,
    /// Where light is looked for later: its entries have the number of one of these for a patch.
    pub asked: Vec<Asked>,
}

/// A look at the sun, whichever it is.
pub enum Asked {
    /// At a point that it may shine on.
    Shine(Vertex),
    /// At a point of a window that may spread its light.
    Glow(Looked),
}

impl Found {
    /// Looks at the sun later; `value` is what its light counts for.
    pub fn ask(&mut self, asked: Asked, part: Part, value: f64) {
        self.entries.push(Entry { patch: self.asked.len() as u32, part, value });
        self.asked.push(asked);
    }
}

/// A node's light, as a vertex sends it on.
#[derive(Clone, Copy)]
pub struct Link {
    /// The layer.
    pub depth: u32,
    /// Which of its nodes.
    pub to: u32,
    /// What its radiance counts for.
    pub weight: f64,
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
    /// Directions per steradian drawn in every patch of the sky, for windows that turn no light; none are: 0.
    pub per_sr: f64,
    /// Points drawn on surfaces.
    pub nodes: Option<&'a NodeDensity>,
    /// Whether these are a sensor's own: a direction that meets a window then goes both ways.
    pub of_sensor: bool,
}

/// Where the light comes from.
pub enum Light<'a> {
    /// The sky and the ground, patch by patch.
    Sky(&'a Sky<'a>),
    /// The sun at many places in turn.
    Suns(Suns),
    /// Any sun, to be told later: what is found is where its light is asked for.
    AnySun,
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
        matches!(self, Self::Scattered { techniques: Techniques { of_sensor: true, .. }, .. })
    }

    /// The share of a surface point's light that a drawn direction keeps, the rest being left to the nodes (theory/room.md, eq. 6).
    pub fn kept_at_node(&self, scene: &Scene, facet: u32, point: Vec3, cos_facet: f64, distance: f64) -> f64 {
        let Self::Scattered { cos, techniques } = self else { return 1.0 };
        let Some(nodes) = techniques.nodes else { return 1.0 };
        let by_direction = techniques.directions * cos * cos_facet.abs() / (PI * distance * distance);
        let by_node = nodes.per_m2(scene, facet, point, cos_facet < 0.0);
        if by_node == 0.0 {
            return 1.0;
        }
        1.0 - techniques.share_of_node(by_node, by_direction)
    }
}

impl Techniques<'_> {
    /// The share of a surface point's light that nodes find, by the densities of these and of drawn directions. A sensor, which draws
    /// many, leaves them what is near (power heuristic), a reflection weighs its one by its density (balance heuristic).
    #[inline]
    pub fn share_of_node(&self, by_node: f64, by_direction: f64) -> f64 {
        if self.of_sensor {
            by_node * by_node / (by_node * by_node + by_direction * by_direction)
        } else {
            by_node / (by_node + by_direction)
        }
    }
}
