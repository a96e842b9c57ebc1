//! What turns the sun's beams as a whole: flat mirrors and windows, and where light can go from each.

use super::sensors::Sensors;
use super::shade::Screens;
use crate::facet::Facet;
use crate::scene::Scene;
use crate::surface::Kind;
use hemisphere::Vec3;

/// The flat things that turn light, what can be lit, and what throws shadows.
pub struct Turners {
    pub all: Vec<Turner>,
    pub screens: Screens,
    /// Boxes about what sends light on diffusely, and about the sensors.
    receivers: Vec<Shape>,
}

/// A mirror's facet, or a window.
pub struct Turner {
    pub facet: u32,
    shape: Shape,
}

/// Corners and directions of edges, with a ball about them.
struct Shape {
    corners: Vec<Vec3>,
    edges: Vec<Vec3>,
    centre: Vec3,
    radius: f64,
}

/// Mirrors are followed up to so many directions of their normals.
pub const MOST_NORMALS: usize = 256;

/// And up to so many facets.
pub const MOST_FACETS: usize = 1024;

/// Normals nearer than this are one \[rad\].
const SAME: f64 = 1e-6;

/// Lengths that are rounding, in shares of the sizes compared.
const ROUNDING: f64 = 1e-9;

/// A curved mirror, of more facets than are followed.
#[derive(Clone, Debug, PartialEq)]
pub struct Unfollowed {
    /// The surface.
    pub name: String,
    /// Directions of its normals, opposite ones being one.
    pub normals: usize,
    /// Its facets.
    pub facets: usize,
}

/// Which surfaces are mirrors whose beams are followed, and which are too curved.
fn mirrors(scene: &Scene) -> (Vec<usize>, Vec<Unfollowed>) {
    let is_mirror =
        |(_, surface): &(usize, &crate::Surface)| matches!(surface.kind, Kind::Opaque(m) if m.specular > 0.0);
    let mut mirrors: Vec<(usize, Vec<Vec3>)> = scene
        .surfaces
        .iter()
        .enumerate()
        .filter(is_mirror)
        .map(|(k, surface)| {
            let mut normals = Vec::new();
            surface.facets.clone().for_each(|facet| add_normal(&mut normals, scene.facet(facet).normal));
            (k, normals)
        })
        .collect();
    // the flattest first
    mirrors.sort_by_key(|(k, normals)| (normals.len(), scene.surfaces[*k].facets.len()));
    let (mut all, mut facets) = (Vec::new(), 0);
    let (mut followed, mut left_out) = (Vec::new(), Vec::new());
    for (k, normals) in mirrors {
        let surface = &scene.surfaces[k];
        let mut together = all.clone();
        normals.iter().for_each(|&normal| add_normal(&mut together, normal));
        if together.len() > MOST_NORMALS || facets + surface.facets.len() > MOST_FACETS {
            let name = surface.name.clone();
            left_out.push(Unfollowed { name, normals: normals.len(), facets: surface.facets.len() });
        } else {
            facets += surface.facets.len();
            all = together;
            followed.push(k);
        }
    }
    (followed, left_out)
}

/// Adds a normal that is not there yet, up to sign; more than can be followed are not told apart.
fn add_normal(normals: &mut Vec<Vec3>, normal: Vec3) {
    if normals.len() <= MOST_NORMALS && !normals.iter().any(|n| n.cross(normal).length_squared() < SAME * SAME) {
        normals.push(normal);
    }
}

/// Mirrors so curved that the sun by way of them is not looked for.
pub fn unfollowed_mirrors(scene: &Scene) -> Vec<Unfollowed> {
    mirrors(scene).1
}

impl Turners {
    /// Those of a scene, to light its surfaces and these sensors.
    pub fn new(scene: &Scene, sensors: &Sensors) -> Self {
        let followed = mirrors(scene).0;
        let surfaces = || scene.surfaces.iter().enumerate();
        let turns = |k: usize, kind: &Kind| matches!(kind, Kind::Window { .. }) || followed.contains(&k);
        let all = surfaces().filter(|(k, s)| turns(*k, &s.kind)).flat_map(|(_, s)| s.facets.clone());
        let lit = |kind: &Kind| match kind {
            Kind::Opaque(material) => material.diffuse > 0.0,
            Kind::Window { glazing, .. } => glazing.spreads(),
            Kind::Interface { .. } => false,
        };
        let corners = |facets: std::ops::Range<u32>| facets.flat_map(|f| scene.facet(f).corners()).collect::<Vec<_>>();
        let mut receivers: Vec<Shape> =
            surfaces().filter(|(_, s)| lit(&s.kind)).map(|(_, s)| Shape::around(&corners(s.facets.clone()))).collect();
        receivers.push(Shape::around(&(0..sensors.len()).map(|i| sensors.position(i)).collect::<Vec<_>>()));
        Self {
            all: all.map(|facet| Turner { facet, shape: Shape::of(scene.facet(facet)) }).collect(),
            screens: Screens::of(scene),
            receivers,
        }
    }

    /// The turners that light leaving one along a direction may meet: more than it does, but none too few.
    pub fn onward<'a>(&'a self, scene: &'a Scene, from: usize, direction: Vec3) -> impl Iterator<Item = usize> + 'a {
        let (source, left) = (&self.all[from].shape, scene.facet(self.all[from].facet));
        (0..self.all.len()).filter(move |&to| {
            let Turner { facet, shape } = &self.all[to];
            to != from && source.shines_on(left, direction, shape) && arrives(source, scene.facet(*facet), direction)
        })
    }

    /// Whether light leaving a turner along a direction may fall on what it can light.
    pub fn lights(&self, scene: &Scene, from: usize, direction: Vec3) -> bool {
        let (source, left) = (&self.all[from].shape, scene.facet(self.all[from].facet));
        self.receivers.iter().any(|receiver| source.shines_on(left, direction, receiver))
    }
}

/// Whether some of what sends light along a direction lies on the side of a facet that the light comes from.
fn arrives(source: &Shape, facet: &Facet, direction: Vec3) -> bool {
    let side = facet.normal.dot(direction).signum();
    source.corners.iter().any(|&corner| side * facet.height(corner) < -ROUNDING * source.radius)
}

impl Shape {
    fn of(facet: &Facet) -> Self {
        let corners = facet.corners();
        let edges = (0..corners.len()).map(|k| corners[(k + 1) % corners.len()] - corners[k]);
        let mut apart: Vec<Vec3> = Vec::new();
        for edge in edges.map(Vec3::normalize) {
            // parallel edges bound nothing new
            if !apart.iter().any(|e| e.cross(edge).length_squared() < SAME * SAME) {
                apart.push(edge);
            }
        }
        Self::with_edges(corners, apart)
    }

    /// The box around points.
    fn around(points: &[Vec3]) -> Self {
        let low = points.iter().fold(Vec3::INFINITY, |low, &p| low.min(p));
        let high = points.iter().fold(Vec3::NEG_INFINITY, |high, &p| high.max(p));
        let pick = |bit: usize, k: usize| if bit >> k & 1 == 0 { low[k] } else { high[k] };
        let corners = (0..8).map(|bit| Vec3::new(pick(bit, 0), pick(bit, 1), pick(bit, 2))).collect();
        Self::with_edges(corners, vec![Vec3::X, Vec3::Y, Vec3::Z])
    }

    fn with_edges(corners: Vec<Vec3>, edges: Vec<Vec3>) -> Self {
        let centre = corners.iter().copied().sum::<Vec3>() / corners.len() as f64;
        let radius = corners.iter().map(|c| (*c - centre).length()).fold(0.0, f64::max);
        Self { corners, edges, centre, radius }
    }

    /// Whether light that leaves the whole of this, a facet, along a direction may fall on another shape: unless a plane along the
    /// light parts the two, or the facet's own plane.
    fn shines_on(&self, facet: &Facet, direction: Vec3, other: &Self) -> bool {
        let (way, reach) = (other.centre - self.centre, self.radius + other.radius);
        let along = way.dot(direction);
        if along < -reach || (way - along * direction).length() > reach {
            return false;
        }
        let (least, side) = (ROUNDING * reach, facet.normal.dot(direction).signum());
        if other.corners.iter().all(|&corner| side * facet.height(corner) <= least) {
            return false;
        }
        self.edges.iter().chain(&other.edges).all(|edge| {
            let axis = direction.cross(*edge);
            let extent = |shape: &Self| {
                shape
                    .corners
                    .iter()
                    .map(|c| axis.dot(*c))
                    .fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], x| [low.min(x), high.max(x)])
            };
            let ([low, high], [other_low, other_high]) = (extent(self), extent(other));
            high >= other_low - least && other_high >= low - least
        })
    }
}
