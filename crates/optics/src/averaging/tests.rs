//! Laws of averages over cells: closed accounts, reciprocity, images, and agreement with what was averaged.

use super::*;
use crate::{Block, Blocks, Bsdf, ClearGlazing, Lobe, Matrix, Scattered, Tree};
use hemisphere::{KlemsBasis, Rng};
use std::f64::consts::PI;

fn klems(name: &str) -> Cells {
    Cells::Klems(KlemsBasis::named(name).expect("known"))
}

/// A sheet that throws what passes up by a fixed step of the sine from either side, as a grating would, so that its lobes move
/// across cells. What its back mirrors it may dim.
struct Grating {
    step: f64,
    absorbed_behind: f64,
}

impl Grating {
    /// The other end of the way of light that passes: what comes back from there is thrown up to where it came from.
    fn partner(&self, d: Direction) -> Option<Direction> {
        let y = d.y + self.step;
        let z2 = 1.0 - d.x * d.x - y * y;
        (z2 > 1e-12).then(|| Direction::from_unit(Vec3::new(d.x, y, z2.sqrt().copysign(d.z))))
    }
}

impl Glazing for Grating {
    fn lobes(&self, incident: Direction, out: &mut Lobes) {
        out.clear();
        let kept = if incident.z < 0.0 { 1.0 - self.absorbed_behind } else { 1.0 };
        let mut beam = |direction, power| out.beams.push(Lobe { direction, power, total_reflections: 0 });
        match self.partner(incident) {
            // as much passes whichever end the light comes from, and what is mirrored is thrown up as well
            Some(direction) => {
                let passed = 0.8 * (incident.z * direction.z).abs();
                let mirrored = Direction::from_unit(direction.vector() * Vec3::new(1.0, 1.0, -1.0));
                beam(direction, passed);
                beam(mirrored, (1.0 - passed) * kept);
            }
            None => beam(-incident, kept),
        }
        out.absorbed = 1.0 - out.beams.iter().map(|beam| beam.power).sum::<f64>();
    }

    fn scatter(&self, incident: Direction, u: [f64; 3]) -> Scattered {
        let mut lobes = Lobes::default();
        self.lobes(incident, &mut lobes);
        let mut left = u[0];
        let hit = lobes.beams.iter().find(|beam| {
            left -= beam.power;
            left < 0.0
        });
        hit.map_or(Scattered::Absorbed, |b| Scattered::Leaves { direction: b.direction, total_reflections: 0 })
    }
}

const ALL: [(Side, Way); 4] = [
    (Side::Front, Way::Transmission),
    (Side::Front, Way::Reflection),
    (Side::Back, Way::Transmission),
    (Side::Back, Way::Reflection),
];

/// Largest departure of T + R + A from 1 in any column, and of a block from its partner turned round, A being that of the lobes.
fn laws(exchange: &Exchange) -> (f64, f64) {
    let cells = exchange.cells();
    let count = cells.count();
    let tables: Vec<Vec<f64>> = ALL.iter().map(|&(side, way)| exchange.table(side, way)).collect();
    let (mut energy, mut reciprocity) = (0.0_f64, 0.0_f64);
    for (side, pair) in tables.chunks(2).enumerate() {
        for i in 0..count {
            let out: f64 = (0..count).map(|o| cells.size(o) * (pair[0][o * count + i] + pair[1][o * count + i])).sum();
            let departure = (out + exchange.absorbed[side * count + i] - 1.0).abs();
            energy = energy.max(departure).max(exchange.misfit);
        }
    }
    for o in 0..count {
        for i in 0..count {
            let turned = cells.turned(i) * count + cells.turned(o);
            for (one, other) in [(0, 2), (1, 1), (3, 3)] {
                reciprocity = reciprocity.max((tables[one][o * count + i] - tables[other][turned]).abs());
            }
        }
    }
    (energy, reciprocity)
}

/// Energy closes to 1e-9 in every column and reciprocity holds to rounding, for a lossless element whose lobes wander, an
/// absorbing pane and an opening, in patches and in squares.
#[test]
fn energy_and_reciprocity_hold_at_once() {
    let pane = ClearGlazing::slab(1.52, 6.0, 0.02).expect("possible");
    let grating = Grating { step: 0.37, absorbed_behind: 0.0 };
    for (k, glazing) in [&grating as &dyn Glazing, &pane, &ClearGlazing::open()].into_iter().enumerate() {
        for cells in [klems("klems_full"), klems("klems_quarter"), Cells::Grid(3)] {
            let exchange = Exchange::of(glazing, cells, &Averaging::default());
            let (energy, reciprocity) = laws(&exchange);
            assert!(energy < 1e-9, "{k}: {energy}");
            assert!(reciprocity < 1e-10, "{k}: {reciprocity}");
            let (correction, asymmetry) = (exchange.correction, exchange.asymmetry);
            // both are errors of quadrature, the larger where the grating's lobe ends and light turns back
            assert!(correction < 0.03 && asymmetry < 0.05, "{k}: {correction} {asymmetry}");
            if k != 1 {
                assert!(exchange.absorbed.iter().all(|a| a.abs() < 1e-9), "{k} is lossless");
            }
        }
    }
}

/// Moving lobes are shared by the cells they cross as brute force has it: 40 000 places in each of a few patches.
#[test]
fn columns_agree_with_brute_force() {
    let glazing = Grating { step: 0.37, absorbed_behind: 0.0 };
    let exchange = Exchange::of(&glazing, klems("klems_full"), &Averaging::default());
    let cells = exchange.cells();
    let (count, mut lobes) = (cells.count(), Lobes::default());
    let table = exchange.table(Side::Front, Way::Transmission);
    for i in [0, 3, 20, 60, 100, 128, 140] {
        let mut brute = vec![0.0; count];
        let n = 200;
        for k in 0..n * n {
            let [x, y] = cells.place(i, [k / n, k % n].map(|m| (m as f64 + 0.5) / n as f64));
            glazing.lobes(Direction::from_unit(Vec3::new(x, y, (1.0 - x * x - y * y).sqrt())), &mut lobes);
            for lobe in lobes.beams.iter().filter(|lobe| lobe.direction.z > 0.0) {
                brute[cells.find(lobe.direction.x, lobe.direction.y)] += lobe.power / (n * n) as f64;
            }
        }
        let off: f64 = (0..count).map(|o| (brute[o] - table[o * count + i] * cells.size(o)).abs()).sum();
        assert!(off < 0.006, "{i}: {off}");
    }
}

/// A pane's hemispherical shares are its own, averaged; its columns are peaks on the diagonal.
#[test]
fn panes_are_diagonal() {
    let pane = ClearGlazing::slab(1.52, 6.0, 0.0).expect("possible");
    let exchange = Exchange::of(&pane, klems("klems_full"), &Averaging::default());
    for (o, i, value) in exchange.block(Side::Front, Way::Transmission) {
        assert_eq!(o, i);
        let cells = exchange.cells();
        let n = 400;
        let mean: f64 = (0..n)
            .map(|k| {
                let [x, y] = cells.place(i, [(f64::from(k) + 0.5) / f64::from(n), 0.5]);
                let d = Direction::from_unit(Vec3::new(x, y, (1.0 - x * x - y * y).sqrt()));
                pane.straight(d).expect("clear").transmittance
            })
            .sum::<f64>()
            / f64::from(n);
        assert!((value * cells.size(i) - mean).abs() < 1e-4, "{i}");
    }
}

/// Turned upside down, the blocks are those with y turned round; turned inside out, front and back are exchanged.
#[test]
fn turned_elements_have_turned_blocks() {
    struct Turned<'a>(&'a Grating, Vec3);
    impl Glazing for Turned<'_> {
        fn lobes(&self, incident: Direction, out: &mut Lobes) {
            self.0.lobes(Direction::from_unit(incident.vector() * self.1), out);
            for beam in &mut out.beams {
                beam.direction = Direction::from_unit(beam.direction.vector() * self.1);
            }
        }
        fn scatter(&self, _: Direction, _: [f64; 3]) -> Scattered {
            Scattered::Absorbed
        }
    }
    let grating = Grating { step: 0.37, absorbed_behind: 0.4 };
    let of = |turn: Vec3| Exchange::of(&Turned(&grating, turn), klems("klems_half"), &Averaging::default());
    let plain = of(Vec3::ONE);
    let basis = plain.cells();
    let count = basis.count();
    let flipped = |p: usize| basis.turned(basis.mirrored_in_x(p));
    let down = of(Vec3::new(1.0, -1.0, 1.0)).table(Side::Front, Way::Transmission);
    let inside_out = of(Vec3::new(1.0, 1.0, -1.0));
    for way in [Way::Transmission, Way::Reflection] {
        let (was, is) = (plain.table(Side::Back, way), inside_out.table(Side::Front, way));
        assert!(was.iter().zip(&is).all(|(a, b)| (a - b).abs() < 1e-9));
    }
    let mirrored = |side| plain.block(side, Way::Reflection).map(|e| e.2).sum::<f64>();
    assert!(mirrored(Side::Back) < 0.7 * mirrored(Side::Front));
    let front = plain.table(Side::Front, Way::Transmission);
    let (mut largest, mut upright) = (0.0_f64, 0.0_f64);
    for i in 0..count {
        let off = |other: &dyn Fn(usize) -> f64| -> f64 {
            (0..count).map(|o| (front[o * count + i] - other(o)).abs() * basis.size(o)).sum()
        };
        let upside = off(&|o| down[flipped(o) * count + flipped(i)]);
        assert!(upside < 0.02, "{i}: {upside}");
        upright = upright.max(off(&|o| down[o * count + i]));
        largest = largest.max((0..count).map(|o| front[o * count + i] * basis.size(o)).sum());
    }
    // and it does matter which way up it is
    assert!(largest > 0.5 && upright > 0.5);
}

/// A tree on a grid sends out as much as it was given, and less than the full grid is ever held.
#[test]
fn trees_hold_what_was_averaged() {
    let grating = Grating { step: 0.37, absorbed_behind: 0.0 };
    let exchange = Exchange::of(&grating, Cells::Grid(4), &Averaging::default());
    let walk = exchange.tree(Side::Front, Way::Transmission, 0.0).expect("a grid");
    assert!(walk.len() < 16_usize.pow(4) / 4, "{}", walk.len());
    let tree = Tree::from_preorder(4, &walk).expect("sound");
    let cells = exchange.cells();
    for i in 0..cells.count() {
        let at = cells.place(i, [0.5, 0.5]);
        let sum: f64 =
            exchange.block(Side::Front, Way::Transmission).filter(|e| e.1 == i).map(|e| e.2 * cells.size(e.0)).sum();
        assert!((tree.hemispherical(at) - sum).abs() < 1e-12);
    }
    assert!(exchange.tree(Side::Front, Way::Reflection, 0.0).is_some());
}

/// What has no lobes is drawn: the means agree with the element's own matrix within their standard errors.
#[test]
fn spread_light_is_drawn_with_standard_errors() {
    let basis = KlemsBasis::named("klems_quarter").expect("known");
    let n = basis.patches();
    let mut rng = Rng::new(3, 0);
    let mut values = vec![0.0; n * n];
    for o in 0..n {
        for i in 0..=o {
            // reciprocal: f(i, o) = f(−o, −i)
            let value = 0.8 / PI * rng.uniform();
            values[o * n + i] = value;
            values[basis.turned(i) * n + basis.turned(o)] = value;
        }
    }
    let reciprocal = |o: usize, i: usize| 0.5 * (values[o * n + i] + values[basis.turned(i) * n + basis.turned(o)]);
    let values: Vec<f64> = (0..n * n).map(|k| reciprocal(k / n, k % n)).collect();
    let block = || Some(Block::Matrix(Matrix::new(basis.clone(), basis.clone(), &values).expect("sound")));
    let side = || Blocks { transmission: block(), reflection: None };
    let element = Bsdf::new(side(), side()).expect("sound");
    assert!(!has_lobes(&element) && has_lobes(&ClearGlazing::open()));
    let exchange = Exchange::of(&element, Cells::Klems(basis), &Averaging::default());
    let (energy, reciprocity) = laws(&exchange);
    // chance keeps the two sides from agreeing on what passes: the misfit is absorbed
    assert!(energy < 0.01 && reciprocity < 1e-10, "{energy} {reciprocity}");
    let found = exchange.table(Side::Front, Way::Transmission);
    let errors = exchange.standard_error(Side::Front, Way::Transmission).expect("drawn");
    let (mut chi2, count) = (0.0, (n * n) as f64);
    for ((found, error), want) in found.iter().zip(&errors).zip(&values) {
        assert!(*error < 0.03 && (found - want).abs() < 6.0 * error, "{found} {want} ± {error}");
        chi2 += ((found - want) / error).powi(2);
    }
    // the errors come from 16 repetitions each end: squares of their quotients average n / (n − 2) or so
    assert!(chi2 > 0.7 * count && chi2 < 1.4 * count, "{chi2} of {count}");
}

/// A pane's tree of rank 3 sends out what the pane does; an element with an up has none.
#[test]
fn rank_3_is_for_isotropic_elements() {
    let pane = ClearGlazing::slab(1.52, 6.0, 0.02).expect("possible");
    let trees = isotropic_trees(&pane, 5, &Averaging::default(), 0.0).expect("isotropic");
    let [tf, tb, rf, _] = trees.map(|walk| Tree::from_preorder(3, &walk).expect("sound"));
    // in the middle of some of the cells of r, by projected solid angle
    for r in [0, 6, 11, 14].map(|k: i32| (0.5 * (f64::from(k * k) + f64::from((k + 1) * (k + 1)))).sqrt() / 16.0) {
        let incident = Direction::from_unit(Vec3::new(0.6 * r, -0.8 * r, f64::sqrt(1.0 - r * r)));
        let straight = pane.straight(incident).expect("clear");
        let at = [incident.x, incident.y];
        assert!((tf.hemispherical(at) - straight.transmittance).abs() < 6e-3, "{r}");
        assert!((tb.hemispherical(at) - straight.transmittance).abs() < 6e-3);
        assert!((rf.hemispherical(at) - straight.reflectance).abs() < 6e-3);
        // the peak is straight ahead, half in the square on either side of the plane of incidence
        assert!(tf.value(at, at) > 10.0 && (r < 0.1 || tf.value(at, [-at[1], at[0]]) == 0.0));
    }
    assert!(isotropic_trees(&Grating { step: 0.2, absorbed_behind: 0.0 }, 4, &Averaging::default(), 0.0).is_err());
}
