//! Beams among so many facets that polygons would take too long: a grid of rays instead, one for each cell.

use super::convex::{Polygon, area, bounds, shared};
use super::plane::{Distance, Plane, Shade};
use crate::scene::Scene;
use crate::surface::Kind;
use glam::DVec2;
use hemisphere::Vec3;

/// Cells along the longer side of the box about a beam.
const CELLS: f64 = 48.0;

/// Pieces of a cell of less area than this are none \[m²\].
const LEAST_AREA: f64 = 1e-12;

/// A run of neighbours in a row that meet one facet, or the sky, and what of the beam's pieces lies in it.
struct Run {
    corners: [DVec2; 4],
    met: Option<u32>,
    inside: Vec<Polygon>,
}

/// What the sky sees of some pieces.
pub struct Open {
    pub pieces: Vec<Polygon>,
    /// Share that nothing opaque hides.
    pub share: f64,
    /// The surface that hides most.
    pub hidden_by: Option<u32>,
}

/// What each cell of a beam meets, as [`super::plane::visible`] tells it. What is smaller than a cell may be missed, and edges are as
/// rough as the cells.
pub fn cells_of(scene: &Scene, plane: &Plane, direction: Vec3, pieces: &[Polygon]) -> Vec<(Shade, Vec<Polygon>)> {
    let (runs, _) = runs_of(scene, plane, direction, pieces);
    let met = runs.into_iter().filter_map(|run| Some((run.met?, run)));
    met.filter(|(_, run)| !run.inside.is_empty())
        .map(|(facet, run)| {
            let distance = Distance::of(scene.facet(facet), plane, direction);
            (Shade { outline: run.corners.to_vec(), distance, facet }, run.inside)
        })
        .collect()
}

/// Pieces that see the sky along a direction.
pub fn sky_cells(scene: &Scene, plane: &Plane, towards: Vec3, pieces: &[Polygon]) -> Open {
    let (runs, counts) = runs_of(scene, plane, towards, pieces);
    let left = runs.into_iter().filter(|run| run.met.is_none()).flat_map(|run| run.inside).collect();
    let opaque = |surface: &usize| !matches!(scene.surfaces[*surface].kind, Kind::Window { .. });
    let hiding = (0..scene.surfaces.len()).filter(opaque);
    let most = hiding.clone().fold(None, |best: Option<usize>, k| match best {
        Some(best) if counts.of_surface[best] >= counts.of_surface[k] => Some(best),
        _ => Some(k),
    });
    let hidden: usize = hiding.map(|surface| counts.of_surface[surface]).sum();
    Open {
        pieces: left,
        share: 1.0 - hidden as f64 / counts.inside.max(1) as f64,
        hidden_by: most.filter(|&surface| counts.of_surface[surface] > 0).map(|surface| surface as u32),
    }
}

/// Cells that hold some of the pieces, all and by the surface that they meet.
struct Counts {
    inside: usize,
    of_surface: Vec<usize>,
}

fn runs_of(scene: &Scene, plane: &Plane, direction: Vec3, pieces: &[Polygon]) -> (Vec<Run>, Counts) {
    let [low, high] = bounds(&pieces.concat());
    let size = (high - low).max(DVec2::splat(1e-9));
    let count = (size / size.max_element() * CELLS).ceil().max(DVec2::ONE);
    let step = size / count;
    // whether the pieces are all of the cells
    let fills = pieces.iter().map(|piece| area(piece)).sum::<f64>() > (1.0 - 1e-9) * size.x * size.y;
    let inside = |cell: &[DVec2; 4]| -> Vec<Polygon> {
        if fills {
            return vec![cell.to_vec()];
        }
        let parts = pieces.iter().map(|piece| shared(piece, cell));
        parts.filter(|part| !part.is_empty() && area(part) > LEAST_AREA).collect()
    };
    let mut counts = Counts { inside: 0, of_surface: vec![0; scene.surfaces.len()] };
    let mut runs: Vec<Run> = Vec::new();
    for row in 0..count.y as usize {
        let mut is_first = true;
        for column in 0..count.x as usize {
            let corner = low + DVec2::new(column as f64, row as f64) * step;
            let cell = [DVec2::ZERO, DVec2::X, DVec2::ONE, DVec2::Y].map(|at| corner + at * step);
            let met = scene.met(plane.space(corner + 0.5 * step), direction).map(|hit| hit.facet);
            if fills || !inside(&cell).is_empty() {
                counts.inside += 1;
                if let Some(facet) = met {
                    counts.of_surface[scene.facet(facet).surface as usize] += 1;
                }
            }
            match runs.last_mut().filter(|run| !is_first && run.met == met) {
                Some(run) => (run.corners[1], run.corners[2]) = (cell[1], cell[2]),
                None => runs.push(Run { corners: cell, met, inside: Vec::new() }),
            }
            is_first = false;
        }
    }
    for run in &mut runs {
        run.inside = inside(&run.corners);
    }
    (runs, counts)
}
