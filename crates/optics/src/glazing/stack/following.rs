//! Layers that turn light: beams followed from gap to gap, the strongest first.
//!
//! Light in one gap along one direction is one state. Where a state leads is a Mueller matrix to each of finitely many others, found
//! when light gets there; from then on light that comes again costs only additions (theory/layers.md, eqs. 5 and 6). Layers that send
//! light into ever new directions are asked for strong light alone; a walk finishes the rest ([`super::finishing`]).

use super::super::{Glazing, LitLobe, LitLobes, Lobes, PolarisedLobe, PolarisedLobes};
use super::finishing::finish;
use super::states::{State, States};
use crate::stokes::{Mueller, Stokes};
use hemisphere::Direction;
use std::collections::BinaryHeap;
use std::sync::Arc;

/// States weaker than this share of the power of a wavelength are not asked where they lead.
const ASK: f64 = 1e-7;

/// States weaker than this are not followed even if it is known where they lead.
const FOLLOW: f64 = 1e-11;

/// A layer that answers with more beams than this sends light into ever new directions.
const FEW_BEAMS: usize = 16;

/// From then on, layers that turn light are asked for states of this share or more: of all light, and of that of a wavelength the more
/// the less it weighs, by the root, as errors of wavelengths do.
const ASK_STRONG: f64 = 1e-2;

/// Times that layers which turn light are asked at most, at one wavelength.
const MOST_ASKED: usize = 200;

/// Times that a state is followed at most.
const MOST_STEPS: usize = 100_000;

/// All that becomes of one incident beam; the powers, the absorptances and `residual` add to 1.
#[derive(Clone, Debug, Default)]
pub struct StackLobes {
    /// The beams, no two of one direction, the strongest first.
    pub beams: Vec<LitLobe>,
    /// Share each layer absorbs, the outermost first.
    pub absorptance: Vec<f64>,
    /// Share not followed to its end.
    pub residual: f64,
    /// Share that was under way when enough had been asked, and was followed by a walk.
    pub walked: f64,
    /// Square of the standard error of any share by that walk, at most: of independent rays half of which go one way.
    pub walked_variance: f64,
}

/// Where a state leads.
pub struct Exits {
    ways: Vec<(usize, Mueller, u16)>,
    absorbed: Stokes,
    residual: f64,
}

/// What a layer does to directions.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Kind {
    /// Keeps or mirrors them.
    Straight,
    /// Not known yet.
    Turning,
    /// Turns light into few.
    Few,
    /// Turns light into many.
    Many,
}

/// Light of one wavelength on its way through a stack.
struct Following<'a> {
    layers: &'a [Arc<dyn Glazing>],
    is_resolved: bool,
    weight: f64,
    kinds: Vec<Kind>,
    /// The least light for which a layer that turns light is asked, and how often one has been.
    least: f64,
    asked: usize,
    states: States,
    /// States that light waits in by the bits of its power, which are in order too; outdated once there is more of it.
    queue: BinaryHeap<(u64, usize)>,
    out: &'a mut StackLobes,
}

/// Follows light of these Stokes parameters along `incident` and adds `weight` times what becomes of it to `out`.
pub fn follow(
    layers: &[Arc<dyn Glazing>],
    is_resolved: bool,
    (incident, stokes): (Direction, Stokes),
    weight: f64,
    out: &mut StackLobes,
) {
    let kind = |layer: &Arc<dyn Glazing>| layer.straight(incident).map_or(Kind::Turning, |_| Kind::Straight);
    let mut following = Following {
        layers,
        is_resolved,
        weight,
        kinds: layers.iter().map(kind).collect(),
        least: ASK,
        asked: 0,
        states: States::new(layers.len()),
        queue: BinaryHeap::new(),
        out,
    };
    let first = following.states.find(if incident.z > 0.0 { 0 } else { layers.len() }, incident);
    following.send(first, stokes, 0);
    for _ in 0..MOST_STEPS {
        // the strongest first, so that what meets again meets merged
        let Some((power, i)) = following.queue.pop() else { break };
        if following.states.all[i].waiting[0].to_bits() == power {
            following.pass_on(i);
        }
    }
    let mut states = following.states;
    finish(layers, is_resolved, &mut states, weight, out);
    for State { gap, direction, waiting, total_reflections, .. } in states.all {
        if met(layers.len(), gap, direction).is_some() {
            out.residual += weight * waiting[0];
        } else if waiting[0] != 0.0 {
            out.beams.push(LitLobe { direction, stokes: waiting.map(|x| weight * x), total_reflections });
        }
    }
}

impl Following<'_> {
    /// Adds light to a state, whose turn comes.
    fn send(&mut self, to: usize, light: Stokes, total_reflections: u16) {
        let waiting = self.states.add(to, light, total_reflections);
        if waiting >= FOLLOW {
            self.queue.push((waiting.to_bits(), to));
        }
    }

    /// Sends on what waits in state `i`, if it is known where to or worth asking.
    fn pass_on(&mut self, i: usize) {
        let State { gap, direction, waiting, .. } = self.states.all[i];
        let Some(layer) = met(self.layers.len(), gap, direction) else { return };
        if self.states.all[i].exits.is_none() {
            let kind = self.kinds[layer];
            if kind == Kind::Straight {
                if waiting[0] < ASK {
                    return;
                }
            } else {
                if waiting[0] < self.least || self.asked == MOST_ASKED {
                    return;
                }
                self.asked += 1;
            }
            if matches!(kind, Kind::Turning | Kind::Many) {
                return self.pass_on_lit(i, layer);
            }
            self.states.all[i].exits = Some(self.ask(layer, direction));
        }
        let Some(exits) = self.states.all[i].exits.take() else { return };
        let (light, count) = self.taken(i);
        let absorbed: f64 = exits.absorbed.iter().zip(light).map(|(a, x)| a * x).sum();
        self.out.absorptance[layer] += self.weight * absorbed;
        self.out.residual += self.weight * exits.residual * light[0];
        for &(to, mueller, more) in &exits.ways {
            self.send(to, mueller.apply(light), count.saturating_add(more));
        }
        self.states.all[i].exits = Some(exits);
    }

    /// The same where light is not expected to come again in numbers: its layer is asked for its polarisation alone.
    fn pass_on_lit(&mut self, i: usize, layer: usize) {
        let direction = self.states.all[i].direction;
        let ([power, q, u, v], count) = self.taken(i);
        let mut found = LitLobes::default();
        if self.is_resolved {
            self.layers[layer].lit_lobes(direction, [q / power, u / power, v / power], &mut found);
        } else {
            let mut lobes = Lobes::default();
            self.layers[layer].lobes(direction, &mut lobes);
            let mut polarised = PolarisedLobes::default();
            polarised.depolarised(&lobes);
            polarised.lit([0.0; 3], &mut found);
        }
        self.out.absorptance[layer] += self.weight * found.absorbed * power;
        self.out.residual += self.weight * found.residual * power;
        self.learn(layer, found.beams.len());
        for beam in &found.beams {
            let to = self.states.find(entered(layer, beam.direction), beam.direction);
            self.send(to, beam.stokes.map(|x| power * x), count.saturating_add(beam.total_reflections));
        }
    }

    /// What waits in a state, which then holds nothing, and its total reflections.
    fn taken(&mut self, i: usize) -> (Stokes, u16) {
        let state = &mut self.states.all[i];
        let light = std::mem::replace(&mut state.waiting, [0.0; 4]);
        (if self.is_resolved { light } else { [light[0], 0.0, 0.0, 0.0] }, state.total_reflections)
    }

    /// Asks a layer where light of one direction and any polarisation goes, and makes the states it leads to.
    fn ask(&mut self, layer: usize, direction: Direction) -> Exits {
        let mut found = PolarisedLobes::default();
        if self.is_resolved {
            self.layers[layer].polarised_lobes(direction, &mut found);
        } else {
            let mut lobes = Lobes::default();
            self.layers[layer].lobes(direction, &mut lobes);
            found.depolarised(&lobes);
        }
        if self.kinds[layer] != Kind::Straight {
            self.learn(layer, found.beams.len());
        }
        let mut to = |beam: &PolarisedLobe| self.states.find(entered(layer, beam.direction), beam.direction);
        let ways = found.beams.iter().map(|beam| (to(beam), beam.mueller, beam.total_reflections)).collect();
        Exits { ways, absorbed: found.absorbed(), residual: found.residual }
    }

    /// Takes note of how many beams a layer that turns light has answered with.
    fn learn(&mut self, layer: usize, beams: usize) {
        if beams > FEW_BEAMS {
            self.kinds[layer] = Kind::Many;
            self.least = ASK_STRONG / self.weight.sqrt();
        } else if self.kinds[layer] == Kind::Turning {
            self.kinds[layer] = Kind::Few;
        }
    }
}

/// The layer of `count` that light in a gap meets next; `None` if it has left.
pub fn met(count: usize, gap: usize, direction: Direction) -> Option<usize> {
    if direction.z > 0.0 { (gap < count).then_some(gap) } else { gap.checked_sub(1) }
}

/// The gap that light leaving `layer` along `direction` enters.
pub fn entered(layer: usize, direction: Direction) -> usize {
    if direction.z > 0.0 { layer + 1 } else { layer }
}
