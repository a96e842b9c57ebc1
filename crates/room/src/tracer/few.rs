//! A scene of at most 64 facets: every plane at once, a bit for each facet.

use super::{Hit, Place, Ray};
use crate::facet::Facet;
use hemisphere::Vec3;

/// As many facets as a word has bits.
pub const MOST: usize = 64;

/// Planes side by side, so that a few instructions treat several.
pub struct Few {
    nx: [f64; MOST],
    ny: [f64; MOST],
    nz: [f64; MOST],
    offset: [f64; MOST],
    /// Facets rounded up to whole instructions.
    padded: usize,
    /// Which facets have a part behind, and in front of, each one's plane: none else can be met on leaving it.
    reach: Vec<[u64; 2]>,
    /// On which side of every plane each facet lies as a whole; `None` if a plane cuts it.
    whole: Vec<Option<(u64, u64)>>,
    all: u64,
}

/// Planes treated by one turn of the loops.
const LANES: usize = 4;

impl Few {
    pub fn new(facets: &[Facet], least: f64) -> Self {
        let mut few = Self {
            nx: [0.0; MOST],
            ny: [0.0; MOST],
            nz: [0.0; MOST],
            offset: [0.0; MOST],
            padded: facets.len().div_ceil(LANES) * LANES,
            reach: Vec::new(),
            whole: Vec::new(),
            all: if facets.len() == MOST { u64::MAX } else { (1 << facets.len()) - 1 },
        };
        for (k, f) in facets.iter().enumerate() {
            (few.nx[k], few.ny[k], few.nz[k], few.offset[k]) = (f.normal.x, f.normal.y, f.normal.z, f.offset);
            let beyond = |sign: f64| {
                facets.iter().enumerate().fold(0, |bits, (j, other)| {
                    let part = j != k && other.corners().into_iter().any(|c| sign * f.height(c) > least);
                    bits | (u64::from(part) << j)
                })
            };
            few.reach.push([beyond(-1.0), beyond(1.0)]);
        }
        few.whole = (0..facets.len())
            .map(|k| {
                // facets with a part behind and in front of the plane of each facet j, seen from facet k
                let part =
                    |side: usize| (0..facets.len()).fold(0, |bits, j| bits | (((few.reach[j][side] >> k) & 1) << j));
                let (behind, in_front) = (part(0), part(1));
                (behind & in_front == 0).then_some((in_front, few.all & !(behind | in_front)))
            })
            .collect();
        few
    }

    #[inline]
    pub fn closest(&self, facets: &[Facet], ray: &Ray, least: f64) -> Option<Hit> {
        match self.padded {
            0..=8 => self.closest_of::<8>(facets, ray, least),
            9..=16 => self.closest_of::<16>(facets, ray, least),
            _ => self.closest_of::<MOST>(facets, ray, least),
        }
    }

    /// The same with room for `N` distances, for clearing more than needed takes time too.
    #[inline]
    fn closest_of<const N: usize>(&self, facets: &[Facet], ray: &Ray, least: f64) -> Option<Hit> {
        let Ray { origin: o, direction: d, leaving } = *ray;
        let mut candidates = match self.reach.get(leaving as usize) {
            Some(sides) => sides[usize::from(d.dot(facets[leaving as usize].normal) > 0.0)],
            None => self.all,
        };
        if candidates == 0 {
            return None;
        }
        let mut distance = [0.0; N];
        for (turn, lanes) in distance[..self.padded].chunks_exact_mut(LANES).enumerate() {
            for (lane, t) in lanes.iter_mut().enumerate() {
                let k = LANES * turn + lane;
                let height = self.nx[k] * o.x + self.ny[k] * o.y + self.nz[k] * o.z - self.offset[k];
                let speed = self.nx[k] * d.x + self.ny[k] * d.y + self.nz[k] * d.z;
                *t = -height / speed;
            }
        }
        // in a convex room the nearest plane ahead is the one that is met
        loop {
            let (mut nearest, mut facet) = (f64::INFINITY, MOST);
            let mut rest = candidates;
            while rest != 0 {
                let k = rest.trailing_zeros() as usize;
                rest &= rest - 1;
                // a ray along a plane has no finite distance and fails both tests
                if distance[k] > least && distance[k] < nearest {
                    (nearest, facet) = (distance[k], k);
                }
            }
            if facet == MOST {
                return None;
            }
            if facets[facet].holds(o + nearest * d) {
                return Some(Hit { distance: nearest, facet: facet as u32 });
            }
            candidates &= !(1 << facet);
        }
    }

    #[inline]
    pub fn place_on(&self, facet: u32, p: Vec3, least: f64) -> Place {
        match self.whole[facet as usize] {
            Some((sides, within)) => Place { position: p, sides, within },
            None => self.place(p, least),
        }
    }

    #[inline]
    pub fn place(&self, p: Vec3, least: f64) -> Place {
        let (mut sides, mut within) = (0, 0);
        for first in (0..self.padded).step_by(LANES) {
            let mut height = [0.0; LANES];
            for (lane, h) in height.iter_mut().enumerate() {
                let k = first + lane;
                *h = self.nx[k] * p.x + self.ny[k] * p.y + self.nz[k] * p.z - self.offset[k];
            }
            for (lane, h) in height.iter().enumerate() {
                sides |= u64::from(*h > 0.0) << (first + lane);
                within |= u64::from(h.abs() <= least) << (first + lane);
            }
        }
        Place { position: p, sides, within }
    }
}

/// Whether none of the facets in `between`, whose planes part the points, holds the crossing.
pub fn clear(facets: &[Facet], a: Vec3, b: Vec3, mut between: u64) -> bool {
    while between != 0 {
        let k = between.trailing_zeros() as usize;
        between &= between - 1;
        let (ha, hb) = (facets[k].height(a), facets[k].height(b));
        if facets[k].holds(a + ha / (ha - hb) * (b - a)) {
            return false;
        }
    }
    true
}
