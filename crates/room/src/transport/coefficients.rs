//! Daylight coefficients of the sky's patches and the ground.

use super::path::Light;
use super::rounds::{Component, run};
use super::sensors::Sensors;
use super::settings::{Progress, Settings};
use super::sky::Sky;
use crate::RoomError;
use crate::scene::Scene;
use hemisphere::{SkyBasis, Vec3};
use std::time::Instant;

/// Daylight coefficients of every sensor and patch.
#[derive(Clone, Debug)]
pub struct DaylightCoefficients {
    /// Number of sensors.
    pub sensors: usize,
    /// Number of patches, the ground included.
    pub patches: usize,
    /// Specular paths without total internal reflection.
    pub direct: Component,
    /// Specular paths with total internal reflection.
    pub redirected: Component,
    /// Paths with a diffuse reflection.
    pub interreflected: Component,
    /// Light after more reflections than allowed; `None` without a limit.
    pub lost: Option<Vec<f64>>,
    /// Σ coefficient · weight of each sensor, the three parts together.
    pub weighted: Component,
    /// Rounds done.
    pub rounds: usize,
    /// Whether the target was met; true without one.
    pub converged: bool,
    /// Whether it was stopped before its end.
    pub interrupted: bool,
    /// Time it took \[s\].
    pub seconds: f64,
}

/// The coefficients of sensors in a scene. `go_on` is asked after every round and may stop the work; what is there is kept.
pub fn daylight_coefficients(
    scene: &Scene,
    points: &[Vec3],
    normals: &[Vec3],
    basis: &SkyBasis,
    settings: &Settings,
    go_on: impl FnMut(Progress) -> bool,
) -> Result<DaylightCoefficients, RoomError> {
    let started = Instant::now();
    settings.check()?;
    let weights = weights(settings, basis)?;
    let sensors = Sensors::new(scene, points, normals)?;
    let sky = Sky::new(basis);
    let found = run(scene, &sensors, settings, &weights, None, |_| Ok(Light::Sky(&sky)), go_on)?;
    Ok(DaylightCoefficients {
        sensors: sensors.len(),
        patches: basis.patches(),
        direct: found.direct,
        redirected: found.redirected,
        interreflected: found.interreflected,
        lost: found.lost,
        weighted: found.weighted,
        rounds: found.rounds,
        converged: found.converged,
        interrupted: found.interrupted,
        seconds: started.elapsed().as_secs_f64(),
    })
}

fn weights(settings: &Settings, basis: &SkyBasis) -> Result<Vec<f64>, RoomError> {
    let wrong = |name, rule, value: String, way_out| Err(RoomError::Setting { name, rule, value, way_out });
    let weights = settings.weights.clone().unwrap_or_else(|| basis.overcast(0.2));
    if weights.len() != basis.patches() {
        let value = format!("{} values", weights.len());
        return wrong("weights", "one luminance for every patch and the ground", value, "take the basis' own patches");
    }
    if let Some(value) = weights.iter().find(|w| !(w.is_finite() && **w >= 0.0)) {
        return wrong("weights", "finite and not negative", value.to_string(), "give luminances");
    }
    Ok(weights)
}
