//! What a beam travels in: a refractive index and an absorption, at one wavelength or over a spectrum.
//!
//! Wavelengths are in nm and absorption per mm, as every source tabulates them; nothing else here has a unit.

mod absorption;
mod dispersion;
mod named;
mod table;

pub use absorption::Absorption;
pub use dispersion::{Dispersion, Law};
pub use named::names as medium_names;
pub use table::Table;

use crate::OpticsError;

/// A clear medium: n(λ), α(λ) and the wavelengths for which both are known.
#[derive(Clone, Debug, PartialEq)]
pub struct Medium {
    dispersion: Dispersion,
    absorption: Absorption,
    range_nm: Option<(f64, f64)>,
}

impl Medium {
    /// A medium from its two laws; it holds where both do.
    pub fn new(dispersion: Dispersion, absorption: Absorption) -> Result<Self, OpticsError> {
        let range_nm = match (dispersion.range_nm(), absorption.range_nm()) {
            (Some((n_low_nm, n_high_nm)), Some((a_low_nm, a_high_nm))) => {
                let (low, high) = (n_low_nm.max(a_low_nm), n_high_nm.min(a_high_nm));
                if low > high {
                    return Err(OpticsError::DisjointRanges { n_low_nm, n_high_nm, a_low_nm, a_high_nm });
                }
                Some((low, high))
            }
            (n_range, a_range) => n_range.or(a_range),
        };
        Ok(Self { dispersion, absorption, range_nm })
    }

    /// The same index and absorption [1/mm] at every wavelength.
    pub fn constant(n: f64, absorption_per_mm: f64) -> Result<Self, OpticsError> {
        Self::new(Dispersion::constant(n)?, Absorption::from_values("constant", &[absorption_per_mm])?)
    }

    /// The refractive index's law.
    pub fn dispersion(&self) -> &Dispersion {
        &self.dispersion
    }

    /// The absorption's law.
    pub fn absorption(&self) -> &Absorption {
        &self.absorption
    }

    /// The wavelengths for which both are known [nm]; `None`: all.
    pub fn wavelength_range_nm(&self) -> Option<(f64, f64)> {
        self.range_nm
    }

    /// Whether anything depends on the wavelength.
    pub fn is_spectral(&self) -> bool {
        self.dispersion.is_spectral() || !matches!(self.absorption, Absorption::Constant(_))
    }

    /// Refractive index at a wavelength [nm].
    pub fn index(&self, wavelength_nm: f64) -> Result<f64, OpticsError> {
        self.check(wavelength_nm)?;
        self.dispersion.index(wavelength_nm)
    }

    /// Absorption coefficient of the power at a wavelength [1/mm].
    pub fn absorption_per_mm(&self, wavelength_nm: f64) -> Result<f64, OpticsError> {
        self.check(wavelength_nm)?;
        Ok(self.absorption.per_mm(wavelength_nm))
    }

    /// Share of the power left after a path in the medium: Beer–Lambert, e^(−α·path) (theory/media.md, eq. 5).
    pub fn internal_transmittance(&self, wavelength_nm: f64, path_mm: f64) -> Result<f64, OpticsError> {
        Ok((-self.absorption_per_mm(wavelength_nm)? * path_mm).exp())
    }

    fn check(&self, wavelength_nm: f64) -> Result<(), OpticsError> {
        if !(wavelength_nm.is_finite() && wavelength_nm > 0.0) {
            return Err(OpticsError::NotAWavelength { value: wavelength_nm });
        }
        match self.range_nm {
            Some((low_nm, high_nm)) if !(low_nm..=high_nm).contains(&wavelength_nm) => {
                Err(OpticsError::WavelengthOutside { value: wavelength_nm, low_nm, high_nm })
            }
            _ => Ok(()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// α = 4πk/λ comes out per mm, by hand.
    #[test]
    fn extinction_is_turned_into_absorption_per_mm() {
        let k = 1e-7;
        let absorption = Absorption::from_values("extinction", &[500.0, k, 600.0, k]).unwrap();
        // 4π · 1e-7 / 500e-6 mm
        assert!((absorption.per_mm(500.0) - 4.0 * std::f64::consts::PI * 1e-7 / 500e-6).abs() < 1e-15);
    }

    /// Two paths in a row transmit the product of their shares.
    #[test]
    fn beer_lambert_multiplies_along_the_path() {
        let medium = Medium::constant(1.49, 0.02).unwrap();
        let share = |path_mm| medium.internal_transmittance(550.0, path_mm).unwrap();
        assert!((share(3.0) * share(5.0) - share(8.0)).abs() < 1e-15 && share(0.0) == 1.0);
    }

    /// Cauchy's law with two terms, by hand: 1.5 + 0.004 / 0.25 at 0.5 µm.
    #[test]
    fn cauchy_law_by_hand() {
        let law = Dispersion::from_coefficients("cauchy", &[1.5, 0.004, -2.0], Some((400.0, 700.0))).unwrap();
        assert!((law.index(500.0).unwrap() - 1.516).abs() < 1e-15);
    }

    /// Each way of being wrong is its own error, at construction where it can be.
    #[test]
    fn mistakes_are_refused() {
        for n in [0.99, -1.5, f64::NAN, f64::INFINITY] {
            assert!(matches!(Medium::constant(n, 0.0), Err(OpticsError::IndexBelowOne { .. })));
        }
        for alpha in [-0.1, f64::NAN] {
            assert!(matches!(Medium::constant(1.5, alpha), Err(OpticsError::NegativeAbsorption { .. })));
        }
        // a pole at 0.6 µm: n² runs through every negative value just below it
        let pole = Dispersion::from_coefficients("sellmeier", &[0.0, 1.0, 0.36], Some((400.0, 700.0)));
        assert!(matches!(pole, Err(OpticsError::IndexBelowOne { .. })));
        assert!(matches!(Medium::named("perspex"), Err(OpticsError::UnknownMedium { .. })));
        let pmma = Medium::named("pmma").unwrap();
        assert!(matches!(pmma.index(419.9), Err(OpticsError::WavelengthOutside { .. })));
        assert!(matches!(pmma.absorption_per_mm(f64::NAN), Err(OpticsError::NotAWavelength { .. })));
    }

    /// A law taken apart and put together again is the same law.
    #[test]
    fn laws_survive_the_round_trip() {
        for name in medium_names() {
            let medium = Medium::named(name).unwrap();
            let (law, coefficients) = medium.dispersion().to_coefficients();
            let (quantity, values) = medium.absorption().to_values();
            let again = Medium::new(
                Dispersion::from_coefficients(law, &coefficients, medium.dispersion().range_nm()).unwrap(),
                Absorption::from_values(quantity, &values).unwrap(),
            );
            assert_eq!(again.unwrap(), medium);
        }
    }
}
