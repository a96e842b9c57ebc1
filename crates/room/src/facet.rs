//! One flat piece of a surface, as rays meet it.

use crate::outline::Outline;
use crate::sunlit::convex::{anticlockwise, is_convex};
use glam::DVec2;
use hemisphere::{Direction, Vec3};

/// A flat piece: where its plane is, how to tell whether a point of the plane is in it, how to draw points on it.
#[derive(Clone, Debug)]
pub struct Facet {
    /// Unit normal; the front is the side it points to.
    pub normal: Vec3,
    /// The plane is normal · p = offset.
    pub offset: f64,
    /// Area \[m²\].
    pub area: f64,
    /// Which surface it belongs to.
    pub surface: u32,
    shape: Shape,
}

#[derive(Clone, Debug)]
enum Shape {
    /// Corner, two edges, and the vectors that measure a point along each edge, 0..1.
    Parallelogram(Corner),
    Triangle(Corner),
    Polygon {
        outline: Outline,
        pieces: Vec<Piece>,
    },
}

#[derive(Clone, Copy, Debug)]
struct Corner {
    origin: Vec3,
    edges: [Vec3; 2],
    duals: [Vec3; 2],
}

/// A triangle of a polygon and the share of the area up to and with it.
#[derive(Clone, Debug)]
struct Piece {
    corners: [Vec3; 3],
    area_to_here: f64,
}

/// How far past its edge a facet still stops rays, in shares of its size, so that none slips between neighbours.
pub const RIM: f64 = 1e-9;

impl Corner {
    /// `None` if the edges are parallel.
    fn of(origin: Vec3, edges: [Vec3; 2]) -> Option<(Self, Direction, f64)> {
        let [a, b] = edges;
        let cross = a.cross(b);
        let normal = Direction::of(cross)?;
        let n2 = cross.length_squared();
        let duals = [b.cross(cross) / n2, cross.cross(a) / n2];
        duals.iter().all(|d| d.is_finite()).then(|| (Self { origin, edges, duals }, normal, n2.sqrt()))
    }

    #[inline]
    fn place(&self, p: Vec3) -> [f64; 2] {
        let d = p - self.origin;
        self.duals.map(|dual| d.dot(dual))
    }
}

impl Facet {
    /// A triangle; `None` if it has no area.
    pub fn triangle(corners: [Vec3; 3], surface: u32) -> Option<Self> {
        let [o, a, b] = corners;
        let (corner, normal, area2) = Corner::of(o, [a - o, b - o])?;
        Some(Self {
            normal: *normal,
            offset: normal.dot(o),
            area: 0.5 * area2,
            surface,
            shape: Shape::Triangle(corner),
        })
    }

    /// A checked polygon.
    pub fn polygon(outline: &Outline, surface: u32) -> Self {
        let normal = outline.frame.z;
        let vertices = outline.vertices();
        let shape = parallelogram(outline, &vertices).unwrap_or_else(|| {
            let mut area_to_here = 0.0;
            let pieces = outline.triangles().into_iter().map(|t| {
                let corners = t.map(|p| outline.lift(p));
                area_to_here += 0.5 * (corners[1] - corners[0]).cross(corners[2] - corners[0]).length();
                Piece { corners, area_to_here }
            });
            let pieces = pieces.collect();
            Shape::Polygon { outline: outline.clone(), pieces }
        });
        Self { normal, offset: normal.dot(outline.origin), area: outline.area(), surface, shape }
    }

    /// Whether a point of its plane lies in it.
    #[inline]
    pub fn holds(&self, p: Vec3) -> bool {
        match &self.shape {
            Shape::Parallelogram(corner) => corner.place(p).iter().all(|s| (-RIM..=1.0 + RIM).contains(s)),
            Shape::Triangle(corner) => {
                let [s, t] = corner.place(p);
                s >= -RIM && t >= -RIM && s + t <= 1.0 + RIM
            }
            Shape::Polygon { outline, .. } => outline.holds(outline.flatten(p)),
        }
    }

    /// For a triangle, the vectors and offsets that measure a point along its two edges, 0..1.
    pub fn triangle_measures(&self) -> Option<[(Vec3, f64); 2]> {
        match &self.shape {
            Shape::Triangle(corner) => Some(corner.duals.map(|dual| (dual, dual.dot(corner.origin)))),
            _ => None,
        }
    }

    /// A point on it, uniform over its area for `u` uniform in the unit square; near `u` give near points.
    pub fn point(&self, u: [f64; 2]) -> Vec3 {
        match &self.shape {
            Shape::Parallelogram(Corner { origin, edges, .. }) => *origin + u[0] * edges[0] + u[1] * edges[1],
            Shape::Triangle(Corner { origin, edges, .. }) => {
                let [s, t] = fold(u);
                *origin + s * edges[0] + t * edges[1]
            }
            Shape::Polygon { pieces, .. } => {
                let whole = pieces.last().map_or(0.0, |p| p.area_to_here);
                let target = u[0] * whole;
                let i = pieces.partition_point(|p| p.area_to_here <= target).min(pieces.len() - 1);
                let before = if i == 0 { 0.0 } else { pieces[i - 1].area_to_here };
                let [s, t] = fold([(target - before) / (pieces[i].area_to_here - before), u[1]]);
                let [o, a, b] = pieces[i].corners;
                o + s * (a - o) + t * (b - o)
            }
        }
    }

    /// What [`Self::point`] makes a point of the facet from.
    pub fn coordinates(&self, p: Vec3) -> [f64; 2] {
        match &self.shape {
            Shape::Parallelogram(corner) => corner.place(p),
            Shape::Triangle(corner) => unfold(corner.place(p)),
            Shape::Polygon { pieces, .. } => {
                let whole = pieces.last().map_or(0.0, |piece| piece.area_to_here);
                let places = pieces.iter().map(|piece| {
                    let [o, a, b] = piece.corners;
                    let [s, t] = Corner::of(o, [a - o, b - o]).map_or([-1.0; 2], |(corner, ..)| corner.place(p));
                    ([s, t], s.min(t).min(1.0 - s - t))
                });
                // rounding may put a point on an edge outside of both its triangles: take the nearest
                let best = places.enumerate().max_by(|(_, a), (_, b)| a.1.total_cmp(&b.1));
                let Some((i, (place, _))) = best else { return [0.0; 2] };
                let before = if i == 0 { 0.0 } else { pieces[i - 1].area_to_here };
                let [u, v] = unfold(place);
                [(before + u.clamp(0.0, 1.0) * (pieces[i].area_to_here - before)) / whole, v]
            }
        }
    }

    /// Its corners, for boxes and side tests.
    pub fn corners(&self) -> Vec<Vec3> {
        match &self.shape {
            Shape::Parallelogram(Corner { origin, edges: [a, b], .. }) => {
                vec![*origin, *origin + *a, *origin + *a + *b, *origin + *b]
            }
            Shape::Triangle(Corner { origin, edges: [a, b], .. }) => vec![*origin, *origin + *a, *origin + *b],
            Shape::Polygon { outline, .. } => outline.vertices(),
        }
    }

    /// Triangles that tile it.
    pub fn triangles(&self) -> Vec<[Vec3; 3]> {
        match &self.shape {
            Shape::Polygon { pieces, .. } => pieces.iter().map(|p| p.corners).collect(),
            _ => {
                let corners = self.corners();
                (2..corners.len()).map(|i| [corners[0], corners[i - 1], corners[i]]).collect()
            }
        }
    }

    /// Itself if it is convex, else the triangles that tile it.
    pub fn convex_pieces(&self) -> Vec<Vec<Vec3>> {
        let is_convex = |loops: &[Vec<[f64; 2]>]| matches!(loops, [one] if is_convex(&anticlockwise(one.iter().map(|&p| DVec2::from_array(p)).collect())));
        match &self.shape {
            Shape::Polygon { outline, .. } if !is_convex(&outline.loops) => {
                self.triangles().into_iter().map(|triangle| triangle.to_vec()).collect()
            }
            _ => vec![self.corners()],
        }
    }

    /// Signed distance of a point from its plane, positive in front.
    #[inline]
    pub fn height(&self, p: Vec3) -> f64 {
        self.normal.dot(p) - self.offset
    }
}

/// From the unit square to the triangle s, t ≥ 0, s + t ≤ 1, area for area (P. Shirley, K. Chiu, JGT 2(3), 1997, by square root).
fn fold(u: [f64; 2]) -> [f64; 2] {
    let r = u[0].sqrt();
    [1.0 - r, u[1] * r]
}

/// The inverse of [`fold`].
fn unfold([s, t]: [f64; 2]) -> [f64; 2] {
    let r = 1.0 - s;
    [r * r, if r > 0.0 { t / r } else { 0.0 }]
}

fn parallelogram(outline: &Outline, v: &[Vec3]) -> Option<Shape> {
    if outline.loops.len() > 1 || v.len() != 4 {
        return None;
    }
    let size = (v[2] - v[0]).length();
    if (v[0] + v[2] - v[1] - v[3]).length() > 1e-12 * size {
        return None;
    }
    Corner::of(v[0], [v[1] - v[0], v[3] - v[0]]).map(|(corner, ..)| Shape::Parallelogram(corner))
}

#[cfg(test)]
mod tests {
    use super::*;
    use hemisphere::Rng;

    /// Points drawn on any shape lie in it, and their mean is the centroid.
    #[test]
    fn drawn_points_fill_the_facet_evenly() {
        let square =
            |x: f64, s: f64| [(x, x), (x + s, x), (x + s, x + s), (x, x + s)].map(|(a, b)| Vec3::new(a, b, a)).to_vec();
        let whole = Outline::new("whole", &square(0.0, 4.0), &[]).expect("sound");
        let holed = Outline::new("holed", &square(0.0, 4.0), &[square(1.0, 1.0)]).expect("sound");
        let mut rng = Rng::new(1, 2);
        for (facet, mean) in [
            (Facet::polygon(&whole, 0), 2.0),
            // 16 parts about 2 less 1 part about 1.5
            (Facet::polygon(&holed, 0), (16.0 * 2.0 - 1.5) / 15.0),
            (Facet::triangle([Vec3::ZERO, Vec3::X * 3.0, Vec3::new(3.0, 3.0, 0.0)], 0).expect("sound"), 2.0),
        ] {
            let n = 20_000;
            let mut sum = 0.0;
            for _ in 0..n {
                let u = [rng.uniform(), rng.uniform()];
                let p = facet.point(u);
                assert!(facet.holds(p) && facet.height(p).abs() < 1e-12);
                let back = facet.coordinates(p);
                assert!((back[0] - u[0]).abs() + (back[1] - u[1]).abs() < 1e-9, "{u:?} {back:?}");
                sum += p.x;
            }
            assert!((sum / f64::from(n) - mean).abs() < 5.0 * 1.2 / f64::from(n).sqrt(), "{}", sum / f64::from(n));
        }
    }

    /// A facet without area is none.
    #[test]
    fn needles_are_no_facets() {
        assert!(Facet::triangle([Vec3::ZERO, Vec3::X, Vec3::X * 2.0], 0).is_none());
    }
}
