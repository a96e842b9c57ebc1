//! All that light from one finest incident cell is sent to: the tree with the incident coordinates held.

use super::{Node, Tree};
use std::f64::consts::PI;

/// The leaves that send light out, with their shares summed up.
#[derive(Debug, Default)]
pub(super) struct Slice {
    cumulative: Vec<f64>,
    /// Place and side of each leaf in the square of outgoing directions.
    squares: Vec<([f64; 2], f64)>,
}

impl Slice {
    /// Collects the leaves that hold the finest incident cell `cell`.
    pub fn of(tree: &Tree, cell: [usize; 2]) -> Self {
        let mut slice = Self::default();
        slice.collect(tree, 0, 0, cell, [0, 0]);
        slice
    }

    fn collect(&mut self, tree: &Tree, node: usize, level: u32, cell: [usize; 2], outgoing: [usize; 2]) {
        match tree.nodes[node] {
            Node::Inner(first) => {
                let incident_bits = tree.rank - 2;
                let bit = tree.depth - level - 1;
                let held = if incident_bits == 2 {
                    (cell[0] >> bit & 1) | (cell[1] >> bit & 1) << 1
                } else {
                    cell[0] >> bit & 1
                };
                for quarter in 0..4 {
                    let child = first as usize + held + (quarter << incident_bits);
                    let outgoing = [outgoing[0] * 2 + (quarter & 1), outgoing[1] * 2 + (quarter >> 1)];
                    self.collect(tree, child, level + 1, cell, outgoing);
                }
            }
            Node::Leaf(0.0) => {}
            Node::Leaf(value) => {
                let side = 0.5_f64.powi(level as i32);
                let before = self.cumulative.last().copied().unwrap_or(0.0);
                self.cumulative.push(before + value * PI * side * side);
                self.squares.push((outgoing.map(|place| place as f64 * side), side));
            }
        }
    }

    /// A place in the square of outgoing directions, in proportion to power; its middle if nothing is sent out.
    pub fn sample(&self, u: [f64; 3]) -> [f64; 2] {
        let Some(&total) = self.cumulative.last() else { return [0.5, 0.5] };
        let place = u[0] * total;
        let chosen = self.cumulative.partition_point(|&sum| sum <= place).min(self.squares.len() - 1);
        let ([s, t], side) = self.squares[chosen];
        [s + u[1] * side, t + u[2] * side]
    }
}
