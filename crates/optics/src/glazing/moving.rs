//! Beams that move: how their directions change with that of the light.

use super::{Glazing, Lobe, Lobes};
use hemisphere::{Direction, Vec3};

/// How (x, y) of a beam's direction change with x, and with y, of the light's.
pub type Slopes = [[f64; 2]; 2];

/// Every beam that leaves, and how each moves. Two of them may share a direction, if they part as the light moves.
#[derive(Clone, Debug, Default)]
pub struct MovingLobes {
    /// The beams and what does not leave.
    pub lobes: Lobes,
    /// Slopes of each beam; `None` for one that stays the image of the light ([`stays_image`]), and for one that is known for
    /// this direction of the light alone.
    pub slopes: Vec<Option<Slopes>>,
    beside: [Lobes; 2],
}

impl MovingLobes {
    /// Forgets everything but keeps the memory.
    pub fn clear(&mut self) {
        self.lobes.clear();
        self.slopes.clear();
    }
}

/// Step by which slopes are found, and how far a beam may then have moved.
const STEP: f64 = 1e-6;
const MOVED: f64 = 1e-3;

/// A beam whose (x, y) are those of the light but for signs, to this, is its image.
const SAME: f64 = 1e-9;

/// Slopes that differ from those of an image by no more than this are those of an image.
const SAME_SLOPE: f64 = 1e-6;

/// Whether (x, y) of a beam are those of the light but for their signs.
fn is_image(incident: Direction, direction: Direction) -> bool {
    (direction.x.abs() - incident.x.abs()).abs() < SAME && (direction.y.abs() - incident.y.abs()).abs() < SAME
}

/// Whether (x, y) of a beam with these slopes are those of the light but for their signs, and stay so: what panes do, and cuts
/// across the sheet.
pub fn stays_image(incident: Direction, direction: Direction, [by_x, by_y]: Slopes) -> bool {
    let crossed = by_x[1].abs().max(by_y[0].abs());
    let apart = (by_x[0].abs() - 1.0).abs().max((by_y[1].abs() - 1.0).abs());
    crossed < SAME_SLOPE && apart < SAME_SLOPE && is_image(incident, direction)
}

/// The beams of an element, and their slopes by the beams of two directions a small step beside.
pub(super) fn by_steps<G: Glazing + ?Sized>(glazing: &G, incident: Direction, out: &mut MovingLobes) {
    out.clear();
    glazing.lobes(incident, &mut out.lobes);
    let beams = &out.lobes.beams;
    if beams.iter().all(|beam| is_image(incident, beam.direction)) {
        out.slopes.resize(beams.len(), None);
        return;
    }
    let (x, y) = (incident.x, incident.y);
    // towards the middle, which is always a direction
    let steps = [x, y].map(|v: f64| -STEP.copysign(v));
    for (k, beside) in out.beside.iter_mut().enumerate() {
        let (x, y) = if k == 0 { (x + steps[0], y) } else { (x, y + steps[1]) };
        let z = (1.0 - x * x - y * y).max(1e-18).sqrt().copysign(incident.z);
        glazing.lobes(Direction::of(Vec3::new(x, y, z)).unwrap_or(incident), beside);
    }
    let beside = &out.beside;
    let slope = |beam: &Lobe| {
        if is_image(incident, beam.direction) {
            return None;
        }
        Some([one_slope(beam, &beside[0], steps[0])?, one_slope(beam, &beside[1], steps[1])?])
    };
    out.slopes.extend(beams.iter().map(slope));
}

/// How (x, y) of a beam change over one step; `None` if it is not found there.
fn one_slope(beam: &Lobe, beside: &Lobes, step: f64) -> Option<[f64; 2]> {
    let d = beam.direction;
    let distance = |other: &&Lobe| (other.direction.vector() - d.vector()).length_squared();
    let same_side = beside.beams.iter().filter(|other| other.direction.z * d.z > 0.0);
    let other = same_side.min_by(|a, b| distance(a).total_cmp(&distance(b)))?;
    (distance(&other) < MOVED * MOVED).then(|| [(other.direction.x - d.x) / step, (other.direction.y - d.y) / step])
}
