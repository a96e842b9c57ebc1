//! Whether the media of a scene fit together: between two neighbouring boundaries lies one medium.

use crate::RoomError;
use crate::scene::Scene;
use crate::surface::{Kind, Medium};
use crate::tracer::Ray;
use hemisphere::{Direction, Frame, Rng, Vec3};

/// Lines drawn from each side of a facet.
const PROBES: u64 = 4;

/// At most this many facets of a mesh are probed.
const PROBED_FACETS: usize = 2000;

/// Looks out from both sides of every boundary: what is met next must agree on the medium in between, and the open sky is air.
pub fn check(scene: &Scene) -> Result<(), RoomError> {
    for surface in &scene.surfaces {
        let Kind::Interface { front, back } = surface.kind else { continue };
        let step = surface.facets.len().div_ceil(PROBED_FACETS).max(1);
        for facet in surface.facets.clone().step_by(step) {
            for (side, medium) in [(1.0, front), (-1.0, back)] {
                probe(scene, &surface.name, facet, side, medium)?;
            }
        }
    }
    Ok(())
}

fn probe(scene: &Scene, name: &str, facet: u32, side: f64, medium: Medium) -> Result<(), RoomError> {
    let shape = scene.facet(facet);
    let frame = Frame::about(Direction::from_unit(side * shape.normal));
    let mut rng = Rng::new(u64::from(facet), side.to_bits());
    for _ in 0..PROBES {
        // well inside the facet and away from its plane
        let [u, v] = [0, 1].map(|_| 0.2 + 0.6 * rng.uniform());
        let local = Vec3::new(rng.uniform() - 0.5, rng.uniform() - 0.5, 0.3 + rng.uniform()).normalize();
        let ray = Ray { origin: shape.point([u, v]), direction: frame.outward(local), leaving: facet };
        let (other, beyond) = match scene.tracer.closest(&ray) {
            None => ("the open sky".to_owned(), Medium::AIR),
            Some(hit) => {
                let met = scene.surface_of(hit.facet);
                let from_front = scene.facet(hit.facet).normal.dot(ray.direction) < 0.0;
                match met.kind {
                    Kind::Interface { front, back } => (met.name.clone(), if from_front { front } else { back }),
                    // windows stand in air; an opaque surface may end any medium
                    Kind::Window { .. } => (met.name.clone(), Medium::AIR),
                    Kind::Opaque(_) => continue,
                }
            }
        };
        if beyond != medium {
            let (one, two) = (medium.to_string(), beyond.to_string());
            return Err(RoomError::MediaDoNotNest { name: name.to_owned(), other, one, two });
        }
    }
    Ok(())
}
