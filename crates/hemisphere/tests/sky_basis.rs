//! Sky bases against the published tables, and the laws they all obey.

use hemisphere::{Order, Rng, SkyBasis, Vec3, towards};
use std::f64::consts::{PI, TAU};

const NAMES: [&str; 5] = ["tregenza145", "reinhart577", "reinhart1297", "reinhart2305", "troplux5221"];

fn basis(name: &str) -> SkyBasis {
    SkyBasis::named(name).expect("a known basis")
}

fn rows(table: &str) -> impl Iterator<Item = Vec<f64>> + '_ {
    table
        .lines()
        .filter(|line| line.starts_with(|c: char| c.is_ascii_digit()))
        .map(|line| line.split(',').map(|x| x.parse().expect("a number")).collect())
}

/// Names say how many patches there are; other names are unknown.
#[test]
fn names_count_the_sky_patches() {
    for name in NAMES {
        let digits: String = name.chars().filter(char::is_ascii_digit).collect();
        assert_eq!(basis(name).ground().to_string(), digits);
    }
    for name in ["tregenza144", "reinhart", "reinhart600", "reinhart1", "klems", ""] {
        assert!(SkyBasis::named(name).is_none(), "{name}");
    }
}

/// Centres in the CIE's order are those of the published list, degree by degree.
#[test]
fn cie_order_is_the_published_serpentine() {
    let sky = basis("tregenza145");
    let order = sky.order(Order::Cie);
    let table: Vec<_> = rows(include_str!("data/tregenza145_cie_order.csv")).collect();
    assert_eq!(table.len(), 145);
    for row in table {
        let want = towards(row[1].to_radians(), row[2].to_radians());
        assert!((sky.centre(order[row[0] as usize - 1]) - want).length() < 1e-12, "patch {}", row[0]);
    }
}

/// Centres and solid angles in Radiance's order are those of its table; the ground comes first.
#[test]
fn radiance_order_begins_with_the_ground() {
    let sky = basis("tregenza145");
    let order = sky.order(Order::Radiance);
    assert_eq!(order[0], sky.ground());
    let table: Vec<_> = rows(include_str!("data/tregenza145_radiance_order.csv")).collect();
    assert_eq!(table.len(), 145);
    for row in table {
        let index = order[row[0] as usize];
        let want = towards(row[2].to_radians(), row[3].to_radians());
        assert!((sky.centre(index) - want).length() < 1e-12, "patch {}", row[0]);
        assert!((sky.solid_angle(index) - row[4]).abs() < 1e-8, "patch {}", row[0]);
    }
}

/// The patches tile the sky: solid angles sum to 2π, and so do their projections on the ground to π.
#[test]
fn patches_tile_the_sky() {
    for name in NAMES {
        let sky = basis(name);
        let solid: f64 = (0..sky.ground()).map(|p| sky.solid_angle(p)).sum();
        let projected: f64 = (0..sky.ground())
            .map(|p| {
                let b = sky.bounds(p);
                0.5 * sky.solid_angle(p) * (b.altitude_low.sin() + b.altitude_high.sin())
            })
            .sum();
        assert!((solid - TAU).abs() < 1e-12 && (projected - PI).abs() < 1e-12, "{name}: {solid} {projected}");
    }
}

/// Every direction has one patch, and a patch's own samples and centre are found in it.
#[test]
fn look_up_undoes_sampling() {
    let mut rng = Rng::new(3, 0);
    for name in NAMES {
        let sky = basis(name);
        for patch in 0..sky.patches() {
            assert_eq!(sky.find(sky.centre(patch)), patch, "{name} centre");
            for _ in 0..8 {
                // not the very edge, which belongs to either side
                let u = [0.001 + 0.998 * rng.uniform(), 0.001 + 0.998 * rng.uniform()];
                assert_eq!(sky.find(sky.sample(patch, u)), patch, "{name} {u:?}");
            }
        }
        assert_eq!(sky.find(Vec3::X), sky.find(towards(1e-9, PI / 2.0)));
    }
}

/// Uniform directions fall on each patch in proportion to its solid angle (χ² within five standard deviations).
#[test]
fn uniform_directions_fill_patches_by_solid_angle() {
    let mut rng = Rng::new(11, 0);
    for name in ["tregenza145", "troplux5221"] {
        let sky = basis(name);
        let n = 40 * sky.ground();
        let mut count = vec![0.0; sky.ground()];
        for _ in 0..n {
            let (z, a) = (rng.uniform(), TAU * rng.uniform());
            let r = (1.0 - z * z).sqrt();
            count[sky.find(Vec3::new(r * a.cos(), r * a.sin(), z))] += 1.0;
        }
        let chi2: f64 = (0..sky.ground())
            .map(|p| {
                let expected = n as f64 * sky.solid_angle(p) / TAU;
                (count[p] - expected) * (count[p] - expected) / expected
            })
            .sum();
        let freedom = (sky.ground() - 1) as f64;
        assert!((chi2 - freedom).abs() < 5.0 * (2.0 * freedom).sqrt(), "{name}: χ² {chi2} of {freedom}");
    }
}

/// Tregenza's patches in 6 × 6 lie each within its parent, and the 37 parts of the zenith cap are equal.
#[test]
fn troplux_splits_each_tregenza_patch() {
    let (fine, coarse) = (basis("troplux5221"), basis("tregenza145"));
    let mut parts = vec![0; coarse.ground()];
    for p in 0..fine.ground() {
        parts[coarse.find(fine.centre(p))] += 1;
    }
    assert!(parts[..144].iter().all(|&n| n == 36) && parts[144] == 37);
    for p in fine.ground() - 37..fine.ground() {
        assert!((fine.solid_angle(p) - coarse.solid_angle(144) / 37.0).abs() < 1e-15);
    }
}

/// The overcast sky gives 7π/9 of its zenith luminance on open ground, in any basis.
#[test]
fn overcast_sky_lights_open_ground() {
    for name in NAMES {
        let sky = basis(name);
        let luminance = sky.overcast(0.2);
        let patch_sum: f64 = (0..sky.ground())
            .map(|p| {
                let b = sky.bounds(p);
                luminance[p] * 0.5 * sky.solid_angle(p) * (b.altitude_low.sin() + b.altitude_high.sin())
            })
            .sum();
        // averaging over a patch and weighting by its mean sine loses the covariance of the two, which shrinks as patches do
        let loss = 7.0 * PI / 9.0 - patch_sum;
        assert!(loss > 0.0 && loss < 0.01 * 144.0 / sky.ground() as f64 * 4.0, "{name}: {loss}");
    }
}
