//! The sun through plain and redirecting windows, against closed forms and against the sky's own coefficients.

mod rooms;

use hemisphere::{Direction, SkyBasis, Vec3, towards};
use optics::{ClearGlazing, Glazing, Lobe, Lobes, Scattered};
use room::{RoomError, Settings, centre_coefficients, daylight_coefficients, sun_coefficients};
use rooms::{Shoebox, assert_estimate, tregenza};
use std::f64::consts::PI;
use std::sync::Arc;

/// An ideal panel that turns the share `turned` of the light up where it went down, by one total reflection, and passes the rest.
struct Turner {
    turned: f64,
}

impl Turner {
    fn flipped(incident: Direction) -> Direction {
        incident.mirrored(Direction::from_unit(Vec3::Y))
    }
}

impl Glazing for Turner {
    fn lobes(&self, incident: Direction, out: &mut Lobes) {
        out.clear();
        out.beams.push(Lobe { direction: Self::flipped(incident), power: self.turned, total_reflections: 1 });
        out.beams.push(Lobe { direction: incident, power: 1.0 - self.turned, total_reflections: 0 });
        out.beams.retain(|lobe| lobe.power > 0.0);
    }

    fn scatter(&self, incident: Direction, u: [f64; 3]) -> Scattered {
        let turned = u[0] < self.turned;
        let direction = if turned { Self::flipped(incident) } else { incident };
        Scattered::Leaves { direction, total_reflections: u16::from(turned) }
    }
}

fn sun(altitude_deg: f64, azimuth_deg: f64) -> Vec3 {
    towards(altitude_deg.to_radians(), azimuth_deg.to_radians())
}

/// The sun through a pane is T(θ) cos θ of its normal illuminance where it falls, at every altitude, and nothing elsewhere.
#[test]
fn sun_through_a_pane_is_the_closed_form() {
    let room = Shoebox { reflectances: [0.0; 3], ..Shoebox::reference() };
    let glass = ClearGlazing::glass(0.88).expect("possible");
    let scene = room.scene(glass.clone());
    let settings = Settings { rounds: 2, nodes: 1, ..Settings::default() };
    for altitude in [10.0_f64, 30.0, 50.0, 70.0, 85.0] {
        let towards_sun = sun(altitude, 165.0);
        let lit = Vec3::new(2.0, 0.0, 1.8) - 0.5 * towards_sun;
        let shade = Vec3::new(2.0, 7.9, 2.9);
        let found = sun_coefficients(&scene, &[lit, shade], &[Vec3::Z; 2], &[towards_sun], 4, &settings, |_| true)
            .expect("sound input");
        let cos_i = -towards_sun.y;
        let incident = Direction::from_unit(Vec3::new((1.0 - cos_i * cos_i).sqrt(), 0.0, cos_i));
        let straight = glass.straight(incident).expect("clear").transmittance;
        let expected = straight * towards_sun.z;
        // the disc's own width tilts cosine and transmittance by less than half a percent even at grazing
        assert!(
            (found.direct.value[0] / expected - 1.0).abs() < 0.03,
            "{altitude}: {} {expected}",
            found.direct.value[0]
        );
        assert_eq!(found.direct.value[1], 0.0);
    }
}

/// A patch's coefficient is its suns' mean times its solid angle, direct and interreflected alike: two ways that share little.
#[test]
fn suns_of_a_patch_add_up_to_its_coefficient() {
    let room = Shoebox::reference();
    for glazing in
        [Arc::new(ClearGlazing::glass(0.88).expect("possible")) as Arc<dyn Glazing>, Arc::new(Turner { turned: 0.7 })]
    {
        let scene = room.builder(glazing).build().expect("sound");
        let basis = tregenza();
        let patch = basis.find(sun(42.0, 190.0));
        let count = 256;
        let suns: Vec<Vec3> = (0..count)
            .map(|i| {
                let i = f64::from(i) + 0.5;
                basis.sample(patch, [(i * 0.754_877_666) % 1.0, (i * 0.569_840_290_998) % 1.0])
            })
            .collect();
        let (points, normals) = ([Vec3::new(2.0, 2.0, 0.8), Vec3::new(1.0, 5.0, 2.5)], [Vec3::Z, -Vec3::Z]);
        let settings = Settings { rounds: 12, nodes: 256, ..Settings::default() };
        let by_sun = sun_coefficients(&scene, &points, &normals, &suns, 1, &settings, |_| true).expect("sound");
        let settings = Settings { rounds: 16, nodes: 4096, window_samples: 4096, ..Settings::default() };
        let by_sky = daylight_coefficients(&scene, &points, &normals, &basis, &settings, |_| true).expect("sound");
        for i in 0..points.len() {
            for (part, of_suns, of_sky) in [
                ("direct", &by_sun.direct, &by_sky.direct),
                ("redirected", &by_sun.redirected, &by_sky.redirected),
                ("interreflected", &by_sun.interreflected, &by_sky.interreflected),
            ] {
                let row = i * count as usize..(i + 1) * count as usize;
                let scale = basis.solid_angle(patch) / f64::from(count);
                let mean = of_suns.value[row.clone()].iter().sum::<f64>() * scale;
                // suns share their paths: their errors add as they are
                let sun_error = of_suns.standard_error[row].iter().sum::<f64>() * scale;
                let at = i * basis.patches() + patch;
                let (value, error) = (of_sky.value[at], of_sky.standard_error[at].hypot(sun_error));
                // 256 suns sample the patch to about a percent where a window's edge cuts it
                assert!(error < 0.2 * value.max(1e-3), "{part} {i}: too noisy: {value} ± {error}");
                assert!(
                    (mean - value).abs() < 4.0 * error + 0.02 * value + 1e-12,
                    "{part} {i}: {mean} {value} ± {error}"
                );
            }
        }
    }
}

/// A panel whose cuts turn all light sends the sun to the ceiling and none to the floor.
#[test]
fn turned_sun_lights_the_ceiling_not_the_floor() {
    let room = Shoebox { reflectances: [0.0; 3], ..Shoebox::reference() };
    let scene = room.builder(Arc::new(Turner { turned: 1.0 })).build().expect("sound");
    let plane = |z: f64| -> Vec<Vec3> {
        (0..64).map(|i| Vec3::new(0.25 + 0.5 * f64::from(i % 8), 0.5 + f64::from(i / 8), z)).collect()
    };
    let settings = Settings { rounds: 2, nodes: 1, ..Settings::default() };
    let at = |z: f64, normal: Vec3| {
        let found = sun_coefficients(&scene, &plane(z), &[normal; 64], &[sun(45.0, 180.0)], 4, &settings, |_| true);
        let found = found.expect("sound");
        assert!(found.direct.value.iter().all(|&v| v == 0.0));
        found.redirected.value
    };
    let (ceiling, floor) = (at(2.999, -Vec3::Z), at(0.001, Vec3::Z));
    assert!(floor.iter().all(|&v| v == 0.0));
    // mirrored at the cuts the beam rises at 45°: where it lands it gives cos 45° of the normal illuminance
    let bright = ceiling.iter().fold(0.0, |a: f64, &b| a.max(b));
    assert!((bright - 45.0_f64.to_radians().sin()).abs() < 0.005, "{bright}");
    // it lands from where the window's head is to where its sill is: 0.3 m to 2.1 m inside
    let rows: Vec<f64> = ceiling.chunks(8).map(|row| row[3]).collect();
    assert!(rows[0] > 0.7 && rows[1] > 0.7 && rows[2..].iter().all(|&v| v == 0.0), "{rows:?}");
}

/// The sky through the turning panel: redirected is to direct as its shares are, seen from straight ahead at level height.
#[test]
fn redirected_light_is_counted_apart() {
    let room = Shoebox { reflectances: [0.0; 3], window: [[0.2, 0.5], [3.8, 2.5]], ..Shoebox::reference() };
    let scene = room.builder(Arc::new(Turner { turned: 0.25 })).build().expect("sound");
    let basis = tregenza();
    // light from everywhere is the same light after turning
    let weights = Some(vec![1.0; basis.patches()]);
    let settings = Settings { weights, window_samples: 2048, ..Settings::default() };
    let found = daylight_coefficients(&scene, &[Vec3::new(2.0, 4.0, 1.5)], &[-Vec3::Y], &basis, &settings, |_| true)
        .expect("sound");
    let (direct, redirected): (f64, f64) = (found.direct.value.iter().sum(), found.redirected.value.iter().sum());
    // the form factor of the window, 4 m away, 1.8 m to each side and 1 m up and down
    let leg = |a: f64, b: f64| a / a.hypot(4.0) * (b / a.hypot(4.0)).atan();
    let form = 4.0 * (leg(1.8, 1.0) + leg(1.0, 1.8)) / (2.0 * PI);
    let error = found.weighted.standard_error[0] / PI;
    assert_estimate("all", (direct + redirected) / PI, error, form, 0.01 * form);
    assert!((redirected / (direct + redirected) - 0.25).abs() < 0.01, "{redirected} {direct}");
}

/// By sector centres an open sky gives each patch its solid angle times the cosine of its centre, as published; a turned ray counts where
/// it really goes.
#[test]
fn centre_rays_reach_the_sector_they_are_sent_to() {
    let room = Shoebox { reflectances: [0.0; 3], ..Shoebox::reference() };
    let basis = SkyBasis::named("troplux5221").expect("known");
    let (points, normals) = ([Vec3::new(2.0, 1.0, 0.8)], [Vec3::Z]);
    let scene = room.scene(ClearGlazing::open());
    let centre = centre_coefficients(&scene, &points, &normals, &basis).expect("sound");
    let settings = Settings { window_samples: 8192, ..Settings::default() };
    let sampled = daylight_coefficients(&scene, &points, &normals, &basis, &settings, |_| true).expect("sound");
    let sum = |v: &[f64]| v[..basis.ground()].iter().sum::<f64>();
    assert!((sum(&centre.direct) / sum(&sampled.direct.value) - 1.0).abs() < 0.01);
    assert!(centre.redirected.iter().all(|&v| v == 0.0));
    // all light turned: what arrives from above at the sensor came from below the horizon
    let scene = room.builder(Arc::new(Turner { turned: 1.0 })).build().expect("sound");
    let turned = centre_coefficients(&scene, &points, &normals, &basis).expect("sound");
    assert!(sum(&turned.redirected) == 0.0 && turned.redirected[basis.ground()] > 0.1);
}

/// A panel without definite directions has no exact sun, and says so.
#[test]
fn rough_panel_has_no_exact_sun() {
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
    let scene = Shoebox::reference().builder(Arc::new(Rough)).build().expect("sound");
    let found =
        sun_coefficients(&scene, &[Vec3::ONE], &[Vec3::Z], &[sun(45.0, 180.0)], 1, &Settings::default(), |_| true);
    assert!(matches!(found, Err(RoomError::NoLobes { ref name, .. }) if name == "window"));
}

/// A window of which a little light has no direction lets the rest in, and the little counts as cut off; more is refused.
#[test]
fn light_without_a_direction_is_told() {
    struct Leaky(f64);
    impl Glazing for Leaky {
        fn lobes(&self, incident: Direction, out: &mut Lobes) {
            out.clear();
            out.beams.push(Lobe { direction: incident, power: 1.0 - self.0, total_reflections: 0 });
            out.residual = self.0;
        }
        fn scatter(&self, incident: Direction, _: [f64; 3]) -> Scattered {
            Scattered::Leaves { direction: incident, total_reflections: 0 }
        }
    }
    let towards_sun = sun(45.0, 180.0);
    let lit = Vec3::new(2.0, 0.0, 1.8) - 0.5 * towards_sun;
    let found = |residual: f64| {
        let room = Shoebox { reflectances: [0.0; 3], ..Shoebox::reference() };
        let scene = room.builder(Arc::new(Leaky(residual))).build().expect("sound");
        sun_coefficients(&scene, &[lit], &[Vec3::Z], &[towards_sun], 1, &Settings::default(), |_| true)
    };
    let little = found(2.5e-3).expect("few per mille are told, not refused");
    assert!((little.direct.value[0] - 0.9975 * towards_sun.z).abs() < 0.005);
    assert!((little.cut_off[0] - 2.5e-3 * -towards_sun.y).abs() < 3e-5, "{}", little.cut_off[0]);
    assert!(matches!(found(3.5e-3), Err(RoomError::NoLobes { residual, .. }) if (residual - 3.5e-3).abs() < 1e-12));
}

/// Two panes one behind the other, each a window of its own, let through what both together do; a third that turns light lets
/// the sun in through them from either side.
#[test]
fn sun_passes_windows_in_a_row() {
    let black = Shoebox { reflectances: [0.0; 3], ..Shoebox::reference() };
    let pane = |t| -> Arc<dyn Glazing> { Arc::new(ClearGlazing::constant(t).expect("possible")) };
    let turn = || -> Arc<dyn Glazing> { Arc::new(Turner { turned: 1.0 }) };
    let outline = |y: f64| [(-9., -9.), (-9., 9.), (13., 9.), (13., -9.)].map(|(x, z)| Vec3::new(x, y, z));
    let lit = |inner: Arc<dyn Glazing>, outer: Arc<dyn Glazing>| {
        let mut b = black.builder(inner);
        b.window("outer", &outline(-0.5), outer, None, None).expect("sound");
        let scene = b.build().expect("sound");
        let settings = Settings { rounds: 2, ..Settings::default() };
        // where the straight sun falls, and where it goes once its rise is turned about
        let (points, normals) = ([Vec3::new(2.0, 1.5, 0.5), Vec3::new(2.0, 1.5, 2.9)], [-Vec3::Y; 2]);
        let towards = sun(45.0, 180.0);
        let found = sun_coefficients(&scene, &points, &normals, &[towards], 4, &settings, |_| true).expect("beams");
        (found.direct.value, found.redirected.value)
    };
    let cos = sun(45.0, 180.0).dot(-Vec3::Y);
    let (direct, redirected) = lit(pane(0.8), pane(0.5));
    assert!((direct[0] - 0.4 * cos).abs() < 1e-3 && direct[1] == 0.0 && redirected == [0.0; 2], "{direct:?}");
    for (inner, outer) in [(pane(0.8), turn()), (turn(), pane(0.8))] {
        let (direct, redirected) = lit(inner, outer);
        assert!(
            (redirected[1] - 0.8 * cos).abs() < 1e-3 && redirected[0] == 0.0 && direct == [0.0; 2],
            "{redirected:?}"
        );
    }
}
