//! Laws that every block keeps: light is shared out as the values say, drawn as it is shared, by matrices and trees alike.

use super::*;
use hemisphere::{KlemsBasis, Rng};
use std::f64::consts::PI;

fn klems(name: &str) -> KlemsBasis {
    KlemsBasis::named(name).expect("known")
}

/// A matrix of random values that sends out at most the share `most`.
fn matrix(incident: &str, outgoing: &str, most: f64, seed: u64) -> Matrix {
    let (incident, outgoing) = (klems(incident), klems(outgoing));
    let mut rng = Rng::new(seed, 0);
    let count = incident.patches() * outgoing.patches();
    let values: Vec<f64> = (0..count).map(|_| most / PI * rng.uniform().powi(3)).collect();
    Matrix::new(incident, outgoing, &values).expect("sound")
}

/// A tree with leaves of all sizes and random values.
fn tree(rank: usize, seed: u64) -> Tree {
    fn grow(rank: usize, level: u32, rng: &mut Rng, walk: &mut Vec<f64>) {
        if level < 4 && (level == 0 || rng.uniform() < 0.4) {
            walk.push(f64::NAN);
            (0..1 << rank).for_each(|_| grow(rank, level + 1, rng, walk));
        } else {
            walk.push(if rng.uniform() < 0.5 { 0.0 } else { 0.5 / PI * rng.uniform() });
        }
    }
    let mut walk = Vec::new();
    grow(rank, 0, &mut Rng::new(seed, 1), &mut walk);
    Tree::from_preorder(rank, &walk).expect("sound")
}

fn along(x: f64, y: f64, side: f64) -> Direction {
    Direction::from_unit(Vec3::new(x, y, side * (1.0 - x * x - y * y).sqrt()))
}

fn elements() -> Vec<Bsdf> {
    let pair = |t, r| Blocks { transmission: Some(t), reflection: Some(r) };
    vec![
        Bsdf::new(
            pair(
                Block::Matrix(matrix("klems_full", "klems_full", 0.9, 1)),
                Block::Matrix(matrix("klems_half", "klems_quarter", 0.7, 2)),
            ),
            Blocks::default(),
        ),
        Bsdf::new(pair(Block::Tree(tree(4, 3)), Block::Tree(tree(4, 4))), Blocks::default()),
        Bsdf::new(
            pair(Block::Tree(tree(3, 5)), Block::Matrix(matrix("klems_full", "klems_full", 0.2, 6))),
            Blocks::default(),
        ),
    ]
    .into_iter()
    .map(|b| b.expect("sound"))
    .collect()
}

const INCIDENT: [[f64; 2]; 4] = [[0.0, 0.0], [0.31, -0.52], [-0.77, 0.11], [-0.4, -0.85]];

/// The spread share is the integral of the values over projected solid angle, by quadrature in the plane of (x, y).
#[test]
fn spread_share_is_the_integral_of_the_values() {
    let n = 500;
    let mut lobes = Lobes::default();
    for (k, element) in elements().iter().enumerate() {
        for [x, y] in INCIDENT {
            let incident = along(x, y, 1.0);
            element.lobes(incident, &mut lobes);
            let mut sum = 0.0;
            for i in 0..n {
                for j in 0..n {
                    let [x, y] = [i, j].map(|m| (f64::from(m) + 0.5) / f64::from(n) * 2.0 - 1.0);
                    if x * x + y * y < 1.0 {
                        sum += element.bsdf(incident, along(x, y, 1.0)) + element.bsdf(incident, along(x, y, -1.0));
                    }
                }
            }
            sum *= 4.0 / f64::from(n * n);
            assert!((sum - lobes.spread).abs() < 4e-3 * lobes.spread, "{k}: {x} {y}: {sum} {}", lobes.spread);
            assert!((lobes.spread + lobes.absorbed - 1.0).abs() < 1e-12 && lobes.spread > 0.01);
        }
    }
}

/// Draws fall on the cells of the half spaces as often as the density says: chi-square over Klems patches of both sides.
#[test]
fn draws_follow_the_density() {
    let patches = klems("klems_full");
    let draws = 200_000;
    let mut lobes = Lobes::default();
    for (k, element) in elements().iter().enumerate() {
        for [x, y] in INCIDENT {
            let incident = along(x, y, 1.0);
            element.lobes(incident, &mut lobes);
            let mut rng = Rng::new(7, k as u64);
            // what is expected in each patch, by fine quadrature of the density
            let (m, mut expected) = (40, vec![0.0; 2 * patches.patches() + 1]);
            for (o, expected) in expected[..2 * patches.patches()].iter_mut().enumerate() {
                let (patch, side) = (o / 2, if o % 2 == 0 { 1.0 } else { -1.0 });
                for i in 0..m * m {
                    let u = [(f64::from(i / m) + 0.5) / f64::from(m), (f64::from(i % m) + 0.5) / f64::from(m)];
                    let [x, y] = patches.sample(patch, u);
                    let outgoing = along(x, y, side);
                    *expected += element.density(incident, outgoing) / outgoing.z.abs() / f64::from(m * m);
                }
                *expected *= patches.projected_solid_angle(patch);
            }
            *expected.last_mut().expect("one") = lobes.absorbed;
            let mut count = vec![0.0; expected.len()];
            for _ in 0..draws {
                let at = match element.scatter(incident, std::array::from_fn(|_| rng.uniform())) {
                    Scattered::Absorbed => count.len() - 1,
                    Scattered::Leaves { direction: d, .. } => 2 * patches.find(d.x, d.y) + usize::from(d.z < 0.0),
                };
                count[at] += 1.0;
            }
            let (mut chi2, mut freedom) = (0.0, -1.0);
            for (count, share) in count.iter().zip(&expected) {
                let mean = share * f64::from(draws);
                if mean > 5.0 {
                    chi2 += (count - mean) * (count - mean) / mean;
                    freedom += 1.0;
                } else {
                    assert!(*count < mean + 25.0);
                }
            }
            // five standard deviations of chi-square
            assert!((chi2 - freedom) < 5.0 * (2.0_f64 * freedom).sqrt(), "{k} {x} {y}: {chi2} for {freedom}");
        }
    }
}

/// A Lambert element spreads evenly by any block, and sends nothing to a side it has no block for.
#[test]
fn lambert_is_lambert() {
    let n = klems("klems_quarter").patches();
    let even = Matrix::new(klems("klems_quarter"), klems("klems_quarter"), &vec![0.6 / PI; n * n]).expect("sound");
    for block in [Block::Matrix(even), Block::Tree(Tree::from_preorder(4, &[0.6 / PI]).expect("sound"))] {
        let element =
            Bsdf::new(Blocks::default(), Blocks { transmission: None, reflection: Some(block) }).expect("sound");
        let incident = along(0.2, -0.6, -1.0);
        let mut lobes = Lobes::default();
        element.lobes(incident, &mut lobes);
        assert!((lobes.spread - 0.6).abs() < 1e-12);
        assert!((element.bsdf(incident, along(0.5, 0.5, 1.0)) - 0.6 / PI).abs() < 1e-15);
        assert_eq!(element.bsdf(incident, along(0.5, 0.5, -1.0)), 0.0);
        element.lobes(-incident, &mut lobes);
        assert_eq!((lobes.spread, lobes.absorbed), (0.0, 1.0));
    }
}

/// What is written cell by cell is read back, zeros and even parts merged; broken walks are refused.
#[test]
fn trees_are_grown_and_read_back() {
    let mut writer = TreeWriter::new(4, 3);
    let mut rng = Rng::new(9, 0);
    let places: Vec<[usize; 4]> = (0..8).map(|i| [i, 7 - i, (3 * i) % 8, i / 2]).collect();
    let values: Vec<f64> = places.iter().map(|_| rng.uniform()).collect();
    places.iter().zip(&values).for_each(|(p, v)| writer.set(p, *v));
    let walk = writer.preorder(0.0);
    assert!(walk.len() < 400, "{}", walk.len());
    let tree = Tree::from_preorder(4, &walk).expect("sound");
    for i in 0..8_usize.pow(4) {
        let cell = [i % 8, i / 8 % 8, i / 64 % 8, i / 512];
        let [a, b, c, d] = cell.map(|p| (p as f64 + 0.4) / 8.0);
        let want = places.iter().position(|p| *p == cell).map_or(0.0, |k| values[k]);
        assert_eq!(tree.value(square_to_disk(a, b), square_to_disk(c, d)), want);
    }
    let mut even = TreeWriter::new(3, 2);
    (0..64).for_each(|i| even.set(&[i % 4, i / 4 % 4, i / 16], 0.25));
    assert_eq!(even.preorder(0.0), [0.25]);
    for walk in [&[][..], &[f64::NAN, 0.0], &[0.0, 0.0], &[-1.0], &[f64::INFINITY]] {
        assert!(Tree::from_preorder(4, walk).is_err());
    }
    assert!(Tree::from_preorder(2, &[0.0]).is_err());
}

/// More light than came is scaled to what came if it is noise, and refused if it is not.
#[test]
fn gains_are_scaled_or_refused() {
    let even = |share: f64| Some(Block::Tree(Tree::from_preorder(4, &[share / PI]).expect("sound")));
    let refused = Bsdf::new(Blocks { transmission: even(1.02), reflection: None }, Blocks::default());
    assert!(matches!(refused, Err(OpticsError::BsdfGains { ref block, .. }) if block == "transmission_front"));
    let noisy =
        Bsdf::new(Blocks { transmission: even(0.6), reflection: even(0.405) }, Blocks::default()).expect("noise");
    let mut lobes = Lobes::default();
    noisy.lobes(along(0.1, 0.2, 1.0), &mut lobes);
    assert!((lobes.spread - 1.0).abs() < 1e-15 && lobes.absorbed == 0.0);
    let value = noisy.bsdf(along(0.1, 0.2, 1.0), along(0.1, 0.2, 1.0));
    assert!((value - 0.6 / 1.005 / PI).abs() < 1e-12);
}
