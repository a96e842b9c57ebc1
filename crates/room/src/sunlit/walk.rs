//! Light followed forwards through a room by its mirrors, windows and walls, ray by ray.

use super::lobed::Lobed;
use crate::scene::Scene;
use crate::surface::Kind;
use hemisphere::{Direction, Rng, Vec3};
use optics::Scattered;
use std::f64::consts::TAU;

/// Steps that a path takes at most, whatever it meets.
const MOST_STEPS: usize = 16;

/// Rays at once; the strongest are followed.
const MOST_RAYS: usize = 20_000;

/// Directions that round to the same are one.
const DIGITS: f64 = 1e12;

/// What a vertex of a path is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Event {
    /// Where light comes from.
    Sun,
    /// A window.
    Glazing,
    /// A surface that mirrors more than it scatters.
    Mirror,
    /// A surface that scatters.
    Diffuse,
    /// A boundary between media, where paths end.
    Interface,
    /// Nothing was met.
    Sky,
}

/// A place on a path.
pub struct PathVertex {
    /// Where.
    pub position: Vec3,
    /// What is there.
    pub event: Event,
    /// The surface that it lies on, if any.
    pub surface: Option<u32>,
    /// What arrives, as a share of the light that fell on the window or mirror where the path began.
    pub power: f64,
    /// Total reflections on the way here.
    pub total_reflections: u32,
    /// Whether a mirror was on the way here.
    pub is_mirrored: bool,
    /// Where its light came from.
    before: Option<usize>,
}

/// Light on its way.
#[derive(Clone)]
pub struct LightRay {
    pub origin: Vec3,
    pub direction: Vec3,
    pub power: f64,
    /// The vertex that it comes from.
    pub vertex: Option<usize>,
    pub total_reflections: u32,
    pub is_mirrored: bool,
    /// Diffuse reflections on the way.
    pub bounces: u32,
}

/// Paths as a tree of vertices: each knows where its light came from.
pub struct Walk<'a> {
    pub scene: &'a Scene,
    pub lobed: &'a Lobed<'a>,
    /// Light weaker than this is followed no further.
    pub least_power: f64,
    /// Diffuse reflections that are followed.
    pub bounces: u32,
    /// How far light is drawn that meets nothing.
    pub beyond_m: f64,
    pub vertices: Vec<PathVertex>,
    drawn: u64,
}

impl<'a> Walk<'a> {
    pub fn new(scene: &'a Scene, lobed: &'a Lobed<'a>, least_power: f64, bounces: u32, beyond_m: f64) -> Self {
        Self { scene, lobed, least_power, bounces, beyond_m, vertices: Vec::new(), drawn: 0 }
    }

    /// Light that comes from the sun to places of a surface, and meets it there.
    pub fn sent_to(&mut self, places: &[Vec3], towards: Vec3, event: Event, surface: u32) -> Vec<LightRay> {
        let ray = |&origin: &Vec3| LightRay {
            origin,
            direction: -towards,
            power: 1.0,
            vertex: None,
            total_reflections: 0,
            is_mirrored: false,
            bounces: 0,
        };
        let mut rays: Vec<LightRay> = places.iter().map(ray).collect();
        for ray in &mut rays {
            ray.vertex = Some(self.add(ray.origin + self.beyond_m * towards, Event::Sun, ray, None));
        }
        for ray in &mut rays {
            ray.vertex = Some(self.add(ray.origin, event, ray, Some(surface)));
        }
        rays
    }

    /// Adds a vertex at the end of a ray.
    fn add(&mut self, position: Vec3, event: Event, ray: &LightRay, surface: Option<u32>) -> usize {
        let LightRay { power, total_reflections, is_mirrored, vertex: before, .. } = *ray;
        self.vertices.push(PathVertex { position, event, surface, power, total_reflections, is_mirrored, before });
        self.vertices.len() - 1
    }

    /// Vertices of each path from its beginning to its end.
    pub fn chains(&self) -> Vec<Vec<usize>> {
        let mut is_last = vec![true; self.vertices.len()];
        self.vertices.iter().filter_map(|vertex| vertex.before).for_each(|before| is_last[before] = false);
        let chain = |last: usize| {
            let mut back: Vec<usize> =
                std::iter::successors(Some(last), |&vertex| self.vertices[vertex].before).collect();
            back.reverse();
            back
        };
        (0..self.vertices.len()).filter(|&vertex| is_last[vertex]).map(chain).collect()
    }

    /// Follows light until it is weak, absorbed or outside.
    pub fn follow(&mut self, mut rays: Vec<LightRay>) {
        for _ in 0..MOST_STEPS {
            rays.retain(|ray| ray.power >= self.least_power);
            if rays.len() > MOST_RAYS {
                rays.sort_by(|a, b| b.power.total_cmp(&a.power));
                rays.truncate(MOST_RAYS);
            }
            if rays.is_empty() {
                return;
            }
            rays = self.step(rays);
        }
    }

    /// Takes rays to what they meet; what goes on from there.
    fn step(&mut self, rays: Vec<LightRay>) -> Vec<LightRay> {
        let scene = self.scene;
        let (mut mirrored, mut scattered) = (Vec::new(), Vec::new());
        let mut at_windows: Vec<(u32, Vec<LightRay>)> = Vec::new();
        for mut ray in rays {
            let Some(hit) = scene.met(ray.origin, ray.direction) else {
                self.add(ray.origin + self.beyond_m * ray.direction, Event::Sky, &ray, None);
                continue;
            };
            let position = ray.origin + hit.distance * ray.direction;
            let facet = scene.facet(hit.facet);
            let kind = &scene.surfaces[facet.surface as usize].kind;
            let event = match kind {
                Kind::Window { .. } => Event::Glazing,
                Kind::Interface { .. } => Event::Interface,
                Kind::Opaque(material) if material.specular > material.diffuse => Event::Mirror,
                Kind::Opaque(_) => Event::Diffuse,
            };
            ray.vertex = Some(self.add(position, event, &ray, Some(facet.surface)));
            ray.origin = position;
            match kind {
                Kind::Opaque(material) => {
                    let along = facet.normal.dot(ray.direction);
                    let (specular, diffuse) = (ray.power * material.specular, ray.power * material.diffuse);
                    if specular >= self.least_power && ray.bounces == 0 {
                        let direction = ray.direction - 2.0 * along * facet.normal;
                        mirrored.push(LightRay { direction, power: specular, is_mirrored: true, ..ray.clone() });
                    }
                    if diffuse >= self.least_power && ray.bounces < self.bounces {
                        let normal = if along > 0.0 { -facet.normal } else { facet.normal };
                        let direction = cosine_weighted(normal, well_spread(self.drawn));
                        self.drawn += 1;
                        let bounces = ray.bounces + 1;
                        scattered.push(LightRay { direction, power: diffuse, bounces, ..ray });
                    }
                }
                // after a diffuse reflection what meets a window is drawn no further
                Kind::Window { .. } if ray.bounces == 0 => {
                    match at_windows.iter_mut().find(|(window, _)| *window == hit.facet) {
                        Some((_, rays)) => rays.push(ray),
                        None => at_windows.push((hit.facet, vec![ray])),
                    }
                }
                _ => {}
            }
        }
        let mut following = mirrored;
        following.append(&mut scattered);
        at_windows.sort_by_key(|(window, _)| *window);
        for (window, rays) in at_windows {
            following.extend(self.through(rays, window));
        }
        following
    }

    /// What leaves a window on either side: a beam for each lobe, a drawn direction where it spreads light.
    pub fn through(&mut self, mut rays: Vec<LightRay>, window: u32) -> Vec<LightRay> {
        let rounded = |ray: &LightRay| ray.direction.to_array().map(|x| (x * DIGITS).round() as i64);
        rays.sort_by_key(rounded);
        let mut made = Vec::new();
        for own in rays.chunk_by(|a, b| rounded(a) == rounded(b)) {
            let Some(solved) = self.lobed.solved(window, own[0].direction) else { continue };
            for lobe in solved.beams.iter().take_while(|lobe| lobe.power >= self.least_power) {
                made.extend(own.iter().map(|ray| LightRay {
                    direction: lobe.direction,
                    power: ray.power * lobe.power,
                    total_reflections: ray.total_reflections + u32::from(lobe.total_reflections),
                    ..ray.clone()
                }));
            }
            if solved.spread > 0.0 {
                self.scatter(own, window, solved.spread, &mut made);
            }
        }
        made
    }

    /// One direction for each ray, in proportion to power; the share that a window spreads, averaged over them.
    fn scatter(&mut self, own: &[LightRay], window: u32, share: f64, made: &mut Vec<LightRay>) {
        let Some((glazing, frame)) = self.lobed.window(window) else { return };
        let Some(incident) = Direction::of(frame.inward(own[0].direction)) else { return };
        for (stream, ray) in own.iter().enumerate() {
            let mut rng = Rng::new(self.drawn, stream as u64);
            let u = std::array::from_fn(|_| rng.uniform());
            if let Scattered::Leaves { direction, .. } = glazing.scatter(incident, u) {
                let direction = frame.outward(*direction);
                made.push(LightRay { direction, power: ray.power * share, ..ray.clone() });
            }
        }
        self.drawn += own.len() as u64;
    }
}

/// Point `index` of those that fill the unit square evenly, whichever run of them is taken: the additive sequence of the plastic
/// number (theory/room.md, eq. 17).
fn well_spread(index: u64) -> [f64; 2] {
    const PLASTIC: f64 = 1.324_717_957_244_746;
    let n = (index + 1) as f64;
    [1.0 / PLASTIC, 1.0 / (PLASTIC * PLASTIC)].map(|step| (0.5 + n * step).fract())
}

/// A direction about a normal, as dense as the cosine of their angle.
fn cosine_weighted(normal: Vec3, spread: [f64; 2]) -> Vec3 {
    let helper = if normal.z.abs() < 0.9 { Vec3::Z } else { Vec3::X };
    let across = helper.cross(normal).normalize();
    let (radius, height) = (spread[0].sqrt(), (1.0 - spread[0]).max(0.0).sqrt());
    let (sine, cosine) = (TAU * spread[1]).sin_cos();
    radius * (cosine * across + sine * normal.cross(across)) + height * normal
}
