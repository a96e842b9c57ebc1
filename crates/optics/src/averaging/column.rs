//! One incident cell: where its light goes, by quadrature with exact lobes.

use super::{Averaging, Ports};
use crate::{Glazing, Lobe, MovingLobes, Slopes};
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
    here: MovingLobes,
}

impl Sums {
    pub fn new(ports: usize) -> Self {
        Self { dense: vec![0.0; ports], used: Vec::new(), here: MovingLobes::default() }
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

/// Points of a whole cell to which the directions of lobes are carried, and the fewest for one place of the quadrature.
const CARRIED: f64 = 4096.0;
const FEWEST_CARRIED: usize = 8;
/// Lobes of this power or more are carried to all of them, weaker ones to fewer by the root of their power, halved so often at most.
const WORTH_ALL: f64 = 1e-3;
const HALVINGS: usize = 8;

/// Places along each coordinate of a part of a cell.
const PLACES: usize = 3;

/// A part of a cell's unit square: its lower and its upper corner.
#[derive(Clone, Copy)]
struct Part {
    low: [f64; 2],
    high: [f64; 2],
}

impl Part {
    fn share(&self) -> f64 {
        (self.high[0] - self.low[0]) * (self.high[1] - self.low[1])
    }

    fn quarters(&self) -> [Self; 4] {
        let middle = [0, 1].map(|k| 0.5 * (self.low[k] + self.high[k]));
        [[false, false], [true, false], [false, true], [true, true]].map(|upper| {
            let low = [0, 1].map(|k| if upper[k] { middle[k] } else { self.low[k] });
            let high = [0, 1].map(|k| if upper[k] { self.high[k] } else { middle[k] });
            Self { low, high }
        })
    }
}

/// Averages over one incident port, quartering the parts of its cell in which quartering still changes the column
/// (theory/bsdf_averaging.md, eq. 6).
pub(super) fn column(glazing: &dyn Glazing, ports: &Ports, port: usize, how: &Averaging, sums: &mut Sums) -> Column {
    let whole = Part { low: [0.0; 2], high: [1.0; 2] };
    let first = quadrature(glazing, ports, port, whole, sums);
    let mut found = Column::default();
    let mut open = vec![(whole, first, 0)];
    while let Some((part, before, level)) = open.pop() {
        if level == how.levels {
            found.add(before);
            continue;
        }
        let quarters = part.quarters().map(|quarter| (quarter, quadrature(glazing, ports, port, quarter, sums)));
        let mut together = Column::default();
        quarters.iter().for_each(|(_, column)| together.add(column.clone()));
        let change = difference(&before.sent, &together.sent) + (before.absorbed - together.absorbed).abs();
        // what parts of a cell change is as likely more as less: it adds by squares
        if change <= how.tolerance * part.share().sqrt() || level + 1 == how.levels {
            found.add(Column { change, ..together });
        } else {
            open.extend(quarters.map(|(quarter, column)| (quarter, column, level + 1)));
        }
    }
    found
}

impl Column {
    /// Adds the light of another part of the cell.
    fn add(&mut self, other: Self) {
        let mut sent = Vec::with_capacity(self.sent.len() + other.sent.len());
        let (mut a, mut b) = (self.sent.iter().peekable(), other.sent.iter().peekable());
        while let (Some(&&(p, x)), Some(&&(q, y))) = (a.peek(), b.peek()) {
            sent.push((p.min(q), if p <= q { x } else { 0.0 } + if q <= p { y } else { 0.0 }));
            if p <= q {
                a.next();
            }
            if q <= p {
                b.next();
            }
        }
        sent.extend(a.chain(b));
        self.sent = sent;
        self.absorbed += other.absorbed;
        self.residual += other.residual;
        self.change = self.change.hypot(other.change);
    }
}

fn quadrature(glazing: &dyn Glazing, ports: &Ports, port: usize, part: Part, sums: &mut Sums) -> Column {
    let (side, cell) = ports.parts(port);
    let [first, second] = ports.cells.rules(cell, PLACES, part.low, part.high);
    let mut column = Column::default();
    let mut low = part.low;
    for [a, weight_a] in &first {
        let high_a = low[0] + weight_a;
        low[1] = part.low[1];
        for [b, weight_b] in &second {
            let high_b = low[1] + weight_b;
            let at = ports.cells.place(cell, [*a, *b]);
            let share = weight_a * weight_b;
            let mut here = std::mem::take(&mut sums.here);
            glazing.moving_lobes(towards(at, side), &mut here);
            column.absorbed += share * here.lobes.absorbed;
            column.residual += share * (here.lobes.residual + here.lobes.spread);
            let part = Part { low, high: [high_a, high_b] };
            let mut moves = Moves { cell, at, part, lattices: Default::default() };
            for (&lobe, &slopes) in here.lobes.beams.iter().zip(&here.slopes) {
                carry(ports, lobe, slopes, &mut moves, sums);
            }
            sums.here = here;
            low[1] = high_b;
        }
        low[0] = high_a;
    }
    column.sent = sums.take();
    column
}

/// The direction of (x, y) on a side.
fn towards([x, y]: [f64; 2], side: f64) -> Direction {
    let z = (1.0 - x * x - y * y).max(1e-18).sqrt();
    Direction::of(Vec3::new(x, y, side * z)).unwrap_or(Direction::from_unit(Vec3::Z * side))
}

/// Hands the light of one lobe to the ports that it leaves by, as the incident light moves over its part of the cell
/// (theory/bsdf_averaging.md, eq. 7).
fn carry(ports: &Ports, lobe: Lobe, slopes: Option<Slopes>, moves: &mut Moves, sums: &mut Sums) {
    let (d, power) = (lobe.direction, moves.part.share() * lobe.power);
    let Some([by_x, by_y]) = slopes else {
        sums.add(ports.returning(d.z, [d.x, d.y]), power);
        return;
    };
    let points = moves.worth(ports, lobe.power);
    let power = power / points.len() as f64;
    for [dx, dy] in points {
        let (x, y) = (d.x + by_x[0] * dx + by_y[0] * dy, d.y + by_x[1] * dx + by_y[1] * dy);
        // beyond grazing there is no direction: what little gets there leaves along the sheet
        let beyond = x.hypot(y).max(1.0);
        sums.add(ports.returning(d.z, [x / beyond, y / beyond]), power);
    }
}

/// How far the light moves over a part of a cell, from the place of quadrature that answers for it.
struct Moves {
    cell: usize,
    at: [f64; 2],
    part: Part,
    /// Lattices of ever half as many points, those that have been asked for.
    lattices: [Vec<[f64; 2]>; HALVINGS + 1],
}

impl Moves {
    /// Points as many as a lobe of this power is worth.
    fn worth(&mut self, ports: &Ports, power: f64) -> &[[f64; 2]] {
        let all = (CARRIED * self.part.share()) as usize;
        // errors go with the power over the points: weak lobes err less with fewer
        let fewer = (0.5 * (WORTH_ALL / power.max(f64::MIN_POSITIVE)).log2()).clamp(0.0, HALVINGS as f64) as usize;
        let Self { cell, at, part, lattices } = self;
        let lattice = &mut lattices[fewer];
        if lattice.is_empty() {
            let points = (all >> fewer).max(FEWEST_CARRIED);
            lattice.extend((0..points).map(|k| {
                // a rank-1 lattice: even in both coordinates and in line with no edge
                let u = [(k as f64 + 0.5) / points as f64, ((k as f64 + 0.5) * LATTICE).fract()];
                let [x, y] =
                    ports.cells.place(*cell, [0, 1].map(|i| part.low[i] + (part.high[i] - part.low[i]) * u[i]));
                [x - at[0], y - at[1]]
            }));
        }
        lattice
    }
}

/// The golden section's step of the lattice.
const LATTICE: f64 = 0.618_033_988_749_894_9;

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
