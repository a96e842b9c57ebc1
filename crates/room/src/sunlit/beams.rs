//! The sun's beams behind each window, and the patches that they light (theory/room.md, eqs. 12 and 16).

use super::cells::{Open, cells_of, sky_cells};
use super::convex::{Polygon, area, shared};
use super::lobed::Lobed;
use super::plane::{Plane, Shade, area_of, shades_of, unhidden, visible};
use crate::scene::Scene;
use crate::surface::Kind;
use hemisphere::Vec3;
use std::collections::VecDeque;
use std::sync::Arc;

/// Windows and mirrors that a beam goes by at most, and beams in all.
const MOST_STEPS: u32 = 6;
const MOST_BEAMS: usize = 400;

/// Flat pieces of mirrors outside that the sun is followed from, the largest first.
const MOST_MIRRORS: usize = 64;

/// Light closer to a plane than this, as a cosine, does not meet it.
const LEAST_COS: f64 = 1e-6;

/// Pieces of a beam of less area than this are none \[m²\].
const LEAST_AREA: f64 = 1e-10;

/// Parallel light that leaves pieces of one plane.
#[derive(Clone)]
pub struct SunBeam {
    /// The facet that it leaves, of a window or a mirror.
    pub source: u32,
    /// The window's facet that the light came in by, `None` while it is outside.
    pub window: Option<u32>,
    /// Where it travels.
    pub direction: Vec3,
    /// Share of the light that fell on the window.
    pub power: f64,
    /// Illuminance across it over that normal to the sun.
    pub strength: f64,
    /// Total internal reflections on the way.
    pub total_reflections: u32,
    /// Whether a mirror threw it.
    pub is_mirrored: bool,
    pub(super) plane: Plane,
    pub(super) pieces: Arc<Vec<Polygon>>,
}

/// A convex piece of a surface that one beam lights, and the piece of the beam's source that it comes from.
pub struct Patch {
    /// Which of the beams.
    pub beam: usize,
    /// The facet that is lit.
    pub facet: u32,
    /// Corners on it.
    pub corners: Vec<Vec3>,
    /// The same corners on the source.
    pub source: Vec<Vec3>,
    /// Area \[m²\].
    pub area: f64,
    /// Illuminance over that normal to the sun.
    pub strength: f64,
}

/// What the sun sees of a window.
pub struct Sunlight {
    /// The window's facet.
    pub facet: u32,
    /// Of incidence on the outside.
    pub cos: f64,
    /// Share that nothing opaque hides.
    pub share: f64,
    /// The surface that hides most of it.
    pub hidden_by: Option<u32>,
    pub(super) plane: Plane,
    /// In sight by way of nothing.
    pub(super) pieces: Arc<Vec<Polygon>>,
}

/// The light of one sun on its way.
pub struct Sunbeams<'a> {
    pub scene: &'a Scene,
    pub lobed: &'a Lobed<'a>,
    /// Towards the sun.
    pub towards: Vec3,
    /// A beam of less power is not followed.
    pub least_power: f64,
    /// Facets in the way of a beam, beyond which it is looked at cell by cell.
    pub most_shades: usize,
}

impl Sunbeams<'_> {
    /// What of a window the sun reaches from outside.
    pub fn on_window(&self, facet: u32) -> Sunlight {
        let (scene, shape) = (self.scene, self.scene.facet(facet));
        let (cos, plane) = (-shape.normal.dot(self.towards), Plane::of(&shape.corners(), shape.normal));
        let dark = Sunlight { facet, cos, share: 0.0, hidden_by: None, plane, pieces: Arc::default() };
        if cos <= 1e-9 || self.towards.z <= 0.0 {
            return dark;
        }
        let pieces: Vec<Polygon> = scene.pieces().of_facet(facet).map(|corners| plane.polygon(corners)).collect();
        let Some(shades) = shades_of(scene, &plane, self.towards, &pieces, self.most_shades) else {
            let Open { pieces, share, hidden_by } = sky_cells(scene, &plane, self.towards, &pieces);
            return Sunlight { share, hidden_by, pieces: Arc::new(pieces), ..dark };
        };
        let whole = area_of(&pieces);
        let opaque: Vec<&Shade> = shades.iter().filter(|shade| !is_window(scene, shade.facet)).collect();
        let mut hidden = vec![0.0; scene.surfaces.len()];
        for shade in &opaque {
            let covered = pieces.iter().map(|piece| area(&shared(piece, &shade.outline))).sum::<f64>();
            hidden[scene.facet(shade.facet).surface as usize] += covered;
        }
        let most = (0..hidden.len()).fold(0, |best, k| if hidden[k] > hidden[best] { k } else { best });
        let in_sight = unhidden(pieces.clone(), opaque);
        Sunlight {
            share: area_of(&in_sight) / whole,
            hidden_by: (hidden[most] > 1e-6 * whole).then_some(most as u32),
            pieces: Arc::new(unhidden(pieces, &shades)),
            ..dark
        }
    }

    /// Follows every beam by windows and mirrors to where its light is scattered.
    pub fn followed(&self, seen: &[Sunlight], thrown: &[SunBeam]) -> (Vec<SunBeam>, Vec<Patch>) {
        let (mut beams, mut patches) = (Vec::new(), Vec::new());
        let lit = seen.iter().filter(|one| !one.pieces.is_empty());
        let first = lit.flat_map(|one| self.through(one.facet, &one.plane, &one.pieces, -self.towards, None));
        // what the first window turns back stays outside
        let first = first.filter(|beam| beam.direction.dot(self.scene.facet(beam.source).normal) > 0.0);
        let mut waiting: VecDeque<(SunBeam, u32)> = first.chain(thrown.iter().cloned()).map(|beam| (beam, 1)).collect();
        while let Some((beam, steps)) = waiting.pop_front().filter(|_| beams.len() < MOST_BEAMS) {
            let number = beam.window.map(|_| beams.len());
            let following = self.land(&beam, number, &mut patches);
            if number.is_some() {
                beams.push(beam);
            }
            if steps < MOST_STEPS {
                waiting.extend(following.into_iter().map(|one| (one, steps + 1)));
            }
        }
        (beams, patches)
    }

    /// What mirrors that see the sun by way of nothing, as a light shelf outside, throw on.
    pub fn thrown_outside(&self) -> Vec<SunBeam> {
        let scene = self.scene;
        if self.towards.z <= 0.0 {
            return Vec::new();
        }
        let shines = |facet: u32| specular(scene, facet) >= self.least_power;
        let mut mirrors: Vec<(u32, &[Vec3])> = scene.pieces().having(shines).collect();
        if mirrors.len() > MOST_MIRRORS {
            mirrors.sort_by(|a, b| size(b.1).total_cmp(&size(a.1)));
            mirrors.truncate(MOST_MIRRORS);
        }
        let thrown = |(facet, corners): (u32, &[Vec3])| {
            let normal = scene.facet(facet).normal;
            let cos = normal.dot(self.towards);
            if cos.abs() < LEAST_COS {
                return None;
            }
            let plane = Plane::of(corners, normal * cos.signum());
            let pieces = vec![plane.polygon(corners)];
            let pieces = match shades_of(scene, &plane, self.towards, &pieces, self.most_shades) {
                Some(shades) => unhidden(pieces, &shades),
                None => sky_cells(scene, &plane, self.towards, &pieces).pieces,
            };
            let share = specular(scene, facet);
            (!pieces.is_empty()).then(|| SunBeam {
                source: facet,
                window: None,
                direction: 2.0 * cos * normal - self.towards,
                power: share,
                strength: share,
                total_reflections: 0,
                is_mirrored: true,
                plane,
                pieces: Arc::new(pieces),
            })
        };
        mirrors.into_iter().filter_map(thrown).collect()
    }

    /// The beams that a window makes of light that travels one way.
    fn through(
        &self,
        facet: u32,
        plane: &Plane,
        pieces: &Arc<Vec<Polygon>>,
        way: Vec3,
        before: Option<&SunBeam>,
    ) -> Vec<SunBeam> {
        let Some(solved) = self.lobed.solved(facet, way) else { return Vec::new() };
        let normal = self.scene.facet(facet).normal;
        let (power, strength) = before.map_or((1.0, 1.0), |beam| (beam.power, beam.strength));
        let made = solved.beams.iter().filter_map(|lobe| {
            let cos_out = normal.dot(lobe.direction).abs();
            let is_strong = lobe.power >= self.least_power && power * lobe.power >= self.least_power;
            (is_strong && cos_out > LEAST_COS).then(|| SunBeam {
                source: facet,
                window: before.and_then(|beam| beam.window).or(Some(facet)),
                direction: lobe.direction,
                power: power * lobe.power,
                strength: strength * lobe.power * normal.dot(way).abs() / cos_out,
                total_reflections: before.map_or(0, |beam| beam.total_reflections) + u32::from(lobe.total_reflections),
                is_mirrored: before.is_some_and(|beam| beam.is_mirrored),
                plane: *plane,
                pieces: pieces.clone(),
            })
        });
        made.collect()
    }

    /// Adds the patches of a beam, of this number unless it is outside; what becomes of it at windows and mirrors.
    fn land(&self, beam: &SunBeam, number: Option<usize>, patches: &mut Vec<Patch>) -> Vec<SunBeam> {
        let scene = self.scene;
        let seen = match shades_of(scene, &beam.plane, beam.direction, &beam.pieces, self.most_shades) {
            Some(shades) => visible(shades),
            None => cells_of(scene, &beam.plane, beam.direction, &beam.pieces),
        };
        // by the facet that they meet, in the order in which it is met
        let mut onward: Vec<(u32, Vec<Vec<Vec3>>)> = Vec::new();
        for (shade, pieces) in seen {
            let parts = beam.pieces.iter().flat_map(|mine| pieces.iter().map(move |piece| shared(mine, piece)));
            let parts: Vec<Polygon> = parts.filter(|part| area(part) > LEAST_AREA).collect();
            let surface = scene.surface_of(shade.facet);
            if matches!(surface.kind, Kind::Window { .. }) || specular(scene, shade.facet) > 0.0 {
                let landed = parts.iter().map(|part| shade.landed(&beam.plane, beam.direction, part));
                match onward.iter_mut().find(|(facet, _)| *facet == shade.facet) {
                    Some((_, known)) => known.extend(landed),
                    None => onward.push((shade.facet, landed.collect())),
                }
            }
            // what lies outside is lit by the sun itself, and that is not asked for
            let (Some(number), Kind::Opaque(_)) = (number, &surface.kind) else { continue };
            let cos = scene.facet(shade.facet).normal.dot(beam.direction).abs();
            patches.extend(parts.iter().map(|part| {
                let corners = shade.landed(&beam.plane, beam.direction, part);
                Patch {
                    beam: number,
                    facet: shade.facet,
                    area: 0.5 * size(&corners),
                    corners,
                    source: part.iter().map(|&at| beam.plane.space(at)).collect(),
                    strength: beam.strength * cos,
                }
            }));
        }
        onward.into_iter().flat_map(|(facet, parts)| self.onward(beam, facet, &parts)).collect()
    }

    /// What becomes of a beam's pieces at a window or a mirror.
    fn onward(&self, beam: &SunBeam, facet: u32, parts: &[Vec<Vec3>]) -> Vec<SunBeam> {
        if parts.is_empty() {
            return Vec::new();
        }
        let shape = self.scene.facet(facet);
        let plane = Plane::of(&shape.corners(), shape.normal);
        let pieces = Arc::new(parts.iter().map(|part| plane.polygon(part)).collect());
        if is_window(self.scene, facet) {
            return self.through(facet, &plane, &pieces, beam.direction, Some(beam));
        }
        let share = specular(self.scene, facet);
        if beam.power * share < self.least_power {
            return Vec::new();
        }
        vec![SunBeam {
            source: facet,
            direction: beam.direction - 2.0 * beam.direction.dot(shape.normal) * shape.normal,
            power: beam.power * share,
            strength: beam.strength * share,
            is_mirrored: true,
            plane,
            pieces,
            ..beam.clone()
        }]
    }
}

fn is_window(scene: &Scene, facet: u32) -> bool {
    matches!(scene.surface_of(facet).kind, Kind::Window { .. })
}

fn specular(scene: &Scene, facet: u32) -> f64 {
    match &scene.surface_of(facet).kind {
        Kind::Opaque(material) => material.specular,
        _ => 0.0,
    }
}

/// Twice the area of a flat polygon.
fn size(corners: &[Vec3]) -> f64 {
    let Some(&first) = corners.first() else { return 0.0 };
    corners.windows(2).map(|pair| (pair[0] - first).cross(pair[1] - first)).sum::<Vec3>().length()
}
