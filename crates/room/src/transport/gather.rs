//! One round for one group of sensors: what each finds on its own, and what the shared nodes send it.

use super::nodes::{Node, NodeDensity, Shared};
use super::numbers::Numbers;
use super::path::{Path, Techniques, Vertex};
use super::sensors::Sensors;
use super::walk::Walker;
use super::{Entry, Part};
use crate::tracer::NO_FACET;
use hemisphere::{Rng, Sobol};
use std::f64::consts::PI;
use std::ops::Range;

/// Sensors treated together: few enough for their coefficients to stay near, enough to share the reading of the nodes.
pub const GROUP: usize = 32;

/// Coefficients of one group from one round, part by part, patch by patch, sensor by sensor.
pub struct Round {
    /// Direct, redirected, interreflected, lost.
    parts: [Vec<f64>; 4],
}

impl Round {
    pub fn new(patches: usize) -> Self {
        Self { parts: std::array::from_fn(|_| vec![0.0; patches * GROUP]) }
    }

    /// The coefficients of a part; sensor `s` of the group and patch `p` at `p * GROUP + s`.
    pub fn part(&self, part: Part) -> &[f64] {
        &self.parts[part as usize]
    }

    pub fn clear(&mut self) {
        self.parts.iter_mut().for_each(|part| part.fill(0.0));
    }

    #[inline]
    fn row(&mut self, part: Part, patch: u32) -> &mut [f64; GROUP] {
        let first = patch as usize * GROUP;
        match (&mut self.parts[part as usize][first..first + GROUP]).try_into() {
            Ok(row) => row,
            Err(_) => unreachable!("a row has the length of a group"),
        }
    }
}

/// How much work one sensor does by itself.
#[derive(Clone, Copy, Debug)]
pub struct Own {
    /// Window points.
    pub window_points: u32,
    /// Directions in each patch of the sky, looked for behind windows that turn no light.
    pub patch_directions: u32,
    /// Directions over the hemisphere.
    pub directions: u32,
}

/// Fills `round` with what the sensors of `group` find.
pub fn gather(
    walker: &Walker<'_>,
    sensors: &Sensors,
    group: Range<usize>,
    own: &[Own],
    shared: &Shared<'_>,
    seed: u64,
    round: &mut Round,
) {
    round.clear();
    let mut entries = Vec::new();
    for (s, i) in group.clone().enumerate() {
        explore(walker, sensors, i, own[i], shared.density, seed, &mut entries);
        for Entry { patch, part, value } in entries.drain(..) {
            round.row(part, patch)[s] += value;
        }
    }
    let lanes = Lanes::of(sensors, group, own);
    for node in shared.nodes.iter().filter(|node| !node.entries.is_empty()) {
        let weights = lanes.weights(walker, node);
        if weights == [0.0; GROUP] {
            continue;
        }
        for &Entry { patch, part, value } in &node.entries {
            let row = round.row(part, patch);
            for (sum, weight) in row.iter_mut().zip(&weights) {
                *sum += weight * value;
            }
        }
    }
}

/// What one sensor finds through windows and along directions of its own (theory/room.md, eqs. 3–6).
fn explore(
    walker: &Walker<'_>,
    sensors: &Sensors,
    i: usize,
    own: Own,
    density: &NodeDensity,
    seed: u64,
    out: &mut Vec<Entry>,
) {
    let vertex = Vertex { place: sensors.place(i), normal: sensors.normal(i), facet: NO_FACET };
    let techniques = Techniques {
        directions: f64::from(own.directions),
        window_points: own.window_points,
        patch_directions: own.patch_directions,
        nodes: Some(density),
    };
    // sensors draw independent points, so that their errors do not line up
    let seed = Rng::new(seed, i as u64).bits();
    let mut path = Path { numbers: Numbers::new(Sobol { seed }, 0), out };
    walker.look_out(&vertex, PI, &techniques, 0, &mut path);
    walker.look_at_patches(&vertex, PI, &techniques, &mut path);
    let directions = Sobol { seed: !seed };
    for index in 0..own.directions {
        let mut path = Path { numbers: Numbers::new(directions, index), out };
        let event = path.numbers.event();
        let beta = PI / f64::from(own.directions);
        walker.scattered(&vertex, beta, techniques, 0, event.start(), &mut path);
    }
}

/// The sensors of a group, coordinate by coordinate.
struct Lanes {
    position: [[f64; GROUP]; 3],
    normal: [[f64; GROUP]; 3],
    /// Directions of its own each sensor draws, over π.
    directions: [f64; GROUP],
    places: Vec<crate::tracer::Place>,
}

impl Lanes {
    fn of(sensors: &Sensors, group: Range<usize>, own: &[Own]) -> Self {
        let mut lanes = Self {
            position: [[0.0; GROUP]; 3],
            normal: [[0.0; GROUP]; 3],
            directions: [0.0; GROUP],
            places: group.clone().map(|i| sensors.place(i)).collect(),
        };
        for (s, i) in group.enumerate() {
            for k in 0..3 {
                lanes.position[k][s] = sensors.position(i)[k];
                lanes.normal[k][s] = sensors.normal(i)[k];
            }
            lanes.directions[s] = f64::from(own[i].directions) / PI;
        }
        lanes
    }

    /// What the radiance of a node counts for at each sensor: cos θ cos θ′/d² over the density of points there, its own directions
    /// counted in (theory/room.md, eq. 7).
    fn weights(&self, walker: &Walker<'_>, node: &Node) -> [f64; GROUP] {
        let (p, n) = (node.vertex.place.position, node.vertex.normal);
        let mut weights = [0.0; GROUP];
        for (s, weight) in weights.iter_mut().enumerate() {
            let [x, y, z] = [p.x - self.position[0][s], p.y - self.position[1][s], p.z - self.position[2][s]];
            let cos_here = x * self.normal[0][s] + y * self.normal[1][s] + z * self.normal[2][s];
            let cos_there = -(x * n.x + y * n.y + z * n.z);
            let d2 = x * x + y * y + z * z;
            let form = cos_here.max(0.0) * cos_there.max(0.0) / (d2 * d2).max(f64::MIN_POSITIVE);
            *weight = form / (node.per_m2 + self.directions[s] * form);
        }
        for (weight, place) in weights.iter_mut().zip(&self.places) {
            if *weight > 0.0 && !walker.scene.tracer.visible(place, &node.vertex.place) {
                *weight = 0.0;
            }
        }
        weights
    }
}
