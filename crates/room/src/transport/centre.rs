//! The published method's direct part: one ray from the sensor at each sector's centre, refracted, and the sector it really reaches.

use super::sensors::Sensors;
use crate::RoomError;
use crate::scene::Scene;
use crate::surface::Kind;
use crate::tracer::{NO_FACET, Ray};
use hemisphere::{Direction, SkyBasis, Vec3};
use optics::Lobes;
use rayon::prelude::*;

/// Direct and redirected coefficients by sector centres, sensor by sensor, patch by patch \[sr\].
#[derive(Clone, Debug)]
pub struct CentreCoefficients {
    /// Number of patches, the ground included.
    pub patches: usize,
    /// Without total internal reflection.
    pub direct: Vec<f64>,
    /// With it.
    pub redirected: Vec<f64>,
}

/// Casts one ray at the centre of each sector above the horizon. What it carries is the sector's solid angle times the cosine at the
/// sensor, shared out over the ways the window leaves open to it.
pub fn centre_coefficients(
    scene: &Scene,
    points: &[Vec3],
    normals: &[Vec3],
    basis: &SkyBasis,
) -> Result<CentreCoefficients, RoomError> {
    let sensors = Sensors::new(scene, points, normals)?;
    let rows: Vec<[Vec<f64>; 2]> = (0..sensors.len())
        .into_par_iter()
        .map(|i| {
            let mut row = [vec![0.0; basis.patches()], vec![0.0; basis.patches()]];
            for patch in 0..basis.ground() {
                let direction = basis.centre(patch);
                let projected = basis.solid_angle(patch) * direction.dot(sensors.normal(i));
                if projected > 0.0 {
                    cast(scene, basis, sensors.position(i), direction, projected, &mut row);
                }
            }
            row
        })
        .collect();
    let part = |k: usize| rows.iter().flat_map(|row| row[k].iter().copied()).collect();
    Ok(CentreCoefficients { patches: basis.patches(), direct: part(0), redirected: part(1) })
}

fn cast(scene: &Scene, basis: &SkyBasis, origin: Vec3, direction: Vec3, projected: f64, row: &mut [Vec<f64>; 2]) {
    let Some(hit) = scene.tracer.closest(&Ray { origin, direction, leaving: NO_FACET }) else {
        row[0][basis.find(direction)] += projected;
        return;
    };
    let Kind::Window { glazing, frame } = &scene.surface_of(hit.facet).kind else { return };
    let incident = frame.inward(direction);
    let mut lobes = Lobes::default();
    glazing.lobes(Direction::from_unit(incident), &mut lobes);
    let through = lobes.beams.iter().filter(|lobe| lobe.direction.z * incident.z > 0.0);
    for lobe in through {
        let leaves = frame.outward(*lobe.direction);
        let ray = Ray { origin: origin + hit.distance * direction, direction: leaves, leaving: hit.facet };
        if scene.tracer.closest(&ray).is_none() {
            row[usize::from(lobe.total_reflections > 0)][basis.find(leaves)] += projected * lobe.power;
        }
    }
}
