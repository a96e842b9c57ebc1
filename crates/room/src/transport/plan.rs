//! Where nodes go, and what each sensor does by itself.

use super::nodes::NodePlan;
use super::path::Light;
use super::pilot::pilot;
use super::sensors::Sensors;
use super::settings::Settings;
use super::walk::Walker;
use hemisphere::Rng;

/// The plan of all rounds.
pub struct Plan {
    pub nodes: NodePlan,
    pub own: Vec<Own>,
}

/// How much work one sensor does by itself in a round.
#[derive(Clone, Copy, Debug)]
pub struct Own {
    /// Window points.
    pub window_points: u32,
    /// Directions per steradian drawn in each patch of the sky, for windows that turn no light.
    pub per_sr: f64,
    /// Directions over the hemisphere.
    pub directions: u32,
}

/// Directions a sensor draws where only they explore, under suns: one for as many nodes.
const SUNS_NODES_PER_DIRECTION: usize = 8;

/// Points that a sensor draws on windows that spread the suns' light.
const SPREAD_POINTS: u32 = 64;

/// A sensor's own directions, where nodes do as well: one for as many nodes …
const NODES_PER_DIRECTION: usize = 64;

/// … but few sensors draw more, all together as many as there are nodes to so many of them.
const NODES_PER_SHARED_DIRECTION: usize = 2;

/// A window smaller than this share of a mean patch is looked for by points alone.
const PATCHES_SEEN: f64 = 0.1;

/// Where patches are looked for one by one, points on the windows serve the ground alone: one for so many directions.
const DIRECTIONS_PER_GROUND_POINT: u32 = 4;

impl Plan {
    /// What a few rays tell to be best. `weights` are the luminances that errors are judged under.
    pub fn new(walker: &Walker<'_>, sensors: &Sensors, weights: &[f64], settings: &Settings) -> Self {
        let pilot = pilot(walker, sensors, weights, Rng::new(settings.seed, u64::MAX).bits());
        let shared = settings.nodes.div_ceil(NODES_PER_SHARED_DIRECTION * sensors.len());
        let least = settings.nodes.div_ceil(NODES_PER_DIRECTION).max(shared) as u32;
        let own = |(i, alone): (usize, &f64)| {
            let (window_points, per_sr, exploring) = match walker.light {
                Light::Sky(_) => {
                    let (points, per_sr) = looks(walker, sensors, i, settings.window_samples as u32);
                    (points, per_sr, settings.window_samples)
                }
                // every reflection costs a look at all suns: go by the nodes
                Light::Suns(_) | Light::AnySun => {
                    let points = if walker.portals.spreads() { SPREAD_POINTS } else { 0 };
                    (points, 0.0, settings.nodes / SUNS_NODES_PER_DIRECTION)
                }
            };
            Own { window_points, per_sr, directions: least.max((alone * exploring as f64).ceil() as u32) }
        };
        let own = pilot.alone.iter().enumerate().map(own).collect();
        Self { nodes: NodePlan::new(&pilot.near, &pilot.far, settings.nodes), own }
    }
}

/// Points on the windows, and directions per steradian in the patches behind those that turn no light: about `samples` of either.
fn looks(walker: &Walker<'_>, sensors: &Sensors, i: usize, samples: u32) -> (u32, f64) {
    let Light::Sky(sky) = walker.light else { return (samples, 0.0) };
    let seen = walker
        .portals
        .straight()
        .filter_map(|(_, facet)| walker.portals.seen(walker.scene, facet, sensors.position(i)));
    let solid_angle: f64 = seen.map(|seen| seen.solid_angle).sum();
    let patch = std::f64::consts::TAU / sky.patches() as f64;
    if solid_angle < PATCHES_SEEN * patch {
        return (samples, 0.0);
    }
    let points = if walker.portals.all_straight() { samples.div_ceil(DIRECTIONS_PER_GROUND_POINT) } else { samples };
    (points, f64::from(samples) / solid_angle)
}
