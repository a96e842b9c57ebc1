//! A right-handed orthonormal frame about an axis.

use crate::{Direction, Vec3};

/// Three unit vectors at right angles, x × y = z.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frame {
    /// First axis.
    pub x: Vec3,
    /// Second axis.
    pub y: Vec3,
    /// Third axis, the one the frame was made about.
    pub z: Vec3,
}

impl Frame {
    /// Any frame about `z`, without branches or square roots
    /// (Duff et al., *Building an Orthonormal Basis, Revisited*, JCGT 6(1), 2017).
    pub fn about(z: Direction) -> Self {
        let z = z.vector();
        let sign = 1.0_f64.copysign(z.z);
        let a = -1.0 / (sign + z.z);
        let b = z.x * z.y * a;
        Self {
            x: Vec3::new(1.0 + sign * z.x * z.x * a, sign * b, -sign * z.x),
            y: Vec3::new(b, sign + z.y * z.y * a, -z.y),
            z,
        }
    }

    /// The frame about `z` whose y axis is as near to `up` as it can be; `None` if they are parallel.
    pub fn with_up(z: Direction, up: Vec3) -> Option<Self> {
        let z = z.vector();
        let x = up.cross(z).try_normalize()?;
        Some(Self { x, y: z.cross(x), z })
    }

    /// From components in this frame to the surrounding one.
    pub fn outward(&self, local: Vec3) -> Vec3 {
        local.x * self.x + local.y * self.y + local.z * self.z
    }

    /// From the surrounding frame to components in this one.
    pub fn inward(&self, v: Vec3) -> Vec3 {
        Vec3::new(v.dot(self.x), v.dot(self.y), v.dot(self.z))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Any frame is right-handed, orthonormal, and undoes itself.
    #[test]
    fn frames_are_orthonormal_and_invert() {
        for v in [Vec3::X, -Vec3::Z, Vec3::new(0.2, -0.7, 0.4), Vec3::new(1e-9, 0.0, -1.0)] {
            let f = Frame::about(Direction::of(v).expect("finite"));
            assert!((f.x.cross(f.y) - f.z).length() < 1e-14);
            assert!(f.x.dot(f.y).abs() < 1e-15 && (f.x.length() - 1.0).abs() < 1e-14);
            let w = Vec3::new(0.1, 2.0, -3.0);
            assert!((f.outward(f.inward(w)) - w).length() < 1e-13);
        }
    }

    /// The y axis of an upright frame leans up.
    #[test]
    fn with_up_leans_up() {
        let f =
            Frame::with_up(Direction::of(Vec3::new(1.0, 1.0, 0.3)).expect("finite"), Vec3::Z).expect("not parallel");
        assert!(f.y.z > 0.0 && f.x.z.abs() < 1e-15);
        assert!(Frame::with_up(Direction::from_unit(Vec3::Z), Vec3::Z).is_none());
    }
}
