//! Independent rounds, one after another, until they are good enough (theory/room.md, eq. 10).

use super::Part;
use super::estimate::Estimate;
use super::gather::{GROUP, Round, Task};
use super::path::Light;
use super::plan::Plan;
use super::portals::Portals;
use super::sensors::Sensors;
use super::settings::{Progress, Settings};
use super::walk::Walker;
use crate::RoomError;
use crate::scene::Scene;
use hemisphere::Rng;
use rayon::prelude::*;
use std::time::Instant;

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

/// What follows the paths of a round.
pub fn walker<'b>(scene: &'b Scene, portals: &'b Portals, light: &'b Light<'b>, settings: &Settings) -> Walker<'b> {
    Walker { scene, portals, light, layers: &[], max_bounces: settings.max_bounces }
}

/// Runs rounds. `light` gives the light of a round from its seed; `weights` has a value for each of its columns. Without a `plan` it is
/// made for this light.
pub fn run<'a>(
    scene: &Scene,
    sensors: &Sensors,
    settings: &Settings,
    weights: &[f64],
    plan: Option<Plan>,
    light: impl Fn(u64) -> Result<Light<'a>, RoomError>,
    mut go_on: impl FnMut(Progress) -> bool,
) -> Result<Found, RoomError> {
    let started = Instant::now();
    let portals = Portals::of(scene);
    let limited = settings.max_bounces.is_some();
    let plan = match plan {
        Some(plan) => plan,
        None => {
            let ahead = light(Rng::new(settings.seed, u64::MAX).bits())?;
            Plan::new(&walker(scene, &portals, &ahead, settings), sensors, weights, settings)
        }
    };
    let mut groups: Vec<Group> = (0..sensors.len())
        .step_by(GROUP)
        .map(|first| Group::new(first, (first + GROUP).min(sensors.len()), weights.len(), limited))
        .collect();
    let (mut rounds, mut interrupted) = (0, false);
    let worst = loop {
        let seed = Rng::new(settings.seed, rounds as u64).bits();
        let light = light(seed)?;
        let walker = walker(scene, &portals, &light, settings);
        groups.par_iter_mut().for_each(|group| group.round.clear());
        for lot in 0..plan.nodes.lots {
            let layers = plan.nodes.draw(&walker, seed, lot);
            let walker = Walker { layers: &layers, ..walker };
            let task = Task { walker: &walker, sensors, own: &plan.own, seed, lot, lots: plan.nodes.lots };
            groups.par_iter_mut().for_each(|group| task.gather(group.first..group.end, &mut group.round));
        }
        groups.par_iter_mut().for_each(|group| group.take_in(weights));
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
