//! Rooms that several tests share.

#![allow(dead_code)]

use hemisphere::{SkyBasis, Vec3};
use optics::{ClearGlazing, Glazing};
use room::{Material, Scene, SceneBuilder};
use std::sync::Arc;

/// A box room from the origin with its sizes along x, y, z, and one window in the wall y = 0, which looks south.
pub struct Shoebox {
    pub size: [f64; 3],
    /// Of floor, walls, ceiling.
    pub reflectances: [f64; 3],
    /// x and z of the window's lower left and upper right corner.
    pub window: [[f64; 2]; 2],
}

impl Shoebox {
    /// The room that rivals are timed in: 4 × 8 × 3 m, a window of 3.6 × 1.8 m, sill 0.9 m.
    pub fn reference() -> Self {
        Self { size: [4.0, 8.0, 3.0], reflectances: [0.2, 0.5, 0.8], window: [[0.2, 0.9], [3.8, 2.7]] }
    }

    pub fn builder(&self, glazing: Arc<dyn Glazing>) -> SceneBuilder {
        let [x, y, z] = self.size;
        let [floor, walls, ceiling] = self.reflectances.map(Material::diffuse);
        let corner = |a: f64, b: f64, c: f64| Vec3::new(a * x, b * y, c * z);
        let mut b = SceneBuilder::default();
        let mut face = |name: &str, corners: [(f64, f64, f64); 4], material| {
            let outline = corners.map(|(a, b, c)| corner(a, b, c));
            b.polygon(name, &outline, &[], material).expect("a sound wall");
        };
        face("floor", [(0., 0., 0.), (1., 0., 0.), (1., 1., 0.), (0., 1., 0.)], floor);
        face("ceiling", [(0., 0., 1.), (0., 1., 1.), (1., 1., 1.), (1., 0., 1.)], ceiling);
        face("south", [(0., 0., 0.), (0., 0., 1.), (1., 0., 1.), (1., 0., 0.)], walls);
        face("north", [(0., 1., 0.), (1., 1., 0.), (1., 1., 1.), (0., 1., 1.)], walls);
        face("west", [(0., 0., 0.), (0., 1., 0.), (0., 1., 1.), (0., 0., 1.)], walls);
        face("east", [(1., 0., 0.), (1., 0., 1.), (1., 1., 1.), (1., 1., 0.)], walls);
        let [[x0, z0], [x1, z1]] = self.window;
        // anticlockwise as seen from the room, which looks towards −y: x runs to the left
        let outline = [(x0, z0), (x0, z1), (x1, z1), (x1, z0)].map(|(x, z)| Vec3::new(x, 0.0, z));
        b.window("window", &outline, glazing, None, Some("south")).expect("a sound window");
        b
    }

    pub fn scene(&self, glazing: ClearGlazing) -> Scene {
        self.builder(Arc::new(glazing)).build().expect("a sound room")
    }

    /// Sensors facing up, `step` apart, half a step from the walls.
    pub fn work_plane(&self, height: f64, step: f64) -> (Vec<Vec3>, Vec<Vec3>) {
        let count = |length: f64| (length / step).round() as usize;
        let points: Vec<Vec3> = (0..count(self.size[1]))
            .flat_map(|j| (0..count(self.size[0])).map(move |i| (i as f64 + 0.5, j as f64 + 0.5)))
            .map(|(i, j)| Vec3::new(i * step, j * step, height))
            .collect();
        let normals = vec![Vec3::Z; points.len()];
        (points, normals)
    }
}

pub fn tregenza() -> SkyBasis {
    SkyBasis::named("tregenza145").expect("known")
}

/// Fails unless a Monte Carlo estimate agrees with a known answer within 4.5 of its standard errors, and could have disagreed.
pub fn assert_estimate(what: &str, value: f64, standard_error: f64, expected: f64, resolution: f64) {
    assert!(standard_error <= resolution, "{what}: too noisy to judge: {standard_error:.2e} > {resolution:.2e}");
    assert!(
        (value - expected).abs() <= 4.5 * standard_error + 1e-12,
        "{what}: {value} ± {standard_error:.2e}, expected {expected}"
    );
}
