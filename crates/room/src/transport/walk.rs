//! One path, followed from where its light is wanted until it ends in the sky or is absorbed (theory/room.md, eqs. 3–9).

use super::nodes::Layer;
use super::numbers::Event;
use super::path::{Came, Light, Path, State, Techniques, Vertex};
use super::portals::Portals;
use super::through::Met;
use super::{Entry, Part};
use crate::scene::Scene;
use crate::surface::{Kind, Medium};
use crate::tracer::Ray;
use hemisphere::{Direction, Frame, Vec3};
use optics::{Interface, Split};
use std::f64::consts::PI;

/// Follows paths in a scene.
pub struct Walker<'a> {
    pub scene: &'a Scene,
    pub portals: &'a Portals,
    /// Where light comes from.
    pub light: &'a Light<'a>,
    /// Shared nodes; those of layer b send their light to vertices of b reflections.
    pub layers: &'a [Layer],
    /// Light that took more diffuse reflections is reported as lost.
    pub max_bounces: Option<u32>,
}

/// Window points drawn at a diffuse reflection.
const WINDOW_POINTS: u32 = 3;

/// Meetings with surfaces after which roulette ends even paths that lose nothing: between white walls, in a block of glass.
const PATIENCE: u32 = 512;

/// Probability with which such a path goes on, its light then counting the more.
const GOES_ON: f64 = 0.98;

/// A ray of which the share s is kept is followed with probability 8 s: its light is then of even weight, and little.
const FOLLOWED: f64 = 8.0;

impl Walker<'_> {
    /// The light that a diffuse vertex of this reflectance sends on: from windows it sees, from nodes, and from a reflection.
    /// `bounces` counts its own; `index` is its own among nodes.
    pub fn reflected(
        &self,
        vertex: &Vertex,
        reflectance: f64,
        index: Option<u32>,
        bounces: u32,
        event: &Event,
        path: &mut Path<'_>,
    ) {
        let techniques = self.look_about(vertex, reflectance, index, bounces, path);
        // roulette by the reflectance itself keeps beta as it is
        if event.choice() < reflectance {
            self.scattered(vertex, 1.0, techniques, bounces, event.direction(), path);
        }
    }

    /// The light that a diffuse vertex gets from windows and from nodes, times `beta`; what directions drawn there compete with.
    fn look_about(
        &self,
        vertex: &Vertex,
        beta: f64,
        index: Option<u32>,
        bounces: u32,
        path: &mut Path<'_>,
    ) -> Techniques<'_> {
        let layer = self.layers.get(bounces as usize).filter(|layer| layer.is_linked());
        let techniques = Techniques { nodes: layer.map(|layer| &layer.density), ..self.reflection() };
        self.look_out(vertex, beta, &techniques, bounces, path);
        if let Some(layer) = layer {
            let index = index.unwrap_or_else(|| path.numbers.rng.bits() as u32);
            layer.link(self, bounces, vertex, index, beta, &mut path.out.links);
        }
        techniques
    }

    /// Light arriving at a vertex along one direction drawn by the cosine law; `beta` counts the mean radiance.
    pub fn scattered(
        &self,
        vertex: &Vertex,
        beta: f64,
        techniques: Techniques<'_>,
        bounces: u32,
        u: [f64; 2],
        path: &mut Path<'_>,
    ) {
        let local = cosine_direction(u);
        let direction = Frame::about(Direction::from_unit(vertex.normal)).outward(local);
        let state = State {
            ray: Ray { origin: vertex.place.position, direction, leaving: vertex.facet },
            beta,
            came: Came::Scattered { cos: local.z, techniques },
            bounces,
            redirected: false,
            medium: Medium::AIR,
            looks_out: true,
        };
        self.follow(state, path);
    }

    /// Follows a path to its end.
    pub fn follow<'b>(&'b self, mut state: State<'b>, path: &mut Path<'_>) {
        let scene = self.scene;
        for meeting in 0_u32.. {
            if meeting > PATIENCE {
                if path.numbers.rng.uniform() >= GOES_ON {
                    return;
                }
                state.beta /= GOES_ON;
            }
            let Ray { origin, direction, .. } = state.ray;
            let Some(hit) = scene.tracer.closest(&state.ray) else {
                // suns are looked for where light is reflected, not met by chance
                if let Light::Sky(sky) = self.light {
                    let patch = sky.basis.find(direction) as u32;
                    let part = self.part(state.bounces, state.redirected);
                    path.out.entries.push(Entry { patch, part, value: state.beta });
                }
                return;
            };
            let point = origin + hit.distance * direction;
            let facet = scene.facet(hit.facet);
            let cos_facet = facet.normal.dot(direction);
            state.beta *= state.medium.left_after(hit.distance);
            let event = path.numbers.event();
            match &scene.surface_of(hit.facet).kind {
                Kind::Opaque(material) => {
                    let normal = if cos_facet < 0.0 { facet.normal } else { -facet.normal };
                    let choice = event.choice();
                    if material.diffuse > 0.0 {
                        let kept = state.came.kept_at_node(scene, hit.facet, point, cos_facet, hit.distance);
                        // what the nodes find as well is seldom worth following
                        let followed = (FOLLOWED * kept).min(1.0);
                        if kept >= 1.0 || path.numbers.rng.uniform() < followed {
                            let kept_beta = state.beta * kept / followed;
                            let vertex =
                                Vertex { place: scene.tracer.place_on(hit.facet, point), normal, facet: hit.facet };
                            state.bounces += 1;
                            let techniques = if state.looks_out {
                                let beta = kept_beta * material.diffuse;
                                Some(self.look_about(&vertex, beta, None, state.bounces, path))
                            } else {
                                None
                            };
                            if choice < material.diffuse {
                                let local = cosine_direction(event.direction());
                                let direction = Frame::about(Direction::from_unit(normal)).outward(local);
                                state.ray = Ray { origin: point, direction, leaving: hit.facet };
                                state.came = match techniques {
                                    Some(techniques) => Came::Scattered { cos: local.z, techniques },
                                    None => Came::Specular,
                                };
                                state.beta = kept_beta;
                                continue;
                            }
                            state.bounces -= 1;
                        }
                    }
                    if !(material.diffuse..material.diffuse + material.specular).contains(&choice) {
                        return;
                    }
                    let mirrored = direction - 2.0 * cos_facet * facet.normal;
                    state.ray = Ray { origin: point, direction: mirrored, leaving: hit.facet };
                    state.came = Came::Specular;
                }
                Kind::Window { glazing, frame } => {
                    let met = Met { facet: hit.facet, point, distance: hit.distance };
                    if !self.meet_window(&mut state, &met, &**glazing, frame, &event, path) {
                        return;
                    }
                }
                Kind::Interface { front, back } => {
                    let (here, beyond) = if cos_facet < 0.0 { (*front, *back) } else { (*back, *front) };
                    let normal = if cos_facet < 0.0 { facet.normal } else { -facet.normal };
                    // the first boundary met tells what the ray came through
                    if state.medium != here {
                        state.beta *= here.left_after(hit.distance) / state.medium.left_after(hit.distance);
                    }
                    let interface = Interface { n_i: here.n, n_t: beyond.n };
                    let reflectance = match interface.split(cos_facet.abs().min(1.0)) {
                        Split::Total { .. } => {
                            state.redirected = true;
                            1.0
                        }
                        Split::Partial { amplitude_s: s, amplitude_p: p, .. } => 0.5 * (s * s + p * p),
                    };
                    let through = if event.start()[0] < reflectance {
                        None
                    } else {
                        optics::refract(direction, normal, interface)
                    };
                    (state.ray.direction, state.medium) = match through {
                        Some(refracted) => (refracted.normalize(), beyond),
                        None => (optics::mirror(direction, normal), here),
                    };
                    (state.ray.origin, state.ray.leaving) = (point, hit.facet);
                    state.came = Came::Specular;
                }
            }
            if state.beta == 0.0 {
                return;
            }
        }
    }

    /// Which part light belongs to that took so many diffuse reflections.
    pub fn part(&self, bounces: u32, redirected: bool) -> Part {
        match bounces {
            0 if redirected => Part::Redirected,
            0 => Part::Direct,
            n if self.max_bounces.is_some_and(|most| n > most) => Part::Lost,
            _ => Part::Interreflected,
        }
    }

    /// What is drawn at every diffuse reflection: one direction, and for the sky a few window points, which cost little.
    fn reflection(&self) -> Techniques<'static> {
        let window_points = match self.light {
            Light::Sky(_) => WINDOW_POINTS,
            Light::Suns(_) | Light::AnySun => u32::from(self.portals.spreads()),
        };
        Techniques { directions: 1.0, window_points, per_sr: 0.0, nodes: None, of_sensor: false }
    }
}

/// A direction about z with density cos θ/π: the unit square to a disc without tearing neighbours apart (P. Shirley, K. Chiu,
/// JGT 2(3), 1997), then up to the hemisphere (Malley).
#[inline]
pub fn cosine_direction(u: [f64; 2]) -> Vec3 {
    let (a, b) = (2.0 * u[0] - 1.0, 2.0 * u[1] - 1.0);
    let (r, angle) = if a.abs() > b.abs() {
        (a, PI / 4.0 * (b / a))
    } else if b != 0.0 {
        (b, PI / 2.0 - PI / 4.0 * (a / b))
    } else {
        return Vec3::Z;
    };
    let (sine, cosine) = angle.sin_cos();
    Vec3::new(r * cosine, r * sine, (1.0 - r * r).max(0.0).sqrt())
}
