//! What a beam carries: power alone, s and p apart, or a Stokes vector.

use optics::{Mueller, Retarder, Split, Stokes};

/// A boundary's action on what a beam carries.
#[derive(Clone, Copy, Debug)]
pub struct Actions<A> {
    /// On the part that is mirrored.
    pub reflected: A,
    /// On the part that goes through.
    pub transmitted: A,
}

/// What a beam carries, and how boundaries act on it.
pub trait Payload: Copy + std::fmt::Debug + Send {
    /// A linear action on it.
    type Action: Copy + std::fmt::Debug + Send;
    /// Nothing.
    const ZERO: Self;
    /// Power.
    fn power(self) -> f64;
    /// Largest component, without its sign.
    fn largest(self) -> f64;
    /// Sum.
    fn plus(self, other: Self) -> Self;
    /// Multiple.
    fn times(self, factor: f64) -> Self;
    /// After a boundary.
    fn after(self, action: &Self::Action) -> Self;
    /// What `split` does to light along `arriving` that is mirrored along `mirrored` or goes on along `through`;
    /// `s` is the axis across the plane of incidence, `is_film` a gap of no width.
    fn actions(split: Split, is_film: bool, turns: impl FnOnce() -> Turns) -> Actions<Self::Action>;
    /// As a Stokes vector about the reference axes of its direction.
    fn stokes(self) -> Stokes;
    /// What it keeps of a Stokes vector.
    fn of_stokes(stokes: Stokes) -> Self;
}

/// The turns between the reference axes of the three beams at a boundary and its plane of incidence.
#[derive(Clone, Copy, Debug)]
pub struct Turns {
    /// Arriving beam, into the plane of incidence.
    pub arriving: Mueller,
    /// Out of it, for the mirrored beam.
    pub mirrored: Mueller,
    /// Out of it, for the beam that goes through.
    pub through: Mueller,
}

/// Share of unpolarised power that a gap of no width mirrors, if each of its faces mirrors `r`
/// (theory/panels.md, eq. 6).
pub fn film_reflectance(r: f64) -> f64 {
    2.0 * r / (1.0 + r)
}

/// Power alone: light is unpolarised again at every hit.
impl Payload for f64 {
    type Action = f64;
    const ZERO: Self = 0.0;

    #[inline]
    fn power(self) -> f64 {
        self
    }
    #[inline]
    fn largest(self) -> f64 {
        self.abs()
    }
    #[inline]
    fn plus(self, other: Self) -> Self {
        self + other
    }
    #[inline]
    fn times(self, factor: f64) -> Self {
        self * factor
    }
    #[inline]
    fn after(self, action: &f64) -> Self {
        self * action
    }

    fn actions(split: Split, is_film: bool, _: impl FnOnce() -> Turns) -> Actions<f64> {
        let reflected = match split {
            Split::Total { .. } => 1.0,
            Split::Partial { amplitude_s: s, amplitude_p: p, .. } => {
                let r = 0.5 * (s * s + p * p);
                if is_film { film_reflectance(r) } else { r }
            }
        };
        Actions { reflected, transmitted: 1.0 - reflected }
    }

    fn stokes(self) -> Stokes {
        [self, 0.0, 0.0, 0.0]
    }

    fn of_stokes(stokes: Stokes) -> Self {
        stokes[0]
    }
}

/// Powers of s and p light in a plane of incidence that never turns: incidence across the cuts.
impl Payload for [f64; 2] {
    type Action = [f64; 2];
    const ZERO: Self = [0.0; 2];

    #[inline]
    fn power(self) -> f64 {
        self[0] + self[1]
    }
    #[inline]
    fn largest(self) -> f64 {
        self[0].abs().max(self[1].abs())
    }
    #[inline]
    fn plus(self, other: Self) -> Self {
        [self[0] + other[0], self[1] + other[1]]
    }
    #[inline]
    fn times(self, factor: f64) -> Self {
        [self[0] * factor, self[1] * factor]
    }
    #[inline]
    fn after(self, action: &[f64; 2]) -> Self {
        [self[0] * action[0], self[1] * action[1]]
    }

    fn actions(split: Split, is_film: bool, _: impl FnOnce() -> Turns) -> Actions<[f64; 2]> {
        let reflected = match split {
            Split::Total { .. } => [1.0; 2],
            Split::Partial { amplitude_s: s, amplitude_p: p, .. } => {
                [s * s, p * p].map(|r| if is_film { film_reflectance(r) } else { r })
            }
        };
        Actions { reflected, transmitted: reflected.map(|r| 1.0 - r) }
    }

    fn stokes(self) -> Stokes {
        [self[0] + self[1], self[0] - self[1], 0.0, 0.0]
    }

    fn of_stokes([power, difference, ..]: Stokes) -> Self {
        [0.5 * (power + difference), 0.5 * (power - difference)]
    }
}

/// Full polarisation, in skew planes of incidence too.
impl Payload for Stokes {
    /// Column by column: one multiplication of all components by each.
    type Action = [Stokes; 4];
    const ZERO: Self = [0.0; 4];

    #[inline]
    fn power(self) -> f64 {
        self[0]
    }
    #[inline]
    fn largest(self) -> f64 {
        self[0].abs().max(self[1].abs()).max(self[2].abs().max(self[3].abs()))
    }
    #[inline]
    fn plus(self, other: Self) -> Self {
        [self[0] + other[0], self[1] + other[1], self[2] + other[2], self[3] + other[3]]
    }
    #[inline]
    fn times(self, factor: f64) -> Self {
        [self[0] * factor, self[1] * factor, self[2] * factor, self[3] * factor]
    }
    #[inline]
    fn after(self, action: &[Stokes; 4]) -> Self {
        let [a, b, c, d] = action;
        let component = |i: usize| a[i] * self[0] + b[i] * self[1] + c[i] * self[2] + d[i] * self[3];
        [component(0), component(1), component(2), component(3)]
    }

    fn actions(split: Split, is_film: bool, turns: impl FnOnce() -> Turns) -> Actions<[Stokes; 4]> {
        let turns = turns();
        let (reflected, transmitted) = if is_film {
            (Retarder::reflected_by_film(split), Retarder::transmitted_by_film(split))
        } else {
            (Retarder::reflected(split), Retarder::transmitted(split))
        };
        let columns = |m: Mueller| std::array::from_fn(|j| std::array::from_fn(|i| m.0[i][j]));
        Actions {
            reflected: columns(turns.mirrored.after(&reflected.mueller()).after(&turns.arriving)),
            transmitted: columns(turns.through.after(&transmitted.mueller()).after(&turns.arriving)),
        }
    }

    fn stokes(self) -> Stokes {
        self
    }

    fn of_stokes(stokes: Stokes) -> Self {
        stokes
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A gap mirrors what its first face mirrors and all that its faces send to and fro in between.
    #[test]
    fn a_film_sums_the_reflections_within_its_gap() {
        for r in [0.0_f64, 0.04, 0.3, 0.9] {
            let t = 1.0 - r;
            let summed: f64 = r + (0..2000).map(|k| t * r.powi(2 * k + 1) * t).sum::<f64>();
            assert!((film_reflectance(r) - summed).abs() < 1e-12, "R = {r}");
        }
        assert_eq!(film_reflectance(1.0), 1.0);
    }
}
