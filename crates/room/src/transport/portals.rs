//! Points on the windows, drawn to look out through them instead of searching the room for the way out.

use crate::scene::Scene;
use crate::surface::Kind;
use hemisphere::{SobolPoint, Vec3};

/// The windows of a scene.
pub struct Portals {
    windows: Vec<Portal>,
}

struct Portal {
    surface: u32,
    facet: u32,
    /// Probability of this and all windows before it.
    up_to_here: f64,
    /// Points per m², of one point drawn on all windows.
    density: f64,
}

/// A point drawn on a window.
pub struct Drawn {
    /// Which surface.
    pub surface: u32,
    /// Its facet.
    pub facet: u32,
    /// Where.
    pub point: Vec3,
}

impl Portals {
    /// All windows, each as likely as its share of their area.
    pub fn of(scene: &Scene) -> Self {
        let windows = scene.surfaces.iter().enumerate().filter(|(_, s)| matches!(s.kind, Kind::Window { .. }));
        let area: f64 = windows.clone().map(|(_, s)| s.area).sum();
        let mut up_to_here = 0.0;
        let windows = windows.map(|(surface, s)| {
            up_to_here += s.area / area;
            Portal { surface: surface as u32, facet: s.facets.start, up_to_here, density: 1.0 / area }
        });
        Self { windows: windows.collect() }
    }

    /// Whether there is no window.
    pub fn is_empty(&self) -> bool {
        self.windows.is_empty()
    }

    /// Surface and facet of each window.
    pub fn windows(&self) -> impl Iterator<Item = (u32, u32)> + '_ {
        self.windows.iter().map(|w| (w.surface, w.facet))
    }

    /// Draws a point; `None` without windows.
    #[inline]
    pub fn draw(&self, scene: &Scene, u: &SobolPoint) -> Option<Drawn> {
        let last = self.windows.len().checked_sub(1)?;
        let i = if last == 0 {
            0
        } else {
            let pick = u.coordinate(2);
            self.windows.iter().position(|w| pick < w.up_to_here).unwrap_or(last)
        };
        let Portal { surface, facet, .. } = self.windows[i];
        Some(Drawn { surface, facet, point: scene.facet(facet).point([u.coordinate(0), u.coordinate(1)]) })
    }

    /// The density with which a point of a window is drawn from `seen_from` \[1/m²\]: none from outside.
    #[inline]
    pub fn density(&self, scene: &Scene, facet: u32, seen_from: Vec3) -> f64 {
        let on_room_side = scene.facet(facet).height(seen_from) > 0.0;
        if on_room_side { self.windows.first().map_or(0.0, |w| w.density) } else { 0.0 }
    }
}
