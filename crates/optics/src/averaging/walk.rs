//! One incident cell of an element without lobes: where its light goes, by random draws.

use super::{
    Averaging, Ports,
    column::{Column, Sums},
};
use crate::{Glazing, Scattered};
use hemisphere::{Direction, Rng, Sobol, Vec3};

/// Repetitions with well-spread draws of their own, whose scatter says how certain the mean is.
const REPETITIONS: u32 = 16;

/// Draws from well-spread places of one incident port.
pub(super) fn column(glazing: &dyn Glazing, ports: &Ports, port: usize, how: &Averaging, sums: &mut Sums) -> Column {
    let (side, cell) = ports.parts(port);
    let mut rng = Rng::new(how.seed, port as u64);
    let draws = how.draws.div_ceil(REPETITIONS);
    let share = 1.0 / f64::from(draws);
    let mut column = Column::default();
    let mut found = Vec::new();
    for _ in 0..REPETITIONS {
        let sobol = Sobol { seed: rng.bits() };
        for index in 0..draws {
            let [a, b, u, v] = [0, 1, 2, 3].map(|d| sobol.sample(index, d));
            let [x, y] = ports.cells.place(cell, [a, b]);
            let z = (1.0 - x * x - y * y).max(1e-18).sqrt();
            match Direction::of(Vec3::new(x, y, side * z)).map(|i| glazing.scatter(i, [u, v, rng.uniform()])) {
                Some(Scattered::Leaves { direction: d, .. }) => sums.add(ports.returning(d.z, [d.x, d.y]), share),
                _ => column.absorbed += share / f64::from(REPETITIONS),
            }
        }
        found.push(sums.take());
    }
    // mean over the repetitions, and the variance of that mean; a cell that no draw met may still get less than one draw's share
    let n = f64::from(REPETITIONS);
    found.iter().flatten().for_each(|&(port, share)| sums.add(port as usize, share / n));
    column.sent = sums.take();
    found.iter().flatten().for_each(|&(port, share)| sums.add(port as usize, share * share / n));
    column.variance = sums.take();
    for ((_, variance), (_, mean)) in column.variance.iter_mut().zip(&column.sent) {
        *variance = ((*variance - mean * mean) / (n - 1.0)).max((share / n).powi(2));
    }
    column
}
