//! Independent uniform numbers, reproducible from a seed and a stream.

/// A stream of independent uniform numbers (SplitMix64: G. L. Steele, D. Lea, C. H. Flood, OOPSLA 2014).
///
/// Streams of one seed, and seeds of one stream, are unrelated, so a ray or a block of rays may own its stream and the
/// result does not depend on which thread does the work.
#[derive(Clone, Debug)]
pub struct Rng {
    state: u64,
}

impl Rng {
    /// The stream numbered `stream` of `seed`.
    pub fn new(seed: u64, stream: u64) -> Self {
        Self { state: mix(seed ^ mix(stream.wrapping_add(WEYL))) }
    }

    /// The next 64 random bits.
    #[inline]
    pub fn bits(&mut self) -> u64 {
        self.state = self.state.wrapping_add(WEYL);
        mix(self.state)
    }

    /// The next number in [0, 1).
    #[inline]
    pub fn uniform(&mut self) -> f64 {
        // 53 bits fill the mantissa
        (self.bits() >> 11) as f64 * 2.0_f64.powi(-53)
    }
}

/// 2⁶⁴ over the golden ratio, made odd: the step of the Weyl sequence.
const WEYL: u64 = 0x9e37_79b9_7f4a_7c15;

/// Spreads every bit of `z` over all 64 (the finaliser of SplitMix64, variant 13 of D. Stafford).
#[inline]
pub fn mix(z: u64) -> u64 {
    let z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The same seed and stream give the same numbers; another stream gives others.
    #[test]
    fn streams_are_reproducible_and_distinct() {
        let draw = |seed, stream| {
            let mut rng = Rng::new(seed, stream);
            std::array::from_fn::<u64, 4, _>(|_| rng.bits())
        };
        assert_eq!(draw(7, 3), draw(7, 3));
        assert_ne!(draw(7, 3), draw(7, 4));
        assert_ne!(draw(7, 3), draw(3, 7));
    }

    /// Mean 1/2 and variance 1/12, also across neighbouring streams.
    #[test]
    fn numbers_are_uniform_within_and_across_streams() {
        let n = 1 << 16;
        let mut one = Rng::new(1, 0);
        for values in [
            (0..n).map(|_| one.uniform()).collect::<Vec<_>>(),
            (0..n).map(|stream| Rng::new(1, stream).uniform()).collect(),
        ] {
            let mean = values.iter().sum::<f64>() / n as f64;
            let variance = values.iter().map(|u| (u - mean) * (u - mean)).sum::<f64>() / n as f64;
            // five standard errors of each
            assert!((mean - 0.5).abs() < 5.0 * (1.0 / 12.0 / n as f64).sqrt(), "{mean}");
            assert!((variance - 1.0 / 12.0).abs() < 5.0 * (1.0 / 180.0 / n as f64).sqrt(), "{variance}");
        }
    }
}
