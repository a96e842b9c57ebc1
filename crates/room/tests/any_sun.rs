//! Paths that are kept for any sun, against those that are followed for one.

mod rooms;

use hemisphere::{Direction, Vec3, towards};
use optics::{Glazing, Lobe, Lobes, Scattered};
use room::{AnySun, Material, Scene, Settings, SunCoefficients, sun_coefficients};
use rooms::{Shoebox, assert_estimate};
use std::f64::consts::{PI, TAU};
use std::sync::Arc;

/// Passes 30 % straight on, turns 40 % up by a total reflection, spreads 20 % evenly.
struct Mixed;

impl Mixed {
    const SPREAD: f64 = 0.2;
}

impl Glazing for Mixed {
    fn lobes(&self, incident: Direction, out: &mut Lobes) {
        out.clear();
        let turned = incident.mirrored(Direction::from_unit(Vec3::Y));
        out.beams.push(Lobe { direction: incident, power: 0.3, total_reflections: 0 });
        out.beams.push(Lobe { direction: turned, power: 0.4, total_reflections: 1 });
        (out.spread, out.absorbed) = (Self::SPREAD, 0.1);
    }

    fn scatter(&self, incident: Direction, u: [f64; 3]) -> Scattered {
        let direction = if u[0] < 0.3 {
            incident
        } else if u[0] < 0.7 {
            incident.mirrored(Direction::from_unit(Vec3::Y))
        } else if u[0] < 0.9 {
            let (r, angle) = (u[1].sqrt(), TAU * u[2]);
            Direction::from_unit(Vec3::new(r * angle.cos(), r * angle.sin(), (1.0 - u[1]).sqrt() * incident.z.signum()))
        } else {
            return Scattered::Absorbed;
        };
        Scattered::Leaves { direction, total_reflections: u16::from((0.3..0.7).contains(&u[0])) }
    }

    fn bsdf(&self, incident: Direction, outgoing: Direction) -> f64 {
        if incident.z * outgoing.z > 0.0 { Self::SPREAD / PI } else { 0.0 }
    }

    fn spreads(&self) -> bool {
        true
    }
}

/// The reference room with such a window and a shelf that mirrors.
fn mixed_room() -> Scene {
    let mut builder = Shoebox::reference().builder(Arc::new(Mixed));
    let shelf = [(0.5, 0.1), (3.5, 0.1), (3.5, 0.9), (0.5, 0.9)].map(|(x, y)| Vec3::new(x, y, 1.8));
    builder.polygon("shelf", &shelf, &[], Material { diffuse: 0.1, specular: 0.8 }).expect("sound");
    builder.build().expect("sound")
}

const SUNS: [[f64; 2]; 3] = [[35.0, 180.0], [60.0, 140.0], [20.0, 230.0]];

fn sun([altitude_deg, azimuth_deg]: [f64; 2]) -> Vec3 {
    towards(altitude_deg.to_radians(), azimuth_deg.to_radians())
}

fn one_sun(scene: &Scene, points: &[Vec3], normals: &[Vec3], at: [f64; 2], settings: &Settings) -> SunCoefficients {
    sun_coefficients(scene, points, normals, &[sun(at)], 1, settings, |_| true).expect("sound")
}

/// Rounds that are kept are those of the coefficients of the same seed, sun by sun and part by part.
#[test]
fn kept_rounds_are_those_of_the_coefficients() {
    let scene = mixed_room();
    // half look up, half look down from under the ceiling, at what is turned
    let (mut points, mut normals) = Shoebox::reference().work_plane(0.8, 1.0);
    points.extend(Shoebox::reference().work_plane(2.9, 1.0).0);
    normals.resize(points.len(), -Vec3::Z);
    let settings = Settings { rounds: 2, nodes: 200, any_sun: true, ..Settings::default() };
    let kept = AnySun::new(&scene, &points, &normals, &[3, 4], &settings).expect("sound");
    assert!(kept.rounds() == 4 && kept.bytes() > 200 * points.len() * 8 * 4);
    for at in SUNS {
        for (number, seed) in [3, 4].into_iter().enumerate() {
            let towards = Direction::of(sun(at)).expect("finite");
            let rounds = kept.light(&scene, towards, 2 * number..2 * number + 2).expect("sound");
            let found = one_sun(&scene, &points, &normals, at, &Settings { seed, ..settings.clone() });
            for (part, of_part) in [&found.direct, &found.redirected, &found.interreflected].into_iter().enumerate() {
                let most = of_part.value.iter().copied().fold(0.0, f64::max);
                assert!(most > 0.0, "{at:?}: no light in part {part}");
                for (sensor, value) in of_part.value.iter().enumerate() {
                    let mean = 0.5 * (rounds[0][sensor][part] + rounds[1][sensor][part]);
                    assert!((mean - value).abs() < 1e-12 * most, "{at:?} {part} {sensor}: {mean} {value}");
                }
            }
        }
    }
}

/// Nodes laid for any sun and nodes laid for this one give the same light.
#[test]
fn where_nodes_are_laid_does_not_matter() {
    let scene = mixed_room();
    let (points, normals) = ([Vec3::new(2.0, 3.0, 0.8), Vec3::new(1.0, 6.0, 0.8)], [Vec3::Z; 2]);
    for at in SUNS {
        let found = |any_sun, seed| {
            let settings = Settings { rounds: 48, nodes: 1024, any_sun, seed, ..Settings::default() };
            one_sun(&scene, &points, &normals, at, &settings).interreflected
        };
        let (any, own) = (found(true, 1), found(false, 2));
        for sensor in 0..points.len() {
            let error = any.standard_error[sensor].hypot(own.standard_error[sensor]);
            let expected = own.value[sensor];
            assert_estimate(&format!("{at:?}"), any.value[sensor], error, expected, 0.03 * expected);
        }
    }
}
