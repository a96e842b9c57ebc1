//! Klems bases: the half space of directions about a window's normal cut into rings of patches.
//!
//! A patch is named by (x, y) of a unit vector alone, so one basis serves both sides. A basis is a table of [`KlemsRing`]s from the
//! normal to the plane; solid angles, centres, look-up and sampling follow from it. Patches are numbered ring by ring from the
//! normal, the first of a ring centred on +x, counter-clockwise: LBNL's order.

use crate::{Direction, Vec3};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// Patches between two angles from the normal, all of one width, the first centred on +x.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct KlemsRing {
    /// Least angle from the normal \[rad\].
    pub theta_low: f64,
    /// Greatest angle from the normal \[rad\].
    pub theta_high: f64,
    /// How many patches share the ring.
    pub count: usize,
}

/// Lower angle from the normal \[degrees\] and number of patches of each ring
/// (J. H. Klems, *ASHRAE Transactions* 100(1), 1994; the tables of LBNL's WINDOW).
const FULL: [(f64, usize); 9] =
    [(0.0, 1), (5.0, 8), (15.0, 16), (25.0, 20), (35.0, 24), (45.0, 24), (55.0, 24), (65.0, 16), (75.0, 12)];
const HALF: [(f64, usize); 7] = [(0.0, 1), (6.5, 8), (19.5, 12), (32.5, 16), (45.5, 20), (58.5, 12), (71.5, 8)];
const QUARTER: [(f64, usize); 5] = [(0.0, 1), (9.0, 8), (27.0, 12), (45.0, 12), (63.0, 8)];

/// The directions of one side cut into patches.
#[derive(Clone, Debug, PartialEq)]
pub struct KlemsBasis {
    name: String,
    rings: Vec<KlemsRing>,
    /// Index of the first patch of each ring, then the number of patches.
    first: Vec<usize>,
    /// Square of the sine of each ring's least angle, then 1.
    sine2_low: Vec<f64>,
}

impl KlemsBasis {
    /// Names of the known bases, from the finest to the coarsest.
    pub const NAMES: [&'static str; 3] = ["klems_full", "klems_half", "klems_quarter"];

    /// The basis called `klems_full` (145 patches), `klems_half` (77) or `klems_quarter` (41); `None` for another name.
    pub fn named(name: &str) -> Option<Self> {
        let place = Self::NAMES.iter().position(|known| *known == name)?;
        let table = [&FULL[..], &HALF, &QUARTER][place];
        let (low, counts): (Vec<f64>, Vec<usize>) = table.iter().map(|&(degrees, count)| (degrees, count)).unzip();
        Self::of_rings(name, &low, &counts)
    }

    /// A basis of another's making, from the least angle from the normal of each ring \[degrees\] and its number of patches.
    /// `None` unless the angles rise from 0 and end below 90, each with at least one patch.
    pub fn of_rings(name: &str, low_deg: &[f64], counts: &[usize]) -> Option<Self> {
        let rises = low_deg.windows(2).all(|pair| pair[0] < pair[1]);
        let ends = low_deg.first() == Some(&0.0) && low_deg.last().is_some_and(|&last| last < 90.0);
        if !(rises && ends) || counts.len() != low_deg.len() || counts.contains(&0) {
            return None;
        }
        let low = |i: usize| low_deg.get(i).map_or(FRAC_PI_2, |degrees| degrees.to_radians());
        let ring = |i: usize| KlemsRing { theta_low: low(i), theta_high: low(i + 1), count: counts[i] };
        let mut first = vec![0];
        for count in counts {
            first.push(first[first.len() - 1] + count);
        }
        // written out at the plane itself, so that the patches fill the half space exactly
        let mut sine2_low: Vec<f64> = (0..counts.len()).map(|i| low(i).sin().powi(2)).collect();
        sine2_low.push(1.0);
        Some(Self { name: name.to_owned(), rings: (0..counts.len()).map(ring).collect(), first, sine2_low })
    }

    /// Its name.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Its rings, from the normal outwards.
    pub fn rings(&self) -> &[KlemsRing] {
        &self.rings
    }

    /// Number of patches.
    pub fn patches(&self) -> usize {
        self.first[self.rings.len()]
    }

    /// The patch that (x, y) of a unit vector lies in.
    #[inline]
    pub fn find(&self, x: f64, y: f64) -> usize {
        let sine2 = x * x + y * y;
        let ring = self.sine2_low[1..self.rings.len()].partition_point(|&low| low <= sine2);
        let count = self.rings[ring].count;
        if count == 1 {
            return self.first[ring];
        }
        // −½ … ½ turn from +x, the first patch reaching half its width either way
        let place = (y.atan2(x) * (1.0 / TAU) * count as f64 + 0.5).floor();
        self.first[ring] + (place as isize).rem_euclid(count as isize) as usize
    }

    /// Number of the ring of a patch.
    pub fn ring_of(&self, index: usize) -> usize {
        self.first.partition_point(|&first| first <= index) - 1
    }

    /// Angles from the normal and azimuths from +x that a patch lies between \[rad\]: \[θ low, θ high\], \[φ low, φ high\].
    pub fn bounds(&self, index: usize) -> ([f64; 2], [f64; 2]) {
        let ring = self.ring_of(index);
        let KlemsRing { theta_low, theta_high, count } = self.rings[ring];
        let width = TAU / count as f64;
        let phi = width * ((index - self.first[ring]) as f64 - 0.5);
        ([theta_low, theta_high], [phi, phi + width])
    }

    /// Solid angle of a patch \[sr\].
    pub fn solid_angle(&self, index: usize) -> f64 {
        let KlemsRing { theta_low, theta_high, count } = self.rings[self.ring_of(index)];
        TAU / count as f64 * (theta_low.cos() - theta_high.cos())
    }

    /// Solid angle of a patch weighted by the cosine from the normal \[sr\]: π (sin²θ₂ − sin²θ₁)/count. All together are π.
    pub fn projected_solid_angle(&self, index: usize) -> f64 {
        let ring = self.ring_of(index);
        PI * (self.sine2_low[ring + 1] - self.sine2_low[ring]) / self.rings[ring].count as f64
    }

    /// The direction through the middle of a patch in angle and azimuth, on the side z > 0; that of the cap is the normal.
    pub fn centre(&self, index: usize) -> Direction {
        let (theta, phi) = self.bounds(index);
        if self.rings[self.ring_of(index)].count == 1 {
            return Direction::from_unit(Vec3::Z);
        }
        direction(0.5 * (theta[0] + theta[1]), 0.5 * (phi[0] + phi[1]))
    }

    /// (x, y) of a direction in a patch, uniform over its projected solid angle for `u` uniform in the unit square.
    pub fn sample(&self, index: usize, u: [f64; 2]) -> [f64; 2] {
        let ring = self.ring_of(index);
        let sine = (self.sine2_low[ring] + u[0] * (self.sine2_low[ring + 1] - self.sine2_low[ring])).sqrt();
        let phi = TAU / self.rings[ring].count as f64 * ((index - self.first[ring]) as f64 - 0.5 + u[1]);
        [sine * phi.cos(), sine * phi.sin()]
    }

    /// The patch of (−x, −y); of even rings and caps alone.
    pub fn turned(&self, index: usize) -> usize {
        let ring = self.ring_of(index);
        let count = self.rings[ring].count;
        self.first[ring] + (index - self.first[ring] + count / 2) % count
    }

    /// The patch of (−x, y); of even rings and caps alone.
    pub fn mirrored_in_x(&self, index: usize) -> usize {
        let ring = self.ring_of(index);
        let count = self.rings[ring].count;
        // azimuth π − φ
        self.first[ring] + (count / 2 + count - (index - self.first[ring])) % count
    }
}

/// The unit vector at this angle from +z and this azimuth from +x \[rad\].
fn direction(theta: f64, phi: f64) -> Direction {
    let (sine, cosine) = theta.sin_cos();
    Direction::from_unit(Vec3::new(sine * phi.cos(), sine * phi.sin(), cosine))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Rng;

    fn bases() -> impl Iterator<Item = KlemsBasis> {
        KlemsBasis::NAMES.iter().map(|name| KlemsBasis::named(name).expect("known"))
    }

    /// Sizes as published; projected solid angles fill π, solid angles 2π.
    #[test]
    fn patches_fill_the_half_space() {
        for (basis, count) in bases().zip([145, 77, 41]) {
            assert_eq!(basis.patches(), count);
            let projected: f64 = (0..count).map(|i| basis.projected_solid_angle(i)).sum();
            let solid: f64 = (0..count).map(|i| basis.solid_angle(i)).sum();
            assert!((projected - PI).abs() < 1e-13 && (solid - TAU).abs() < 1e-13, "{}", basis.name());
        }
        assert!(KlemsBasis::named("klems").is_none());
        for (low, counts) in [(&[0.0, 95.0][..], &[1, 8][..]), (&[5.0], &[1]), (&[0.0, 5.0], &[1]), (&[0.0], &[0])] {
            assert!(KlemsBasis::of_rings("own", low, counts).is_none());
        }
    }

    /// LBNL's numbering: the first patch of a ring on +x, then counter-clockwise, the cap first of all.
    #[test]
    fn numbering_is_lbnls() {
        let basis = KlemsBasis::named("klems_full").expect("known");
        let at = |theta: f64, phi: f64| {
            let (theta, phi) = (theta.to_radians(), phi.to_radians());
            basis.find(theta.sin() * phi.cos(), theta.sin() * phi.sin())
        };
        assert_eq!([at(0.0, 0.0), at(4.9, 200.0)], [0, 0]);
        assert_eq!([at(10.0, 0.0), at(10.0, 22.0), at(10.0, -22.0), at(10.0, 90.0), at(10.0, -45.0)], [1, 1, 1, 3, 8]);
        assert_eq!([at(80.0, 0.0), at(89.99, -16.0), at(90.0, 180.0)], [133, 144, 139]);
    }

    /// Centres, samples, turns and mirror images lie where they should, in every patch.
    #[test]
    fn look_up_finds_centres_samples_and_images() {
        let mut rng = Rng::new(1, 0);
        for basis in bases() {
            for i in 0..basis.patches() {
                let centre = basis.centre(i);
                assert_eq!(basis.find(centre.x, centre.y), i);
                for _ in 0..20 {
                    let [x, y] = basis.sample(i, [rng.uniform(), rng.uniform()]);
                    assert_eq!(basis.find(x, y), i);
                    assert_eq!(basis.find(-x, -y), basis.turned(i));
                    assert_eq!(basis.find(-x, y), basis.mirrored_in_x(i));
                }
            }
        }
    }

    /// Samples fill a patch evenly in the plane of (x, y), which is projected solid angle.
    #[test]
    fn samples_are_even_over_projected_solid_angle() {
        let basis = KlemsBasis::named("klems_quarter").expect("known");
        let n = 300;
        let (mut sum, mut sum2) = (0.0, 0.0);
        for k in 0..n * n {
            let u = [((k / n) as f64 + 0.5) / n as f64, ((k % n) as f64 + 0.5) / n as f64];
            let [x, _] = basis.sample(40, u);
            (sum, sum2) = (sum + x, sum2 + x * x);
        }
        // ∫ x, ∫ x² over the ring's piece in polar coordinates
        let ([t0, t1], [p0, p1]) = basis.bounds(40);
        let (r0, r1) = (t0.sin(), t1.sin());
        let area = basis.projected_solid_angle(40);
        let mean = (r1.powi(3) - r0.powi(3)) / 3.0 * (p1.sin() - p0.sin()) / area;
        let square =
            (r1.powi(4) - r0.powi(4)) / 4.0 * 0.5 * (p1 - p0 + 0.5 * ((2.0 * p1).sin() - (2.0 * p0).sin())) / area;
        let count = (n * n) as f64;
        assert!((sum / count - mean).abs() < 1e-5 && (sum2 / count - square).abs() < 1e-5);
    }
}
