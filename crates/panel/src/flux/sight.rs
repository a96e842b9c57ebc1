//! What a facet sees in one direction: which facets its light goes to next, and how far.

use crate::{
    facet::{Facet, MediumId},
    plane::Vec2,
    profile::Profile,
    topology::HalfEdge,
};

/// Where light goes next.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Target {
    /// To this hand of a facet, so many periods up.
    Facet(HalfEdge, i32),
    /// Out of the panel.
    Outside,
    /// Nowhere within reach: it runs along the sheet.
    Nowhere,
}

/// One stretch of the source, all of whose light goes to one target.
#[derive(Clone, Copy, Debug)]
pub struct Sight {
    /// Where on the source it begins (0..=1).
    pub start: f64,
    /// Where it ends.
    pub end: f64,
    /// What it sees.
    pub target: Target,
    /// Place on the target at the source's 0, and its change along the source.
    pub place: (f64, f64),
    /// Distance within the section at the source's 0, and its change along the source.
    pub distance: (f64, f64),
}

/// Stretches shorter than this share of the source are rounding errors.
const SLIVER: f64 = 1e-12;
/// Copies looked through before light that runs along the sheet is given up.
const MOST_COPIES: i64 = 20_000;

/// The source of light: a segment, the hand of the facet it is (none for the sky), the medium it shines into.
#[derive(Clone, Copy, Debug)]
pub struct Source {
    /// Where parameter 0 is.
    pub start: Vec2,
    /// Where parameter 1 is.
    pub end: Vec2,
    /// Hand of the facet that shines.
    pub hand: Option<HalfEdge>,
    /// Medium it shines into.
    pub medium: MediumId,
}

/// Looks from a source along direction `d` (unit) and writes what it sees to `out`, which covers 0..=1.
pub fn look(profile: &Profile, source: Source, d: Vec2, out: &mut Vec<Sight>) {
    out.clear();
    let open =
        Sight { start: 0.0, end: 1.0, target: Target::Outside, place: (0.0, 0.0), distance: (f64::INFINITY, 0.0) };
    out.push(open);
    let (z_min, z_max) = profile.z_range();
    let eps = 1e-12 * profile.period();
    let outermost = |z: f64| if d.z > 0.0 { z >= z_max - eps } else { d.z < 0.0 && z <= z_min + eps };
    if source.hand.is_some() && outermost(source.start.z) && outermost(source.end.z) {
        return;
    }
    let view = View::new(source, d, profile.period());
    if view.width.abs() <= eps {
        out[0].target = Target::Nowhere;
        return;
    }
    match source.hand.and_then(|h| profile.topology().region(h)) {
        Some((border, own)) => {
            for &(h, shift) in border {
                match profile.topology().mouth(h) {
                    Some(mouth) => view.consider_mouth(mouth, h, shift - own, out),
                    None => view.consider(profile, h.facet(), Some(h), shift - own, out),
                }
            }
        }
        None => look_through_copies(profile, &view, out),
    }
    close_slivers(out);
    let exit_medium = if d.z > 0.0 { profile.back() } else { profile.front() };
    let is_blind = d.z == 0.0 || source.medium != exit_medium || view.gave_up(profile);
    for sight in out.iter_mut().filter(|s| s.target == Target::Outside && is_blind) {
        sight.target = Target::Nowhere;
    }
}

/// An open region: take the copies of all facets in the order in which light meets them.
fn look_through_copies(profile: &Profile, view: &View, out: &mut Vec<Sight>) {
    let (mut near, mut far) = (f64::INFINITY, f64::NEG_INFINITY);
    for f in profile.facets() {
        for p in [f.start, f.end] {
            let along = view.d.dot(p);
            (near, far) = (near.min(along), far.max(along));
        }
    }
    let rise = view.d.y * view.period;
    let (first, last) = view.copies(profile);
    let source_near = view.along.0.min(view.along.0 + view.along.1);
    let in_order: Box<dyn Iterator<Item = i64>> =
        if view.d.y >= 0.0 { Box::new(first..=last) } else { Box::new((first..=last).rev()) };
    let is_behind = |k: i64| far + k as f64 * rise < source_near - 1e-9 * view.period;
    // copies come in the order of their distance: those behind the source come first
    let behind = if rise == 0.0 { 0.0 } else { ((source_near - 1e-9 * view.period - far) / rise.abs()).floor() };
    let nearest = if view.d.y >= 0.0 { first } else { -last };
    let skipped = (behind - nearest as f64).clamp(0.0, 1e9) as usize;
    for k in in_order.skip(skipped).take(MOST_COPIES as usize) {
        let shift = k as f64 * rise;
        if is_behind(k) {
            continue;
        }
        // covered by something nearer than all that is still to come
        let covered = out.iter().map(|s| s.reach()).fold(f64::NEG_INFINITY, f64::max);
        if covered < near + shift {
            break;
        }
        for facet in 0..profile.facets().len() {
            view.consider(profile, facet, None, k as i32, out);
        }
    }
}

/// Stretches left open only by rounding join their neighbour.
fn close_slivers(out: &mut Vec<Sight>) {
    let mut i = 0;
    while out.len() > 1 && i < out.len() {
        let is_open_sliver = out[i].target == Target::Outside && out[i].end - out[i].start < 1e-9;
        if is_open_sliver {
            let gone = out.remove(i);
            if i > 0 {
                out[i - 1].end = gone.end;
            } else {
                out[0].start = gone.start;
            }
        } else {
            i += 1;
        }
    }
}

impl Sight {
    /// Farthest point, measured along the light.
    fn reach(&self) -> f64 {
        (self.distance.0 + self.distance.1 * self.start).max(self.distance.0 + self.distance.1 * self.end)
    }
}

/// A source seen along a direction: `across` tells rays apart, `along` orders what they meet.
struct View {
    source: Source,
    d: Vec2,
    period: f64,
    /// Across at the source's 0.
    across: f64,
    /// Change of across along the source.
    width: f64,
    /// Along at the source's 0, and its change.
    along: (f64, f64),
}

impl View {
    fn new(source: Source, d: Vec2, period: f64) -> Self {
        let across = d.cross(source.start);
        let along = d.dot(source.start);
        Self {
            source,
            d,
            period,
            across,
            width: d.cross(source.end) - across,
            along: (along, d.dot(source.end) - along),
        }
    }

    /// First and last copy that any ray of the source can meet.
    fn copies(&self, profile: &Profile) -> (i64, i64) {
        let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
        for f in profile.facets() {
            for p in [f.start, f.end] {
                let across = self.d.cross(p);
                (low, high) = (low.min(across), high.max(across));
            }
        }
        // a copy one period up moves across by d.z · period
        let step = self.d.z * self.period;
        let (from, to) = (self.across.min(self.across + self.width), self.across.max(self.across + self.width));
        if step.abs() < 1e-12 * self.period {
            return (-MOST_COPIES / 2, MOST_COPIES / 2);
        }
        let (a, b) = ((from - high) / step, (to - low) / step);
        let clamp = |k: f64| k.clamp(-1e9, 1e9) as i64;
        (clamp(a.min(b).ceil() - 1.0), clamp(a.max(b).floor() + 1.0))
    }

    /// Whether the search may have ended before the light met anything.
    fn gave_up(&self, profile: &Profile) -> bool {
        let (first, last) = self.copies(profile);
        self.source.hand.is_none_or(|h| profile.topology().region(h).is_none()) && last - first > MOST_COPIES
    }

    /// Puts a facet `copy` periods up into the picture, wherever it is the nearest so far.
    fn consider(&self, profile: &Profile, facet: usize, hand: Option<HalfEdge>, copy: i32, out: &mut Vec<Sight>) {
        let is_itself = copy == 0 && self.source.hand.is_some_and(|h| h.facet() == facet);
        let Some((sight, is_left)) = (!is_itself).then(|| self.towards(&profile.facets()[facet], copy)).flatten()
        else {
            return;
        };
        let facing = if is_left { HalfEdge::left(facet) } else { HalfEdge::right(facet) };
        let is_seen = match hand {
            Some(h) => h == facing,
            None => profile.medium(facing) == self.source.medium,
        };
        if is_seen {
            insert(Sight { target: Target::Facet(facing, copy), ..sight }, out);
        }
    }

    /// The same for a mouth: light that meets it from inside has left.
    fn consider_mouth(&self, mouth: &Facet, hand: HalfEdge, copy: i32, out: &mut Vec<Sight>) {
        if let Some((sight, is_left)) = self.towards(mouth, copy) {
            if is_left == hand.is_left() {
                insert(sight, out);
            }
        }
    }

    /// The stretch whose light comes upon a facet `copy` periods up, as if nothing were in the way, and whether upon its
    /// left hand.
    fn towards(&self, f: &Facet, copy: i32) -> Option<(Sight, bool)> {
        let dy = f64::from(copy) * self.period;
        let (a, b) = (f.start.raised(dy), f.end.raised(dy));
        let (across_a, across_b) = (self.d.cross(a), self.d.cross(b));
        let span = across_b - across_a;
        if span.abs() <= SLIVER * self.period {
            return None;
        }
        // where on the source the rays start that meet its two ends
        let (s_a, s_b) = ((across_a - self.across) / self.width, (across_b - self.across) / self.width);
        let (start, end) = (s_a.min(s_b).max(0.0), s_a.max(s_b).min(1.0));
        if end - start <= SLIVER {
            return None;
        }
        // place on the facet and depth of the facet are linear along the source
        let place = ((self.across - across_a) / span, self.width / span);
        let (along_a, along_b) = (self.d.dot(a), self.d.dot(b));
        let depth = (along_a + (along_b - along_a) * place.0, (along_b - along_a) * place.1);
        let distance = (depth.0 - self.along.0, depth.1 - self.along.1);
        let middle = 0.5 * (start + end);
        if distance.0 + distance.1 * middle < -1e-11 * self.period {
            return None;
        }
        // light that crosses from left to right meets the left hand
        Some((Sight { start, end, target: Target::Outside, place, distance }, span > 0.0))
    }
}

/// Puts `new` in front of whatever is farther away.
fn insert(new: Sight, out: &mut Vec<Sight>) {
    let mut i = 0;
    while i < out.len() {
        let old = out[i];
        let (mut from, mut to) = (new.start.max(old.start), new.end.min(old.end));
        // rounding at shared vertices: no stretch of no length
        if from - old.start <= SLIVER {
            from = old.start;
        }
        if old.end - to <= SLIVER {
            to = old.end;
        }
        if to - from <= SLIVER || new.start >= old.end || new.end <= old.start {
            i += 1;
            continue;
        }
        let middle = 0.5 * (from + to);
        let at = |s: &Sight| s.distance.0 + s.distance.1 * middle;
        if at(&new) >= at(&old) {
            i += 1;
            continue;
        }
        let parts = [(old.start, from, old), (from, to, new), (to, old.end, old)];
        let kept = parts.into_iter().filter(|(a, b, _)| b > a).map(|(start, end, s)| Sight { start, end, ..s });
        let count = parts.iter().filter(|(a, b, _)| b > a).count();
        out.splice(i..=i, kept);
        i += count;
    }
}
