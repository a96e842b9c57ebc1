//! Polarisation: Stokes vectors carried along beams and the Mueller matrices of one boundary.
//!
//! Every beam has reference axes derived from its direction alone ([`reference_axes`]), so that beams that meet in one
//! direction can be added. A boundary acts in its own s and p axes; turning between the two is part of its matrix.

use crate::interface::Split;
use hemisphere::Vec3;

/// Power and polarisation of a beam (S0, S1, S2, S3): S0 the power, S1 = s − p about the reference axes.
pub type Stokes = [f64; 4];

/// A linear map of Stokes vectors, row by row.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mueller(pub [[f64; 4]; 4]);

/// What a smooth boundary does in its own axes: it weakens s and p light unequally and retards p against s
/// (theory/polarisation.md, eq. 3).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Retarder {
    /// Mean of the powers of s and p light.
    mean: f64,
    /// Half their difference.
    half_difference: f64,
    /// Coherence √(x_s x_p) times the cosine of the retardance.
    cos: f64,
    /// Coherence times its sine.
    sin: f64,
}

impl Retarder {
    /// Powers of s and p light, and the coherence between them times the cosine and the sine of the retardance.
    pub(crate) fn new(power_s: f64, power_p: f64, cos: f64, sin: f64) -> Self {
        Self { mean: 0.5 * (power_s + power_p), half_difference: 0.5 * (power_s - power_p), cos, sin }
    }

    /// What a boundary mirrors.
    #[inline]
    pub fn reflected(split: Split) -> Self {
        match split {
            Split::Total { cos_retardance, sin_retardance } => Self::new(1.0, 1.0, cos_retardance, sin_retardance),
            Split::Partial { amplitude_s: s, amplitude_p: p, .. } => Self::new(s * s, p * p, s * p, 0.0),
        }
    }

    /// What a boundary lets through: 1 − R of each (theory/polarisation.md, eq. 4).
    #[inline]
    pub fn transmitted(split: Split) -> Self {
        match split {
            Split::Total { .. } => Self::new(0.0, 0.0, 0.0, 0.0),
            Split::Partial { amplitude_s: s, amplitude_p: p, .. } => {
                let (t_s, t_p) = (1.0 - s * s, 1.0 - p * p);
                Self::new(t_s, t_p, (t_s * t_p).sqrt(), 0.0)
            }
        }
    }

    /// What a gap of no width between two like boundaries mirrors, all incoherent reflections within it summed
    /// (theory/polarisation.md, eq. 5).
    #[inline]
    pub fn reflected_by_film(split: Split) -> Self {
        match split {
            Split::Total { .. } => Self::reflected(split),
            Split::Partial { amplitude_s: s, amplitude_p: p, .. } => {
                let (r_s, r_p, r_c) = (s * s, p * p, s * p);
                // inside the gap both amplitudes change sign, so their product stays
                let t_c2 = (1.0 - r_s) * (1.0 - r_p);
                let coherence = r_c + t_c2 * r_c / (1.0 - r_c * r_c);
                Self::new(2.0 * r_s / (1.0 + r_s), 2.0 * r_p / (1.0 + r_p), coherence, 0.0)
            }
        }
    }

    /// What such a gap lets through.
    #[inline]
    pub fn transmitted_by_film(split: Split) -> Self {
        match split {
            Split::Total { .. } => Self::new(0.0, 0.0, 0.0, 0.0),
            Split::Partial { amplitude_s: s, amplitude_p: p, .. } => {
                let (r_s, r_p, r_c) = (s * s, p * p, s * p);
                let coherence = (1.0 - r_s) * (1.0 - r_p) / (1.0 - r_c * r_c);
                let through = |r: f64| (1.0 - r) / (1.0 + r);
                Self::new(through(r_s), through(r_p), coherence, 0.0)
            }
        }
    }

    /// The Stokes vector after this boundary, in the boundary's axes.
    #[inline]
    pub fn apply(&self, [i, q, u, v]: Stokes) -> Stokes {
        [
            self.mean * i + self.half_difference * q,
            self.half_difference * i + self.mean * q,
            self.cos * u + self.sin * v,
            self.cos * v - self.sin * u,
        ]
    }

    /// The same as a matrix.
    pub fn mueller(&self) -> Mueller {
        let Self { mean: a, half_difference: b, cos: c, sin: s } = *self;
        Mueller([[a, b, 0.0, 0.0], [b, a, 0.0, 0.0], [0.0, 0.0, c, s], [0.0, 0.0, -s, c]])
    }
}

impl Mueller {
    /// Weakens light of every polarisation by one factor.
    pub fn scaled(factor: f64) -> Self {
        Self(std::array::from_fn(|i| std::array::from_fn(|j| if i == j { factor } else { 0.0 })))
    }

    /// Turns the axes by ψ about the beam: cos 2ψ and sin 2ψ given (theory/polarisation.md, eq. 2).
    pub fn turned(cos_2: f64, sin_2: f64) -> Self {
        Self([[1.0, 0.0, 0.0, 0.0], [0.0, cos_2, sin_2, 0.0], [0.0, -sin_2, cos_2, 0.0], [0.0, 0.0, 0.0, 1.0]])
    }

    /// From the reference axes of a beam along `direction` to axes whose first vector is `s`.
    pub fn into_plane(direction: Vec3, s: Vec3) -> Self {
        let (cos_2, sin_2) = double_angle(direction, s);
        Self::turned(cos_2, sin_2)
    }

    /// From axes whose first vector is `s` to the reference axes of a beam along `direction`.
    pub fn out_of_plane(direction: Vec3, s: Vec3) -> Self {
        let (cos_2, sin_2) = double_angle(direction, s);
        Self::turned(cos_2, -sin_2)
    }

    /// The Stokes vector after this map.
    #[inline]
    pub fn apply(&self, stokes: Stokes) -> Stokes {
        let [a, b, c, d] = &self.0;
        let row = |r: &Stokes| r[0] * stokes[0] + r[1] * stokes[1] + r[2] * stokes[2] + r[3] * stokes[3];
        [row(a), row(b), row(c), row(d)]
    }

    /// This map after `first`.
    pub fn after(&self, first: &Self) -> Self {
        let mut product = [[0.0; 4]; 4];
        for (row, of) in product.iter_mut().zip(&self.0) {
            for (factor, other) in of.iter().zip(&first.0) {
                row.iter_mut().zip(other).for_each(|(sum, x)| *sum += factor * x);
            }
        }
        Self(product)
    }
}

/// cos 2ψ, sin 2ψ of the turn about `direction` that takes its reference axis to `s`.
fn double_angle(direction: Vec3, s: Vec3) -> (f64, f64) {
    let (e_s, e_p) = reference_axes(direction);
    let (c, d) = (e_s.dot(s), e_p.dot(s));
    let norm = c * c + d * d;
    ((c * c - d * d) / norm, 2.0 * c * d / norm)
}

/// The axes a beam's Stokes vector refers to: s the part of x across the beam, p = k × s (theory/polarisation.md, eq. 1).
/// In a beam that travels along x itself, y takes the place of x.
pub fn reference_axes(direction: Vec3) -> (Vec3, Vec3) {
    let across = |axis: Vec3| axis - axis.dot(direction) * direction;
    let x = across(Vec3::X);
    let s = if x.length_squared() > 1e-24 { x } else { across(Vec3::Y) }.normalize();
    (s, direction.cross(s))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Interface;

    /// What is mirrored and what goes through add to what arrived, for any polarisation.
    #[test]
    fn power_is_conserved_at_a_boundary_and_at_a_film() {
        let split = Interface { n_i: 1.49, n_t: 1.0 }.split(0.8);
        let stokes = [1.0, 0.3, -0.5, 0.4];
        for (r, t) in [
            (Retarder::reflected(split), Retarder::transmitted(split)),
            (Retarder::reflected_by_film(split), Retarder::transmitted_by_film(split)),
        ] {
            assert!((r.apply(stokes)[0] + t.apply(stokes)[0] - 1.0).abs() < 1e-15);
        }
    }

    /// A fully polarised beam stays fully polarised at a single boundary.
    #[test]
    fn pure_states_stay_pure() {
        let purity = |s: Stokes| (s[1] * s[1] + s[2] * s[2] + s[3] * s[3]).sqrt() / s[0];
        let stokes = [1.0, 0.6, 0.0, 0.8];
        for cos_i in [0.9, 0.76, 0.3] {
            let split = Interface { n_i: 1.49, n_t: 1.0 }.split(cos_i);
            assert!((purity(Retarder::reflected(split).apply(stokes)) - 1.0).abs() < 1e-12);
        }
        let split = Interface { n_i: 1.0, n_t: 1.49 }.split(0.4);
        assert!((purity(Retarder::transmitted(split).apply(stokes)) - 1.0).abs() < 1e-12);
    }

    /// A film is the limit of summing its inner reflections one by one.
    #[test]
    fn film_sums_its_inner_reflections() {
        let outside = Interface { n_i: 1.49, n_t: 1.0 }.split(0.85);
        let Split::Partial { cos_t, .. } = outside else { panic!("below the critical angle") };
        let inside = Interface { n_i: 1.0, n_t: 1.49 }.split(cos_t);
        let stokes = [1.0, 0.2, 0.5, -0.3];
        let mut in_gap = Retarder::transmitted(outside).apply(stokes);
        let mut reflected = Retarder::reflected(outside).apply(stokes);
        let mut transmitted = [0.0; 4];
        for turn in 0..40 {
            let leaves = Retarder::transmitted(inside).apply(in_gap);
            let sink = if turn % 2 == 0 { &mut transmitted } else { &mut reflected };
            sink.iter_mut().zip(leaves).for_each(|(sum, x)| *sum += x);
            in_gap = Retarder::reflected(inside).apply(in_gap);
        }
        let film =
            (Retarder::reflected_by_film(outside).apply(stokes), Retarder::transmitted_by_film(outside).apply(stokes));
        for i in 0..4 {
            assert!((film.0[i] - reflected[i]).abs() < 1e-14 && (film.1[i] - transmitted[i]).abs() < 1e-14);
        }
    }

    /// Turning into a plane and out again changes nothing.
    #[test]
    fn turns_undo_each_other() {
        let direction = Vec3::new(0.3, -0.5, 0.8).normalize();
        let s = Vec3::new(0.0, 0.8, 0.5).cross(direction).normalize();
        let there_and_back = Mueller::out_of_plane(direction, s).after(&Mueller::into_plane(direction, s));
        let stokes = there_and_back.apply([1.0, 0.1, 0.2, 0.3]);
        for (got, want) in stokes.into_iter().zip([1.0, 0.1, 0.2, 0.3]) {
            assert!((got - want).abs() < 1e-15);
        }
    }
}
