//! One round for one group of sensors: what each finds on its own, and what the shared nodes send it.

use super::nodes::Node;
use super::numbers::Numbers;
use super::path::{Found, Link, Path, Techniques, Vertex};
use super::plan::Own;
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

/// What the sensors do in one lot of a round.
pub struct Task<'a> {
    pub walker: &'a Walker<'a>,
    pub sensors: &'a Sensors,
    /// Each sensor's own work in the round.
    pub own: &'a [Own],
    pub seed: u64,
    pub lot: usize,
    pub lots: usize,
}

/// What the radiance of each node counts for at each sensor, layer by layer.
type NodeWeights = Vec<Vec<[f64; GROUP]>>;

impl Task<'_> {
    /// Adds to `round` what the sensors of `group` find.
    pub fn gather(&self, group: Range<usize>, round: &mut Round) {
        let layers = self.walker.layers;
        let lanes = Lanes::of(self.sensors, group.clone(), self.own);
        let mut weights: NodeWeights = layers.iter().map(|layer| vec![[0.0; GROUP]; layer.nodes.len()]).collect();
        for (node, weights) in layers[0].nodes.iter().zip(&mut weights[0]) {
            if !(node.entries.is_empty() && node.links.is_empty()) {
                *weights = lanes.weights(self.walker, node);
            }
        }
        let mut found = Found::default();
        for (s, i) in group.enumerate() {
            self.explore(i, &mut found);
            for Entry { patch, part, value } in found.entries.drain(..) {
                round.row(part, patch)[s] += value;
            }
            for Link { depth, to, weight } in found.links.drain(..) {
                weights[depth as usize][to as usize][s] += weight;
            }
        }
        for (depth, layer) in layers.iter().enumerate() {
            let (here, deeper) = weights.split_at_mut(depth + 1);
            let seen = layer.nodes.iter().zip(&here[depth]).filter(|(_, weights)| **weights != [0.0; GROUP]);
            for (node, weights) in seen {
                for &Entry { patch, part, value } in &layer.found.entries[node.entries.clone()] {
                    add(round.row(part, patch), weights, value);
                }
                for link in &layer.found.links[node.links.clone()] {
                    add(&mut deeper[link.depth as usize - depth - 1][link.to as usize], weights, link.weight);
                }
            }
        }
    }

    /// What one sensor finds through windows and along directions of its own (theory/room.md, eqs. 3–6).
    pub fn explore(&self, i: usize, out: &mut Found) {
        let Self { walker, sensors, own, lot, lots, .. } = *self;
        let own = own[i];
        let vertex = Vertex { place: sensors.place(i), normal: sensors.normal(i), facet: NO_FACET };
        let techniques = Techniques {
            directions: f64::from(own.directions),
            window_points: own.window_points,
            per_sr: own.per_sr,
            nodes: Some(&walker.layers[0].density),
            of_sensor: true,
        };
        // sensors draw independent points, so that their errors do not line up
        let seed = Rng::new(self.seed, i as u64).bits();
        if lot == 0 {
            let mut path = Path { numbers: Numbers::new(Sobol { seed }, 0), out };
            walker.look_out(&vertex, PI, &techniques, 0, &mut path);
            walker.look_at_patches(&vertex, PI, &techniques, &mut path);
        }
        let directions = Sobol { seed: !seed };
        // each lot takes its part of the directions
        let part = |lot: usize| (u64::from(own.directions) * lot as u64 / lots as u64) as u32;
        for index in part(lot)..part(lot + 1) {
            let mut path = Path { numbers: Numbers::new(directions, index), out };
            let event = path.numbers.event();
            let beta = PI / f64::from(own.directions);
            walker.scattered(&vertex, beta, techniques, 0, event.start(), &mut path);
        }
    }
}

#[inline]
fn add(sums: &mut [f64; GROUP], weights: &[f64; GROUP], value: f64) {
    for (sum, weight) in sums.iter_mut().zip(weights) {
        *sum += weight * value;
    }
}

/// The sensors of a group, coordinate by coordinate.
pub struct Lanes {
    position: [[f64; GROUP]; 3],
    normal: [[f64; GROUP]; 3],
    /// Directions of its own each sensor draws, over π.
    directions: [f64; GROUP],
    places: Vec<crate::tracer::Place>,
}

impl Lanes {
    pub fn of(sensors: &Sensors, group: Range<usize>, own: &[Own]) -> Self {
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
    pub fn weights(&self, walker: &Walker<'_>, node: &Node) -> [f64; GROUP] {
        let (p, n) = (node.vertex.place.position, node.vertex.normal);
        let mut weights = [0.0; GROUP];
        for (s, weight) in weights.iter_mut().enumerate() {
            let [x, y, z] = [p.x - self.position[0][s], p.y - self.position[1][s], p.z - self.position[2][s]];
            let cos_here = x * self.normal[0][s] + y * self.normal[1][s] + z * self.normal[2][s];
            let cos_there = -(x * n.x + y * n.y + z * n.z);
            let d2 = x * x + y * y + z * z;
            let form = cos_here.max(0.0) * cos_there.max(0.0) / (d2 * d2).max(f64::MIN_POSITIVE);
            let by_direction = self.directions[s] * form;
            *weight = form * node.per_m2 / (node.per_m2 * node.per_m2 + by_direction * by_direction);
        }
        for (weight, place) in weights.iter_mut().zip(&self.places) {
            if *weight > 0.0 && !walker.scene.tracer.visible(place, &node.vertex.place) {
                *weight = 0.0;
            }
        }
        weights
    }
}
