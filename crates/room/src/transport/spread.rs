//! The suns' light that a window spreads over its room, seen from points on it (theory/room.md, eq. 14).

use super::Entry;
use super::look_out::Sight;
use super::path::{Path, Techniques, Vertex};
use super::portals::Drawn;
use super::suns::{Suns, let_through};
use super::walk::Walker;
use crate::surface::Kind;
use crate::tracer::Ray;
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

impl Suns {
    /// Light that a vertex gets from points drawn on the windows that spread it; `beta` counts the mean radiance.
    pub fn shine_spread(
        &self,
        walker: &Walker<'_>,
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
            let drawn = walker.portals.draw(walker.scene, |d| spread.coordinate(index, d));
            let Some(Drawn { facet, point, .. }) = drawn else { return };
            let way = point - from;
            let distance = way.length();
            let direction = way / distance;
            let cos = direction.dot(vertex.normal);
            let in_room = direction.dot(walker.scene.facet(facet).normal) < 0.0;
            if cos > 0.0
                && in_room
                && walker.scene.tracer.visible(&vertex.place, &walker.scene.tracer.place_on(facet, point))
            {
                let weight = Sight { facet, from, direction, distance, cos }.weight(walker, techniques);
                let looked = Looked { facet, point, direction, bounces, redirected: false };
                self.glow(walker, &looked, beta * weight, path);
            }
        }
    }

    /// The radiance of a window's point under every sun, as far as it spreads light: f cos θ of the sun's normal illuminance;
    /// `beta` counts it.
    pub fn glow(&self, walker: &Walker<'_>, looked: &Looked, beta: f64, path: &mut Path<'_>) {
        let Kind::Window { glazing, frame } = &walker.scene.surface_of(looked.facet).kind else { return };
        if !glazing.spreads() || beta == 0.0 {
            return;
        }
        let outgoing = Direction::from_unit(frame.inward(-looked.direction));
        let part = walker.part(looked.bounces, looked.redirected);
        for (sun, towards) in self.directions(path.numbers.rng.uniform()) {
            let incident = Direction::from_unit(frame.inward(-towards));
            let value = beta * incident.z.abs() * glazing.bsdf(incident, outgoing);
            let ray = Ray { origin: looked.point, direction: towards, leaving: looked.facet };
            if towards.z > 0.0 && value > 0.0 {
                let value = value * let_through(walker.scene, ray, None);
                path.out.entries.push(Entry { patch: sun, part, value });
            }
        }
    }
}
