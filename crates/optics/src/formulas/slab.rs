//! A plane-parallel pane in air: every inner reflection, absorption along the true path.

use crate::{Interface, Retarder, Split};

/// Which light meets the pane, and how much of its history it keeps.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Polarisation {
    /// Field across the plane of incidence.
    S,
    /// Field in the plane of incidence.
    P,
    /// Unpolarised light, s and p followed apart through the pane: exact.
    Resolved,
    /// Unpolarised again at every surface, as much of the literature has it.
    Averaged,
}

/// Where the power goes; the three add to 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shares {
    /// Share that leaves on the far side.
    pub transmittance: f64,
    /// Share sent back.
    pub reflectance: f64,
    /// Share left in the pane.
    pub absorptance: f64,
}

/// What a pane of index `n` in air does to light arriving at `cos_i`; `optical_depth` is α times the thickness, across
/// the pane (theory/glass.md, eqs. 1–4). Without coherence: the pane is thicker than the light's coherence length.
#[inline]
pub fn slab(cos_i: f64, n: f64, optical_depth: f64, polarisation: Polarisation) -> Shares {
    let Some(Surface { reflectance_s, reflectance_p, internal }) = surface(cos_i, n, optical_depth) else {
        return Shares { transmittance: 0.0, reflectance: 1.0, absorptance: 0.0 };
    };
    match polarisation {
        Polarisation::S => with_inner_reflections(reflectance_s, internal),
        Polarisation::P => with_inner_reflections(reflectance_p, internal),
        Polarisation::Averaged => with_inner_reflections(0.5 * (reflectance_s + reflectance_p), internal),
        Polarisation::Resolved => {
            let s = with_inner_reflections(reflectance_s, internal);
            let p = with_inner_reflections(reflectance_p, internal);
            Shares {
                transmittance: 0.5 * (s.transmittance + p.transmittance),
                reflectance: 0.5 * (s.reflectance + p.reflectance),
                absorptance: 0.5 * (s.absorptance + p.absorptance),
            }
        }
    }
}

/// What a pane lets through and what it mirrors of light of any polarisation, in the axes of the plane of incidence: eqs. 2 and 3
/// of theory/glass.md for s and for p, and theory/layers.md, eq. 4, for the coherence between the two.
pub fn slab_retarders(cos_i: f64, n: f64, optical_depth: f64) -> [Retarder; 2] {
    let split = (Interface { n_i: 1.0, n_t: n }).split(cos_i);
    let (true, Split::Partial { amplitude_s, amplitude_p, cos_t }) = (cos_i > 0.0, split) else {
        return [Retarder::new(0.0, 0.0, 0.0, 0.0), Retarder::new(1.0, 1.0, 1.0, 0.0)];
    };
    let tau = (-optical_depth / cos_t).exp();
    let [s, p] = [amplitude_s, amplitude_p].map(|amplitude| with_inner_reflections(amplitude * amplitude, tau));
    // inside the pane both amplitudes change sign, so their product stays
    let (g, through_both) = (amplitude_s * amplitude_p, (1.0 - amplitude_s.powi(2)) * (1.0 - amplitude_p.powi(2)));
    let coherence = through_both * tau / (1.0 - (g * tau).powi(2));
    [
        Retarder::new(s.transmittance, p.transmittance, coherence, 0.0),
        Retarder::new(s.reflectance, p.reflectance, g + coherence * tau * g, 0.0),
    ]
}

/// Transmittance of unpolarised light that crosses the pane once, inner reflections left out: (1 − R)² τ with
/// R the mean of s and p (theory/glass.md, eq. 4).
pub fn slab_single_pass(cos_i: f64, n: f64, optical_depth: f64) -> f64 {
    surface(cos_i, n, optical_depth).map_or(0.0, |Surface { reflectance_s, reflectance_p, internal }| {
        (1.0 - 0.5 * (reflectance_s + reflectance_p)).powi(2) * internal
    })
}

/// What one surface and one crossing do.
struct Surface {
    reflectance_s: f64,
    reflectance_p: f64,
    internal: f64,
}

/// `None` for light along the pane, which never enters.
#[inline]
fn surface(cos_i: f64, n: f64, optical_depth: f64) -> Option<Surface> {
    if cos_i <= 0.0 {
        return None;
    }
    match (Interface { n_i: 1.0, n_t: n }).split(cos_i) {
        Split::Total { .. } => None,
        Split::Partial { amplitude_s, amplitude_p, cos_t } => Some(Surface {
            reflectance_s: amplitude_s * amplitude_s,
            reflectance_p: amplitude_p * amplitude_p,
            // the path is longer than the pane is thick by 1 / cos θ_t
            internal: (-optical_depth / cos_t).exp(),
        }),
    }
}

/// The geometric series of inner reflections, for a surface reflectance R and a crossing τ:
/// T = (1 − R)² τ / (1 − R² τ²), the reflected R (1 + τ T) (theory/glass.md, eqs. 2–3).
#[inline]
fn with_inner_reflections(r: f64, tau: f64) -> Shares {
    if r >= 1.0 {
        return Shares { transmittance: 0.0, reflectance: 1.0, absorptance: 0.0 };
    }
    let transmittance = (1.0 - r) * (1.0 - r) * tau / ((1.0 - r * tau) * (1.0 + r * tau));
    let reflectance = r * (1.0 + tau * transmittance);
    // each crossing loses 1 − τ, and the crossings' power is (1 − R) / (1 − Rτ) in all
    let absorptance = (1.0 - r) * (1.0 - tau) / (1.0 - r * tau);
    Shares { transmittance, reflectance, absorptance }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// The series is what it says: reflections followed one by one.
    #[test]
    fn series_is_the_sum_of_its_crossings() {
        let (r, tau) = (0.3, 0.9);
        let (mut inside, mut out, mut absorbed) = (1.0 - r, [r, 0.0], 0.0);
        for crossing in 1..200 {
            absorbed += inside * (1.0 - tau);
            let arrives = inside * tau;
            out[crossing % 2] += arrives * (1.0 - r);
            inside = arrives * r;
        }
        let shares = with_inner_reflections(r, tau);
        assert!((shares.transmittance - out[1]).abs() < 1e-15);
        assert!((shares.reflectance - out[0]).abs() < 1e-15);
        assert!((shares.absorptance - absorbed).abs() < 1e-15);
    }

    /// p light at Brewster's angle meets no surface: only absorption is left.
    #[test]
    fn brewster_angle_leaves_only_absorption_for_p() {
        let (n, depth) = (1.5_f64, 0.1);
        let theta = n.atan();
        let cos_t = (theta.sin() / n).asin().cos();
        let shares = slab(theta.cos(), n, depth, Polarisation::P);
        assert!((shares.transmittance - (-depth / cos_t).exp()).abs() < 1e-14 && shares.reflectance < 1e-14);
    }

    proptest! {
        /// Power is neither made nor lost, and averaging at every surface never transmits more than following s and p.
        #[test]
        fn shares_add_to_one(cos_i in 0.0..1.0_f64, n in 1.0..2.5_f64, depth in 0.0..3.0_f64) {
            for polarisation in [Polarisation::S, Polarisation::P, Polarisation::Resolved, Polarisation::Averaged] {
                let Shares { transmittance, reflectance, absorptance } = slab(cos_i, n, depth, polarisation);
                prop_assert!((transmittance + reflectance + absorptance - 1.0).abs() < 1e-13);
                prop_assert!(transmittance >= 0.0 && reflectance >= 0.0 && absorptance >= 0.0);
            }
            let single = slab_single_pass(cos_i, n, depth);
            prop_assert!(single <= slab(cos_i, n, depth, Polarisation::Averaged).transmittance + 1e-15);
        }
    }
}
