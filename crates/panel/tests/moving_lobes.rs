//! How lobes move with the light: the differentials of their rays.

use hemisphere::{Direction, Rng, Vec3};
use optics::{Glazing, Lobe, Lobes, MovingLobes};
use panel::{
    Media, Optical, Panel, Polarisation, Sample,
    flux::Limits,
    shape::{LaserCut, Prismatic, Ridges},
};
use std::sync::Arc;

fn panel(profile: panel::Profile, polarisation: Polarisation, most_pieces: u64) -> Panel {
    let media = Media::in_air(&[Optical { n: 1.49, absorption: 0.02 }]).expect("valid media");
    let limits = Limits { tolerance: 1e-5, most_pieces };
    Panel::new(Arc::new(profile), vec![Sample { media, weight: 1.0 }], polarisation, limits).expect("valid panel")
}

fn prism(lower_deg: f64, upper_deg: f64) -> panel::Profile {
    Prismatic { pitch: 1.0, lower_deg, upper_deg, base: 0.7, ridges: Ridges::Front }.profile().expect("valid prisms")
}

fn along([x, y]: [f64; 2], side: f64) -> Direction {
    Direction::of(Vec3::new(x, y, side * (1.0 - x * x - y * y).sqrt())).expect("some length")
}

fn lobes(panel: &Panel, incident: Direction) -> Vec<Lobe> {
    let mut lobes = Lobes::default();
    panel.lobes(incident, &mut lobes);
    lobes.beams
}

/// The lobe of `beams` nearest to a direction, if no other is as near.
fn nearest(beams: &[Lobe], d: Direction) -> Option<Lobe> {
    let mut near = beams.iter().filter(|b| (b.direction.vector() - d.vector()).length() < 1e-4);
    near.next().filter(|_| near.next().is_none()).copied()
}

/// Slopes are what differences of directions tend to: of prisms, of tilted cuts, and of light that the walk has finished.
#[test]
fn slopes_are_those_of_differences() {
    let tilted = LaserCut { cut_tilt_deg: vec![7.0], ..LaserCut::ideal(0.5, 1.0) }.profile().expect("valid cuts");
    let cases =
        [(prism(45.0, 45.0), 100_000), (prism(42.0, 80.0), 100_000), (prism(42.0, 80.0), 30), (tilted, 100_000)];
    let mut rng = Rng::new(5, 0);
    for (profile, most_pieces) in cases {
        let panel = panel(profile, Polarisation::Averaged, most_pieces);
        let (mut moving, mut judged) = (MovingLobes::default(), 0);
        for i in 0..12 {
            let [x, y] = [0, 1].map(|_| 1.3 * (rng.uniform() - 0.5));
            let side = if i % 2 == 0 { 1.0 } else { -1.0 };
            let step = 1e-6;
            let beside = |dx: f64, dy: f64| lobes(&panel, along([x + dx * step, y + dy * step], side));
            let pairs = [[beside(-1.0, 0.0), beside(1.0, 0.0)], [beside(0.0, -1.0), beside(0.0, 1.0)]];
            panel.moving_lobes(along([x, y], side), &mut moving);
            for (beam, slopes) in moving.lobes.beams.iter().zip(&moving.slopes) {
                let d = beam.direction;
                // near grazing differences are no derivatives
                if beam.power < 1e-3 || d.z.abs() < 0.1 {
                    continue;
                }
                // an image keeps x and y but for signs
                let slopes = slopes.unwrap_or([[(d.x / x).signum(), 0.0], [0.0, (d.y / y).signum()]]);
                for ([low, high], slope) in pairs.iter().zip(slopes) {
                    let (Some(low), Some(high)) = (nearest(low, d), nearest(high, d)) else { continue };
                    let found = [high.direction.x - low.direction.x, high.direction.y - low.direction.y];
                    for (found, slope) in found.iter().zip(slope) {
                        let off = (found / (2.0 * step) - slope).abs();
                        assert!(off < 1e-5, "{x} {y} {side} to {d:?}: {slope} is off by {off}");
                    }
                    judged += 1;
                }
            }
        }
        assert!(judged > 60, "{judged}");
    }
}

/// Light that moves is the same light: absorbed and residual shares, and powers by direction, are those of the lobes.
#[test]
fn moving_lobes_hold_the_powers_of_lobes() {
    for (profile, polarisation) in [
        (prism(45.0, 45.0), Polarisation::Resolved),
        (prism(45.0, 80.0), Polarisation::Averaged),
        (LaserCut { cut_width: 0.1, ..LaserCut::ideal(1.0, 1.0) }.profile().expect("valid"), Polarisation::Averaged),
    ] {
        let panel = panel(profile, polarisation, 100_000);
        for (place, side) in [([0.3, -0.4], 1.0), ([0.5, 0.0], 1.0), ([0.0, 0.6], -1.0)] {
            let (mut moving, mut plain) = (MovingLobes::default(), Lobes::default());
            let incident = along(place, side);
            panel.moving_lobes(incident, &mut moving);
            panel.lobes(incident, &mut plain);
            assert_eq!(moving.slopes.len(), moving.lobes.beams.len());
            assert!((moving.lobes.absorbed - plain.absorbed).abs() < 1e-4);
            for beam in plain.beams.iter().filter(|b| b.power > 1e-3) {
                let same = |b: &&Lobe| (b.direction.vector() - beam.direction.vector()).length() < 1e-8;
                let power: f64 = moving.lobes.beams.iter().filter(same).map(|b| b.power).sum();
                assert!((power - beam.power).abs() < 1e-4, "{place:?}: {power} {}", beam.power);
            }
        }
    }
}

/// In its plane of symmetry a prism of equal flanks throws two beams along one direction, which part as the light leaves the plane:
/// two lobes that move, one that does not.
#[test]
fn beams_that_part_are_two() {
    let panel = panel(prism(45.0, 45.0), Polarisation::Averaged, 100_000);
    let incident = along([0.3, 0.0], 1.0);
    let mut moving = MovingLobes::default();
    panel.moving_lobes(incident, &mut moving);
    let parting = lobes(&panel, incident).iter().any(|lobe| {
        let here = moving.lobes.beams.iter().zip(&moving.slopes);
        let same = here.filter(|(b, _)| (b.direction.vector() - lobe.direction.vector()).length() < 1e-8);
        let up = |s: &Option<[[f64; 2]; 2]>| s.map_or(1.0, |s| s[1][1]);
        let slopes: Vec<f64> = same.filter(|(b, _)| b.power > 1e-3).map(|(_, s)| up(s)).collect();
        slopes.len() == 2 && (slopes[0] - slopes[1]).abs() > 0.1
    });
    assert!(parting);
}
