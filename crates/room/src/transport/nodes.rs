//! Points on diffuse surfaces that all sensors share: each is the start of one path, seen by every sensor (theory/room.md, eq. 7).

use super::Entry;
use super::numbers::Numbers;
use super::path::{Path, Vertex};
use super::sensors::Sensors;
use super::walk::{Walker, cosine_direction};
use crate::scene::Scene;
use crate::surface::Kind;
use crate::tracer::{NO_FACET, Ray};
use hemisphere::{Direction, Frame, Rng, Sobol};
use rayon::prelude::*;

/// How densely nodes lie on each side of each surface.
pub struct NodeDensity {
    /// Nodes per m², back and front of each surface.
    per_m2: Vec<[f64; 2]>,
    /// Surface, whether front, and probability up to and with it.
    choices: Vec<(u32, bool, f64)>,
}

impl NodeDensity {
    /// Spreads `nodes` over the diffuse surfaces in proportion to `weight` of each one's back and front.
    pub fn new(scene: &Scene, nodes: usize, weight: &[[f64; 2]]) -> Self {
        let sum: f64 = weight.iter().flatten().sum();
        let (mut per_m2, mut choices) = (vec![[0.0; 2]; scene.surfaces.len()], Vec::new());
        let mut up_to_here = 0.0;
        for (k, sides) in weight.iter().enumerate() {
            for (side, w) in sides.iter().enumerate().filter(|(_, w)| **w > 0.0) {
                up_to_here += w / sum;
                choices.push((k as u32, side == 1, up_to_here));
                per_m2[k][side] = nodes as f64 * w / sum / scene.surfaces[k].area;
            }
        }
        Self { per_m2, choices }
    }

    /// Nodes per m² on a side of a surface.
    #[inline]
    pub fn per_m2(&self, surface: u32, front: bool) -> f64 {
        self.per_m2[surface as usize][usize::from(front)]
    }

    /// Whether there is any surface to put nodes on.
    pub fn is_empty(&self) -> bool {
        self.choices.is_empty()
    }

    /// Which side of which surface `u` picks, and what is left of `u`.
    fn pick(&self, u: f64) -> (u32, bool, f64) {
        let i = self.choices.iter().position(|c| u < c.2).unwrap_or(self.choices.len() - 1);
        let before = if i == 0 { 0.0 } else { self.choices[i - 1].2 };
        let (surface, front, up_to_here) = self.choices[i];
        (surface, front, ((u - before) / (up_to_here - before)).min(1.0))
    }
}

/// A shared point and the light found for it.
pub struct Node {
    /// Where it lies, which way it faces.
    pub vertex: Vertex,
    /// Nodes per m² there.
    pub per_m2: f64,
    /// What it sends on, patch by patch.
    pub entries: Vec<Entry>,
}

/// The nodes of one round, and how densely they lie.
pub struct Shared<'a> {
    pub density: &'a NodeDensity,
    pub nodes: &'a [Node],
}

/// Nodes handled by one task.
const BLOCK: usize = 64;

/// Draws the nodes of one round and follows a path from each. The order is that of the indices, whoever does the work.
pub fn lit_nodes(walker: &Walker<'_>, density: &NodeDensity, count: usize, seed: u64) -> Vec<Node> {
    if density.is_empty() {
        return Vec::new();
    }
    let sobol = Sobol { seed };
    let blocks: Vec<Vec<Node>> = (0..count)
        .into_par_iter()
        .step_by(BLOCK)
        .map(|first| (first..(first + BLOCK).min(count)).map(|i| lit_node(walker, density, sobol, i as u32)).collect())
        .collect();
    blocks.into_iter().flatten().collect()
}

fn lit_node(walker: &Walker<'_>, density: &NodeDensity, sobol: Sobol, index: u32) -> Node {
    let scene = walker.scene;
    let mut entries = Vec::new();
    let mut path = Path { numbers: Numbers::new(sobol, index), out: &mut entries };
    let event = path.numbers.event();
    let (surface, front, u) = density.pick(event.start()[0]);
    let (facet, point) = scene.point_on(surface, [u, event.start()[1]]);
    let normal = if front { scene.facet(facet).normal } else { -scene.facet(facet).normal };
    let vertex = Vertex { place: scene.tracer.place_on(facet, point), normal, facet };
    if let Kind::Opaque(material) = scene.surfaces[surface as usize].kind {
        walker.reflected(&vertex, material.diffuse, 1.0, 1, &event, &mut path);
    }
    Node { vertex, per_m2: density.per_m2(surface, front), entries }
}

/// What a few rays from the sensors tell before the work begins.
pub struct Pilot {
    /// Light that the sensors get from the back and front of each surface, roughly.
    pub weight: Vec<[f64; 2]>,
    /// For each sensor, the share of its hemisphere that only rays of its own explore: sky, mirrors, boundaries, windows.
    pub alone: Vec<f64>,
}

/// Rays a sensor sends ahead, at least.
const PILOT_RAYS: u32 = 64;

/// Rays that all sensors together send ahead, at least: what these miss is too little to matter.
const ALL_PILOT_RAYS: u32 = 8192;

/// Looks around from every sensor. Its rays serve for planning alone, so what is planned by them stays unbiased.
pub fn pilot(walker: &Walker<'_>, sensors: &Sensors, seed: u64) -> Pilot {
    let scene = walker.scene;
    let rays = PILOT_RAYS.max(ALL_PILOT_RAYS / sensors.len() as u32);
    let looked: Vec<(Vec<(u32, bool)>, f64)> = (0..sensors.len())
        .into_par_iter()
        .map(|i| {
            let sobol = Sobol { seed: seed ^ Rng::new(seed, i as u64).bits() };
            let frame = Frame::about(Direction::from_unit(sensors.normal(i)));
            let (mut met, mut alone) = (Vec::new(), 0.0);
            for index in 0..rays {
                let local = cosine_direction([sobol.sample(index, 0), sobol.sample(index, 1)]);
                let ray = Ray { origin: sensors.position(i), direction: frame.outward(local), leaving: NO_FACET };
                let Some(hit) = scene.tracer.closest(&ray) else {
                    alone += 1.0;
                    continue;
                };
                let facet = scene.facet(hit.facet);
                let front = facet.normal.dot(ray.direction) < 0.0;
                match &scene.surface_of(hit.facet).kind {
                    Kind::Opaque(material) => {
                        alone += material.specular;
                        if material.diffuse > 0.0 {
                            met.push((facet.surface, front));
                        }
                    }
                    // seen from outside, a window leads to what only rays of one's own find
                    Kind::Window { .. } => alone += if front { 0.1 } else { 1.0 },
                    Kind::Interface { .. } => alone += 1.0,
                }
            }
            (met, alone / f64::from(rays))
        })
        .collect();
    let mut met = vec![[0.0; 2]; scene.surfaces.len()];
    for (surface, front) in looked.iter().flat_map(|(met, _)| met) {
        met[*surface as usize][usize::from(*front)] += 1.0;
    }
    let bright: Vec<[f64; 2]> = (0..scene.surfaces.len())
        .into_par_iter()
        .map(|k| {
            [0, 1].map(|side| if met[k][side] == 0.0 { 0.0 } else { brightness(walker, k as u32, side == 1, seed) })
        })
        .collect();
    let product = |a: &[f64; 2], b: &[f64; 2]| a[0] * b[0] + a[1] * b[1];
    let rays_met: f64 = met.iter().flatten().sum();
    let mean = met.iter().zip(&bright).map(|(m, b)| product(m, b)).sum::<f64>() / rays_met.max(1.0);
    // part by brightness, part evenly, lest a surface that seemed dark by chance gets hardly any
    let weight = met
        .iter()
        .zip(&bright)
        .map(|(m, b)| [0, 1].map(|side| m[side] * ((1.0 - EVENLY) * b[side] + EVENLY * mean.max(f64::MIN_POSITIVE))))
        .collect();
    Pilot { weight, alone: looked.into_iter().map(|(_, alone)| alone).collect() }
}

/// Share of the nodes that goes by what the sensors see alone.
const EVENLY: f64 = 0.3;

/// Paths that tell how bright a surface is.
const BRIGHTNESS_PATHS: u32 = 64;

/// The root mean square of what a side of a surface sends on under an even sky, roughly: the best density of points goes with it.
fn brightness(walker: &Walker<'_>, surface: u32, front: bool, seed: u64) -> f64 {
    let mut weight = vec![[0.0; 2]; walker.scene.surfaces.len()];
    weight[surface as usize][usize::from(front)] = 1.0;
    let density = NodeDensity::new(walker.scene, 1, &weight);
    let sobol = Sobol { seed: Rng::new(seed, u64::from(surface)).bits() };
    let squares: f64 = (0..BRIGHTNESS_PATHS)
        .map(|index| {
            let node = lit_node(walker, &density, sobol, index);
            node.entries.iter().map(|e| e.value).sum::<f64>().powi(2)
        })
        .sum();
    (squares / f64::from(BRIGHTNESS_PATHS)).sqrt()
}
