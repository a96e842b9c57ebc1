//! From a tree of two branches a node to one of eight, with four triangles a leaf: fewer and fuller steps for a ray.

use super::quad::Quad;
use glam::{Vec3A, Vec4};
use obvhs::aabb::Aabb;
use obvhs::bvh2::{Bvh2, reinsertion::ReinsertionOptimizer};
use obvhs::ploc::{PlocBuilder, PlocSearchDistance, SortPrecision};

/// Children of a node.
pub const BRANCHES: usize = 8;
/// Triangles of a leaf.
pub const LEAF_SIZE: usize = 4;
/// What tells the number of a leaf from that of a node.
pub const LEAF: u32 = 1 << 31;

/// What a step into a node and into a leaf takes, for the tree that is cheapest on average.
const COST_OF_NODE: f32 = 1.0;
const COST_OF_LEAF: f32 = 1.2;

/// Nodes compared for merging on either side, the depth from which only neighbours are, and the share of nodes tried elsewhere:
/// some 70 % more time to build than by habit; what it saves in tracing is within the noise of a shared machine.
const SEARCH: PlocSearchDistance = PlocSearchDistance::High;
const SEARCH_DEPTH: usize = 3;
const REINSERTED: f32 = 0.3;

/// Eight boxes and where each leads.
#[repr(align(64))]
#[derive(Clone)]
pub struct Node {
    /// Lower x, y, z, then upper x, y, z, of four boxes each.
    pub planes: [[Vec4; 2]; 6],
    /// The number of a node, or with [`LEAF`] of a leaf.
    pub children: [u32; BRANCHES],
}

impl Node {
    /// No box: from +∞ to −∞.
    fn empty() -> Self {
        let (low, high) = ([Vec4::INFINITY; 2], [Vec4::NEG_INFINITY; 2]);
        Self { planes: [low, low, low, high, high, high], children: [LEAF; BRANCHES] }
    }
}

/// The tree: node 0 is its root.
pub struct Tree {
    pub nodes: Vec<Node>,
    pub leaves: Vec<Quad>,
    /// Which triangle each lane of each leaf holds, as they were given; four to a leaf.
    pub order: Vec<u32>,
    /// Nodes on the longest way down.
    pub depth: usize,
}

impl Tree {
    /// Of triangles, in boxes wider by a margin.
    pub fn new(triangles: &[[Vec3A; 3]], margin: f32) -> Self {
        let boxes: Vec<Aabb> = triangles
            .iter()
            .map(|corners| {
                let tight = Aabb::from_points(corners);
                Aabb::new(tight.min - margin, tight.max + margin)
            })
            .collect();
        let all = (0..boxes.len() as u32).collect();
        let mut two =
            PlocBuilder::with_capacity(boxes.len()).build(SEARCH, &boxes, all, SortPrecision::U64, SEARCH_DEPTH);
        ReinsertionOptimizer::default().run(&mut two, REINSERTED, None);
        let plan = Plan::of(&two);
        let mut tree = Self { nodes: vec![Node::empty()], leaves: Vec::new(), order: Vec::new(), depth: 0 };
        // nodes to be filled: where, from which node of the tree of two, how deep
        let mut open = vec![(0, 0, 1)];
        while let Some((at, from, depth)) = open.pop() {
            tree.depth = tree.depth.max(depth);
            let mut node = Node::empty();
            for (lane, child) in plan.children(&two, from).into_iter().enumerate() {
                let bounds = two.nodes[child].aabb();
                for axis in 0..3 {
                    node.planes[axis][lane / 4][lane % 4] = bounds.min[axis];
                    node.planes[3 + axis][lane / 4][lane % 4] = bounds.max[axis];
                }
                node.children[lane] = if plan.is_leaf[child] {
                    let own = below(&two, child);
                    tree.leaves.push(Quad::new(&own.iter().map(|&k| triangles[k as usize]).collect::<Vec<_>>()));
                    tree.order.extend((0..LEAF_SIZE).map(|lane| own[lane.min(own.len() - 1)]));
                    LEAF | (tree.leaves.len() - 1) as u32
                } else {
                    tree.nodes.push(Node::empty());
                    open.push((tree.nodes.len() - 1, child, depth + 1));
                    (tree.nodes.len() - 1) as u32
                };
            }
            tree.nodes[at] = node;
        }
        tree
    }
}

/// Which nodes of the tree of two to keep (H. Ylitie, T. Karras, S. Laine, HPG 2017, §3.1).
struct Plan {
    /// The least cost of what is below a node as one to seven trees.
    cost: Vec<[f32; BRANCHES - 1]>,
    is_leaf: Vec<bool>,
}

impl Plan {
    fn of(two: &Bvh2) -> Self {
        let count = two.nodes.len();
        let mut plan = Self { cost: vec![[f32::INFINITY; BRANCHES - 1]; count], is_leaf: vec![false; count] };
        let mut triangles = vec![0; count];
        for k in upwards(two) {
            let node = &two.nodes[k];
            let area = node.aabb().half_area();
            if node.is_leaf() {
                triangles[k] = node.prim_count as usize;
                plan.is_leaf[k] = true;
                plan.cost[k] = [COST_OF_LEAF * area; BRANCHES - 1];
                continue;
            }
            let first = node.first_index as usize;
            triangles[k] = triangles[first] + triangles[first + 1];
            let inner = plan.shared(first, BRANCHES).0 + COST_OF_NODE * area;
            let leaf = COST_OF_LEAF * area;
            // the root is a node whatever it holds
            plan.is_leaf[k] = k != 0 && triangles[k] <= LEAF_SIZE && leaf <= inner;
            plan.cost[k][0] = if plan.is_leaf[k] { leaf } else { inner };
            for trees in 2..BRANCHES {
                plan.cost[k][trees - 1] = plan.cost[k][trees - 2].min(plan.shared(first, trees).0);
            }
        }
        plan
    }

    /// The least cost of two siblings as so many trees, and how many of them are the first's.
    fn shared(&self, first: usize, trees: usize) -> (f32, usize) {
        (1..trees)
            .map(|k| (self.cost[first][k - 1] + self.cost[first + 1][trees - k - 1], k))
            .fold((f32::INFINITY, 1), |best, found| if found.0 < best.0 { found } else { best })
    }

    /// The children of a node of eight that stands for `from`.
    fn children(&self, two: &Bvh2, from: usize) -> Vec<usize> {
        if two.nodes[from].is_leaf() {
            return vec![from];
        }
        let mut children = Vec::new();
        // what is below these is to become so many trees
        let mut open = vec![(from, BRANCHES)];
        while let Some((k, trees)) = open.pop() {
            let first = two.nodes[k].first_index as usize;
            let firsts = self.shared(first, trees).1;
            for (child, trees) in [(first, firsts), (first + 1, trees - firsts)] {
                let cost = &self.cost[child];
                // one tree where more are no cheaper
                if self.is_leaf[child] || cost[trees - 1] >= cost[0] {
                    children.push(child);
                } else {
                    open.push((child, trees));
                }
            }
        }
        children
    }
}

/// Every node after those below it.
fn upwards(two: &Bvh2) -> Vec<usize> {
    let mut order = vec![0];
    let mut next = 0;
    while let Some(node) = order.get(next).map(|&k| &two.nodes[k]) {
        if !node.is_leaf() {
            order.extend([node.first_index as usize, node.first_index as usize + 1]);
        }
        next += 1;
    }
    order.reverse();
    order
}

/// The triangles below a node.
fn below(two: &Bvh2, k: usize) -> Vec<u32> {
    let node = &two.nodes[k];
    let first = node.first_index as usize;
    if node.is_leaf() {
        return two.primitive_indices[first..first + node.prim_count as usize].to_vec();
    }
    [below(two, first), below(two, first + 1)].concat()
}
