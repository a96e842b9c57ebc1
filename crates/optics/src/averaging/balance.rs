//! What reciprocity and the energy account demand of the exchange between ports, made exact.

/// A symmetric sparse matrix of the light exchanged between ports, by rows, each in the order of its ports.
pub(super) type Rows = Vec<Vec<(u32, f64)>>;

/// The mean of a matrix and its transpose (theory/bsdf_averaging.md, eq. 8), and the greatest sum of absolute differences between
/// the two in a row, as a share of `sizes`.
pub(super) fn symmetric(rows: &Rows, sizes: &[f64]) -> (Rows, f64) {
    let mut transposed: Rows = vec![Vec::new(); rows.len()];
    for (a, row) in rows.iter().enumerate() {
        for &(b, value) in row {
            transposed[b as usize].push((a as u32, value));
        }
    }
    let mut worst = 0.0_f64;
    let mean = rows.iter().zip(&transposed).zip(sizes).map(|((row, other), size)| {
        worst = worst.max(super::column::difference(row, other) / size);
        let mut mean: Vec<(u32, f64)> = row.iter().chain(other).map(|&(b, value)| (b, 0.5 * value)).collect();
        mean.sort_unstable_by_key(|&(b, _)| b);
        mean.dedup_by(|next, kept| {
            let same = next.0 == kept.0;
            if same {
                kept.1 += next.1;
            }
            same
        });
        mean
    });
    let mean = mean.collect();
    (mean, worst)
}

/// Scales a symmetric matrix to Y′_ab = Y_ab (1 + u_a + u_b) with the given sums of its rows, and returns the greatest |u|
/// (theory/bsdf_averaging.md, eq. 9).
///
/// The u solve (diag(Y 1) + Y) u = m − Y 1. Where light passes between two sets
/// of ports alone and their sums disagree, no such u exists: the least misfit is left.
pub(super) fn balance(rows: &mut Rows, sums: &[f64]) -> f64 {
    let mut greatest = 0.0_f64;
    // one step is exact but for rounding, the second takes that out
    for _ in 0..2 {
        let row_sums: Vec<f64> = rows.iter().map(|row| row.iter().map(|e| e.1).sum()).collect();
        let wanted: Vec<f64> = sums.iter().zip(&row_sums).map(|(m, s)| m - s).collect();
        let u = solve(rows, &row_sums, &wanted);
        for (a, row) in rows.iter_mut().enumerate() {
            row.iter_mut().for_each(|(b, value)| *value *= 1.0 + u[a] + u[*b as usize]);
        }
        greatest = u.iter().fold(greatest, |g, x| g.max(x.abs()));
    }
    greatest
}

/// The least-squares u of (diag(s) + Y) u = wanted, s being the sums of the rows: conjugate gradients on the normal equations of the
/// system with its diagonal taken out, which bear a system without solution
/// (M. R. Hestenes, E. Stiefel, *J. Research NBS* 49, 1952, §10).
fn solve(rows: &Rows, row_sums: &[f64], wanted: &[f64]) -> Vec<f64> {
    let root: Vec<f64> = row_sums.iter().map(|s| if *s > 0.0 { 1.0 / s.sqrt() } else { 0.0 }).collect();
    let times = |v: &[f64]| -> Vec<f64> {
        let others = |a: usize| rows[a].iter().map(|&(b, y)| y * root[b as usize] * v[b as usize]).sum::<f64>();
        (0..rows.len()).map(|a| if root[a] > 0.0 { v[a] + root[a] * others(a) } else { 0.0 }).collect()
    };
    let square = |v: &[f64]| v.iter().map(|x| x * x).sum::<f64>();
    let mut w = vec![0.0; rows.len()];
    let mut left: Vec<f64> = wanted.iter().zip(&root).map(|(m, r)| m * r).collect();
    let mut slope = times(&left);
    let mut p = slope.clone();
    let mut size = square(&slope);
    let enough = ENOUGH * size;
    for _ in 0..MOST_STEPS {
        let image = times(&p);
        let curvature = square(&image);
        if size <= enough || curvature < f64::MIN_POSITIVE {
            break;
        }
        let alpha = size / curvature;
        w.iter_mut().zip(&p).for_each(|(w, p)| *w += alpha * p);
        left.iter_mut().zip(&image).for_each(|(r, i)| *r -= alpha * i);
        slope = times(&left);
        let next = square(&slope);
        p.iter_mut().zip(&slope).for_each(|(p, s)| *p = s + next / size * *p);
        size = next;
    }
    w.iter().zip(&root).map(|(w, r)| w * r).collect()
}

/// Share of the squared slope to begin with at which the gradients have done.
const ENOUGH: f64 = 1e-28;

/// Steps of the conjugate gradients at most.
const MOST_STEPS: usize = 2000;

#[cfg(test)]
mod tests {
    use super::*;

    fn sum(row: &[(u32, f64)]) -> f64 {
        row.iter().map(|e| e.1).sum()
    }

    /// Both at once: symmetric, and every row sums to what it should.
    #[test]
    fn balance_keeps_symmetry_and_meets_the_sums() {
        let rows: Rows = vec![
            vec![(0, 0.10), (1, 0.61), (3, 0.2)],
            vec![(0, 0.58), (1, 0.31)],
            vec![(2, 0.05), (3, 0.9)],
            vec![(0, 0.19), (2, 0.91)],
        ];
        let sums = [0.92, 0.9, 0.95, 1.1];
        let (mut mean, worst) = symmetric(&rows, &[1.0; 4]);
        assert!((worst - 0.04).abs() < 1e-12);
        let u = balance(&mut mean, &sums);
        assert!(u > 1e-4 && u < 0.1, "{u}");
        let entry = |a: usize, b: u32| mean[a].iter().find(|e| e.0 == b).map_or(0.0, |e| e.1);
        for a in 0..4 {
            assert!((sum(&mean[a]) - sums[a]).abs() < 1e-14);
            (0..4).for_each(|b| assert!((entry(a, b as u32) - entry(b, a as u32)).abs() < 1e-16));
        }
    }

    /// Two ports that only feed each other and should have different sums get their mean.
    #[test]
    fn what_cannot_be_met_is_shared() {
        let mut rows: Rows = vec![vec![(1, 0.5)], vec![(0, 0.5)], vec![]];
        balance(&mut rows, &[0.8, 0.9, 0.0]);
        assert!((sum(&rows[0]) - 0.85).abs() < 1e-12 && (sum(&rows[1]) - 0.85).abs() < 1e-12);
    }
}
