//! Laws that hold in any room.

mod rooms;

use hemisphere::Vec3;
use optics::ClearGlazing;
use room::{DaylightCoefficients, Material, RoomError, SceneBuilder, Settings, daylight_coefficients};
use rooms::{Shoebox, assert_estimate, tregenza};
use std::f64::consts::PI;
use std::sync::Arc;

fn reference(settings: &Settings) -> DaylightCoefficients {
    let room = Shoebox::reference();
    let scene = room.scene(ClearGlazing::glass(0.88).expect("possible"));
    let (points, normals) = room.work_plane(0.8, 1.0);
    daylight_coefficients(&scene, &points, &normals, &tregenza(), settings, |_| true).expect("sound input")
}

/// The number of threads changes nothing, to the last bit; the seed does.
#[test]
fn threads_do_not_change_the_result() {
    let settings = Settings { rounds: 3, nodes: 300, window_samples: 50, ..Settings::default() };
    let with = |threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("a pool");
        pool.install(|| reference(&settings))
    };
    let (one, three) = (with(1), with(3));
    assert_eq!(one.direct.value, three.direct.value);
    assert_eq!(one.interreflected.value, three.interreflected.value);
    assert_eq!(one.weighted.standard_error, three.weighted.standard_error);
    assert_ne!(one.direct.value, reference(&Settings { seed: 1, ..settings }).direct.value);
}

/// Skies superpose: the weighted sum is that of the coefficients.
#[test]
fn illuminance_is_the_sum_of_coefficients_times_luminance() {
    let weights: Vec<f64> = (0..tregenza().patches()).map(|p| 1.0 + (p % 7) as f64).collect();
    let found = reference(&Settings { weights: Some(weights.clone()), rounds: 4, ..Settings::default() });
    for i in 0..found.sensors {
        let sum: f64 = (0..found.patches)
            .map(|p| {
                let k = i * found.patches + p;
                weights[p] * (found.direct.value[k] + found.redirected.value[k] + found.interreflected.value[k])
            })
            .sum();
        assert!((sum / found.weighted.value[i] - 1.0).abs() < 1e-12);
    }
}

/// Standard errors are honest: over many seeds, estimates scatter about their mean as they say.
#[test]
fn standard_errors_tell_the_scatter() {
    let room = Shoebox::reference();
    let scene = room.scene(ClearGlazing::glass(0.88).expect("possible"));
    let (points, normals) = ([Vec3::new(2.0, 3.0, 0.8)], [Vec3::Z]);
    let runs: Vec<(f64, f64)> = (0..40)
        .map(|seed| {
            let settings = Settings { seed, rounds: 16, nodes: 64, window_samples: 32, ..Settings::default() };
            let found =
                daylight_coefficients(&scene, &points, &normals, &tregenza(), &settings, |_| true).expect("sound");
            (found.weighted.value[0], found.weighted.standard_error[0])
        })
        .collect();
    let n = runs.len() as f64;
    let mean = runs.iter().map(|r| r.0).sum::<f64>() / n;
    let scatter = runs.iter().map(|r| (r.0 - mean).powi(2)).sum::<f64>() / (n - 1.0);
    let claimed = runs.iter().map(|r| r.1 * r.1).sum::<f64>() / n;
    // the variance of a variance from 40 runs is good to 2/√80: four of those
    assert!((scatter / claimed - 1.0).abs() < 4.0 * (2.0 / (n - 1.0)).sqrt(), "{scatter:.3e} against {claimed:.3e}");
}

/// A target is met, and asking is obeyed: the work stops when told to and keeps what is there.
#[test]
fn target_and_interruption() {
    let settings = Settings { target_relative_error: Some(0.02), ..Settings::default() };
    let found = reference(&settings);
    assert!(found.converged && !found.interrupted);
    for (value, error) in found.weighted.value.iter().zip(&found.weighted.standard_error) {
        assert!(error / value <= 0.02);
    }
    let room = Shoebox::reference();
    let scene = room.scene(ClearGlazing::open());
    let (points, normals) = room.work_plane(0.8, 2.0);
    let mut asked = 0;
    let stopped = daylight_coefficients(&scene, &points, &normals, &tregenza(), &Settings::default(), |progress| {
        asked += 1;
        progress.rounds < 3
    })
    .expect("sound input");
    assert!(stopped.interrupted && stopped.rounds == 3 && asked == 3 && stopped.weighted.value[0] > 0.0);
}

/// A point and a window see each other through a partition only where it is not.
#[test]
fn obstruction_darkens_only_what_it_hides() {
    let room = Shoebox { reflectances: [0.0; 3], ..Shoebox::reference() };
    let mut b = room.builder(Arc::new(ClearGlazing::open()));
    let screen = [(0., 0.), (4., 0.), (4., 3.), (0., 3.)].map(|(x, z)| Vec3::new(x, 2.0, z));
    let gap = [(1.5, 1.), (2.5, 1.), (2.5, 2.), (1.5, 2.)].map(|(x, z)| Vec3::new(x, 2.0, z)).to_vec();
    b.polygon("screen", &screen, &[gap], Material::diffuse(0.0)).expect("sound");
    let scene = b.build().expect("sound");
    let (points, normals) = ([Vec3::new(2.0, 4.0, 1.2), Vec3::new(2.0, 4.0, 2.9)], [-Vec3::Y, Vec3::Z]);
    let basis = tregenza();
    let weights = Some([vec![1.0; basis.ground()], vec![0.0]].concat());
    let settings = Settings { weights, ..Settings::default() };
    let found = daylight_coefficients(&scene, &points, &normals, &basis, &settings, |_| true).expect("sound");
    // through the gap the window plane, 4 m away, is seen 1 m to either side and from the sensor's level up to 1.5 m above it
    let leg = |a: f64, b: f64| a / a.hypot(4.0) * (b / a.hypot(4.0)).atan();
    let form = 2.0 * (leg(1.0, 1.5) + leg(1.5, 1.0)) / (2.0 * PI);
    let (value, error) = (found.weighted.value[0] / PI, found.weighted.standard_error[0] / PI);
    assert_estimate("through the gap", value, error, form, 0.01 * form);
    assert_eq!(found.weighted.value[1], 0.0, "up behind the screen");
}

/// Mirrors hand light on: a periscope shows the sky, dimmed by both of its mirrors, as specular light.
#[test]
fn periscope_of_two_mirrors_shows_the_sky() {
    let mut b = SceneBuilder::default();
    let mirror = Material { diffuse: 0.0, specular: 0.9 };
    // two mirrors at 45° in a shaft, the upper one looking out to +y, the lower one to a sensor that looks along +y
    let plate =
        |z: f64| [(-1., -1., -1.), (1., -1., -1.), (1., 1., 1.), (-1., 1., 1.)].map(|(x, y, h)| Vec3::new(x, y, z + h));
    b.polygon("lower", &plate(0.0), &[], mirror).expect("sound");
    b.polygon("upper", &plate(10.0), &[], mirror).expect("sound");
    let scene = b.build().expect("sound");
    let (point, normal) = ([Vec3::new(0.0, -4.0, 0.0)], [Vec3::Y]);
    let basis = tregenza();
    let settings = Settings { nodes: 4096, window_samples: 4096, rounds: 8, ..Settings::default() };
    let found = daylight_coefficients(&scene, &point, &normal, &basis, &settings, |_| true).expect("sound");
    // straight ahead over both mirrors one looks north, level: half of what is seen there is sky
    let north = basis.find(Vec3::new(0.0, 1.0, 0.01));
    assert!(found.direct.value[north] > 0.0 && found.redirected.value.iter().all(|&v| v == 0.0));
    assert!(found.interreflected.value.iter().all(|&v| v == 0.0));
}

/// Each mistake is named before any ray is traced.
#[test]
fn mistakes_are_named() {
    assert!(matches!(SceneBuilder::default().build(), Err(RoomError::EmptyScene)));
    let square = |s: f64, z: f64| [(0., 0.), (s, 0.), (s, s), (0., s)].map(|(x, y)| Vec3::new(x, y, z)).to_vec();
    let mut b = SceneBuilder::default();
    let wrong = b.polygon("dark", &square(1.0, 0.0), &[], Material { diffuse: 0.7, specular: 0.4 });
    assert!(matches!(wrong, Err(RoomError::ShareOutside { ref name, .. }) if name == "dark"));
    b.polygon("wall", &square(2.0, 0.0), &[], Material::diffuse(0.5)).expect("sound");
    assert!(matches!(
        b.polygon("wall", &square(1.0, 1.0), &[], Material::diffuse(0.5)),
        Err(RoomError::NameTwice { .. })
    ));
    let glass: Arc<dyn optics::Glazing> = Arc::new(ClearGlazing::open());
    let outside = b.window("big", &square(3.0, 0.0), glass.clone(), None, Some("wall"));
    assert!(matches!(outside, Err(RoomError::Outside { .. })), "{outside:?}");
    let off_plane = b.window("off", &square(1.0, 0.5), glass.clone(), None, Some("wall"));
    assert!(matches!(off_plane, Err(RoomError::Outside { .. })));
    assert!(matches!(b.window("lost", &square(1.0, 0.0), glass, None, Some("wal")), Err(RoomError::NoSuchWall { .. })));
    let mesh = b.mesh("mesh", &square(1.0, 0.0), &[[0, 1, 9]], Material::diffuse(0.5));
    assert!(matches!(mesh, Err(RoomError::NoSuchVertex { index: 9, .. })));
    let scene = b.build().expect("sound");
    let asked = |points: &[Vec3], normals: &[Vec3], settings: &Settings| {
        daylight_coefficients(&scene, points, normals, &tregenza(), settings, |_| true).map(|_| ())
    };
    assert!(asked(&[Vec3::ZERO], &[], &Settings::default()).is_err());
    assert!(asked(&[Vec3::NAN], &[Vec3::Z], &Settings::default()).is_err());
    assert!(asked(&[Vec3::ZERO], &[Vec3::ZERO], &Settings::default()).is_err());
    for wrong in [
        Settings { rounds: 1, ..Settings::default() },
        Settings { nodes: 0, ..Settings::default() },
        Settings { target_relative_error: Some(0.0), ..Settings::default() },
        Settings { weights: Some(vec![1.0]), ..Settings::default() },
    ] {
        assert!(matches!(asked(&[Vec3::ZERO], &[Vec3::Z], &wrong), Err(RoomError::Setting { .. })));
    }
}
