//! Light that is still under way when enough has been asked is followed by a well-spread walk from layer to layer
//! (theory/layers.md, eqs. 11 and 12).

use super::super::{Glazing, Scattered};
use super::StackLobes;
use super::following::{entered, met};
use super::states::{State, States};
use hemisphere::{Direction, Sobol};
use std::sync::Arc;

/// The standard error that is wanted of any share, and the rays at most and at least.
const STANDARD_ERROR: f64 = 2e-4;
const MOST_RAYS: f64 = 32_768.0;
const LEAST_RAYS: f64 = 64.0;

/// Less light than this share is not worth a walk: it stays residual.
const WORTH_A_WALK: f64 = 1e-5;

/// Any seed will do; one for all keeps results reproducible.
const SEED: u64 = 0x00c1_e7e5_7021;

/// Meetings with a layer after which a ray is given up.
const MOST_MEETINGS: u32 = 20_000;

/// Light drawn at random in a gap of a stack.
#[derive(Clone, Copy)]
pub struct Ray {
    pub gap: usize,
    pub direction: Direction,
    /// Stokes parameters over the power, about the reference axes of the direction.
    pub polarisation: [f64; 3],
    pub total_reflections: u16,
}

/// How a ray ends.
pub enum End {
    /// It leaves, and is then before the stack or behind it.
    Leaves(Ray),
    /// It ends in this layer.
    Absorbed(usize),
    /// It was given up.
    Lost,
}

/// Draws where a ray goes, with three numbers in [0, 1) for each layer that it meets.
pub fn walk(
    layers: &[Arc<dyn Glazing>],
    is_resolved: bool,
    mut ray: Ray,
    mut numbers: impl FnMut(u32) -> [f64; 3],
) -> End {
    for meeting in 0..MOST_MEETINGS {
        let Some(layer) = met(layers.len(), ray.gap, ray.direction) else { return End::Leaves(ray) };
        let u = numbers(meeting);
        let (drawn, polarisation) = if is_resolved {
            layers[layer].polarised_scatter(ray.direction, ray.polarisation, u)
        } else {
            (layers[layer].scatter(ray.direction, u), [0.0; 3])
        };
        let Scattered::Leaves { direction, total_reflections } = drawn else { return End::Absorbed(layer) };
        let total_reflections = ray.total_reflections.saturating_add(total_reflections);
        ray = Ray { gap: entered(layer, direction), direction, polarisation, total_reflections };
    }
    End::Lost
}

/// Sends rays, equally strong, from all that waits, and adds where they leave to the states there.
pub fn finish(layers: &[Arc<dyn Glazing>], is_resolved: bool, states: &mut States, weight: f64, out: &mut StackLobes) {
    let waits = |s: &State| met(layers.len(), s.gap, s.direction).is_some() && s.waiting[0] > 0.0;
    let left: f64 = states.all.iter().filter(|s| waits(s)).map(|s| s.waiting[0]).sum();
    if left < WORTH_A_WALK {
        return;
    }
    let waiting: Vec<(Ray, f64)> = states.all.iter_mut().filter(|s| waits(s)).map(taken).collect();
    let rays = (weight * (0.5 * left / STANDARD_ERROR).powi(2)).min(weight * MOST_RAYS).max(LEAST_RAYS) as u32;
    let sobol = Sobol { seed: SEED };
    let power = left / f64::from(rays);
    let (mut passed, mut index) = (0.0, 0);
    for (ray, strength) in waiting {
        passed += strength;
        // systematic sampling: ray i stands at (i + ½) / rays of the light
        while index < rays && (f64::from(index) + 0.5) * power < passed {
            let numbers = |meeting: u32| {
                let point = sobol.point(index, meeting);
                std::array::from_fn(|k| point.coordinate(k))
            };
            let ray = if is_resolved { ray } else { Ray { polarisation: [0.0; 3], ..ray } };
            match walk(layers, is_resolved, ray, numbers) {
                End::Leaves(Ray { gap, direction, polarisation: [q, u, v], total_reflections }) => {
                    let to = states.find(gap, direction);
                    states.add(to, [power, power * q, power * u, power * v], total_reflections);
                }
                End::Absorbed(layer) => out.absorptance[layer] += weight * power,
                End::Lost => out.residual += weight * power,
            }
            index += 1;
        }
    }
    out.walked += weight * left;
    out.walked_variance += (0.5 * weight * left).powi(2) / f64::from(rays);
}

/// The light of a state as a ray, with its power; the state then holds nothing.
fn taken(state: &mut State) -> (Ray, f64) {
    let [power, q, u, v] = std::mem::replace(&mut state.waiting, [0.0; 4]);
    let State { gap, direction, total_reflections, .. } = *state;
    (Ray { gap, direction, polarisation: [q / power, u / power, v / power], total_reflections }, power)
}
