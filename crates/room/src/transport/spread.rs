//! The suns' light that a window spreads over its room, seen from points on it (theory/room.md, eq. 14).

use super::Entry;
use super::look_out::Sight;
use super::path::{Asked, Light, Path, Techniques, Vertex};
use super::portals::Drawn;
use super::seen::{Shares, Wanted};
use super::suns::Suns;
use super::walk::Walker;
use crate::scene::Scene;
use crate::surface::Kind;
use hemisphere::{Direction, Vec3};

/// A point of a window, looked at.
pub struct Looked {
    /// The window's facet.
    pub facet: u32,
    /// Where.
    pub point: Vec3,
    /// Along which direction.
    pub direction: Vec3,
    /// Diffuse reflections on the way to it.
    pub bounces: u32,
    /// Whether there was a total reflection on the way.
    pub redirected: bool,
}

impl Walker<'_> {
    /// Light that a vertex gets from points drawn on the windows that spread it; `beta` counts the mean radiance.
    pub fn shine_spread(
        &self,
        vertex: &Vertex,
        beta: f64,
        techniques: &Techniques<'_>,
        bounces: u32,
        path: &mut Path<'_>,
    ) {
        if techniques.window_points == 0 {
            return;
        }
        let from = vertex.place.position;
        let spread = path.numbers.window();
        for index in 0..techniques.window_points {
            let drawn = self.portals.draw(self.scene, |d| spread.coordinate(index, d));
            let Some(Drawn { facet, point, .. }) = drawn else { return };
            let way = point - from;
            let distance = way.length();
            let direction = way / distance;
            let cos = direction.dot(vertex.normal);
            let in_room = direction.dot(self.scene.facet(facet).normal) < 0.0;
            if cos > 0.0
                && in_room
                && self.scene.tracer.visible(&vertex.place, &self.scene.tracer.place_on(facet, point))
            {
                let weight = Sight { facet, from, direction, distance, cos }.weight(self, techniques);
                let looked = Looked { facet, point, direction, bounces, redirected: false };
                self.glow(looked, beta * weight, path);
            }
        }
    }

    /// The suns' light that a window's point spreads, at once or later; `beta` counts its radiance.
    pub fn glow(&self, looked: Looked, beta: f64, path: &mut Path<'_>) {
        if beta == 0.0 || !looked.spreads(self.scene) {
            return;
        }
        match self.light {
            Light::Sky(_) => {}
            Light::Suns(suns) => suns.glow(self, &looked, beta, path),
            Light::AnySun => {
                path.numbers.rng.uniform();
                let part = self.part(looked.bounces, looked.redirected);
                path.out.ask(Asked::Glow(looked), part, beta);
            }
        }
    }
}

impl Looked {
    fn spreads(&self, scene: &Scene) -> bool {
        matches!(&scene.surface_of(self.facet).kind, Kind::Window { glazing, .. } if glazing.spreads())
    }
}

impl Suns {
    /// The radiance of a window's point under every sun, as far as it spreads light: f cos θ of the sun's normal illuminance;
    /// `beta` counts it.
    fn glow(&self, walker: &Walker<'_>, looked: &Looked, beta: f64, path: &mut Path<'_>) {
        let u = path.numbers.rng.uniform();
        self.glowing(walker.scene, looked, u, |sun, shares| {
            for (redirected, value) in [false, true].into_iter().zip(shares).filter(|(_, value)| *value > 0.0) {
                let part = walker.part(looked.bounces, looked.redirected || redirected);
                path.out.entries.push(Entry { patch: sun, part, value: beta * value });
            }
        });
    }

    /// Tells that radiance for every sun up, with its number; `u` picks the point of the disc, the same of all.
    pub fn glowing(&self, scene: &Scene, looked: &Looked, u: f64, mut tell: impl FnMut(u32, Shares)) {
        let Kind::Window { glazing, frame } = &scene.surface_of(looked.facet).kind else { return };
        let outgoing = Direction::from_unit(frame.inward(-looked.direction));
        let cos_bsdf = |direction: Vec3| {
            let incident = Direction::from_unit(frame.inward(direction));
            incident.z.abs() * glazing.bsdf(incident, outgoing)
        };
        let place = scene.tracer.place_on(looked.facet, looked.point);
        let wanted = Wanted { place: &place, facet: looked.facet };
        self.shares_at(scene, &wanted, u, cos_bsdf).for_each(|(sun, shares)| tell(sun, shares));
    }
}
