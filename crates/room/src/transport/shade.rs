//! Whether opaque surfaces keep all of a facet from the sun: what is left of it when their shadows are cut away, one after another.

use crate::facet::Facet;
use crate::scene::Scene;
use crate::sunlit::convex::{self, NEAR, Polygon, anticlockwise, cut, without};
use crate::surface::Kind;
use glam::DVec2;
use hemisphere::{Direction, Frame, Vec3};

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
        let area = |s: &Screen| (s.corners[1] - s.corners[0]).cross(s.corners[2] - s.corners[0]).length();
        pieces.sort_by(|a, b| area(b).total_cmp(&area(a)));
        pieces.truncate(MOST_SCREENS);
        Self { pieces }
    }

    /// Whether light from far away, `towards` it, reaches no point of a facet.
    pub fn hide(&self, scene: &Scene, facet: u32, towards: Vec3) -> bool {
        let shape = scene.facet(facet);
        let side = shape.normal.dot(towards).signum();
        let corners = shape.corners();
        let centre = corners.iter().copied().sum::<Vec3>() / corners.len() as f64;
        let radius = corners.iter().map(|c| (*c - centre).length()).fold(0.0, f64::max);
        // as the light sees it, in shares of its size
        let frame = Frame::about(Direction::from_unit(towards));
        let seen = |points: &[Vec3]| -> Polygon {
            let flat =
                points.iter().map(|&p| DVec2::new((p - centre).dot(frame.x), (p - centre).dot(frame.y)) / radius);
            anticlockwise(flat.collect())
        };
        let mut left: Vec<Polygon> = shape.triangles().iter().map(|triangle| seen(triangle)).collect();
        let least = ROUNDING * left.iter().map(|piece| convex::area(piece)).sum::<f64>();
        for screen in self.pieces.iter().filter(|screen| screen.facet != facet) {
            let (way, reach) = (screen.centre - centre, radius + screen.radius);
            let along = way.dot(towards);
            if along < -reach || (way - along * towards).length() > reach {
                continue;
            }
            // only what lies on the light's side of the facet's plane throws a shadow on it
            let height = |corner: Vec3| side * shape.height(corner) / reach;
            let part = cut(&screen.corners, height);
            // one in the same plane throws none
            if part.iter().all(|&corner| height(corner) <= NEAR) {
                continue;
            }
            left = without(left, &seen(&part));
            left.retain(|piece| convex::area(piece) > least);
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
