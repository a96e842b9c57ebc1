//! One smooth boundary between two media: Snell's law, the Fresnel equations and total internal reflection.

use hemisphere::Vec3;

/// A smooth boundary, seen by light that comes from index `n_i` and would enter index `n_t`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interface {
    /// Refractive index on the side the light comes from.
    pub n_i: f64,
    /// Refractive index on the side it would enter.
    pub n_t: f64,
}

/// What one smooth boundary does to one ray.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Split {
    /// Power reflectances of s and p light; the rest goes on at `cos_t` from the normal.
    Partial {
        /// Fresnel amplitude reflected, field across the plane of incidence.
        amplitude_s: f64,
        /// Fresnel amplitude reflected, field in the plane of incidence.
        amplitude_p: f64,
        /// Cosine of the angle of refraction.
        cos_t: f64,
    },
    /// Total internal reflection: all of it is mirrored, p later than s by the retardance δ.
    Total {
        /// cos δ.
        cos_retardance: f64,
        /// sin δ.
        sin_retardance: f64,
    },
}

impl Interface {
    /// Splits light arriving at `cos_i` (0..=1) from the normal: Snell's law and the Fresnel equations
    /// (theory/interface.md, eqs. 1–5; Hecht, *Optics*, §4.6–4.7).
    #[inline]
    pub fn split(self, cos_i: f64) -> Split {
        let Self { n_i, n_t } = self;
        // Snell: n_i sin θ_i = n_t sin θ_t
        let sin2_i = 1.0 - cos_i * cos_i;
        let sin2_t = (n_i / n_t) * (n_i / n_t) * sin2_i;
        if sin2_t >= 1.0 {
            // Beyond the critical angle cos θ_t = i q, q = √(sin²θ_t − 1), and both amplitudes have modulus one:
            // r_s = (n_i c − i n_t q) / (n_i c + i n_t q), r_p likewise with n_i and n_t exchanged, so that
            // r_p r_s* = u² / |u|² with u = (n_t c − i n_i q) (n_i c + i n_t q)
            let q = (sin2_t - 1.0).sqrt();
            let re = n_i * n_t * (cos_i * cos_i + q * q);
            let im = cos_i * q * (n_t * n_t - n_i * n_i);
            let norm = re * re + im * im;
            return Split::Total { cos_retardance: (re * re - im * im) / norm, sin_retardance: 2.0 * re * im / norm };
        }
        let cos_t = (1.0 - sin2_t).sqrt();
        // Fresnel amplitude ratios, electric field across (s) and in (p) the plane of incidence
        let amplitude_s = (n_i * cos_i - n_t * cos_t) / (n_i * cos_i + n_t * cos_t);
        let amplitude_p = (n_t * cos_i - n_i * cos_t) / (n_t * cos_i + n_i * cos_t);
        Split::Partial { amplitude_s, amplitude_p, cos_t }
    }

    /// Whether light at `cos_i` (0..=1) is beyond the critical angle.
    #[inline]
    pub fn is_total(self, cos_i: f64) -> bool {
        (self.n_i / self.n_t) * (self.n_i / self.n_t) * (1.0 - cos_i * cos_i) >= 1.0
    }

    /// Share of unpolarised power reflected at `cos_i` (0..=1): the mean square of both amplitudes.
    #[inline]
    pub fn reflectance(self, cos_i: f64) -> f64 {
        if self.is_total(cos_i) {
            return 1.0;
        }
        match self.split(cos_i) {
            Split::Total { .. } => 1.0,
            Split::Partial { amplitude_s, amplitude_p, .. } => {
                0.5 * (amplitude_s * amplitude_s + amplitude_p * amplitude_p)
            }
        }
    }
}

/// The direction that goes through a boundary, `None` if all is mirrored:
/// v = r l + n (r cos θ_i − √(1 − r² (1 − cos² θ_i))), r = n_i / n_t (theory/interface.md, eq. 6).
///
/// `incident` travels towards the boundary; `normal` points back to the side it comes from; both are unit vectors.
#[inline]
pub fn refract(incident: Vec3, normal: Vec3, interface: Interface) -> Option<Vec3> {
    let r = interface.n_i / interface.n_t;
    let cos_i = -incident.dot(normal);
    let cos2_t = 1.0 - r * r * (1.0 - cos_i * cos_i);
    (cos2_t > 0.0).then(|| r * incident + normal * (r * cos_i - cos2_t.sqrt()))
}

/// The mirrored direction: r = i − 2 (i·n) n (theory/interface.md, eq. 7).
#[inline]
pub fn mirror(incident: Vec3, normal: Vec3) -> Vec3 {
    incident - 2.0 * incident.dot(normal) * normal
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// At normal incidence R = ((n_t − n_i) / (n_t + n_i))².
    #[test]
    fn normal_incidence_is_the_index_contrast() {
        let r = Interface { n_i: 1.0, n_t: 1.49 }.reflectance(1.0);
        assert!((r - (0.49_f64 / 2.49).powi(2)).abs() < 1e-15);
    }

    /// At Brewster's angle, tan θ = n_t / n_i, p light is not reflected at all.
    #[test]
    fn brewster_angle_reflects_only_s() {
        let interface = Interface { n_i: 1.0, n_t: 1.5 };
        let Split::Partial { amplitude_s, amplitude_p, .. } = interface.split(1.5_f64.atan().cos()) else {
            panic!("no total reflection into a denser medium");
        };
        assert!(amplitude_p.abs() < 1e-15 && amplitude_s.abs() > 0.3);
    }

    /// Into a thinner medium all is mirrored beyond sin θ_c = n_t / n_i, and only beyond.
    #[test]
    fn total_reflection_begins_at_the_critical_angle() {
        let interface = Interface { n_i: 1.49, n_t: 1.0 };
        let critical = (1.0_f64 / 1.49).asin();
        assert!(matches!(interface.split((critical + 1e-9).cos()), Split::Total { .. }));
        assert!(matches!(interface.split((critical - 1e-9).cos()), Split::Partial { .. }));
    }

    /// Fresnel's rhomb: n = 1.51 at 54.6° retards p against s by 45° at each total reflection (Born & Wolf, §1.5.4).
    #[test]
    fn fresnel_rhomb_retards_by_an_eighth_turn() {
        let Split::Total { cos_retardance, sin_retardance } =
            (Interface { n_i: 1.51, n_t: 1.0 }).split(54.617_f64.to_radians().cos())
        else {
            panic!("beyond the critical angle");
        };
        let retardance = sin_retardance.atan2(cos_retardance).to_degrees();
        assert!((retardance.abs() - 45.0).abs() < 0.1, "{retardance}");
    }

    proptest! {
        /// The way back through a boundary reflects the same share (Stokes reversibility).
        #[test]
        fn reflectance_is_reciprocal(n_t in 1.01..2.5_f64, cos_i in 0.001..1.0_f64) {
            let there = Interface { n_i: 1.0, n_t };
            let Split::Partial { cos_t, .. } = there.split(cos_i) else { panic!("denser") };
            let back = Interface { n_i: n_t, n_t: 1.0 };
            prop_assert!((there.reflectance(cos_i) - back.reflectance(cos_t)).abs() < 1e-9);
        }

        /// The vector form obeys Snell: n_i (l × n) = n_t (v × n), and v is of unit length.
        #[test]
        fn refracted_vector_obeys_snell(n_i in 1.0..2.0_f64, n_t in 1.0..2.0_f64, x in -1.0..1.0_f64, y in -1.0..1.0_f64, z in 0.01..1.0_f64) {
            let incident = Vec3::new(x, y, -z).normalize();
            if let Some(v) = refract(incident, Vec3::Z, Interface { n_i, n_t }) {
                prop_assert!((n_i * incident.cross(Vec3::Z) - n_t * v.cross(Vec3::Z)).length() < 1e-13);
                prop_assert!((v.length() - 1.0).abs() < 1e-12);
            }
        }
    }
}
