//! The cross-section of a panel: facets between media, repeating upwards.

use crate::{
    error::{PanelError, positive},
    facet::{AIR, Facet, MediumId, Surface},
    plane::Vec2,
    topology::{HalfEdge, Outside, Topology, medium},
};

/// A checked cross-section that repeats every `period` upwards. Lengths may be in any unit: only ratios count,
/// but for absorption.
#[derive(Clone, Debug, PartialEq)]
pub struct Profile {
    facets: Vec<Facet>,
    period: f64,
    z_min: f64,
    z_max: f64,
    front: MediumId,
    back: MediumId,
    topology: Topology,
}

impl Profile {
    /// Checks a drawing: every facet has length, none crosses another or a copy of it one period on, the media around
    /// every vertex agree, and each side faces one medium.
    pub fn new(facets: Vec<Facet>, period: f64) -> Result<Self, PanelError> {
        positive("pitch_mm", period)?;
        if facets.is_empty() {
            return Err(PanelError::NoFacets);
        }
        for (i, f) in facets.iter().enumerate() {
            check_facet(i + 1, f, period)?;
        }
        check_crossings(&facets, period)?;
        Topology::check(&facets, period)?;
        let (mut z_min, mut z_max) = (f64::INFINITY, f64::NEG_INFINITY);
        for f in &facets {
            let (low, high) = f.z_range();
            (z_min, z_max) = (z_min.min(low), z_max.max(high));
        }
        let front = outside(&facets, period, "front")?;
        let back = outside(&facets, period, "back")?;
        let topology = Topology::of(&facets, period, Outside { front, back });
        Ok(Self { facets, period, z_min, z_max, front, back, topology })
    }

    /// Its facets.
    pub fn facets(&self) -> &[Facet] {
        &self.facets
    }

    /// Height after which it repeats.
    pub fn period(&self) -> f64 {
        self.period
    }

    /// Extent across the sheet, from the outermost point of the front to that of the back.
    pub fn z_range(&self) -> (f64, f64) {
        (self.z_min, self.z_max)
    }

    /// Medium before the front.
    pub fn front(&self) -> MediumId {
        self.front
    }

    /// Medium behind the back.
    pub fn back(&self) -> MediumId {
        self.back
    }

    /// Its regions.
    pub fn topology(&self) -> &Topology {
        &self.topology
    }

    /// The medium a half-edge looks at.
    #[inline]
    pub fn medium(&self, h: HalfEdge) -> MediumId {
        medium(&self.facets, h)
    }

    /// The highest medium it names.
    pub fn highest_medium(&self) -> MediumId {
        let film = |f: &Facet| if let Surface::Film(gap) = f.surface { gap } else { 0 };
        self.facets.iter().map(|f| f.left.max(f.right).max(film(f))).max().unwrap_or(0)
    }

    /// Whether light stays in beams: no ripple, no haze.
    pub fn is_smooth(&self) -> bool {
        self.facets.iter().all(|f| f.finish.is_smooth())
    }

    /// Whether every facet is a straight line.
    pub fn is_straight(&self) -> bool {
        self.facets.iter().all(Facet::is_straight)
    }

    /// Thickness and medium, if it is a plain pane: two smooth level faces with one medium between them and one around.
    pub fn pane(&self) -> Option<(f64, MediumId)> {
        let [a, b] = &self.facets[..] else { return None };
        let is_face =
            |f: &Facet| f.is_straight() && f.surface == Surface::Interface && (f.end.z - f.start.z).abs() == 0.0;
        let is_pane = is_face(a) && is_face(b) && self.is_smooth() && (self.front, self.back) == (AIR, AIR);
        // air outside on both sides, so that what a face has besides is the sheet
        is_pane.then_some((self.z_max - self.z_min, a.left.max(a.right)))
    }

    /// The same with every arc drawn by `chords` straight facets.
    pub fn flattened(&self, chords: usize) -> Result<Self, PanelError> {
        Self::new(self.facets.iter().flat_map(|f| f.chords(chords)).collect(), self.period)
    }
}

fn check_facet(number: usize, f: &Facet, period: f64) -> Result<(), PanelError> {
    let ends_differ = (f.end - f.start).length() > 1e-9 * period;
    if !(f.start.is_finite() && f.end.is_finite() && ends_differ) {
        let (z0, y0, z1, y1) = (f.start.z, f.start.y, f.end.z, f.end.y);
        return Err(PanelError::NoLength { facet: number, z0, y0, z1, y1 });
    }
    if !(f.bulge.abs() <= 1.0) {
        return Err(PanelError::Bulge { facet: number, bulge: f.bulge });
    }
    match f.surface {
        Surface::Film(_) if f.left != f.right => {
            Err(PanelError::FilmMedia { facet: number, left: f.left, right: f.right })
        }
        _ => Ok(()),
    }
}

/// Chords by which arcs are tested for crossings.
const TEST_CHORDS: usize = 24;

fn check_crossings(facets: &[Facet], period: f64) -> Result<(), PanelError> {
    let pieces: Vec<(usize, Facet)> =
        facets.iter().enumerate().flat_map(|(i, f)| f.chords(TEST_CHORDS).into_iter().map(move |c| (i, c))).collect();
    for (a, (i, one)) in pieces.iter().enumerate() {
        for (b, (j, other)) in pieces.iter().enumerate().skip(a) {
            // every copy of the other whose heights overlap those of the one
            let ((low, high), (low_other, high_other)) = (one.y_range(), other.y_range());
            let first = ((low - high_other) / period - 1e-9).ceil() as i64;
            let last = ((high - low_other) / period + 1e-9).floor() as i64;
            for k in first..=last {
                let is_itself = a == b && k == 0;
                if is_itself {
                    continue;
                }
                let dy = k as f64 * period;
                if let Some(at) = crossing(one.start, one.end, other.start.raised(dy), other.end.raised(dy), period) {
                    return Err(PanelError::Crossing { first: i + 1, second: j + 1, z: at.z, y: at.y });
                }
            }
        }
    }
    Ok(())
}

/// Where two segments meet other than end to end.
fn crossing(a: Vec2, b: Vec2, c: Vec2, d: Vec2, scale: f64) -> Option<Vec2> {
    let near = 1e-9 * scale;
    let meets_end = |p: Vec2, q: Vec2| (p - q).length() <= near;
    let (u, v) = (b - a, d - c);
    // an end that lies on the inside of the other segment
    let on_inside = |p: Vec2, from: Vec2, along: Vec2| {
        let length = along.length();
        let s = (p - from).dot(along) / length;
        (along.cross(p - from) / length).abs() <= near && s > near && s < length - near
    };
    for (p, from, along) in [(c, a, u), (d, a, u), (a, c, v), (b, c, v)] {
        if on_inside(p, from, along) {
            return Some(p);
        }
    }
    let same_ends = (meets_end(a, c) && meets_end(b, d)) || (meets_end(a, d) && meets_end(b, c));
    if same_ends {
        return Some((a + b) * 0.5);
    }
    let turn = u.cross(v);
    if turn.abs() <= 1e-15 * u.length() * v.length() {
        return None;
    }
    let (s, t) = ((c - a).cross(v) / turn, (c - a).cross(u) / turn);
    let (slack_s, slack_t) = (near / u.length(), near / v.length());
    let inside = s > slack_s && s < 1.0 - slack_s && t > slack_t && t < 1.0 - slack_t;
    inside.then(|| a + u * s)
}

/// Rays cast straight at a side to learn which medium it faces.
const PROBES: usize = 64;

/// The one medium that a side faces.
fn outside(facets: &[Facet], period: f64, side: &'static str) -> Result<MediumId, PanelError> {
    let lines: Vec<Facet> = facets.iter().flat_map(|f| f.chords(TEST_CHORDS)).collect();
    let towards_back = side == "front";
    let mut met: Option<MediumId> = None;
    for probe in 0..PROBES {
        // an irrational stride keeps probes off vertices
        let y = period * ((probe as f64 + 0.5) * 0.618_033_988_749_894_9).fract();
        let mut nearest: Option<(f64, MediumId)> = None;
        for f in &lines {
            let (low, high) = f.y_range();
            for k in ((low - y) / period).floor() as i64..=((high - y) / period).ceil() as i64 {
                let at = y + k as f64 * period;
                if at < low || at >= high {
                    continue;
                }
                let z = f.start.z + (f.end.z - f.start.z) * (at - f.start.y) / (f.end.y - f.start.y);
                // a facet that rises has smaller z on its left
                let rises = f.end.y > f.start.y;
                let faced = if rises == towards_back { f.left } else { f.right };
                let depth = if towards_back { z } else { -z };
                if nearest.is_none_or(|(d, _)| depth < d) {
                    nearest = Some((depth, faced));
                }
            }
        }
        if let Some((_, medium)) = nearest {
            match met {
                Some(one) if one != medium => return Err(PanelError::Outside { side, one, other: medium }),
                _ => met = Some(medium),
            }
        }
    }
    Ok(met.unwrap_or(crate::facet::AIR))
}
