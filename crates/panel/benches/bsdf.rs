//! Speed of averages over directions: what it takes to make the blocks of a BSDF.
#![allow(missing_docs)] // criterion writes a function without them

use criterion::{Criterion, criterion_group, criterion_main};
use hemisphere::{Direction, KlemsBasis};
use optics::{Averaging, Cells, Exchange, Glazing, Lobes, Scattered, Side, Way};
use panel::{
    Media, Optical, Panel, Polarisation, Profile, Sample,
    flux::Limits,
    shape::{LaserCut, Prismatic, Ridges},
};
use std::{hint::black_box, sync::Arc};

const WORDS: [(&str, Polarisation); 2] = [("averaged", Polarisation::Averaged), ("resolved", Polarisation::Resolved)];

fn panel(profile: Profile, polarisation: Polarisation) -> Panel {
    let media = Media::in_air(&[Optical { n: 1.49, absorption: 0.0 }]).expect("acrylic is a medium");
    let limits = Limits { tolerance: 1e-5, ..Limits::default() };
    Panel::new(Arc::new(profile), vec![Sample { media, weight: 1.0 }], polarisation, limits).expect("it is a panel")
}

fn klems(name: &str) -> Cells {
    Cells::Klems(KlemsBasis::named(name).expect("known"))
}

fn blocks(c: &mut Criterion) {
    let mut group = c.benchmark_group("BSDF of a laser-cut panel, D/W 0.3");
    group.sample_size(10);
    let how = Averaging { tolerance: 4e-3, levels: 3, ..Averaging::default() };
    for (word, polarisation) in WORDS {
        let panel = panel(LaserCut::ideal(1.8, 6.0).profile().expect("it can be cut"), polarisation);
        group.bench_function(format!("Klems full, {word}"), |b| {
            b.iter(|| Exchange::of(black_box(&panel), klems("klems_full"), &how).table(Side::Front, Way::Transmission));
        });
        let coarse = Averaging { levels: 2, ..how };
        group.bench_function(format!("tensor tree 2^5, {word}"), |b| {
            b.iter(|| {
                Exchange::of(black_box(&panel), Cells::Grid(5), &coarse).tree(Side::Front, Way::Transmission, 0.0)
            });
        });
    }
    group.finish();
}

/// A panel that does not tell how its beams move, so that it is solved twice more beside each direction.
struct BySteps(Panel);

impl Glazing for BySteps {
    fn lobes(&self, incident: Direction, out: &mut Lobes) {
        self.0.lobes(incident, out);
    }

    fn scatter(&self, incident: Direction, u: [f64; 3]) -> Scattered {
        self.0.scatter(incident, u)
    }
}

/// Prisms and kerfs, coarsely: nine places in each of 41 patches, less those that symmetry saves.
fn prisms(c: &mut Criterion) {
    let mut group = c.benchmark_group("Klems quarter, nine places a patch");
    group.sample_size(10);
    let how = Averaging { levels: 0, ..Averaging::default() };
    let prism = |lower_deg, upper_deg| {
        let sheet = Prismatic { pitch: 1.0, lower_deg, upper_deg, base: 1.0, ridges: Ridges::Front };
        sheet.profile().expect("it can be made")
    };
    let kerf = LaserCut { cut_width: 0.3, ..LaserCut::ideal(4.0, 6.0) }.profile().expect("it can be cut");
    for (name, profile) in
        [("prism 45/45", prism(45.0, 45.0)), ("prism 45/80", prism(45.0, 80.0)), ("kerf of 0.3 mm", kerf)]
    {
        for (word, polarisation) in WORDS {
            let one = panel(profile.clone(), polarisation);
            let steps = BySteps(one.clone());
            for (slopes, glazing) in [("exact slopes", &one as &dyn Glazing), ("slopes by steps", &steps)] {
                group.bench_function(format!("{name}, {word}, {slopes}"), |b| {
                    b.iter(|| Exchange::of(black_box(glazing), klems("klems_quarter"), &how).correction);
                });
            }
        }
    }
    group.finish();
}

criterion_group!(benches, blocks, prisms);
criterion_main!(benches);
