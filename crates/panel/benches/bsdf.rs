//! Speed of averages over directions: what it takes to make the blocks of a BSDF.
#![allow(missing_docs)] // criterion writes a function without them

use criterion::{Criterion, criterion_group, criterion_main};
use hemisphere::KlemsBasis;
use optics::{Averaging, Cells, Exchange, Side, Way};
use panel::{Media, Optical, Panel, Polarisation, Sample, flux::Limits, shape::LaserCut};
use std::{hint::black_box, sync::Arc};

fn laser_cut(polarisation: Polarisation) -> Panel {
    let profile = LaserCut::ideal(1.8, 6.0).profile().expect("it can be cut");
    let media = Media::in_air(&[Optical { n: 1.49, absorption: 0.0 }]).expect("acrylic is a medium");
    let limits = Limits { tolerance: 1e-5, ..Limits::default() };
    Panel::new(Arc::new(profile), vec![Sample { media, weight: 1.0 }], polarisation, limits).expect("it is a panel")
}

fn blocks(c: &mut Criterion) {
    let mut group = c.benchmark_group("BSDF of a laser-cut panel, D/W 0.3");
    group.sample_size(10);
    let how = Averaging { tolerance: 4e-3, levels: 3, ..Averaging::default() };
    for (word, polarisation) in [("averaged", Polarisation::Averaged), ("resolved", Polarisation::Resolved)] {
        let panel = laser_cut(polarisation);
        let full = || Cells::Klems(KlemsBasis::named("klems_full").expect("known"));
        group.bench_function(format!("Klems full, {word}"), |b| {
            b.iter(|| Exchange::of(black_box(&panel), full(), &how).table(Side::Front, Way::Transmission));
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

criterion_group!(benches, blocks);
criterion_main!(benches);
