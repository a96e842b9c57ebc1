//! Well-spread random numbers: an Owen-scrambled Sobol sequence by hashing.
//!
//! The first [`DIMENSIONS`] dimensions are true Sobol dimensions; beyond them the sequence is padded with further sets of as
//! many, each with its own order of the points (B. Burley, *Practical Hash-based Owen Scrambling*, JCGT 9(4), 2020).
//! Any 2ᵏ consecutive points from a multiple of 2ᵏ on are stratified, and every point on its own is uniform.

use crate::rng::mix;

/// True Sobol dimensions in one set: what belongs together in one event should share a set.
pub const DIMENSIONS: usize = 8;

/// An Owen-scrambled Sobol sequence; another seed is an independent randomisation of the same net.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Sobol {
    /// Which randomisation.
    pub seed: u64,
}

impl Sobol {
    /// Coordinate `dimension` of point `index`, in [0, 1).
    #[inline]
    pub fn sample(&self, index: u32, dimension: u32) -> f64 {
        self.point(index, dimension / DIMENSIONS as u32).coordinate(dimension as usize % DIMENSIONS)
    }

    /// Point `index` in one set, dimensions 8 `set` … 8 `set` + 7, its coordinates computed as they are asked for.
    #[inline]
    pub fn point(&self, index: u32, set: u32) -> SobolPoint {
        let seed = self.set_seed(set);
        SobolPoint { index: shuffled(index, seed), seed }
    }

    /// All coordinates of point `index` in one set.
    #[inline]
    pub fn set(&self, index: u32, set: u32) -> [f64; DIMENSIONS] {
        let point = self.point(index, set);
        std::array::from_fn(|d| point.coordinate(d))
    }

    #[inline]
    fn set_seed(&self, set: u32) -> u64 {
        mix(self.seed ^ (u64::from(set) << 32) ^ 0x5851_f42d_4c95_7f2d)
    }
}

/// One point of one set of dimensions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SobolPoint {
    index: u32,
    seed: u64,
}

impl SobolPoint {
    /// Coordinate `d` (0..8), in [0, 1).
    #[inline]
    pub fn coordinate(&self, d: usize) -> f64 {
        unit(scrambled(self.index, d, self.seed))
    }
}

/// The point's place in the set's own order: blocks of 2ᵏ points stay together.
#[inline]
fn shuffled(index: u32, seed: u64) -> u32 {
    laine_karras(index.reverse_bits(), seed as u32).reverse_bits()
}

/// The Sobol coordinate with its digits scrambled after Owen.
#[inline]
fn scrambled(index: u32, d: usize, seed: u64) -> u32 {
    let table = &SOBOL_REVERSED[d];
    let [b0, b1, b2, b3] = index.to_le_bytes();
    let x = table[0][b0 as usize] ^ table[1][b1 as usize] ^ table[2][b2 as usize] ^ table[3][b3 as usize];
    let seed = (seed >> 32) as u32 ^ (d as u32 + 1).wrapping_mul(0x9e37_79b9);
    laine_karras(x, seed.wrapping_mul(0x85eb_ca6b) ^ (seed >> 15)).reverse_bits()
}

/// A hash in which each bit depends on the bits below it alone: an Owen scramble of bit-reversed numbers
/// (S. Laine, T. Karras, *Stratified Sampling for Stochastic Transparency*, EGSR 2011).
#[inline]
fn laine_karras(x: u32, seed: u32) -> u32 {
    let mut x = x ^ x.wrapping_mul(0x3d20_adea);
    x = x.wrapping_add(seed);
    x = x.wrapping_mul((seed >> 16) | 1);
    x ^= x.wrapping_mul(0x0552_6c56);
    x ^ x.wrapping_mul(0x53a2_2864)
}

#[inline]
fn unit(x: u32) -> f64 {
    f64::from(x) * 2.0_f64.powi(-32)
}

/// Primitive polynomials (degree, inner coefficients) and first direction numbers of dimensions 2 to 8
/// (S. Joe, F. Y. Kuo, *Constructing Sobol sequences with better two-dimensional projections*, SIAM J. Sci. Comput. 30, 2008).
const JOE_KUO: [(usize, u32, [u32; 5]); DIMENSIONS - 1] = [
    (1, 0, [1, 0, 0, 0, 0]),
    (2, 1, [1, 3, 0, 0, 0]),
    (3, 1, [1, 3, 1, 0, 0]),
    (3, 2, [1, 1, 1, 0, 0]),
    (4, 1, [1, 1, 3, 3, 0]),
    (4, 4, [1, 3, 5, 13, 0]),
    (5, 2, [1, 1, 5, 5, 17]),
];

/// Bit-reversed Sobol coordinates of every byte of an index, for each dimension: four look-ups make a coordinate.
static SOBOL_REVERSED: [[[u32; 256]; 4]; DIMENSIONS] = byte_tables();

const fn direction_numbers(d: usize) -> [u32; 32] {
    let mut v = [0u32; 32];
    let mut i = 0;
    if d == 0 {
        while i < 32 {
            v[i] = 1 << (31 - i);
            i += 1;
        }
        return v;
    }
    let (degree, coefficients, first) = JOE_KUO[d - 1];
    while i < 32 {
        if i < degree {
            v[i] = first[i] << (31 - i);
        } else {
            // the recurrence of the primitive polynomial
            let mut x = v[i - degree] ^ (v[i - degree] >> degree);
            let mut k = 1;
            while k < degree {
                if (coefficients >> (degree - 1 - k)) & 1 == 1 {
                    x ^= v[i - k];
                }
                k += 1;
            }
            v[i] = x;
        }
        i += 1;
    }
    v
}

const fn byte_tables() -> [[[u32; 256]; 4]; DIMENSIONS] {
    let mut tables = [[[0u32; 256]; 4]; DIMENSIONS];
    let mut d = 0;
    while d < DIMENSIONS {
        let v = direction_numbers(d);
        let mut byte = 0;
        while byte < 4 {
            let mut value = 0;
            while value < 256 {
                let mut x = 0;
                let mut bit = 0;
                while bit < 8 {
                    if (value >> bit) & 1 == 1 {
                        x ^= v[8 * byte + bit];
                    }
                    bit += 1;
                }
                tables[d][byte][value] = x.reverse_bits();
                value += 1;
            }
            byte += 1;
        }
        d += 1;
    }
    tables
}

#[cfg(test)]
mod tests {
    use super::*;

    /// In every dimension, 2ᵏ points fall into 2ᵏ equal intervals one each, wherever their block begins.
    #[test]
    fn every_dimension_is_stratified() {
        let sobol = Sobol { seed: 42 };
        for dimension in 0..24 {
            for first in [0, 256, 7 * 256] {
                let mut hit = [false; 256];
                for index in first..first + 256 {
                    hit[(sobol.sample(index, dimension) * 256.0) as usize] = true;
                }
                assert!(hit.iter().all(|&h| h), "dimension {dimension}, block at {first}");
            }
        }
    }

    /// The first two dimensions form a (0, m, 2)-net: every elementary rectangle of area 1/256 holds one of 256 points.
    #[test]
    fn first_pair_is_a_perfect_net() {
        let sobol = Sobol { seed: 5 };
        for a in 0..=8 {
            let (columns, rows) = (1 << a, 256 >> a);
            let mut count = vec![0; 256];
            for index in 0..256 {
                let [x, y, ..] = sobol.set(index, 3);
                let cell = (x * f64::from(columns)) as usize * rows as usize + (y * f64::from(rows)) as usize;
                count[cell] += 1;
            }
            assert!(count.iter().all(|&c| c == 1), "{columns} × {rows}");
        }
    }

    /// A set is its coordinates, and the same seed says the same; another seed another net.
    #[test]
    fn points_are_reproducible() {
        let sobol = Sobol { seed: 9 };
        let set = sobol.set(1234, 2);
        for (d, &x) in set.iter().enumerate() {
            assert_eq!(x, sobol.sample(1234, 16 + d as u32));
        }
        assert_ne!(set, Sobol { seed: 10 }.set(1234, 2));
        assert_ne!(set, sobol.set(1234, 1));
    }

    /// The integral of a smooth function in 6 dimensions: the error over 64 randomisations is far below that of
    /// independent points, and its mean agrees with the closed form within its standard error.
    #[test]
    fn smooth_integrals_are_unbiased_and_precise() {
        let (points, randomisations) = (1024, 64);
        let estimates: Vec<f64> = (0..randomisations)
            .map(|seed| {
                let sobol = Sobol { seed };
                let sum: f64 = (0..points).map(|i| (0..6).map(|d| 0.5 + sobol.sample(i, d)).product::<f64>()).sum();
                sum / f64::from(points)
            })
            .collect();
        let n = estimates.len() as f64;
        let mean = estimates.iter().sum::<f64>() / n;
        let deviation = (estimates.iter().map(|e| (e - mean) * (e - mean)).sum::<f64>() / (n - 1.0)).sqrt();
        // variance of the product of six factors of mean 1 and variance 1/12, were the points independent
        let independent = (((1.0 + 1.0 / 12.0_f64).powi(6) - 1.0) / f64::from(points)).sqrt();
        assert!((mean - 1.0).abs() < 4.0 * deviation / n.sqrt(), "{mean} ± {}", deviation / n.sqrt());
        assert!(deviation < 0.1 * independent, "{deviation:.2e} against {independent:.2e}");
    }

    /// Across randomisations a point is uniform and unrelated to its neighbour and to the next dimension.
    #[test]
    fn randomisations_are_independent() {
        let n = 4096;
        let centred = |index, dimension| -> Vec<f64> {
            (0..n).map(|seed| Sobol { seed }.sample(index, dimension) - 0.5).collect()
        };
        let (a, b, c) = (centred(0, 0), centred(0, 1), centred(0, 9));
        let product = |x: &[f64], y: &[f64]| 12.0 * x.iter().zip(y).map(|(x, y)| x * y).sum::<f64>() / n as f64;
        let resolution = 5.0 / (n as f64).sqrt();
        assert!((product(&a, &a) - 1.0).abs() < resolution);
        for (x, y) in [(&a, &b), (&a, &c), (&b, &c)] {
            assert!(product(x, y).abs() < resolution, "{}", product(x, y));
        }
    }
}
