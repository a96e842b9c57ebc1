//! What the things in a scene are made of.

use crate::RoomError;
use hemisphere::Frame;
use optics::Glazing;
use std::sync::Arc;

/// An opaque surface: shares of the light reflected diffusely and as by a mirror, the same on both sides.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Material {
    /// Diffuse (Lambertian) reflectance.
    pub diffuse: f64,
    /// Mirror reflectance.
    pub specular: f64,
}

impl Material {
    /// Diffuse alone.
    pub fn diffuse(reflectance: f64) -> Self {
        Self { diffuse: reflectance, specular: 0.0 }
    }

    /// Checks the shares; `name` is the object's that has them.
    pub fn check(self, name: &str) -> Result<Self, RoomError> {
        let share = |what, rule, value: f64| RoomError::ShareOutside { name: name.to_owned(), what, rule, value };
        for (what, value) in [("diffuse reflectance", self.diffuse), ("specular reflectance", self.specular)] {
            if !(0.0..=1.0).contains(&value) {
                return Err(share(what, "", value));
            }
        }
        let sum = self.diffuse + self.specular;
        // shares written in decimals may add up to one ulp over 1
        if sum > 1.0 + 1e-12 {
            return Err(share("diffuse + specular reflectance", " together", sum));
        }
        Ok(self)
    }
}

/// What fills the space on one side of an interface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Medium {
    /// Refractive index.
    pub n: f64,
    /// Absorption of the power along the way [1/m].
    pub absorption_per_m: f64,
}

impl Medium {
    /// What every scene lies in.
    pub const AIR: Self = Self { n: 1.0, absorption_per_m: 0.0 };

    pub(crate) fn check(self, name: &str) -> Result<Self, RoomError> {
        let wrong = |what, rule, value| RoomError::NotAMedium { name: name.to_owned(), what, rule, value };
        if !(self.n.is_finite() && self.n >= 1.0) {
            return Err(wrong("the index", "finite and at least 1", self.n));
        }
        if !(self.absorption_per_m.is_finite() && self.absorption_per_m >= 0.0) {
            return Err(wrong("the absorption per metre", "finite and not negative", self.absorption_per_m));
        }
        Ok(self)
    }

    /// Share of the power left after a way through it: Beer–Lambert (theory/media.md, eq. 5).
    pub(crate) fn left_after(self, metres: f64) -> f64 {
        if self.absorption_per_m == 0.0 { 1.0 } else { (-self.absorption_per_m * metres).exp() }
    }
}

impl std::fmt::Display for Medium {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "n = {} with {}/m absorbed", self.n, self.absorption_per_m)
    }
}

/// What a surface does to light.
#[derive(Clone)]
pub enum Kind {
    /// Reflects or absorbs.
    Opaque(Material),
    /// A window: the glazing and its axes in the world (z from outside to room, y up).
    Window {
        /// What fills it.
        glazing: Arc<dyn Glazing>,
        /// Its axes.
        frame: Frame,
    },
    /// A boundary between media.
    Interface {
        /// On the side the normal points to.
        front: Medium,
        /// On the other side.
        back: Medium,
    },
}

impl Kind {
    /// Its name in tables.
    pub fn name(&self) -> &'static str {
        match self {
            Self::Opaque(_) => "opaque",
            Self::Window { .. } => "window",
            Self::Interface { .. } => "interface",
        }
    }
}
