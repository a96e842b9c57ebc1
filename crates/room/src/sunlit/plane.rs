//! A plane that a beam leaves, and the flat pieces of a scene as it sees them along a direction: polygons of its own
//! (P. S. Heckbert, P. Hanrahan, *Beam tracing polygonal objects*, SIGGRAPH 1984).

use super::convex::{NEAR, Polygon, anticlockwise, area, bounds, cut, shared, without};
use crate::facet::Facet;
use crate::scene::Scene;
use glam::DVec2;
use hemisphere::Vec3;

/// What lies closer to a plane than this lies in it \[m\].
const IN_PLANE: f64 = 1e-7;

/// Of two surfaces this close the first in order is met \[m\].
const SAME: f64 = 1e-7;

/// Outlines of less area are seen edge-on \[m²\].
const LEAST_AREA: f64 = 1e-12;

/// A plane with two axes in it and its normal.
#[derive(Clone, Copy)]
pub struct Plane {
    origin: Vec3,
    x: Vec3,
    y: Vec3,
    normal: Vec3,
}

impl Plane {
    /// Through a polygon, its first axis along the longest edge.
    pub fn of(corners: &[Vec3], normal: Vec3) -> Self {
        let steps = (0..corners.len()).map(|k| corners[(k + 1) % corners.len()] - corners[k]);
        let longest =
            steps.fold(Vec3::ZERO, |best, s| if s.length_squared() > best.length_squared() { s } else { best });
        let x = (longest - longest.dot(normal) * normal).normalize();
        Self { origin: corners[0], x, y: normal.cross(x), normal }
    }

    /// A place in the plane.
    pub fn flat(&self, point: Vec3) -> DVec2 {
        let off = point - self.origin;
        DVec2::new(off.dot(self.x), off.dot(self.y))
    }

    /// A polygon that lies in the plane, anticlockwise in its axes.
    pub fn polygon(&self, corners: &[Vec3]) -> Polygon {
        anticlockwise(corners.iter().map(|&corner| self.flat(corner)).collect())
    }

    /// A place of the plane in space.
    pub fn space(&self, at: DVec2) -> Vec3 {
        self.origin + at.x * self.x + at.y * self.y
    }
}

/// A convex flat piece of a surface.
pub struct Piece {
    /// Which facet it is, or is part of.
    pub facet: u32,
    corners: Vec<Vec3>,
}

/// Convex flat pieces of all surfaces, and how far a ray starts off what it leaves \[m\].
pub struct Pieces {
    all: Vec<Piece>,
    pub step: f64,
}

impl Pieces {
    /// Facets that are convex as they stand, the triangles of the others.
    pub fn of(facets: &[Facet]) -> Self {
        let all: Vec<Piece> = (0_u32..)
            .zip(facets)
            .flat_map(|(facet, shape)| shape.convex_pieces().into_iter().map(move |corners| Piece { facet, corners }))
            .collect();
        let extent = all.iter().flat_map(|piece| &piece.corners).map(|c| c.abs().max_element()).fold(0.0, f64::max);
        Self { all, step: 1e-7 * (1.0 + extent) }
    }

    /// Corners of the pieces of a facet.
    pub fn of_facet(&self, facet: u32) -> impl Iterator<Item = &[Vec3]> {
        self.all.iter().filter(move |piece| piece.facet == facet).map(|piece| &piece.corners[..])
    }

    /// Those of which the facet is such, with their facets.
    pub fn having(&self, such: impl Fn(u32) -> bool) -> impl Iterator<Item = (u32, &[Vec3])> {
        self.all.iter().filter(move |piece| such(piece.facet)).map(|piece| (piece.facet, &piece.corners[..]))
    }
}

/// How far off a facet's plane is along a direction from each place of another plane: a + b · place.
#[derive(Clone, Copy)]
pub struct Distance {
    a: f64,
    b: DVec2,
}

impl Distance {
    pub fn of(facet: &Facet, plane: &Plane, direction: Vec3) -> Self {
        let steep = facet.normal.dot(direction);
        let b = -DVec2::new(facet.normal.dot(plane.x), facet.normal.dot(plane.y)) / steep;
        Self { a: -facet.height(plane.origin) / steep, b }
    }

    pub fn at(self, place: DVec2) -> f64 {
        self.a + self.b.dot(place)
    }
}

/// A piece as a plane sees it along a direction: its outline there, and how far off it is.
pub struct Shade {
    pub outline: Polygon,
    pub distance: Distance,
    pub facet: u32,
}

impl Shade {
    /// Corners of a polygon of the plane carried along a direction onto the piece.
    pub fn landed(&self, plane: &Plane, direction: Vec3, polygon: &[DVec2]) -> Vec<Vec3> {
        polygon.iter().map(|&at| plane.space(at) + self.distance.at(at) * direction).collect()
    }
}

/// Pieces that light from a plane along a direction may meet, where it comes from the box about some polygons; `None` if there are
/// more than `most`.
pub fn shades_of(scene: &Scene, plane: &Plane, direction: Vec3, within: &[Polygon], most: usize) -> Option<Vec<Shade>> {
    let steep = direction.dot(plane.normal);
    let [low, high] = bounds(&within.concat());
    let frame = [low, DVec2::new(high.x, low.y), high, DVec2::new(low.x, high.y)];
    // places in the plane, and how far off
    let mut seen: Vec<(u32, Vec<Vec3>)> = Vec::new();
    for Piece { facet, corners } in &scene.pieces().all {
        let reach = |corner: Vec3| (corner - plane.origin).dot(plane.normal) / steep;
        let farthest = corners.iter().map(|&corner| reach(corner)).fold(f64::NEG_INFINITY, f64::max);
        if farthest * steep.abs() <= IN_PLANE {
            continue;
        }
        let spots: Vec<Vec3> = corners
            .iter()
            .map(|&corner| {
                let off = reach(corner);
                plane.flat(corner - off * direction).extend(off)
            })
            .collect();
        // those that reach through the plane are cut before their box is known
        let through = spots.iter().any(|spot| spot.z * steep.abs() < -IN_PLANE);
        let [least, greatest] = bounds(&spots.iter().map(|spot| spot.truncate()).collect::<Vec<_>>());
        if through || (greatest.cmpgt(low).all() && least.cmplt(high).all()) {
            seen.push((*facet, if through { cut(&spots, |spot| spot.z * steep.abs()) } else { spots }));
        }
        if seen.len() > 4 * most {
            return None;
        }
    }
    let mut made = Vec::new();
    for (facet, spots) in seen {
        let outline = shared(&anticlockwise(spots.iter().map(|spot| spot.truncate()).collect()), &frame);
        if outline.is_empty() || area(&outline) < LEAST_AREA {
            continue;
        }
        made.push(Shade { outline, distance: Distance::of(scene.facet(facet), plane, direction), facet });
    }
    (made.len() <= most).then_some(made)
}

/// What of each shade is met first.
pub fn visible(shades: Vec<Shade>) -> Vec<(Shade, Vec<Polygon>)> {
    let met = |index: usize| {
        let mine = &shades[index];
        let mut pieces = vec![mine.outline.clone()];
        for (other, hiding) in shades.iter().enumerate().filter(|(other, _)| *other != index) {
            // before this one, or as far and first in order
            let near = if other < index { SAME } else { -SAME };
            let cover = cut(&hiding.outline, |at| mine.distance.at(at) - hiding.distance.at(at) + near);
            if !cover.is_empty() {
                pieces = without(pieces, &cover);
            }
            if pieces.is_empty() {
                break;
            }
        }
        pieces
    };
    let found: Vec<Vec<Polygon>> = (0..shades.len()).map(met).collect();
    shades.into_iter().zip(found).filter(|(_, pieces)| !pieces.is_empty()).collect()
}

/// Pieces less all shades: what sees the sky.
pub fn unhidden<'a>(mut pieces: Vec<Polygon>, shades: impl IntoIterator<Item = &'a Shade>) -> Vec<Polygon> {
    for shade in shades {
        pieces = without(pieces, &shade.outline);
        if pieces.is_empty() {
            break;
        }
    }
    pieces
}

/// Summed area of pieces, none smaller than a corner's rounding.
pub fn area_of(pieces: &[Polygon]) -> f64 {
    pieces.iter().map(|piece| area(piece)).filter(|one| *one > NEAR * NEAR).sum()
}
