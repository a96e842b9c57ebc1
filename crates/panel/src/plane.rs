//! The plane of the cross-section: z across the sheet from outside to room, y up.

use std::ops::{Add, Mul, Neg, Sub};

/// A point or vector of the cross-section.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Vec2 {
    /// Across the sheet, from the outside to the room.
    pub z: f64,
    /// Up.
    pub y: f64,
}

impl Vec2 {
    /// A point at depth `z` and height `y`.
    pub const fn new(z: f64, y: f64) -> Self {
        Self { z, y }
    }

    /// Scalar product.
    #[inline]
    pub fn dot(self, other: Self) -> f64 {
        self.z * other.z + self.y * other.y
    }

    /// Turn from `self` to `other`, positive anticlockwise with z to the right and y up.
    #[inline]
    pub fn cross(self, other: Self) -> f64 {
        self.z * other.y - self.y * other.z
    }

    /// Turned a quarter anticlockwise: to the left of this vector.
    #[inline]
    pub fn left(self) -> Self {
        Self::new(-self.y, self.z)
    }

    /// Length.
    pub fn length(self) -> f64 {
        self.z.hypot(self.y)
    }

    /// The same moved up by `dy`.
    #[inline]
    pub fn raised(self, dy: f64) -> Self {
        Self::new(self.z, self.y + dy)
    }

    /// Of length one.
    pub fn normalized(self) -> Self {
        self * (1.0 / self.length())
    }

    /// Whether both components are numbers.
    pub fn is_finite(self) -> bool {
        self.z.is_finite() && self.y.is_finite()
    }
}

impl Add for Vec2 {
    type Output = Self;
    #[inline]
    fn add(self, o: Self) -> Self {
        Self::new(self.z + o.z, self.y + o.y)
    }
}

impl Sub for Vec2 {
    type Output = Self;
    #[inline]
    fn sub(self, o: Self) -> Self {
        Self::new(self.z - o.z, self.y - o.y)
    }
}

impl Mul<f64> for Vec2 {
    type Output = Self;
    #[inline]
    fn mul(self, k: f64) -> Self {
        Self::new(self.z * k, self.y * k)
    }
}

impl Neg for Vec2 {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Self::new(-self.z, -self.y)
    }
}
