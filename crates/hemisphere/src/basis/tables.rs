//! The ring tables of the known bases.

use std::f64::consts::{FRAC_PI_2, TAU};

/// Patches of one altitude band, all of one width.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ring {
    /// Lower altitude \[rad\].
    pub altitude_low: f64,
    /// Upper altitude \[rad\].
    pub altitude_high: f64,
    /// How many patches share the ring.
    pub count: usize,
    /// Where the first of them begins, clockwise from north \[rad\].
    pub azimuth_low: f64,
}

/// Patches in each of Tregenza's rings below the zenith cap (P. R. Tregenza, *Lighting Res. Technol.* 19, 1987).
const TREGENZA: [usize; 7] = [30, 30, 24, 24, 18, 12, 6];

/// Height of Tregenza's rings; the cap is half of one.
const TREGENZA_HEIGHT: f64 = 12.0 * TAU / 360.0;

pub(super) fn rings_named(name: &str) -> Option<Vec<Ring>> {
    match name {
        "tregenza145" => Some(reinhart(1)),
        "troplux5221" => Some(troplux()),
        _ => {
            let patches: usize = name.strip_prefix("reinhart")?.parse().ok()?;
            let mf = (patches.checked_sub(1)? as f64 / 144.0).sqrt().round() as usize;
            ((1..=64).contains(&mf) && 144 * mf * mf + 1 == patches).then(|| reinhart(mf))
        }
    }
}

/// Tregenza's sky with every ring in `mf` and every patch in `mf`; the cap is half a ring high and the first patch is due north
/// (Reinhart's subdivision, as in Radiance; `mf` 1 is Tregenza's own).
fn reinhart(mf: usize) -> Vec<Ring> {
    let height = FRAC_PI_2 / (7.0 * mf as f64 + 0.5);
    let mut rings: Vec<Ring> = (0..7 * mf)
        .map(|row| {
            let count = mf * TREGENZA[row / mf];
            let altitude_low = height * row as f64;
            Ring { altitude_low, altitude_high: height * (row + 1) as f64, count, azimuth_low: centred_on_north(count) }
        })
        .collect();
    rings.push(Ring { altitude_low: height * 7.0 * mf as f64, altitude_high: FRAC_PI_2, count: 1, azimuth_low: 0.0 });
    rings
}

/// 5221 sectors: each of Tregenza's 144 patches in 6 × 6 equal steps of altitude and azimuth, and the zenith cap in 37 equal
/// areas (1 + 6 + 12 + 18), 144 · 36 + 37 = 145 · 36 + 1.
fn troplux() -> Vec<Ring> {
    const SPLIT: usize = 6;
    let height = TREGENZA_HEIGHT / SPLIT as f64;
    let mut rings = Vec::new();
    for (row, &count) in TREGENZA.iter().enumerate() {
        for step in 0..SPLIT {
            let altitude_low = TREGENZA_HEIGHT * row as f64 + height * step as f64;
            rings.push(Ring {
                altitude_low,
                altitude_high: altitude_low + height,
                count: count * SPLIT,
                azimuth_low: centred_on_north(count),
            });
        }
    }
    // the cap above 84°: k inner sectors end at the altitude where 1 − sin γ is k/37 of the cap's
    let cap = 1.0 - (7.0 * TREGENZA_HEIGHT).sin();
    let altitude = |inner: usize| (1.0 - cap * inner as f64 / 37.0).asin();
    for (inner, count) in [(19, 18), (7, 12), (1, 6), (0, 1)] {
        let azimuth_low = if count == 1 { 0.0 } else { centred_on_north(count) };
        let altitude_high = if inner == 0 { FRAC_PI_2 } else { altitude(inner) };
        rings.push(Ring { altitude_low: altitude(inner + count), altitude_high, count, azimuth_low });
    }
    rings
}

fn centred_on_north(count: usize) -> f64 {
    -0.5 * TAU / count as f64
}
