//! From what a spectrophotometer sees at normal incidence to what an uncoated pane is made of.

use crate::OpticsError;

/// Index and optical depth of a pane, at one wavelength.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct UncoatedGlass {
    /// Refractive index, from the reflectance of one surface.
    pub n: f64,
    /// Absorption times thickness across the pane; infinite for a pane that transmits nothing.
    pub optical_depth: f64,
}

/// Inverts the slab at normal incidence: from transmittance T and reflectance R to n and the optical depth
/// (theory/glass.md, eqs. 12–15; M. Rubin, K. von Rottkay, R. Powles, Solar Energy 62, 149–161, 1998).
pub fn uncoated_glass(transmittance: f64, reflectance: f64) -> Result<UncoatedGlass, OpticsError> {
    let (t, r) = (transmittance, reflectance);
    let possible = t >= 0.0 && (0.0..1.0).contains(&r) && t + r <= 1.0;
    if !possible {
        return Err(OpticsError::ImpossibleGlass { transmittance, reflectance });
    }
    // R = ρ (1 + τ T) and T = (1 − ρ)² τ / (1 − ρ² τ²): a quadratic for ρ, of which the smaller root is the surface
    let b = t * t - r * r + 2.0 * r + 1.0;
    let rho = 2.0 * r / (b + (b * b - 4.0 * r * (2.0 - r)).max(0.0).sqrt());
    // a pane that reflects nothing has no surface, and one that transmits nothing hides its far side
    let tau = if t == 0.0 {
        0.0
    } else if rho == 0.0 {
        t
    } else {
        (r - rho) / (rho * t)
    };
    let amplitude = rho.sqrt();
    // rounding may leave τ above 1 by an ulp
    Ok(UncoatedGlass { n: (1.0 + amplitude) / (1.0 - amplitude), optical_depth: (-tau.ln()).max(0.0) })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::formulas::{Polarisation, slab};
    use proptest::prelude::*;

    proptest! {
        /// The inversion undoes the slab.
        #[test]
        fn recovers_the_pane_it_came_from(n in 1.05..2.5_f64, depth in 0.0..2.0_f64) {
            let seen = slab(1.0, n, depth, Polarisation::Resolved);
            // rounding may push a lossless pane's sum above 1 by an ulp
            let found = uncoated_glass(seen.transmittance.min(1.0 - seen.reflectance), seen.reflectance).unwrap();
            prop_assert!((found.n - n).abs() < 1e-9 && (found.optical_depth - depth).abs() < 1e-9, "{found:?}");
        }
    }

    /// An opaque pane shows one surface; impossible readings are refused.
    #[test]
    fn ends_of_the_range() {
        let opaque = uncoated_glass(0.0, 0.04).unwrap();
        assert!((opaque.n - 1.5).abs() < 1e-12 && opaque.optical_depth == f64::INFINITY);
        for (t, r) in [(0.9, 0.2), (-0.1, 0.1), (f64::NAN, 0.1), (0.0, 1.0)] {
            assert!(uncoated_glass(t, r).is_err());
        }
    }
}
