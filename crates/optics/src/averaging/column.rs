//! One incident cell: where its light goes, by quadrature with exact lobes.

use super::{Averaging, Ports};
use crate::{Glazing, Lobe, Lobes};
use hemisphere::{Direction, Vec3};

/// Where the light that arrives through one port goes, as shares of it.
#[derive(Clone, Debug, Default)]
pub(super) struct Column {
    /// Port and share, by port, each once. A port that light leaves by is named as the one that it would arrive through if it
    /// came back the way it went.
    pub sent: Vec<(u32, f64)>,
    /// Variance of each of those shares, if they were found by random draws.
    pub variance: Vec<(u32, f64)>,
    pub absorbed: f64,
    pub residual: f64,
    /// What the last refinement changed: the sum of absolute differences.
    pub change: f64,
}

/// Dense sums by port, and which of them are in use.
pub(super) struct Sums {
    dense: Vec<f64>,
    used: Vec<u32>,
    here: Lobes,
    beside: [Lobes; 2],
}

impl Sums {
    pub fn new(ports: usize) -> Self {
        Self { dense: vec![0.0; ports], used: Vec::new(), here: Lobes::default(), beside: Default::default() }
    }

    pub fn add(&mut self, port: usize, share: f64) {
        if self.dense[port] == 0.0 {
            self.used.push(port as u32);
        }
        self.dense[port] += share;
    }

    /// Takes what has been summed, in the order of the ports.
    pub fn take(&mut self) -> Vec<(u32, f64)> {
        self.used.sort_unstable();
        self.used.dedup();
        let (dense, used) = (&mut self.dense, &mut self.used);
        used.drain(..).map(|port| (port, std::mem::take(&mut dense[port as usize]))).collect()
    }
}

/// Step by which the slope of a lobe's direction is found, and how far a lobe may then have moved.
const STEP: f64 = 1e-6;
const MOVED: f64 = 1e-3;

/// A lobe whose (x, y) are those of the incident light but for signs, to this, keeps them so over the whole cell.
const SAME: f64 = 1e-9;

/// Points to which the directions of a lobe are carried from each place where they are solved for.
const CARRIED: usize = 64;

/// Averages over one incident port, halving the distance of the places until the column hardly changes.
pub(super) fn column(glazing: &dyn Glazing, ports: &Ports, port: usize, how: &Averaging, sums: &mut Sums) -> Column {
    let mut n = how.places.max(1);
    let mut coarse = quadrature(glazing, ports, port, n, sums);
    coarse.change = f64::INFINITY;
    while 2 * n <= how.most_places {
        n *= 2;
        let mut fine = quadrature(glazing, ports, port, n, sums);
        fine.change = difference(&coarse.sent, &fine.sent) + (fine.absorbed - coarse.absorbed).abs();
        let settled = fine.change <= how.tolerance;
        coarse = fine;
        if settled {
            break;
        }
    }
    coarse
}

fn quadrature(glazing: &dyn Glazing, ports: &Ports, port: usize, n: usize, sums: &mut Sums) -> Column {
    let (side, cell) = ports.parts(port);
    let [first, second] = ports.cells.rules(cell, n);
    let mut column = Column::default();
    let mut low = [0.0; 2];
    for [a, weight_a] in &first {
        let high_a = low[0] + weight_a;
        low[1] = 0.0;
        for [b, weight_b] in &second {
            let high_b = low[1] + weight_b;
            let at = ports.cells.place(cell, [*a, *b]);
            let share = weight_a * weight_b;
            solve(glazing, at, side, sums);
            column.absorbed += share * sums.here.absorbed;
            column.residual += share * (sums.here.residual + sums.here.spread);
            for k in 0..sums.here.beams.len() {
                let lobe = sums.here.beams[k];
                let corner = [low, [high_a, high_b]];
                carry(ports, cell, at, corner, lobe, share, sums);
            }
            low[1] = high_b;
        }
        low[0] = high_a;
    }
    column.sent = sums.take();
    column
}

/// The lobes at (x, y) on a side; those a step beside it as well, if any of them is not a plain image of the light.
fn solve(glazing: &dyn Glazing, [x, y]: [f64; 2], side: f64, sums: &mut Sums) {
    let towards = |x: f64, y: f64| {
        let z = (1.0 - x * x - y * y).max(1e-18).sqrt();
        Direction::of(Vec3::new(x, y, side * z)).unwrap_or(Direction::from_unit(Vec3::Z * side))
    };
    glazing.lobes(towards(x, y), &mut sums.here);
    sums.beside.iter_mut().for_each(Lobes::clear);
    if sums.here.beams.iter().any(|lobe| !is_image([x, y], lobe)) {
        // towards the middle, which is always a direction
        glazing.lobes(towards(x - STEP.copysign(x), y), &mut sums.beside[0]);
        glazing.lobes(towards(x, y - STEP.copysign(y)), &mut sums.beside[1]);
    }
}

fn is_image([x, y]: [f64; 2], lobe: &Lobe) -> bool {
    (lobe.direction.x.abs() - x.abs()).abs() < SAME && (lobe.direction.y.abs() - y.abs()).abs() < SAME
}

/// Hands the light of one lobe to the ports that it leaves by, as the incident light moves over its part of the cell
/// (theory/bsdf_averaging.md, eq. 7).
fn carry(
    ports: &Ports,
    cell: usize,
    at: [f64; 2],
    [low, high]: [[f64; 2]; 2],
    lobe: Lobe,
    share: f64,
    sums: &mut Sums,
) {
    let d = lobe.direction;
    let slopes = if is_image(at, &lobe) { None } else { slopes(at, lobe, &sums.beside) };
    let Some([by_x, by_y]) = slopes else {
        sums.add(ports.returning(d.z, [d.x, d.y]), share * lobe.power);
        return;
    };
    let part = share * lobe.power / CARRIED as f64;
    for k in 0..CARRIED {
        // a rank-1 lattice: even in both coordinates and in line with no edge
        let u = [(k as f64 + 0.5) / CARRIED as f64, ((k as f64 + 0.5) * LATTICE).fract()];
        let [x, y] = ports.cells.place(cell, [0, 1].map(|i| low[i] + (high[i] - low[i]) * u[i]));
        let (dx, dy) = (x - at[0], y - at[1]);
        let (x, y) = (d.x + by_x[0] * dx + by_y[0] * dy, d.y + by_x[1] * dx + by_y[1] * dy);
        // beyond grazing there is no direction: what little gets there leaves along the sheet
        let beyond = x.hypot(y).max(1.0);
        sums.add(ports.returning(d.z, [x / beyond, y / beyond]), part);
    }
}

/// The golden section's step of the lattice.
const LATTICE: f64 = 0.618_033_988_749_894_9;

/// How (x, y) of a lobe change with x and with y of the incident light; `None` if it is not found beside.
fn slopes(at: [f64; 2], lobe: Lobe, beside: &[Lobes; 2]) -> Option<[[f64; 2]; 2]> {
    let d = lobe.direction;
    let one = |k: usize| {
        let distance = |other: &&Lobe| (other.direction.vector() - d.vector()).length_squared();
        let same_side = beside[k].beams.iter().filter(|other| other.direction.z * d.z > 0.0);
        let other = same_side.min_by(|a, b| distance(a).total_cmp(&distance(b)))?;
        let step = -STEP.copysign(at[k]);
        (distance(&other) < MOVED * MOVED).then(|| [(other.direction.x - d.x) / step, (other.direction.y - d.y) / step])
    };
    Some([one(0)?, one(1)?])
}

/// Sum of the absolute differences of two columns in the order of their ports.
pub(super) fn difference(a: &[(u32, f64)], b: &[(u32, f64)]) -> f64 {
    let (mut i, mut j, mut sum) = (0, 0, 0.0);
    while i < a.len() || j < b.len() {
        let (left, right) = (a.get(i).map_or(u32::MAX, |e| e.0), b.get(j).map_or(u32::MAX, |e| e.0));
        let mut x = 0.0;
        if left <= right {
            x += a[i].1;
            i += 1;
        }
        if right <= left {
            x -= b[j].1;
            j += 1;
        }
        sum += x.abs();
    }
    sum
}
