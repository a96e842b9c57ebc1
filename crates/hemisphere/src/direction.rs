//! A direction: a vector of length one.

use crate::Vec3;
use std::ops::{Deref, Neg};

/// A unit vector. Light *travels* along it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Direction(Vec3);

impl Direction {
    /// The direction of `vector`; `None` for a null or non-finite vector.
    pub fn of(vector: Vec3) -> Option<Self> {
        vector.try_normalize().map(Self)
    }

    /// Takes a vector that is already of unit length to rounding.
    pub fn from_unit(unit: Vec3) -> Self {
        debug_assert!((unit.length_squared() - 1.0).abs() < 1e-9, "not a unit vector: {unit}");
        Self(unit)
    }

    /// The vector itself.
    pub fn vector(self) -> Vec3 {
        self.0
    }

    /// Mirrored at a plane with this unit normal: r = i − 2 (i·n) n (theory/interface.md, eq. 7).
    pub fn mirrored(self, normal: Direction) -> Self {
        Self(self.0 - 2.0 * self.0.dot(normal.0) * normal.0)
    }
}

impl Deref for Direction {
    type Target = Vec3;
    fn deref(&self) -> &Vec3 {
        &self.0
    }
}

impl Neg for Direction {
    type Output = Self;
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A mirror turns the component along its normal and keeps the rest.
    #[test]
    fn mirror_turns_the_normal_component_alone() {
        let d = Direction::of(Vec3::new(0.3, -0.4, 0.5)).expect("finite");
        let m = d.mirrored(Direction::from_unit(Vec3::Z));
        assert_eq!((m.x, m.y, m.z), (d.x, d.y, -d.z));
    }

    /// No direction is made of nothing.
    #[test]
    fn null_and_nan_vectors_have_no_direction() {
        assert!(Direction::of(Vec3::ZERO).is_none());
        assert!(Direction::of(Vec3::new(f64::NAN, 0.0, 1.0)).is_none());
    }
}
