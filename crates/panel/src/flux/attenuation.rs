//! Absorption along beams whose way is not equally long everywhere.

use super::{density::Piece, payload::Payload, sight::Sight};

/// Change of the exponent along a piece up to which a sloping density is exact enough: the next term of its expansion
/// is below 10⁻⁶ of the piece (theory/panels.md, eq. 8).
const LARGEST_CHANGE: f64 = 0.01;
/// Parts into which one piece is divided at most.
const MOST_PARTS: u32 = 64;

/// Into how many parts a piece is divided so that its absorption is nearly linear along each.
pub fn parts(sight: &Sight, absorption: f64, from: f64, to: f64) -> u32 {
    let change = (absorption * sight.distance.1 * (to - from)).abs();
    ((change / LARGEST_CHANGE).ceil() as u32).clamp(1, MOST_PARTS)
}

/// The piece that is left of `piece` (over `from..to`) after Beer–Lambert: its power and its first moment are exact.
pub fn dimmed<P: Payload>(piece: &Piece<P>, sight: &Sight, absorption: f64, from: f64, to: f64) -> Piece<P> {
    let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
    let length = (sight.distance.0 + sight.distance.1 * middle).max(0.0);
    // exponent at the middle, and its change towards the end
    let (level, x) = ((-absorption * length).exp(), absorption * sight.distance.1 * half);
    let [m0, m1, m2] = moments(x);
    let (mean, tilt) = (piece.mean, piece.slope.times(half));
    Piece {
        mean: mean.times(m0).plus(tilt.times(m1)).times(level),
        slope: mean.times(m1).plus(tilt.times(m2)).times(3.0 * level / half),
        ..*piece
    }
}

/// What Beer–Lambert leaves of light that is spread evenly over `from..to`.
pub fn left(sight: &Sight, absorption: f64, from: f64, to: f64) -> f64 {
    let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
    let length = (sight.distance.0 + sight.distance.1 * middle).max(0.0);
    (-absorption * length).exp() * moments(absorption * sight.distance.1 * half)[0]
}

/// ½ ∫ uᵏ e^{−xu} du over −1..1 for k = 0, 1, 2.
fn moments(x: f64) -> [f64; 3] {
    if x.abs() < 0.05 {
        // series: the closed forms cancel for small x
        let q = x * x;
        return [
            1.0 + q / 6.0 * (1.0 + q / 20.0 * (1.0 + q / 42.0)),
            -x / 3.0 * (1.0 + q / 10.0 * (1.0 + q / 28.0)),
            1.0 / 3.0 + q / 10.0 * (1.0 + q / 25.2),
        ];
    }
    let (sinh, cosh) = (x.sinh(), x.cosh());
    [sinh / x, (sinh / x - cosh) / x, sinh / x - 2.0 * (cosh - sinh / x) / (x * x)]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The series and the closed forms agree with quadrature.
    #[test]
    fn moments_are_integrals() {
        for x in [-0.7, -0.04, 0.0, 0.03, 0.4, 2.0] {
            let count = 20_000;
            let mut sums = [0.0; 3];
            for i in 0..count {
                let u = -1.0 + 2.0 * (f64::from(i) + 0.5) / f64::from(count);
                let w = (-x * u).exp() / f64::from(count);
                sums[0] += w;
                sums[1] += w * u;
                sums[2] += w * u * u;
            }
            for (found, want) in moments(x).into_iter().zip(sums) {
                assert!((found - want).abs() < 1e-8, "x = {x}: {found} {want}");
            }
        }
    }
}
