//! The media of a profile at one wavelength.

use crate::{error::PanelError, facet::MediumId, profile::Profile};

/// One medium at one wavelength.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Optical {
    /// Index of refraction.
    pub n: f64,
    /// Beer–Lambert absorption per unit of the profile's length.
    pub absorption: f64,
}

impl Optical {
    /// Air.
    pub const AIR: Self = Self { n: 1.0, absorption: 0.0 };

    /// A clear medium.
    pub const fn clear(n: f64) -> Self {
        Self { n, absorption: 0.0 }
    }
}

/// The media that a profile names, in its numbering.
#[derive(Clone, Debug, PartialEq)]
pub struct Media(Vec<Optical>);

impl Media {
    /// Air, then the others in turn.
    pub fn in_air(others: &[Optical]) -> Result<Self, PanelError> {
        for medium in others {
            if !(medium.n.is_finite() && medium.n >= 1.0) {
                return Err(PanelError::OutOfRange {
                    name: "n",
                    rule: "a finite number, 1 or more".into(),
                    value: medium.n,
                });
            }
            if !(medium.absorption.is_finite() && medium.absorption >= 0.0) {
                let rule = "0 or a positive number".into();
                return Err(PanelError::OutOfRange { name: "absorption_per_mm", rule, value: medium.absorption });
            }
        }
        Ok(Self(std::iter::once(Optical::AIR).chain(others.iter().copied()).collect()))
    }

    /// A refusal if `profile` names a medium that is not here.
    pub fn suffice_for(&self, profile: &Profile) -> Result<(), PanelError> {
        let needed = profile.highest_medium();
        if usize::from(needed) < self.0.len() {
            Ok(())
        } else {
            Err(PanelError::MissingMedium { needed, given: self.0.len() })
        }
    }

    /// The medium of this number.
    #[inline]
    pub fn get(&self, id: MediumId) -> Optical {
        self.0[usize::from(id)]
    }

    /// Whether any of them absorbs.
    pub fn absorb(&self) -> bool {
        self.0.iter().any(|m| m.absorption > 0.0)
    }
}
