//! The random numbers of one path.

use hemisphere::{Rng, Sobol, SobolPoint};

/// Numbers for the events of one path: well-spread ones for the first few, independent ones after.
pub struct Numbers {
    sobol: Sobol,
    index: u32,
    next_set: u32,
    /// Sets up to here are well spread.
    sets: u32,
    /// Independent numbers.
    pub rng: Rng,
}

/// Events with well-spread numbers; what happens after many reflections is too mixed to gain from them.
const QUASI_EVENTS: u32 = 3;

impl Numbers {
    /// Path `index` of a family of paths.
    pub fn new(sobol: Sobol, index: u32) -> Self {
        Self { sobol, index, next_set: 0, sets: QUASI_EVENTS, rng: Rng::new(sobol.seed, u64::from(index)) }
    }

    /// Independent numbers alone, for a way that branches off.
    pub fn branch(&mut self) -> Self {
        Self { sobol: self.sobol, index: self.index, next_set: 0, sets: 0, rng: Rng::new(self.rng.bits(), 0) }
    }

    /// Numbers for window points at the vertex of the last event: at the first they go with the path's own place in its family.
    pub fn window(&mut self) -> WindowNumbers {
        if self.sets > 0 && self.next_set == 1 {
            WindowNumbers { sobol: self.sobol, first: self.index, dimension: 5 }
        } else {
            WindowNumbers { sobol: Sobol { seed: self.rng.bits() }, first: 0, dimension: 0 }
        }
    }

    /// The numbers of the next event.
    #[inline]
    pub fn event(&mut self) -> Event {
        if self.next_set < self.sets {
            let set = self.next_set;
            self.next_set += 1;
            Event::Spread(self.sobol.point(self.index, set))
        } else {
            Event::Independent(self.rng.bits())
        }
    }
}

/// The numbers that a vertex draws points on the windows by.
pub struct WindowNumbers {
    sobol: Sobol,
    /// Index of the first point, and the dimension it begins with.
    first: u32,
    dimension: usize,
}

impl WindowNumbers {
    /// Coordinate `d` (0..3) of point `index`.
    #[inline]
    pub fn coordinate(&self, index: u32, d: usize) -> f64 {
        // 2ᵏ paths in a row are well spread, and so are they in any other order
        self.sobol.point(self.first ^ index, 0).coordinate(self.dimension + d)
    }
}

/// What is decided at random where a path meets a surface; each number is computed as it is asked for.
#[derive(Clone, Copy)]
pub enum Event {
    /// A point of a well-spread sequence.
    Spread(SobolPoint),
    /// The seed of independent numbers.
    Independent(u64),
}

impl Event {
    #[inline]
    fn number(&self, d: usize) -> f64 {
        match self {
            Self::Spread(point) => point.coordinate(d),
            Self::Independent(seed) => Rng::new(*seed, d as u64).uniform(),
        }
    }

    /// Where a new path starts, or what a window or boundary does.
    #[inline]
    pub fn start(&self) -> [f64; 2] {
        [self.number(0), self.number(1)]
    }

    /// Which direction a reflection takes.
    #[inline]
    pub fn direction(&self) -> [f64; 2] {
        [self.number(2), self.number(3)]
    }

    /// What becomes of the path.
    #[inline]
    pub fn choice(&self) -> f64 {
        self.number(4)
    }
}
