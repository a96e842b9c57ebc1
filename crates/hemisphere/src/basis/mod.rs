//! Bases of the sky: the upper hemisphere cut into patches, with the ground as one more patch below.
//!
//! A basis is a table of [`Ring`]s from the horizon to the zenith. Sizes, centres, solid angles, numbering and look-up
//! follow from it. Patches are numbered ring by ring from the horizon up, clockwise from north, the ground last.

mod numbering;
mod tables;

pub use numbering::Order;
pub use tables::Ring;

use crate::Vec3;
use std::f64::consts::{FRAC_PI_2, TAU};

/// A sky cut into patches, and the ground.
#[derive(Clone, Debug, PartialEq)]
pub struct SkyBasis {
    name: String,
    rings: Vec<Ring>,
    /// Index of the first patch of each ring, then the number of sky patches.
    first: Vec<usize>,
    /// Sine of the lower altitude of each ring.
    sine_low: Vec<f64>,
}

/// Where a patch lies [rad]: altitudes above the horizon, azimuths clockwise from north (`azimuth_low` may be negative).
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
        let sine_low = rings.iter().map(|ring| ring.altitude_low.sin()).collect();
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
        let ring = self.sine_low.partition_point(|&low| low <= outward.z).max(1) - 1;
        let Ring { count, azimuth_low, .. } = self.rings[ring];
        if count == 1 {
            return self.first[ring];
        }
        // clockwise from north (y) over east (x)
        let turn = (outward.x.atan2(outward.y) - azimuth_low) / TAU;
        let place = (turn - turn.floor()) * count as f64;
        self.first[ring] + (place as usize).min(count - 1)
    }

    /// Where patch `index` lies; the ground reaches from −90° to 0°.
    pub fn bounds(&self, index: usize) -> PatchBounds {
        if index >= self.ground() {
            return PatchBounds { altitude_low: -FRAC_PI_2, altitude_high: 0.0, azimuth_low: 0.0, azimuth_high: TAU };
        }
        let ring = self.first.partition_point(|&first| first <= index) - 1;
        let Ring { altitude_low, altitude_high, count, azimuth_low } = self.rings[ring];
        let width = TAU / count as f64;
        let azimuth_low = azimuth_low + width * (index - self.first[ring]) as f64;
        PatchBounds { altitude_low, altitude_high, azimuth_low, azimuth_high: azimuth_low + width }
    }

    /// Solid angle of patch `index` \[sr\]; that of the ground is 2π.
    pub fn solid_angle(&self, index: usize) -> f64 {
        let b = self.bounds(index);
        (b.azimuth_high - b.azimuth_low) * (b.altitude_high.sin() - b.altitude_low.sin())
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
        let b = self.bounds(index);
        // area on the sphere is uniform in the sine of the altitude
        let (low, high) = (b.altitude_low.sin(), b.altitude_high.sin());
        let z = low + u[0] * (high - low);
        let azimuth = b.azimuth_low + u[1] * (b.azimuth_high - b.azimuth_low);
        let across = (1.0 - z * z).max(0.0).sqrt();
        Vec3::new(across * azimuth.sin(), across * azimuth.cos(), z)
    }

    /// Luminances, but for a factor, of the traditional overcast sky (1 + 2 sin γ)/3, averaged over each patch, and of ground of
    /// this reflectance under it (Moon and Spencer 1942; theory/room.md, eq. 10).
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

/// The unit vector towards this altitude and azimuth (clockwise from north) [rad].
pub fn towards(altitude: f64, azimuth: f64) -> Vec3 {
    let across = altitude.cos();
    Vec3::new(across * azimuth.sin(), across * azimuth.cos(), altitude.sin())
}
