//! Looking out through the windows: by points drawn on them, and by directions drawn in each patch of the sky
//! (theory/room.md, eqs. 5 and 6).

use super::path::{Came, Light, Path, State, Techniques, Vertex};
use super::portals::Drawn;
use super::walk::Walker;
use crate::surface::{Kind, Medium};
use crate::tracer::Ray;
use hemisphere::{Direction, Sobol, Vec3};
use optics::Scattered;
use std::f64::consts::PI;

/// A point of a window as seen from a vertex.
pub struct Sight {
    /// The window's facet.
    pub facet: u32,
    /// Where it is seen from.
    pub from: Vec3,
    /// Along which direction.
    pub direction: Vec3,
    /// How far away.
    pub distance: f64,
    /// Cosine at the vertex.
    pub cos: f64,
}

impl Sight {
    /// Points per m² of the window that one direction by the cosine law stands for.
    fn by_direction(&self, walker: &Walker<'_>) -> f64 {
        self.cos * self.per_sr(walker) / PI
    }

    /// Square metres of window per steradian, inverted.
    fn per_sr(&self, walker: &Walker<'_>) -> f64 {
        let cos_there = self.direction.dot(walker.scene.facet(self.facet).normal).abs();
        cos_there / (self.distance * self.distance)
    }

    /// Points per m² by all techniques together; `patches` directions are drawn in each patch if the window turns no light.
    fn density(&self, walker: &Walker<'_>, techniques: &Techniques<'_>, patches: u32) -> f64 {
        let by_point =
            f64::from(techniques.window_points) * walker.portals.density(walker.scene, self.facet, self.from);
        let by_patch = match walker.light {
            Light::Sky(basis) if patches > 0 && self.direction.z >= 0.0 => {
                f64::from(patches) / basis.solid_angle(basis.find(self.direction)) * self.per_sr(walker)
            }
            _ => 0.0,
        };
        by_point + by_patch + techniques.directions * self.by_direction(walker)
    }

    /// What one point found by any technique counts for in the mean radiance (balance heuristic).
    fn weight(&self, walker: &Walker<'_>, techniques: &Techniques<'_>, patches: u32) -> f64 {
        self.by_direction(walker) / self.density(walker, techniques, patches)
    }

    /// The part of the light that directions by the cosine law are left with.
    pub fn share_of_directions(&self, walker: &Walker<'_>, techniques: &Techniques<'_>, patches: u32) -> f64 {
        techniques.directions * self.weight(walker, techniques, patches)
    }
}

impl Walker<'_> {
    /// Light arriving at a vertex through points drawn on the windows, or from the suns; `beta` counts the mean radiance.
    pub fn look_out(&self, vertex: &Vertex, beta: f64, techniques: &Techniques<'_>, bounces: u32, path: &mut Path<'_>) {
        if let Light::Suns(suns) = self.light {
            suns.shine_on(self, vertex, beta, bounces, path);
            return;
        }
        let sobol = Sobol { seed: path.numbers.rng.bits() };
        for index in 0..techniques.window_points {
            let Some(Drawn { surface, facet, point }) = self.portals.draw(self.scene, &sobol.point(index, 0)) else {
                return;
            };
            let way = point - vertex.place.position;
            let distance = way.length();
            let direction = way / distance;
            let sight =
                Sight { facet, from: vertex.place.position, direction, distance, cos: direction.dot(vertex.normal) };
            self.look(vertex, &sight, surface, beta, techniques, bounces, path);
        }
    }

    /// Light arriving at a sensor along directions drawn evenly in every patch of the sky, through windows that turn no light.
    pub fn look_at_patches(&self, vertex: &Vertex, beta: f64, techniques: &Techniques<'_>, path: &mut Path<'_>) {
        let Light::Sky(basis) = self.light else { return };
        if techniques.patch_directions == 0 || self.portals.is_empty() {
            return;
        }
        for patch in 0..basis.ground() {
            let sobol = Sobol { seed: path.numbers.rng.bits() };
            for index in 0..techniques.patch_directions {
                let u = sobol.point(index, 0);
                let direction = basis.sample(patch, [u.coordinate(0), u.coordinate(1)]);
                let cos = direction.dot(vertex.normal);
                if cos <= 0.0 {
                    continue;
                }
                for (surface, facet) in self.portals.windows() {
                    let shape = self.scene.facet(facet);
                    let distance = -shape.height(vertex.place.position) / shape.normal.dot(direction);
                    if distance > 0.0 && shape.holds(vertex.place.position + distance * direction) {
                        let sight = Sight { facet, from: vertex.place.position, direction, distance, cos };
                        if matches!(&self.scene.surfaces[surface as usize].kind, Kind::Window { glazing, frame }
                            if glazing.straight(Direction::from_unit(frame.inward(direction))).is_some())
                        {
                            self.look(vertex, &sight, surface, beta, techniques, 0, path);
                        }
                    }
                }
            }
        }
    }

    #[allow(clippy::too_many_arguments)]
    fn look(
        &self,
        vertex: &Vertex,
        sight: &Sight,
        surface: u32,
        beta: f64,
        techniques: &Techniques<'_>,
        bounces: u32,
        path: &mut Path<'_>,
    ) {
        let Sight { facet, from, direction, distance, cos } = *sight;
        if cos <= 0.0 || direction.dot(self.scene.facet(facet).normal) >= 0.0 {
            return;
        }
        let point = from + distance * direction;
        if !self.scene.tracer.visible(&vertex.place, &self.scene.tracer.place_on(facet, point)) {
            return;
        }
        let Kind::Window { glazing, frame } = &self.scene.surfaces[surface as usize].kind else { return };
        let incident = Direction::from_unit(frame.inward(direction));
        let (outgoing, weight, total_reflections) = match glazing.straight(incident) {
            Some(straight) => {
                let weight = sight.weight(self, techniques, techniques.patch_directions);
                (direction, weight * straight.transmittance, 0)
            }
            None => {
                let u = [path.numbers.rng.uniform(), path.numbers.rng.uniform(), path.numbers.rng.uniform()];
                match glazing.scatter(incident, u) {
                    // what turns back into the room is left to the drawn directions
                    Scattered::Leaves { direction, total_reflections } if direction.z < 0.0 => {
                        (frame.outward(*direction), sight.weight(self, techniques, 0), total_reflections)
                    }
                    _ => return,
                }
            }
        };
        let beta = beta * weight;
        if beta > 0.0 {
            let state = State {
                ray: Ray { origin: point, direction: outgoing, leaving: facet },
                beta,
                came: Came::Specular,
                bounces,
                redirected: total_reflections > 0,
                medium: Medium::AIR,
                looks_out: false,
            };
            self.follow(state, &mut path.branch());
        }
    }
}
