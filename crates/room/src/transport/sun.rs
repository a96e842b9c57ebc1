//! Illuminance by the sun at many places in turn, without patches: exact beams through every window (theory/room.md, eqs. 12 and 13).

use super::any_sun::plan_for_any;
use super::path::Light;
use super::rounds::{Component, run};
use super::sensors::Sensors;
use super::settings::{Progress, Settings};
use super::suns::Suns;
use super::turners::Turners;
use crate::RoomError;
use crate::scene::Scene;
use hemisphere::{Direction, Vec3};
use std::cell::RefCell;
use std::time::Instant;

/// Illuminance of every sensor by every sun, over the sun's normal illuminance.
#[derive(Clone, Debug)]
pub struct SunCoefficients {
    /// Number of sensors.
    pub sensors: usize,
    /// Number of suns.
    pub suns: usize,
    /// Straight, refracted or spread, without total internal reflection.
    pub direct: Component,
    /// With total internal reflection.
    pub redirected: Component,
    /// After a diffuse reflection.
    pub interreflected: Component,
    /// Light after more reflections than allowed; `None` without a limit.
    pub lost: Option<Vec<f64>>,
    /// For each sun, the summed strength, over its normal illuminance, of the beams that were too weak or too many to be followed on.
    pub cut_off: Vec<f64>,
    /// Rounds done.
    pub rounds: usize,
    /// Whether it was stopped before its end.
    pub interrupted: bool,
    /// Time it took \[s\].
    pub seconds: f64,
}

/// The sun's light on sensors in a scene, for each direction `towards` it; every round draws `disc_samples` points of its disc.
///
/// Beams are followed by way of mirrors and windows, in any order, as far as `cut_off` and [`unfollowed_mirrors`] tell; not through
/// boundaries between media.
///
/// [`unfollowed_mirrors`]: crate::unfollowed_mirrors
pub fn sun_coefficients(
    scene: &Scene,
    points: &[Vec3],
    normals: &[Vec3],
    towards: &[Vec3],
    disc_samples: usize,
    settings: &Settings,
    go_on: impl FnMut(Progress) -> bool,
) -> Result<SunCoefficients, RoomError> {
    let started = Instant::now();
    settings.check()?;
    if !(1..=4096).contains(&disc_samples) {
        let (rule, value) = ("in 1..4096", disc_samples.to_string());
        return Err(RoomError::Setting { name: "disc_samples", rule, value, way_out: "1 does; rounds multiply them" });
    }
    let directions = towards
        .iter()
        .enumerate()
        .map(|(i, &t)| {
            Direction::of(t).ok_or_else(|| RoomError::NoDirection {
                name: format!("sun {i}"),
                what: "the direction",
                value: format!("{:?}", t.to_array()),
            })
        })
        .collect::<Result<Vec<_>, _>>()?;
    if directions.is_empty() {
        let value = "none".to_owned();
        return Err(RoomError::Setting {
            name: "sun_directions",
            rule: "one or more",
            value,
            way_out: "give a direction",
        });
    }
    let sensors = Sensors::new(scene, points, normals)?;
    let weights = vec![1.0; directions.len()];
    let turners = Turners::new(scene, &sensors);
    let cut_off = RefCell::new(vec![0.0; directions.len()]);
    let light = |seed| {
        let suns = Suns::new(scene, &turners, &directions, disc_samples, seed)?;
        cut_off.borrow_mut().iter_mut().zip(&suns.cut_off).for_each(|(most, cut)| *most = f64::max(*most, *cut));
        Ok(Light::Suns(suns))
    };
    let plan = settings.any_sun.then(|| plan_for_any(scene, &turners, &sensors, settings)).transpose()?;
    let found = run(scene, &sensors, settings, &weights, plan, light, go_on)?;
    Ok(SunCoefficients {
        sensors: sensors.len(),
        suns: directions.len(),
        direct: found.direct,
        redirected: found.redirected,
        interreflected: found.interreflected,
        lost: found.lost,
        cut_off: cut_off.into_inner(),
        rounds: found.rounds,
        interrupted: found.interrupted,
        seconds: started.elapsed().as_secs_f64(),
    })
}
