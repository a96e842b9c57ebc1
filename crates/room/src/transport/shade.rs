//! Whether opaque surfaces keep all of a facet from the sun: what is left of it when their shadows are cut away, one after another.

use crate::facet::Facet;
use crate::scene::Scene;
use crate::surface::Kind;
use hemisphere::{Direction, Vec3};

/// The largest pieces of what lets no light straight through.
pub struct Screens {
    pieces: Vec<Screen>,
}

struct Screen {
    facet: u32,
    corners: [Vec3; 3],
    centre: Vec3,
    radius: f64,
}

/// More screens than this are seldom needed to hide anything.
const MOST_SCREENS: usize = 256;

/// Pieces that a facet may be left in before it is taken to be lit.
const MOST_LEFT: usize = 64;

/// Area that is rounding, in shares of the facet's.
const ROUNDING: f64 = 1e-9;

impl Screens {
    /// Those of a scene.
    pub fn of(scene: &Scene) -> Self {
        let stops = |facet: &Facet| match &scene.surfaces[facet.surface as usize].kind {
            Kind::Opaque(_) => true,
            Kind::Window { glazing, .. } => glazing.straight(Direction::from_unit(Vec3::Z)).is_none(),
            Kind::Interface { .. } => false,
        };
        let mut pieces: Vec<Screen> = (0_u32..)
            .zip(scene.facets())
            .filter(|(_, shape)| stops(shape))
            .flat_map(|(facet, shape)| shape.triangles().into_iter().map(move |corners| (facet, corners)))
            .map(|(facet, corners)| {
                let centre = corners.iter().copied().sum::<Vec3>() / 3.0;
                let radius = corners.iter().map(|c| (*c - centre).length()).fold(0.0, f64::max);
                Screen { facet, corners, centre, radius }
            })
            .collect();
        let area = |s: &Screen| area(&s.corners);
        pieces.sort_by(|a, b| area(b).total_cmp(&area(a)));
        pieces.truncate(MOST_SCREENS);
        Self { pieces }
    }

    /// Whether light from far away, `towards` it, reaches no point of a facet.
    pub fn hide(&self, scene: &Scene, facet: u32, towards: Vec3) -> bool {
        let shape = scene.facet(facet);
        let side = shape.normal.dot(towards).signum();
        let (normal, offset) = (side * shape.normal, side * shape.offset);
        let mut left: Vec<Vec<Vec3>> = shape.triangles().into_iter().map(|t| t.to_vec()).collect();
        let centre = left.iter().flatten().copied().sum::<Vec3>() / (3 * left.len()) as f64;
        let radius = left.iter().flatten().map(|c| (*c - centre).length()).fold(0.0, f64::max);
        for screen in self.pieces.iter().filter(|screen| screen.facet != facet) {
            let (way, reach) = (screen.centre - centre, radius + screen.radius);
            let along = way.dot(towards);
            if along < -reach || (way - along * towards).length() > reach {
                continue;
            }
            // only what lies on the light's side of the facet's plane throws a shadow on it
            let part = clip(&screen.corners, normal, offset);
            // one in the same plane throws none
            if part.iter().all(|&corner| normal.dot(corner) - offset <= ROUNDING * reach) {
                continue;
            }
            left = left.into_iter().flat_map(|piece| outside_shadow(piece, &part, towards)).collect();
            left.retain(|piece| area(piece) > ROUNDING * shape.area);
            if left.is_empty() {
                return true;
            }
            if left.len() > MOST_LEFT {
                return false;
            }
        }
        false
    }
}

/// What of a convex piece lies outside the shadow of another.
fn outside_shadow(mut piece: Vec<Vec3>, screen: &[Vec3], towards: Vec3) -> Vec<Vec<Vec3>> {
    let middle = screen.iter().copied().sum::<Vec3>() / screen.len() as f64;
    let whole = piece.clone();
    let mut outside = Vec::new();
    for (k, &corner) in screen.iter().enumerate() {
        // the plane through an edge along the light, its normal to the inside
        let across = (screen[(k + 1) % screen.len()] - corner).cross(towards);
        let inwards = across.dot(middle - corner);
        // seen edge-on it throws no shadow
        if inwards.abs() <= ROUNDING * across.length() * (middle - corner).length() {
            return vec![whole];
        }
        let across = across * inwards.signum();
        outside.push(clip(&piece, -across, -across.dot(corner)));
        piece = clip(&piece, across, across.dot(corner));
        if piece.len() < 3 {
            return vec![whole];
        }
    }
    outside.retain(|piece| piece.len() > 2);
    outside
}

/// The part of a convex polygon with normal · p ≥ offset (I. E. Sutherland, G. W. Hodgman, Commun. ACM 17(1), 1974).
fn clip(polygon: &[Vec3], normal: Vec3, offset: f64) -> Vec<Vec3> {
    let mut kept = Vec::with_capacity(polygon.len() + 1);
    for (k, &a) in polygon.iter().enumerate() {
        let b = polygon[(k + 1) % polygon.len()];
        let (here, there) = (normal.dot(a) - offset, normal.dot(b) - offset);
        if here >= 0.0 {
            kept.push(a);
        }
        if (here < 0.0) != (there < 0.0) {
            kept.push(a + here / (here - there) * (b - a));
        }
    }
    kept
}

fn area(polygon: &[Vec3]) -> f64 {
    let Some(&origin) = polygon.first() else { return 0.0 };
    let twice = polygon.windows(2).map(|pair| (pair[0] - origin).cross(pair[1] - origin)).sum::<Vec3>();
    0.5 * twice.length()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Material, SceneBuilder};

    /// Two screens side by side hide what neither hides alone; a gap, or light from elsewhere, shows it.
    #[test]
    fn screens_hide_together() {
        let rectangle = |x: [f64; 2], z: f64| {
            [(x[0], 0.0), (x[1], 0.0), (x[1], 1.0), (x[0], 1.0)].map(|(x, y)| Vec3::new(x, y, z)).to_vec()
        };
        let hidden = |parts: &[[f64; 2]], towards: Vec3| {
            let mut b = SceneBuilder::default();
            b.polygon("lit", &rectangle([0.0, 1.0], 0.0), &[], Material::diffuse(0.5)).expect("sound");
            for (k, &part) in parts.iter().enumerate() {
                b.polygon(&format!("screen {k}"), &rectangle(part, 1.0), &[], Material::diffuse(0.5)).expect("sound");
            }
            let scene = b.build().expect("sound");
            Screens::of(&scene).hide(&scene, 0, towards.normalize())
        };
        let straight = Vec3::Z;
        assert!(hidden(&[[-0.1, 0.6], [0.6, 1.1]], straight) && hidden(&[[0.0, 1.0]], straight));
        assert!(!hidden(&[[-0.1, 0.6], [0.7, 1.1]], straight) && !hidden(&[[-0.1, 0.6]], straight));
        // light from the side passes beside them, and from below they do not stand in its way
        assert!(!hidden(&[[-0.1, 1.1]], Vec3::new(0.5, 0.0, 1.0)) && !hidden(&[[-0.1, 1.1]], -Vec3::Z));
    }
}
