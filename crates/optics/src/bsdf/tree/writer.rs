//! A tree grown from what is not zero alone: the full grid of four coordinates is never held.

/// Values of the finest cells, in any order, that become the preorder walk of a tree.
#[derive(Clone, Debug)]
pub struct TreeWriter {
    rank: usize,
    depth: u32,
    /// Number of the cell, the first halving highest, and its value [1/sr].
    cells: Vec<(u64, f64)>,
}

impl TreeWriter {
    /// A tree of this rank, 2^`depth` finest cells along each coordinate.
    pub fn new(rank: usize, depth: u32) -> Self {
        Self { rank, depth, cells: Vec::new() }
    }

    /// Gives the cell at these places along each coordinate its value [1/sr]; each cell once.
    pub fn set(&mut self, places: &[usize], value: f64) {
        let mut number = 0_u64;
        for bit in (0..self.depth).rev() {
            for &place in places.iter().rev() {
                number = number << 1 | (place >> bit & 1) as u64;
            }
        }
        self.cells.push((number, value));
    }

    /// The preorder walk: NaN for an inner node whose children follow, else the value of a leaf. Children that differ by no more
    /// than the share `merged` of the greatest of them become one leaf of their mean.
    pub fn preorder(mut self, merged: f64) -> Vec<f64> {
        self.cells.sort_unstable_by_key(|&(number, _)| number);
        let mut walk = Vec::new();
        self.grow(&self.cells, 0, merged, &mut walk);
        walk
    }

    fn grow(&self, cells: &[(u64, f64)], level: u32, merged: f64, walk: &mut Vec<f64>) {
        if cells.is_empty() || level == self.depth {
            walk.push(cells.first().map_or(0.0, |&(_, value)| value));
            return;
        }
        let start = walk.len();
        walk.push(f64::NAN);
        let shift = (self.depth - level - 1) * self.rank as u32;
        let children = 1_u64 << self.rank;
        let mut rest = cells;
        for child in 0..children {
            let (own, others) = rest.split_at(rest.partition_point(|&(n, _)| (n >> shift & (children - 1)) <= child));
            self.grow(own, level + 1, merged, walk);
            rest = others;
        }
        let leaves = &walk[start + 1..];
        if leaves.len() == children as usize {
            // a NaN among them would be an inner node, but then there were more
            let (least, most) = leaves.iter().fold((f64::INFINITY, 0.0_f64), |(l, m), &v| (l.min(v), m.max(v)));
            if most - least <= merged * most {
                let mean = leaves.iter().sum::<f64>() / children as f64;
                walk.truncate(start);
                walk.push(mean);
            }
        }
    }
}
