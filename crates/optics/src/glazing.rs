//! What a flat element of a window does to light: the only thing a room knows of a window.

mod clear;
mod moving;
mod polarised;
mod stack;

pub use clear::ClearGlazing;
pub use moving::{MovingLobes, Slopes, stays_image};
pub use polarised::{LitLobe, LitLobes, PolarisedLobe, PolarisedLobes};
pub use stack::{LayerShares, Stack, StackLobes};

use hemisphere::{Direction, Vec3};

/// The two faces of a window element, as in WINDOW: `Front` is the outside.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Side {
    /// The outside, z = 0.
    Front,
    /// The room side, z = thickness.
    Back,
}

impl Side {
    /// The other side.
    pub fn opposite(self) -> Self {
        match self {
            Self::Front => Self::Back,
            Self::Back => Self::Front,
        }
    }

    /// The side that light travelling along `direction` leaves by.
    pub fn left_along(direction: Vec3) -> Self {
        if direction.z > 0.0 { Self::Back } else { Self::Front }
    }

    /// The side that light travelling along `direction` arrives on.
    pub fn entered_along(direction: Vec3) -> Self {
        Self::left_along(direction).opposite()
    }
}

/// One parallel beam that leaves a window element.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lobe {
    /// Where it travels, in the element's axes (x along the cuts, y up, z from outside to room).
    pub direction: Direction,
    /// Share of the incident power.
    pub power: f64,
    /// Least number of total internal reflections on the way.
    pub total_reflections: u16,
}

/// Every beam that leaves, and what does not: the powers of the beams, `absorbed`, `spread` and `residual` sum to 1.
#[derive(Clone, Debug, Default)]
pub struct Lobes {
    /// The beams, no two of one direction.
    pub beams: Vec<Lobe>,
    /// Share of the incident power absorbed.
    pub absorbed: f64,
    /// Share of the incident power that leaves spread over solid angle, not in beams: [`Glazing::bsdf`] says where to.
    pub spread: f64,
    /// Share of the incident power not followed to its end.
    pub residual: f64,
    /// Share of the incident power that a stack's walk followed, as part of the beams: these are good to the standard error of that.
    pub walked: f64,
}

impl Lobes {
    /// Forgets everything but keeps the memory.
    pub fn clear(&mut self) {
        self.beams.clear();
        (self.absorbed, self.spread, self.residual, self.walked) = (0.0, 0.0, 0.0, 0.0);
    }
}

/// One direction drawn at random.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Scattered {
    /// It leaves along this direction.
    Leaves {
        /// Where it travels, in the element's axes.
        direction: Direction,
        /// Total internal reflections on the way.
        total_reflections: u16,
    },
    /// It ends inside.
    Absorbed,
}

/// What an element does that turns no light: it passes straight on or is mirrored at the element's plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Straight {
    /// Share that goes straight on.
    pub transmittance: f64,
    /// Share mirrored.
    pub reflectance: f64,
}

/// What a flat element of a window does to light.
///
/// Directions are those in which light travels, in the element's own axes: x along the cuts, y up, z from the outside
/// to the room. The sign of `incident.z` says which side the light arrives on.
pub trait Glazing: Send + Sync {
    /// Every specular direction that leaves, with its share of the power: exact, no random numbers.
    fn lobes(&self, incident: Direction, out: &mut Lobes);

    /// As [`Self::lobes`], and how the direction of each moves with that of the light. An element that does not know is asked for
    /// its lobes twice more, a small step beside.
    fn moving_lobes(&self, incident: Direction, out: &mut MovingLobes) {
        moving::by_steps(self, incident, out);
    }

    /// One direction that leaves, drawn with probability proportional to its power.
    /// `u` are uniform numbers in [0, 1); the last seeds whatever further numbers the way needs.
    fn scatter(&self, incident: Direction, u: [f64; 3]) -> Scattered;

    /// The two shares at this incidence, if the element never turns light and never reflects it totally; `None` otherwise.
    fn straight(&self, _incident: Direction) -> Option<Straight> {
        None
    }

    /// The two shares of s and of p light about the plane of incidence, if the element is straight (see [`Self::straight`]).
    fn straight_s_p(&self, incident: Direction) -> Option<[Straight; 2]> {
        self.straight(incident).map(|shares| [shares; 2])
    }

    /// As [`Self::lobes`], for light of any polarisation. An element that does not know takes power alone, and what leaves it is
    /// unpolarised.
    fn polarised_lobes(&self, incident: Direction, out: &mut PolarisedLobes) {
        let mut lobes = Lobes::default();
        self.lobes(incident, &mut lobes);
        out.depolarised(&lobes);
    }

    /// As [`Self::polarised_lobes`], for light of these Stokes parameters over its power alone: a quarter of the work, where light of
    /// one polarisation comes once.
    fn lit_lobes(&self, incident: Direction, polarisation: [f64; 3], out: &mut LitLobes) {
        let mut lobes = PolarisedLobes::default();
        self.polarised_lobes(incident, &mut lobes);
        lobes.lit(polarisation, out);
    }

    /// As [`Self::scatter`], for light of these Stokes parameters over its power, about the reference axes of its direction;
    /// returned with those of the light that leaves.
    fn polarised_scatter(&self, incident: Direction, _polarisation: [f64; 3], u: [f64; 3]) -> (Scattered, [f64; 3]) {
        (self.scatter(incident, u), [0.0; 3])
    }

    /// The bidirectional scattering distribution [1/sr] of the part that is not specular, on both sides: radiance that leaves
    /// along `outgoing` for each unit of irradiance that arrives along `incident` (theory/bsdf.md, eq. 1). Its integral over
    /// |outgoing.z| dω is [`Lobes::spread`]. Zero where all light leaves in beams.
    fn bsdf(&self, _incident: Direction, _outgoing: Direction) -> f64 {
        0.0
    }

    /// Whether [`Self::bsdf`] can be other than zero.
    fn spreads(&self) -> bool {
        false
    }

    /// Probability per solid angle [1/sr] with which [`Self::scatter`] draws `outgoing` from the spread part; its integral over
    /// all directions is [`Lobes::spread`], as a draw may also be a beam or an end. Zero for beams, which have no density.
    fn density(&self, incident: Direction, outgoing: Direction) -> f64 {
        self.bsdf(incident, outgoing) * outgoing.z.abs()
    }
}
