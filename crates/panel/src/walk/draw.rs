//! The random numbers of one walk: well-spread ones first, then independent ones.

use hemisphere::{Rng, SOBOL_DIMENSIONS, Sobol};

/// Numbers in [0, 1), one after the other.
#[derive(Clone, Debug)]
pub struct Draw {
    first: [f64; SOBOL_DIMENSIONS],
    used: usize,
    then: Rng,
}

impl Draw {
    /// Walk `index` of the randomisation `seed`: a point of a scrambled Sobol sequence, then a stream of its own.
    #[inline]
    pub fn spread(sobol: &Sobol, index: u32) -> Self {
        Self { first: sobol.set(index, 0), used: 0, then: Rng::new(sobol.seed, u64::from(index)) }
    }

    /// Three numbers given from outside; the last also seeds what follows.
    pub fn given(u: [f64; 3]) -> Self {
        let mut first = [0.0; SOBOL_DIMENSIONS];
        first[SOBOL_DIMENSIONS - 3..].copy_from_slice(&u);
        Self { first, used: SOBOL_DIMENSIONS - 3, then: Rng::new(u[2].to_bits(), u[1].to_bits()) }
    }

    /// The next number.
    #[inline]
    pub fn uniform(&mut self) -> f64 {
        if self.used < SOBOL_DIMENSIONS {
            self.used += 1;
            self.first[self.used - 1]
        } else {
            self.then.uniform()
        }
    }

    /// Two independent normal numbers (Box and Muller, 1958).
    pub fn normals(&mut self) -> (f64, f64) {
        let radius = (-2.0 * (1.0 - self.uniform()).ln()).sqrt();
        let (sin, cos) = (std::f64::consts::TAU * self.uniform()).sin_cos();
        (radius * cos, radius * sin)
    }
}
