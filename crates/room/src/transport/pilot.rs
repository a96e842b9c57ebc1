//! What a few rays and points tell before the work begins: where it is bright, and what of it matters to whom.
//!
//! They serve for planning alone, so what is planned by them stays unbiased.

use super::density::{Cells, NodeDensity};
use super::importance::weights_of;
use super::nodes::lit_node;
use super::numbers::Numbers;
use super::path::{Found, Vertex};
use super::sensors::Sensors;
use super::walk::{Walker, cosine_direction};
use crate::surface::Kind;
use crate::tracer::{NO_FACET, Ray};
use hemisphere::{Direction, Frame, Rng, Sobol, Vec3};
use rayon::prelude::*;

/// What is known beforehand.
pub struct Pilot {
    /// Where nodes serve the sensors best, one in all.
    pub near: NodeDensity,
    /// Where nodes serve those best, one in all.
    pub far: NodeDensity,
    /// For each sensor, the share of its hemisphere that only rays of its own explore: sky, mirrors, boundaries, windows.
    pub alone: Vec<f64>,
}

/// Rays a sensor sends ahead, at least.
const RAYS: u32 = 64;

/// Rays that all sensors together send ahead, at least.
const ALL_RAYS: u32 = 8192;

/// Cells that surfaces are cut into, about.
const CELLS: f64 = 256.0;

/// Points tried on each side of a cell.
const POINTS: u32 = 4;

/// Sensors that each of these points looks at.
const LOOKS: usize = 8;

/// Nodes that the far points look at.
const NEAR: usize = 48;

/// A point is taken to matter no more to another than at this form factor \[1/m²\]: directions do better from there on.
const NEAREST: f64 = 8.0;

/// An even sky added to the one that errors are judged under, in shares of its mean luminance.
const ANY_SKY: f64 = 0.2;

/// What the rays of one sensor met.
struct Looked {
    /// Facet, point and side of diffuse surfaces.
    met: Vec<(u32, Vec3, bool)>,
    rays: f64,
    alone: f64,
    /// Rays to the sky or a window.
    open: f64,
}

/// A point tried on one side of a cell.
struct Tried {
    cell: usize,
    side: usize,
    vertex: Vertex,
}

/// Looks around from every sensor, and from every cell of every surface.
pub fn pilot(walker: &Walker<'_>, sensors: &Sensors, weights: &[f64], seed: u64) -> Pilot {
    let scene = walker.scene;
    let mean = weights.iter().sum::<f64>() / weights.len() as f64;
    // other skies will be asked for
    let luminance: Vec<f64> = weights.iter().map(|w| if mean > 0.0 { w / mean + ANY_SKY } else { 1.0 }).collect();
    let looked: Vec<Looked> =
        (0..sensors.len()).into_par_iter().map(|i| look_around(walker, sensors, i, seed)).collect();
    let cells = cells_for(walker, &looked);
    let tried = points_of(walker, &cells, seed);
    // form factors of the points at a few sensors each
    let seen: Vec<Vec<(usize, f64)>> = tried
        .par_iter()
        .enumerate()
        .map(|(k, point)| {
            (0..LOOKS.min(sensors.len()))
                .map(|n| (k + n * sensors.len() / LOOKS.min(sensors.len())) % sensors.len())
                .map(|i| {
                    (
                        i,
                        form(
                            walker,
                            &Vertex { place: sensors.place(i), normal: sensors.normal(i), facet: NO_FACET },
                            &point.vertex,
                        ),
                    )
                })
                .filter(|(_, form)| *form > 0.0)
                .collect()
        })
        .collect();
    let mut met = vec![[false; 2]; cells.count()];
    for &(facet, point, front) in looked.iter().flat_map(|looked| &looked.met) {
        met[cells.of(scene, facet, point)][usize::from(front)] = true;
    }
    let is_near = |k: usize| !seen[k].is_empty() || met[tried[k].cell][tried[k].side];
    let near: Vec<usize> = (0..tried.len()).filter(|&k| is_near(k)).collect();
    let step = near.len().div_ceil(NEAR).max(1);
    let far: Vec<f64> = tried
        .par_iter()
        .enumerate()
        .map(|(k, point)| {
            let few = near[k % step.min(near.len().max(1))..].iter().step_by(step);
            let (squares, n) = few.fold((0.0, 0.0), |(squares, n), &j| {
                let form = form(walker, &tried[j].vertex, &point.vertex);
                (squares + form * form, n + 1.0)
            });
            if n > 0.0 { f64::sqrt(squares / n) } else { 0.0 }
        })
        .collect();
    let bright: Vec<f64> = (0..tried.len())
        .into_par_iter()
        .map(|k| {
            let lit = is_near(k) || far[k] > 0.0;
            if lit { brightness(walker, &tried[k].vertex, &luminance, Rng::new(seed, k as u64).bits()) } else { 0.0 }
        })
        .collect();
    let bright = per_side(&cells, &tried, |k| bright[k]);
    // how much light each sensor gets, roughly: errors count relative to it
    let light: Vec<f64> = looked
        .iter()
        .map(|looked| {
            let met = looked
                .met
                .iter()
                .map(|&(facet, point, front)| bright[cells.of(scene, facet, point)][usize::from(front)]);
            (looked.open + met.sum::<f64>()) / looked.rays
        })
        .collect();
    let least = 0.05 * light.iter().sum::<f64>() / light.len() as f64;
    let matters = per_side(&cells, &tried, |k| {
        let squares = seen[k].iter().map(|&(i, form)| (form / (light[i] + least).max(f64::MIN_POSITIVE)).powi(2));
        (squares.sum::<f64>() / LOOKS as f64).sqrt()
    });
    let far = per_side(&cells, &tried, |k| far[k]);
    let density = |matters: &[[f64; 2]], met: &[[bool; 2]]| {
        let weight = weights_of(walker, &cells, matters, met, &bright);
        NodeDensity::new(scene, &cells, 1.0, &weight)
    };
    let alone = looked.iter().map(|looked| looked.alone / looked.rays).collect();
    Pilot { near: density(&matters, &met), far: density(&far, &vec![[false; 2]; cells.count()]), alone }
}

fn look_around(walker: &Walker<'_>, sensors: &Sensors, i: usize, seed: u64) -> Looked {
    let scene = walker.scene;
    let sobol = Sobol { seed: seed ^ Rng::new(seed, i as u64).bits() };
    let frame = Frame::about(Direction::from_unit(sensors.normal(i)));
    let rays = RAYS.max(ALL_RAYS / sensors.len() as u32);
    let mut looked = Looked { met: Vec::new(), rays: f64::from(rays), alone: 0.0, open: 0.0 };
    for index in 0..rays {
        let local = cosine_direction([sobol.sample(index, 0), sobol.sample(index, 1)]);
        let ray = Ray { origin: sensors.position(i), direction: frame.outward(local), leaving: NO_FACET };
        let Some(hit) = scene.tracer.closest(&ray) else {
            looked.alone += 1.0;
            looked.open += 1.0;
            continue;
        };
        let front = scene.facet(hit.facet).normal.dot(ray.direction) < 0.0;
        match &scene.surface_of(hit.facet).kind {
            Kind::Opaque(material) => {
                looked.alone += material.specular;
                if material.diffuse > 0.0 {
                    looked.met.push((hit.facet, ray.origin + hit.distance * ray.direction, front));
                }
            }
            // seen from outside, a window leads to what only rays of one's own find
            Kind::Window { .. } => {
                looked.alone += if front { 0.1 } else { 1.0 };
                looked.open += 1.0;
            }
            Kind::Interface { .. } => looked.alone += 1.0,
        }
    }
    looked
}

/// More cells for what the sensors see more of, and for larger surfaces.
fn cells_for(walker: &Walker<'_>, looked: &[Looked]) -> Cells {
    let surfaces = &walker.scene.surfaces;
    let mut met = vec![0.0; surfaces.len()];
    for &(facet, ..) in looked.iter().flat_map(|looked| &looked.met) {
        met[walker.scene.facet(facet).surface as usize] += 1.0;
    }
    let all_met = met.iter().sum::<f64>().max(1.0);
    let all_area: f64 = surfaces.iter().map(|s| s.area).sum();
    let share = |(met, surface): (f64, &crate::scene::Surface)| match surface.kind {
        Kind::Opaque(material) if material.diffuse > 0.0 => 0.5 * (met / all_met + surface.area / all_area),
        _ => 0.0,
    };
    let shares: Vec<f64> = met.into_iter().zip(surfaces).map(share).collect();
    Cells::new(walker.scene, &shares, CELLS)
}

/// A few points on each side of each cell of each diffuse surface.
fn points_of(walker: &Walker<'_>, cells: &Cells, seed: u64) -> Vec<Tried> {
    let scene = walker.scene;
    let mut tried = Vec::new();
    for (surface, cell) in cells.each() {
        if !matches!(scene.surfaces[surface as usize].kind, Kind::Opaque(material) if material.diffuse > 0.0) {
            continue;
        }
        let sobol = Sobol { seed: Rng::new(!seed, cell as u64).bits() };
        for side in [0, 1] {
            for index in 0..POINTS {
                let u = sobol.point(index, 0);
                let (facet, point) = cells.point(scene, surface, cell, [u.coordinate(0), u.coordinate(1)]);
                let normal = scene.facet(facet).normal;
                let normal = if side == 1 { normal } else { -normal };
                tried.push(Tried {
                    cell,
                    side,
                    vertex: Vertex { place: scene.tracer.place_on(facet, point), normal, facet },
                });
            }
        }
    }
    tried
}

/// cos θ cos θ′/d² between two vertices that see each other, bounded.
fn form(walker: &Walker<'_>, a: &Vertex, b: &Vertex) -> f64 {
    let way = b.place.position - a.place.position;
    let (here, there, d2) = (way.dot(a.normal), -way.dot(b.normal), way.length_squared());
    if here <= 0.0 || there <= 0.0 || !walker.scene.tracer.visible(&a.place, &b.place) {
        return 0.0;
    }
    (here * there / (d2 * d2)).min(NEAREST)
}

/// What a point sends on, by one path.
fn brightness(walker: &Walker<'_>, vertex: &Vertex, luminance: &[f64], seed: u64) -> f64 {
    let mut found = Found::default();
    lit_node(walker, vertex, Numbers::new(Sobol { seed }, 0), None, 1, &mut found);
    found.entries.iter().map(|entry| entry.value * luminance[entry.patch as usize]).sum()
}

/// The root mean square of a property of the points on each side of each cell.
fn per_side(cells: &Cells, tried: &[Tried], property: impl Fn(usize) -> f64) -> Vec<[f64; 2]> {
    let mut squares = vec![[0.0; 2]; cells.count()];
    for (k, Tried { cell, side, .. }) in tried.iter().enumerate() {
        squares[*cell][*side] += property(k).powi(2) / f64::from(POINTS);
    }
    squares.into_iter().map(|sides| sides.map(f64::sqrt)).collect()
}
