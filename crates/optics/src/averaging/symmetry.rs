//! What an element's own symmetry saves: columns that are images of others.

use super::{Ports, column::Column};
use crate::{Glazing, Lobes};
use hemisphere::{Direction, Vec3};

/// Greatest difference of powers, and of directions, between what are taken for images.
const POWER: f64 = 1e-5;
const DIRECTION: f64 = 1e-8;

/// Directions in general position on the front; their images on the back are tried as well.
const PROBES: [[f64; 2]; 4] = [[0.137, 0.211], [-0.302, 0.518], [0.481, -0.634], [-0.688, -0.293]];

/// The mirror images, as signs of x, y and z, that change nothing about an element: judged by its lobes for a few directions in
/// general position. The first is that which mirrors nothing.
pub(super) fn symmetries(glazing: &dyn Glazing) -> Vec<Vec3> {
    let mut signs = vec![Vec3::ONE];
    for axis in 0..3 {
        let mut mirror = Vec3::ONE;
        mirror[axis] = -1.0;
        if keeps(glazing, mirror) {
            let images: Vec<Vec3> = signs.iter().map(|s| *s * mirror).collect();
            signs.extend(images);
        }
    }
    signs
}

fn keeps(glazing: &dyn Glazing, mirror: Vec3) -> bool {
    let (mut plain, mut image) = (Lobes::default(), Lobes::default());
    PROBES.iter().flat_map(|&[x, y]| [1.0, -1.0].map(|side| (x, y, side))).all(|(x, y, side)| {
        let z = side * f64::sqrt(1.0 - x * x - y * y);
        let Some(incident) = Direction::of(Vec3::new(x, y, z)) else { return false };
        glazing.lobes(incident, &mut plain);
        glazing.lobes(Direction::from_unit(incident.vector() * mirror), &mut image);
        (plain.absorbed - image.absorbed).abs() < POWER
            && plain.beams.iter().filter(|beam| beam.power > POWER).all(|beam| {
                let want = beam.direction.vector() * mirror;
                let found = image.beams.iter().find(|b| (b.direction.vector() - want).length() < DIRECTION);
                found.is_some_and(|b| (b.power - beam.power).abs() < POWER)
            })
    })
}

impl Ports {
    /// The port that the light of a port would arrive through if all were mirrored so.
    pub(super) fn mirrored(&self, port: usize, signs: Vec3) -> usize {
        let (side, mut cell) = self.parts(port);
        if signs.x < 0.0 {
            cell = self.cells.mirrored_in_x(cell);
        }
        if signs.y < 0.0 {
            // (x, −y) is (−x, y) turned
            cell = self.cells.turned(self.cells.mirrored_in_x(cell));
        }
        if side * signs.z > 0.0 { cell } else { cell + self.cells.count() }
    }
}

impl Column {
    /// The column of the mirrored port.
    pub(super) fn mirrored(&self, ports: &Ports, signs: Vec3) -> Self {
        let image = |&(port, share): &(u32, f64)| (ports.mirrored(port as usize, signs) as u32, share);
        let mut sent: Vec<_> = self.sent.iter().map(image).collect();
        sent.sort_unstable_by_key(|&(port, _)| port);
        Self { sent, ..self.clone() }
    }
}
