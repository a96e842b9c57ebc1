//! A panel as a room sees it: exact lobes, and directions drawn in proportion to power.

use crate::{
    media::Optical,
    panel::{Beam, Outcome, Panel, Polarisation, SAME_DIRECTION, Sample, Workspace, is_across_the_cuts},
    walk::{Draw, End},
};
use hemisphere::Direction;
use optics::{
    Glazing, LitLobe, LitLobes, Lobe, Lobes, MovingLobes, Mueller, PolarisedLobe, PolarisedLobes, Scattered, Stokes,
    Straight, formulas::slab, stays_image,
};
use std::cell::RefCell;

thread_local! {
    static WORKSPACE: RefCell<Workspace> = RefCell::default();
}

impl Glazing for Panel {
    /// A rough panel has no lobes: all its light is residual here, and [`Glazing::scatter`] follows it.
    fn lobes(&self, incident: Direction, out: &mut Lobes) {
        out.clear();
        let outcome = WORKSPACE.with_borrow_mut(|workspace| self.outcome(incident, workspace));
        let Ok(outcome) = outcome else {
            out.residual = 1.0;
            return;
        };
        fill(&outcome, out);
    }

    /// One solution: the differential of each ray goes along with it.
    fn moving_lobes(&self, incident: Direction, out: &mut MovingLobes) {
        out.clear();
        let outcome = WORKSPACE.with_borrow_mut(|workspace| self.moving_outcome(incident, workspace));
        let Ok(outcome) = outcome else {
            out.lobes.residual = 1.0;
            return;
        };
        let slopes = |b: &Beam| b.slopes.filter(|&slopes| !stays_image(incident, b.direction, slopes));
        out.slopes.extend(outcome.beams.iter().map(slopes));
        fill(&outcome, &mut out.lobes);
    }

    fn scatter(&self, incident: Direction, u: [f64; 3]) -> Scattered {
        self.polarised_scatter(incident, [0.0; 3], u).0
    }

    fn straight(&self, incident: Direction) -> Option<Straight> {
        self.straight_s_p(incident).map(|[s, p]| Straight {
            transmittance: 0.5 * (s.transmittance + p.transmittance),
            reflectance: 0.5 * (s.reflectance + p.reflectance),
        })
    }

    /// A plain pane turns no light: its shares in closed form.
    fn straight_s_p(&self, incident: Direction) -> Option<[Straight; 2]> {
        let (thickness, medium) = self.profile().pane()?;
        let by_formula = match self.polarisation() {
            Polarisation::Averaged => [optics::formulas::Polarisation::Averaged; 2],
            Polarisation::Resolved => [optics::formulas::Polarisation::S, optics::formulas::Polarisation::P],
        };
        Some(by_formula.map(|polarisation| {
            let mut sum = Straight { transmittance: 0.0, reflectance: 0.0 };
            for Sample { media, weight } in self.spectrum() {
                let Optical { n, absorption } = media.get(medium);
                let shares = slab(incident.z.abs(), n, absorption * thickness, polarisation);
                sum.transmittance += weight * shares.transmittance;
                sum.reflectance += weight * shares.reflectance;
            }
            sum
        }))
    }

    fn polarised_lobes(&self, incident: Direction, out: &mut PolarisedLobes) {
        let mut lobes = Lobes::default();
        let wave = |light: Stokes| WORKSPACE.with_borrow_mut(|w| self.outcome_of((incident, light), w)).ok();
        let (Polarisation::Resolved, Some(plain)) = (self.polarisation(), wave([1.0, 0.0, 0.0, 0.0])) else {
            self.lobes(incident, &mut lobes);
            return out.depolarised(&lobes);
        };
        out.beams.clear();
        out.residual = plain.residual;
        let of = |b: &Beam| PolarisedLobe {
            direction: b.direction,
            mueller: Mueller(b.stokes.map(|power| [power, 0.0, 0.0, 0.0])),
            total_reflections: b.total_reflections,
        };
        out.beams.extend(plain.beams.iter().map(of));
        // the other columns: of light polarised fully, less that of unpolarised light
        let columns = if is_across_the_cuts(incident) { 1..2 } else { 1..4 };
        for k in columns {
            let mut light = [1.0, 0.0, 0.0, 0.0];
            light[k] = 1.0;
            let Some(found) = wave(light) else { continue };
            for beam in &mut out.beams {
                let is_same =
                    |b: &&Beam| (b.direction.vector() - beam.direction.vector()).length_squared() < SAME_DIRECTION;
                let stokes = found.beams.iter().find(is_same).map_or([0.0; 4], |b| b.stokes);
                for (row, x) in beam.mueller.0.iter_mut().zip(stokes) {
                    row[k] = x - row[0];
                }
            }
        }
    }

    fn lit_lobes(&self, incident: Direction, [q, u, v]: [f64; 3], out: &mut LitLobes) {
        *out = LitLobes::default();
        let light = [1.0, q, u, v];
        let Ok(found) = WORKSPACE.with_borrow_mut(|workspace| self.outcome_of((incident, light), workspace)) else {
            out.residual = 1.0;
            return;
        };
        let lobe =
            |b: &Beam| LitLobe { direction: b.direction, stokes: b.stokes, total_reflections: b.total_reflections };
        out.beams.extend(found.beams.iter().map(lobe));
        (out.absorbed, out.residual) = (found.absorbed, found.residual);
    }

    fn polarised_scatter(&self, incident: Direction, polarisation: [f64; 3], u: [f64; 3]) -> (Scattered, [f64; 3]) {
        // one number chooses the wavelength; what is left of it is as good as new
        let (mut left, mut chosen) = (u[0], 0);
        while chosen + 1 < self.walks().len() && left >= self.walks()[chosen].1 {
            left -= self.walks()[chosen].1;
            chosen += 1;
        }
        let (walk, weight) = &self.walks()[chosen];
        let mut draw = Draw::given([(left / weight).clamp(0.0, 1.0 - f64::EPSILON), u[1], u[2]]);
        match walk.run_polarised(incident, polarisation, &mut draw) {
            (End::Leaves { direction, total_reflections, weight }, after) if draw.uniform() < weight => {
                let direction = Direction::from_unit(direction.normalize());
                (Scattered::Leaves { direction, total_reflections }, after)
            }
            _ => (Scattered::Absorbed, [0.0; 3]),
        }
    }
}

fn fill(outcome: &Outcome, out: &mut Lobes) {
    let lobe = |b: &Beam| Lobe { direction: b.direction, power: b.stokes[0], total_reflections: b.total_reflections };
    out.beams.extend(outcome.beams.iter().map(lobe));
    (out.absorbed, out.residual) = (outcome.absorbed, outcome.residual);
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Media, Profile, flux::Limits, shape::LaserCut, shape::pane};
    use hemisphere::{Rng, Vec3};
    use optics::{ClearGlazing, Stack};
    use std::sync::Arc;

    const ACRYLIC: Optical = Optical { n: 1.49, absorption: 0.01 };

    fn panel(profile: Profile) -> Panel {
        let media = Media::in_air(&[ACRYLIC]).expect("a medium");
        let spectrum = vec![Sample { media, weight: 1.0 }];
        Panel::new(Arc::new(profile), spectrum, Polarisation::Resolved, Limits::default()).expect("a panel")
    }

    fn laser_cut() -> Panel {
        let cut = LaserCut {
            spacing: vec![4.0],
            thickness: 6.0,
            cut_width: 0.3,
            cut_tilt_deg: vec![0.0],
            cut_depth: None,
            cut_radius: None,
            finish: crate::Finish { slope: 0.0, diffuse: 0.0 },
        };
        panel(cut.profile().expect("a profile"))
    }

    fn along(x: f64, y: f64, z: f64) -> Direction {
        Direction::of(Vec3::new(x, y, z)).expect("some length")
    }

    /// A pane drawn as a profile is the pane by formula: alone, and what the solver finds of polarised light.
    #[test]
    fn a_drawn_pane_is_the_formula() {
        let (drawn, formula) =
            (panel(pane(4.0).expect("a pane")), ClearGlazing::slab(1.49, 4.0, 0.01).expect("a slab"));
        for d in [along(0.0, 0.0, 1.0), along(0.3, -0.8, 0.4), along(-0.5, 0.1, -0.9), along(0.0, -2.0, 1.0)] {
            assert_eq!(drawn.straight_s_p(d), formula.straight_s_p(d));
            let (mut a, mut b) = (PolarisedLobes::default(), PolarisedLobes::default());
            drawn.polarised_lobes(d, &mut a);
            formula.polarised_lobes(d, &mut b);
            // in the plane across the cuts the last two parameters are left out
            let known = if is_across_the_cuts(d) { 2 } else { 4 };
            for beam in &b.beams {
                let found = a.beams.iter().find(|x| x.direction.dot(*beam.direction) > 1.0 - 1e-12).expect("a beam");
                for i in 0..known {
                    for j in 0..known {
                        let off = (found.mueller.0[i][j] - beam.mueller.0[i][j]).abs();
                        assert!(off < 1e-5, "{d:?} {i} {j}: {off}");
                    }
                }
            }
        }
        assert!(laser_cut().straight(along(0.0, -0.5, 1.0)).is_none());
    }

    /// A laser-cut panel between panes, in a skew plane: draws carry polarisation from layer to layer as the beams do.
    #[test]
    fn draws_through_a_stack_follow_its_beams() {
        let glass = || -> Arc<dyn Glazing> { Arc::new(panel(pane(4.0).expect("a pane"))) };
        let layers = || -> Vec<Arc<dyn Glazing>> { vec![glass(), Arc::new(laser_cut()), glass()] };
        let stack = Stack::new(layers()).expect("layers");
        let d = along(0.9, -1.3, 0.8);
        let found = stack.outcome(d);
        let whole: f64 = found.beams.iter().map(|b| b.stokes[0]).sum::<f64>() + found.absorptance.iter().sum::<f64>();
        assert!((whole + found.residual - 1.0).abs() < 1e-9 && found.residual < 1e-5);
        assert_eq!(found.beams.len(), 4);
        let mut rng = Rng::new(11, 0);
        let n = 400_000;
        let mut counts = [0.0; 4];
        for _ in 0..n {
            let u = std::array::from_fn(|_| rng.uniform());
            if let Scattered::Leaves { direction, .. } = stack.scatter(d, u) {
                let same = |b: &optics::LitLobe| (b.direction.vector() - direction.vector()).length_squared() < 1e-16;
                counts[found.beams.iter().position(same).expect("a known beam")] += 1.0;
            }
        }
        let averaged = Stack::spectral(vec![(layers(), 1.0)], false).expect("layers").outcome(d);
        let mut furthest = 0.0_f64;
        for (beam, count) in found.beams.iter().zip(counts) {
            let (p, n) = (beam.stokes[0], f64::from(n));
            let sigma = (p * (1.0 - p) / n).sqrt();
            assert!((count / n - p).abs() < 4.5 * sigma + 1e-5, "{p} {}", count / n);
            let same = |b: &&optics::LitLobe| (b.direction.vector() - beam.direction.vector()).length_squared() < 1e-16;
            let without = averaged.beams.iter().find(same).expect("the same beams").stokes[0];
            furthest = furthest.max((without - p).abs() / sigma);
        }
        // unpolarised between layers would have been found out
        assert!(furthest > 10.0, "{furthest}");
    }
}
