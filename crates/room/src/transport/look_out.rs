//! Looking out through the windows: by points drawn on them, and by directions drawn in each patch of the sky
//! (theory/room.md, eqs. 5 and 6).

use super::path::{Asked, Came, Light, Path, State, Techniques, Vertex};
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

    /// Points per m² by window points and directions together.
    fn density(&self, walker: &Walker<'_>, techniques: &Techniques<'_>) -> f64 {
        let by_point =
            f64::from(techniques.window_points) * walker.portals.density(walker.scene, self.facet, self.from);
        by_point + techniques.directions * self.by_direction(walker)
    }

    /// What one point found by either counts for in the mean radiance (balance heuristic).
    pub fn weight(&self, walker: &Walker<'_>, techniques: &Techniques<'_>) -> f64 {
        self.by_direction(walker) / self.density(walker, techniques)
    }

    /// The part of the light that directions by the cosine law are left with. A window that is `straight`, turns no light, shows the
    /// sky to a sensor patch by patch: to nothing else.
    pub fn share_of_directions(&self, walker: &Walker<'_>, techniques: &Techniques<'_>, straight: bool) -> f64 {
        if self.is_by_patch(techniques, straight) {
            0.0
        } else {
            techniques.directions * self.weight(walker, techniques)
        }
    }

    /// Whether this is left to the directions drawn in the patches of the sky.
    fn is_by_patch(&self, techniques: &Techniques<'_>, straight: bool) -> bool {
        straight && techniques.per_sr > 0.0 && self.direction.z >= 0.0
    }
}

impl Walker<'_> {
    /// Light arriving at a vertex through points drawn on the windows, or from the suns; `beta` counts the mean radiance.
    pub fn look_out(&self, vertex: &Vertex, beta: f64, techniques: &Techniques<'_>, bounces: u32, path: &mut Path<'_>) {
        match self.light {
            Light::Sky(_) => {}
            Light::Suns(suns) => {
                suns.shine_on(self, vertex, beta, bounces, path);
                self.shine_spread(vertex, beta, techniques, bounces, path);
                return;
            }
            Light::AnySun => {
                // as many random numbers as suns take: the paths are the same
                path.numbers.rng.uniform();
                path.out.ask(Asked::Shine(*vertex), self.part(bounces, false), beta / PI);
                self.shine_spread(vertex, beta, techniques, bounces, path);
                return;
            }
        }
        let spread = path.numbers.window();
        for index in 0..techniques.window_points {
            let Some(Drawn { surface, facet, point }) = self.portals.draw(self.scene, |d| spread.coordinate(index, d))
            else {
                return;
            };
            let way = point - vertex.place.position;
            let distance = way.length();
            let direction = way / distance;
            let sight =
                Sight { facet, from: vertex.place.position, direction, distance, cos: direction.dot(vertex.normal) };
            self.look(vertex, &sight, surface, beta, techniques, bounces, None, path);
        }
    }

    /// Light arriving at a sensor along directions drawn evenly in every patch of the sky, through windows that turn no light.
    pub fn look_at_patches(&self, vertex: &Vertex, beta: f64, techniques: &Techniques<'_>, path: &mut Path<'_>) {
        let Light::Sky(sky) = self.light else { return };
        if techniques.per_sr == 0.0 {
            return;
        }
        let from = vertex.place.position;
        for (surface, facet) in self.portals.straight() {
            let Some(seen) = self.portals.seen(self.scene, facet, from) else { continue };
            let shape = self.scene.facet(facet);
            let height = shape.height(from);
            for patch in sky.touched(seen.axis, seen.half_angle) {
                let sobol = Sobol { seed: path.numbers.rng.bits() };
                let each = 1.0 / (PI * sky.density(patch, techniques.per_sr));
                for index in 0..sky.directions(patch, techniques.per_sr) {
                    let u = sobol.point(index, 0);
                    let direction = sky.basis.sample(patch, [u.coordinate(0), u.coordinate(1)]);
                    let distance = -height / shape.normal.dot(direction);
                    if distance > 0.0 && shape.holds(from + distance * direction) {
                        let cos = direction.dot(vertex.normal);
                        let sight = Sight { facet, from, direction, distance, cos };
                        self.look(vertex, &sight, surface, beta, techniques, 0, Some(cos * each), path);
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
        by_patch: Option<f64>,
        path: &mut Path<'_>,
    ) {
        let Sight { facet, from, direction, distance, cos } = *sight;
        if cos <= 0.0 || direction.dot(self.scene.facet(facet).normal) >= 0.0 {
            return;
        }
        let Kind::Window { glazing, frame } = &self.scene.surfaces[surface as usize].kind else { return };
        let incident = Direction::from_unit(frame.inward(direction));
        let straight = glazing.straight(incident);
        if by_patch.is_none() && sight.is_by_patch(techniques, straight.is_some()) {
            return;
        }
        let point = from + distance * direction;
        if !self.scene.tracer.visible(&vertex.place, &self.scene.tracer.place_on(facet, point)) {
            return;
        }
        let weight = by_patch.unwrap_or_else(|| sight.weight(self, techniques));
        let leaving = |outgoing: Vec3, beta, total_reflections: u16| State {
            ray: Ray { origin: point, direction: outgoing, leaving: facet },
            beta,
            came: Came::Specular,
            bounces,
            redirected: total_reflections > 0,
            medium: Medium::AIR,
            // what the window turns back sees the room once more
            looks_out: outgoing.dot(self.scene.facet(facet).normal) > 0.0,
        };
        let (transmitted, turned) = match straight {
            Some(straight) => {
                let is_mirrored = techniques.of_sensor && path.numbers.rng.uniform() < straight.reflectance;
                let mirrored = is_mirrored.then(|| direction - 2.0 * direction.dot(frame.z) * frame.z);
                (Some(leaving(direction, beta * weight * straight.transmittance, 0)), mirrored.map(|d| (d, 0)))
            }
            None => {
                let u = [path.numbers.rng.uniform(), path.numbers.rng.uniform(), path.numbers.rng.uniform()];
                match glazing.scatter(incident, u) {
                    // what turns back into the room only a sensor follows; a reflection leaves it to its drawn direction
                    Scattered::Leaves { direction, total_reflections } if direction.z < 0.0 || techniques.of_sensor => {
                        (None, Some((frame.outward(*direction), total_reflections)))
                    }
                    _ => (None, None),
                }
            }
        };
        let turned = turned.map(|(outgoing, total_reflections)| leaving(outgoing, beta * weight, total_reflections));
        for state in [transmitted, turned].into_iter().flatten().filter(|state| state.beta > 0.0) {
            self.follow(state, &mut path.branch());
        }
    }
}
