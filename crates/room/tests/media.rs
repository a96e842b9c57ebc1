//! Bodies drawn face by face between media, against closed forms.

mod rooms;

use hemisphere::Vec3;
use optics::formulas::{Polarisation, slab};
use room::{Material, Medium, RoomError, SceneBuilder, Settings, daylight_coefficients};
use rooms::{assert_estimate, tregenza};
use std::f64::consts::{FRAC_PI_2, PI};

/// The eight corners and twelve triangles of a box, outward normals.
fn block(low: Vec3, high: Vec3) -> (Vec<Vec3>, Vec<[i64; 3]>) {
    let corners = (0..8)
        .map(|i| Vec3::from_array(std::array::from_fn(|k| if (i >> k) & 1 == 1 { high[k] } else { low[k] })))
        .collect();
    let faces = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    (corners, faces.iter().flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]]).collect())
}

/// Under an even sky a sheet overhead lets through the hemispherical mean of the slab's transmittance, unpolarised at every
/// surface, with its absorption, however often the light went to and fro in it.
#[test]
fn drawn_sheet_is_the_slab_formula() {
    let (n, absorption_per_m, thickness) = (1.5, 20.0, 0.01);
    let (vertices, triangles) = block(Vec3::new(-5000.0, -5000.0, 1.0), Vec3::new(5000.0, 5000.0, 1.0 + thickness));
    let mut b = SceneBuilder::default();
    b.interface("sheet", &vertices, &triangles, Medium::AIR, Medium { n, absorption_per_m }).expect("sound");
    let scene = b.build().expect("nested");
    let basis = tregenza();
    let weights = Some([vec![1.0; basis.ground()], vec![0.0]].concat());
    let settings = Settings { weights, nodes: 1, window_samples: 8192, ..Settings::default() };
    let found =
        daylight_coefficients(&scene, &[Vec3::ZERO], &[Vec3::Z], &basis, &settings, |_| true).expect("sound input");
    // midpoint rule over θ of 2 sin θ cos θ T(θ)
    let steps = 20_000;
    let expected: f64 = (0..steps)
        .map(|i| {
            let theta = (f64::from(i) + 0.5) / f64::from(steps) * FRAC_PI_2;
            let shares = slab(theta.cos(), n, absorption_per_m * thickness, Polarisation::Averaged);
            2.0 * theta.sin() * theta.cos() * shares.transmittance * FRAC_PI_2 / f64::from(steps)
        })
        .sum();
    let (value, error) = (found.weighted.value[0] / PI, found.weighted.standard_error[0] / PI);
    assert_estimate("sheet", value, error, expected, 0.005 * expected);
    // parallel faces reflect nothing totally but what came in by the far-off edges
    let redirected: f64 = found.redirected.value.iter().sum();
    assert!(redirected < 1e-3 * value, "{redirected}");
}

/// A light guide carries the sky round no corner but to its end: total reflection at its sides keeps all but the Fresnel losses of its
/// faces, and counts as redirected.
#[test]
fn light_guide_keeps_what_enters_its_face() {
    let n = 1.5;
    // every ray that enters a face of n > √2 is totally reflected at the sides
    let (vertices, triangles) = block(Vec3::new(-0.1, -0.1, 0.0), Vec3::new(0.1, 0.1, 20.0));
    let mut b = SceneBuilder::default();
    b.interface("guide", &vertices, &triangles, Medium::AIR, Medium { n, absorption_per_m: 0.0 }).expect("sound");
    let scene = b.build().expect("nested");
    let basis = tregenza();
    let weights = Some([vec![1.0; basis.ground()], vec![0.0]].concat());
    let settings = Settings { weights, nodes: 1, window_samples: 8192, ..Settings::default() };
    // close under its lower face a sensor sees nothing else
    let found = daylight_coefficients(&scene, &[Vec3::new(0.0, 0.0, -1e-6)], &[Vec3::Z], &basis, &settings, |_| true)
        .expect("sound input");
    let steps = 20_000;
    let expected: f64 = (0..steps)
        .map(|i| {
            let theta = (f64::from(i) + 0.5) / f64::from(steps) * FRAC_PI_2;
            // both faces and all reflections between them, as in a pane
            let shares = slab(theta.cos(), n, 0.0, Polarisation::Averaged);
            2.0 * theta.sin() * theta.cos() * shares.transmittance * FRAC_PI_2 / f64::from(steps)
        })
        .sum();
    let (value, error) = (found.weighted.value[0] / PI, found.weighted.standard_error[0] / PI);
    assert_estimate("guide", value, error, expected, 0.006 * expected);
    let redirected: f64 = found.redirected.value[..basis.ground()].iter().sum::<f64>() / PI;
    // only rays within 0.1/20 of the axis reach the top without touching a side
    assert!(redirected > 0.98 * value, "{redirected} of {value}");
}

/// A white furnace stays as bright as its surroundings with a half mirror and a block of clear glass in it: nothing is gained or lost at
/// mirrors and boundaries, by shared points or by a sensor's own directions.
#[test]
fn furnace_with_mirror_and_glass_is_as_bright() {
    let room = rooms::Shoebox { reflectances: [1.0; 3], ..rooms::Shoebox::reference() };
    let pane = optics::ClearGlazing::slab(1.5, 4.0, 0.0).expect("possible");
    let mut b = room.builder(std::sync::Arc::new(pane));
    let screen = [(1., 3., 0.5), (3., 3., 0.5), (3., 3.5, 2.5), (1., 3.5, 2.5)].map(|(x, y, z)| Vec3::new(x, y, z));
    b.polygon("half mirror", &screen, &[], Material { diffuse: 0.5, specular: 0.5 }).expect("sound");
    let (vertices, triangles) = block(Vec3::new(1.2, 1.5, 0.9), Vec3::new(2.4, 2.0, 1.4));
    let glass = Medium { n: 1.5, absorption_per_m: 0.0 };
    b.interface("block", &vertices, &triangles, Medium::AIR, glass).expect("sound");
    let scene = b.build().expect("nested");
    let points = [Vec3::new(2.0, 1.75, 0.8), Vec3::new(2.0, 2.8, 1.2), Vec3::new(1.0, 6.0, 0.8)];
    let normals = [Vec3::Z, Vec3::Y, Vec3::Z];
    let basis = tregenza();
    let settings = Settings { weights: Some(vec![1.0; basis.patches()]), rounds: 32, ..Settings::default() };
    let found = daylight_coefficients(&scene, &points, &normals, &basis, &settings, |_| true).expect("sound");
    for i in 0..points.len() {
        let (value, error) = (found.weighted.value[i], found.weighted.standard_error[i]);
        assert_estimate("furnace", value, error, PI, 0.03 * PI);
    }
}

/// Light that can never leave ends the work all the same: in a closed white room, and totally reflected in a block of glass.
#[test]
fn trapped_paths_come_to_an_end() {
    let mut closed = SceneBuilder::default();
    let (vertices, triangles) = block(Vec3::ZERO, Vec3::ONE);
    closed.mesh("white box", &vertices, &triangles, Material::diffuse(1.0)).expect("sound");
    let mut solid = SceneBuilder::default();
    solid
        .interface("glass", &vertices, &triangles, Medium::AIR, Medium { n: 1.8, absorption_per_m: 0.0 })
        .expect("sound");
    let settings = Settings { rounds: 2, ..Settings::default() };
    let found = [closed, solid].map(|b| {
        let scene = b.build().expect("sound");
        let middle = [Vec3::splat(0.5)];
        daylight_coefficients(&scene, &middle, &[Vec3::Z], &tregenza(), &settings, |_| true)
            .expect("sound")
            .weighted
            .value[0]
    });
    assert!(found[0] == 0.0 && found[1] > 0.1, "{found:?}");
}

/// Glass in water in air nests; a body whose neighbour says otherwise, or that is open, does not.
#[test]
fn media_must_nest() {
    let glass = Medium { n: 1.5, absorption_per_m: 0.0 };
    let water = Medium { n: 1.33, absorption_per_m: 0.1 };
    let (outer, triangles) = block(Vec3::ZERO, Vec3::ONE);
    let (inner, _) = block(Vec3::splat(0.3), Vec3::splat(0.7));
    let nested = |inner_front: Medium| {
        let mut b = SceneBuilder::default();
        b.interface("tank", &outer, &triangles, Medium::AIR, water).expect("sound");
        b.interface("glass", &inner, &triangles, inner_front, glass).expect("sound");
        b.build().map(|_| ())
    };
    assert!(nested(water).is_ok());
    assert!(matches!(nested(Medium::AIR), Err(RoomError::MediaDoNotNest { .. })));
    let mut open = SceneBuilder::default();
    open.interface("open", &outer, &triangles[..10], Medium::AIR, water).expect("sound");
    assert!(matches!(open.build().map(|_| ()), Err(RoomError::MediaDoNotNest { ref name, .. }) if name == "open"));
    let mut wrong = SceneBuilder::default();
    let thin = Medium { n: 0.9, absorption_per_m: 0.0 };
    assert!(matches!(
        wrong.interface("thin", &outer, &triangles, Medium::AIR, thin),
        Err(RoomError::NotAMedium { .. })
    ));
    wrong.polygon("lid", &outer[..3], &[], Material::diffuse(0.1)).expect("sound");
}
