//! The directions of one solution: few, for light between flat facets, and each kept once.

use crate::{differential::Differential, facet::MediumId, plane::Vec2};
use hemisphere::Vec3;
use optics::Slopes;

/// Number of a direction.
pub type DirectionId = u32;

/// Directions nearer than this are one.
const SAME: f64 = 1e-11;

/// Bins of the height of directions, in which they are looked for, and the end of each list.
const BINS: usize = 128;
const NONE: DirectionId = DirectionId::MAX;

#[derive(Clone, Copy, Debug)]
struct Entry {
    /// Unit direction within the section.
    d: Vec2,
    medium: MediumId,
    /// Index of the medium.
    n: f64,
    /// Index within the section: √(n² − k_x²) (theory/panels.md, eq. 4).
    kappa: f64,
    /// How it turns with the incident light.
    turning: Differential,
}

/// All directions that light of one transverse component k_x has taken.
#[derive(Debug, Default)]
pub struct Directions {
    entries: Vec<Entry>,
    /// The last entry of each bin of y, and before each entry the one before it in its bin.
    last: Vec<u32>,
    before: Vec<u32>,
    k_x: f64,
    tell_apart: bool,
}

impl Directions {
    /// Forgets all; from now on k_x, the component along the cuts, is this. Directions that are one but part as the incident
    /// light moves may be told apart.
    pub fn reset(&mut self, k_x: f64, tell_apart: bool) {
        self.entries.clear();
        self.before.clear();
        self.last.clear();
        self.last.resize(BINS, NONE);
        (self.k_x, self.tell_apart) = (k_x, tell_apart);
    }

    /// The direction of light from outside, where n is that of the outer medium.
    pub fn enter(&mut self, incident: Vec3, medium: MediumId, n: f64) -> DirectionId {
        self.k_x = n * incident.x;
        let d = Vec2::new(incident.z, incident.y).normalized();
        self.find(Entry { d, medium, n, kappa: self.kappa(n), turning: Differential::incident(incident, n) })
    }

    /// Mirrored by a facet of this normal.
    pub fn mirror(&mut self, from: DirectionId, normal: Vec2) -> DirectionId {
        let entry = self.entries[from as usize];
        let d = entry.d - normal * (2.0 * entry.d.dot(normal));
        self.find(Entry { d: d.normalized(), turning: entry.turning.mirrored(in_space(normal)), ..entry })
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
        let Entry { d, kappa: kappa_i, turning, .. } = self.entries[from as usize];
        let kappa = self.kappa(n);
        let along = kappa_i * d.dot(tangent) / kappa;
        let across2 = 1.0 - along * along;
        if !(across2 > 0.0) {
            return None;
        }
        let d = tangent * along - normal * across2.sqrt();
        let v = Vec3::new(self.k_x, kappa * d.y, kappa * d.z) / n;
        Some(self.find(Entry { d, medium, n, kappa, turning: turning.refracted(v, in_space(normal)) }))
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

    /// How it turns with the incident light.
    pub fn turning(&self, id: DirectionId) -> Differential {
        self.entries[id as usize].turning
    }

    /// Slopes of its (x, y) with those of the incident light.
    pub fn slopes(&self, id: DirectionId) -> Slopes {
        let Entry { n, turning, .. } = self.entries[id as usize];
        turning.slopes(n)
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
            e.medium == wanted.medium
                && (e.d.z - wanted.d.z).abs() < SAME
                && (e.d.y - wanted.d.y).abs() < SAME
                && (!self.tell_apart || e.turning.is_like(wanted.turning))
        };
        let bin = |y: f64| (((y + 1.0) * (0.5 * BINS as f64)) as usize).min(BINS - 1);
        for bin in bin(wanted.d.y - SAME)..=bin(wanted.d.y + SAME) {
            let mut id = self.last[bin];
            while id != NONE {
                if is_same(&self.entries[id as usize]) {
                    return id;
                }
                id = self.before[id as usize];
            }
        }
        let (id, bin) = (self.entries.len() as DirectionId, bin(wanted.d.y));
        self.before.push(std::mem::replace(&mut self.last[bin], id));
        self.entries.push(wanted);
        id
    }
}

fn in_space(normal: Vec2) -> Vec3 {
    Vec3::new(0.0, normal.y, normal.z)
}
