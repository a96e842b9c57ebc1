//! A block on the leaves of a tensor tree, fine where light goes.

mod slice;
mod writer;

pub use writer::TreeWriter;

use crate::OpticsError;
use hemisphere::{disk_to_square, square_to_disk};
use slice::Slice;
use std::{f64::consts::PI, sync::OnceLock};

/// Values on the leaves of a tree that halves every coordinate at once.
///
/// Rank 4: the coordinates are those of incident (x, y) and of outgoing (x, y), each pair from the disk to the unit square.
/// Rank 3, for elements that are the same turned about their normal: (1 − r)/2 of the incident radius r, and the outgoing pair
/// turned by the incident azimuth (theory/bsdf_averaging.md, eqs. 3 and 4). Bit k of a child's number says in which half of coordinate k it
/// lies.
#[derive(Debug)]
pub struct Tree {
    rank: usize,
    /// Halvings down to the finest leaf.
    depth: u32,
    nodes: Vec<Node>,
    /// Share sent out from each finest incident cell.
    totals: Vec<f64>,
    /// What is sent out from each finest incident cell, collected when it is first drawn from.
    slices: Vec<OnceLock<Slice>>,
}

#[derive(Clone, Copy, Debug)]
enum Node {
    /// The value [1/sr].
    Leaf(f64),
    /// Number of the first of 2^rank children, which lie together.
    Inner(u32),
}

/// Halvings at most: a side of 1024 cells.
pub(super) const DEEPEST: u32 = 10;

impl Tree {
    /// A block from its preorder walk: NaN is an inner node whose 2^rank children follow, anything else a leaf [1/sr].
    pub fn from_preorder(rank: usize, preorder: &[f64]) -> Result<Self, OpticsError> {
        if !(rank == 3 || rank == 4) {
            return Err(OpticsError::TreeRank { rank });
        }
        let mut nodes = vec![Node::Leaf(0.0)];
        // places still to be filled, the next one last, with their depth
        let mut open = vec![(0_usize, 0_u32)];
        let mut depth = 0;
        for (at, &value) in preorder.iter().enumerate() {
            let Some((slot, level)) = open.pop() else {
                return Err(OpticsError::TreeLength { rule: "end with its last leaf", at });
            };
            if value.is_nan() {
                if level == DEEPEST {
                    return Err(OpticsError::TreeLength { rule: "halve no coordinate more than 10 times", at });
                }
                let first = nodes.len();
                nodes[slot] = Node::Inner(first as u32);
                nodes.resize(first + (1 << rank), Node::Leaf(0.0));
                open.extend((first..nodes.len()).rev().map(|child| (child, level + 1)));
                depth = depth.max(level + 1);
            } else if value.is_finite() && value >= 0.0 {
                nodes[slot] = Node::Leaf(value);
            } else {
                return Err(OpticsError::BsdfValue { place: format!("leaf at place {at} of the tree"), value });
            }
        }
        if !open.is_empty() {
            return Err(OpticsError::TreeLength { rule: "have 2^rank children for every node", at: preorder.len() });
        }
        let cells = 1 << (depth * (rank as u32 - 2));
        let mut tree = Self { rank, depth, nodes, totals: vec![0.0; cells], slices: Vec::new() };
        tree.slices.resize_with(cells, OnceLock::new);
        let mut totals = std::mem::take(&mut tree.totals);
        tree.add_totals(0, 0, [0, 0], &mut totals);
        tree.totals = totals;
        Ok(tree)
    }

    /// Adds what a node's leaves send out to the finest incident cells they cover.
    fn add_totals(&self, node: usize, level: u32, incident: [usize; 2], totals: &mut [f64]) {
        match self.nodes[node] {
            Node::Inner(first) => {
                for child in 0..1 << self.rank {
                    let half = [incident[0] * 2 + (child & 1), incident[1] * 2 + (child >> 1 & 1)];
                    let incident = if self.rank == 4 { half } else { [half[0], 0] };
                    self.add_totals(first as usize + child, level + 1, incident, totals);
                }
            }
            Node::Leaf(0.0) => {}
            Node::Leaf(value) => {
                let share = value * PI * 0.25_f64.powi(level as i32);
                let side = 1 << (self.depth - level);
                let rows = if self.rank == 4 { side } else { 1 };
                for row in 0..rows {
                    let start = ((incident[1] * rows + row) << self.depth) + incident[0] * side;
                    totals[start..start + side].iter_mut().for_each(|total| *total += share);
                }
            }
        }
    }

    /// Number of coordinates.
    pub fn rank(&self) -> usize {
        self.rank
    }

    /// Number of nodes, leaves included.
    pub fn size(&self) -> usize {
        self.nodes.len()
    }

    /// The incident coordinates (the second is 0 at rank 3), and the turn to the azimuth they are given at.
    fn incident_coordinates(&self, [x, y]: [f64; 2]) -> ([f64; 2], [f64; 2]) {
        if self.rank == 4 {
            return (disk_to_square(x, y), [1.0, 0.0]);
        }
        let r = x.hypot(y);
        let turn = if r > 0.0 { [x / r, y / r] } else { [1.0, 0.0] };
        ([0.5 - 0.5 * r.min(1.0), 0.0], turn)
    }

    /// The finest incident cell of incident coordinates: along each of them.
    fn incident_cell(&self, coordinates: [f64; 2]) -> [usize; 2] {
        let side = 1_usize << self.depth;
        coordinates.map(|c| ((c * side as f64) as usize).min(side - 1))
    }

    fn cell_number(&self, cell: [usize; 2]) -> usize {
        (cell[1] << self.depth) + cell[0]
    }

    /// The value [1/sr].
    pub fn value(&self, incident: [f64; 2], [x, y]: [f64; 2]) -> f64 {
        let (arrives, [cosine, sine]) = self.incident_coordinates(incident);
        let leaves = disk_to_square(cosine * x + sine * y, cosine * y - sine * x);
        let mut at = [arrives[0], arrives[1], leaves[0], leaves[1]];
        if self.rank == 3 {
            at = [arrives[0], leaves[0], leaves[1], 0.0];
        }
        let mut node = 0;
        loop {
            match self.nodes[node] {
                Node::Leaf(value) => return value,
                Node::Inner(first) => {
                    let mut child = 0;
                    for (k, coordinate) in at.iter_mut().enumerate().take(self.rank) {
                        *coordinate *= 2.0;
                        if *coordinate >= 1.0 {
                            child |= 1 << k;
                            *coordinate -= 1.0;
                        }
                    }
                    node = first as usize + child;
                }
            }
        }
    }

    /// Share of the light along `incident` that is sent out.
    pub fn hemispherical(&self, incident: [f64; 2]) -> f64 {
        let (arrives, _) = self.incident_coordinates(incident);
        self.totals[self.cell_number(self.incident_cell(arrives))]
    }

    /// The greatest such share of all incident cells.
    pub fn greatest_hemispherical(&self) -> f64 {
        self.totals.iter().copied().fold(0.0, f64::max)
    }

    /// A direction drawn in proportion to power.
    pub(super) fn sample(&self, incident: [f64; 2], u: [f64; 3]) -> [f64; 2] {
        let (arrives, [cosine, sine]) = self.incident_coordinates(incident);
        let cell = self.incident_cell(arrives);
        let slice = self.slices[self.cell_number(cell)].get_or_init(|| Slice::of(self, cell));
        let [s, t] = slice.sample(u);
        let [x, y] = square_to_disk(s, t);
        [cosine * x - sine * y, sine * x + cosine * y]
    }
}
