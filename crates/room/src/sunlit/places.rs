//! Where on windows and mirrors paths begin: in even rows, where light gets there.

use super::beams::{SunBeam, Sunlight};
use super::convex::bounds;
use crate::loops::{crossings_odd, signed_area};
use crate::scene::Scene;
use crate::surface::Kind;
use glam::DVec2;
use hemisphere::Vec3;

impl Sunlight {
    /// Whether the sun reaches nothing of the window.
    pub(super) fn is_dark(&self) -> bool {
        self.pieces.is_empty()
    }
}

/// About so many places of a window that the sun reaches.
pub fn on_window(scene: &Scene, seen: &Sunlight, points: usize, towards: Vec3) -> Vec<Vec3> {
    let Kind::Window { frame, .. } = &scene.surface_of(seen.facet).kind else { return Vec::new() };
    let corners = scene.facet(seen.facet).corners();
    let flat: Vec<[f64; 2]> =
        corners.iter().map(|&c| [(c - corners[0]).dot(frame.x), (c - corners[0]).dot(frame.y)]).collect();
    let mut lit = Vec::new();
    // between slats the sun may reach none of a few places
    for finer in [1, 16, 256] {
        let places = grid(&flat, finer * points).into_iter().map(|[x, y]| corners[0] + x * frame.x + y * frame.y);
        lit = places.filter(|&place| scene.met(place, towards).is_none()).collect();
        if lit.len() as f64 > 0.25 * seen.share * points as f64 {
            break;
        }
    }
    if points > 1 { thinned(lit, points) } else { lit }
}

/// About so many places of a mirror outside from which light goes to a window.
pub fn on_mirror(scene: &Scene, beam: &SunBeam, points: usize) -> Vec<Vec3> {
    let flat =
        beam.pieces.iter().flat_map(|piece| grid(&piece.iter().map(|p| p.to_array()).collect::<Vec<_>>(), points));
    let places = flat.map(|at| beam.plane.space(DVec2::from_array(at)));
    let to_window = |place: &Vec3| {
        let hit = scene.met(*place, beam.direction);
        hit.is_some_and(|hit| matches!(scene.surface_of(hit.facet).kind, Kind::Window { .. }))
    };
    thinned(places.filter(to_window).collect(), points)
}

/// So many of some places, evenly.
fn thinned(places: Vec<Vec3>, most: usize) -> Vec<Vec3> {
    if places.len() <= most {
        return places;
    }
    let step = (places.len() - 1) as f64 / (most - 1).max(1) as f64;
    (0..most).map(|k| places[(k as f64 * step).round_ties_even() as usize]).collect()
}

/// About so many places in a polygon of a plane: the middles of the squares of a grid.
fn grid(flat: &[[f64; 2]], count: usize) -> Vec<[f64; 2]> {
    let [low, high] = bounds(&flat.iter().map(|&p| DVec2::from_array(p)).collect::<Vec<_>>());
    let size = high - low;
    let step = (signed_area(flat).abs() / count as f64).sqrt();
    let numbers = (size / step).to_array().map(|n| n.round_ties_even().max(1.0));
    let place = |k: usize, axis: usize| (k as f64 + 0.5) / numbers[axis] * size[axis] + low[axis];
    let rows = (0..numbers[1] as usize).flat_map(|row| (0..numbers[0] as usize).map(move |column| [column, row]));
    rows.map(|[column, row]| [place(column, 0), place(row, 1)]).filter(|&at| crossings_odd(flat, at)).collect()
}
