//! The directions of light in the gaps of a stack: each kept once, and found again quickly among thousands.

use super::following::Exits;
use crate::stokes::Stokes;
use hemisphere::Direction;
use std::collections::BTreeSet;

/// Directions closer than this are one.
const SAME: f64 = 1e-9;

/// Light in gap `gap`, before layer `gap` and behind the one before, along `direction`.
pub struct State {
    pub gap: usize,
    pub direction: Direction,
    /// What has come here and not gone on.
    pub waiting: Stokes,
    pub total_reflections: u16,
    /// Where it leads, once its layer has been asked for light of any polarisation.
    pub exits: Option<Exits>,
}

/// All of them, in the order in which light came upon them.
pub struct States {
    pub all: Vec<State>,
    /// Of each gap.
    directories: Vec<Directory>,
}

impl States {
    /// Of a stack of so many layers.
    pub fn new(layers: usize) -> Self {
        Self { all: Vec::new(), directories: (0..=layers).map(|_| Directory::default()).collect() }
    }

    /// The number of the state of this direction in this gap, made if it is new.
    pub fn find(&mut self, gap: usize, direction: Direction) -> usize {
        let next = self.all.len();
        let found = self.directories[gap].find(direction, next, |i| self.all[i].direction);
        if found == next {
            self.all.push(State { gap, direction, waiting: [0.0; 4], total_reflections: u16::MAX, exits: None });
        }
        found
    }

    /// Adds light to state `i`, and returns how much now waits there.
    pub fn add(&mut self, i: usize, light: Stokes, total_reflections: u16) -> f64 {
        let there = &mut self.all[i];
        there.waiting.iter_mut().zip(light).for_each(|(sum, x)| *sum += x);
        there.total_reflections = there.total_reflections.min(total_reflections);
        there.waiting[0]
    }
}

/// Numbers of directions by their height y: light between panels keeps its x, and its heights differ.
#[derive(Default)]
pub struct Directory(BTreeSet<(i64, usize)>);

impl Directory {
    /// The number of this direction among those that `of` tells, or else `next`, under which it is filed.
    pub fn find(&mut self, direction: Direction, next: usize, of: impl Fn(usize) -> Direction) -> usize {
        let near = (rank(direction.y - SAME), 0)..=(rank(direction.y + SAME), usize::MAX);
        let known = self.0.range(near).map(|&(_, i)| i).find(|&i| same(of(i), direction));
        known.unwrap_or_else(|| {
            self.0.insert((rank(direction.y), next));
            next
        })
    }
}

/// A whole number that grows with y.
fn rank(y: f64) -> i64 {
    let bits = y.to_bits() as i64;
    // of negative numbers all bits but the sign count down
    bits ^ (((bits >> 63) as u64) >> 1) as i64
}

pub fn same(a: Direction, b: Direction) -> bool {
    (a.vector() - b.vector()).length_squared() < SAME * SAME
}
