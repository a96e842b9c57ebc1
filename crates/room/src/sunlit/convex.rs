//! Convex polygons, cut and subtracted: shadows of beams, of patches and of mirrors are all found by these.

use glam::DVec2;
use std::ops::{Add, Mul, Sub};

/// Corners in a plane, in order.
pub type Polygon = Vec<DVec2>;

/// Corners closer to a cutting line than this lie on it, and pieces smaller than its square are none.
pub const NEAR: f64 = 1e-9;

/// The part of a convex polygon where `height`, linear over it, is at least 0; empty if that is no more than an edge
/// (I. E. Sutherland, G. W. Hodgman, Commun. ACM 17(1), 1974).
pub fn cut<P>(polygon: &[P], height: impl Fn(P) -> f64) -> Vec<P>
where
    P: Copy + Add<Output = P> + Sub<Output = P> + Mul<f64, Output = P>,
{
    let heights: Vec<f64> = polygon.iter().map(|&corner| height(corner)).collect();
    if heights.iter().all(|&h| h >= -NEAR) {
        return polygon.to_vec();
    }
    if heights.iter().all(|&h| h <= NEAR) {
        return Vec::new();
    }
    let mut kept = Vec::with_capacity(polygon.len() + 1);
    let mut before = polygon.len() - 1;
    for here in 0..polygon.len() {
        let (low, high) = (heights[before], heights[here]);
        if (low > NEAR && high < -NEAR) || (low < -NEAR && high > NEAR) {
            kept.push(polygon[before] + (polygon[here] - polygon[before]) * (low / (low - high)));
        }
        if high >= -NEAR {
            kept.push(polygon[here]);
        }
        before = here;
    }
    if kept.len() > 2 { kept } else { Vec::new() }
}

/// A line through a plane: so far inside of it, along `inwards`, is a point.
#[derive(Clone, Copy)]
struct Edge {
    inwards: DVec2,
    offset: f64,
}

impl Edge {
    fn depth(self, point: DVec2) -> f64 {
        self.inwards.dot(point) - self.offset
    }
}

/// The edges of a polygon that runs anticlockwise.
fn edges(polygon: &[DVec2]) -> impl Iterator<Item = Edge> + '_ {
    let last = polygon.last().copied().into_iter();
    last.chain(polygon.iter().copied()).zip(polygon).filter_map(|(before, &here)| {
        let along = here - before;
        let length = along.length();
        (length > NEAR).then(|| {
            let inwards = along.perp() / length;
            Edge { inwards, offset: inwards.dot(before) }
        })
    })
}

/// What two convex polygons that run anticlockwise share.
pub fn shared(polygon: &[DVec2], other: &[DVec2]) -> Polygon {
    let mut around = edges(other).peekable();
    // what is no more than a point has no edges
    if around.peek().is_none() || apart(polygon, other) {
        return Vec::new();
    }
    let mut found = polygon.to_vec();
    for edge in around {
        found = cut(&found, |point| edge.depth(point));
        if found.is_empty() {
            break;
        }
    }
    found
}

/// Convex pieces less a convex polygon, all anticlockwise: convex pieces again.
pub fn without(pieces: Vec<Polygon>, other: &[DVec2]) -> Vec<Polygon> {
    let mut left = Vec::with_capacity(pieces.len());
    for piece in pieces {
        if shared(&piece, other).is_empty() {
            left.push(piece);
            continue;
        }
        let mut rest = piece;
        for edge in edges(other) {
            let outside = cut(&rest, |point| -edge.depth(point));
            if !outside.is_empty() {
                left.push(outside);
            }
            rest = cut(&rest, |point| edge.depth(point));
            if rest.is_empty() {
                break;
            }
        }
    }
    left
}

/// Whether the boxes about two polygons share no area.
fn apart(polygon: &[DVec2], other: &[DVec2]) -> bool {
    let ([low, high], [other_low, other_high]) = (bounds(polygon), bounds(other));
    high.cmple(other_low + NEAR).any() || other_high.cmple(low + NEAR).any()
}

/// Least and greatest coordinates.
pub fn bounds(points: &[DVec2]) -> [DVec2; 2] {
    points.iter().fold([DVec2::INFINITY, DVec2::NEG_INFINITY], |[low, high], &p| [low.min(p), high.max(p)])
}

/// Positive for one that runs anticlockwise.
pub fn area(polygon: &[DVec2]) -> f64 {
    let Some(&first) = polygon.first() else { return 0.0 };
    0.5 * polygon.windows(2).map(|pair| (pair[0] - first).perp_dot(pair[1] - first)).sum::<f64>()
}

/// The same corners, anticlockwise.
pub fn anticlockwise(mut polygon: Polygon) -> Polygon {
    if area(&polygon) < 0.0 {
        polygon.reverse();
    }
    polygon
}

/// Whether a polygon that runs anticlockwise turns one way only, and once.
pub fn is_convex(polygon: &[DVec2]) -> bool {
    let count = polygon.len();
    let steps: Vec<DVec2> = (0..count).map(|k| polygon[(k + 1) % count] - polygon[k]).collect();
    let longest = steps.iter().map(|step| step.length()).fold(0.0, f64::max);
    let turns = (0..count).map(|k| (steps[k], steps[(k + 1) % count]));
    let whole: f64 = turns.clone().map(|(a, b)| a.perp_dot(b).atan2(a.dot(b))).sum();
    turns.clone().all(|(a, b)| a.perp_dot(b) >= -1e-9 * longest * longest)
        && (whole - std::f64::consts::TAU).abs() < 1e-6
}

#[cfg(test)]
mod tests {
    use super::*;
    use hemisphere::Rng;

    fn rectangle(low: [f64; 2], high: [f64; 2]) -> Polygon {
        [[low[0], low[1]], [high[0], low[1]], high, [low[0], high[1]]].map(DVec2::from_array).to_vec()
    }

    fn triangle(rng: &mut Rng) -> Polygon {
        anticlockwise((0..3).map(|_| DVec2::new(rng.uniform(), rng.uniform())).collect())
    }

    /// What is left and what is shared make up the whole, and no point lies in both.
    #[test]
    fn a_piece_is_what_is_shared_and_what_is_left() {
        let mut rng = Rng::new(4, 0);
        for _ in 0..500 {
            let (piece, other) = (triangle(&mut rng), triangle(&mut rng));
            let both = shared(&piece, &other);
            let left = without(vec![piece.clone()], &other);
            let sum = area(&both) + left.iter().map(|one| area(one)).sum::<f64>();
            assert!((sum - area(&piece)).abs() < 1e-9);
            assert!(left.iter().all(|one| area(one) > 0.0 && area(&shared(one, &other)) < 1e-8));
        }
    }

    /// A window in the middle of a wall leaves a frame; one beside it, or only touching, leaves all.
    #[test]
    fn a_hole_leaves_its_frame() {
        let wall = rectangle([0.0, 0.0], [4.0, 3.0]);
        let frame = without(vec![wall.clone()], &rectangle([1.0, 1.0], [3.0, 2.0]));
        assert!((frame.iter().map(|one| area(one)).sum::<f64>() - 10.0).abs() < 1e-12);
        assert_eq!(without(vec![wall.clone()], &rectangle([4.0, 0.0], [5.0, 3.0])), vec![wall.clone()]);
        assert!(without(vec![wall.clone()], &rectangle([-1.0, -1.0], [5.0, 4.0])).is_empty());
    }

    /// A square turns once; an arrowhead turns back; a pentagram turns twice.
    #[test]
    fn convex_is_one_turn() {
        assert!(is_convex(&rectangle([0.0, 0.0], [1.0, 2.0])));
        let arrow = [[0.0, 0.0], [2.0, 1.0], [0.0, 2.0], [1.0, 1.0]].map(DVec2::from_array);
        let star: Polygon = (0..5).map(|k| DVec2::from_angle(f64::from(2 * k) * std::f64::consts::TAU / 5.0)).collect();
        assert!(!is_convex(&arrow) && !is_convex(&star));
    }
}
