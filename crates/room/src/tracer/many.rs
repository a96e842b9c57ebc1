//! A scene of many facets: a thin wall around the `obvhs` hierarchy of boxes.
//!
//! Boxes are single precision, widened by their rounding; facets are met in double precision.

use super::{Hit, NO_FACET, Ray};
use crate::facet::Facet;
use glam::Vec3A;
use hemisphere::Vec3;
use obvhs::cwbvh::{CwBvh, builder::build_cwbvh};
use obvhs::ray::RayHit;
use obvhs::{BvhBuildParams, aabb::Aabb};
use std::time::Duration;

/// The hierarchy.
pub struct Many {
    boxes: CwBvh,
}

/// Single precision of a coordinate, a few times over.
const WIDENED: f32 = 4.0 * f32::EPSILON;

impl Many {
    pub fn new(facets: &[Facet]) -> Self {
        let corners: Vec<Vec<Vec3A>> =
            facets.iter().map(|f| f.corners().iter().map(|c| c.as_vec3a()).collect()).collect();
        let size = corners.iter().flatten().fold(0.0_f32, |m, c| m.max(c.abs().max_element()));
        let boxes: Vec<Aabb> = corners
            .iter()
            .map(|corners| {
                let tight = Aabb::from_points(corners);
                let margin = Vec3A::splat(WIDENED * size);
                Aabb::new(tight.min - margin, tight.max + margin)
            })
            .collect();
        Self { boxes: build_cwbvh(&boxes, BvhBuildParams::medium_build(), &mut Duration::default()) }
    }

    pub fn closest(&self, facets: &[Facet], ray: &Ray, least: f64) -> Option<Hit> {
        let mut best: Option<Hit> = None;
        let mut nearest = f64::INFINITY;
        self.boxes.ray_traverse(single(ray.origin, ray.direction, f64::INFINITY), &mut RayHit::none(), |_, slot| {
            let k = self.boxes.primitive_indices[slot];
            if k != ray.leaving {
                let t = meet(&facets[k as usize], ray.origin, ray.direction);
                if t > least && t < nearest && facets[k as usize].holds(ray.origin + t * ray.direction) {
                    nearest = t;
                    best = Some(Hit { distance: t, facet: k });
                    // boxes beyond are dropped; those that begin within rounding of here are not
                    return t as f32 * (1.0 + WIDENED);
                }
            }
            f32::INFINITY
        });
        best
    }

    pub fn visible(&self, facets: &[Facet], a: Vec3, b: Vec3, least: f64) -> bool {
        let way = (b - a).length();
        let direction = (b - a) / way;
        self.boxes.ray_traverse_miss(single(a, direction, way), |_, slot| {
            let f = &facets[self.boxes.primitive_indices[slot] as usize];
            let (ha, hb) = (f.height(a), f.height(b));
            // the points lie on either side of it, and neither in it
            let parted = ha * hb < 0.0 && ha.abs() > least && hb.abs() > least;
            let stands_between = parted && f.holds(a + ha / (ha - hb) * (b - a));
            if stands_between { 0.0 } else { f32::INFINITY }
        })
    }
}

fn meet(facet: &Facet, origin: Vec3, direction: Vec3) -> f64 {
    -facet.height(origin) / facet.normal.dot(direction)
}

fn single(origin: Vec3, direction: Vec3, way: f64) -> obvhs::ray::Ray {
    obvhs::ray::Ray::new(origin.as_vec3a(), direction.as_vec3a(), 0.0, way as f32)
}

// a ray of no facet must not be taken for one of the last facet a word can number
const _: () = assert!(NO_FACET == u32::MAX);
