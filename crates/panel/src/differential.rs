//! The differential of a ray: how its direction turns as the direction of the light that it came of turns
//! (H. Igehy, *Tracing Ray Differentials*, SIGGRAPH 1999), exact at every flat facet.

use hemisphere::Vec3;
use optics::Slopes;

/// Derivatives of n v with x and with y of the unit vector of the incident light, v being the direction and n the index.
#[derive(Clone, Copy, Debug)]
pub struct Differential([Vec3; 2]);

/// Differentials no farther apart than this, as a share of the larger and of 1, are one.
const SAME: f64 = 1e-7;

impl Differential {
    /// Of the incident light itself, in a medium of index `n`: its z follows x and y.
    pub fn incident(v: Vec3, n: f64) -> Self {
        Self([Vec3::new(1.0, 0.0, -v.x / v.z), Vec3::new(0.0, 1.0, -v.y / v.z)].map(|by| n * by))
    }

    /// After a mirror of this unit normal.
    #[must_use]
    pub fn mirrored(self, normal: Vec3) -> Self {
        Self(self.0.map(|by| by - 2.0 * by.dot(normal) * normal))
    }

    /// After a boundary of this unit normal, beyond which the light travels along `v`: Snell keeps n v along the boundary, and
    /// its length is n, so that it only turns (theory/panels.md, eq. 12).
    #[must_use]
    pub fn refracted(self, v: Vec3, normal: Vec3) -> Self {
        Self(self.0.map(|by| {
            let along = by - by.dot(normal) * normal;
            along - along.dot(v) / normal.dot(v) * normal
        }))
    }

    /// Slopes of (x, y) of the direction in a medium of index `n`.
    pub fn slopes(self, n: f64) -> Slopes {
        self.0.map(|by| [by.x / n, by.y / n])
    }

    /// Whether two turn alike.
    pub fn is_like(self, other: Self) -> bool {
        self.0.iter().zip(&other.0).all(|(a, b)| {
            let apart = (*a - *b).length_squared();
            apart <= SAME * SAME * a.length_squared().max(b.length_squared()).max(1.0)
        })
    }
}

/// Whether two beams move alike, as far as that is known of both.
pub fn move_alike(a: Option<Slopes>, b: Option<Slopes>) -> bool {
    let (Some(a), Some(b)) = (a, b) else { return true };
    let largest = a.iter().chain(&b).flatten().fold(1.0, |most: f64, x| most.max(x.abs()));
    a.iter().flatten().zip(b.iter().flatten()).all(|(x, y)| (x - y).abs() <= SAME * largest)
}
