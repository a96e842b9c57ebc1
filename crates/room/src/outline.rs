//! A flat polygon with holes: checked, measured, triangulated.

use crate::RoomError;
use crate::loops::{crossings_odd, folds_back, on_loop, segments_cross, segments_meet, signed_area};
use hemisphere::{Direction, Frame, Vec3};

/// A checked polygon in its own plane. Its normal follows the right hand around the outer loop.
#[derive(Clone, Debug)]
pub struct Outline {
    /// The first vertex.
    pub origin: Vec3,
    /// Axes of the plane; z is the normal.
    pub frame: Frame,
    /// The outer loop, then the holes, in the plane's axes.
    pub loops: Vec<Vec<[f64; 2]>>,
}

/// Largest distance off the plane, and least edge, in shares of the extent.
const FLATNESS: f64 = 1e-6;

impl Outline {
    /// Checks an outline and its holes, given in the world's axes; a last vertex equal to the first is dropped.
    pub fn new(name: &str, outer: &[Vec3], holes: &[Vec<Vec3>]) -> Result<Self, RoomError> {
        let outer = checked_loop(name, outer)?;
        let extent = extent(&outer);
        // Newell: the sum of cross products is twice the area along the normal
        let origin = outer[0];
        let twice_area: Vec3 = (0..outer.len())
            .map(|i| (outer[i] - origin).cross(outer[(i + 1) % outer.len()] - origin))
            .fold(Vec3::ZERO, |sum, v| sum + v);
        let normal = Direction::of(twice_area)
            .filter(|_| twice_area.length() > FLATNESS * extent * extent)
            .ok_or_else(|| RoomError::NoArea { name: name.to_owned(), detail: "an area of 0".to_owned() })?;
        let frame = Frame::about(normal);
        let mut outline = Self { origin, frame, loops: Vec::new() };
        outline.loops.push(outline.flat_loop(name, &outer, extent)?);
        for hole in holes {
            let hole = checked_loop(name, hole)?;
            let flat = outline.flat_loop(name, &hole, extent)?;
            outline.cut(name, flat, "a hole")?;
        }
        Ok(outline)
    }

    /// The outer loop in the world's axes.
    pub fn vertices(&self) -> Vec<Vec3> {
        self.loops[0].iter().map(|&p| self.lift(p)).collect()
    }

    /// Area without the holes \[m²\].
    pub fn area(&self) -> f64 {
        self.loops.iter().skip(1).fold(signed_area(&self.loops[0]).abs(), |area, hole| area - signed_area(hole).abs())
    }

    /// Cuts another outline out of this one; `inner` is its name.
    pub fn cut_out(&mut self, name: &str, inner: &str, opening: &Self) -> Result<(), RoomError> {
        let vertices = opening.vertices();
        let size = extent(&self.vertices());
        for &v in &vertices {
            let off = (v - self.origin).dot(self.frame.z).abs();
            if off > FLATNESS * size {
                let detail = format!("a vertex {off:.2e} m off its plane");
                return Err(outside(name, inner, "its plane and outline", detail));
            }
        }
        let flat = vertices.iter().map(|&v| self.flatten(v)).collect();
        self.cut(name, flat, inner)
    }

    /// Triangles that tile the polygon, in the plane's axes.
    pub fn triangles(&self) -> Vec<[[f64; 2]; 3]> {
        let points: Vec<[f64; 2]> = self.loops.iter().flatten().copied().collect();
        let mut starts = Vec::new();
        let mut count = 0;
        for l in &self.loops[..self.loops.len() - 1] {
            count += l.len();
            starts.push(count as u32);
        }
        let mut indices: Vec<u32> = Vec::new();
        earcut::Earcut::new().earcut(points.iter().copied(), &starts, &mut indices);
        indices.chunks_exact(3).map(|t| [0, 1, 2].map(|k| points[t[k] as usize])).collect()
    }

    /// From the plane's axes to the world's.
    pub fn lift(&self, [x, y]: [f64; 2]) -> Vec3 {
        self.origin + x * self.frame.x + y * self.frame.y
    }

    /// From the world's axes to the plane's, off-plane part dropped.
    pub fn flatten(&self, v: Vec3) -> [f64; 2] {
        let d = v - self.origin;
        [d.dot(self.frame.x), d.dot(self.frame.y)]
    }

    /// Whether a point of the plane lies in the polygon and in none of its holes (crossing number).
    pub fn holds(&self, p: [f64; 2]) -> bool {
        self.loops.iter().filter(|l| crossings_odd(l, p)).count() == 1
    }

    fn flat_loop(&self, name: &str, vertices: &[Vec3], extent: f64) -> Result<Vec<[f64; 2]>, RoomError> {
        for (vertex, &v) in vertices.iter().enumerate() {
            let distance_m = (v - self.origin).dot(self.frame.z).abs();
            if distance_m > FLATNESS * extent {
                return Err(RoomError::NotPlanar { name: name.to_owned(), vertex, distance_m });
            }
        }
        let flat: Vec<_> = vertices.iter().map(|&v| self.flatten(v)).collect();
        let n = flat.len();
        for first in 0..n {
            for second in first + 1..n {
                let neighbours = second == first + 1 || (first == 0 && second == n - 1);
                let (a, b) = ([flat[first], flat[(first + 1) % n]], [flat[second], flat[(second + 1) % n]]);
                if if neighbours { folds_back(a, b) } else { segments_meet(a, b) } {
                    return Err(RoomError::SelfCrossing { name: name.to_owned(), first, second });
                }
            }
        }
        Ok(flat)
    }

    fn cut(&mut self, name: &str, hole: Vec<[f64; 2]>, inner: &str) -> Result<(), RoomError> {
        let edges = |l: &[[f64; 2]]| (0..l.len()).map(|i| [l[i], l[(i + 1) % l.len()]]).collect::<Vec<_>>();
        for other in &self.loops {
            if edges(other).iter().any(|&a| edges(&hole).iter().any(|&b| segments_cross(a, b))) {
                return Err(outside(name, inner, "the outline", "edges that cross".to_owned()));
            }
        }
        // the middle of each edge tells, for vertices may touch the rim
        let middles = edges(&hole).into_iter().map(|[a, b]| [0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])]);
        if hole.iter().copied().chain(middles).any(|p| !self.holds(p) && !self.on_rim(p)) {
            return Err(outside(
                name,
                inner,
                "the outline",
                "a vertex outside it or within another opening".to_owned(),
            ));
        }
        // an opening cut twice has all its edges on a rim, but its inside is gone
        let alone = Self { origin: self.origin, frame: self.frame, loops: vec![hole.clone()] };
        let mut insides = alone.triangles().into_iter().map(|[a, b, c]| [0, 1].map(|k| (a[k] + b[k] + c[k]) / 3.0));
        if insides.any(|p| !self.holds(p)) {
            return Err(outside(
                name,
                inner,
                "the outline",
                "a part of it outside or within another opening".to_owned(),
            ));
        }
        for other in &self.loops[1..] {
            if other.iter().any(|&p| crossings_odd(&hole, p) && !on_loop(&hole, p)) {
                return Err(outside(name, inner, "the outline", "another opening inside it".to_owned()));
            }
        }
        self.loops.push(hole);
        Ok(())
    }

    fn on_rim(&self, p: [f64; 2]) -> bool {
        self.loops.iter().any(|l| on_loop(l, p))
    }
}

fn outside(name: &str, inner: &str, outer: &str, detail: String) -> RoomError {
    RoomError::Outside { name: name.to_owned(), inner: inner.to_owned(), outer: outer.to_owned(), detail }
}

fn checked_loop(name: &str, vertices: &[Vec3]) -> Result<Vec<Vec3>, RoomError> {
    check_finite(name, vertices)?;
    let mut vertices = vertices.to_vec();
    if vertices.len() > 1 && vertices.first() == vertices.last() {
        vertices.pop();
    }
    let size = extent(&vertices);
    // points given twice in a row say nothing
    vertices.dedup_by(|a, b| (*a - *b).length() <= 1e-12 * size);
    if vertices.len() < 3 {
        let detail = format!("{} distinct points", vertices.len());
        return Err(RoomError::NoArea { name: name.to_owned(), detail });
    }
    Ok(vertices)
}

/// Refuses the first vertex with a coordinate that is not finite.
pub fn check_finite(name: &str, vertices: &[Vec3]) -> Result<(), RoomError> {
    for (vertex, v) in vertices.iter().enumerate() {
        if let Some(value) = v.to_array().into_iter().find(|x| !x.is_finite()) {
            return Err(RoomError::NotFinite { name: name.to_owned(), vertex, value });
        }
    }
    Ok(())
}

/// The longest side of the box around some points \[m\].
pub fn extent(points: &[Vec3]) -> f64 {
    let low = points.iter().fold(Vec3::INFINITY, |low, &p| low.min(p));
    let high = points.iter().fold(Vec3::NEG_INFINITY, |high, &p| high.max(p));
    if points.is_empty() { 0.0 } else { (high - low).max_element() }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::loops::turn;

    fn square(x: f64, y: f64, side: f64) -> Vec<Vec3> {
        [(0.0, 0.0), (side, 0.0), (side, side), (0.0, side)].map(|(a, b)| Vec3::new(x + a, y + b, 1.0)).to_vec()
    }

    /// Area, triangles and inside agree on a wall with an opening, and the normal follows the right hand.
    #[test]
    fn opening_is_cut_out_of_a_wall() {
        let wall = Outline::new("wall", &square(0.0, 0.0, 4.0), &[square(1.0, 1.0, 2.0)]).expect("sound");
        assert!((wall.area() - 12.0).abs() < 1e-12 && wall.frame.z == Vec3::Z);
        let area: f64 = wall.triangles().iter().map(|&[a, b, c]| 0.5 * turn(a, b, c).abs()).sum();
        assert!((area - 12.0).abs() < 1e-12);
        assert!(
            wall.holds(wall.flatten(Vec3::new(0.5, 2.0, 1.0))) && !wall.holds(wall.flatten(Vec3::new(2.0, 2.0, 1.0)))
        );
    }

    /// A bow tie crosses itself, a spike folds back, a line has no area, a bent sheet is not flat, a NaN is not finite.
    #[test]
    fn unsound_outlines_are_refused_by_name() {
        let mut bow = square(0.0, 0.0, 1.0);
        bow.swap(1, 2);
        (bow[0].x, bow[0].y) = (-0.5, -0.5);
        assert!(matches!(Outline::new("bow", &bow, &[]), Err(RoomError::SelfCrossing { .. })));
        let spike = [(0.0, 0.0), (2.0, 0.0), (1.0, 0.0), (1.0, 1.0)].map(|(x, y)| Vec3::new(x, y, 0.0));
        assert!(matches!(Outline::new("spike", &spike, &[]), Err(RoomError::SelfCrossing { .. })));
        let line = [0.0, 1.0, 2.0].map(|x| Vec3::new(x, 0.0, 0.0));
        assert!(matches!(Outline::new("line", &line, &[]), Err(RoomError::NoArea { .. })));
        let mut bent = square(0.0, 0.0, 1.0);
        bent[2].z += 0.01;
        assert!(matches!(Outline::new("bent", &bent, &[]), Err(RoomError::NotPlanar { .. })));
        bent[1].y = f64::NAN;
        assert!(matches!(Outline::new("nan", &bent, &[]), Err(RoomError::NotFinite { vertex: 1, .. })));
    }

    /// Openings may share a rim with the wall or another opening, but not stick out or overlap.
    #[test]
    fn openings_stay_inside_and_apart() {
        let outer = square(0.0, 0.0, 4.0);
        let side_by_side = [square(0.0, 1.0, 1.0), square(1.0, 1.0, 1.0)];
        assert!(Outline::new("wall", &outer, &side_by_side).is_ok());
        for holes in [
            vec![square(3.5, 1.0, 1.0)],
            vec![square(1.0, 1.0, 2.0), square(1.5, 1.5, 1.0)],
            vec![square(9.0, 9.0, 1.0)],
            vec![square(1.0, 1.0, 1.0), square(1.0, 1.0, 1.0)],
        ] {
            assert!(matches!(Outline::new("wall", &outer, &holes), Err(RoomError::Outside { .. })), "{holes:?}");
        }
        // the larger opening cut second swallows the first
        let swallow = [square(1.5, 1.5, 1.0), square(1.0, 1.0, 2.0)];
        assert!(matches!(Outline::new("wall", &outer, &swallow), Err(RoomError::Outside { .. })));
    }
}
