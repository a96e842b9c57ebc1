//! Plain glazing, which lets light through unturned: an opening, a fixed transmittance, glass by formula.

use super::{Glazing, Lobe, Lobes, PolarisedLobe, PolarisedLobes, Scattered, Straight};
use crate::OpticsError;
use crate::formulas::{Polarisation, slab, slab_retarders, tregenza_sharples};
use crate::stokes::{Mueller, Retarder, reference_axes};
use hemisphere::{Direction, Vec3};

/// A glazing without structure: what passes keeps its direction, what is reflected is a mirror image.
#[derive(Clone, Debug, PartialEq)]
pub struct ClearGlazing(Law);

#[derive(Clone, Debug, PartialEq)]
enum Law {
    /// The same transmittance at every angle; the rest is absorbed.
    Constant { transmittance: f64 },
    /// 6 mm clear float by the polynomial of Tregenza and Sharples; the rest is absorbed.
    TregenzaSharples,
    /// A plane-parallel pane, all inner reflections.
    Slab(Box<SlabTable>),
}

/// Transmittance and reflectance of a pane by cubic pieces over the root of the cosine of incidence, which is fine where grazing light
/// changes fast: a room asks millions of times.
#[derive(Clone, Debug, PartialEq)]
struct SlabTable {
    n: f64,
    optical_depth: f64,
    transmittance: Vec<[f64; 4]>,
    reflectance: Vec<[f64; 4]>,
}

impl SlabTable {
    /// Pieces of the table; the cubics are then off by less than 1e-7.
    const PIECES: usize = 256;

    fn new(n: f64, optical_depth: f64) -> Self {
        let exact = |c: f64| {
            let shares = slab(c, n, optical_depth, Polarisation::Resolved);
            [shares.transmittance, shares.reflectance]
        };
        let piece = |which: usize| {
            (0..Self::PIECES).map(move |k| {
                // the cubic through four points of the piece, its ends included
                let f = [0.0, 1.0, 2.0, 3.0]
                    .map(|third| exact(((k as f64 + third / 3.0) / Self::PIECES as f64).powi(2))[which]);
                [
                    f[0],
                    -5.5 * f[0] + 9.0 * f[1] - 4.5 * f[2] + f[3],
                    9.0 * f[0] - 22.5 * f[1] + 18.0 * f[2] - 4.5 * f[3],
                    4.5 * (f[3] - f[0]) + 13.5 * (f[1] - f[2]),
                ]
            })
        };
        Self { n, optical_depth, transmittance: piece(0).collect(), reflectance: piece(1).collect() }
    }

    #[inline]
    fn at(&self, cos_i: f64) -> Straight {
        let place = cos_i.sqrt() * Self::PIECES as f64;
        let k = (place as usize).min(Self::PIECES - 1);
        let x = place - k as f64;
        let cubic = |[a, b, c, d]: [f64; 4]| a + x * (b + x * (c + x * d));
        Straight { transmittance: cubic(self.transmittance[k]), reflectance: cubic(self.reflectance[k]) }
    }

    /// What the pane lets through and what it mirrors, for light of any polarisation (theory/glass.md, eqs. 2–3 for s and for p;
    /// theory/layers.md, eq. 4 between them).
    fn retarders(&self, cos_i: f64) -> [Retarder; 2] {
        slab_retarders(cos_i, self.n, self.optical_depth)
    }
}

/// Index of the glass whose normal transmittance is all that is known, as in Radiance's `glass`.
const GLASS_N: f64 = 1.52;

impl ClearGlazing {
    /// Nothing in the opening.
    pub fn open() -> Self {
        Self(Law::Constant { transmittance: 1.0 })
    }

    /// The same transmittance at every angle of incidence; what does not pass is absorbed.
    pub fn constant(transmittance: f64) -> Result<Self, OpticsError> {
        if (0.0..=1.0).contains(&transmittance) {
            Ok(Self(Law::Constant { transmittance }))
        } else {
            Err(OpticsError::TransmittanceOutside { value: transmittance, greatest: 1.0 })
        }
    }

    /// One pane of n = 1.52 that transmits this share at normal incidence, inner reflections included.
    ///
    /// The pane's optical depth follows from T = (1 − R)² τ / (1 − R² τ²) (theory/glass.md, eq. 2) solved for τ.
    pub fn glass(transmittance: f64) -> Result<Self, OpticsError> {
        let r = ((GLASS_N - 1.0) / (GLASS_N + 1.0)).powi(2);
        let clear = (1.0 - r) / (1.0 + r);
        let t = transmittance;
        if !(t > 0.0 && t <= clear) {
            return Err(OpticsError::TransmittanceOutside { value: t, greatest: clear });
        }
        let once = (1.0 - r) * (1.0 - r);
        // the root of R² T τ² + (1 − R)² τ − T = 0 in the form that loses no digits
        let tau = 2.0 * t / (once + (once * once + 4.0 * r * r * t * t).sqrt());
        Ok(Self(Law::Slab(Box::new(SlabTable::new(GLASS_N, (-tau.ln()).max(0.0))))))
    }

    /// 6 mm clear float glass after Tregenza and Sharples (theory/glass.md, eq. 8).
    pub fn tregenza_sharples() -> Self {
        Self(Law::TregenzaSharples)
    }

    /// A plane-parallel pane of index `n`, `thickness_mm` thick, that absorbs `absorption_per_mm` of power (theory/glass.md, eqs. 1–4).
    pub fn slab(n: f64, thickness_mm: f64, absorption_per_mm: f64) -> Result<Self, OpticsError> {
        if !(n.is_finite() && n >= 1.0) {
            return Err(OpticsError::IndexBelowOne { value: n, wavelength_nm: None });
        }
        if !(absorption_per_mm.is_finite() && absorption_per_mm >= 0.0) {
            return Err(OpticsError::NegativeAbsorption {
                quantity: "absorption_per_mm",
                value: absorption_per_mm,
                wavelength_nm: None,
            });
        }
        if !(thickness_mm.is_finite() && thickness_mm > 0.0) {
            return Err(OpticsError::NotAThickness { value: thickness_mm });
        }
        Ok(Self(Law::Slab(Box::new(SlabTable::new(n, absorption_per_mm * thickness_mm)))))
    }

    /// Shares let through and mirrored at `cos_i` from the normal.
    #[inline]
    fn shares(&self, cos_i: f64) -> Straight {
        match &self.0 {
            Law::Constant { transmittance } => Straight { transmittance: *transmittance, reflectance: 0.0 },
            Law::TregenzaSharples => Straight { transmittance: tregenza_sharples(cos_i), reflectance: 0.0 },
            Law::Slab(table) => table.at(cos_i),
        }
    }
}

impl Glazing for ClearGlazing {
    fn lobes(&self, incident: Direction, out: &mut Lobes) {
        out.clear();
        let Straight { transmittance, reflectance } = self.shares(incident.z.abs());
        for (direction, power) in [(incident, transmittance), (mirror_image(incident), reflectance)] {
            if power > 0.0 {
                out.beams.push(Lobe { direction, power, total_reflections: 0 });
            }
        }
        out.absorbed = 1.0 - transmittance - reflectance;
    }

    fn scatter(&self, incident: Direction, u: [f64; 3]) -> Scattered {
        let Straight { transmittance, reflectance } = self.shares(incident.z.abs());
        if u[0] < transmittance {
            Scattered::Leaves { direction: incident, total_reflections: 0 }
        } else if u[0] < transmittance + reflectance {
            Scattered::Leaves { direction: mirror_image(incident), total_reflections: 0 }
        } else {
            Scattered::Absorbed
        }
    }

    fn straight(&self, incident: Direction) -> Option<Straight> {
        Some(self.shares(incident.z.abs()))
    }

    fn straight_s_p(&self, incident: Direction) -> Option<[Straight; 2]> {
        let Law::Slab(table) = &self.0 else { return Some([self.shares(incident.z.abs()); 2]) };
        Some([Polarisation::S, Polarisation::P].map(|polarisation| {
            let shares = slab(incident.z.abs(), table.n, table.optical_depth, polarisation);
            Straight { transmittance: shares.transmittance, reflectance: shares.reflectance }
        }))
    }

    fn polarised_lobes(&self, incident: Direction, out: &mut PolarisedLobes) {
        out.beams.clear();
        out.residual = 0.0;
        let Law::Slab(table) = &self.0 else {
            // of a sheet known by its transmittance alone the best guess is that it leaves polarisation as it is
            let mueller = Mueller::scaled(self.shares(incident.z.abs()).transmittance);
            return out.beams.push(PolarisedLobe { direction: incident, mueller, total_reflections: 0 });
        };
        let [through, mirrored] = table.retarders(incident.z.abs());
        let (into, s) = into_plane(incident);
        for (direction, retarder) in [(incident, through), (mirror_image(incident), mirrored)] {
            let mueller = Mueller::out_of_plane(*direction, s).after(&retarder.mueller()).after(&into);
            out.beams.push(PolarisedLobe { direction, mueller, total_reflections: 0 });
        }
    }

    fn polarised_scatter(&self, incident: Direction, [q, u, v]: [f64; 3], random: [f64; 3]) -> (Scattered, [f64; 3]) {
        let Law::Slab(table) = &self.0 else { return (self.scatter(incident, random), [q, u, v]) };
        let (into, s) = into_plane(incident);
        let arriving = into.apply([1.0, q, u, v]);
        let mut left = random[0];
        for (direction, retarder) in
            [incident, mirror_image(incident)].into_iter().zip(table.retarders(incident.z.abs()))
        {
            let leaving = retarder.apply(arriving);
            if left < leaving[0] {
                let [power, q, u, v] = Mueller::out_of_plane(*direction, s).apply(leaving);
                return (Scattered::Leaves { direction, total_reflections: 0 }, [q / power, u / power, v / power]);
            }
            left -= leaving[0];
        }
        (Scattered::Absorbed, [0.0; 3])
    }
}

/// The turn from the reference axes of a beam into its plane of incidence, and the axis across that plane.
fn into_plane(incident: Direction) -> (Mueller, Vec3) {
    let across = Vec3::Z.cross(*incident);
    // at normal incidence any axis will do
    let s = if across.length_squared() > 1e-24 { across.normalize() } else { reference_axes(*incident).0 };
    (Mueller::into_plane(*incident, s), s)
}

/// Mirrored at the element's own plane.
pub(super) fn mirror_image(incident: Direction) -> Direction {
    incident.mirrored(Direction::from_unit(Vec3::Z))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn at(degrees: f64) -> Direction {
        let (sine, cosine) = degrees.to_radians().sin_cos();
        Direction::from_unit(Vec3::new(0.0, -sine, cosine))
    }

    /// Glass of a given normal transmittance has it, for all that n = 1.52 allows.
    #[test]
    fn glass_has_the_transmittance_asked_for() {
        for t in [0.1, 0.5, 0.88, 0.9181] {
            let straight = ClearGlazing::glass(t).expect("possible").straight(at(0.0)).expect("clear");
            assert!((straight.transmittance - t).abs() < 1e-12);
        }
        for t in [0.0, -0.1, 0.93, f64::NAN] {
            assert!(ClearGlazing::glass(t).is_err(), "{t}");
        }
    }

    /// The table is the formula, to 1e-7 at every angle.
    #[test]
    fn slab_table_is_the_formula() {
        for (n, depth) in [(1.52, 0.0), (1.49, 0.3), (2.4, 0.01), (1.52, 0.003)] {
            let table = SlabTable::new(n, depth);
            for i in 0..=10_000 {
                let c = f64::from(i) / 1e4;
                let (got, want) = (table.at(c), slab(c, n, depth, Polarisation::Resolved));
                assert!((got.transmittance - want.transmittance).abs() < 1e-7, "{n} {depth} {c}");
                assert!((got.reflectance - want.reflectance).abs() < 1e-7, "{n} {depth} {c}");
            }
        }
    }

    /// Lobes share out all the power, and random draws leave as often as the lobes say.
    #[test]
    fn draws_follow_the_lobes() {
        let pane = ClearGlazing::slab(1.52, 6.0, 0.02).expect("possible");
        let mut lobes = Lobes::default();
        for degrees in [0.0, 40.0, 75.0, 89.0] {
            pane.lobes(at(degrees), &mut lobes);
            let sum: f64 = lobes.beams.iter().map(|lobe| lobe.power).sum();
            assert!((sum + lobes.absorbed - 1.0).abs() < 1e-15);
            let n = 1000;
            let draws = (0..n).map(|i| pane.scatter(at(degrees), [(f64::from(i) + 0.5) / f64::from(n), 0.0, 0.0]));
            let passed =
                draws.filter(|s| matches!(s, Scattered::Leaves { direction, .. } if direction.z > 0.0)).count();
            assert!((passed as f64 / f64::from(n) - lobes.beams[0].power).abs() <= 1.0 / f64::from(n));
        }
    }

    /// What does not pass a glass by polynomial is absorbed, from either side.
    #[test]
    fn formula_glass_reflects_nothing() {
        let mut lobes = Lobes::default();
        for incident in [at(60.0), -at(60.0)] {
            ClearGlazing::tregenza_sharples().lobes(incident, &mut lobes);
            assert_eq!(lobes.beams.len(), 1);
            assert_eq!(lobes.beams[0].direction, incident);
            assert!((lobes.beams[0].power - tregenza_sharples(0.5)).abs() < 1e-12);
        }
    }
}
