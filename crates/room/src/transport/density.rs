//! How densely shared points lie on the surfaces, cell by cell and side by side.

use crate::scene::Scene;
use hemisphere::Vec3;

/// Every surface cut into cells of equal area.
#[derive(Clone)]
pub struct Cells {
    grids: Vec<Grid>,
    count: usize,
}

/// The cells of one surface: equal pieces of the unit square that its points are made from.
#[derive(Clone, Copy)]
struct Grid {
    first: usize,
    across: [usize; 2],
}

/// The most cells of one surface.
const MOST: f64 = 64.0;

impl Cells {
    /// About `shares[k] * cells` on surface k, as near to squares as may be.
    pub fn new(scene: &Scene, shares: &[f64], cells: f64) -> Self {
        let mut count = 0;
        let grid = |(surface, share): (usize, &f64)| {
            let wanted = (share * cells).clamp(1.0, MOST);
            let point = |u| scene.point_on(surface as u32, u).1;
            let length = |from, to| (point(to) - point(from)).length();
            let [along, up] = [length([0.0, 0.5], [1.0 - 1e-9, 0.5]), length([0.5, 0.0], [0.5, 1.0 - 1e-9])];
            let columns = (wanted * along / up).sqrt();
            let columns = if columns.is_finite() { columns.round().clamp(1.0, wanted) } else { 1.0 };
            let across = [columns as usize, (wanted / columns).round().max(1.0) as usize];
            let first = count;
            count += across[0] * across[1];
            Grid { first, across }
        };
        let grids = shares.iter().enumerate().map(grid).collect();
        Self { grids, count }
    }

    /// How many, each with two sides.
    pub fn count(&self) -> usize {
        self.count
    }

    /// Surface and number of every cell.
    pub fn each(&self) -> impl Iterator<Item = (u32, usize)> + '_ {
        self.grids.iter().enumerate().flat_map(|(surface, grid)| {
            (0..grid.across[0] * grid.across[1]).map(move |c| (surface as u32, grid.first + c))
        })
    }

    /// The cell that a point of a facet lies in.
    #[inline]
    pub fn of(&self, scene: &Scene, facet: u32, point: Vec3) -> usize {
        let Grid { first, across: [columns, rows] } = self.grids[scene.facet(facet).surface as usize];
        if columns * rows == 1 {
            return first;
        }
        let [u, v] = scene.coordinates(facet, point);
        let place = |u: f64, n: usize| ((u * n as f64) as usize).min(n - 1);
        first + place(v, rows) * columns + place(u, columns)
    }

    /// The facet and the point of a cell that `u`, uniform in the unit square, makes.
    #[inline]
    pub fn point(&self, scene: &Scene, surface: u32, cell: usize, u: [f64; 2]) -> (u32, Vec3) {
        let Grid { first, across: [columns, rows] } = self.grids[surface as usize];
        let (column, row) = ((cell - first) % columns, (cell - first) / columns);
        let u = [(column as f64 + u[0]) / columns as f64, (row as f64 + u[1]) / rows as f64];
        scene.point_on(surface, u)
    }

    /// Area of a surface's cells \[m²\].
    pub fn area(&self, scene: &Scene, surface: u32) -> f64 {
        let Grid { across: [columns, rows], .. } = self.grids[surface as usize];
        scene.surfaces[surface as usize].area / (columns * rows) as f64
    }
}

/// How densely nodes lie on each side of each cell.
#[derive(Clone)]
pub struct NodeDensity {
    cells: Cells,
    /// Nodes per m², back and front of each cell.
    per_m2: Vec<[f64; 2]>,
    choices: Vec<Choice>,
}

#[derive(Clone, Copy)]
struct Choice {
    surface: u32,
    front: bool,
    cell: usize,
    /// Probability up to and with it.
    up_to_here: f64,
}

/// A place for a node.
pub struct Picked {
    /// The facet.
    pub facet: u32,
    /// Where.
    pub point: Vec3,
    /// Whether on its front.
    pub front: bool,
    /// Nodes per m² there.
    pub per_m2: f64,
}

impl NodeDensity {
    /// Spreads `nodes` in proportion to `weight` of the back and front of each cell.
    pub fn new(scene: &Scene, cells: &Cells, nodes: f64, weight: &[[f64; 2]]) -> Self {
        let sum: f64 = weight.iter().flatten().sum();
        let (mut per_m2, mut choices) = (vec![[0.0; 2]; cells.count()], Vec::new());
        let mut up_to_here = 0.0;
        for (surface, cell) in cells.each() {
            for (side, w) in weight[cell].iter().enumerate().filter(|(_, w)| **w > 0.0) {
                up_to_here += w / sum;
                choices.push(Choice { surface, front: side == 1, cell, up_to_here });
                per_m2[cell][side] = nodes * w / sum / cells.area(scene, surface);
            }
        }
        Self { cells: cells.clone(), per_m2, choices }
    }

    /// The same for so many times the nodes.
    pub fn times(&self, factor: f64) -> Self {
        let per_m2 = self.per_m2.iter().map(|sides| sides.map(|n| factor * n)).collect();
        Self { per_m2, ..self.clone() }
    }

    /// Nodes per m² at a point of a side of a facet.
    #[inline]
    pub fn per_m2(&self, scene: &Scene, facet: u32, point: Vec3, front: bool) -> f64 {
        self.per_m2[self.cells.of(scene, facet, point)][usize::from(front)]
    }

    /// Whether there is any surface to put nodes on.
    pub fn is_empty(&self) -> bool {
        self.choices.is_empty()
    }

    /// The place that `u`, uniform in the unit square, picks; near `u` pick near places.
    pub fn pick(&self, scene: &Scene, u: [f64; 2]) -> Picked {
        let i = self.choices.partition_point(|c| c.up_to_here <= u[0]).min(self.choices.len() - 1);
        let before = if i == 0 { 0.0 } else { self.choices[i - 1].up_to_here };
        let Choice { surface, front, cell, up_to_here } = self.choices[i];
        let rest = ((u[0] - before) / (up_to_here - before)).clamp(0.0, 1.0 - f64::EPSILON);
        let (facet, point) = self.cells.point(scene, surface, cell, [rest, u[1]]);
        Picked { facet, point, front, per_m2: self.per_m2[cell][usize::from(front)] }
    }
}
