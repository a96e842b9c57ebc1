//! Shares of light by Monte Carlo, each with its standard error.

use super::{Draw, End, Walk};
use crate::panel::Shares;
use hemisphere::{Direction, Rng, Sobol};
use rayon::prelude::*;

/// Independent randomisations of the sequence: their spread is the standard error.
pub const REPLICATES: u64 = 32;

/// A mean and its standard error.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Estimate {
    /// Mean over the replicates.
    pub mean: Shares,
    /// Standard error of that mean.
    pub standard_error: Shares,
    /// Rays followed.
    pub rays: u64,
}

/// Estimates how light along `incident` divides, with at least `rays` rays. The same seed gives the same result on any
/// number of threads.
pub fn estimate_shares(walks: &[(Walk, f64)], incident: Direction, rays: u64, seed: u64) -> Estimate {
    let each = rays.div_ceil(REPLICATES).clamp(1, u64::from(u32::MAX));
    let replicate = |i: u64| {
        let mut stream = Rng::new(seed, i);
        let (sobol, offset) = (Sobol { seed: stream.bits() }, stream.uniform());
        let mut sum = Shares::default();
        for index in 0..each as u32 {
            // each wavelength in its turn, for its share of the rays
            let walk = pick(walks, (f64::from(index) + offset) / each as f64);
            count(&mut sum, incident, walk.run(incident, &mut Draw::spread(&sobol, index)));
        }
        sum.scaled(1.0 / each as f64)
    };
    let replicates: Vec<Shares> = (0..REPLICATES).into_par_iter().map(replicate).collect();
    let count = REPLICATES as f64;
    let mean = replicates.iter().fold(Shares::default(), |sum, r| sum.plus(r)).scaled(1.0 / count);
    let squares = replicates.iter().fold(Shares::default(), |sum, r| sum.plus(&r.plus(&mean.scaled(-1.0)).squared()));
    let standard_error = squares.scaled(1.0 / (count * (count - 1.0))).root();
    Estimate { mean, standard_error, rays: each * REPLICATES }
}

/// The walk whose stretch of the weights holds `u`.
fn pick(walks: &[(Walk, f64)], u: f64) -> &Walk {
    let mut left = u;
    for (walk, weight) in walks {
        left -= weight;
        if left < 0.0 {
            return walk;
        }
    }
    &walks[walks.len() - 1].0
}

fn count(sum: &mut Shares, incident: Direction, end: End) {
    match end {
        End::Leaves { direction, weight, .. } => {
            sum.count(incident, direction, weight);
            sum.absorptance += 1.0 - weight;
        }
        End::Lost { weight } => {
            sum.residual += weight;
            sum.absorptance += 1.0 - weight;
        }
    }
}

impl Shares {
    fn zip(&self, other: &Self, f: impl Fn(f64, f64) -> f64) -> Self {
        Self {
            transmittance: f(self.transmittance, other.transmittance),
            reflectance: f(self.reflectance, other.reflectance),
            absorptance: f(self.absorptance, other.absorptance),
            transmittance_deflected: f(self.transmittance_deflected, other.transmittance_deflected),
            transmittance_undeflected: f(self.transmittance_undeflected, other.transmittance_undeflected),
            residual: f(self.residual, other.residual),
        }
    }

    fn plus(&self, other: &Self) -> Self {
        self.zip(other, |a, b| a + b)
    }

    fn scaled(&self, factor: f64) -> Self {
        self.zip(self, |a, _| a * factor)
    }

    fn squared(&self) -> Self {
        self.zip(self, |a, b| a * b)
    }

    fn root(&self) -> Self {
        self.zip(self, |a, _| a.sqrt())
    }
}
