//! Four triangles side by side, in single precision: which of them a ray may meet.

use glam::{Vec3A, Vec4};

/// Room for the rounding of single precision in the coordinates of a scene of radius 1, in a ray's origin up to 3 from its centre, and
/// in what follows from them: about 50 of its steps (2⁻²³) in the worst case.
pub const SLACK: f32 = 64.0 * f32::EPSILON;

/// Up to four triangles.
pub struct Quad {
    corner: [Vec4; 3],
    edges: [[Vec4; 3]; 2],
    /// [`SLACK`] times the lengths of edges: what a signed area may be off.
    margin: f32,
}

impl Quad {
    /// Triangles by their corners.
    pub fn new(triangles: &[[Vec3A; 3]]) -> Self {
        // a lane without a triangle holds a NaN, which is met by nothing
        let mut quad = Self { corner: [Vec4::NAN; 3], edges: [[Vec4::NAN; 3]; 2], margin: 0.0 };
        for (lane, &[o, a, b]) in triangles.iter().enumerate() {
            for axis in 0..3 {
                quad.corner[axis][lane] = o[axis];
                quad.edges[0][axis][lane] = a[axis] - o[axis];
                quad.edges[1][axis][lane] = b[axis] - o[axis];
            }
            quad.margin = quad.margin.max(SLACK * ((a - o).length() + (b - o).length()));
        }
        quad
    }

    /// A bit for each triangle that the line through a ray may meet: none is left out that it does meet, few are added.
    ///
    /// The line passes inside if it sees all three edges turn the same way (T. Möller, B. Trumbore, JGT 2(1), 1997, without the
    /// division).
    #[inline(always)]
    pub fn may_meet(&self, origin: [Vec4; 3], direction: [Vec4; 3]) -> u32 {
        let [a, b] = &self.edges;
        let from_corner: [Vec4; 3] = std::array::from_fn(|axis| origin[axis] - self.corner[axis]);
        let moment = cross(&from_corner, &direction);
        let s = dot(&moment, b);
        let t = -dot(&moment, a);
        let rest = -dot(&cross(a, b), &direction) - s - t;
        let margin = Vec4::splat(self.margin);
        let (least, most) = (s.min(t).min(rest), s.max(t).max(rest));
        (least.cmpge(-margin) | most.cmple(margin)).bitmask()
    }
}

#[inline(always)]
fn cross(p: &[Vec4; 3], q: &[Vec4; 3]) -> [Vec4; 3] {
    [p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]]
}

#[inline(always)]
fn dot(p: &[Vec4; 3], q: &[Vec4; 3]) -> Vec4 {
    p[0] * q[0] + p[1] * q[1] + p[2] * q[2]
}
