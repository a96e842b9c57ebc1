//! Layers that turn light: beams followed from gap to gap, each layer asked once for each direction it meets.
//!
//! Light in one gap along one direction is one state. Where a state leads is a Mueller matrix to each of finitely many others, found
//! when light first gets there; from then on light that comes again costs only additions (theory/layers.md, eqs. 5 and 6).

use super::super::{Glazing, Lobes, PolarisedLobes};
use crate::stokes::{Mueller, Stokes};
use hemisphere::Direction;
use std::sync::Arc;

/// States weaker than this share of the incident power are not asked where they lead: what they hold is residual.
const ASK: f64 = 1e-7;

/// States weaker than this are not followed even if it is known where they lead.
const FOLLOW: f64 = 1e-11;

/// States at most: layers that send light into ever new directions would never end.
const MOST_STATES: usize = 1_000;

/// Times that a state is followed at most.
const MOST_STEPS: usize = 100_000;

/// Directions closer than this are one.
const SAME: f64 = 1e-9;

/// One parallel beam that leaves a stack.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StackLobe {
    /// Where it travels.
    pub direction: Direction,
    /// Power, as a share of the incident, and polarisation about the reference axes of the direction.
    pub stokes: Stokes,
    /// Least number of total internal reflections on the way.
    pub total_reflections: u16,
}

/// All that becomes of one incident beam.
#[derive(Clone, Debug, Default)]
pub struct StackLobes {
    /// The beams, no two of one direction.
    pub beams: Vec<StackLobe>,
    /// Share each layer absorbs, the outermost first.
    pub absorptance: Vec<f64>,
    /// Share not followed to its end.
    pub residual: f64,
}

/// Light in gap `gap`, before layer `gap` and behind the one before, along `direction`.
struct State {
    gap: usize,
    direction: Direction,
    waiting: Stokes,
    total_reflections: u16,
    exits: Option<Exits>,
}

/// Where a state leads.
struct Exits {
    layer: usize,
    ways: Vec<(usize, Mueller, u16)>,
    absorbed: Stokes,
    residual: f64,
}

/// Follows light of these Stokes parameters along `incident` and adds `weight` times what becomes of it to `out`.
pub fn follow(
    layers: &[Arc<dyn Glazing>],
    is_resolved: bool,
    (incident, stokes): (Direction, Stokes),
    weight: f64,
    out: &mut StackLobes,
) {
    let gap = if incident.z > 0.0 { 0 } else { layers.len() };
    let mut states = vec![State { gap, direction: incident, waiting: stokes, total_reflections: 0, exits: None }];
    for _ in 0..MOST_STEPS {
        // the strongest first, so that what meets again meets merged
        let may_ask = states.len() < MOST_STATES;
        let follows = |s: &State| match (&s.exits, met(layers.len(), s.gap, s.direction)) {
            (_, None) => false,
            (Some(_), _) => s.waiting[0] >= FOLLOW,
            (None, _) => s.waiting[0] >= ASK && may_ask,
        };
        let strongest = (0..states.len())
            .filter(|&i| follows(&states[i]))
            .max_by(|&a, &b| states[a].waiting[0].total_cmp(&states[b].waiting[0]));
        let Some(i) = strongest else { break };
        let exits = match states[i].exits.take() {
            Some(known) => known,
            None => ask(layers, is_resolved, i, &mut states),
        };
        let mut light = std::mem::replace(&mut states[i].waiting, [0.0; 4]);
        if !is_resolved {
            light = [light[0], 0.0, 0.0, 0.0];
        }
        let count = states[i].total_reflections;
        out.absorptance[exits.layer] += weight * exits.absorbed.iter().zip(light).map(|(a, x)| a * x).sum::<f64>();
        out.residual += weight * exits.residual * light[0];
        for (to, mueller, total_reflections) in &exits.ways {
            let there = &mut states[*to];
            there.waiting.iter_mut().zip(mueller.apply(light)).for_each(|(sum, x)| *sum += x);
            there.total_reflections = there.total_reflections.min(count.saturating_add(*total_reflections));
        }
        states[i].exits = Some(exits);
    }
    for State { gap, direction, waiting, total_reflections, .. } in states {
        if met(layers.len(), gap, direction).is_some() {
            out.residual += weight * waiting[0];
            continue;
        }
        let stokes = waiting.map(|x| weight * x);
        match out.beams.iter_mut().find(|b| same(b.direction, direction)) {
            Some(there) => {
                there.stokes.iter_mut().zip(stokes).for_each(|(sum, x)| *sum += x);
                there.total_reflections = there.total_reflections.min(total_reflections);
            }
            None => out.beams.push(StackLobe { direction, stokes, total_reflections }),
        }
    }
}

/// Asks the layer that state `i` meets where its light goes, and makes the states it leads to.
fn ask(layers: &[Arc<dyn Glazing>], is_resolved: bool, i: usize, states: &mut Vec<State>) -> Exits {
    let State { gap, direction, .. } = states[i];
    // a state that has left is never asked
    let layer = met(layers.len(), gap, direction).unwrap_or_default();
    let mut found = PolarisedLobes::default();
    if is_resolved {
        layers[layer].polarised_lobes(direction, &mut found);
    } else {
        let mut lobes = Lobes::default();
        layers[layer].lobes(direction, &mut lobes);
        found.depolarised(&lobes);
    }
    let absorbed = found.absorbed();
    let mut ways = Vec::with_capacity(found.beams.len());
    for beam in &found.beams {
        let gap = entered(layer, beam.direction);
        let known = states.iter().position(|s| s.gap == gap && same(s.direction, beam.direction));
        let to = known.unwrap_or_else(|| {
            let direction = beam.direction;
            states.push(State { gap, direction, waiting: [0.0; 4], total_reflections: u16::MAX, exits: None });
            states.len() - 1
        });
        ways.push((to, beam.mueller, beam.total_reflections));
    }
    Exits { layer, ways, absorbed, residual: found.residual }
}

/// The layer of `count` that light in a gap meets next; `None` if it has left.
pub fn met(count: usize, gap: usize, direction: Direction) -> Option<usize> {
    if direction.z > 0.0 { (gap < count).then_some(gap) } else { gap.checked_sub(1) }
}

/// The gap that light leaving `layer` along `direction` enters.
pub fn entered(layer: usize, direction: Direction) -> usize {
    if direction.z > 0.0 { layer + 1 } else { layer }
}

pub fn same(a: Direction, b: Direction) -> bool {
    (a.vector() - b.vector()).length_squared() < SAME * SAME
}
