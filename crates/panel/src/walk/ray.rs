//! One ray from entry to exit: at every facet chance decides between going through and being mirrored.

use super::{
    draw::Draw,
    geometry::{Geometry, Meeting},
};
use crate::{
    differential::Differential,
    facet::{Facet, Finish, MediumId, Surface},
    flux::film_reflectance,
    media::{Media, Optical},
    panel::{Polarisation, skimming},
    plane::Vec2,
    profile::Profile,
    topology::HalfEdge,
};
use hemisphere::{Direction, Frame, Vec3};
use optics::{Interface, Mueller, Retarder, Slopes, Split, mirror, reference_axes, refract};

/// Facets a ray may meet before it is given up: only light that is all but trapped gets here.
const MOST_MEETINGS: u32 = 20_000;
/// Draws of a rippled normal that looks away from the light before the smooth one is taken.
const RIPPLE_TRIES: u32 = 16;

/// How a walk ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum End {
    /// It leaves with the share `weight` of its power; the rest was absorbed on the way.
    Leaves {
        /// Where it travels.
        direction: Vec3,
        /// Total internal reflections on the way.
        total_reflections: u16,
        /// Share not absorbed.
        weight: f64,
    },
    /// It was given up with this share of its power.
    Lost {
        /// Share not absorbed.
        weight: f64,
    },
}

/// What a walk needs to know of one facet.
#[derive(Clone, Copy, Debug)]
struct Boundary {
    film: Option<MediumId>,
    finish: Finish,
}

/// Walks through one panel at one wavelength.
#[derive(Clone, Debug)]
pub struct Walk {
    geometry: Geometry,
    boundaries: Vec<Boundary>,
    media: Media,
    is_resolved: bool,
    absorbs: bool,
}

/// A ray on its way.
#[derive(Clone, Copy, Debug)]
pub struct Ray {
    pub(crate) v: Vec3,
    /// First axis that its polarisation refers to, across `v`.
    pub(crate) s: Vec3,
    /// Q, U, V over the power.
    pub(crate) polarisation: [f64; 3],
    pub(crate) weight: f64,
    pub(crate) total_reflections: u16,
    /// How it turns with the light that it came of, if that is asked for.
    pub(crate) turning: Option<Differential>,
}

impl Ray {
    /// Along `v`, with Stokes parameters over the power about the reference axes of `v`.
    pub(crate) fn new(v: Vec3, polarisation: [f64; 3]) -> Self {
        let s = reference_axes(v).0;
        Self { v, s, polarisation, weight: 1.0, total_reflections: 0, turning: None }
    }
}

impl Walk {
    /// Prepares a panel.
    pub fn new(profile: &Profile, media: &Media, polarisation: Polarisation) -> Self {
        let boundary = |f: &Facet| Boundary {
            film: if let Surface::Film(gap) = f.surface { Some(gap) } else { None },
            finish: f.finish,
        };
        Self {
            geometry: Geometry::of(profile),
            boundaries: profile.facets().iter().map(boundary).collect(),
            absorbs: media.absorb(),
            media: media.clone(),
            is_resolved: polarisation == Polarisation::Resolved,
        }
    }

    /// Follows unpolarised light that arrives along `incident`.
    pub fn run(&self, incident: Direction, draw: &mut Draw) -> End {
        self.run_polarised(incident, [0.0; 3], draw).0
    }

    /// Follows light that arrives along `incident` with these Stokes parameters over its power, and returns those it leaves with;
    /// each about the reference axes of its direction.
    pub fn run_polarised(&self, incident: Direction, polarisation: [f64; 3], draw: &mut Draw) -> (End, [f64; 3]) {
        if let Some(mirrored) = skimming(incident) {
            let end = End::Leaves { direction: mirrored.vector(), total_reflections: 0, weight: 1.0 };
            return (end, polarisation);
        }
        let incident = incident.vector();
        let mut ray = Ray::new(incident, polarisation);
        match self.geometry.enter(draw.uniform(), incident) {
            Meeting::Facet(hand, at, _) => {
                let end = self.follow(&mut ray, hand, at, draw);
                let [q, u, v] = ray.polarisation;
                let [_, q, u, v] = Mueller::out_of_plane(ray.v, ray.s).apply([1.0, q, u, v]);
                (end, if self.is_resolved { [q, u, v] } else { [0.0; 3] })
            }
            Meeting::Outside => (End::Leaves { direction: incident, total_reflections: 0, weight: 1.0 }, polarisation),
            Meeting::Nothing => (End::Lost { weight: 1.0 }, polarisation),
        }
    }

    /// Follows light that arrives as `ray` at share `s` of the facet of `hand`, and returns the slopes it leaves with, if it was
    /// known how it turns.
    pub fn resume(&self, hand: HalfEdge, s: f64, mut ray: Ray, draw: &mut Draw) -> (End, Option<Slopes>) {
        let end = self.follow(&mut ray, hand, self.geometry.point(hand, s), draw);
        let n = self.media.get(self.geometry.outside(ray.v)).n;
        (end, ray.turning.map(|turning| turning.slopes(n)))
    }

    fn follow(&self, ray: &mut Ray, mut hand: HalfEdge, mut at: Vec2, draw: &mut Draw) -> End {
        for _ in 0..MOST_MEETINGS {
            let leaves_by = self.meet(ray, hand, at, draw);
            match self.geometry.next(leaves_by, at, ray.v) {
                Meeting::Facet(next, point, length) => {
                    if self.absorbs {
                        // Beer–Lambert along the true path
                        ray.weight *= (-self.medium(leaves_by).absorption * length).exp();
                    }
                    (hand, at) = (next, point);
                }
                Meeting::Outside => {
                    let Ray { v: direction, total_reflections, weight, .. } = *ray;
                    return End::Leaves { direction, total_reflections, weight };
                }
                Meeting::Nothing => break,
            }
        }
        End::Lost { weight: ray.weight }
    }

    #[inline]
    fn medium(&self, hand: HalfEdge) -> Optical {
        self.media.get(self.geometry.medium(hand))
    }

    /// One facet: turns the ray, and says by which hand it leaves.
    #[inline]
    fn meet(&self, ray: &mut Ray, hand: HalfEdge, at: Vec2, draw: &mut Draw) -> HalfEdge {
        let boundary = &self.boundaries[hand.facet()];
        let inward = self.geometry.inward(hand, at);
        let smooth = Vec3::new(0.0, inward.y, inward.z);
        let mut normal = smooth;
        if !boundary.finish.is_smooth() {
            if boundary.finish.diffuse > 0.0 && draw.uniform() < boundary.finish.diffuse {
                scatter_diffusely(ray, smooth, draw);
                return hand;
            }
            if boundary.finish.slope > 0.0 {
                normal = rippled(smooth, boundary.finish.slope, ray.v, draw);
            }
        }
        let n_i = self.medium(hand).n;
        let n_t = match boundary.film {
            Some(gap) => self.media.get(gap).n,
            None => self.medium(hand.other()).n,
        };
        let interface = Interface { n_i, n_t };
        let cos_i = (-ray.v.dot(normal)).clamp(0.0, 1.0);
        let is_mirrored = if self.is_resolved {
            self.decide_resolved(ray, interface, cos_i, normal, boundary.film.is_some(), draw)
        } else {
            decide_averaged(ray, interface, cos_i, boundary.film.is_some(), draw)
        };
        if !is_mirrored && boundary.film.is_some() {
            return hand.other();
        }
        let turned = if is_mirrored { Some(mirror(ray.v, normal)) } else { refract(ray.v, normal, interface) };
        // mirrored light that a rippled normal would send into the facet leaves it as from the smooth facet
        let v = turned.unwrap_or_else(|| mirror(ray.v, normal));
        let side = v.dot(smooth);
        let goes_wrong = if is_mirrored { side <= 0.0 } else { side >= 0.0 };
        ray.v = if goes_wrong { v - 2.0 * side * smooth } else { v };
        // of smooth facets alone: others send out no beams
        ray.turning = ray
            .turning
            .map(|turning| if is_mirrored { turning.mirrored(normal) } else { turning.refracted(ray.v, normal) });
        if is_mirrored { hand } else { hand.other() }
    }

    /// Chance by the polarisation that the ray has, which is carried on.
    fn decide_resolved(
        &self,
        ray: &mut Ray,
        interface: Interface,
        cos_i: f64,
        normal: Vec3,
        is_film: bool,
        draw: &mut Draw,
    ) -> bool {
        // turn into the plane of incidence; at normal incidence it is any plane
        let across = normal.cross(ray.v);
        if across.length_squared() > 1e-24 {
            let s = across.normalize();
            let (c, d) = (ray.s.dot(s), ray.v.cross(ray.s).dot(s));
            let (cos_2, sin_2) = (c * c - d * d, 2.0 * c * d);
            let [q, u, v] = ray.polarisation;
            ray.polarisation = [q * cos_2 + u * sin_2, u * cos_2 - q * sin_2, v];
            ray.s = s;
        }
        let split = interface.split(cos_i);
        let [q, u, v] = ray.polarisation;
        let stokes = [1.0, q, u, v];
        let total = matches!(split, Split::Total { .. });
        let mirrored =
            if is_film { Retarder::reflected_by_film(split) } else { Retarder::reflected(split) }.apply(stokes);
        let is_mirrored = total || draw.uniform() < mirrored[0];
        ray.total_reflections = ray.total_reflections.saturating_add(u16::from(total));
        let after = if is_mirrored {
            mirrored
        } else if is_film {
            Retarder::transmitted_by_film(split).apply(stokes)
        } else {
            Retarder::transmitted(split).apply(stokes)
        };
        ray.polarisation = [after[1] / after[0], after[2] / after[0], after[3] / after[0]];
        is_mirrored
    }
}

/// Chance by the mean of s and p.
#[inline]
fn decide_averaged(ray: &mut Ray, interface: Interface, cos_i: f64, is_film: bool, draw: &mut Draw) -> bool {
    if interface.is_total(cos_i) {
        ray.total_reflections = ray.total_reflections.saturating_add(1);
        return true;
    }
    let r = interface.reflectance(cos_i);
    draw.uniform() < if is_film { film_reflectance(r) } else { r }
}

/// Lambert's law about the facet, unpolarised.
fn scatter_diffusely(ray: &mut Ray, normal: Vec3, draw: &mut Draw) {
    let (u, turn) = (draw.uniform(), std::f64::consts::TAU * draw.uniform());
    let (sin, cos) = turn.sin_cos();
    let (across, up) = (u.sqrt(), (1.0 - u).max(1e-300).sqrt());
    ray.v = Frame::about(Direction::from_unit(normal)).outward(Vec3::new(across * cos, across * sin, up));
    ray.s = reference_axes(ray.v).0;
    ray.polarisation = [0.0; 3];
}

/// The normal of a rippled facet: its tangents tilt by normal numbers of deviation `slope`, along and across the cut.
fn rippled(smooth: Vec3, slope: f64, v: Vec3, draw: &mut Draw) -> Vec3 {
    let along = Vec3::new(0.0, smooth.z, -smooth.y);
    for _ in 0..RIPPLE_TRIES {
        let (a, b) = draw.normals();
        let normal = (smooth + slope * (a * Vec3::X + b * along)).normalize();
        if v.dot(normal) < 0.0 {
            return normal;
        }
    }
    smooth
}
