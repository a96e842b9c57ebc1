//! A scene of many facets: a thin wall around the `obvhs` hierarchy of boxes.
//!
//! Boxes are single precision, widened by their rounding; facets are met in double precision.

use super::{Hit, NO_FACET, Ray};
use crate::facet::{Facet, RIM};
use glam::Vec3A;
use hemisphere::Vec3;
use obvhs::cwbvh::{CwBvh, builder::build_cwbvh};
use obvhs::ray::RayHit;
use obvhs::{BvhBuildParams, aabb::Aabb};
use std::time::Duration;

/// The hierarchy.
pub struct Many {
    boxes: CwBvh,
    /// The facets as the hierarchy orders them.
    leaves: Vec<Leaf>,
}

/// A facet, as little of it as a ray needs.
struct Leaf {
    normal: Vec3,
    offset: f64,
    /// What measures a point along two edges of a triangle; of no use for a polygon.
    along: [(Vec3, f64); 2],
    facet: u32,
    is_triangle: bool,
}

impl Leaf {
    fn of(facets: &[Facet], facet: u32) -> Self {
        let shape = &facets[facet as usize];
        let measures = shape.triangle_measures();
        Self {
            normal: shape.normal,
            offset: shape.offset,
            along: measures.unwrap_or([(Vec3::ZERO, 0.0); 2]),
            facet,
            is_triangle: measures.is_some(),
        }
    }

    #[inline]
    fn height(&self, p: Vec3) -> f64 {
        self.normal.dot(p) - self.offset
    }

    #[inline]
    fn holds(&self, facets: &[Facet], p: Vec3) -> bool {
        if self.is_triangle {
            let [s, t] = self.along.map(|(dual, start)| dual.dot(p) - start);
            s >= -RIM && t >= -RIM && s + t <= 1.0 + RIM
        } else {
            facets[self.facet as usize].holds(p)
        }
    }
}

/// The hierarchy skips boxes that end within 1e-4 of a ray's origin, in whatever unit: rays begin as far behind theirs, twice over.
const BEHIND: f64 = 2e-4;

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
        let boxes = build_cwbvh(&boxes, BvhBuildParams::medium_build(), &mut Duration::default());
        let leaves = boxes.primitive_indices.iter().map(|&facet| Leaf::of(facets, facet)).collect();
        Self { boxes, leaves }
    }

    pub fn closest(&self, facets: &[Facet], ray: &Ray, least: f64) -> Option<Hit> {
        let mut best: Option<Hit> = None;
        let mut nearest = f64::INFINITY;
        self.boxes.ray_traverse(single(ray.origin, ray.direction, f64::INFINITY), &mut RayHit::none(), |_, slot| {
            let leaf = &self.leaves[slot];
            if leaf.facet != ray.leaving {
                let t = -leaf.height(ray.origin) / leaf.normal.dot(ray.direction);
                if t > least && t < nearest && leaf.holds(facets, ray.origin + t * ray.direction) {
                    nearest = t;
                    best = Some(Hit { distance: t, facet: leaf.facet });
                    // boxes beyond are dropped; those that begin within rounding of here are not
                    return (t + BEHIND) as f32 * (1.0 + WIDENED);
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
            let leaf = &self.leaves[slot];
            let (ha, hb) = (leaf.height(a), leaf.height(b));
            // the points lie on either side of it, and neither in it
            let parted = ha * hb < 0.0 && ha.abs() > least && hb.abs() > least;
            let stands_between = parted && leaf.holds(facets, a + ha / (ha - hb) * (b - a));
            if stands_between { 0.0 } else { f32::INFINITY }
        })
    }
}

fn single(origin: Vec3, direction: Vec3, way: f64) -> obvhs::ray::Ray {
    let start = origin - BEHIND * direction;
    obvhs::ray::Ray::new(start.as_vec3a(), direction.as_vec3a(), 0.0, (way + BEHIND) as f32)
}

// a ray of no facet must not be taken for one of the last facet a word can number
const _: () = assert!(NO_FACET == u32::MAX);
