//! The cells that the directions of one side are cut into.

use hemisphere::{KlemsBasis, disk_to_square, square_to_disk};
use std::f64::consts::PI;

/// The directions of one side cut into cells, each of which is a unit square with areas kept.
#[derive(Clone, Debug)]
pub enum Cells {
    /// Patches of a Klems basis.
    Klems(KlemsBasis),
    /// 2^k by 2^k squares of the unit square that the disk of (x, y) is mapped to, row by row.
    Grid(u32),
}

/// Places and weights along one coordinate of a cell.
pub type Rule = Vec<[f64; 2]>;

impl Cells {
    /// How many there are.
    pub fn count(&self) -> usize {
        match self {
            Self::Klems(basis) => basis.patches(),
            Self::Grid(k) => 1 << (2 * k),
        }
    }

    /// The cell that (x, y) of a unit vector lies in.
    #[inline]
    pub fn find(&self, x: f64, y: f64) -> usize {
        match self {
            Self::Klems(basis) => basis.find(x, y),
            Self::Grid(k) => {
                let side = 1_usize << k;
                let [i, j] = disk_to_square(x, y).map(|p| ((p * side as f64) as usize).min(side - 1));
                j * side + i
            }
        }
    }

    /// Projected solid angle of a cell [sr].
    pub fn size(&self, cell: usize) -> f64 {
        match self {
            Self::Klems(basis) => basis.projected_solid_angle(cell),
            Self::Grid(_) => PI / self.count() as f64,
        }
    }

    /// (x, y) at a place in the cell's unit square: equal areas are equal projected solid angles.
    pub fn place(&self, cell: usize, at: [f64; 2]) -> [f64; 2] {
        match self {
            Self::Klems(basis) => basis.sample(cell, at),
            Self::Grid(k) => {
                let side = 1_usize << k;
                square_to_disk(
                    ((cell % side) as f64 + at[0]) / side as f64,
                    ((cell / side) as f64 + at[1]) / side as f64,
                )
            }
        }
    }

    /// The cell of (−x, −y).
    pub fn turned(&self, cell: usize) -> usize {
        match self {
            Self::Klems(basis) => basis.turned(cell),
            Self::Grid(_) => self.count() - 1 - cell,
        }
    }

    /// The cell of (−x, y).
    pub fn mirrored_in_x(&self, cell: usize) -> usize {
        match self {
            Self::Klems(basis) => basis.mirrored_in_x(cell),
            Self::Grid(k) => {
                let side = 1 << k;
                cell / side * side + side - 1 - cell % side
            }
        }
    }

    /// Gauss-Legendre rules of `n` places along both coordinates of the part of a cell between two corners; the weights are shares of
    /// the whole. Along the first of a Klems patch they are those in the angle from the normal, over which the optics is smooth up to
    /// grazing incidence.
    pub fn rules(&self, cell: usize, n: usize, low: [f64; 2], high: [f64; 2]) -> [Rule; 2] {
        let even = gauss_legendre(n);
        let width = [high[0] - low[0], high[1] - low[1]];
        let along = |k: usize| -> Rule { even.iter().map(|[x, w]| [low[k] + width[k] * x, w * width[k]]).collect() };
        let Self::Klems(basis) = self else { return [along(0), along(1)] };
        let ([inner, outer], _) = basis.bounds(cell);
        let (start, end) = (inner.sin().powi(2), outer.sin().powi(2));
        let theta = |a: f64| (start + (end - start) * a).min(1.0).sqrt().asin();
        let (from, to) = (theta(low[0]), theta(high[0]));
        let mut first: Rule = even
            .iter()
            .map(|[place, weight]| {
                let theta = from + (to - from) * place;
                [(theta.sin().powi(2) - start) / (end - start), weight * (2.0 * theta).sin()]
            })
            .collect();
        let sum: f64 = first.iter().map(|[_, weight]| weight).sum();
        first.iter_mut().for_each(|[_, weight]| *weight *= width[0] / sum);
        [first, along(1)]
    }
}

/// Gauss-Legendre quadrature on 0..1: roots of the Legendre polynomial by Newton's method
/// (M. Abramowitz, I. A. Stegun, *Handbook of Mathematical Functions*, 25.4.30).
fn gauss_legendre(n: usize) -> Rule {
    let root = |k: usize| {
        let mut x = (PI * (k as f64 + 0.75) / (n as f64 + 0.5)).cos();
        let mut slope = 1.0;
        for _ in 0..100 {
            let (mut before, mut value) = (1.0, x);
            for m in 2..=n {
                let m = m as f64;
                (before, value) = (value, ((2.0 * m - 1.0) * x * value - (m - 1.0) * before) / m);
            }
            slope = n as f64 * (x * value - before) / (x * x - 1.0);
            let step = value / slope;
            x -= step;
            if step.abs() < 1e-15 {
                break;
            }
        }
        [0.5 - 0.5 * x, 1.0 / ((1.0 - x * x) * slope * slope)]
    };
    match n {
        0 | 1 => vec![[0.5, 1.0]],
        _ => (0..n).map(root).collect(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// n places integrate polynomials up to degree 2n − 1, and stand mirror-symmetrically.
    #[test]
    fn gauss_legendre_is_exact_for_polynomials() {
        for n in 1..=24 {
            let rule = gauss_legendre(n);
            for degree in 0..2 * n as i32 {
                let sum: f64 = rule.iter().map(|[x, w]| w * x.powi(degree)).sum();
                assert!((sum - 1.0 / f64::from(degree + 1)).abs() < 1e-13, "{n} {degree}");
            }
            for (a, b) in rule.iter().zip(rule.iter().rev()) {
                assert!((a[0] + b[0] - 1.0).abs() < 1e-15 && (a[1] - b[1]).abs() < 1e-14);
            }
        }
    }

    /// Places stay in their cell; turning and mirroring a direction turns and mirrors its cell.
    #[test]
    fn cells_hold_their_places_and_images() {
        let klems = KlemsBasis::named("klems_half").expect("known");
        for cells in [Cells::Klems(klems), Cells::Grid(0), Cells::Grid(3)] {
            let total: f64 = (0..cells.count()).map(|c| cells.size(c)).sum();
            assert!((total - PI).abs() < 1e-13);
            for cell in 0..cells.count() {
                let [first, second] = cells.rules(cell, 3, [0.0; 2], [1.0; 2]);
                for [a, _] in &first {
                    for [b, _] in &second {
                        let [x, y] = cells.place(cell, [*a, *b]);
                        assert_eq!(cells.find(x, y), cell);
                        assert_eq!(cells.find(-x, -y), cells.turned(cell));
                        assert_eq!(cells.find(-x, y), cells.mirrored_in_x(cell));
                    }
                }
            }
        }
    }
}
