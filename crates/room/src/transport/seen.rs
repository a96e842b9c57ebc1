//! Looking back along beams: from where light is wanted to what turned it last, and from turn to turn to the sun
//! (theory/mirrored_sun.md, eq. 2).

use super::beams::{Beam, FROM_SUN};
use crate::scene::Scene;
use crate::surface::Kind;
use crate::tracer::{Place, Ray};
use hemisphere::{Direction, Vec3};

/// A share of the sun's normal illuminance below which a way is given up.
const LEAST_SHARE: f64 = 1e-6;

/// Turns after which a way is given up.
const MOST_TURNS: u32 = 256;

/// Where light is wanted: a place, and the facet it lies on.
pub struct Wanted<'a> {
    pub place: &'a Place,
    pub facet: u32,
}

/// Illuminance across beams over the sun's normal illuminance: without, and with total internal reflection.
pub type Shares = [f64; 2];

/// The beams of one point of the sun, to be looked back along.
#[derive(Clone, Copy)]
pub struct Sunlight<'a> {
    pub scene: &'a Scene,
    /// Directions of the ways.
    pub ways: &'a [Vec3],
    pub beams: &'a [Beam],
}

impl Sunlight<'_> {
    /// Adds what one of the beams gives a place, times `weight`, which is asked for only if need be.
    #[inline]
    pub fn seen_from(&self, beam: &Beam, wanted: &Wanted<'_>, weight: impl Fn(Vec3) -> f64, sum: &mut Shares) {
        let Self { scene, .. } = *self;
        let from = wanted.place.position;
        let shape = scene.facet(beam.facet);
        let back = shape.height(from) * beam.way_per_height;
        // what lies on a mirror is not lit by it, whatever rounding says
        if back <= 0.0 || beam.facet == wanted.facet {
            return;
        }
        let weight = weight(beam.direction);
        let point = from - back * beam.direction;
        if weight <= 0.0 || !shape.holds(point) {
            return;
        }
        // what was turned may pass clear windows on its way; of unturned light the innermost clear window speaks for all
        let inside = if scene.tracer.visible(wanted.place, &scene.tracer.place_on(beam.facet, point)) {
            1.0
        } else if beam.passes {
            0.0
        } else {
            let looked = Ray { origin: from, direction: -beam.direction, leaving: wanted.facet };
            scene.let_through(looked, Some(beam.facet))
        };
        if inside == 0.0 {
            return;
        }
        if beam.passes {
            let outside = Ray { origin: point, direction: -beam.direction, leaving: beam.facet };
            sum[0] += weight * beam.strength * inside * scene.let_through(outside, None);
        } else {
            let mut found = [0.0; 2];
            let before = Way { way: beam.before, share: beam.strength * inside, redirected: beam.redirected, turns: 1 };
            self.follow(before, point, beam.facet, &mut found);
            sum.iter_mut().zip(found).for_each(|(sum, found)| *sum += weight * found);
        }
    }

    /// Follows a way back from a point of a facet, and adds what comes all along it from the sun.
    fn follow(&self, mut at: Way, point: Vec3, facet: u32, sum: &mut Shares) {
        let Self { scene, ways, beams } = *self;
        let mut ray = Ray { origin: point, direction: -ways[at.way as usize], leaving: facet };
        while at.share > LEAST_SHARE {
            let Some(hit) = scene.tracer.closest(&ray) else {
                if at.way == FROM_SUN {
                    sum[usize::from(at.redirected)] += at.share;
                }
                return;
            };
            let point = ray.origin + hit.distance * ray.direction;
            let turned = |beam: &&Beam| beam.facet == hit.facet && beam.way == at.way && !beam.passes;
            for beam in beams.iter().filter(turned).filter(|_| at.turns < MOST_TURNS) {
                let before = Way {
                    way: beam.before,
                    share: at.share * beam.strength,
                    redirected: at.redirected || beam.redirected,
                    turns: at.turns + 1,
                };
                self.follow(before, point, hit.facet, sum);
            }
            at.share *= scene.straight_share(hit.facet, ray.direction);
            ray = Ray { origin: point, leaving: hit.facet, ..ray };
        }
    }
}

/// A way on its way back to the sun.
#[derive(Clone, Copy)]
struct Way {
    /// Which it is now.
    way: u32,
    /// The share of the sun's normal illuminance it has left.
    share: f64,
    redirected: bool,
    turns: u32,
}

impl Scene {
    /// Whether light from far away, `towards` it, reaches a point of a facet through nothing but clear windows.
    pub(super) fn is_open(&self, facet: u32, point: Vec3, towards: Vec3) -> bool {
        self.let_through(Ray { origin: point, direction: towards, leaving: facet }, None) > 0.0
    }

    /// The share of light that clear windows let through along a ray, up to a facet or to the sky; 0 if anything else is met.
    pub(super) fn let_through(&self, mut ray: Ray, up_to: Option<u32>) -> f64 {
        let mut share = 1.0;
        while let Some(hit) = self.tracer.closest(&ray) {
            if up_to == Some(hit.facet) {
                return share;
            }
            share *= self.straight_share(hit.facet, ray.direction);
            ray = Ray { origin: ray.origin + hit.distance * ray.direction, leaving: hit.facet, ..ray };
            if share == 0.0 {
                return 0.0;
            }
        }
        if up_to.is_none() { share } else { 0.0 }
    }

    /// The share of light that goes straight on through a facet: none but through a clear window.
    fn straight_share(&self, facet: u32, direction: Vec3) -> f64 {
        let Kind::Window { glazing, frame } = &self.surface_of(facet).kind else { return 0.0 };
        let straight = glazing.straight(Direction::from_unit(frame.inward(direction)));
        straight.map_or(0.0, |straight| straight.transmittance)
    }
}
