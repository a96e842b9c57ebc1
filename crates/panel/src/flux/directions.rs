//! The directions of one solution: few, for light between flat facets, and each kept once.

use crate::{facet::MediumId, plane::Vec2};
use hemisphere::Vec3;

/// Number of a direction.
pub type DirectionId = u32;

/// Directions nearer than this are one.
const SAME: f64 = 1e-11;

#[derive(Clone, Copy, Debug)]
struct Entry {
    /// Unit direction within the section.
    d: Vec2,
    medium: MediumId,
    /// Index of the medium.
    n: f64,
    /// Index within the section: √(n² − k_x²) (theory/panels.md, eq. 4).
    kappa: f64,
}

/// All directions that light of one transverse component k_x has taken.
#[derive(Debug, Default)]
pub struct Directions {
    entries: Vec<Entry>,
    k_x: f64,
}

impl Directions {
    /// Forgets all; from now on k_x, the component along the cuts, is this.
    pub fn reset(&mut self, k_x: f64) {
        self.entries.clear();
        self.k_x = k_x;
    }

    /// The direction of light from outside, where n is that of the outer medium.
    pub fn enter(&mut self, incident: Vec3, medium: MediumId, n: f64) -> DirectionId {
        self.k_x = n * incident.x;
        let d = Vec2::new(incident.z, incident.y).normalized();
        self.find(Entry { d, medium, n, kappa: self.kappa(n) })
    }

    /// A direction in the same medium as `like`.
    pub fn add(&mut self, d: Vec2, like: DirectionId) -> DirectionId {
        let entry = self.entries[like as usize];
        self.find(Entry { d: d.normalized(), ..entry })
    }

    /// Snell within the section: κ_i (d·t) = κ_t (d'·t); `None` if nothing goes through.
    pub fn refract(
        &mut self,
        from: DirectionId,
        tangent: Vec2,
        normal: Vec2,
        medium: MediumId,
        n: f64,
    ) -> Option<DirectionId> {
        let Entry { d, kappa: kappa_i, .. } = self.entries[from as usize];
        let kappa = self.kappa(n);
        let along = kappa_i * d.dot(tangent) / kappa;
        let across2 = 1.0 - along * along;
        if !(across2 > 0.0) {
            return None;
        }
        let d = tangent * along - normal * across2.sqrt();
        Some(self.find(Entry { d, medium, n, kappa }))
    }

    /// Unit direction within the section.
    pub fn in_section(&self, id: DirectionId) -> Vec2 {
        self.entries[id as usize].d
    }

    /// Unit direction in space.
    pub fn vector(&self, id: DirectionId) -> Vec3 {
        let Entry { d, n, kappa, .. } = self.entries[id as usize];
        Vec3::new(self.k_x, kappa * d.y, kappa * d.z) / n
    }

    /// Length of the way in space for each unit within the section: n / κ.
    pub fn lengthening(&self, id: DirectionId) -> f64 {
        let Entry { n, kappa, .. } = self.entries[id as usize];
        n / kappa
    }

    fn kappa(&self, n: f64) -> f64 {
        (n * n - self.k_x * self.k_x).max(0.0).sqrt()
    }

    fn find(&mut self, wanted: Entry) -> DirectionId {
        let is_same = |e: &Entry| {
            e.medium == wanted.medium && (e.d.z - wanted.d.z).abs() < SAME && (e.d.y - wanted.d.y).abs() < SAME
        };
        self.entries.iter().position(is_same).unwrap_or_else(|| {
            self.entries.push(wanted);
            self.entries.len() - 1
        }) as DirectionId
    }
}
