//! Prisms of odd angles between and behind panes: beams and walk together are what rays through the layers find.

use hemisphere::{Direction, Rng};
use optics::{ClearGlazing, Glazing, LitLobes, Lobes, PolarisedLobes, Scattered, Side, Stack, StackLobes, has_lobes};
use panel::flux::Limits;
use panel::shape::{LaserCut, Prismatic, Ridges};
use panel::{Finish, Media, Optical, Panel, Polarisation, Profile, Sample, incident_direction};
use std::sync::Arc;

const BINS_A_TURN: f64 = 72.0;

fn panel(profile: Profile) -> Arc<Panel> {
    let media = Media::in_air(&[Optical { n: 1.49, absorption: 0.004 }]).expect("a medium");
    let limits = Limits { tolerance: 1e-5, most_pieces: 100_000 };
    let spectrum = vec![Sample { media, weight: 1.0 }];
    Arc::new(Panel::new(Arc::new(profile), spectrum, Polarisation::Resolved, limits).expect("a panel"))
}

fn prism(lower_deg: f64, upper_deg: f64) -> Arc<Panel> {
    let prism = Prismatic { pitch: 2.0, lower_deg, upper_deg, base: 3.0, ridges: Ridges::Front };
    panel(prism.profile().expect("a profile"))
}

fn laser_cut() -> Arc<Panel> {
    let cut = LaserCut {
        spacing: vec![4.0],
        thickness: 6.0,
        cut_width: 0.0,
        cut_tilt_deg: vec![0.0],
        cut_depth: None,
        cut_radius: None,
        finish: Finish { slope: 0.0, diffuse: 0.0 },
    };
    panel(cut.profile().expect("a profile"))
}

fn pane() -> Arc<dyn Glazing> {
    Arc::new(ClearGlazing::slab(1.52, 4.0, 0.01).expect("a slab"))
}

fn stack(layers: Vec<Arc<dyn Glazing>>) -> Stack {
    Stack::new(layers).expect("layers")
}

fn from(elevation_deg: f64, azimuth_deg: f64, side: Side) -> Direction {
    incident_direction(elevation_deg.to_radians(), azimuth_deg.to_radians(), side)
}

/// Whole power and what is unknown of it.
fn whole(found: &StackLobes) -> f64 {
    let leaves: f64 = found.beams.iter().map(|b| b.stokes[0]).sum();
    leaves + found.absorptance.iter().sum::<f64>() + found.residual
}

/// Which 5° of a turn about the cuts light leaves along.
fn bin(direction: Direction) -> usize {
    ((direction.y.atan2(direction.z) / std::f64::consts::TAU).rem_euclid(1.0) * BINS_A_TURN) as usize
}

/// Rays drawn through the layers, independent of every beam and of the walk that finishes: by bins of directions, and what is absorbed.
#[test]
fn beams_are_what_rays_find() {
    let rays = 60_000;
    let cases: [(Vec<Arc<dyn Glazing>>, Direction); 4] = [
        (vec![pane(), prism(45.0, 80.0)], from(35.0, 20.0, Side::Front)),
        (vec![prism(60.0, 20.0), pane()], from(60.0, -30.0, Side::Front)),
        (vec![pane(), prism(45.0, 80.0), pane()], from(20.0, 0.0, Side::Back)),
        (vec![prism(42.0, 5.0), prism(60.0, 20.0)], from(10.0, 50.0, Side::Front)),
    ];
    for (layers, incident) in cases {
        let stack = stack(layers);
        let found = stack.outcome(incident);
        assert!((whole(&found) - 1.0).abs() < 1e-11, "{}", whole(&found));
        assert!(found.residual.abs() < 5e-4 && found.absorptance.iter().all(|&a| a > 0.0));
        assert!(found.walked > 1e-3 && found.walked_variance.sqrt() < 3e-4);
        let mut rng = Rng::new(3, found.beams.len() as u64);
        let mut drawn = vec![0.0; BINS_A_TURN as usize + 1];
        for _ in 0..rays {
            let u = std::array::from_fn(|_| rng.uniform());
            match stack.scatter(incident, u) {
                Scattered::Leaves { direction, .. } => drawn[bin(direction)] += 1.0 / f64::from(rays),
                Scattered::Absorbed => drawn[BINS_A_TURN as usize] += 1.0 / f64::from(rays),
            }
        }
        let mut known = vec![0.0; BINS_A_TURN as usize + 1];
        found.beams.iter().for_each(|b| known[bin(b.direction)] += b.stokes[0]);
        known[BINS_A_TURN as usize] = found.absorptance.iter().sum();
        for (i, (p, q)) in known.iter().zip(&drawn).enumerate() {
            // the variance by what is known, and one ray more for rare ones
            let variance = (p + 1.0 / f64::from(rays)) / f64::from(rays) + found.walked_variance;
            let z = ((p - q).abs() - found.residual.abs()) / variance.sqrt();
            assert!(z < 4.5, "bin {i}: {p} and {q}, {z} standard errors");
        }
    }
}

/// A panel that says it sends light into very many directions.
struct Pretender(Arc<Panel>);

impl Glazing for Pretender {
    fn lobes(&self, incident: Direction, out: &mut Lobes) {
        self.0.lobes(incident, out);
    }

    fn scatter(&self, incident: Direction, u: [f64; 3]) -> Scattered {
        self.0.scatter(incident, u)
    }

    fn polarised_lobes(&self, incident: Direction, out: &mut PolarisedLobes) {
        self.0.polarised_lobes(incident, out);
    }

    fn lit_lobes(&self, incident: Direction, polarisation: [f64; 3], out: &mut LitLobes) {
        self.0.lit_lobes(incident, polarisation, out);
        let Some(&first) = out.beams.first() else { return };
        let dark = optics::LitLobe { stokes: [0.0; 4], ..first };
        out.beams.extend([dark; 20]);
    }

    fn polarised_scatter(&self, incident: Direction, polarisation: [f64; 3], u: [f64; 3]) -> (Scattered, [f64; 3]) {
        self.0.polarised_scatter(incident, polarisation, u)
    }
}

/// Where light has few directions all of it is followed; asked for strong light alone and walked, it goes the same ways.
#[test]
fn the_walk_finds_what_following_finds() {
    for panel in [prism(45.0, 45.0), laser_cut()] {
        let exact = stack(vec![pane(), panel.clone(), pane()]);
        let walked = stack(vec![pane(), Arc::new(Pretender(panel)), pane()]);
        for incident in [from(35.0, 20.0, Side::Front), from(-50.0, 40.0, Side::Back), from(20.0, 0.0, Side::Front)] {
            let (a, b) = (exact.outcome(incident), walked.outcome(incident));
            assert!(a.walked == 0.0 && b.walked > 3e-3, "{} {}", a.walked, b.walked);
            assert!((whole(&b) - 1.0).abs() < 1e-11);
            let unknown = 4.5 * b.walked_variance.sqrt() + a.residual.abs() + b.residual.abs();
            let of = |found: &StackLobes, d: Direction| -> f64 {
                let same = |b: &&optics::LitLobe| (b.direction.vector() - d.vector()).length_squared() < 1e-16;
                found.beams.iter().filter(same).map(|b| b.stokes[0]).sum()
            };
            for beam in a.beams.iter().chain(&b.beams) {
                let (p, q) = (of(&a, beam.direction), of(&b, beam.direction));
                assert!((p - q).abs() < unknown, "{p} {q} {unknown}");
            }
            for (p, q) in a.absorptance.iter().zip(&b.absorptance) {
                assert!((p - q).abs() < unknown, "{p} {q} {unknown}");
            }
        }
    }
}

/// Light of one polarisation, asked for alone, goes where the matrices of light of any send it.
#[test]
fn one_polarisation_alone_is_what_matrices_say() {
    let panel = prism(45.0, 45.0);
    let (mut matrices, mut said, mut alone) = (PolarisedLobes::default(), LitLobes::default(), LitLobes::default());
    for incident in [from(30.0, 40.0, Side::Front), from(-20.0, 10.0, Side::Back)] {
        let polarisation = [0.4, -0.3, 0.2];
        panel.polarised_lobes(incident, &mut matrices);
        matrices.lit(polarisation, &mut said);
        panel.lit_lobes(incident, polarisation, &mut alone);
        assert!((said.absorbed - alone.absorbed).abs() < 3e-5);
        for beam in &said.beams {
            let near = |b: &&optics::LitLobe| b.direction.dot(*beam.direction) > 1.0 - 1e-14;
            let same = alone.beams.iter().find(near).expect("the same beams");
            for (p, q) in beam.stokes.iter().zip(same.stokes) {
                assert!((p - q).abs() < 3e-5, "{p} {q}");
            }
        }
    }
}

/// What a room gets: the same light in fewer beams, none of which is further than a cell from where its light goes.
#[test]
fn a_room_gets_the_same_light_in_fewer_beams() {
    let stack = stack(vec![prism(45.0, 80.0), pane()]);
    let incident = from(35.0, 20.0, Side::Front);
    let (found, mut lobes) = (stack.outcome(incident), Lobes::default());
    stack.lobes(incident, &mut lobes);
    assert!(found.beams.len() > 1000 && lobes.beams.len() < 700, "{} {}", found.beams.len(), lobes.beams.len());
    assert!((lobes.walked - found.walked).abs() < 1e-15 && lobes.beams.is_sorted_by(|a, b| a.power >= b.power));
    for (through, turned) in [(true, true), (true, false), (false, true), (false, false)] {
        let sums = |beams: &mut dyn Iterator<Item = (Direction, f64, u16)>| {
            let chosen = beams.filter(|(d, _, count)| (d.z > 0.0) == through && (*count > 0) == turned);
            chosen.fold([0.0; 3], |[power, x, y], (d, p, _)| [power + p, x + p * d.x, y + p * d.y])
        };
        let before = sums(&mut found.beams.iter().map(|b| (b.direction, b.stokes[0], b.total_reflections)));
        let after = sums(&mut lobes.beams.iter().map(|b| (b.direction, b.power, b.total_reflections)));
        for (a, b) in before.iter().zip(after) {
            assert!((a - b).abs() < 1e-12, "{a} {b}");
        }
    }
    // every beam has one near it, and strong ones stay where they are
    for beam in &found.beams {
        let nearest = lobes
            .beams
            .iter()
            .map(|b| (b.direction.vector() - beam.direction.vector()).length())
            .fold(f64::MAX, f64::min);
        let allowed = if beam.stokes[0] > 1e-3 { 1e-12 } else { 0.4_f64.to_radians() * 1.01 };
        assert!(nearest <= allowed, "{nearest} from a beam of {}", beam.stokes[0]);
    }
    // averages over patches take it for what is drawn
    assert!(!has_lobes(&stack) && has_lobes(&*prism(45.0, 45.0)));
}
