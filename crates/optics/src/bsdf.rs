//! A BSDF of four blocks as a glazing: measured files, and panels averaged over patches.

mod matrix;
mod tree;

pub use matrix::Matrix;
pub use tree::{Tree, TreeWriter};

use crate::{Glazing, Lobes, OpticsError, Scattered, Side};
use hemisphere::{Direction, Vec3, square_to_disk};

/// How light that arrives on one side is sent out on one side.
///
/// A direction is named by (x, y) of the way light travels, on either side; which side is the block's affair.
#[derive(Debug)]
pub enum Block {
    /// Constant between pairs of Klems patches.
    Matrix(Matrix),
    /// Constant on the leaves of a tensor tree.
    Tree(Tree),
}

impl Block {
    /// The value [1/sr] for light that arrives along `incident` and leaves along `outgoing`.
    pub fn value(&self, incident: [f64; 2], outgoing: [f64; 2]) -> f64 {
        match self {
            Self::Matrix(matrix) => matrix.value(incident, outgoing),
            Self::Tree(tree) => tree.value(incident, outgoing),
        }
    }

    /// Share of the light along `incident` that leaves by this block: the value's integral over projected solid angle.
    pub fn hemispherical(&self, incident: [f64; 2]) -> f64 {
        match self {
            Self::Matrix(matrix) => matrix.hemispherical(incident),
            Self::Tree(tree) => tree.hemispherical(incident),
        }
    }

    /// The greatest such share of all directions.
    pub fn greatest_hemispherical(&self) -> f64 {
        match self {
            Self::Matrix(matrix) => matrix.greatest_hemispherical(),
            Self::Tree(tree) => tree.greatest_hemispherical(),
        }
    }

    /// (x, y) of a direction that light along `incident` leaves by, drawn in proportion to power; any if none leaves.
    fn sample(&self, incident: [f64; 2], u: [f64; 3]) -> [f64; 2] {
        match self {
            Self::Matrix(matrix) => matrix.sample(incident, u),
            Self::Tree(tree) => tree.sample(incident, u),
        }
    }
}

/// Where light that arrives on one side goes; a block that is missing sends out nothing.
#[derive(Debug, Default)]
pub struct Blocks {
    /// Leaves by the other side.
    pub transmission: Option<Block>,
    /// Leaves by the side it came from.
    pub reflection: Option<Block>,
}

impl Blocks {
    /// Shares transmitted and reflected, and the factor by which both are less than the blocks say: 1 unless the blocks would
    /// give more light than came.
    fn shares(&self, incident: [f64; 2]) -> (f64, f64, f64) {
        let share = |block: &Option<Block>| block.as_ref().map_or(0.0, |b| b.hemispherical(incident));
        let (transmitted, reflected) = (share(&self.transmission), share(&self.reflection));
        (transmitted, reflected, 1.0 / (transmitted + reflected).max(1.0))
    }
}

/// A flat element that spreads all its light: what a BSDF file says, no more.
///
/// A column that would send out more than it gets, as noisy files have it, is scaled to send out all; one beyond
/// [`Bsdf::MOST`] is refused.
#[derive(Debug)]
pub struct Bsdf {
    front: Blocks,
    back: Blocks,
}

impl Bsdf {
    /// The most that the light of one direction may sum to.
    pub const MOST: f64 = 1.01;

    /// A glazing of what happens to light that arrives on the front (the outside) and on the back.
    pub fn new(front: Blocks, back: Blocks) -> Result<Self, OpticsError> {
        for (side, blocks) in [("front", &front), ("back", &back)] {
            for (name, block) in [("transmission", &blocks.transmission), ("reflection", &blocks.reflection)] {
                let most = block.as_ref().map_or(0.0, Block::greatest_hemispherical);
                if most > Self::MOST {
                    return Err(OpticsError::BsdfGains { block: format!("{name}_{side}"), sum: most });
                }
            }
            // the blocks may be cut into different cells: their sum is looked at on a grid
            let places = (0..GRID * GRID).map(|k| [k / GRID, k % GRID].map(|i| (i as f64 + 0.5) / GRID as f64));
            let sums = places.map(|[u, v]| blocks.shares(square_to_disk(u, v))).map(|(t, r, _)| t + r);
            let most = sums.fold(0.0, f64::max);
            if most > Self::MOST {
                let block = format!("transmission_{side} with reflection_{side}");
                return Err(OpticsError::BsdfGains { block, sum: most });
            }
        }
        Ok(Self { front, back })
    }

    /// What happens to light that arrives on this side.
    pub fn blocks(&self, side: Side) -> &Blocks {
        match side {
            Side::Front => &self.front,
            Side::Back => &self.back,
        }
    }

    fn met_by(&self, incident: Direction) -> &Blocks {
        self.blocks(Side::entered_along(incident.vector()))
    }
}

impl Glazing for Bsdf {
    fn lobes(&self, incident: Direction, out: &mut Lobes) {
        out.clear();
        let (transmitted, reflected, factor) = self.met_by(incident).shares([incident.x, incident.y]);
        out.spread = (transmitted + reflected) * factor;
        out.absorbed = (1.0 - out.spread).max(0.0);
    }

    fn scatter(&self, incident: Direction, u: [f64; 3]) -> Scattered {
        let blocks = self.met_by(incident);
        let at = [incident.x, incident.y];
        let (transmitted, reflected, factor) = blocks.shares(at);
        // what is left of the number that chose the block is as good as new
        let place = u[0] / factor;
        let (block, side, left) = if place < transmitted {
            (&blocks.transmission, incident.z.signum(), place / transmitted)
        } else if place < transmitted + reflected {
            (&blocks.reflection, -incident.z.signum(), (place - transmitted) / reflected)
        } else {
            return Scattered::Absorbed;
        };
        let Some(block) = block else { return Scattered::Absorbed };
        let [x, y] = block.sample(at, [left.min(1.0 - f64::EPSILON), u[1], u[2]]);
        let z = (1.0 - x * x - y * y).max(LEAST_COSINE * LEAST_COSINE).sqrt();
        match Direction::of(Vec3::new(x, y, side * z)) {
            Some(direction) => Scattered::Leaves { direction, total_reflections: 0 },
            None => Scattered::Absorbed,
        }
    }

    fn bsdf(&self, incident: Direction, outgoing: Direction) -> f64 {
        let blocks = self.met_by(incident);
        let at = [incident.x, incident.y];
        let block = if incident.z * outgoing.z > 0.0 { &blocks.transmission } else { &blocks.reflection };
        let value = block.as_ref().map_or(0.0, |b| b.value(at, [outgoing.x, outgoing.y]));
        if value == 0.0 { 0.0 } else { value * blocks.shares(at).2 }
    }

    fn spreads(&self) -> bool {
        true
    }
}

/// Incident directions along each coordinate at which the sum of two blocks is looked at.
const GRID: usize = 64;

/// Light that leaves along the sheet to rounding leaves at this cosine.
const LEAST_COSINE: f64 = 1e-9;

#[cfg(test)]
mod tests;
