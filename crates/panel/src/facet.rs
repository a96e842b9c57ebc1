//! One facet of a cross-section: a straight line or a circular arc between two media.

use crate::plane::Vec2;

/// Which of a profile's media; 0 is the air outside.
pub type MediumId = u8;

/// The air around the panel.
pub const AIR: MediumId = 0;

/// What kind of boundary a facet is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Surface {
    /// Two media touch.
    Interface,
    /// A gap of no width, filled with this medium, between two faces of one medium: the ideal laser cut.
    Film(MediumId),
}

/// How a facet departs from a perfect mirror.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Finish {
    /// Root-mean-square tilt of the rippled surface, along and across the cut [rad].
    pub slope: f64,
    /// Share of the light on it that is reflected diffusely.
    pub diffuse: f64,
}

impl Finish {
    /// Smooth and clear, so that light stays in beams.
    pub fn is_smooth(self) -> bool {
        self.slope == 0.0 && self.diffuse == 0.0
    }
}

/// A facet from `start` to `end`, with a medium on either hand.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Facet {
    /// Where it begins.
    pub start: Vec2,
    /// Where it ends.
    pub end: Vec2,
    /// Tangent of a quarter of the angle an arc sweeps, positive anticlockwise; 0 for a straight facet (as in DXF).
    pub bulge: f64,
    /// Medium on the left on the way from start to end.
    pub left: MediumId,
    /// Medium on the right.
    pub right: MediumId,
    /// Interface or film.
    pub surface: Surface,
    /// Ripple and haze.
    pub finish: Finish,
}

impl Facet {
    /// A smooth straight interface.
    pub fn interface(start: Vec2, end: Vec2, left: MediumId, right: MediumId) -> Self {
        Self { start, end, bulge: 0.0, left, right, surface: Surface::Interface, finish: Finish::default() }
    }

    /// A smooth straight air gap of no width inside `medium`.
    pub fn film(start: Vec2, end: Vec2, medium: MediumId) -> Self {
        Self { surface: Surface::Film(AIR), ..Self::interface(start, end, medium, medium) }
    }

    /// The same, curved.
    pub fn with_bulge(self, bulge: f64) -> Self {
        Self { bulge, ..self }
    }

    /// The same, rippled or hazy.
    pub fn with_finish(self, finish: Finish) -> Self {
        Self { finish, ..self }
    }

    /// Whether it is a straight line.
    pub fn is_straight(&self) -> bool {
        self.bulge == 0.0
    }

    /// Centre and radius of an arc.
    pub fn circle(&self) -> Option<(Vec2, f64)> {
        if self.is_straight() {
            return None;
        }
        let chord = self.end - self.start;
        let middle = (self.start + self.end) * 0.5;
        // distance of the centre from the chord, to the left for an anticlockwise arc of less than half a turn
        let b = self.bulge;
        let centre = middle + chord.left() * ((1.0 - b * b) / (4.0 * b));
        Some((centre, (self.start - centre).length()))
    }

    /// The point at share `s` (0..=1) of the way.
    pub fn at(&self, s: f64) -> Vec2 {
        let Some((centre, _)) = self.circle() else {
            return self.start + (self.end - self.start) * s;
        };
        let (sin, cos) = (4.0 * self.bulge.atan() * s).sin_cos();
        let from = self.start - centre;
        centre + from * cos + from.left() * sin
    }

    /// Unit tangent at share `s`, in the sense of travel.
    pub fn tangent(&self, s: f64) -> Vec2 {
        match self.circle() {
            None => (self.end - self.start).normalized(),
            Some((centre, _)) => (self.at(s) - centre).left().normalized() * self.bulge.signum(),
        }
    }

    /// Signed curvature: positive for an anticlockwise arc.
    pub fn curvature(&self) -> f64 {
        self.circle().map_or(0.0, |(_, radius)| self.bulge.signum() / radius)
    }

    /// The same facet drawn by `chords` straight ones if it is an arc.
    pub fn chords(&self, chords: usize) -> Vec<Facet> {
        if self.is_straight() {
            return vec![*self];
        }
        let point = |i: usize| match i {
            0 => self.start,
            i if i == chords => self.end,
            i => self.at(i as f64 / chords as f64),
        };
        (0..chords).map(|i| Facet { start: point(i), end: point(i + 1), bulge: 0.0, ..*self }).collect()
    }

    /// Least and greatest height.
    pub fn y_range(&self) -> (f64, f64) {
        self.range(|p| p.y)
    }

    /// Least and greatest depth across the sheet.
    pub fn z_range(&self) -> (f64, f64) {
        self.range(|p| p.z)
    }

    fn range(&self, of: impl Fn(Vec2) -> f64) -> (f64, f64) {
        let (a, b) = (of(self.start), of(self.end));
        let (mut low, mut high) = (a.min(b), a.max(b));
        if let Some((centre, radius)) = self.circle() {
            // an arc may reach beyond its ends where the circle turns
            for extreme in [Vec2::new(1.0, 0.0), Vec2::new(-1.0, 0.0), Vec2::new(0.0, 1.0), Vec2::new(0.0, -1.0)] {
                let p = centre + extreme * radius;
                if self.share_of_arc(centre, p).is_some() {
                    (low, high) = (low.min(of(p)), high.max(of(p)));
                }
            }
        }
        (low, high)
    }

    /// Share of the way at which the arc passes the direction of `p` from its centre, if it does.
    pub fn share_of_arc(&self, centre: Vec2, p: Vec2) -> Option<f64> {
        let sweep = 4.0 * self.bulge.atan();
        let (from, to) = (self.start - centre, p - centre);
        let mut turn = from.cross(to).atan2(from.dot(to));
        if sweep > 0.0 && turn < -1e-9 {
            turn += std::f64::consts::TAU;
        } else if sweep < 0.0 && turn > 1e-9 {
            turn -= std::f64::consts::TAU;
        }
        let s = turn / sweep;
        (-1e-9..=1.0 + 1e-9).contains(&s).then(|| s.clamp(0.0, 1.0))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A bulge of one is a half circle, to the right of its chord when anticlockwise.
    #[test]
    fn a_bulge_of_one_is_a_half_circle() {
        let arc = Facet::interface(Vec2::new(0.0, 0.0), Vec2::new(2.0, 0.0), 0, 1).with_bulge(1.0);
        let (centre, radius) = arc.circle().expect("an arc");
        assert!((centre - Vec2::new(1.0, 0.0)).length() < 1e-12 && (radius - 1.0).abs() < 1e-12);
        assert!((arc.at(0.5) - Vec2::new(1.0, -1.0)).length() < 1e-12);
        assert!((arc.tangent(0.5) - Vec2::new(1.0, 0.0)).length() < 1e-12);
        assert_eq!(arc.y_range().0, -1.0);
    }

    /// The ends of an arc are its ends, whichever way it turns.
    #[test]
    fn arcs_end_where_they_end() {
        for bulge in [-0.4, 0.1, 0.7] {
            let arc = Facet::interface(Vec2::new(0.3, 1.0), Vec2::new(2.0, -0.5), 0, 1).with_bulge(bulge);
            assert!((arc.at(1.0) - arc.end).length() < 1e-12);
            let (centre, _) = arc.circle().expect("an arc");
            assert!((arc.share_of_arc(centre, arc.at(0.25)).expect("on it") - 0.25).abs() < 1e-12);
        }
    }
}
