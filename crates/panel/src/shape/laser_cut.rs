//! An acrylic sheet with fine cuts.

use super::SHEET;
use crate::{
    error::{PanelError, positive, within},
    facet::{AIR, Facet, Finish},
    plane::Vec2,
    profile::Profile,
};

/// A laser-cut panel. Sequences repeat; sequences of different lengths repeat until all of them end together.
#[derive(Clone, Debug, PartialEq)]
pub struct LaserCut {
    /// Distance from each cut to the next.
    pub spacing: Vec<f64>,
    /// Thickness of the sheet.
    pub thickness: f64,
    /// Width of a cut, measured upwards; 0 for the ideal cut.
    pub cut_width: f64,
    /// Tilt of each cut [degrees]: positive if it rises from the outside to the room.
    pub cut_tilt_deg: Vec<f64>,
    /// How deep each cut goes, from the front; `None` for right through.
    pub cut_depth: Option<Vec<f64>>,
    /// Radius of curved cuts: positive if they bulge upwards, negative downwards; `None` for straight ones.
    pub cut_radius: Option<f64>,
    /// Ripple and haze of the cut faces.
    pub finish: Finish,
}

/// One cut: where it starts on the front face, and where it leads.
#[derive(Clone, Copy)]
struct Cut {
    from: Vec2,
    to: Vec2,
    goes_through: bool,
}

/// Longest sequence of cuts before a panel repeats.
const MOST_CUTS: usize = 4096;

impl LaserCut {
    /// An ideal panel: straight cuts of no width, right through and square to the sheet.
    pub fn ideal(spacing: f64, thickness: f64) -> Self {
        Self {
            spacing: vec![spacing],
            thickness,
            cut_width: 0.0,
            cut_tilt_deg: vec![0.0],
            cut_depth: None,
            cut_radius: None,
            finish: Finish::default(),
        }
    }

    /// Its cross-section.
    pub fn profile(&self) -> Result<Profile, PanelError> {
        self.check_sizes()?;
        let cuts = self.cuts()?;
        let period: f64 = (0..cuts.len()).map(|i| self.spacing[i % self.spacing.len()]).sum();
        self.check_neighbours(&cuts, period)?;
        let mut facets = Vec::new();
        let (half, up) = (0.5 * self.cut_width, |p: Vec2, dy: f64| p.raised(dy));
        for (i, cut) in cuts.iter().enumerate() {
            let next = cuts.get(i + 1).copied().unwrap_or_else(|| cuts[0].raised(period));
            facets.push(Facet::interface(up(cut.from, half), up(next.from, -half), AIR, SHEET));
            let bulge = self.bulge(cut)?;
            if self.cut_width == 0.0 {
                facets.push(Facet::film(cut.from, cut.to, SHEET).with_bulge(bulge).with_finish(self.finish));
                continue;
            }
            // the faces of the kerf: sheet below its lower face, air above, and the reverse
            let (low, high) = ((up(cut.from, -half), up(cut.to, -half)), (up(cut.from, half), up(cut.to, half)));
            facets.push(Facet::interface(low.0, low.1, AIR, SHEET).with_bulge(bulge).with_finish(self.finish));
            facets.push(Facet::interface(high.0, high.1, SHEET, AIR).with_bulge(bulge).with_finish(self.finish));
            if !cut.goes_through {
                facets.push(Facet::interface(low.1, high.1, AIR, SHEET).with_finish(self.finish));
            }
        }
        facets.extend(self.back_face(&cuts, period));
        Profile::new(facets, period)
    }

    /// The back face, in pieces between the cuts that go right through.
    fn back_face(&self, cuts: &[Cut], period: f64) -> Vec<Facet> {
        let half = 0.5 * self.cut_width;
        let through: Vec<Vec2> = cuts.iter().filter(|c| c.goes_through).map(|c| c.to).collect();
        if through.is_empty() {
            let foot = Vec2::new(self.thickness, 0.0);
            return vec![Facet::interface(foot, foot.raised(period), SHEET, AIR)];
        }
        (0..through.len())
            .map(|i| {
                let next = through.get(i + 1).copied().unwrap_or_else(|| through[0].raised(period));
                Facet::interface(through[i].raised(half), next.raised(-half), SHEET, AIR)
            })
            .collect()
    }

    fn check_sizes(&self) -> Result<(), PanelError> {
        for (name, sequence) in [("spacing_mm", &self.spacing), ("cut_tilt_deg", &self.cut_tilt_deg)] {
            if sequence.is_empty() {
                return Err(PanelError::Empty { name });
            }
        }
        positive("thickness_mm", self.thickness)?;
        for &spacing in &self.spacing {
            positive("spacing_mm", spacing)?;
            if self.cut_width >= spacing {
                return Err(PanelError::CutWiderThanSpacing { width: self.cut_width, spacing });
            }
        }
        if !(self.cut_width.is_finite() && self.cut_width >= 0.0) {
            let rule = "0 or a positive number".into();
            return Err(PanelError::OutOfRange { name: "cut_width_mm", rule, value: self.cut_width });
        }
        for &tilt in &self.cut_tilt_deg {
            within("cut_tilt_deg", tilt, -80.0, 80.0)?;
        }
        for &depth in self.cut_depth.iter().flatten() {
            positive("cut_depth_mm", depth)?;
            if depth > self.thickness {
                let rule = format!("at most thickness_mm ({})", self.thickness);
                return Err(PanelError::OutOfRange { name: "cut_depth_mm", rule, value: depth });
            }
        }
        if self.cut_depth.as_ref().is_some_and(Vec::is_empty) {
            return Err(PanelError::Empty { name: "cut_depth_mm" });
        }
        let degrees = self.finish.slope.to_degrees();
        if !(0.0..=30.0).contains(&degrees) {
            return Err(PanelError::OutOfRange {
                name: "cut_slope_deg",
                rule: "between 0 and 30".into(),
                value: degrees,
            });
        }
        within("cut_diffuse", self.finish.diffuse, 0.0, 1.0).map(|_| ())
    }

    fn cuts(&self) -> Result<Vec<Cut>, PanelError> {
        let lengths = [self.spacing.len(), self.cut_tilt_deg.len(), self.cut_depth.as_ref().map_or(1, Vec::len)];
        let count = lengths.into_iter().fold(1, least_common_multiple);
        if count > MOST_CUTS {
            let rule = format!("sequences that repeat within {MOST_CUTS} cuts (make their lengths agree)");
            return Err(PanelError::OutOfRange { name: "spacing_mm", rule, value: count as f64 });
        }
        let mut y = 0.0;
        let cuts = (0..count).map(|i| {
            let depth = self.cut_depth.as_ref().map_or(self.thickness, |d| d[i % d.len()]);
            let rise = self.tilt(i).to_radians().tan() * depth;
            let from = Vec2::new(0.0, y);
            y += self.spacing[i % self.spacing.len()];
            Cut { from, to: from + Vec2::new(depth, rise), goes_through: depth == self.thickness }
        });
        Ok(cuts.collect())
    }

    fn tilt(&self, cut: usize) -> f64 {
        self.cut_tilt_deg[cut % self.cut_tilt_deg.len()]
    }

    /// Neighbours must not meet where both are present.
    fn check_neighbours(&self, cuts: &[Cut], period: f64) -> Result<(), PanelError> {
        for (i, cut) in cuts.iter().enumerate() {
            let next = cuts.get(i + 1).copied().unwrap_or_else(|| cuts[0].raised(period));
            let depth = cut.to.z.min(next.to.z);
            let height = |c: &Cut| c.from.y + (c.to.y - c.from.y) * depth / c.to.z;
            if height(&next) - height(cut) <= self.cut_width {
                let second = (i + 1) % cuts.len();
                let (tilt_first, tilt_second) = (self.tilt(i), self.tilt(second));
                return Err(PanelError::CutsCross { first: i + 1, second: second + 1, tilt_first, tilt_second });
            }
        }
        Ok(())
    }

    /// Bulge of the arc of this radius over the cut's chord (theory/panels.md, eq. 2).
    fn bulge(&self, cut: &Cut) -> Result<f64, PanelError> {
        let Some(radius) = self.cut_radius else { return Ok(0.0) };
        let half_chord = 0.5 * (cut.to - cut.from).length();
        if !(radius.is_finite() && radius.abs() >= half_chord) {
            let rule = format!("at least half the length of the cut ({half_chord:.3}) or more, up or down");
            return Err(PanelError::OutOfRange { name: "cut_radius_mm", rule, value: radius });
        }
        // an arc that bulges up from left to right turns clockwise
        Ok(-radius.signum() * (0.5 * (half_chord / radius.abs()).asin()).tan())
    }
}

impl Cut {
    fn raised(self, dy: f64) -> Self {
        Self { from: self.from.raised(dy), to: self.to.raised(dy), ..self }
    }
}

fn least_common_multiple(a: usize, b: usize) -> usize {
    let (mut x, mut y) = (a, b);
    while y != 0 {
        (x, y) = (y, x % y);
    }
    a.checked_div(x).map_or(0, |quotient| quotient * b)
}
