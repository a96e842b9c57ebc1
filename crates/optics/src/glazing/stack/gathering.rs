//! The beams of a stack put together: those of one direction, and for a room those that the eye could not tell apart.

use super::super::LitLobe;
use super::states::Directory;
use hemisphere::{Direction, Vec3};
use std::collections::HashMap;

/// Beams at least as strong as this share of the incident power keep their directions.
const STRONG: f64 = 1e-3;

/// Beams that a room takes as they are, and as many as it should get of more.
const FEW: usize = 128;
const ENOUGH: usize = 512;

/// Sides of the cells in which weaker beams become one \[degrees\]: the next, if they are still more than enough. The sun's disc is
/// 0.533° wide.
const CELLS_DEG: [f64; 3] = [0.1, 0.2, 0.4];

/// Whether light leaves inwards, whether it was totally reflected, and where in the angles about and along the cuts.
type Cell = (bool, bool, i32, i32);

/// Makes one of beams of one direction, which come by different wavelengths, and sorts them, the strongest first.
pub fn joined(beams: &[LitLobe]) -> Vec<LitLobe> {
    let mut directory = Directory::default();
    let mut joined: Vec<LitLobe> = Vec::with_capacity(beams.len());
    for beam in beams {
        let i = directory.find(beam.direction, joined.len(), |i| joined[i].direction);
        match joined.get_mut(i) {
            Some(there) => add(there, beam),
            None => joined.push(*beam),
        }
    }
    sort(&mut joined);
    joined
}

/// The same light in fewer beams: weak ones that leave the same side within a small cell of directions become one along their mean
/// (theory/layers.md, eq. 13). Light that was totally reflected stays apart from light that was not.
pub fn gathered(mut beams: Vec<LitLobe>) -> Vec<LitLobe> {
    if beams.len() <= FEW {
        return beams;
    }
    // they are sorted
    let strong = beams.partition_point(|b| b.stokes[0] >= STRONG);
    for cell in CELLS_DEG {
        let weak = in_cells(&beams[strong..], cell.to_radians());
        beams.truncate(strong);
        beams.extend(weak);
        if beams.len() <= ENOUGH {
            break;
        }
    }
    sort(&mut beams);
    beams
}

/// Beams within cells of this side \[rad\] as one each.
fn in_cells(beams: &[LitLobe], side: f64) -> Vec<LitLobe> {
    let mut cells: HashMap<Cell, (LitLobe, [f64; 3])> = HashMap::new();
    for beam in beams {
        let d = beam.direction;
        // light between panels keeps its x: turned about it, it differs by an angle
        let (turned, along) = (d.y.atan2(d.z.abs()) / side, d.x.clamp(-1.0, 1.0).asin() / side);
        let key = (d.z > 0.0, beam.total_reflections > 0, turned.floor() as i32, along.round() as i32);
        let power = beam.stokes[0].max(0.0);
        let moments = [power, power * d.x, power * d.y];
        match cells.get_mut(&key) {
            Some((there, sums)) => {
                add(there, beam);
                sums.iter_mut().zip(moments).for_each(|(sum, x)| *sum += x);
            }
            None => drop(cells.insert(key, (*beam, moments))),
        }
    }
    let merged = |(beam, moments): (LitLobe, _)| LitLobe { direction: mean(moments, beam.direction), ..beam };
    cells.into_values().map(merged).collect()
}

/// The direction of the mean components along the sheet, or that of any beam where there is no light.
fn mean([power, x, y]: [f64; 3], any: Direction) -> Direction {
    if power <= 0.0 {
        return any;
    }
    let (x, y) = (x / power, y / power);
    let z = (1.0 - x * x - y * y).max(f64::MIN_POSITIVE).sqrt();
    Direction::from_unit(Vec3::new(x, y, z.copysign(any.z)))
}

fn add(there: &mut LitLobe, beam: &LitLobe) {
    there.stokes.iter_mut().zip(beam.stokes).for_each(|(sum, x)| *sum += x);
    there.total_reflections = there.total_reflections.min(beam.total_reflections);
}

/// The strongest first, and then by height: the same on every run.
fn sort(beams: &mut [LitLobe]) {
    beams.sort_by(|a, b| b.stokes[0].total_cmp(&a.stokes[0]).then(a.direction.y.total_cmp(&b.direction.y)));
}
