//! A scene of many facets: a tree of boxes, eight to a node, with four triangles side by side in each leaf.
//!
//! Boxes and triangles are single precision, widened by their rounding, about the scene's middle and in shares of its radius: they
//! only say what a ray may meet. What it does meet, and where, is found in double precision by the facets themselves.

use super::eight::{LEAF, LEAF_SIZE, Tree};
use super::quad::SLACK;
use super::{Hit, NO_FACET, Ray};
use crate::facet::{Facet, RIM};
use glam::{Vec3A, Vec4};
use hemisphere::Vec3;
use prefetch_index::prefetch_index;

/// The tree.
pub struct Many {
    tree: Tree,
    /// Every lane of every leaf in double precision.
    exact: Vec<Exact>,
    /// The scene's middle.
    centre: Vec3,
    /// Half the diagonal of the box around it \[m\].
    radius: f64,
}

/// A triangle as little of it as a ray needs.
struct Exact {
    corner: Vec3,
    edges: [Vec3; 2],
    facet: u32,
    /// Whether it is all of its facet; of a polygon it is a piece.
    whole: bool,
}

impl Exact {
    /// How far along a ray it is met (T. Möller, B. Trumbore, JGT 2(1), 1997), if it is.
    #[inline(always)]
    fn distance(&self, facets: &[Facet], ray: &Ray) -> Option<f64> {
        if !self.whole {
            let facet = &facets[self.facet as usize];
            let t = -facet.height(ray.origin) / facet.normal.dot(ray.direction);
            return facet.holds(ray.origin + t * ray.direction).then_some(t);
        }
        let [a, b] = self.edges;
        let normal = a.cross(b);
        let from_corner = ray.origin - self.corner;
        let moment = from_corner.cross(ray.direction);
        let per_speed = -1.0 / normal.dot(ray.direction);
        let (s, t) = (moment.dot(b) * per_speed, -moment.dot(a) * per_speed);
        (s >= -RIM && t >= -RIM && s + t <= 1.0 + RIM).then(|| from_corner.dot(normal) * per_speed)
    }
}

/// Boxes to come back to, in most trees.
const WAITING: usize = 32;

/// A ray as boxes and triangles know it.
struct Single {
    origin: [Vec4; 3],
    direction: [Vec4; 3],
    inverse: [Vec4; 3],
    /// The planes of a node through which the ray enters and leaves, axis by axis.
    near: [usize; 3],
    far: [usize; 3],
    /// How far along the ray its single-precision origin is \[m\].
    start: f64,
}

/// More boxes had to wait than there was room for.
struct NoRoom;

impl Many {
    pub fn new(facets: &[Facet]) -> Self {
        let (low, high) = facets
            .iter()
            .flat_map(Facet::corners)
            .fold((Vec3::INFINITY, Vec3::NEG_INFINITY), |(low, high), c| (low.min(c), high.max(c)));
        let (centre, radius) = (0.5 * (low + high), 0.5 * (high - low).length());
        let pieces: Vec<([Vec3; 3], u32)> =
            (0..).zip(facets).flat_map(|(k, f)| f.triangles().into_iter().map(move |corners| (corners, k))).collect();
        let single: Vec<[Vec3A; 3]> =
            pieces.iter().map(|(corners, _)| corners.map(|c| ((c - centre) / radius).as_vec3a())).collect();
        let tree = Tree::new(&single, SLACK);
        let exact = tree.order.iter().map(|&k| {
            let ([o, a, b], facet) = pieces[k as usize];
            let whole = facets[facet as usize].triangle_measures().is_some();
            Exact { corner: o, edges: [a - o, b - o], facet, whole }
        });
        Self { exact: exact.collect(), tree, centre, radius }
    }

    pub fn closest(&self, facets: &[Facet], ray: &Ray, least: f64) -> Option<Hit> {
        let single = self.single(ray.origin, ray.direction);
        let mut best = Hit { distance: f64::INFINITY, facet: NO_FACET };
        self.walk(&single, f64::INFINITY, |leaf, mut may| {
            while may != 0 {
                let exact = &self.exact[LEAF_SIZE * leaf + may.trailing_zeros() as usize];
                may &= may - 1;
                let Some(t) = exact.distance(facets, ray) else { continue };
                // of facets that lie in one another the first, whatever the order of the tree
                let nearer = t < best.distance || (t == best.distance && exact.facet < best.facet);
                if t > least && nearer && exact.facet != ray.leaving {
                    best = Hit { distance: t, facet: exact.facet };
                }
            }
            best.distance
        });
        (best.facet != NO_FACET).then_some(best)
    }

    pub fn visible(&self, facets: &[Facet], a: Vec3, b: Vec3, least: f64) -> bool {
        let way = (b - a).length();
        let single = self.single(a, (b - a) / way);
        let mut clear = true;
        self.walk(&single, way, |leaf, mut may| {
            while may != 0 {
                let facet = &facets[self.exact[LEAF_SIZE * leaf + may.trailing_zeros() as usize].facet as usize];
                may &= may - 1;
                let (ha, hb) = (facet.height(a), facet.height(b));
                // the points lie on either side of it, and neither in it
                let parted = ha * hb < 0.0 && ha.abs() > least && hb.abs() > least;
                if parted && facet.holds(a + ha / (ha - hb) * (b - a)) {
                    clear = false;
                    return f64::NEG_INFINITY;
                }
            }
            way
        });
        clear
    }

    fn single(&self, origin: Vec3, direction: Vec3) -> Single {
        let from_centre = origin - self.centre;
        // a ray from far away begins near the scene, lest its rounding be that of the distance
        let away = from_centre.length();
        let start = if away > 2.0 * self.radius { away - 1.5 * self.radius } else { 0.0 };
        let origin = ((from_centre + start * direction) / self.radius).as_vec3a();
        let direction = direction.as_vec3a();
        // no quotient of 0 and 0 in a box's plane
        let inverse = direction.to_array().map(|d| 1.0 / if d.abs() < 1e-20 { 1e-20_f32.copysign(d) } else { d });
        let enters = |axis: usize, backwards: bool| if backwards { 3 + axis } else { axis };
        Single {
            origin: origin.to_array().map(Vec4::splat),
            direction: direction.to_array().map(Vec4::splat),
            inverse: inverse.map(Vec4::splat),
            near: std::array::from_fn(|axis| enters(axis, inverse[axis] < 0.0)),
            far: std::array::from_fn(|axis| enters(axis, inverse[axis] >= 0.0)),
            start,
        }
    }

    /// Shows every leaf with triangles that the ray may meet within `reach` \[m\], nearer boxes first; the visit says how far to look on.
    #[inline(always)]
    fn walk(&self, ray: &Single, reach: f64, mut visit: impl FnMut(usize, u32) -> f64) {
        if self.walk_with(&mut [(0, 0.0); WAITING], ray, reach, &mut visit).is_err() {
            // once more with room for any; what was found is found again
            self.walk_deep(ray, reach, &mut visit);
        }
    }

    #[cold]
    #[inline(never)]
    fn walk_deep(&self, ray: &Single, reach: f64, visit: &mut dyn FnMut(usize, u32) -> f64) {
        let mut waiting = vec![(0, 0.0); 8 * (self.tree.depth + 1)];
        let enough = self.walk_with(&mut waiting, ray, reach, visit);
        debug_assert!(enough.is_ok());
    }

    #[inline(always)]
    fn walk_with(
        &self,
        waiting: &mut [(u32, f32)],
        ray: &Single,
        reach: f64,
        mut visit: impl FnMut(usize, u32) -> f64,
    ) -> Result<(), NoRoom> {
        let rounded = |reach: f64| ((reach - ray.start) / self.radius) as f32 * (1.0 + SLACK) + SLACK;
        let mut reach = rounded(reach);
        let (mut at, mut count) = (0, 0);
        loop {
            if at & LEAF != 0 {
                let leaf = (at & !LEAF) as usize;
                // most leaves that are reached are met: what that takes may as well be on its way
                for lane in 0..LEAF_SIZE {
                    prefetch_index(&self.exact, LEAF_SIZE * leaf + lane);
                }
                let may = self.tree.leaves[leaf].may_meet(ray.origin, ray.direction);
                if may != 0 {
                    reach = rounded(visit(leaf, may));
                }
            } else {
                let node = &self.tree.nodes[at as usize];
                let (mut hit, entry) = node.entries(ray, reach);
                if hit != 0 {
                    if count + 8 > waiting.len() {
                        return Err(NoRoom);
                    }
                    let first = count;
                    while hit != 0 {
                        let k = hit.trailing_zeros() as usize & 7;
                        hit &= hit - 1;
                        // the nearest last, where it is taken from
                        let mut place = count;
                        while place > first && waiting[place - 1].1 < entry[k] {
                            waiting[place] = waiting[place - 1];
                            place -= 1;
                        }
                        waiting[place] = (node.children[k], entry[k]);
                        count += 1;
                    }
                    count -= 1;
                    at = waiting[count].0;
                    continue;
                }
            }
            // the next box that begins within reach
            loop {
                if count == 0 {
                    return Ok(());
                }
                count -= 1;
                if waiting[count].1 <= reach {
                    at = waiting[count].0;
                    break;
                }
            }
        }
    }
}

impl super::eight::Node {
    /// A bit for each box that a ray is in within reach, and how far along the ray it enters each.
    #[inline(always)]
    fn entries(&self, ray: &Single, reach: f32) -> (u32, [f32; 8]) {
        let mut hit = 0;
        let mut entry = [0.0; 8];
        for half in 0..2 {
            let along = |plane: usize, axis: usize| (self.planes[plane][half] - ray.origin[axis]) * ray.inverse[axis];
            let [x, y, z] = std::array::from_fn(|axis| along(ray.near[axis], axis));
            let enters = x.max(y).max(z.max(Vec4::ZERO));
            let [x, y, z] = std::array::from_fn(|axis| along(ray.far[axis], axis));
            let leaves = x.min(y).min(z.min(Vec4::splat(reach)));
            hit |= enters.cmple(leaves).bitmask() << (4 * half);
            entry[4 * half..4 * half + 4].copy_from_slice(&enters.to_array());
        }
        (hit, entry)
    }
}
