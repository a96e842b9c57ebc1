//! From exact lobes to the blocks of a BSDF: averages over cells of directions, reciprocal and with the energy account closed.

mod balance;
mod cells;
mod column;
mod isotropic;
mod symmetry;
mod walk;

pub use cells::Cells;
pub use isotropic::isotropic_trees;

use crate::{Glazing, Lobes, Side, TreeWriter};
use column::{Column, Sums};
use hemisphere::{Direction, Vec3};
use rayon::prelude::*;

/// How closely to average.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Averaging {
    /// A column has settled when quartering the parts of its cell changes it by less than this: the sum of absolute differences as a
    /// share of its light.
    pub tolerance: f64,
    /// How often a part of a cell is quartered at most; each has 3 places along both coordinates.
    pub levels: u32,
    /// Random draws for each incident cell of an element without exact lobes.
    pub draws: u32,
    /// Seed of the draws.
    pub seed: u64,
}

impl Default for Averaging {
    fn default() -> Self {
        Self { tolerance: 1e-3, levels: 4, draws: 20_000, seed: 0 }
    }
}

/// The ports of an element: each cell of the front, then each of the back.
#[derive(Clone, Debug)]
pub(crate) struct Ports {
    cells: Cells,
}

impl Ports {
    fn count(&self) -> usize {
        2 * self.cells.count()
    }

    /// The sign of z of light that arrives through a port, and its cell.
    fn parts(&self, port: usize) -> (f64, usize) {
        let count = self.cells.count();
        if port < count { (1.0, port) } else { (-1.0, port - count) }
    }

    /// The port that light which leaves along (x, y) with this sign of z would arrive through if it came back.
    #[inline]
    fn returning(&self, z: f64, [x, y]: [f64; 2]) -> usize {
        let cell = self.cells.find(-x, -y);
        if z > 0.0 { self.cells.count() + cell } else { cell }
    }
}

/// Light exchanged between all cells of both sides: symmetric, with the sums that the energy account demands.
#[derive(Clone, Debug)]
pub struct Exchange {
    ports: Ports,
    rows: balance::Rows,
    variances: balance::Rows,
    /// Share of the light of each port that is absorbed, those of the front first.
    pub absorbed: Vec<f64>,
    /// Share not followed to its end, at its greatest; it is taken to go where the rest goes.
    pub residual: f64,
    /// What the last refinement changed in any column: the sum of absolute differences as a share of its light.
    pub change: f64,
    /// Greatest difference between a column and the same exchange found from the light's other end.
    pub asymmetry: f64,
    /// Greatest factor less 1 that closing the energy account took, twice.
    pub correction: f64,
    /// Greatest difference between `absorbed`, which closes the account of the blocks, and what was found absorbed.
    pub misfit: f64,
    /// Draws for each column, if it was found by random draws.
    pub draws: Option<u32>,
}

/// One of the four blocks.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Way {
    /// Leaves by the other side.
    Transmission,
    /// Leaves by the side it came from.
    Reflection,
}

impl Exchange {
    /// Averages what an element does over cells of directions (theory/bsdf_averaging.md, eqs. 5–9). An element that has exact lobes is
    /// solved by quadrature, any other by random draws.
    pub fn of(glazing: &dyn Glazing, cells: Cells, how: &Averaging) -> Self {
        let ports = Ports { cells };
        let count = ports.count();
        let exact = has_lobes(glazing);
        // draws are left independent of each other
        let images = if exact { symmetry::symmetries(glazing) } else { vec![Vec3::ONE] };
        let is_first = |&port: &usize| images.iter().all(|&signs| port <= ports.mirrored(port, signs));
        let chosen: Vec<usize> = (0..count).filter(is_first).collect();
        let one = |sums: &mut Sums, &port: &usize| {
            if exact {
                column::column(glazing, &ports, port, how, sums)
            } else {
                walk::column(glazing, &ports, port, how, sums)
            }
        };
        let solved: Vec<Column> = chosen.par_iter().map_init(|| Sums::new(count), one).collect();
        let mut columns = vec![Column::default(); count];
        for (&port, column) in chosen.iter().zip(solved) {
            for &signs in &images[1..] {
                columns[ports.mirrored(port, signs)] = column.mirrored(&ports, signs);
            }
            columns[port] = column;
        }
        let sizes: Vec<f64> = (0..count).map(|p| ports.cells.size(ports.parts(p).1)).collect();
        let largest = |of: fn(&Column) -> f64| columns.iter().map(of).fold(0.0, f64::max);
        let (residual, change) = (largest(|c| c.residual), largest(|c| c.change));
        // what was not followed goes where the rest goes
        let absorbed: Vec<f64> = columns.iter().map(|c| c.absorbed / (1.0 - c.residual)).collect();
        let square = |(c, size): (&Column, &f64)| -> Vec<(u32, f64)> {
            c.variance.iter().map(|&(p, variance)| (p, variance * size * size)).collect()
        };
        let (mut variances, _) = balance::symmetric(&columns.iter().zip(&sizes).map(square).collect(), &sizes);
        // the mean of two independent finds has half the mean of their variances
        let halved = |(a, row): (usize, &mut Vec<(u32, f64)>)| {
            row.iter_mut().for_each(|(b, v)| *v *= if *b as usize == a { 1.0 } else { 0.5 });
        };
        variances.iter_mut().enumerate().for_each(halved);
        let part = |(c, size): (Column, &f64)| -> Vec<(u32, f64)> {
            c.sent.iter().map(|&(p, share)| (p, share * size / (1.0 - c.residual))).collect()
        };
        let rows: balance::Rows = columns.into_iter().zip(&sizes).map(part).collect();
        let (mut rows, asymmetry) = balance::symmetric(&rows, &sizes);
        let sums: Vec<f64> = sizes.iter().zip(&absorbed).map(|(size, a)| size * (1.0 - a)).collect();
        let correction = balance::balance(&mut rows, &sums);
        let left = |row: &[(u32, f64)], size: f64| 1.0 - row.iter().map(|e| e.1).sum::<f64>() / size;
        let kept: Vec<f64> = rows.iter().zip(&sizes).map(|(row, &size)| left(row, size)).collect();
        let misfit = kept.iter().zip(&absorbed).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        let draws = (!exact).then_some(how.draws);
        let change = if exact { change } else { 0.0 };
        Self { ports, rows, variances, absorbed: kept, residual, change, asymmetry, correction, misfit, draws }
    }

    /// The cells of either side.
    pub fn cells(&self) -> &Cells {
        &self.ports.cells
    }

    /// Every value other than 0 of a block as (outgoing cell, incident cell, value [1/sr]).
    pub fn block(&self, side: Side, way: Way) -> impl Iterator<Item = (usize, usize, f64)> + '_ {
        self.entries(&self.rows, side, way).map(|(o, i, value)| {
            let sizes = self.cells().size(i) * self.cells().size(o);
            (o, i, value / sizes)
        })
    }

    fn entries<'a>(
        &'a self,
        rows: &'a balance::Rows,
        side: Side,
        way: Way,
    ) -> impl Iterator<Item = (usize, usize, f64)> + 'a {
        let count = self.cells().count();
        let arrives = if side == Side::Front { 0 } else { count };
        // light leaves by the ports of the side it could come back from
        let leaves = if (side == Side::Front) == (way == Way::Transmission) { count } else { 0 };
        (0..count).flat_map(move |i| {
            rows[arrives + i].iter().filter_map(move |&(port, value)| {
                let cell = (port as usize).checked_sub(leaves).filter(|&c| c < count)?;
                (value > 0.0).then(|| (self.cells().turned(cell), i, value))
            })
        })
    }

    /// A block as a dense table, `values[o * cells + i]` [1/sr].
    pub fn table(&self, side: Side, way: Way) -> Vec<f64> {
        let count = self.cells().count();
        let mut values = vec![0.0; count * count];
        self.block(side, way).for_each(|(o, i, value)| values[o * count + i] = value);
        values
    }

    /// Standard errors of a block's table [1/sr] if it was found by random draws (theory/bsdf_averaging.md, eq. 10). Where no draw
    /// fell it is that of less than one draw.
    pub fn standard_error(&self, side: Side, way: Way) -> Option<Vec<f64>> {
        let draws = f64::from(self.draws?);
        let (cells, count) = (self.cells(), self.cells().count());
        let mut errors: Vec<f64> = (0..count * count).map(|at| 1.0 / draws / cells.size(at / count)).collect();
        for (o, i, variance) in self.entries(&self.variances, side, way) {
            errors[o * count + i] = variance.sqrt() / (cells.size(i) * cells.size(o));
        }
        Some(errors)
    }

    /// A block as the preorder walk of a tensor tree of rank 4; of a grid alone. Children that differ by no more than the share
    /// `merged` of the greatest of them are one leaf.
    pub fn tree(&self, side: Side, way: Way, merged: f64) -> Option<Vec<f64>> {
        let Cells::Grid(depth) = *self.cells() else { return None };
        let mut writer = TreeWriter::new(4, depth);
        let grid = 1_usize << depth;
        for (o, i, value) in self.block(side, way) {
            writer.set(&[i % grid, i / grid, o % grid, o / grid], value);
        }
        Some(writer.preorder(merged))
    }
}

/// Share of the light that may go other than in beams for an element to count as having lobes.
const STRAY: f64 = 1e-3;

/// Whether all light of the element leaves in beams, judged by a few directions.
pub fn has_lobes(glazing: &dyn Glazing) -> bool {
    let mut lobes = Lobes::default();
    let places = [[0.0, 0.0], [0.5, 0.1], [-0.2, 0.6], [0.3, -0.5], [-0.8, -0.4]];
    places.iter().flat_map(|&[x, y]| [1.0, -1.0].map(|side| (x, y, side))).all(|(x, y, side)| {
        let z = side * f64::sqrt(1.0 - x * x - y * y);
        Direction::of(Vec3::new(x, y, z)).is_some_and(|incident| {
            glazing.lobes(incident, &mut lobes);
            lobes.residual + lobes.spread + lobes.walked < STRAY
        })
    })
}

#[cfg(test)]
mod tests;
