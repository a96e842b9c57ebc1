//! Transmittance of 6 mm clear float glass as a polynomial of the cosine of incidence.

/// Factors of c⁰ … c⁵ (P. R. Tregenza, S. Sharples, *Daylighting Algorithms*, ETSU S 1350, 1993).
const FACTORS: [f64; 6] = [-0.028378, 3.156075, -3.058376, -1.428919, 4.014235, -1.775827];

/// Transmittance of 6 mm clear float glass, absorption included (theory/glass.md, eq. 8).
///
/// The published polynomial is negative beyond 89.48°; there it is clamped at 0.
pub fn tregenza_sharples(cos_i: f64) -> f64 {
    FACTORS.iter().rev().fold(0.0, |sum, factor| sum * cos_i + factor).max(0.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// At normal incidence it is the sum of its factors; at grazing nothing passes.
    #[test]
    fn ends_are_the_sum_of_the_factors_and_nothing() {
        assert!((tregenza_sharples(1.0) - 0.87881).abs() < 1e-12);
        assert_eq!(tregenza_sharples(0.0), 0.0);
    }

    /// The clamp begins between 89.4° and 89.5°.
    #[test]
    fn clamp_begins_just_above_89_degrees() {
        assert!(tregenza_sharples(89.4_f64.to_radians().cos()) > 0.0);
        assert_eq!(tregenza_sharples(89.5_f64.to_radians().cos()), 0.0);
    }
}
