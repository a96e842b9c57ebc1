//! Independent rounds, one after another, until they are good enough (theory/room.md, eq. 9).

use super::Part;
use super::estimate::Estimate;
use super::gather::{GROUP, Own, Round, gather};
use super::nodes::{NodeDensity, Shared, lit_nodes, pilot};
use super::path::Light;
use super::portals::Portals;
use super::sensors::Sensors;
use super::walk::Walker;
use crate::RoomError;
use crate::scene::Scene;
use hemisphere::Rng;
use rayon::prelude::*;
use std::time::Instant;

/// How much work to do.
#[derive(Clone, Debug)]
pub struct Settings {
    /// Which random numbers.
    pub seed: u64,
    /// Independent rounds, without a target.
    pub rounds: usize,
    /// Shared points on surfaces, a round.
    pub nodes: usize,
    /// Points each sensor draws on the windows, a round.
    pub window_samples: usize,
    /// Light after more diffuse reflections is reported as lost; `None` follows it to its end.
    pub max_bounces: Option<u32>,
    /// Rounds are added until the standard error of Σ coefficient · weight is at most this share of it at every sensor.
    pub target_relative_error: Option<f64>,
    /// But not more rounds than this.
    pub max_rounds: usize,
    /// Luminances of the patches that the target speaks of; by default the overcast sky over ground of reflectance 0.2.
    pub weights: Option<Vec<f64>>,
}

impl Default for Settings {
    fn default() -> Self {
        Self {
            seed: 0,
            rounds: 16,
            nodes: 512,
            window_samples: 512,
            max_bounces: None,
            target_relative_error: None,
            max_rounds: 4096,
            weights: None,
        }
    }
}

/// Fewer rounds do not tell their own standard error.
const LEAST_ROUNDS: usize = 8;

/// How far the work is.
#[derive(Clone, Copy, Debug)]
pub struct Progress {
    /// Rounds done.
    pub rounds: usize,
    /// Rounds it will take, as far as one can tell.
    pub expected_rounds: usize,
    /// Largest relative standard error of Σ coefficient · weight over the sensors that have any; NaN before the second round.
    pub worst_relative_error: f64,
    /// Time since the start \[s\].
    pub seconds: f64,
}

/// Values and standard errors, sensor by sensor, patch by patch \[sr\].
#[derive(Clone, Debug)]
pub struct Component {
    /// Coefficients.
    pub value: Vec<f64>,
    /// Their standard errors.
    pub standard_error: Vec<f64>,
}

/// What the rounds have found, sensor by sensor, column by column.
pub struct Found {
    pub direct: Component,
    pub redirected: Component,
    pub interreflected: Component,
    pub lost: Option<Vec<f64>>,
    pub weighted: Component,
    pub rounds: usize,
    pub converged: bool,
    pub interrupted: bool,
}

fn walker<'b>(scene: &'b Scene, portals: &'b Portals, light: &'b Light<'b>, settings: &Settings) -> Walker<'b> {
    Walker { scene, portals, light, max_bounces: settings.max_bounces }
}

/// Runs rounds. `light` gives the light of a round from its seed; `weights` has a value for each of its columns.
pub fn run<'a>(
    scene: &Scene,
    sensors: &Sensors,
    settings: &Settings,
    weights: &[f64],
    light: impl Fn(u64) -> Result<Light<'a>, RoomError>,
    mut go_on: impl FnMut(Progress) -> bool,
) -> Result<Found, RoomError> {
    let started = Instant::now();
    let portals = Portals::of(scene);
    let limited = settings.max_bounces.is_some();
    let ahead = light(Rng::new(settings.seed, u64::MAX).bits())?;
    let plan = Plan::new(&walker(scene, &portals, &ahead, settings), sensors, settings);
    let mut groups: Vec<Group> = (0..sensors.len())
        .step_by(GROUP)
        .map(|first| Group::new(first, (first + GROUP).min(sensors.len()), weights.len(), limited))
        .collect();
    let (mut rounds, mut interrupted) = (0, false);
    let worst = loop {
        let seed = Rng::new(settings.seed, rounds as u64).bits();
        let light = light(seed)?;
        let walker = walker(scene, &portals, &light, settings);
        let nodes = lit_nodes(&walker, &plan.density, settings.nodes, seed);
        groups.par_iter_mut().for_each(|group| {
            let shared = Shared { density: &plan.density, nodes: &nodes };
            gather(&walker, sensors, group.first..group.end, &plan.own, &shared, seed, &mut group.round);
            group.take_in(weights);
        });
        rounds += 1;
        let worst =
            groups.iter().map(Group::worst_relative_error).fold(0.0, |a: f64, b| if a.is_nan() { a } else { b.max(a) });
        let expected_rounds = settings.expected(rounds, worst);
        if rounds >= expected_rounds {
            break worst;
        }
        let seconds = started.elapsed().as_secs_f64();
        if !go_on(Progress { rounds, expected_rounds, worst_relative_error: worst, seconds }) {
            interrupted = true;
            break worst;
        }
    };
    let component = |estimate: fn(&Group) -> &Estimate, columns| collect(&groups, estimate, sensors.len(), columns);
    Ok(Found {
        direct: component(|g| &g.parts[0], weights.len()),
        redirected: component(|g| &g.parts[1], weights.len()),
        interreflected: component(|g| &g.parts[2], weights.len()),
        lost: settings.max_bounces.map(|_| component(|g| &g.parts[3], weights.len()).value),
        weighted: component(|g| &g.weighted, 1),
        rounds,
        converged: !interrupted && settings.target_relative_error.is_none_or(|target| worst <= target),
        interrupted,
    })
}

impl Settings {
    /// Refuses numbers that make no sense.
    pub(super) fn check(&self) -> Result<(), RoomError> {
        let settings = self;
        let wrong = |name, rule, value: String, way_out| Err(RoomError::Setting { name, rule, value, way_out });
        for (name, value) in [("rounds", settings.rounds), ("max_rounds", settings.max_rounds)] {
            if value < 2 {
                return wrong(name, "at least 2", value.to_string(), "one round alone has no standard error");
            }
        }
        for (name, value) in [("nodes", settings.nodes), ("window_samples", settings.window_samples)] {
            if value == 0 || value > 1 << 24 {
                return wrong(name, "in 1..16777216", value.to_string(), "a few hundred do; add rounds for precision");
            }
        }
        if let Some(target) = settings.target_relative_error {
            if !(target > 0.0 && target.is_finite()) {
                return wrong("target_relative_error", "above 0", target.to_string(), "0.02 is 2 %");
            }
        }
        Ok(())
    }

    /// Rounds it takes in all, judged after `rounds` of them: errors fall with the root of their number.
    fn expected(&self, rounds: usize, worst: f64) -> usize {
        let Some(target) = self.target_relative_error else { return self.rounds };
        if rounds < LEAST_ROUNDS {
            return LEAST_ROUNDS.min(self.max_rounds);
        }
        if worst <= target {
            return rounds;
        }
        let more = (rounds as f64 * (worst / target).powi(2)).ceil();
        (more as usize).max(rounds + 1).min(self.max_rounds.max(rounds))
    }
}

/// Where nodes go and what each sensor does by itself.
struct Plan {
    density: NodeDensity,
    own: Vec<Own>,
}

/// Directions a sensor draws where only they explore, under suns: one for as many nodes.
const SUNS_NODES_PER_DIRECTION: usize = 8;

/// A sensor's own directions, where nodes do as well: one for as many nodes …
const NODES_PER_DIRECTION: usize = 256;

/// … but few sensors draw more, all together as many as there are nodes to so many of them.
const NODES_PER_SHARED_DIRECTION: usize = 2;

impl Plan {
    fn new(walker: &Walker<'_>, sensors: &Sensors, settings: &Settings) -> Self {
        let pilot = pilot(walker, sensors, Rng::new(settings.seed, u64::MAX).bits());
        let shared = settings.nodes.div_ceil(NODES_PER_SHARED_DIRECTION * sensors.len());
        let least = settings.nodes.div_ceil(NODES_PER_DIRECTION).max(shared) as u32;
        // half of the patches lie behind; about as many of these directions as window points then find a window
        let samples = settings.window_samples;
        let (window_points, patch_directions, exploring) = match walker.light {
            Light::Sky(basis) => (samples as u32, (2 * samples).div_ceil(basis.patches()) as u32, samples),
            // every reflection costs a look at all suns: go by the nodes
            Light::Suns(_) => (0, 0, settings.nodes / SUNS_NODES_PER_DIRECTION),
        };
        let own = pilot
            .alone
            .iter()
            .map(|alone| Own {
                window_points,
                patch_directions,
                directions: least.max((alone * exploring as f64).ceil() as u32),
            })
            .collect();
        Self { density: NodeDensity::new(walker.scene, settings.nodes, &pilot.weight), own }
    }
}

/// What is known of a group of sensors.
struct Group {
    first: usize,
    end: usize,
    round: Round,
    parts: Vec<Estimate>,
    weighted: Estimate,
}

impl Group {
    fn new(first: usize, end: usize, patches: usize, limited: bool) -> Self {
        let parts = (0..if limited { 4 } else { 3 }).map(|_| Estimate::new(patches * GROUP)).collect();
        Self { first, end, round: Round::new(patches), parts, weighted: Estimate::new(GROUP) }
    }

    fn take_in(&mut self, weights: &[f64]) {
        const PARTS: [Part; 4] = [Part::Direct, Part::Redirected, Part::Interreflected, Part::Lost];
        let mut sums = [0.0; GROUP];
        for part in &PARTS[..3] {
            for (row, weight) in self.round.part(*part).chunks_exact(GROUP).zip(weights) {
                sums.iter_mut().zip(row).for_each(|(sum, value)| *sum += weight * value);
            }
        }
        self.weighted.add(&sums);
        for (estimate, part) in self.parts.iter_mut().zip(PARTS) {
            estimate.add(self.round.part(part));
        }
    }

    /// NaN before the second round; sensors without light have no relative error.
    fn worst_relative_error(&self) -> f64 {
        (0..self.end - self.first)
            .filter(|&s| self.weighted.mean()[s] > 0.0)
            .map(|s| self.weighted.standard_error(s) / self.weighted.mean()[s])
            .fold(0.0, |a: f64, b| if a.is_nan() || b.is_nan() { f64::NAN } else { a.max(b) })
    }
}

/// From groups, patch by patch, to sensors, patch by patch.
fn collect(groups: &[Group], estimate: fn(&Group) -> &Estimate, sensors: usize, columns: usize) -> Component {
    let (mut value, mut standard_error) = (vec![0.0; sensors * columns], vec![0.0; sensors * columns]);
    for group in groups {
        let estimate = estimate(group);
        for (s, i) in (group.first..group.end).enumerate() {
            for column in 0..columns {
                value[i * columns + column] = estimate.mean()[column * GROUP + s];
                standard_error[i * columns + column] = estimate.standard_error(column * GROUP + s);
            }
        }
    }
    Component { value, standard_error }
}
