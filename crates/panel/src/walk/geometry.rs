//! The profile as a walk needs it: for each hand of a facet, what a ray that leaves it can meet.

use crate::{
    facet::Facet,
    plane::Vec2,
    profile::Profile,
    topology::{HalfEdge, Placed, medium},
};
use hemisphere::Vec3;

/// One hand of a facet, run with its region on the left.
#[derive(Clone, Copy, Debug)]
struct Edge {
    start: Vec2,
    /// From its start to its end.
    span: Vec2,
    /// Unit vector into the region (for an arc: of its chord).
    inward: Vec2,
    /// Inward · start: distance of the line from the origin.
    offset: f64,
    arc: Option<Arc>,
}

#[derive(Clone, Copy, Debug)]
struct Arc {
    facet: Facet,
    centre: Vec2,
    radius: f64,
    /// Whether the centre lies on the region's side.
    is_hollow: bool,
}

/// What lies around the rays that leave one hand.
#[derive(Clone, Copy, Debug)]
enum Surroundings {
    /// A convex region with straight sides: the first line ahead is hit.
    Convex { first: u32, last: u32, own: i32 },
    /// Any other closed region.
    Closed { first: u32, last: u32, own: i32 },
    /// A region without end.
    Open,
}

/// The geometry of a walk.
#[derive(Clone, Debug)]
pub struct Geometry {
    edges: Vec<Edge>,
    surroundings: Vec<Surroundings>,
    /// The borders of the closed regions, each edge raised into place.
    borders: Vec<(HalfEdge, i32, Edge)>,
    /// Hands that lie in the outermost plane of the sheet and look away from it.
    outermost: Vec<bool>,
    /// Those hands at the front and at the back, with the heights they span: light from the open meets them at once. Of a
    /// mouth it is the hand that looks in: light goes on from there.
    doors: [Vec<(f64, f64, HalfEdge)>; 2],
    media: Vec<u8>,
    /// Hands of facets; those of mouths come after them.
    hands: u32,
    period: f64,
    z: (f64, f64),
    y: (f64, f64),
    outside: (u8, u8),
}

/// What a ray meets.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Meeting {
    /// This hand of a facet, at this point of its own period, after this length.
    Facet(HalfEdge, Vec2, f64),
    /// The open.
    Outside,
    /// Nothing within reach: it runs along the sheet.
    Nothing,
}

/// Copies looked through before a ray that runs along the sheet is given up.
const MOST_COPIES: i64 = 20_000;

impl Geometry {
    /// Prepares a profile.
    pub fn of(profile: &Profile) -> Self {
        let hands = 2 * profile.facets().len() as u32;
        let all: Vec<Facet> = profile.facets().iter().chain(profile.topology().mouths()).copied().collect();
        let edges: Vec<Edge> = (0..2 * all.len() as u32).map(|h| Edge::of(&all, HalfEdge(h))).collect();
        let (z, period) = (profile.z_range(), profile.period());
        let mut geometry = Self {
            surroundings: vec![Surroundings::Open; edges.len()],
            borders: Vec::new(),
            outermost: edges.iter().map(|e| e.is_outermost(z)).collect(),
            doors: [doors(&edges, hands, z, true), doors(&edges, hands, z, false)],
            media: (0..2 * all.len() as u32).map(|h| medium(&all, HalfEdge(h))).collect(),
            hands,
            period,
            z,
            y: profile
                .facets()
                .iter()
                .map(Facet::y_range)
                .fold((f64::MAX, f64::MIN), |y, r| (y.0.min(r.0), y.1.max(r.1))),
            outside: (profile.front(), profile.back()),
            edges,
        };
        for hand in (0..2 * all.len() as u32).map(HalfEdge) {
            if let Some((border, own)) = profile.topology().region(hand) {
                geometry.surroundings[hand.0 as usize] = geometry.enclose(border, own);
            }
        }
        geometry
    }

    /// Files a border (once for each of its hands: short lists, read in one go).
    fn enclose(&mut self, border: &[Placed], own: i32) -> Surroundings {
        let first = self.borders.len() as u32;
        for &(h, shift) in border {
            self.borders.push((h, shift, self.edges[h.0 as usize].raised(f64::from(shift) * self.period)));
        }
        let last = self.borders.len() as u32;
        let sides = &self.borders[first as usize..];
        let turns_left = |i: usize| {
            let (a, b) = (sides[i].2.span, sides[(i + 1) % sides.len()].2.span);
            a.cross(b) > 0.0
        };
        let is_straight = sides.iter().all(|(_, _, e)| e.arc.is_none());
        if is_straight && (0..sides.len()).all(turns_left) {
            Surroundings::Convex { first, last, own }
        } else {
            Surroundings::Closed { first, last, own }
        }
    }

    /// What light from the open meets first that enters at share `u` of a period along `v`.
    #[inline]
    pub fn enter(&self, u: f64, v: Vec3) -> Meeting {
        let from_front = v.z > 0.0;
        let at = Vec2::new(if from_front { self.z.0 } else { self.z.1 }, u * self.period);
        for &(low, high, hand) in &self.doors[usize::from(!from_front)] {
            let y = at.y + ((low - at.y) / self.period).ceil() * self.period;
            if y <= high {
                let at = Vec2::new(at.z, y);
                return if hand.0 < self.hands { Meeting::Facet(hand, at, 0.0) } else { self.next(hand, at, v) };
            }
        }
        self.through_copies(None, at, Vec2::new(v.z, v.y))
    }

    /// The medium that light travelling along `v` leaves into.
    pub fn outside(&self, v: Vec3) -> u8 {
        if v.z > 0.0 { self.outside.1 } else { self.outside.0 }
    }

    /// The medium a hand looks at.
    #[inline]
    pub fn medium(&self, hand: HalfEdge) -> u8 {
        self.media[hand.0 as usize]
    }

    /// Unit normal of a hand at a point, into its region.
    #[inline]
    pub fn inward(&self, hand: HalfEdge, at: Vec2) -> Vec2 {
        let edge = &self.edges[hand.0 as usize];
        match &edge.arc {
            None => edge.inward,
            Some(arc) => {
                let out = (at - arc.centre) * (1.0 / arc.radius);
                if arc.is_hollow { -out } else { out }
            }
        }
    }

    /// The point at share `s` of the facet of `hand`, along the facet's own sense.
    pub fn point(&self, hand: HalfEdge, s: f64) -> Vec2 {
        let edge = &self.edges[HalfEdge::left(hand.facet()).0 as usize];
        match &edge.arc {
            None => edge.start + edge.span * s,
            Some(arc) => arc.facet.at(s),
        }
    }

    /// The next thing on the way of a ray that leaves `hand` at `from` along `v`.
    #[inline]
    pub fn next(&self, hand: HalfEdge, from: Vec2, v: Vec3) -> Meeting {
        let v = Vec2::new(v.z, v.y);
        match self.surroundings[hand.0 as usize] {
            Surroundings::Convex { first, last, own } => {
                let p = from.raised(f64::from(own) * self.period);
                let mut nearest = (f64::INFINITY, first as usize);
                for (i, (_, _, edge)) in self.borders[first as usize..last as usize].iter().enumerate() {
                    let towards = v.dot(edge.inward);
                    let t = (edge.offset - p.dot(edge.inward)) / towards;
                    if towards < 0.0 && t < nearest.0 {
                        nearest = (t, first as usize + i);
                    }
                }
                self.meeting(nearest.1, nearest.0.max(0.0), p, v)
            }
            Surroundings::Closed { first, last, own } => {
                let p = from.raised(f64::from(own) * self.period);
                let mut nearest: Option<(f64, usize)> = None;
                for (i, (h, shift, edge)) in self.borders[first as usize..last as usize].iter().enumerate() {
                    let is_own = h.facet() == hand.facet() && *shift == own;
                    if let Some(t) = edge.meet(p, v, is_own, self.period) {
                        if nearest.is_none_or(|(least, _)| t < least) {
                            nearest = Some((t, first as usize + i));
                        }
                    }
                }
                nearest.map_or(Meeting::Nothing, |(t, i)| self.meeting(i, t, p, v))
            }
            Surroundings::Open => {
                let looks_away = self.outermost[hand.0 as usize];
                if looks_away { Meeting::Outside } else { self.through_copies(Some(hand), from, v) }
            }
        }
    }

    /// What is met at border `i` after `t`: outside a mouth is the open.
    #[inline]
    fn meeting(&self, i: usize, t: f64, p: Vec2, v: Vec2) -> Meeting {
        let (met, shift, _) = self.borders[i];
        if met.0 >= self.hands {
            return Meeting::Outside;
        }
        Meeting::Facet(met, (p + v * t).raised(-f64::from(shift) * self.period), t)
    }

    /// Copy after copy in the order in which the ray passes them.
    fn through_copies(&self, hand: Option<HalfEdge>, from: Vec2, v: Vec2) -> Meeting {
        let medium = match hand {
            Some(h) => self.medium(h),
            None if v.z > 0.0 => self.outside.0,
            None => self.outside.1,
        };
        let ends = if v.z > 0.0 { self.z.1 } else { self.z.0 };
        let leaves_after = if v.z == 0.0 { f64::INFINITY } else { (ends - from.z) / v.z };
        // copy k reaches from y.0 + k · period to y.1 + k · period
        let height = self.y.1 - self.y.0;
        let upward = v.y >= 0.0;
        let first = if upward { (from.y - self.y.1) / self.period } else { (from.y - self.y.0) / self.period };
        let first = if upward { first.ceil() - 1.0 } else { first.floor() + 1.0 } as i64;
        let step = if upward { 1 } else { -1 };
        let mut nearest: Option<(f64, HalfEdge, i64)> = None;
        for i in 0..MOST_COPIES {
            let k = first + i * step;
            let dy = k as f64 * self.period;
            // when the ray comes to this copy
            let (near, far) = if upward { (self.y.0 + dy, self.y.1 + dy) } else { (self.y.1 + dy, self.y.0 + dy) };
            let slack = 1e-9 * height;
            let begins =
                if v.y == 0.0 { f64::NEG_INFINITY } else { ((near - from.y) - slack * f64::from(step as i32)) / v.y };
            let is_behind = if upward { far < from.y - slack } else { far > from.y + slack };
            let done = nearest.is_some_and(|(t, ..)| t < begins) || begins > leaves_after + slack;
            let level_and_past = v.y == 0.0 && near > from.y + slack;
            if done || level_and_past {
                break;
            }
            if is_behind {
                continue;
            }
            let p = from.raised(-dy);
            for (h, edge) in self.edges[..self.hands as usize].iter().enumerate() {
                let h = HalfEdge(h as u32);
                if self.media[h.0 as usize] != medium {
                    continue;
                }
                let is_own = k == 0 && hand.is_some_and(|own| own.facet() == h.facet());
                if let Some(t) = edge.meet(p, v, is_own, self.period) {
                    if nearest.is_none_or(|(least, ..)| t < least) {
                        nearest = Some((t, h, k));
                    }
                }
            }
        }
        match nearest {
            Some((t, h, k)) => Meeting::Facet(h, (from + v * t).raised(-(k as f64) * self.period), t),
            None if leaves_after.is_finite() && medium == if v.z > 0.0 { self.outside.1 } else { self.outside.0 } => {
                Meeting::Outside
            }
            None => Meeting::Nothing,
        }
    }
}

/// The hands in the outermost plane of one side that light from the open meets, with their heights.
fn doors(edges: &[Edge], hands: u32, z: (f64, f64), is_front: bool) -> Vec<(f64, f64, HalfEdge)> {
    let is_met = |(i, e): &(usize, &Edge)| {
        let looks_out = e.is_outermost(z) && (e.inward.z < 0.0) == is_front;
        if (*i as u32) < hands { looks_out } else { e.is_mouth_of(z, is_front) && (e.inward.z > 0.0) == is_front }
    };
    let door = |(i, e): (usize, &Edge)| {
        let (a, b) = (e.start.y, e.start.y + e.span.y);
        (a.min(b), a.max(b), HalfEdge(i as u32))
    };
    edges.iter().enumerate().filter(is_met).map(door).collect()
}

impl Edge {
    fn of(facets: &[Facet], hand: HalfEdge) -> Self {
        let facet = facets[hand.facet()];
        let (start, end) = if hand.is_left() { (facet.start, facet.end) } else { (facet.end, facet.start) };
        let span = end - start;
        let inward = span.left().normalized();
        let arc = facet.circle().map(|(centre, radius)| Arc {
            facet,
            centre,
            radius,
            // an anticlockwise arc has its centre on the left
            is_hollow: (facet.bulge > 0.0) == hand.is_left(),
        });
        Self { start, span, inward, offset: inward.dot(start), arc }
    }

    fn raised(&self, dy: f64) -> Self {
        let start = self.start.raised(dy);
        let arc = self.arc.map(|a| Arc {
            facet: Facet { start: a.facet.start.raised(dy), end: a.facet.end.raised(dy), ..a.facet },
            centre: a.centre.raised(dy),
            ..a
        });
        Self { start, offset: self.inward.dot(start), arc, ..*self }
    }

    fn is_outermost(&self, z: (f64, f64)) -> bool {
        let eps = 1e-12 * (z.1 - z.0);
        let flat = self.arc.is_none() && self.span.z.abs() <= eps;
        flat && ((self.start.z <= z.0 + eps && self.inward.z < 0.0)
            || (self.start.z >= z.1 - eps && self.inward.z > 0.0))
    }

    /// Whether this hand of a mouth lies in the front or in the back plane.
    fn is_mouth_of(&self, z: (f64, f64), is_front: bool) -> bool {
        (self.start.z < 0.5 * (z.0 + z.1)) == is_front
    }

    /// How far along `v` from `p` a ray comes upon this hand from inside its region. `is_own`: the ray starts on this facet.
    #[inline]
    fn meet(&self, p: Vec2, v: Vec2, is_own: bool, scale: f64) -> Option<f64> {
        let near = 1e-12 * scale;
        let Some(arc) = &self.arc else {
            let towards = v.dot(self.inward);
            if towards >= 0.0 || is_own {
                return None;
            }
            let t = (self.offset - p.dot(self.inward)) / towards;
            if t < -near {
                return None;
            }
            // ends count: a ray never slips between two facets that share a vertex
            let s = (p + v * t - self.start).dot(self.span) / self.span.dot(self.span);
            return (-1e-12..=1.0 + 1e-12).contains(&s).then_some(t.max(0.0));
        };
        arc.meet(p, v, is_own, near)
    }
}

impl Arc {
    /// |p + t v − centre| = radius; of a ray that starts on the arc itself the root t = 0 is divided out.
    fn meet(&self, p: Vec2, v: Vec2, is_own: bool, near: f64) -> Option<f64> {
        let from = p - self.centre;
        let (a, half_b) = (v.dot(v), from.dot(v));
        let c = if is_own { 0.0 } else { from.dot(from) - self.radius * self.radius };
        let discriminant = half_b * half_b - a * c;
        if discriminant <= 0.0 {
            return None;
        }
        let root = discriminant.sqrt();
        // seen from the hollow side the far root is hit, from the other side the near one
        let t = if self.is_hollow {
            if half_b > 0.0 && !is_own { -c / (half_b + root) } else { (root - half_b) / a }
        } else if half_b < 0.0 {
            if is_own { 0.0 } else { c / (root - half_b) }
        } else {
            (-half_b - root) / a
        };
        let starts_here = is_own && t.abs() <= near;
        if t < -near || starts_here {
            return None;
        }
        self.facet.share_of_arc(self.centre, p + v * t).map(|_| t.max(0.0))
    }
}
