//! The sun's beams in the room: exact directions behind each window, looked back along from wherever light is wanted
//! (theory/room.md, eqs. 12 and 13).

use super::Entry;
use super::path::{Path, Vertex};
use super::walk::Walker;
use crate::RoomError;
use crate::scene::Scene;
use crate::surface::Kind;
use crate::tracer::Ray;
use hemisphere::{Direction, Frame, Rng, Sobol, Vec3};
use optics::Lobes;
use rayon::prelude::*;
use std::f64::consts::{PI, TAU};
use std::ops::Range;

/// Angular diameter of the sun \[rad\]: 0.533°.
const DIAMETER: f64 = 0.533 * PI / 180.0;

/// The most of a window's light that may have no definite direction.
const RESIDUAL: f64 = 1e-3;

/// Suns, each as a few points of its disc, with the beams these send in by every window.
pub struct Suns {
    /// Points of the disc of each sun.
    per_sun: usize,
    /// Sun by sun, point by point.
    points: Vec<Point>,
    beams: Vec<Beam>,
}

/// A point of the sun's disc.
struct Point {
    /// Towards it.
    towards: Vec3,
    /// Its beams indoors.
    beams: Range<u32>,
}

/// One beam behind one window.
struct Beam {
    facet: u32,
    /// Where it travels.
    direction: Vec3,
    /// How far it has come for each metre off the window's plane.
    way_per_height: f64,
    /// Illuminance across it over the sun's normal illuminance: p cos θ_i / cos θ_k.
    strength: f64,
    redirected: bool,
    /// Whether the window turns no light.
    straight: bool,
}

impl Suns {
    /// Draws `per_sun` points of each sun's disc and finds their beams.
    pub fn new(scene: &Scene, towards: &[Direction], per_sun: usize, seed: u64) -> Result<Self, RoomError> {
        let found: Vec<Vec<(Vec3, Vec<Beam>)>> = towards
            .par_iter()
            .enumerate()
            .map(|(sun, &towards)| {
                let sobol = Sobol { seed: Rng::new(seed, sun as u64).bits() };
                let frame = Frame::about(towards);
                (0..per_sun)
                    .map(|index| {
                        let [u, v, ..] = sobol.set(index as u32, 0);
                        let (r, angle) = (u.sqrt() * (0.5 * DIAMETER).sin(), TAU * v);
                        let local = Vec3::new(r * angle.cos(), r * angle.sin(), (1.0 - r * r).sqrt());
                        let point = frame.outward(local);
                        beams_of(scene, point).map(|beams| (point, beams))
                    })
                    .collect()
            })
            .collect::<Result<_, _>>()?;
        let mut suns = Self { per_sun, points: Vec::new(), beams: Vec::new() };
        for (towards, beams) in found.into_iter().flatten() {
            let start = suns.beams.len() as u32;
            suns.beams.extend(beams);
            suns.points.push(Point { towards, beams: start..suns.beams.len() as u32 });
        }
        Ok(suns)
    }

    /// Every sun's number and one point of its disc, the same of all, which `u` picks.
    pub fn directions(&self, u: f64) -> impl Iterator<Item = (u32, Vec3)> + '_ {
        let chosen = (u * self.per_sun as f64) as usize;
        (0_u32..).zip(self.points.chunks_exact(self.per_sun)).map(move |(sun, points)| (sun, points[chosen].towards))
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
                let cos = point.towards.dot(vertex.normal);
                let open = Ray { origin: vertex.place.position, direction: point.towards, leaving: vertex.facet };
                if cos > 0.0 && !hiding.is_some_and(|facet| walker.scene.tracer.meets(&open, facet)) {
                    hiding = walker.scene.tracer.closest(&open).map(|hit| hit.facet);
                    if hiding.is_none() {
                        seen[0] += cos;
                    }
                }
                for beam in &self.beams[point.beams.start as usize..point.beams.end as usize] {
                    seen[usize::from(beam.redirected)] += beam.seen_from(walker.scene, vertex, point.towards);
                }
            }
            for (redirected, value) in [false, true].into_iter().zip(seen).filter(|(_, value)| *value > 0.0) {
                let part = walker.part(bounces, redirected);
                path.out.entries.push(Entry { patch: sun as u32, part, value: each * value });
            }
        }
    }
}

impl Beam {
    /// Illuminance it gives a vertex, over the sun's normal illuminance: looked back along through the window and on to the sun.
    #[inline]
    fn seen_from(&self, scene: &Scene, vertex: &Vertex, towards: Vec3) -> f64 {
        let cos = -self.direction.dot(vertex.normal);
        if cos <= 0.0 {
            return 0.0;
        }
        let shape = scene.facet(self.facet);
        let from = vertex.place.position;
        let back = shape.height(from) * self.way_per_height;
        let point = from - back * self.direction;
        if back <= 0.0 || !shape.holds(point) {
            return 0.0;
        }
        let outside = Ray { origin: point, direction: towards, leaving: self.facet };
        // light turned by one window may pass clear ones on either side; between clear ones the innermost speaks for all
        let inside = if scene.tracer.visible(&vertex.place, &scene.tracer.place_on(self.facet, point)) {
            1.0
        } else if self.straight {
            0.0
        } else {
            let looked = Ray { origin: from, direction: -self.direction, leaving: vertex.facet };
            let_through(scene, looked, Some(self.facet))
        };
        if inside > 0.0 { cos * self.strength * inside * let_through(scene, outside, None) } else { 0.0 }
    }
}

/// The share of light that clear windows let through along a ray, up to a facet or to the sky; 0 if anything else is met.
pub fn let_through(scene: &Scene, mut ray: Ray, up_to: Option<u32>) -> f64 {
    let mut share = 1.0;
    while let Some(hit) = scene.tracer.closest(&ray) {
        if up_to == Some(hit.facet) {
            return share;
        }
        let Kind::Window { glazing, frame } = &scene.surface_of(hit.facet).kind else { return 0.0 };
        let Some(straight) = glazing.straight(Direction::from_unit(frame.inward(ray.direction))) else { return 0.0 };
        share *= straight.transmittance;
        ray = Ray { origin: ray.origin + hit.distance * ray.direction, leaving: hit.facet, ..ray };
        if share == 0.0 {
            return 0.0;
        }
    }
    if up_to.is_none() { share } else { 0.0 }
}

/// The beams that light from one direction sends in by every window, from its front to its back.
fn beams_of(scene: &Scene, towards: Vec3) -> Result<Vec<Beam>, RoomError> {
    let (mut beams, mut lobes) = (Vec::new(), Lobes::default());
    // a sun that has set sends none
    if towards.z <= 0.0 {
        return Ok(beams);
    }
    for surface in &scene.surfaces {
        let Kind::Window { glazing, frame } = &surface.kind else { continue };
        let incident = frame.inward(-towards);
        if incident.z <= 0.0 {
            continue;
        }
        let incident = Direction::from_unit(incident);
        glazing.lobes(incident, &mut lobes);
        let straight = glazing.straight(incident).is_some();
        if lobes.residual > RESIDUAL {
            return Err(RoomError::NoLobes { name: surface.name.clone(), residual: lobes.residual });
        }
        beams.extend(lobes.beams.iter().filter(|lobe| lobe.direction.z > 0.0 && lobe.power > 0.0).map(|lobe| Beam {
            facet: surface.facets.start,
            direction: frame.outward(*lobe.direction),
            way_per_height: 1.0 / lobe.direction.z,
            strength: lobe.power * incident.z / lobe.direction.z,
            redirected: lobe.total_reflections > 0,
            straight,
        }));
    }
    Ok(beams)
}
