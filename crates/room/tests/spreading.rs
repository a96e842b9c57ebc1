//! Windows that spread light: sky and sun behind them against closed forms.

mod rooms;

use hemisphere::{Direction, Vec3};
use optics::{Glazing, Lobes, Scattered};
use room::{Scene, Settings, daylight_coefficients, sun_coefficients};
use rooms::{Shoebox, assert_estimate, tregenza};
use std::f64::consts::{PI, TAU};
use std::sync::Arc;

/// Sends this share on as evenly bright as opal glass, and absorbs the rest.
struct Opal(f64);

impl Glazing for Opal {
    fn lobes(&self, _: Direction, out: &mut Lobes) {
        out.clear();
        (out.spread, out.absorbed) = (self.0, 1.0 - self.0);
    }

    fn scatter(&self, incident: Direction, u: [f64; 3]) -> Scattered {
        if u[0] >= self.0 {
            return Scattered::Absorbed;
        }
        // cosine law, by Malley's method
        let (r, angle) = (u[1].sqrt(), TAU * u[2]);
        let direction = Vec3::new(r * angle.cos(), r * angle.sin(), (1.0 - u[1]).sqrt() * incident.z.signum());
        Scattered::Leaves { direction: Direction::from_unit(direction), total_reflections: 0 }
    }

    fn bsdf(&self, incident: Direction, outgoing: Direction) -> f64 {
        if incident.z * outgoing.z > 0.0 { self.0 / PI } else { 0.0 }
    }

    fn spreads(&self) -> bool {
        true
    }
}

fn black_room() -> (Scene, [Vec3; 2], [Vec3; 2], [f64; 2]) {
    let room = Shoebox { reflectances: [0.0; 3], ..Shoebox::reference() };
    let scene = room.builder(Arc::new(Opal(0.5))).build().expect("sound");
    // before the middle of the window, far from it and near, looking at it
    let points = [Vec3::new(2.0, 4.0, 1.8), Vec3::new(2.0, 0.05, 1.8)];
    let leg =
        |a: f64, b: f64, d: f64| a / a.hypot(d) * (b / a.hypot(d)).atan() + b / b.hypot(d) * (a / b.hypot(d)).atan();
    let forms = [4.0, 0.05].map(|d| 4.0 * leg(1.8, 0.9, d) / TAU);
    (scene, points, [-Vec3::Y; 2], forms)
}

/// Opal glass before an even sky is as bright as it lets light through; what a sensor gets is its form factor.
#[test]
fn opal_window_under_an_even_sky_is_its_form_factor() {
    let (scene, points, normals, forms) = black_room();
    let basis = tregenza();
    let settings = Settings { weights: Some(vec![1.0; basis.patches()]), rounds: 64, ..Settings::default() };
    let found = daylight_coefficients(&scene, &points, &normals, &basis, &settings, |_| true).expect("sound");
    for (i, form) in forms.into_iter().enumerate() {
        let (value, error) = (found.weighted.value[i] / PI, found.weighted.standard_error[i] / PI);
        assert_estimate("opal window", value, error, 0.5 * form, 0.01 * form);
    }
}

/// The sun on opal glass makes it as bright as E cos θ τ/π, whether a sensor is far from it or close.
#[test]
fn opal_window_in_the_sun_is_its_form_factor() {
    let (scene, points, normals, forms) = black_room();
    for (altitude, turned) in [(20.0_f64, 0.0_f64), (50.0, 40.0)] {
        let (altitude, turned) = (altitude.to_radians(), turned.to_radians());
        let cos_i = altitude.cos() * turned.cos();
        let towards = Vec3::new(altitude.cos() * turned.sin(), -cos_i, altitude.sin());
        let settings = Settings { rounds: 64, ..Settings::default() };
        let found = sun_coefficients(&scene, &points, &normals, &[towards], 1, &settings, |_| true).expect("spread");
        for (i, form) in forms.into_iter().enumerate() {
            let (value, error) = (found.direct.value[i], found.direct.standard_error[i]);
            assert_estimate("opal window in the sun", value, error, 0.5 * cos_i * form, 0.01 * form);
            assert_eq!(found.redirected.value[i], 0.0);
        }
    }
}

/// Suns over a patch add up to the patch's coefficient, reflections in the room counted.
#[test]
fn suns_of_a_patch_add_up_to_its_coefficient_behind_opal_glass() {
    let room = Shoebox::reference();
    let scene = room.builder(Arc::new(Opal(0.5))).build().expect("sound");
    let (points, normals, basis) = ([Vec3::new(2.0, 3.0, 0.8)], [Vec3::Z], tregenza());
    // due south, 30° to 42° up
    let patch = basis.find(Vec3::new(0.0, -36.0_f64.to_radians().cos(), 36.0_f64.to_radians().sin()));
    let towards: Vec<Vec3> = (0..64)
        .map(|k| basis.sample(patch, [(f64::from(k % 8) + 0.5) / 8.0, (f64::from(k / 8) + 0.5) / 8.0]))
        .collect();
    let settings = Settings { rounds: 16, nodes: 2048, ..Settings::default() };
    let by_sun = sun_coefficients(&scene, &points, &normals, &towards, 1, &settings, |_| true).expect("spread");
    let fine = Settings { rounds: 64, nodes: 4096, window_samples: 4096, ..Settings::default() };
    let by_sky = daylight_coefficients(&scene, &points, &normals, &basis, &fine, |_| true).expect("sound");
    for (what, sun, sky) in
        [("direct", &by_sun.direct, &by_sky.direct), ("interreflected", &by_sun.interreflected, &by_sky.interreflected)]
    {
        // a patch of even luminance L gives a plane facing a part dω of it the illuminance L dω
        let mean = basis.solid_angle(patch) * sun.value.iter().sum::<f64>() / 64.0;
        // errors of the suns line up
        let error = basis.solid_angle(patch) * sun.standard_error.iter().sum::<f64>() / 64.0;
        let error = error.hypot(sky.standard_error[patch]);
        assert_estimate(what, mean, error, sky.value[patch], 0.05 * sky.value[patch]);
    }
}
