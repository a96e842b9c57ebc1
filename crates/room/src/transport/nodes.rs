//! Points on diffuse surfaces that all sensors share, in layers: every sensor sees those of the first, and whatever light was reflected
//! b times sees a few of layer b (theory/room.md, eqs. 7 and 8).

use super::Entry;
use super::density::{NodeDensity, Picked};
use super::numbers::Numbers;
use super::path::{Found, Link, Path, Vertex};
use super::walk::Walker;
use crate::surface::Kind;
use hemisphere::{Rng, Sobol};
use rayon::prelude::*;
use std::f64::consts::PI;
use std::ops::Range;

/// A shared point.
pub struct Node {
    /// Where it lies, which way it faces.
    pub vertex: Vertex,
    /// Nodes per m² there, as its layer's density has it.
    pub per_m2: f64,
    /// What it sends on: entries of its layer.
    pub entries: Range<usize>,
    /// Which links of its layer lead on from it.
    pub links: Range<usize>,
}

/// The nodes of one layer, with the light found for them.
pub struct Layer {
    /// Nodes per m²; of a deeper layer, only of those that one vertex is linked to.
    pub density: NodeDensity,
    /// Its nodes; in a deeper layer as many as a power of two.
    pub nodes: Vec<Node>,
    /// What they send on, where their links lead.
    pub found: Found,
    /// To how many of them a vertex is linked.
    links: usize,
}

/// How many nodes of each layer, and where.
pub struct NodePlan {
    layers: Vec<LayerPlan>,
    /// Lots that a round draws its nodes in: each is linked within itself, so that no more is held than fits near the processor.
    pub lots: usize,
}

struct LayerPlan {
    density: NodeDensity,
    /// Nodes of one lot.
    count: usize,
    /// To how many of them a vertex is linked.
    links: usize,
}

/// The most nodes of the first layer in one lot.
const LOT: usize = 8192;

/// Deeper layers: light that was reflected more often is followed by itself.
const DEEPER: usize = 3;

/// Nodes of the first layer for each of a deeper one.
const FIRST_PER_DEEPER: usize = 4;

/// Nodes that a vertex is linked to, after one reflection and after more.
const LINKS: [usize; 2] = [8, 4];

/// Nodes handled by one task.
const BLOCK: usize = 64;

impl NodePlan {
    /// `near`, where nodes serve sensors, and `far`, where they serve nodes, are densities of one node.
    pub fn new(near: &NodeDensity, far: &NodeDensity, nodes: usize) -> Self {
        let lots = nodes.div_ceil(LOT);
        let of_lot = nodes.div_ceil(lots);
        let density = near.times((lots * of_lot) as f64);
        let mut layers = vec![LayerPlan { density, count: if near.is_empty() { 0 } else { of_lot }, links: 0 }];
        if !far.is_empty() {
            let count = of_lot.div_ceil(FIRST_PER_DEEPER).next_power_of_two();
            layers.extend((0..DEEPER).map(|depth| {
                let links = LINKS[depth.min(1)].min(count);
                LayerPlan { density: far.times(links as f64), count, links }
            }));
        }
        Self { layers, lots }
    }

    /// Draws the nodes of one lot of a round, the deepest layer first, and follows a path from each. The order is that of the indices,
    /// whoever does the work.
    pub fn draw(&self, walker: &Walker<'_>, seed: u64, lot: usize) -> Vec<Layer> {
        let empty = |LayerPlan { density, links, .. }: &LayerPlan| Layer {
            density: density.clone(),
            nodes: Vec::new(),
            found: Found::default(),
            links: *links,
        };
        let mut layers: Vec<Layer> = self.layers.iter().map(empty).collect();
        for (depth, LayerPlan { density, count, .. }) in self.layers.iter().enumerate().rev() {
            let sobol = Sobol { seed: Rng::new(seed, u64::MAX - depth as u64).bits() };
            let walker = Walker { layers: &layers, ..*walker };
            let indices = (lot * count) as u32..((lot + 1) * count) as u32;
            let (nodes, found) = draw_layer(&walker, density, indices, sobol, depth as u32 + 1);
            (layers[depth].nodes, layers[depth].found) = (nodes, found);
        }
        layers
    }
}

/// Draws the nodes of these indices, whose light was reflected `bounces` times, their own reflection counted.
fn draw_layer(
    walker: &Walker<'_>,
    density: &NodeDensity,
    indices: Range<u32>,
    sobol: Sobol,
    bounces: u32,
) -> (Vec<Node>, Found) {
    let blocks: Vec<(Vec<Node>, Found)> = indices
        .clone()
        .into_par_iter()
        .step_by(BLOCK)
        .map(|first| {
            let (mut nodes, mut found) = (Vec::with_capacity(BLOCK), Found::default());
            for index in first..(first + BLOCK as u32).min(indices.end) {
                let (vertex, per_m2) = place(walker, density, sobol, index);
                let (entries, links) = (found.entries.len(), found.links.len());
                lit_node(walker, &vertex, Numbers::new(sobol, index), Some(index), bounces, &mut found);
                let (entries, links) = (entries..found.entries.len(), links..found.links.len());
                nodes.push(Node { vertex, per_m2, entries, links });
            }
            (nodes, found)
        })
        .collect();
    let (mut nodes, mut found) = (Vec::with_capacity(indices.len()), Found::default());
    for (block, of_block) in blocks {
        let (entries, links) = (found.entries.len(), found.links.len());
        let asked = found.asked.len() as u32;
        let shifted = |range: Range<usize>, by: usize| range.start + by..range.end + by;
        nodes.extend(block.into_iter().map(|node| Node {
            entries: shifted(node.entries, entries),
            links: shifted(node.links, links),
            ..node
        }));
        // only where the sun is asked for later are their patches numbers of the block's own
        found.entries.extend(of_block.entries.into_iter().map(|entry| Entry { patch: entry.patch + asked, ..entry }));
        found.asked.extend(of_block.asked);
        found.links.extend(of_block.links);
    }
    (nodes, found)
}

fn place(walker: &Walker<'_>, density: &NodeDensity, sobol: Sobol, index: u32) -> (Vertex, f64) {
    let u = sobol.point(index, 0);
    let Picked { facet, point, front, per_m2 } = density.pick(walker.scene, [u.coordinate(0), u.coordinate(1)]);
    let normal = walker.scene.facet(facet).normal;
    let normal = if front { normal } else { -normal };
    (Vertex { place: walker.scene.tracer.place_on(facet, point), normal, facet }, per_m2)
}

/// Follows a path from a node: what it sends on, patch by patch. `index` is its own in its layer, if it is in one.
pub fn lit_node(
    walker: &Walker<'_>,
    vertex: &Vertex,
    numbers: Numbers,
    index: Option<u32>,
    bounces: u32,
    out: &mut Found,
) {
    if let Kind::Opaque(material) = walker.scene.surface_of(vertex.facet).kind {
        let mut path = Path { numbers, out };
        let event = path.numbers.event();
        walker.reflected(vertex, material.diffuse, index, bounces, &event, &mut path);
    }
}

impl Layer {
    /// Whether there are nodes to link to.
    pub fn is_linked(&self) -> bool {
        self.links > 0 && !self.nodes.is_empty()
    }

    /// Links a vertex to a few nodes spread over all of them; what is too near for this, directions find (theory/room.md, eq. 8).
    /// `beta` counts the mean radiance.
    pub fn link(&self, walker: &Walker<'_>, depth: u32, vertex: &Vertex, index: u32, beta: f64, out: &mut Vec<Link>) {
        let (p, n) = (vertex.place.position, vertex.normal);
        let count = self.nodes.len();
        for k in 0..self.links {
            // any 2ᵏ nodes in a row are well spread in either layer: so are their pairs
            let to = (index as usize ^ (k * (count / self.links))) & (count - 1);
            let node = &self.nodes[to];
            let way = node.vertex.place.position - p;
            let (here, there, d2) = (way.dot(n), -way.dot(node.vertex.normal), way.length_squared());
            if here <= 0.0 || there <= 0.0 || (node.entries.is_empty() && node.links.is_empty()) {
                continue;
            }
            let form = here * there / (PI * d2 * d2).max(f64::MIN_POSITIVE);
            if walker.scene.tracer.visible(&vertex.place, &node.vertex.place) {
                out.push(Link { depth, to: to as u32, weight: beta * form / (node.per_m2 + form) });
            }
        }
    }
}
