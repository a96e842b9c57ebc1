//! What becomes of a path at a window.

use super::look_out::Sight;
use super::numbers::Event;
use super::path::{Came, Light, Path, State};
use super::spread::Looked;
use super::walk::Walker;
use crate::surface::Medium;
use crate::tracer::Ray;
use hemisphere::{Direction, Frame, Vec3};
use optics::{Glazing, Scattered};

/// Where a path meets a window.
pub struct Met {
    /// The window's facet.
    pub facet: u32,
    /// Where.
    pub point: Vec3,
    /// How far along the path's last ray.
    pub distance: f64,
}

impl Walker<'_> {
    /// Sends a path on through a window, or back; false if it ends there.
    pub fn meet_window<'b>(
        &'b self,
        state: &mut State<'b>,
        met: &Met,
        glazing: &dyn Glazing,
        frame: &Frame,
        event: &Event,
        path: &mut Path<'_>,
    ) -> bool {
        let (Ray { origin, direction, .. }, point) = (state.ray, met.point);
        let facet = self.scene.facet(met.facet);
        let cos_facet = facet.normal.dot(direction);
        let incident = Direction::from_unit(frame.inward(direction));
        let straight = glazing.straight(incident);
        // from the room, points on the window find it as well
        let share = match &state.came {
            Came::Scattered { cos, techniques } if incident.z < 0.0 => {
                let sight = Sight { facet: met.facet, from: origin, direction, distance: met.distance, cos: *cos };
                sight.share_of_directions(self, techniques, straight.is_some())
            }
            _ => 1.0,
        };
        let kept = match self.light {
            Light::Sky(_) => share,
            // of the suns, only what the window spreads
            Light::Suns(_) | Light::AnySun => {
                let State { bounces, redirected, .. } = *state;
                let looked = Looked { facet: met.facet, point, direction, bounces, redirected };
                self.glow(looked, state.beta * share, path);
                1.0
            }
        };
        let leaves = match straight {
            // a sensor's own few directions go both ways
            Some(straight) if state.came.is_sensor() => {
                state.beta *= kept;
                let beta = state.beta * straight.transmittance;
                let ray = Ray { origin: point, direction, leaving: met.facet };
                self.follow(
                    State { ray, beta, came: Came::Specular, medium: Medium::AIR, ..*state },
                    &mut path.branch(),
                );
                state.beta *= straight.reflectance;
                direction - 2.0 * cos_facet * facet.normal
            }
            _ => {
                let [u, v] = event.start();
                let u = [u, v, path.numbers.rng.uniform()];
                let Scattered::Leaves { direction: leaves, total_reflections } = glazing.scatter(incident, u) else {
                    return false;
                };
                // only a sensor's window points follow what turns back: more would multiply
                if leaves.z < 0.0 || state.came.is_sensor() {
                    state.beta *= kept;
                }
                state.redirected |= total_reflections > 0;
                frame.outward(*leaves)
            }
        };
        state.ray = Ray { origin: point, direction: leaves, leaving: met.facet };
        state.came = Came::Specular;
        true
    }
}
