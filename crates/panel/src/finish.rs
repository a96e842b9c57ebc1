//! What the exact solver leaves over when its budget ends is followed by a quasi-random walk.

use crate::{
    differential::Differential,
    flux::{Part, Payload, Solver},
    panel::{Beam, Outcome},
    walk::{Draw, End, Ray, Walk},
};
use hemisphere::{Direction, Sobol, Vec3};
use optics::Stokes;

/// Rays that follow what is left if it is this share of the light or more; less light is worth fewer.
const RAYS: u32 = 4096;
const WORTH_ALL: f64 = 0.02;
/// Rays at least.
const LEAST_RAYS: u32 = 64;

/// Rays that follow what is left of the power of an incident beam.
pub fn rays(left: f64) -> u32 {
    ((f64::from(RAYS) * left / WORTH_ALL) as u32).clamp(LEAST_RAYS, RAYS)
}

/// Any seed will do; one for all keeps results reproducible.
const SEED: u64 = 0x00c1_e7e5_7021;

/// Light of one piece that still waits.
struct Waiting {
    hand: crate::HalfEdge,
    direction: Vec3,
    turning: Option<Differential>,
    start: f64,
    end: f64,
    stokes: Stokes,
    total_reflections: u16,
}

/// Sends rays from all that waits in `solver`, equally strong, and adds where they go to `outcome`, with how they move if wanted.
pub fn finish<P: Payload>(solver: &Solver<P>, moves: bool, (walk, weight): (&Walk, f64), outcome: &mut Outcome) {
    let waiting: Vec<Waiting> = solver
        .waiting()
        .map(|(hand, direction, Part { start, end, piece })| Waiting {
            hand,
            direction: solver.direction(direction),
            turning: moves.then(|| solver.turning(direction)),
            start,
            end,
            stokes: piece.mean.times(end - start).stokes(),
            total_reflections: piece.total_reflections,
        })
        .filter(|w| w.stokes[0] > 0.0)
        .collect();
    let left: f64 = waiting.iter().map(|w| w.stokes[0]).sum();
    // tiny negative pieces, which rounding makes, are no light to follow: they stay in the account
    outcome.residual += weight * (solver.waiting_power() - left);
    let rays = rays(left);
    let sobol = Sobol { seed: SEED };
    let (mut passed, mut index) = (0.0, 0);
    for w in &waiting {
        let from = passed;
        passed += w.stokes[0];
        // systematic sampling: ray i stands at (i + ½) / rays of the light
        while index < rays && (f64::from(index) + 0.5) / f64::from(rays) * left < passed {
            let share = ((f64::from(index) + 0.5) / f64::from(rays) * left - from) / w.stokes[0];
            let power = weight * left / f64::from(rays);
            let polarisation = [1, 2, 3].map(|i| w.stokes[i] / w.stokes[0]);
            let mut draw = Draw::spread(&sobol, index);
            let place = w.start + (w.end - w.start) * share.clamp(0.0, 1.0);
            let ray = Ray {
                total_reflections: w.total_reflections,
                turning: w.turning,
                ..Ray::new(w.direction, polarisation)
            };
            let (end, slopes) = walk.resume(w.hand, place, ray, &mut draw);
            match end {
                End::Leaves { direction, total_reflections, weight } => {
                    outcome.add(Beam {
                        direction: Direction::from_unit(direction),
                        stokes: [power * weight, 0.0, 0.0, 0.0],
                        total_reflections,
                        slopes,
                    });
                    outcome.absorbed += power * (1.0 - weight);
                }
                End::Lost { weight } => {
                    outcome.residual += power * weight;
                    outcome.absorbed += power * (1.0 - weight);
                }
            }
            outcome.walked += power;
            index += 1;
        }
    }
}
