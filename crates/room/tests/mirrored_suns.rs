//! The sun by way of mirrors and windows, against closed forms and rooms mirrored by hand.

mod rooms;

use hemisphere::{Direction, SkyBasis, Vec3, towards};
use optics::{ClearGlazing, Glazing, Lobe, Lobes, Scattered};
use room::{
    Material, RoomError, Scene, SceneBuilder, Settings, SunCoefficients, daylight_coefficients, sun_coefficients,
    unfollowed_mirrors,
};
use rooms::{Shoebox, assert_estimate};
use std::f64::consts::{FRAC_1_SQRT_2, PI};
use std::sync::Arc;

fn mirror(reflectance: f64) -> Material {
    Material { diffuse: 0.0, specular: reflectance }
}

fn sun(altitude_deg: f64, azimuth_deg: f64) -> Vec3 {
    towards(altitude_deg.to_radians(), azimuth_deg.to_radians())
}

fn black() -> Shoebox {
    Shoebox { reflectances: [0.0; 3], ..Shoebox::reference() }
}

fn pane(transmittance: f64) -> Arc<dyn Glazing> {
    Arc::new(ClearGlazing::constant(transmittance).expect("possible"))
}

fn rectangle(corner: [f64; 3], along: Vec3, up: Vec3) -> [Vec3; 4] {
    let corner = Vec3::from_array(corner);
    [corner, corner + along, corner + along + up, corner + up]
}

/// One round on sensors that a diffuse reflection cannot reach, or of which only the first parts are asked.
fn lit(scene: &Scene, points: &[Vec3], normal: Vec3, towards: Vec3) -> SunCoefficients {
    let settings = Settings { rounds: 2, nodes: 1, ..Settings::default() };
    sun_coefficients(scene, points, &vec![normal; points.len()], &[towards], 8, &settings, |_| true).expect("sound")
}

/// A mirror before an open window throws the sun on the ceiling: ρ sin α of its normal illuminance within the patch that geometry tells,
/// nothing outside, whether the mirror is a polygon or a mesh of many triangles.
#[test]
fn mirror_shelf_lights_the_patch_that_geometry_tells() {
    let (height, depth, rho) = (0.8, 0.6, 0.85);
    let shelf = rectangle([0.5, -depth, height], 3.0 * Vec3::X, depth * Vec3::Y);
    let (mut as_polygon, mut as_mesh) = (black().builder(pane(1.0)), black().builder(pane(1.0)));
    as_polygon.polygon("shelf", &shelf, &[], mirror(rho)).expect("sound");
    let at = |i: usize, j: usize| shelf[0] + i as f64 / 6.0 * 3.0 * Vec3::X + j as f64 / 2.0 * depth * Vec3::Y;
    let vertices: Vec<Vec3> = (0..7).flat_map(|i| (0..3).map(move |j| (i, j))).map(|(i, j)| at(i, j)).collect();
    let quads = (0..6_i64).flat_map(|i| (0..2_i64).map(move |j| 3 * i + j));
    let triangles: Vec<[i64; 3]> = quads.flat_map(|a| [[a, a + 3, a + 4], [a, a + 1, a + 4]]).collect();
    as_mesh.mesh("shelf", &vertices, &triangles, mirror(rho)).expect("sound");
    let points: Vec<Vec3> = (0..400)
        .map(|k| Vec3::new(0.1 + 0.2 * f64::from(k % 20), 0.5 + 0.15 * f64::from(k / 20), 3.0 - 1e-6))
        .collect();
    for scene in [as_polygon, as_mesh].map(|b| b.build().expect("sound")) {
        for towards in [sun(40.0, 180.0), sun(55.0, 160.0)] {
            let found = lit(&scene, &points, -Vec3::Z, towards);
            let (mut inside, mut outside) = (0, 0);
            for (k, p) in points.iter().enumerate() {
                // back along the mirrored sun: through the window, and on to the shelf
                let back = |distance: f64| *p + distance * Vec3::new(towards.x, towards.y, -towards.z);
                let (window, met) = (back(p.y / -towards.y), back((p.z - height) / towards.z));
                // how far inside the rim of both, in units of the sun's half-width at that distance
                let rims = [
                    window.x - 0.2,
                    3.8 - window.x,
                    window.z - 0.9,
                    2.7 - window.z,
                    met.x - 0.5,
                    3.5 - met.x,
                    met.y + depth,
                    -met.y,
                ];
                let least = rims.into_iter().fold(f64::INFINITY, f64::min);
                let value = found.direct.value[k];
                if least > 0.03 {
                    inside += 1;
                    assert!((value - rho * towards.z).abs() < 0.004, "{k}: {value}");
                } else if least < -0.03 {
                    outside += 1;
                    assert_eq!(value, 0.0, "{k}: {p}");
                }
            }
            assert!(inside > 20 && outside > 100, "{inside} {outside}");
            assert!(found.redirected.value.iter().all(|&v| v == 0.0) && found.cut_off == [0.0]);
        }
    }
}

/// Two mirrors at 45° hand the sun on parallel to itself: what arrives has lost each one's share and gained nothing.
#[test]
fn periscope_hands_the_sun_on() {
    let mut b = SceneBuilder::default();
    // a low sun due south comes along +y, is sent down, and on along +y again
    let tilted = |z: f64| rectangle([0.0, -0.5, z + 0.5], Vec3::X, Vec3::new(0.0, 1.0, -1.0));
    let (upper, lower) = (tilted(5.0), tilted(1.0));
    b.polygon("upper", &upper, &[], mirror(0.9)).expect("sound");
    b.polygon("lower", &lower, &[], mirror(0.8)).expect("sound");
    // hides the straight sun
    let wall = rectangle([-5.0, -0.6, 0.0], 10.0 * Vec3::X, 4.0 * Vec3::Z);
    b.polygon("wall", &wall, &[], Material::diffuse(0.0)).expect("sound");
    let scene = b.build().expect("sound");
    let points = [Vec3::new(0.5, 2.0, 1.0), Vec3::new(0.5, 2.0, 2.5)];
    let found = lit(&scene, &points, -Vec3::Y, sun(1.0, 180.0));
    let expected = 0.9 * 0.8 * 1.0_f64.to_radians().cos();
    assert!((found.direct.value[0] - expected).abs() < 1e-3, "{} {expected}", found.direct.value[0]);
    assert_eq!(found.direct.value[1], 0.0);
}

/// Between two mirrors, along a corridor, the sun keeps ρᵐ after m reflections, however many these are.
#[test]
fn corridor_of_mirrors_counts_the_reflections() {
    let (width, rho) = (0.5, 0.9);
    let mut b = SceneBuilder::default();
    for (name, x) in [("west", 0.0), ("east", width)] {
        let wall = rectangle([x, 0.0, 0.0], 20.0 * Vec3::Y, 3.0 * Vec3::Z);
        b.polygon(name, &wall, &[], mirror(rho)).expect("sound");
    }
    // nothing comes from above
    let roof = rectangle([0.0, 0.0, 3.0], width * Vec3::X, 20.0 * Vec3::Y);
    b.polygon("roof", &roof, &[], Material::diffuse(0.0)).expect("sound");
    let scene = b.build().expect("sound");
    let towards = sun(10.0, 140.0);
    let points: Vec<Vec3> = (0..40).map(|k| Vec3::new(0.2, 0.3 * f64::from(k) + 0.1, 0.4)).collect();
    let found = lit(&scene, &points, Vec3::Z, towards);
    let mut most = 0;
    for (point, value) in points.iter().zip(&found.direct.value) {
        // unfolded, the way back runs straight: walls are crossed at every multiple of the width
        let at_opening = point.x + towards.x / -towards.y * point.y;
        let crossed = (at_opening / width).floor();
        let clear =
            (at_opening / width - crossed - 0.5).abs() < 0.4 && point.z + towards.z / -towards.y * point.y < 2.9;
        if clear {
            let expected = rho.powf(crossed.abs()) * towards.z;
            assert!((value - expected).abs() < 0.02 * expected, "{point}: {value} {expected}");
            most = most.max(crossed.abs() as i32);
        }
    }
    assert!(most >= 15, "{most}");
}

/// A wall that is a perfect mirror is a room twice as large, in the sum over a sun and its mirror image and under an even sky:
/// direct light, reflected light, light that the mirror shows.
#[test]
fn mirrored_wall_is_a_room_twice_as_large() {
    let build = |mirrored: bool| {
        let half = Shoebox { window: [[0.6, 0.9], [1.8, 2.7]], size: [3.0, 4.0, 3.0], ..Shoebox::reference() };
        let mut b = SceneBuilder::default();
        let west = if mirrored { 0.0 } else { -3.0 };
        let [floor, walls, ceiling] = half.reflectances.map(Material::diffuse);
        let across = (3.0 - west) * Vec3::X;
        b.polygon("floor", &rectangle([west, 0.0, 0.0], across, 4.0 * Vec3::Y), &[], floor).expect("sound");
        b.polygon("ceiling", &rectangle([west, 0.0, 3.0], across, 4.0 * Vec3::Y), &[], ceiling).expect("sound");
        b.polygon("south", &rectangle([west, 0.0, 0.0], across, 3.0 * Vec3::Z), &[], walls).expect("sound");
        b.polygon("north", &rectangle([west, 4.0, 0.0], across, 3.0 * Vec3::Z), &[], walls).expect("sound");
        b.polygon("east", &rectangle([3.0, 0.0, 0.0], 4.0 * Vec3::Y, 3.0 * Vec3::Z), &[], walls).expect("sound");
        let material = if mirrored { mirror(1.0) } else { walls };
        b.polygon("west", &rectangle([west, 0.0, 0.0], 4.0 * Vec3::Y, 3.0 * Vec3::Z), &[], material).expect("sound");
        let [[x0, z0], [x1, z1]] = half.window;
        let mut window = |name: &str, x0: f64, x1: f64| {
            let outline = [(x0, z0), (x0, z1), (x1, z1), (x1, z0)].map(|(x, z)| Vec3::new(x, 0.0, z));
            b.window(name, &outline, pane(0.8), None, Some("south")).expect("sound");
        };
        window("window", x0, x1);
        if !mirrored {
            window("its image", -x1, -x0);
        }
        b.build().expect("sound")
    };
    let points = [(0.5, 1.0, 0.8), (1.5, 2.5, 0.8), (2.6, 3.5, 1.5), (0.3, 1.2, 0.8), (0.19, 2.98, 0.6)]
        .map(|(x, y, z)| Vec3::new(x, y, z));
    let normals = [Vec3::Z, Vec3::Z, -Vec3::X, Vec3::X, -Vec3::Y];
    let suns = [sun(20.0, 155.0), sun(20.0, 205.0)];
    let settings = Settings { rounds: 24, nodes: 1024, ..Settings::default() };
    let [one, two] = [true, false].map(|mirrored| {
        sun_coefficients(&build(mirrored), &points, &normals, &suns, 2, &settings, |_| true).expect("sound")
    });
    for i in 0..points.len() {
        for (what, one, two, resolution) in [
            ("direct", &one.direct, &two.direct, 0.005),
            ("interreflected", &one.interreflected, &two.interreflected, 0.002),
        ] {
            let sum = |c: &room::Component| c.value[2 * i] + c.value[2 * i + 1];
            // the errors of two suns line up
            let error = |c: &room::Component| c.standard_error[2 * i] + c.standard_error[2 * i + 1];
            assert_estimate(&format!("{what} {i}"), sum(one), error(one).hypot(error(two)), sum(two), resolution);
        }
    }
    // the last of them is lit twice, straight and by way of the mirror
    assert!((one.direct.value[8] + 1.6 * suns[0].y).abs() < 1e-3, "{}", one.direct.value[8]);
    let basis = SkyBasis::named("tregenza145").expect("known");
    let settings = Settings {
        weights: Some(vec![1.0; basis.patches()]),
        rounds: 32,
        nodes: 1024,
        window_samples: 1024,
        ..Settings::default()
    };
    let [one, two] = [true, false].map(|mirrored| {
        daylight_coefficients(&build(mirrored), &points, &normals, &basis, &settings, |_| true).expect("sound").weighted
    });
    for i in 0..points.len() {
        let error = one.standard_error[i].hypot(two.standard_error[i]);
        assert_estimate(&format!("sky {i}"), one.value[i], error, two.value[i], 0.02 * two.value[i]);
    }
}

/// A glass facade across the street throws a low sun from behind the house into its window: R(θ) of the one, T of the other.
#[test]
fn glass_facade_opposite_throws_the_sun_in() {
    let glass = ClearGlazing::glass(0.88).expect("possible");
    let mut b = black().builder(pane(0.7));
    // its outside looks north, to the house
    let facade = [(-20.0, 0.0), (-20.0, 30.0), (24.0, 30.0), (24.0, 0.0)].map(|(x, z)| Vec3::new(x, -20.0, z));
    b.window("facade", &facade, Arc::new(glass.clone()), None, None).expect("sound");
    let facing = rectangle([-20.0, -20.5, 0.0], 44.0 * Vec3::X, 30.0 * Vec3::Z);
    b.polygon("rooms behind it", &facing, &[], Material::diffuse(0.0)).expect("sound");
    let scene = b.build().expect("sound");
    // over the roof, from the north
    let towards = sun(30.0, 20.0);
    let mirrored = Vec3::new(towards.x, -towards.y, towards.z);
    let target = Vec3::new(2.0, 0.0, 1.8);
    let points = [target - 0.4 * mirrored, target - 0.4 * mirrored + 2.0 * Vec3::Y];
    let found = lit(&scene, &points, -Vec3::Y, towards);
    let incident =
        Direction::of(Vec3::new((1.0 - towards.y * towards.y).sqrt(), 0.0, towards.y.abs())).expect("finite");
    let reflectance = glass.straight(incident).expect("clear").reflectance;
    let expected = 0.7 * reflectance * -mirrored.y;
    assert!(reflectance > 0.07);
    assert!((found.direct.value[0] / expected - 1.0).abs() < 0.02, "{} {expected}", found.direct.value[0]);
    assert_eq!(found.direct.value[1], 0.0);
}

/// The inner face of a pane throws back what falls on it: R(θ), and between two panes R(θ) of each, to and fro.
#[test]
fn inner_faces_of_panes_throw_the_sun_back() {
    let glass = ClearGlazing::glass(0.88).expect("possible");
    let mut b = black().builder(Arc::new(ClearGlazing::open()));
    let back = [(0.2, 0.1), (3.8, 0.1), (3.8, 2.9), (0.2, 2.9)].map(|(x, z)| Vec3::new(x, 8.0, z));
    b.window("back", &back, Arc::new(glass.clone()), None, Some("north")).expect("sound");
    let scene = b.build().expect("sound");
    let towards = sun(10.0, 180.0);
    let incident = Direction::of(Vec3::new(towards.z, 0.0, -towards.y)).expect("finite");
    let shares = glass.straight(incident).expect("clear");
    // it falls on the back window at about 1 m, and comes back to where it is 0.5 m lower
    let points = [Vec3::new(2.0, 8.0 - 0.5 * 0.984_807_75 / 0.173_648_18, 0.5 + 1e-9)];
    let found = lit(&scene, &points, Vec3::Y, towards);
    let expected = shares.reflectance * -towards.y;
    assert!((found.direct.value[0] / expected - 1.0).abs() < 0.02, "{} {expected}", found.direct.value[0]);
    // two panes 1 mm apart, as two windows: T² / (1 − R²) in all, though each passes T² alone
    let mut b = black().builder(Arc::new(glass.clone()));
    let outline = |y: f64| [(0.0, 0.0), (0.0, 3.0), (4.0, 3.0), (4.0, 0.0)].map(|(x, z)| Vec3::new(x, y, z));
    b.window("outer", &outline(-0.001), Arc::new(glass.clone()), None, None).expect("sound");
    let scene = b.build().expect("sound");
    let towards = sun(75.0, 180.0);
    let incident = Direction::of(Vec3::new(towards.z, 0.0, -towards.y)).expect("finite");
    let shares = glass.straight(incident).expect("clear");
    let found = lit(&scene, &[Vec3::new(2.0, 0.2, 1.0)], Vec3::Z, towards);
    let expected = shares.transmittance.powi(2) / (1.0 - shares.reflectance.powi(2)) * towards.z;
    assert!(shares.reflectance.powi(2) > 0.02);
    assert!((found.direct.value[0] / expected - 1.0).abs() < 0.01, "{} {expected}", found.direct.value[0]);
}

/// Turns all light up that went down, by one total reflection.
struct Flip;

impl Glazing for Flip {
    fn lobes(&self, incident: Direction, out: &mut Lobes) {
        out.clear();
        let direction = incident.mirrored(Direction::from_unit(Vec3::Y));
        out.beams.push(Lobe { direction, power: 0.9, total_reflections: 1 });
    }

    fn scatter(&self, incident: Direction, _: [f64; 3]) -> Scattered {
        Scattered::Leaves { direction: incident.mirrored(Direction::from_unit(Vec3::Y)), total_reflections: 1 }
    }
}

/// Two windows in a row that both turn light turn it twice: here back to where it went, and it counts as redirected.
#[test]
fn two_windows_that_turn_light_turn_it_twice() {
    let mut b = black().builder(Arc::new(Flip));
    let outline = [(-9., -9.), (-9., 9.), (13., 9.), (13., -9.)].map(|(x, z)| Vec3::new(x, -0.1, z));
    b.window("outer", &outline, Arc::new(Flip), None, None).expect("sound");
    let scene = b.build().expect("sound");
    let towards = sun(45.0, 180.0);
    let found = lit(&scene, &[Vec3::new(2.0, 1.5, 0.5), Vec3::new(2.0, 1.5, 2.9)], -Vec3::Y, towards);
    assert!((found.redirected.value[0] - 0.81 * FRAC_1_SQRT_2).abs() < 2e-3, "{:?}", found.redirected.value);
    assert!(found.redirected.value[1] == 0.0 && found.direct.value == [0.0; 2]);
}

/// What was totally reflected before a mirror threw it on is redirected light all the same; a mirror that reflects diffusely too is lit on
/// the side that the light falls on alone.
#[test]
fn redirected_light_stays_so_behind_a_mirror() {
    let mut b = black().builder(Arc::new(Flip));
    let shelf = rectangle([0.5, 0.5, 2.6], 3.0 * Vec3::X, 1.5 * Vec3::Y);
    b.polygon("sail", &shelf, &[], Material { diffuse: 0.2, specular: 0.7 }).expect("sound");
    let scene = b.build().expect("sound");
    // at 45° up from the sill's height, met from below at y = 1
    let point = Vec3::new(2.0, 2.0, 1.6);
    let towards = sun(45.0, 180.0);
    let found = lit(&scene, &[point], Vec3::Z, towards);
    let expected = 0.9 * 0.7 * FRAC_1_SQRT_2;
    assert!((found.redirected.value[0] - expected).abs() < 3e-3, "{:?}", found.redirected.value);
    assert_eq!(found.direct.value, [0.0]);
    // black all around: no sensor above the sail is lit by its upper side
    let settings = Settings { rounds: 8, ..Settings::default() };
    let above = sun_coefficients(&scene, &[Vec3::new(2.0, 1.0, 2.9)], &[-Vec3::Z], &[towards], 1, &settings, |_| true)
        .expect("sound");
    assert_eq!(above.interreflected.value, [0.0]);
    let below = sun_coefficients(&scene, &[Vec3::new(2.0, 1.0, 1.0)], &[Vec3::Z], &[towards], 1, &settings, |_| true)
        .expect("sound");
    assert!(below.interreflected.value[0] > 0.01);
}

/// Opal glass over a mirror glows by the sun and by its image.
#[test]
fn opal_glass_glows_by_mirrored_light_as_well() {
    struct Opal;
    impl Glazing for Opal {
        fn lobes(&self, _: Direction, out: &mut Lobes) {
            out.clear();
            (out.spread, out.absorbed) = (0.5, 0.5);
        }
        fn scatter(&self, _: Direction, _: [f64; 3]) -> Scattered {
            Scattered::Absorbed
        }
        fn bsdf(&self, incident: Direction, outgoing: Direction) -> f64 {
            if incident.z * outgoing.z > 0.0 { 0.5 / PI } else { 0.0 }
        }
        fn spreads(&self) -> bool {
            true
        }
    }
    let towards = sun(50.0, 180.0);
    let settings = Settings { rounds: 64, ..Settings::default() };
    let [alone, mirrored] = [false, true].map(|with| {
        let mut b = black().builder(Arc::new(Opal));
        if with {
            let shelf = rectangle([-30.0, -60.0, 0.0], 64.0 * Vec3::X, 60.0 * Vec3::Y);
            b.polygon("water", &shelf, &[], mirror(0.6)).expect("sound");
        }
        let scene = b.build().expect("sound");
        sun_coefficients(&scene, &[Vec3::new(2.0, 4.0, 1.8)], &[-Vec3::Y], &[towards], 1, &settings, |_| true)
            .expect("spread")
            .direct
    });
    let error = mirrored.standard_error[0].hypot(1.6 * alone.standard_error[0]);
    assert_estimate("glow", mirrored.value[0], error, 1.6 * alone.value[0], 0.02 * alone.value[0]);
}

/// A curved mirror of more facets than are followed is named; a flat one beside it is still followed.
#[test]
fn mirrors_too_curved_are_named() {
    let mut b = black().builder(pane(1.0));
    b.polygon("shelf", &rectangle([0.5, -0.6, 0.8], 3.0 * Vec3::X, 0.6 * Vec3::Y), &[], mirror(0.5)).expect("sound");
    let count = 300_i64;
    let rim = |k: i64, x: f64| {
        let (sine, cosine) = (PI * k as f64 / count as f64).sin_cos();
        Vec3::new(x, -30.0 + cosine, 30.0 + sine)
    };
    let vertices: Vec<Vec3> = (0..=count).flat_map(|k| [rim(k, 0.0), rim(k, 1.0)]).collect();
    let triangles: Vec<[i64; 3]> =
        (0..count).flat_map(|k| [[2 * k, 2 * k + 1, 2 * k + 3], [2 * k, 2 * k + 3, 2 * k + 2]]).collect();
    b.mesh("barrel", &vertices, &triangles, mirror(0.9)).expect("sound");
    let scene = b.build().expect("sound");
    let unfollowed = unfollowed_mirrors(&scene);
    assert_eq!(unfollowed.iter().map(|one| one.name.as_str()).collect::<Vec<_>>(), ["barrel"]);
    assert!(unfollowed[0].facets == 600 && unfollowed[0].normals > 256);
    let towards = sun(40.0, 180.0);
    let back = |p: Vec3, d: f64| p + d * Vec3::new(-towards.x, -towards.y, towards.z);
    let point = back(Vec3::new(2.0, -0.2, 0.8), 2.2 / towards.z - 1e-6);
    let found = lit(&scene, &[point], -Vec3::Z, towards);
    assert!((found.direct.value[0] - 0.5 * towards.z).abs() < 0.003, "{}", found.direct.value[0]);
}

/// A rough panel that only mirrored light meets has no exact sun either.
#[test]
fn rough_panel_behind_a_mirror_has_no_exact_sun() {
    struct Rough;
    impl Glazing for Rough {
        fn lobes(&self, _: Direction, out: &mut Lobes) {
            out.clear();
            out.residual = 1.0;
        }
        fn scatter(&self, _: Direction, _: [f64; 3]) -> Scattered {
            Scattered::Absorbed
        }
    }
    let mut b = black().builder(Arc::new(Rough));
    b.polygon("opposite", &rectangle([-20.0, -20.0, 0.0], 44.0 * Vec3::X, 30.0 * Vec3::Z), &[], mirror(0.3))
        .expect("sound");
    let scene = b.build().expect("sound");
    let found =
        sun_coefficients(&scene, &[Vec3::ONE], &[Vec3::Z], &[sun(20.0, 0.0)], 1, &Settings::default(), |_| true);
    assert!(matches!(found, Err(RoomError::NoLobes { ref name, .. }) if name == "window"));
}
