//! Bases of the sky: the upper hemisphere cut into patches, with the ground as one more patch below.
//!
//! A basis is a table of [`Ring`]s from the horizon to the zenith. Sizes, centres, solid angles, numbering and look-up
//! follow from it. Patches are numbered ring by ring from the horizon up, clockwise from north, the ground last.

mod numbering;
mod tables;

pub use numbering::Order;
pub use tables::Ring;

use crate::Vec3;
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// A sky cut into patches, and the ground.
#[derive(Clone, Debug, PartialEq)]
pub struct SkyBasis {
    name: String,
    rings: Vec<Ring>,
    /// Index of the first patch of each ring, then the number of sky patches.
    first: Vec<usize>,
    /// Sine of the lower altitude of each ring, then of the zenith.
    sine_low: Vec<f64>,
}

/// Where a patch lies \[rad\]: altitudes above the horizon, azimuths clockwise from north (`azimuth_low` may be negative).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PatchBounds {
    /// Lower altitude.
    pub altitude_low: f64,
    /// Upper altitude.
    pub altitude_high: f64,
    /// First azimuth.
    pub azimuth_low: f64,
    /// Last azimuth.
    pub azimuth_high: f64,
}

impl SkyBasis {
    /// A basis from its rings, from the horizon to the zenith.
    fn of_rings(name: &str, rings: Vec<Ring>) -> Self {
        let mut first = vec![0];
        for ring in &rings {
            first.push(first[first.len() - 1] + ring.count);
        }
        let sine_low = rings.iter().map(|ring| ring.altitude_low.sin()).chain([1.0]).collect();
        Self { name: name.to_owned(), rings, first, sine_low }
    }

    /// The basis called `tregenza145`, `reinhart577`, `reinhart2305` … (144 MF² + 1) or `troplux5221`; `None` for another name.
    pub fn named(name: &str) -> Option<Self> {
        tables::rings_named(name).map(|rings| Self::of_rings(name, rings))
    }

    /// Its name.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Its rings, from the horizon up.
    pub fn rings(&self) -> &[Ring] {
        &self.rings
    }

    /// Number of patches, the ground included.
    pub fn patches(&self) -> usize {
        self.ground() + 1
    }

    /// Index of the ground, the last patch.
    pub fn ground(&self) -> usize {
        self.first[self.rings.len()]
    }

    /// The patch that light comes from when one looks along `outward`: the ground below the horizon.
    #[inline]
    pub fn find(&self, outward: Vec3) -> usize {
        if outward.z < 0.0 {
            return self.ground();
        }
        // the highest ring that begins at or below this altitude
        let low = &self.sine_low[..self.rings.len()];
        let below = if low.len() <= FEW_RINGS {
            low.iter().filter(|&&low| low <= outward.z).count()
        } else {
            low.partition_point(|&low| low <= outward.z)
        };
        let ring = below.max(1) - 1;
        let Ring { count, azimuth_low, .. } = self.rings[ring];
        if count == 1 {
            return self.first[ring];
        }
        // clockwise from north (y) over east (x); a rough angle does unless an edge is near
        let place = |azimuth: f64| {
            // azimuths are −π..π and the first patch begins near north
            let turn = (azimuth - azimuth_low) * (1.0 / TAU);
            (if turn < 0.0 { turn + 1.0 } else { turn }) * count as f64
        };
        let mut within = place(rough_angle(outward.y, outward.x));
        let from_edge = within - (within as usize) as f64;
        let doubt = ROUGH * count as f64;
        if from_edge < doubt || from_edge > 1.0 - doubt {
            within = place(outward.x.atan2(outward.y));
        }
        self.first[ring] + (within as usize).min(count - 1)
    }

    /// Where patch `index` lies; the ground reaches from −90° to 0°.
    pub fn bounds(&self, index: usize) -> PatchBounds {
        if index >= self.ground() {
            return PatchBounds { altitude_low: -FRAC_PI_2, altitude_high: 0.0, azimuth_low: 0.0, azimuth_high: TAU };
        }
        let ring = self.ring_of(index);
        let Ring { altitude_low, altitude_high, count, azimuth_low } = self.rings[ring];
        let width = TAU / count as f64;
        let azimuth_low = azimuth_low + width * (index - self.first[ring]) as f64;
        PatchBounds { altitude_low, altitude_high, azimuth_low, azimuth_high: azimuth_low + width }
    }

    fn ring_of(&self, index: usize) -> usize {
        self.first.partition_point(|&first| first <= index) - 1
    }

    /// Solid angle of patch `index` \[sr\]; that of the ground is 2π.
    pub fn solid_angle(&self, index: usize) -> f64 {
        if index >= self.ground() {
            return TAU;
        }
        let ring = self.ring_of(index);
        TAU / self.rings[ring].count as f64 * (self.sine_low[ring + 1] - self.sine_low[ring])
    }

    /// The direction towards the middle of patch `index`, half-way in altitude and azimuth; a cap's and the ground's is its pole.
    pub fn centre(&self, index: usize) -> Vec3 {
        let b = self.bounds(index);
        if index >= self.ground() {
            return -Vec3::Z;
        }
        // a whole turn up to the zenith is a cap
        if b.azimuth_high - b.azimuth_low > TAU - 1e-9 && b.altitude_high > FRAC_PI_2 - 1e-9 {
            return Vec3::Z;
        }
        towards(0.5 * (b.altitude_low + b.altitude_high), 0.5 * (b.azimuth_low + b.azimuth_high))
    }

    /// A direction towards patch `index`, uniform over its solid angle for `u` uniform in the unit square.
    pub fn sample(&self, index: usize, u: [f64; 2]) -> Vec3 {
        if index >= self.ground() {
            return Self::at(-1.0 + u[0], TAU * u[1]);
        }
        let ring = self.ring_of(index);
        let Ring { count, azimuth_low, .. } = self.rings[ring];
        // area on the sphere is uniform in the sine of the altitude
        let z = self.sine_low[ring] + u[0] * (self.sine_low[ring + 1] - self.sine_low[ring]);
        let place = (index - self.first[ring]) as f64 + u[1];
        Self::at(z, azimuth_low + TAU / count as f64 * place)
    }

    /// The direction at this sine of altitude and this azimuth.
    fn at(z: f64, azimuth: f64) -> Vec3 {
        let across = (1.0 - z * z).max(0.0).sqrt();
        let (sine, cosine) = azimuth.sin_cos();
        Vec3::new(across * sine, across * cosine, z)
    }

    /// Luminances, but for a factor, of the traditional overcast sky (1 + 2 sin γ)/3, averaged over each patch, and of ground of
    /// this reflectance under it (Moon and Spencer 1942; theory/room.md, eq. 11).
    pub fn overcast(&self, ground_reflectance: f64) -> Vec<f64> {
        let mut luminance: Vec<f64> = (0..self.ground())
            .map(|index| {
                let b = self.bounds(index);
                // the mean of sin γ over a patch is that of its bounds, for area is uniform in sin γ
                (1.0 + b.altitude_low.sin() + b.altitude_high.sin()) / 3.0
            })
            .collect();
        // E_h = ∫ L sin γ dω = 7π/9, and diffuse ground has L = ρ E_h / π
        luminance.push(ground_reflectance * 7.0 / 9.0);
        luminance
    }
}

/// Rings that are counted sooner than searched.
const FEW_RINGS: usize = 16;

/// Error of [`rough_angle`], in turns, generously.
const ROUGH: f64 = 1e-5;

/// The angle of (x, y) to within 2e-5 rad: a polynomial for the arctangent of 0..1
/// (M. Abramowitz, I. A. Stegun, *Handbook of Mathematical Functions*, 4.4.47) in the right octant.
fn rough_angle(x: f64, y: f64) -> f64 {
    let (long, short) = (x.abs().max(y.abs()), x.abs().min(y.abs()));
    let t = if long > 0.0 { short / long } else { 0.0 };
    let s = t * t;
    let octant = t * (0.9998660 + s * (-0.3302995 + s * (0.1801410 + s * (-0.0851330 + s * 0.0208351))));
    let quadrant = if y.abs() > x.abs() { FRAC_PI_2 - octant } else { octant };
    let half = if x < 0.0 { PI - quadrant } else { quadrant };
    half.copysign(y)
}

/// The unit vector towards this altitude and azimuth (clockwise from north) \[rad\].
pub fn towards(altitude: f64, azimuth: f64) -> Vec3 {
    let across = altitude.cos();
    Vec3::new(across * azimuth.sin(), across * azimuth.cos(), altitude.sin())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The rough angle is never further off than is allowed for.
    #[test]
    fn rough_angle_is_within_its_bound() {
        for i in 0..100_000 {
            let angle = TAU * (f64::from(i) / 1e5 - 0.5);
            let (y, x) = angle.sin_cos();
            assert!((rough_angle(x, y) - y.atan2(x)).abs() < ROUGH * TAU, "{angle}");
        }
    }
}
