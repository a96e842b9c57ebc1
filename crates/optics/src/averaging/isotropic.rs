//! Tensor trees of rank 3, for elements that are the same turned about their normal.

use super::{Averaging, Way};
use crate::{Glazing, Lobe, Lobes, OpticsError, Side, TreeWriter};
use hemisphere::{Direction, Vec3, disk_to_square};
use std::f64::consts::PI;

/// Places along the radius of a cell, before it is halved as often as others are quartered.
const PLACES_OF_RADIUS: usize = 3;

/// A lobe's directions in the plane of incidence are shared by the cells on either side of it.
const BESIDE: f64 = 1e-9;

/// The four blocks of an element that is the same turned about its normal as preorder walks of rank 3, 2^`depth` cells along each
/// coordinate: transmission front and back, reflection front and back (theory/bsdf_averaging.md, eq. 4).
pub fn isotropic_trees(
    glazing: &dyn Glazing,
    depth: u32,
    how: &Averaging,
    merged: f64,
) -> Result<[Vec<f64>; 4], OpticsError> {
    is_isotropic(glazing)?;
    let order = [
        (Side::Front, Way::Transmission),
        (Side::Back, Way::Transmission),
        (Side::Front, Way::Reflection),
        (Side::Back, Way::Reflection),
    ];
    Ok(order.map(|(side, way)| one(glazing, side, way, depth, how, merged)))
}

fn one(glazing: &dyn Glazing, side: Side, way: Way, depth: u32, how: &Averaging, merged: f64) -> Vec<f64> {
    let cells = 1_usize << depth;
    let z = if side == Side::Front { 1.0 } else { -1.0 };
    let leaves = if way == Way::Transmission { z } else { -z };
    let mut writer = TreeWriter::new(3, depth);
    let mut lobes = Lobes::default();
    let size = PI / (cells * cells) as f64;
    let places = PLACES_OF_RADIUS << how.levels;
    // incident radii fill the half of the first coordinate below ½
    for i in 0..cells / 2 {
        let radius = |c: usize| 1.0 - 2.0 * c as f64 / cells as f64;
        let (high, low) = (radius(i).powi(2), radius(i + 1).max(0.0).powi(2));
        let mut sums = std::collections::BTreeMap::<usize, f64>::new();
        for k in 0..places {
            // even in r², which is projected solid angle
            let r = (low + (high - low) * (k as f64 + 0.5) / places as f64).sqrt();
            let Some(incident) = Direction::of(Vec3::new(r, 0.0, z * (1.0 - r * r).max(1e-18).sqrt())) else {
                continue;
            };
            glazing.lobes(incident, &mut lobes);
            let scale = 1.0 / (places as f64 * (1.0 - lobes.residual));
            for Lobe { direction: d, power, .. } in lobes.beams.iter().filter(|l| l.direction.z * leaves > 0.0) {
                for beside in [BESIDE, -BESIDE] {
                    let place = disk_to_square(d.x, d.y + beside);
                    let [u, v] = place.map(|p| ((p * cells as f64) as usize).min(cells - 1));
                    *sums.entry(v * cells + u).or_default() += 0.5 * power * scale;
                }
            }
        }
        for (cell, share) in sums {
            writer.set(&[i, cell % cells, cell / cells], share / size);
        }
    }
    writer.preorder(merged)
}

/// Refuses an element whose beams do not turn with the light.
fn is_isotropic(glazing: &dyn Glazing) -> Result<(), OpticsError> {
    let (mut lobes, mut turned) = (Lobes::default(), Lobes::default());
    if !super::has_lobes(glazing) {
        return Err(OpticsError::NotIsotropic);
    }
    for (r, side) in [0.2, 0.55, 0.9].into_iter().flat_map(|r: f64| [(r, 1.0), (r, -1.0)]) {
        let z = side * (1.0 - r * r).sqrt();
        glazing.lobes(Direction::from_unit(Vec3::new(r, 0.0, z)), &mut lobes);
        for azimuth in [0.7_f64, 1.57, 3.0, 4.4] {
            let (sine, cosine) = azimuth.sin_cos();
            glazing.lobes(Direction::from_unit(Vec3::new(r * cosine, r * sine, z)), &mut turned);
            let found = lobes.beams.iter().filter(|l| l.power > 1e-4).all(|l| {
                let d = l.direction;
                let want = Vec3::new(cosine * d.x - sine * d.y, sine * d.x + cosine * d.y, d.z);
                let same = |t: &&Lobe| (t.direction.vector() - want).length() < 1e-6;
                turned.beams.iter().find(same).is_some_and(|t| (t.power - l.power).abs() < 1e-4)
            });
            if !found {
                return Err(OpticsError::NotIsotropic);
            }
        }
    }
    Ok(())
}
