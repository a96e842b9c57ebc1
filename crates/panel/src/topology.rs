//! How the facets of a profile hang together: its vertices, and the regions they enclose.
//!
//! Each facet has two half-edges, one for either hand. Walking along half-edges with the region on the left, and turning
//! as sharply left as possible at every vertex, goes once around a region. A walk that comes back to where it began without
//! having climbed a period, anticlockwise, is the border of a *closed* region: light inside it can only meet that border.
//!
//! Cuts and grooves that open to the outside are closed by *mouths*: lines in the outermost planes, from one facet that
//! touches the plane to the next, that let all light pass. Light that meets a mouth from inside has left the panel.

use crate::{
    error::PanelError,
    facet::{Facet, MediumId},
    plane::Vec2,
};

/// One hand of a facet: `2 · facet` is its left, `2 · facet + 1` its right. Mouths are counted on after the facets.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct HalfEdge(pub u32);

impl HalfEdge {
    /// The left hand of facet `index`.
    pub fn left(index: usize) -> Self {
        Self(2 * index as u32)
    }

    /// The right hand of facet `index`.
    pub fn right(index: usize) -> Self {
        Self(2 * index as u32 + 1)
    }

    /// The facet it belongs to.
    #[inline]
    pub fn facet(self) -> usize {
        (self.0 / 2) as usize
    }

    /// Whether it is the left hand.
    #[inline]
    pub fn is_left(self) -> bool {
        self.0 % 2 == 0
    }

    /// The other hand of the same facet.
    #[inline]
    pub fn other(self) -> Self {
        Self(self.0 ^ 1)
    }

    /// +1 if the facet's own sense keeps the region on the left, −1 if not.
    #[inline]
    pub fn sign(self) -> f64 {
        if self.is_left() { 1.0 } else { -1.0 }
    }

    fn index(self) -> usize {
        self.0 as usize
    }
}

/// A half-edge and how many periods up it is.
pub type Placed = (HalfEdge, i32);

/// The regions of a profile.
#[derive(Clone, Debug, PartialEq)]
pub struct Topology {
    /// Number of facets that are no mouths.
    facets: usize,
    mouths: Vec<Facet>,
    /// The border of each closed region.
    regions: Vec<Vec<Placed>>,
    /// For each half-edge the closed region it borders, and where in its list.
    region_of: Vec<Option<(u32, u32)>>,
}

/// The media before the front and behind the back.
#[derive(Clone, Copy, Debug)]
pub struct Outside {
    /// Before the front.
    pub front: MediumId,
    /// Behind the back.
    pub back: MediumId,
}

/// The ends of a half-edge: vertex and the period it is in.
#[derive(Clone, Copy)]
struct Ends {
    from: (usize, i32),
    to: (usize, i32),
}

/// The medium a half-edge looks at.
pub(crate) fn medium(facets: &[Facet], h: HalfEdge) -> MediumId {
    let facet = &facets[h.facet()];
    if h.is_left() { facet.left } else { facet.right }
}

impl Topology {
    /// An error where the media around a vertex do not agree.
    pub fn check(facets: &[Facet], period: f64) -> Result<(), PanelError> {
        let (vertices, ends) = find_vertices(facets, period);
        check_media(facets, &sort_fans(facets, vertices, &ends))
    }

    /// Finds mouths, vertices and regions of facets that pass the check.
    pub fn of(facets: &[Facet], period: f64, outside: Outside) -> Self {
        let mouths = mouths(facets, period, outside);
        let all: Vec<Facet> = facets.iter().chain(&mouths).copied().collect();
        let (vertices, ends) = find_vertices(&all, period);
        let fans = sort_fans(&all, vertices, &ends);
        let (regions, region_of) = regions(&all, period, &ends, &fans);
        Self { facets: facets.len(), mouths, regions, region_of }
    }

    /// The mouth that `h` is a hand of; `None` for a facet.
    #[inline]
    pub fn mouth(&self, h: HalfEdge) -> Option<&Facet> {
        self.mouths.get(h.facet().checked_sub(self.facets)?)
    }

    /// All mouths, each one line that light passes.
    pub fn mouths(&self) -> &[Facet] {
        &self.mouths
    }

    /// The border of the closed region that `h` looks into, and by how many periods `h` itself is raised in it;
    /// `None` where the region is open.
    #[inline]
    pub fn region(&self, h: HalfEdge) -> Option<(&[Placed], i32)> {
        let (region, place) = self.region_of[h.index()]?;
        let border = &self.regions[region as usize];
        Some((border, border[place as usize].1))
    }
}

/// The border of each closed region, and for each half-edge the region it borders and where in its list.
#[allow(clippy::type_complexity)]
fn regions(
    facets: &[Facet],
    period: f64,
    ends: &[Ends],
    fans: &[Vec<HalfEdge>],
) -> (Vec<Vec<Placed>>, Vec<Option<(u32, u32)>>) {
    let count = 2 * facets.len();
    let mut seen = vec![false; count];
    let (mut regions, mut islands) = (Vec::new(), Vec::new());
    for first in (0..count as u32).map(HalfEdge) {
        if seen[first.index()] {
            continue;
        }
        let (mut h, mut shift, mut doubled_area) = (first, 0, 0.0);
        let mut border = Vec::new();
        loop {
            seen[h.index()] = true;
            border.push((h, shift));
            doubled_area += swept_area(&facets[h.facet()], h, f64::from(shift) * period);
            let next = next_around(fans, ends, h);
            shift += ends[h.index()].to.1 - ends[next.index()].from.1;
            h = next;
            if h == first || seen[h.index()] {
                break;
            }
        }
        let closed = h == first && shift == 0;
        if closed && doubled_area > 0.0 {
            regions.push(border);
        } else if closed {
            islands.push(border);
        }
    }
    // a region with an island inside has borders that its walk does not meet: leave it open
    let may_hold = |region: &Vec<Placed>, island: &Vec<Placed>| {
        let (outer, inner) = (extent(facets, region, period), extent(facets, island, period));
        let is_alike = medium(facets, region[0].0) == medium(facets, island[0].0);
        let near = 1e-9 * period;
        let is_within = inner.0.0 >= outer.0.0 - near && inner.0.1 <= outer.0.1 + near;
        is_alike && is_within && inner.1.1 - inner.1.0 <= outer.1.1 - outer.1.0 + near
    };
    regions.retain(|region| !islands.iter().any(|island| may_hold(region, island)));
    let mut region_of = vec![None; count];
    for (i, border) in regions.iter().enumerate() {
        for (j, (h, _)) in border.iter().enumerate() {
            region_of[h.index()] = Some((i as u32, j as u32));
        }
    }
    (regions, region_of)
}

/// Extent of a border across the sheet and upwards.
fn extent(facets: &[Facet], border: &[Placed], period: f64) -> ((f64, f64), (f64, f64)) {
    let nothing = (f64::INFINITY, f64::NEG_INFINITY);
    border.iter().fold((nothing, nothing), |(z, y), &(h, shift)| {
        let facet = &facets[h.facet()];
        let (dy, (z_low, z_high), (y_low, y_high)) = (f64::from(shift) * period, facet.z_range(), facet.y_range());
        ((z.0.min(z_low), z.1.max(z_high)), (y.0.min(y_low + dy), y.1.max(y_high + dy)))
    })
}

/// Lines in the two outermost planes that join the facets which touch them, wherever no facet lies in the plane.
fn mouths(facets: &[Facet], period: f64, outside: Outside) -> Vec<Facet> {
    let near = 1e-9 * period;
    let mut mouths = Vec::new();
    let all_z = facets.iter().map(Facet::z_range).fold((f64::MAX, f64::MIN), |z, r| (z.0.min(r.0), z.1.max(r.1)));
    for (plane, outer) in [(all_z.0, outside.front), (all_z.1, outside.back)] {
        let on = |p: Vec2| (p.z - plane).abs() <= near;
        let mut touching: Vec<Vec2> = facets.iter().flat_map(|f| [f.start, f.end]).filter(|&p| on(p)).collect();
        for p in &mut touching {
            *p = p.raised(-(p.y / period).floor() * period);
        }
        touching.sort_by(|a, b| a.y.total_cmp(&b.y));
        touching.dedup_by(|a, b| (a.y - b.y).abs() <= near);
        if touching.len() > 1 && touching[0].y + period - touching[touching.len() - 1].y <= near {
            touching.pop();
        }
        let lies_here = |y: f64| {
            facets.iter().filter(|f| f.is_straight() && on(f.start) && on(f.end)).any(|f| {
                let (low, high) = f.y_range();
                (y - low).rem_euclid(period) <= high - low
            })
        };
        for (i, &from) in touching.iter().enumerate() {
            let to = touching.get(i + 1).copied().unwrap_or_else(|| touching[0].raised(period));
            if !lies_here(0.5 * (from.y + to.y)) {
                mouths.push(Facet::interface(from, to, outer, outer));
            }
        }
    }
    mouths
}

/// Twice the area that the line from the origin to a half-edge sweeps.
fn swept_area(facet: &Facet, h: HalfEdge, dy: f64) -> f64 {
    let (a, b) = (facet.start.raised(dy), facet.end.raised(dy));
    // the segment between chord and arc, of half-angle θ/2 = 2 atan(bulge)
    let segment = facet.circle().map_or(0.0, |(_, radius)| {
        let sweep = 4.0 * facet.bulge.atan();
        radius * radius * (sweep - sweep.sin())
    });
    h.sign() * (a.cross(b) + segment)
}

fn find_vertices(facets: &[Facet], period: f64) -> (usize, Vec<Ends>) {
    let near = 1e-9 * period;
    let mut vertices: Vec<Vec2> = Vec::new();
    let mut place = |p: Vec2| {
        for (i, v) in vertices.iter().enumerate() {
            let periods = ((p.y - v.y) / period).round();
            if (p.z - v.z).abs() <= near && (p.y - v.y - periods * period).abs() <= near {
                return (i, periods as i32);
            }
        }
        vertices.push(p);
        (vertices.len() - 1, 0)
    };
    let mut ends = Vec::with_capacity(2 * facets.len());
    for facet in facets {
        let (from, to) = (place(facet.start), place(facet.end));
        ends.push(Ends { from, to });
        ends.push(Ends { from: to, to: from });
    }
    (vertices.len(), ends)
}

/// The half-edges that leave each vertex, anticlockwise.
fn sort_fans(facets: &[Facet], vertices: usize, ends: &[Ends]) -> Vec<Vec<HalfEdge>> {
    let mut fans = vec![Vec::new(); vertices];
    for h in (0..ends.len() as u32).map(HalfEdge) {
        fans[ends[h.index()].from.0].push(h);
    }
    // by direction; facets that leave tangentially are told apart by which way they bend
    let leaving = |h: &HalfEdge| {
        let facet = &facets[h.facet()];
        let tangent = if h.is_left() { facet.tangent(0.0) } else { -facet.tangent(1.0) };
        let angle = tangent.y.atan2(tangent.z);
        ((angle * 1e9).round(), h.sign() * facet.curvature())
    };
    for fan in &mut fans {
        fan.sort_by(|a, b| {
            let (a, b) = (leaving(a), leaving(b));
            a.0.total_cmp(&b.0).then(a.1.total_cmp(&b.1))
        });
    }
    fans
}

/// In the sector between one leaving half-edge and the next, both must name the same medium.
fn check_media(facets: &[Facet], fans: &[Vec<HalfEdge>]) -> Result<(), PanelError> {
    for fan in fans {
        for (i, &h) in fan.iter().enumerate() {
            let next = fan[(i + 1) % fan.len()];
            let (one, other) = (medium(facets, h), medium(facets, next.other()));
            if one != other {
                let facet = &facets[h.facet()];
                let at = if h.is_left() { facet.start } else { facet.end };
                let (number, neighbour) = (h.facet() + 1, next.facet() + 1);
                return Err(PanelError::Media { facet: number, neighbour, one, other, z: at.z, y: at.y });
            }
        }
    }
    Ok(())
}

/// The half-edge that follows `h` around its region: clockwise next to the way back.
fn next_around(fans: &[Vec<HalfEdge>], ends: &[Ends], h: HalfEdge) -> HalfEdge {
    let fan = &fans[ends[h.index()].to.0];
    let back = fan.iter().position(|&k| k == h.other()).unwrap_or(0);
    fan[(back + fan.len() - 1) % fan.len()]
}
