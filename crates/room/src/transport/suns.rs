//! The sun's beams in the room: exact directions behind each window, looked back along from wherever light is wanted
//! (theory/room.md, eqs. 12 and 13).

use super::Entry;
use super::beams::{Beam, Beams};
use super::path::{Path, Vertex};
use super::seen::{Shares, Sunlight, Wanted};
use super::turners::Turners;
use super::walk::Walker;
use crate::RoomError;
use crate::scene::Scene;
use crate::tracer::Ray;
use hemisphere::{Direction, Frame, Rng, Sobol, Vec3};
use rayon::prelude::*;
use std::f64::consts::{PI, TAU};
use std::ops::Range;

/// Angular diameter of the sun \[rad\]: 0.533°.
const DIAMETER: f64 = 0.533 * PI / 180.0;

/// Suns, each as a few points of its disc, with the beams these send in by every window.
pub struct Suns {
    /// Points of the disc of each sun.
    per_sun: usize,
    /// Sun by sun, point by point.
    points: Vec<Point>,
    /// Of all points, one after another.
    ways: Vec<Vec3>,
    beams: Vec<Beam>,
    /// Summed strength of the beams of each sun that were not followed on: the most of its points.
    pub cut_off: Vec<f64>,
}

/// A point of the sun's disc.
struct Point {
    /// Towards it.
    towards: Vec3,
    ways: Range<u32>,
    /// Its beams; so many of the first may light something.
    beams: Range<u32>,
    lighting: u32,
}

impl Suns {
    /// Draws `per_sun` points of each sun's disc and finds their beams.
    pub fn new(
        scene: &Scene,
        turners: &Turners,
        towards: &[Direction],
        per_sun: usize,
        seed: u64,
    ) -> Result<Self, RoomError> {
        let points = |(sun, &towards): (usize, &Direction)| points_of(scene, turners, sun, towards, per_sun, seed);
        Ok(Self::put_together(per_sun, towards.par_iter().enumerate().map(points).collect::<Result<_, _>>()?))
    }

    /// One point of one sun, as the first of several would be.
    pub fn one(scene: &Scene, turners: &Turners, towards: Direction, seed: u64) -> Result<Self, RoomError> {
        Ok(Self::put_together(1, vec![points_of(scene, turners, 0, towards, 1, seed)?]))
    }

    fn put_together(per_sun: usize, found: Vec<Vec<(Vec3, Beams)>>) -> Self {
        let mut suns = Self { per_sun, points: Vec::new(), ways: Vec::new(), beams: Vec::new(), cut_off: Vec::new() };
        for of_sun in found {
            suns.cut_off.push(of_sun.iter().map(|(_, beams)| beams.cut_off).fold(0.0, f64::max));
            for (towards, Beams { ways, beams, lighting, .. }) in of_sun {
                let (first_way, first_beam) = (suns.ways.len() as u32, suns.beams.len() as u32);
                suns.ways.extend(ways);
                suns.beams.extend(beams);
                suns.points.push(Point {
                    towards,
                    ways: first_way..suns.ways.len() as u32,
                    beams: first_beam..suns.beams.len() as u32,
                    lighting: lighting as u32,
                });
            }
        }
        suns
    }

    /// The beams of a point of the sun, and how many of the first may light something.
    fn sunlight<'a>(&'a self, scene: &'a Scene, point: &Point) -> (Sunlight<'a>, &'a [Beam]) {
        let range = |range: &Range<u32>| range.start as usize..range.end as usize;
        let beams = &self.beams[range(&point.beams)];
        (Sunlight { scene, ways: &self.ways[range(&point.ways)], beams }, &beams[..point.lighting as usize])
    }

    /// The sun's light on a place, for every sun up: its number and the sum over the directions that it comes from, each times
    /// `weight`. `u` picks the point of the disc, the same of all.
    pub fn shares_at(
        &self,
        scene: &Scene,
        wanted: &Wanted<'_>,
        u: f64,
        weight: impl Fn(Vec3) -> f64,
    ) -> impl Iterator<Item = (u32, Shares)> {
        let chosen = (u * self.per_sun as f64) as usize;
        let points = (0_u32..).zip(self.points.chunks_exact(self.per_sun).map(move |points| &points[chosen]));
        points.filter(|(_, point)| point.towards.z > 0.0).map(move |(sun, point)| {
            let mut seen = [0.0; 2];
            let straight = weight(-point.towards);
            if straight > 0.0 {
                let ray = Ray { origin: wanted.place.position, direction: point.towards, leaving: wanted.facet };
                seen[0] += straight * scene.let_through(ray, None);
            }
            let (sunlight, lighting) = self.sunlight(scene, point);
            for beam in lighting.iter().filter(|beam| !beam.passes) {
                sunlight.seen_from(beam, wanted, &weight, &mut seen);
            }
            (sun, seen)
        })
    }

    /// The sun's light on a vertex, for every sun. A sensor takes all points of the disc, a reflection one, by chance.
    pub fn shine_on(&self, walker: &Walker<'_>, vertex: &Vertex, beta: f64, bounces: u32, path: &mut Path<'_>) {
        let chosen = (path.numbers.rng.uniform() * self.per_sun as f64) as usize;
        // what hid one sun mostly hides the next
        let mut hiding = None;
        for (sun, points) in self.points.chunks_exact(self.per_sun).enumerate() {
            let points = if bounces == 0 { points } else { &points[chosen..=chosen] };
            // beta counts the mean radiance, E/π
            let each = beta / (PI * points.len() as f64);
            // without and with total reflection
            let mut seen = [0.0; 2];
            for point in points.iter().filter(|point| point.towards.z > 0.0) {
                self.shine(walker.scene, vertex, point, &mut hiding, &mut seen);
            }
            for (redirected, value) in [false, true].into_iter().zip(seen).filter(|(_, value)| *value > 0.0) {
                let part = walker.part(bounces, redirected);
                path.out.entries.push(Entry { patch: sun as u32, part, value: each * value });
            }
        }
    }

    /// The light of suns of one point on a vertex that was reached before they were known, over their normal illuminance. What hid one
    /// from the last vertex, which mostly hides it from the next, is kept in `hiding`.
    pub fn shining(&self, scene: &Scene, vertex: &Vertex, hiding: &mut Option<u32>) -> Shares {
        let mut seen = [0.0; 2];
        for point in self.points.iter().filter(|point| point.towards.z > 0.0) {
            self.shine(scene, vertex, point, hiding, &mut seen);
        }
        seen
    }

    /// Adds what one point of a sun gives a vertex.
    #[inline]
    fn shine(&self, scene: &Scene, vertex: &Vertex, point: &Point, hiding: &mut Option<u32>, seen: &mut Shares) {
        let cos = point.towards.dot(vertex.normal);
        let open = Ray { origin: vertex.place.position, direction: point.towards, leaving: vertex.facet };
        if cos > 0.0 && !hiding.is_some_and(|facet| scene.tracer.meets(&open, facet)) {
            *hiding = scene.tracer.closest(&open).map(|hit| hit.facet);
            if hiding.is_none() {
                seen[0] += cos;
            }
        }
        let (sunlight, lighting) = self.sunlight(scene, point);
        let wanted = Wanted { place: &vertex.place, facet: vertex.facet };
        let cosine = |direction: Vec3| -direction.dot(vertex.normal);
        for beam in lighting {
            sunlight.seen_from(beam, &wanted, cosine, seen);
        }
    }
}

/// Draws the points of a sun's disc, with their beams; `sun` is its number.
fn points_of(
    scene: &Scene,
    turners: &Turners,
    sun: usize,
    towards: Direction,
    per_sun: usize,
    seed: u64,
) -> Result<Vec<(Vec3, Beams)>, RoomError> {
    let sobol = Sobol { seed: Rng::new(seed, sun as u64).bits() };
    let frame = Frame::about(towards);
    let point = |index: usize| {
        let [u, v, ..] = sobol.set(index as u32, 0);
        let (r, angle) = (u.sqrt() * (0.5 * DIAMETER).sin(), TAU * v);
        let local = Vec3::new(r * angle.cos(), r * angle.sin(), (1.0 - r * r).sqrt());
        let point = frame.outward(local);
        Beams::of(scene, turners, point).map(|beams| (point, beams))
    };
    (0..per_sun).map(point).collect()
}
