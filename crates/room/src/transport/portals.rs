//! Points on the windows, drawn to look out through them instead of searching the room for the way out.

use crate::scene::Scene;
use crate::surface::Kind;
use hemisphere::{Direction, Vec3};

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
    /// Whether it turns no light.
    straight: bool,
    /// Whether it spreads light.
    spreads: bool,
}

/// A window as seen from a point in the room.
pub struct Seen {
    /// The direction of its middle, about.
    pub axis: Vec3,
    /// The half-angle of a cone about this that holds it.
    pub half_angle: f64,
    /// Its solid angle \[sr\].
    pub solid_angle: f64,
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
            let straight =
                matches!(&s.kind, Kind::Window { glazing, .. } if glazing.straight(Direction::from_unit(Vec3::Z)).is_some());
            let spreads = matches!(&s.kind, Kind::Window { glazing, .. } if glazing.spreads());
            Portal { surface: surface as u32, facet: s.facets.start, up_to_here, density: 1.0 / area, straight, spreads }
        });
        Self { windows: windows.collect() }
    }

    /// Surface and facet of each window that turns no light.
    pub fn straight(&self) -> impl Iterator<Item = (u32, u32)> + '_ {
        self.windows.iter().filter(|w| w.straight).map(|w| (w.surface, w.facet))
    }

    /// Whether any window spreads light.
    pub fn spreads(&self) -> bool {
        self.windows.iter().any(|w| w.spreads)
    }

    /// Whether no window turns light.
    pub fn all_straight(&self) -> bool {
        self.windows.iter().all(|w| w.straight)
    }

    /// A window as seen from a point on its room side; `None` from outside.
    pub fn seen(&self, scene: &Scene, facet: u32, from: Vec3) -> Option<Seen> {
        let shape = scene.facet(facet);
        if shape.height(from) <= 0.0 {
            return None;
        }
        let corners: Vec<Vec3> = shape.corners().into_iter().map(|c| (c - from).normalize()).collect();
        let axis = corners.iter().copied().sum::<Vec3>().normalize();
        let half_angle = corners.iter().map(|c| c.dot(axis).clamp(-1.0, 1.0).acos()).fold(0.0, f64::max);
        let solid_angle = shape.triangles().into_iter().map(|t| solid_angle(t.map(|c| c - from))).sum();
        Some(Seen { axis, half_angle, solid_angle })
    }

    /// Draws a point; `None` without windows.
    #[inline]
    pub fn draw(&self, scene: &Scene, u: impl Fn(usize) -> f64) -> Option<Drawn> {
        let last = self.windows.len().checked_sub(1)?;
        let i = if last == 0 {
            0
        } else {
            let pick = u(2);
            self.windows.iter().position(|w| pick < w.up_to_here).unwrap_or(last)
        };
        let Portal { surface, facet, .. } = self.windows[i];
        Some(Drawn { surface, facet, point: scene.facet(facet).point([u(0), u(1)]) })
    }

    /// The density with which a point of a window is drawn from `seen_from` \[1/m²\]: none from outside.
    #[inline]
    pub fn density(&self, scene: &Scene, facet: u32, seen_from: Vec3) -> f64 {
        let on_room_side = scene.facet(facet).height(seen_from) > 0.0;
        if on_room_side { self.windows.first().map_or(0.0, |w| w.density) } else { 0.0 }
    }
}

/// Solid angle of a triangle seen from the origin (A. Van Oosterom, J. Strackee, IEEE Trans. Biomed. Eng. 30(2), 1983).
fn solid_angle([a, b, c]: [Vec3; 3]) -> f64 {
    let (la, lb, lc) = (a.length(), b.length(), c.length());
    let volume = a.dot(b.cross(c)).abs();
    2.0 * volume.atan2(la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// An octant of the sphere is seen through the triangle of the axes; near a triangle it fills a half-space.
    #[test]
    fn solid_angles_of_triangles() {
        use std::f64::consts::{FRAC_PI_2, TAU};
        assert!((solid_angle([Vec3::X, Vec3::Y, Vec3::Z]) - FRAC_PI_2).abs() < 1e-12);
        let near = [Vec3::new(1e3, 0.0, 1e-4), Vec3::new(-1e3, 1e3, 1e-4), Vec3::new(-1e3, -1e3, 1e-4)];
        assert!((solid_angle(near) - TAU).abs() < 1e-5);
    }
}
