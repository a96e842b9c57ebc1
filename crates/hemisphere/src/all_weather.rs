//! The all-weather sky: its relative luminance, and its mean over every patch of a basis by quadrature.

use crate::{Ring, SkyBasis, Vec3};
use std::f64::consts::{FRAC_PI_3, PI, TAU};

/// One moment's sky of Perez, Seals and Michalsky by its five parameters (theory/perez.md, eq. 5).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AllWeather {
    /// Darkening (< 0) or brightening of the horizon.
    pub a: f64,
    /// How steeply luminance changes towards the horizon.
    pub b: f64,
    /// Height of the glow about the sun.
    pub c: f64,
    /// How fast the glow falls off \[1/rad\].
    pub d: f64,
    /// Light scattered back.
    pub e: f64,
}

/// Below this sine of altitude the gradation stays what it is: 1 / sin γ has no bound (theory/perez.md, clamps).
const LEAST_SINE: f64 = 0.01;

impl AllWeather {
    /// Luminance, but for a factor, at this sine of altitude and this cosine of the angle from the sun; never negative.
    pub fn luminance(&self, sine: f64, cos_from_sun: f64) -> f64 {
        let x = cos_from_sun.clamp(-1.0, 1.0);
        let indicatrix = 1.0 + self.c * (self.d * x.acos()).exp() + self.e * x * x;
        (self.gradation(sine) * indicatrix).max(0.0)
    }

    fn gradation(&self, sine: f64) -> f64 {
        1.0 + self.a * (self.b / sine.max(LEAST_SINE)).exp()
    }
}

/// Directions in every patch of a basis whose weighted mean is the mean over the patch.
#[derive(Clone, Debug)]
pub struct SkyNodes {
    rings: Vec<RingNodes>,
    ground: usize,
}

#[derive(Clone, Debug)]
struct RingNodes {
    first: usize,
    count: usize,
    /// ∫ sin γ dω over one patch.
    projected: f64,
    /// Sine of altitude and weight; the weights sum to 1.
    rows: Vec<(f64, f64)>,
    /// Weight, then north and east of the azimuth in each patch; the weights sum to 1.
    columns: Vec<(f64, Vec<f32>, Vec<f32>)>,
}

impl SkyNodes {
    /// Gauss–Legendre points, `order` each way, in sin γ and azimuth, which are even in solid angle; 0 means the centres alone,
    /// which then stand for all of their patch.
    /// A patch wider than 60°, as the zenith cap is, is cut into sectors first.
    pub fn new(basis: &SkyBasis, order: usize) -> Self {
        let rule = gauss_legendre(order);
        let mut first = 0;
        let rings = basis
            .rings()
            .iter()
            .map(|ring| {
                let nodes = RingNodes::new(ring, first, &rule);
                first += ring.count;
                nodes
            })
            .collect();
        Self { rings, ground: first }
    }

    /// Number of sky patches, the ground not among them.
    pub fn sky_patches(&self) -> usize {
        self.ground
    }

    /// Mean luminance of every sky patch of this sky with the sun towards `sun`, scaled so that patches of these means light an
    /// unobstructed horizontal plane with `horizontal` (theory/perez.md, eqs. 9–10). A sky that is black everywhere becomes uniform.
    ///
    /// # Panics
    /// If `out` is shorter than there are sky patches.
    pub fn patch_means(&self, sky: &AllWeather, sun: Vec3, horizontal: f64, out: &mut [f32]) {
        let out = &mut out[..self.ground];
        out.fill(0.0);
        let glow = Glow { c: sky.c as f32, d: sky.d as f32, e: sky.e as f32 };
        let mut relative = 0.0;
        for ring in &self.rings {
            let patches = &mut out[ring.first..ring.first + ring.count];
            for &(sine, row_weight) in &ring.rows {
                let across = (1.0 - sine * sine).max(0.0).sqrt();
                let [up, north, east] = [sine * sun.z, across * sun.y, across * sun.x].map(|x| x as f32);
                let gradation = sky.gradation(sine) * row_weight;
                for (weight, norths, easts) in &ring.columns {
                    glow.add(up, (north, norths), (east, easts), (gradation * weight) as f32, patches);
                }
            }
            relative += ring.projected * sum(patches);
        }
        if relative > 0.0 {
            let scale = (horizontal / relative) as f32;
            out.iter_mut().for_each(|mean| *mean *= scale);
        } else {
            out.fill((horizontal / PI) as f32);
        }
    }
}

impl RingNodes {
    fn new(ring: &Ring, first: usize, rule: &[(f64, f64)]) -> Self {
        let (low, high) = (ring.altitude_low.sin(), ring.altitude_high.sin());
        let width = TAU / ring.count as f64;
        let cap = ring.count == 1 && high > 1.0 - 1e-12;
        let centred = rule.is_empty();
        let rows = match (centred, cap) {
            (true, true) => vec![(1.0, 1.0)],
            (true, false) => vec![((0.5 * (ring.altitude_low + ring.altitude_high)).sin(), 1.0)],
            _ => rule.iter().map(|&(x, weight)| (low + (high - low) * x, weight)).collect(),
        };
        let sectors = if centred { 1 } else { (width / FRAC_PI_3 - 1e-9).ceil().max(1.0) as usize };
        let centre = [(0.5, 1.0)];
        let rule = if centred { &centre[..] } else { rule };
        let columns = (0..sectors)
            .flat_map(|sector| rule.iter().map(move |&(x, weight)| ((sector as f64 + x) / sectors as f64, weight)))
            .map(|(place, weight)| {
                let azimuths = (0..ring.count).map(|patch| ring.azimuth_low + width * (patch as f64 + place));
                let (east, north) =
                    azimuths.map(|azimuth| azimuth.sin_cos()).map(|(s, c)| (s as f32, c as f32)).unzip();
                (weight / sectors as f64, north, east)
            })
            .collect();
        // the solid angle times the mean sine of the altitude; of centres alone, their own sine, as Radiance has it
        let sine = if centred { rows[0].0 } else { 0.5 * (high + low) };
        let projected = width * (high - low) * sine;
        Self { first, count: ring.count, projected, rows, columns }
    }
}

/// What surrounds the sun, in single precision, written so that a compiler makes it several points at a time.
#[derive(Clone, Copy)]
struct Glow {
    c: f32,
    d: f32,
    e: f32,
}

impl Glow {
    fn add(self, up: f32, north: (f32, &[f32]), east: (f32, &[f32]), weight: f32, patches: &mut [f32]) {
        for ((mean, n), e) in patches.iter_mut().zip(north.1).zip(east.1) {
            let cosine = up + north.0 * n + east.0 * e;
            let luminance = weight * (1.0 + self.c * exp(self.d * arccos(cosine)) + self.e * cosine * cosine);
            *mean += if luminance > 0.0 { luminance } else { 0.0 };
        }
    }
}

/// arccos to 3e-7 (M. Abramowitz, I. A. Stegun, *Handbook of Mathematical Functions*, 4.4.46); beyond ±1 that of ±1.
#[inline]
fn arccos(x: f32) -> f32 {
    const POLYNOMIAL: [f64; 7] =
        [-0.0012624911, 0.0066700901, -0.0170881256, 0.0308918810, -0.0501743046, 0.0889789874, -0.2145988016];
    let size = if x < 0.0 { -x } else { x };
    let size = if size < 1.0 { size } else { 1.0 };
    let mut sum = POLYNOMIAL[0] as f32;
    for coefficient in &POLYNOMIAL[1..] {
        sum = sum * size + *coefficient as f32;
    }
    let angle = (1.0 - size).sqrt() * (sum * size + std::f32::consts::FRAC_PI_2);
    if x < 0.0 { std::f32::consts::PI - angle } else { angle }
}

/// eˣ to 8e-6 of itself (the argument's own rounding); beyond ±87 that of ±87.
#[inline]
fn exp(x: f32) -> f32 {
    /// Adding it leaves a number's whole part in the last bits.
    const ROUNDER: f32 = 12_582_912.0;
    let x = if x > -87.0 { x } else { -87.0 };
    let x = if x < 87.0 { x } else { 87.0 };
    let power = x * std::f32::consts::LOG2_E;
    let rounded = power + ROUNDER;
    let part = power - (rounded - ROUNDER);
    // 2^part for |part| ≤ 1/2 by its series
    let y = part * std::f32::consts::LN_2;
    let series =
        1.0 + y * (1.0 + y * (0.5 + y * (1.0 / 6.0 + y * (1.0 / 24.0 + y * (1.0 / 120.0 + y * (1.0 / 720.0))))));
    let whole = (rounded.to_bits() as i32).wrapping_sub(ROUNDER.to_bits() as i32);
    series * f32::from_bits(((whole + 127) << 23) as u32)
}

/// Sum of many numbers, eight at a time.
fn sum(values: &[f32]) -> f64 {
    let chunks = values.chunks_exact(8);
    let rest: f32 = chunks.remainder().iter().sum();
    let mut lanes = [0.0_f32; 8];
    for chunk in chunks {
        for (lane, value) in lanes.iter_mut().zip(chunk) {
            *lane += value;
        }
    }
    lanes.iter().map(|lane| f64::from(*lane)).sum::<f64>() + f64::from(rest)
}

/// Points of 0..1 and weights that sum to 1 (roots of the Legendre polynomial by Newton's method).
fn gauss_legendre(order: usize) -> Vec<(f64, f64)> {
    let n = order as f64;
    (0..order)
        .map(|i| {
            let mut x = (PI * (i as f64 + 0.75) / (n + 0.5)).cos();
            let mut slope = 1.0;
            for _ in 0..64 {
                let (mut before, mut value) = (0.0, 1.0);
                for k in 0..order {
                    let k = k as f64;
                    (before, value) = (value, ((2.0 * k + 1.0) * x * value - k * before) / (k + 1.0));
                }
                slope = n * (x * value - before) / (x * x - 1.0);
                let step = value / slope;
                x -= step;
                if step.abs() < 1e-15 {
                    break;
                }
            }
            (0.5 * (1.0 - x), 1.0 / ((1.0 - x * x) * slope * slope))
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    const CLEAR: AllWeather = AllWeather { a: -1.0, b: -0.3, c: 12.0, d: -3.5, e: 0.4 };

    fn towards_sun(altitude: f64) -> Vec3 {
        crate::towards(altitude, 2.0)
    }

    /// Single precision and its series are as good as they say.
    #[test]
    fn functions_are_what_they_approximate() {
        for i in 0..=20_000 {
            let x = -1.0 + f64::from(i) * 1e-4;
            assert!((f64::from(arccos(x as f32)) - f64::from(x as f32).acos()).abs() < 6e-7, "arccos {x}");
            let y = -80.0 + f64::from(i) * 8e-3;
            assert!((f64::from(exp(y as f32)) / f64::from(y as f32).exp() - 1.0).abs() < 8e-6, "exp {y}");
        }
        assert_eq!(arccos(1.5), 0.0);
    }

    /// Points of order n integrate polynomials up to 2 n − 1 exactly.
    #[test]
    fn points_integrate_polynomials() {
        for order in 1..8 {
            for power in 0..2 * order {
                let found: f64 = gauss_legendre(order).iter().map(|(x, w)| w * x.powi(power as i32)).sum();
                assert!((found - 1.0 / (power + 1) as f64).abs() < 1e-13, "{order} {power} {found}");
            }
        }
    }

    /// The patches light a horizontal plane as asked, whatever the basis, the order and the sky.
    #[test]
    fn horizontal_illuminance_is_kept() {
        for (name, order) in [("tregenza145", 4), ("reinhart577", 3), ("reinhart2305", 2), ("troplux5221", 2)] {
            let Some(basis) = SkyBasis::named(name) else { panic!("{name}") };
            let nodes = SkyNodes::new(&basis, order);
            let mut means = vec![0.0; basis.patches()];
            nodes.patch_means(&CLEAR, towards_sun(0.6), 12_345.0, &mut means);
            let horizontal: f64 = (0..nodes.sky_patches())
                .map(|p| {
                    let b = basis.bounds(p);
                    let mean_sine = 0.5 * (b.altitude_low.sin() + b.altitude_high.sin());
                    f64::from(means[p]) * basis.solid_angle(p) * mean_sine
                })
                .sum();
            assert!((horizontal / 12_345.0 - 1.0).abs() < 1e-5, "{name}: {horizontal}");
        }
    }

    /// Quadrature agrees with many random directions in every patch.
    #[test]
    fn means_are_those_of_many_directions() {
        let Some(basis) = SkyBasis::named("tregenza145") else { panic!() };
        let (nodes, sun) = (SkyNodes::new(&basis, 4), towards_sun(0.6));
        let mut means = vec![0.0; basis.patches()];
        nodes.patch_means(&CLEAR, sun, 1.0, &mut means);
        let steps = 64;
        let sampled: Vec<f64> = (0..nodes.sky_patches())
            .map(|p| {
                let place = |i: usize| (i as f64 + 0.5) / steps as f64;
                let each = (0..steps * steps).map(|i| basis.sample(p, [place(i / steps), place(i % steps)]));
                each.map(|v| CLEAR.luminance(v.z, v.dot(sun))).sum::<f64>() / (steps * steps) as f64
            })
            .collect();
        let scale = f64::from(means[40]) / sampled[40];
        for (p, &value) in sampled.iter().enumerate() {
            assert!((f64::from(means[p]) / (scale * value) - 1.0).abs() < 2e-3, "{p}: {} {}", means[p], scale * value);
        }
    }

    /// A sky of negative luminance everywhere is taken as uniform.
    #[test]
    fn black_sky_becomes_uniform() {
        let Some(basis) = SkyBasis::named("tregenza145") else { panic!() };
        let black = AllWeather { a: -2.0, b: 0.0, c: 0.0, d: -1.0, e: 0.0 };
        let mut means = vec![0.0; basis.patches()];
        SkyNodes::new(&basis, 2).patch_means(&black, towards_sun(0.5), PI, &mut means);
        assert!(means[..145].iter().all(|mean| (mean - 1.0).abs() < 1e-6));
    }
}
