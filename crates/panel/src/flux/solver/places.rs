//! Which channel, bundle and exit stands for a hand and a direction: looked up at once, for tilted facets know thousands.

use crate::{flux::directions::DirectionId, topology::HalfEdge};

/// No number.
const NONE: u32 = u32::MAX;

/// Numbers by direction and hand.
#[derive(Debug, Default)]
pub struct Places {
    hands: usize,
    /// Of each direction: for each hand a channel and a bundle, then an exit.
    numbers: Vec<u32>,
}

impl Places {
    /// Forgets all; from now on there are so many hands.
    pub fn reset(&mut self, hands: usize) {
        self.numbers.clear();
        self.hands = hands;
    }

    /// The channel of light that leaves this hand.
    pub fn channel(&self, from: HalfEdge, direction: DirectionId) -> Option<u32> {
        self.get(self.channel_at(from, direction))
    }

    /// Notes it.
    pub fn set_channel(&mut self, from: HalfEdge, direction: DirectionId, number: u32) {
        self.set(self.channel_at(from, direction), number);
    }

    /// The bundle of light that arrives at this hand.
    pub fn bundle(&self, at: HalfEdge, direction: DirectionId) -> Option<u32> {
        self.get(self.channel_at(at, direction) + self.hands)
    }

    /// Notes it.
    pub fn set_bundle(&mut self, at: HalfEdge, direction: DirectionId, number: u32) {
        self.set(self.channel_at(at, direction) + self.hands, number);
    }

    /// The exit of this direction.
    pub fn leaving(&self, direction: DirectionId) -> Option<u32> {
        self.get(self.leaving_at(direction))
    }

    /// Notes it.
    pub fn set_leaving(&mut self, direction: DirectionId, number: u32) {
        self.set(self.leaving_at(direction), number);
    }

    fn row(&self) -> usize {
        2 * self.hands + 1
    }

    fn channel_at(&self, from: HalfEdge, direction: DirectionId) -> usize {
        direction as usize * self.row() + from.0 as usize
    }

    fn leaving_at(&self, direction: DirectionId) -> usize {
        (direction as usize + 1) * self.row() - 1
    }

    fn get(&self, at: usize) -> Option<u32> {
        self.numbers.get(at).copied().filter(|&number| number != NONE)
    }

    fn set(&mut self, at: usize, number: u32) {
        if at >= self.numbers.len() {
            let row = self.row();
            self.numbers.resize((at / row + 1) * row, NONE);
        }
        self.numbers[at] = number;
    }
}
