//! Daylight coefficients against what is known without tracing a ray.

mod rooms;

use hemisphere::{SkyBasis, Vec3};
use optics::ClearGlazing;
use room::{DaylightCoefficients, Material, Scene, SceneBuilder, Settings, daylight_coefficients};
use rooms::{Shoebox, assert_estimate, tregenza};
use std::f64::consts::PI;

fn run(
    scene: &Scene,
    points: &[Vec3],
    normals: &[Vec3],
    basis: &SkyBasis,
    settings: &Settings,
) -> DaylightCoefficients {
    daylight_coefficients(scene, points, normals, basis, settings, |_| true).expect("sound input")
}

/// A sensor under the open sky sees every patch by its projected solid angle, π in all; the ground it does not see at all.
#[test]
fn open_sky_sums_to_pi() {
    let mut b = SceneBuilder::default();
    let below = [(0., 0.), (1., 0.), (1., 1.), (0., 1.)].map(|(x, y)| Vec3::new(x, y, -1.0));
    b.polygon("slab", &below, &[], Material::diffuse(0.5)).expect("sound");
    let scene = b.build().expect("sound");
    let basis = tregenza();
    let found =
        run(&scene, &[Vec3::ZERO], &[Vec3::Z], &basis, &Settings { window_samples: 4096, ..Settings::default() });
    for p in 0..basis.ground() {
        let b = basis.bounds(p);
        let projected = 0.5 * basis.solid_angle(p) * (b.altitude_low.sin() + b.altitude_high.sin());
        assert_estimate(
            "patch",
            found.direct.value[p],
            found.direct.standard_error[p],
            projected,
            0.05 * projected + 1e-4,
        );
    }
    let sum: f64 = found.direct.value.iter().sum();
    assert!((sum - PI).abs() < 1e-12 && found.direct.value[basis.ground()] == 0.0, "{sum}");
}

/// A room without absorption, under a luminance of 1 from everywhere, is as bright inside as outside: π at every sensor, by however
/// many reflections.
#[test]
fn white_furnace_is_as_bright_as_its_surroundings() {
    let room = Shoebox { reflectances: [1.0; 3], ..Shoebox::reference() };
    let scene = room.scene(ClearGlazing::open());
    let points = [Vec3::new(2.0, 1.0, 0.8), Vec3::new(1.0, 7.0, 0.8), Vec3::new(3.0, 4.0, 2.5)];
    let normals = [Vec3::Z, -Vec3::Y, -Vec3::Z];
    let basis = tregenza();
    let settings = Settings { weights: Some(vec![1.0; basis.patches()]), rounds: 32, ..Settings::default() };
    let found = run(&scene, &points, &normals, &basis, &settings);
    for i in 0..points.len() {
        let (value, error) = (found.weighted.value[i], found.weighted.standard_error[i]);
        assert_estimate("furnace", value, error, PI, 0.02 * PI);
    }
}

/// What an explicit limit loses is what following the light to its end finds more.
#[test]
fn limit_reports_what_it_loses() {
    let scene = Shoebox::reference().scene(ClearGlazing::open());
    let (points, normals) = ([Vec3::new(2.0, 5.0, 0.8)], [Vec3::Z]);
    let basis = tregenza();
    let overcast = basis.overcast(0.2);
    // pairs of the light found without a limit, and with one plus what that lost
    let pairs: Vec<[f64; 3]> = (0..8)
        .map(|pair| {
            let settings = |max_bounces, seed| Settings { max_bounces, seed, ..Settings::default() };
            let whole = run(&scene, &points, &normals, &basis, &settings(None, 2 * pair));
            let limited = run(&scene, &points, &normals, &basis, &settings(Some(2), 2 * pair + 1));
            assert!(whole.lost.is_none());
            let lost: f64 = limited.lost.expect("a limit").iter().zip(&overcast).map(|(l, w)| l * w).sum();
            [whole.weighted.value[0], limited.weighted.value[0], lost]
        })
        .collect();
    let mean = |f: fn(&[f64; 3]) -> f64| pairs.iter().map(f).sum::<f64>() / 8.0;
    let difference = mean(|p| p[0] - p[1] - p[2]);
    let error = (pairs.iter().map(|p| (p[0] - p[1] - p[2] - difference).powi(2)).sum::<f64>() / 56.0).sqrt();
    let lost = mean(|p| p[2]);
    // reflectances of 0.2, 0.5 and 0.8 leave a good part of the light to the third reflection and beyond
    assert!(lost > 0.1 * mean(|p| p[0]));
    assert_estimate("whole less limited less lost", difference, error, 0.0, 0.1 * lost);
}

/// Sky components under an unglazed window in a black room, against the closed forms for a uniform sky.
#[test]
fn window_in_a_black_room_is_its_sky_component() {
    let table = include_str!("data/sky_component_window_analytic.csv");
    let rows = table.lines().filter(|line| line.starts_with(|c: char| c.is_ascii_digit()));
    let mut checked = 0;
    for row in rows {
        let v: Vec<f64> = row.split(',').map(|x| x.parse().unwrap_or(f64::NAN)).collect();
        let [w, h, d] = [v[0], v[1], v[2]];
        if w > 100.0 {
            continue;
        }
        // the sensor stands at sill level, d inside, opposite the lower corner of a window that reaches w to one side
        let room = Shoebox {
            size: [w + 4.0, d + 2.0, h + 3.0],
            reflectances: [0.0; 3],
            window: [[2.0, 1.0], [2.0 + w, 1.0 + h]],
        };
        let scene = room.scene(ClearGlazing::open());
        let basis = SkyBasis::named("reinhart2305").expect("known");
        let weights = Some([vec![1.0 / PI; basis.ground()], vec![0.0]].concat());
        let settings = Settings { weights, ..Settings::default() };
        let found = run(&scene, &[Vec3::new(2.0, d, 1.0)], &[Vec3::Z], &basis, &settings);
        assert_estimate(row, found.weighted.value[0], found.weighted.standard_error[0], v[3], 0.003 * v[3]);
        // the overcast sky, whose luminance is averaged over 2305 patches: half a percent at most from that
        let overcast = basis.overcast(0.0);
        let cie: f64 =
            (0..basis.patches()).map(|p| found.direct.value[p] * overcast[p]).sum::<f64>() / (7.0 * PI / 9.0);
        assert!((cie / v[6] - 1.0).abs() < 0.008, "{row}: {cie}");
        checked += 1;
    }
    assert_eq!(checked, 5);
}

/// A horizontal opening of half-size a in a black roof at height h gives a sensor below its middle the form factor of a square,
/// 4/(2π) · 2 · x/√(1+x²) · atan(x/√(1+x²)), x = a/h.
#[test]
fn roof_opening_is_a_form_factor() {
    let (a, h) = (1.0_f64, 2.5_f64);
    let mut b = SceneBuilder::default();
    let square = |s: f64| [(-s, -s), (s, -s), (s, s), (-s, s)].map(|(x, y)| Vec3::new(x, y, h)).to_vec();
    b.polygon("roof", &square(500.0), &[], Material::diffuse(0.0)).expect("sound");
    // anticlockwise as seen from below
    let outline: Vec<Vec3> = square(a).into_iter().rev().collect();
    b.window("light", &outline, std::sync::Arc::new(ClearGlazing::open()), None, Some("roof")).expect("sound");
    let scene = b.build().expect("sound");
    let basis = tregenza();
    let weights = Some([vec![1.0; basis.ground()], vec![0.0]].concat());
    let found = run(&scene, &[Vec3::ZERO], &[Vec3::Z], &basis, &Settings { weights, ..Settings::default() });
    let x = a / h;
    let s = x / (1.0 + x * x).sqrt();
    let form = 4.0 / (2.0 * PI) * 2.0 * s * s.atan();
    // beyond the roof's rim 500 m away remains a ring of sky of (h/500)²
    assert_estimate(
        "roof light",
        found.weighted.value[0] / PI,
        found.weighted.standard_error[0] / PI,
        form,
        0.002 * form,
    );
}

/// In a sphere, light that has been reflected once falls evenly on the wall: with a port of share f, light Φ entering and reflectance ρ,
/// what a sensor in the middle gets after two or more reflections is ρ² Φ / A / (1 − ρ (1 − f)), the integrating sphere's formula.
#[test]
fn integrating_sphere_multiplies_its_light() {
    let rho = 0.8_f64;
    let (rings, sectors, port_ring) = (64_usize, 128_usize, 8_usize);
    let angle = |i: usize| PI * i as f64 / rings as f64;
    let vertices: Vec<Vec3> = (0..=rings)
        .flat_map(|i| (0..sectors).map(move |j| (angle(i), 2.0 * PI * j as f64 / sectors as f64)))
        .map(|(t, p)| Vec3::new(t.sin() * p.cos(), t.sin() * p.sin(), t.cos()))
        .collect();
    let at = |i: usize, j: usize| (i * sectors + j % sectors) as i64;
    let triangles: Vec<[i64; 3]> = (port_ring..rings)
        .flat_map(|i| (0..sectors).map(move |j| (i, j)))
        .flat_map(|(i, j)| [[at(i, j), at(i + 1, j), at(i + 1, j + 1)], [at(i, j), at(i + 1, j + 1), at(i, j + 1)]])
        .collect();
    let port: Vec<Vec3> = (0..sectors).rev().map(|j| vertices[port_ring * sectors + j]).collect();
    let mut b = SceneBuilder::default();
    b.mesh("sphere", &vertices, &triangles, Material::diffuse(rho)).expect("sound");
    b.window("port", &port, std::sync::Arc::new(ClearGlazing::open()), None, None).expect("sound");
    let scene = b.build().expect("sound");
    let basis = tregenza();
    let found: Vec<f64> = (0..6)
        .map(|seed| {
            let settings = Settings {
                max_bounces: Some(1),
                nodes: 2048,
                rounds: 4,
                window_samples: 1,
                seed,
                ..Settings::default()
            };
            let found = run(&scene, &[Vec3::ZERO], &[-Vec3::Z], &basis, &settings);
            found.lost.expect("a limit")[..basis.ground()].iter().sum()
        })
        .collect();
    let mean = found.iter().sum::<f64>() / 6.0;
    let error = (found.iter().map(|x| (x - mean).powi(2)).sum::<f64>() / 30.0).sqrt();
    // a luminance of 1 sends π times the port's area in; the port takes the share f of the sphere
    let (flux, f) = (PI * PI * angle(port_ring).sin().powi(2), 0.5 * (1.0 - angle(port_ring).cos()));
    let expected = rho * rho * flux / (4.0 * PI) / (1.0 - rho * (1.0 - f));
    assert_estimate("sphere", mean, error, expected, 0.012 * expected);
}
