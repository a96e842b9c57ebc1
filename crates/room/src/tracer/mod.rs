//! Where rays end, and who sees whom.

mod eight;
mod few;
mod many;
mod quad;

use crate::facet::Facet;
use few::Few;
use hemisphere::Vec3;
use many::Many;

/// The number of no facet: of a ray that leaves none.
pub const NO_FACET: u32 = u32::MAX;

/// A half-line, and the facet and side it leaves, which it cannot meet again.
#[derive(Clone, Copy, Debug)]
pub struct Ray {
    /// Where it begins.
    pub origin: Vec3,
    /// Where it goes, of unit length.
    pub direction: Vec3,
    /// The facet it leaves, or [`NO_FACET`].
    pub leaving: u32,
}

/// Where a ray ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hit {
    /// How far along the ray \[m\].
    pub distance: f64,
    /// On which facet.
    pub facet: u32,
}

/// A point as line-of-sight tests know it: where it is, on which side of each plane.
#[derive(Clone, Copy, Debug, Default)]
pub struct Place {
    /// Where.
    pub position: Vec3,
    /// Bit k: in front of the plane of facet k. Empty in scenes of many facets.
    sides: u64,
    /// Bit k: in the plane of facet k.
    within: u64,
}

/// The facets of a scene, ready to be met by rays.
pub struct Tracer {
    facets: Vec<Facet>,
    /// Shorter ways than this are rounding \[m\].
    least: f64,
    index: Index,
}

enum Index {
    /// Up to 64 facets: a bit for each.
    Few(Box<Few>),
    /// A hierarchy of boxes.
    Many(Box<Many>),
}

/// Ways shorter than this share of the scene's size are rounding.
const ROUNDING: f64 = 1e-10;

impl Tracer {
    /// Indexes the facets.
    pub fn new(facets: Vec<Facet>) -> Self {
        let corners: Vec<Vec3> = facets.iter().flat_map(Facet::corners).collect();
        let least = ROUNDING
            * crate::outline::extent(&corners).max(corners.iter().fold(0.0, |m, c| c.abs().max_element().max(m)));
        let index = if facets.len() <= few::MOST {
            Index::Few(Box::new(Few::new(&facets, least)))
        } else {
            Index::Many(Box::new(Many::new(&facets)))
        };
        Self { facets, least, index }
    }

    /// Its facets.
    pub fn facets(&self) -> &[Facet] {
        &self.facets
    }

    /// The first facet a ray meets.
    #[inline]
    pub fn closest(&self, ray: &Ray) -> Option<Hit> {
        match &self.index {
            Index::Few(few) => few.closest(&self.facets, ray, self.least),
            Index::Many(many) => many.closest(&self.facets, ray, self.least),
        }
    }

    /// Whether a ray meets this facet, whatever else it may meet.
    #[inline]
    pub fn meets(&self, ray: &Ray, facet: u32) -> bool {
        let shape = &self.facets[facet as usize];
        let t = -shape.height(ray.origin) / shape.normal.dot(ray.direction);
        facet != ray.leaving && t > self.least && t.is_finite() && shape.holds(ray.origin + t * ray.direction)
    }

    /// A point, made ready for many line-of-sight tests.
    #[inline]
    pub fn place(&self, position: Vec3) -> Place {
        match &self.index {
            Index::Few(few) => few.place(position, self.least),
            Index::Many(_) => Place { position, sides: 0, within: 0 },
        }
    }

    /// A point of a facet, made ready in the same way, mostly at no cost.
    #[inline]
    pub fn place_on(&self, facet: u32, position: Vec3) -> Place {
        match &self.index {
            Index::Few(few) => few.place_on(facet, position, self.least),
            Index::Many(_) => Place { position, sides: 0, within: 0 },
        }
    }

    /// Whether nothing stands between two points; facets that hold either point do not.
    #[inline]
    pub fn visible(&self, a: &Place, b: &Place) -> bool {
        match &self.index {
            Index::Few(_) => {
                // only a plane that the points lie on either side of can stand between them
                let between = (a.sides ^ b.sides) & !(a.within | b.within);
                between == 0 || few::clear(&self.facets, a.position, b.position, between)
            }
            Index::Many(many) => many.visible(&self.facets, a.position, b.position, self.least),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use hemisphere::Rng;

    fn soup(n: usize, scale: f64) -> Vec<Facet> {
        let mut rng = Rng::new(8, n as u64);
        let mut point = |size: f64| Vec3::from_array(std::array::from_fn(|_| size * (rng.uniform() - 0.5)));
        (0..n)
            .filter_map(|_| {
                let o = point(10.0);
                Facet::triangle([o, o + point(3.0), o + point(3.0)].map(|p| scale * p), 0)
            })
            .collect()
    }

    /// Both indices find what trying every facet finds, in closest hits and in lines of sight, in rooms and in tenths of millimetres.
    #[test]
    fn indices_agree_with_trying_every_facet() {
        for (n, scale) in [(40, 1.0), (500, 1.0), (500, 1e-5)] {
            let tracer = Tracer::new(soup(n, scale));
            let mut rng = Rng::new(9, 0);
            let mut hits = 0;
            for _ in 0..2000 {
                let mut point = || Vec3::from_array(std::array::from_fn(|_| scale * 12.0 * (rng.uniform() - 0.5)));
                let (a, b) = (point(), point());
                let (way, direction) = ((b - a).length(), (b - a).normalize());
                let every: Vec<(f64, u32)> = (0..n as u32)
                    .filter_map(|k| {
                        let f = &tracer.facets()[k as usize];
                        let t = -f.height(a) / f.normal.dot(direction);
                        (t > 0.0 && f.holds(a + t * direction)).then_some((t, k))
                    })
                    .collect();
                let want = every.iter().copied().min_by(|x, y| x.0.total_cmp(&y.0));
                let got = tracer.closest(&Ray { origin: a, direction, leaving: NO_FACET });
                assert_eq!(got.map(|h| h.facet), want.map(|w| w.1));
                if let (Some(got), Some(want)) = (got, want) {
                    hits += 1;
                    assert!((got.distance - want.0).abs() < 1e-9 * scale);
                }
                let clear = every.iter().all(|&(t, _)| t > way);
                assert_eq!(tracer.visible(&tracer.place(a), &tracer.place(b)), clear);
            }
            assert!(hits > 100);
        }
    }
}
