//! The light of any one sun on some sensors: a few rounds of paths are followed before the sun is known, and kept. For each sun only
//! its beams are found, and looked for where the paths were reflected (theory/room.md, eqs. 7, 8 and 13).

use super::Part;
use super::gather::{GROUP, Lanes, Task};
use super::nodes::Layer;
use super::path::{Asked, Found, Light};
use super::plan::Plan;
use super::portals::Portals;
use super::rounds::walker;
use super::seen::Shares;
use super::sensors::Sensors;
use super::settings::Settings;
use super::suns::Suns;
use super::turners::Turners;
use super::walk::Walker;
use crate::RoomError;
use crate::scene::Scene;
use hemisphere::{Direction, Rng, Vec3};
use rayon::prelude::*;
use std::f64::consts::PI;
use std::ops::Range;

/// Suns that the nodes are planned for, evenly over the sky.
const PLANNED: usize = 16;

/// Rounds of paths, of a scene and sensors that stay the same.
pub struct AnySun {
    sensors: usize,
    turners: Turners,
    rounds: Vec<KeptRound>,
}

/// One round: lots of nodes, and what the sensors find by themselves.
struct KeptRound {
    seed: u64,
    lots: Vec<KeptLot>,
}

struct KeptLot {
    layers: Vec<KeptLayer>,
    /// What the radiance of each node of the first layer counts for at each sensor, node by node.
    weights: Vec<f64>,
    /// What the sensors find, and which of it is whose.
    own: Found,
    of_sensor: Vec<Own>,
}

struct KeptLayer {
    found: Found,
    of_node: Vec<Own>,
}

/// Which entries and links belong to a node or a sensor.
struct Own {
    entries: Range<usize>,
    links: Range<usize>,
}

/// What one sun gives the sensors in one round, over its normal illuminance: direct, redirected, interreflected of each.
pub type SunRound = Vec<[f64; 3]>;

impl AnySun {
    /// Follows the paths of so many rounds of each seed. Rounds and nodes are those of the settings. They are the paths of
    /// [`super::sun::sun_coefficients`] with that seed and `any_sun`.
    pub fn new(
        scene: &Scene,
        points: &[Vec3],
        normals: &[Vec3],
        seeds: &[u64],
        settings: &Settings,
    ) -> Result<Self, RoomError> {
        settings.check()?;
        let settings = Settings { max_bounces: None, ..settings.clone() };
        let sensors = Sensors::new(scene, points, normals)?;
        let (portals, turners) = (Portals::of(scene), Turners::new(scene, &sensors));
        let plan = plan_for_any(scene, &turners, &sensors, &settings)?;
        let walker = walker(scene, &portals, &Light::AnySun, &settings);
        let of_seed = |&seed: &u64| (0..settings.rounds as u64).map(move |round| Rng::new(seed, round).bits());
        let rounds = seeds.iter().flat_map(of_seed).map(|seed| {
            let lot = |lot| KeptLot::drawn(&walker, &sensors, &plan, seed, lot);
            KeptRound { seed, lots: (0..plan.nodes.lots).map(lot).collect() }
        });
        Ok(Self { sensors: sensors.len(), rounds: rounds.collect(), turners })
    }

    /// The light of the sun `towards` here in some of the rounds: independent estimates without bias.
    pub fn light(&self, scene: &Scene, towards: Direction, rounds: Range<usize>) -> Result<Vec<SunRound>, RoomError> {
        let of_round = |round: &KeptRound| {
            let suns = Suns::one(scene, &self.turners, towards, round.seed)?;
            let mut sums = vec![[0.0; 3]; self.sensors];
            round.lots.iter().for_each(|lot| lot.add(scene, &suns, &mut sums));
            Ok(sums)
        };
        self.rounds[rounds].iter().map(of_round).collect()
    }

    /// How many rounds there are.
    pub fn rounds(&self) -> usize {
        self.rounds.len()
    }

    /// Bytes of memory, about.
    pub fn bytes(&self) -> usize {
        let found = |found: &Found| {
            size_of_val(&found.asked[..]) + size_of_val(&found.entries[..]) + size_of_val(&found.links[..])
        };
        let lot = |lot: &KeptLot| {
            let layers = lot.layers.iter().map(|layer| found(&layer.found) + size_of_val(&layer.of_node[..]));
            layers.sum::<usize>() + size_of_val(&lot.weights[..]) + found(&lot.own) + size_of_val(&lot.of_sensor[..])
        };
        self.rounds.iter().flat_map(|round| &round.lots).map(lot).sum()
    }
}

impl KeptLot {
    fn drawn(walker: &Walker<'_>, sensors: &Sensors, plan: &Plan, seed: u64, lot: usize) -> Self {
        let layers = plan.nodes.draw(walker, seed, lot);
        let walker = Walker { layers: &layers, ..*walker };
        let task = Task { walker: &walker, sensors, own: &plan.own, seed, lot, lots: plan.nodes.lots };
        let (mut own, mut of_sensor) = (Found::default(), Vec::with_capacity(sensors.len()));
        for sensor in 0..sensors.len() {
            let (entries, links) = (own.entries.len(), own.links.len());
            task.explore(sensor, &mut own);
            of_sensor.push(Own { entries: entries..own.entries.len(), links: links..own.links.len() });
        }
        let mut weights = vec![0.0; layers[0].nodes.len() * sensors.len()];
        let lanes: Vec<(usize, Lanes)> = (0..sensors.len())
            .step_by(GROUP)
            .map(|first| (first, Lanes::of(sensors, first..(first + GROUP).min(sensors.len()), &plan.own)))
            .collect();
        weights.par_chunks_mut(sensors.len().max(1)).zip(&layers[0].nodes).for_each(|(row, node)| {
            for (first, lanes) in &lanes {
                let here = row[*first..].iter_mut().zip(lanes.weights(&walker, node));
                here.for_each(|(kept, weight)| *kept = weight);
            }
        });
        let kept = |layer: Layer| KeptLayer {
            of_node: layer.nodes.into_iter().map(|node| Own { entries: node.entries, links: node.links }).collect(),
            found: layer.found,
        };
        Self { layers: layers.into_iter().map(kept).collect(), weights, own, of_sensor }
    }

    /// Adds the light of one sun to what the sensors have.
    fn add(&self, scene: &Scene, suns: &Suns, sums: &mut [[f64; 3]]) {
        // radiances, the deepest layer first
        let mut radiance: Vec<Vec<f64>> = vec![Vec::new(); self.layers.len()];
        for (depth, layer) in self.layers.iter().enumerate().rev() {
            let seen = looked_at(&layer.found, scene, suns);
            let of_node = |own: &Own| {
                let entries = layer.found.entries[own.entries.clone()].iter();
                let shone: f64 = entries.map(|entry| entry.value * both(seen[entry.patch as usize])).sum();
                shone + linked(&layer.found, own, &radiance)
            };
            radiance[depth] = layer.of_node.iter().map(of_node).collect();
        }
        let mut reflected = vec![0.0; sums.len()];
        for (row, radiance) in self.weights.chunks_exact(sums.len().max(1)).zip(&radiance[0]) {
            if *radiance > 0.0 {
                reflected.iter_mut().zip(row).for_each(|(sum, weight)| *sum += weight * radiance);
            }
        }
        let seen = looked_at(&self.own, scene, suns);
        for ((sum, own), reflected) in sums.iter_mut().zip(&self.of_sensor).zip(reflected) {
            sum[Part::Interreflected as usize] += reflected + linked(&self.own, own, &radiance);
            for entry in &self.own.entries[own.entries.clone()] {
                let [plain, turned] = seen[entry.patch as usize];
                let turns_to = if entry.part == Part::Direct { Part::Redirected } else { entry.part };
                sum[entry.part as usize] += entry.value * plain;
                sum[turns_to as usize] += entry.value * turned;
            }
        }
    }
}

/// Where nodes serve suns anywhere in the sky: the same whatever the seed.
pub fn plan_for_any(
    scene: &Scene,
    turners: &Turners,
    sensors: &Sensors,
    settings: &Settings,
) -> Result<Plan, RoomError> {
    let settings = Settings { seed: 0, ..settings.clone() };
    let before = Rng::new(settings.seed, u64::MAX).bits();
    let (portals, ahead) = (Portals::of(scene), Light::Suns(Suns::new(scene, turners, &planned(), 1, before)?));
    Ok(Plan::new(&walker(scene, &portals, &ahead, &settings), sensors, &[1.0; PLANNED], &settings))
}

/// What the nodes send that a node or sensor is linked to.
fn linked(found: &Found, own: &Own, radiance: &[Vec<f64>]) -> f64 {
    found.links[own.links.clone()]
        .iter()
        .map(|link| link.weight * radiance[link.depth as usize][link.to as usize])
        .sum()
}

/// What is seen of the sun where it was asked for.
fn looked_at(found: &Found, scene: &Scene, suns: &Suns) -> Vec<Shares> {
    let mut hiding = None;
    let look = |asked: &Asked| match asked {
        Asked::Shine(vertex) => suns.shining(scene, vertex, &mut hiding),
        Asked::Glow(looked) => {
            let mut seen = [0.0; 2];
            suns.glowing(scene, looked, 0.0, |_, shares| seen = shares);
            seen
        }
    };
    found.asked.iter().map(look).collect()
}

fn both([plain, turned]: Shares) -> f64 {
    plain + turned
}

/// Directions evenly over the sky: a spiral by the golden angle, equal steps up.
fn planned() -> Vec<Direction> {
    let golden = PI * (3.0 - 5.0_f64.sqrt());
    let place = |k: usize| {
        let (z, angle) = ((k as f64 + 0.5) / PLANNED as f64, k as f64 * golden);
        let (sine, cosine) = angle.sin_cos();
        let across = (1.0 - z * z).sqrt();
        Direction::from_unit(Vec3::new(across * cosine, across * sine, z))
    };
    (0..PLANNED).map(place).collect()
}
