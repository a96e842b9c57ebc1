//! Beams with their polarisation: what a layer hands to the next one in a stack.

use super::{Lobes, Straight};
use crate::stokes::{Mueller, Stokes};
use hemisphere::Direction;

/// One parallel beam that leaves a window element, for light of any polarisation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PolarisedLobe {
    /// Where it travels, in the element's axes.
    pub direction: Direction,
    /// Its Stokes vector from that of the incident light, each about the reference axes of its own direction.
    pub mueller: Mueller,
    /// Least number of total internal reflections on the way.
    pub total_reflections: u16,
}

/// Every beam that leaves, for light of any polarisation; what neither leaves nor is residual is absorbed.
#[derive(Clone, Debug, Default)]
pub struct PolarisedLobes {
    /// The beams, no two of one direction.
    pub beams: Vec<PolarisedLobe>,
    /// Share of the power not followed to its end, taken as the same for every polarisation.
    pub residual: f64,
}

/// One parallel beam that leaves, of light whose polarisation is known.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LitLobe {
    /// Where it travels, in the element's axes.
    pub direction: Direction,
    /// Power, as a share of the incident, and polarisation about the reference axes of the direction.
    pub stokes: Stokes,
    /// Least number of total internal reflections on the way.
    pub total_reflections: u16,
}

/// Every beam that leaves when light of one polarisation comes in; powers, `absorbed` and `residual` add to 1.
#[derive(Clone, Debug, Default)]
pub struct LitLobes {
    /// The beams, no two of one direction.
    pub beams: Vec<LitLobe>,
    /// Share of the power absorbed.
    pub absorbed: f64,
    /// Share of the power not followed to its end.
    pub residual: f64,
}

impl PolarisedLobes {
    /// What becomes of light of these Stokes parameters over its power.
    pub fn lit(&self, [q, u, v]: [f64; 3], out: &mut LitLobes) {
        let light = [1.0, q, u, v];
        out.beams.clear();
        out.beams.extend(self.beams.iter().map(|beam| LitLobe {
            direction: beam.direction,
            stokes: beam.mueller.apply(light),
            total_reflections: beam.total_reflections,
        }));
        out.absorbed = self.absorbed().iter().zip(light).map(|(a, x)| a * x).sum();
        out.residual = self.residual;
    }

    /// Beams of an element of which only powers are known: what leaves is unpolarised, whatever arrives.
    pub fn depolarised(&mut self, lobes: &Lobes) {
        self.beams.clear();
        for lobe in &lobes.beams {
            let mueller = depolariser(lobe.power);
            let (direction, total_reflections) = (lobe.direction, lobe.total_reflections);
            self.beams.push(PolarisedLobe { direction, mueller, total_reflections });
        }
        self.residual = lobes.residual;
    }

    /// Share of S₀, and of S₁, S₂, S₃ over it, that is absorbed: what closes the account.
    pub fn absorbed(&self) -> Stokes {
        let mut row = [1.0 - self.residual, 0.0, 0.0, 0.0];
        for beam in &self.beams {
            row.iter_mut().zip(beam.mueller.0[0]).for_each(|(left, leaves)| *left -= leaves);
        }
        row
    }
}

/// Lets this share of the power leave and forgets the polarisation.
fn depolariser(power: f64) -> Mueller {
    let mut rows = [[0.0; 4]; 4];
    rows[0][0] = power;
    Mueller(rows)
}

/// Shares of unpolarised light, from those of s and of p light.
pub(super) fn mean([s, p]: [Straight; 2]) -> Straight {
    Straight {
        transmittance: 0.5 * (s.transmittance + p.transmittance),
        reflectance: 0.5 * (s.reflectance + p.reflectance),
    }
}
