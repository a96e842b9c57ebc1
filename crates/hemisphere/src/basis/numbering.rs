//! The numberings of patches in the literature, from ours.

use super::SkyBasis;
use std::f64::consts::{PI, TAU};

/// How a table numbers the patches.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Order {
    /// Radiance's: the ground first, then rings from the horizon up, each clockwise from north.
    Radiance,
    /// CIE 108 and Tregenza 1987: a serpentine from due south, clockwise in the first ring, back in the second; the ground last.
    Cie,
}

impl SkyBasis {
    /// Our index of each patch in the order of such a table.
    pub fn order(&self, order: Order) -> Vec<usize> {
        let ground = self.ground();
        match order {
            Order::Radiance => std::iter::once(ground).chain(0..ground).collect(),
            Order::Cie => {
                let mut indices = Vec::with_capacity(self.patches());
                for row in 0..self.rings().len() {
                    let mut ring: Vec<usize> = (self.first[row]..self.first[row + 1]).collect();
                    ring.sort_by(|&a, &b| self.turn_from_south(a).total_cmp(&self.turn_from_south(b)));
                    if row % 2 == 1 {
                        ring.reverse();
                    }
                    indices.extend(ring);
                }
                indices.push(ground);
                indices
            }
        }
    }

    /// How far clockwise of due south a patch's centre lies, 0..2π; rounding does not push the first one a whole turn on.
    fn turn_from_south(&self, index: usize) -> f64 {
        let b = self.bounds(index);
        let width = b.azimuth_high - b.azimuth_low;
        let turn = 0.5 * (b.azimuth_low + b.azimuth_high) - PI + 1e-3 * width;
        turn.rem_euclid(TAU)
    }
}
