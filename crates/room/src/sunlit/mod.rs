//! The way of the sun through windows to where it lands, followed forwards to be drawn: beams as polygons, paths as rays
//! (theory/room.md, eqs. 12, 16 and 17).

mod beams;
mod cells;
pub mod convex;
mod lobed;
mod places;
pub mod plane;
mod walk;

pub use beams::{Patch, SunBeam, Sunlight};
pub use walk::{Event, PathVertex};

use crate::scene::Scene;
use crate::surface::Kind;
use crate::tracer::{Hit, NO_FACET, Ray};
use beams::Sunbeams;
use hemisphere::{Direction, Rng, Vec3};
use lobed::Lobed;
use optics::Scattered;
use plane::Pieces;
use walk::Walk;

/// Directions drawn to tell how much of what a window spreads goes into the room.
const DRAWS: u64 = 512;

/// How the sun's way is followed.
#[derive(Clone, Copy, Debug)]
pub struct WaySettings {
    /// About so many places of each window, from which paths are drawn.
    pub points: usize,
    /// Diffuse reflections that each path is drawn on for.
    pub bounces: u32,
    /// Share of the light on a window below which a beam or path is followed no further.
    pub least_power: f64,
    /// How far paths are drawn outside \[m\].
    pub beyond_m: f64,
    /// Facets in the way of a beam, beyond which it is looked at cell by cell.
    pub most_shades: usize,
}

/// The way of one sun.
pub struct SunWay {
    /// What it sees of each window, and the share of its light there that goes on into the room.
    pub windows: Vec<(Sunlight, f64)>,
    /// Each direction in which light leaves a window or a mirror.
    pub beams: Vec<SunBeam>,
    /// What they light.
    pub patches: Vec<Patch>,
    /// Places on paths.
    pub vertices: Vec<PathVertex>,
    /// Vertices of each path from its beginning to its end.
    pub paths: Vec<Vec<usize>>,
}

/// Follows the sun `towards` here through the windows of a scene.
pub fn sun_way(scene: &Scene, towards: Direction, settings: &WaySettings) -> SunWay {
    let WaySettings { points, bounces, least_power, beyond_m, most_shades } = *settings;
    let lobed = Lobed::of(scene);
    let sun = Sunbeams { scene, lobed: &lobed, towards: *towards, least_power, most_shades };
    let windows = scene.surfaces.iter().filter(|surface| matches!(surface.kind, Kind::Window { .. }));
    let seen: Vec<Sunlight> = windows.map(|window| sun.on_window(window.facets.start)).collect();
    let thrown = sun.thrown_outside();
    let (beams, patches) = sun.followed(&seen, &thrown);
    let mut walk = Walk::new(scene, &lobed, least_power, bounces, beyond_m);
    let mut starts = Vec::new();
    for one in seen.iter().filter(|one| !one.is_dark()) {
        let places = places::on_window(scene, one, points, *towards);
        let facet = scene.facet(one.facet);
        let rays = walk.sent_to(&places, *towards, Event::Glazing, facet.surface);
        starts.extend(walk.through(rays, one.facet).into_iter().filter(|ray| ray.direction.dot(facet.normal) > 0.0));
    }
    for beam in &thrown {
        let places = places::on_mirror(scene, beam, points);
        let mut rays = walk.sent_to(&places, *towards, Event::Mirror, scene.facet(beam.source).surface);
        for ray in &mut rays {
            (ray.direction, ray.power, ray.is_mirrored) = (beam.direction, beam.power, true);
        }
        starts.append(&mut rays);
    }
    walk.follow(starts);
    let entering = |one: &Sunlight| if one.cos > 0.0 { entering(&lobed, one.facet, *towards) } else { 0.0 };
    let shares: Vec<f64> = seen.iter().map(entering).collect();
    let paths = walk.chains();
    SunWay { windows: seen.into_iter().zip(shares).collect(), beams, patches, vertices: walk.vertices, paths }
}

/// The share of the sun's light on a window that goes on into the room.
fn entering(lobed: &Lobed<'_>, facet: u32, towards: Vec3) -> f64 {
    let (Some((glazing, frame)), Some(solved)) = (lobed.window(facet), lobed.solved(facet, -towards)) else {
        return 0.0;
    };
    let inwards = solved.beams.iter().filter(|lobe| lobe.direction.dot(frame.z) > 0.0);
    let beams: f64 = inwards.map(|lobe| lobe.power).sum();
    let Some(incident) = Direction::of(frame.inward(-towards)).filter(|_| solved.spread > 0.0) else { return beams };
    let drawn = (0..DRAWS).filter_map(|stream| {
        let mut rng = Rng::new(0, stream);
        match glazing.scatter(incident, std::array::from_fn(|_| rng.uniform())) {
            Scattered::Leaves { direction, .. } => Some(direction.z > 0.0),
            Scattered::Absorbed => None,
        }
    });
    let [leaves, enters] = drawn.fold([0.0; 2], |[all, room], enters| [all + 1.0, room + f64::from(u8::from(enters))]);
    if leaves > 0.0 { beams + solved.spread * enters / leaves } else { beams }
}

impl Scene {
    /// Convex flat pieces of its surfaces, made when they are first asked for.
    pub(crate) fn pieces(&self) -> &Pieces {
        self.pieces.get_or_init(|| Pieces::of(self.facets()))
    }

    /// What a ray meets first, off whatever it starts on.
    fn met(&self, origin: Vec3, direction: Vec3) -> Option<Hit> {
        let step = self.pieces().step;
        let hit = self.tracer.closest(&Ray { origin: origin + step * direction, direction, leaving: NO_FACET })?;
        Some(Hit { distance: hit.distance + step, ..hit })
    }
}
