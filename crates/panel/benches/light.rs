//! Speed of the exact solver and of the walk, on one core.
#![allow(missing_docs)] // criterion writes a function without them

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use hemisphere::{Direction, Sobol};
use optics::Side;
use panel::{
    Media, Optical, Panel, Polarisation, Profile, Sample, Workspace,
    flux::Limits,
    incident_direction,
    shape::{LaserCut, Prismatic, Ridges},
    walk::{Draw, Walk},
};
use std::{hint::black_box, sync::Arc};

const ACRYLIC: Optical = Optical { n: 1.49, absorption: 0.0 };

fn from_above(degrees: f64) -> Direction {
    incident_direction(f64::to_radians(degrees), 0.0, Side::Front)
}

fn panel(profile: Profile, polarisation: Polarisation) -> Panel {
    let media = Media::in_air(&[ACRYLIC]).expect("acrylic is a medium");
    let limits = Limits { tolerance: 1e-6, ..Limits::default() };
    Panel::new(Arc::new(profile), vec![Sample { media, weight: 1.0 }], polarisation, limits).expect("it is a panel")
}

fn laser_cut(d_over_w: f64) -> Profile {
    LaserCut::ideal(6.0 * d_over_w, 6.0).profile().expect("it can be cut")
}

/// Cuts as a laser makes them: 0.3 mm wide, 4 mm apart in a sheet of 6 mm, perhaps tilted.
fn kerf(tilt_deg: f64) -> Profile {
    let cut = LaserCut { cut_width: 0.3, cut_tilt_deg: vec![tilt_deg], ..LaserCut::ideal(4.0, 6.0) };
    cut.profile().expect("it can be cut")
}

fn prismatic() -> Profile {
    let sheet = Prismatic { pitch: 1.0, lower_deg: 45.0, upper_deg: 45.0, base: 1.0, ridges: Ridges::Front };
    sheet.profile().expect("it can be made")
}

fn exact(c: &mut Criterion) {
    let cases = [
        ("laser-cut D/W 0.5 at 60°, averaged", laser_cut(0.5), 60.0, Polarisation::Averaged),
        ("laser-cut D/W 0.5 at 60°, resolved", laser_cut(0.5), 60.0, Polarisation::Resolved),
        ("kerf of 0.3 mm at 45°, resolved", kerf(0.0), 45.0, Polarisation::Resolved),
        ("kerf of 0.3 mm tilted by 10° at 45°, resolved", kerf(10.0), 45.0, Polarisation::Resolved),
        ("prism 45/45 at 35°, averaged", prismatic(), 35.0, Polarisation::Averaged),
        ("prism 45/45 at 35°, resolved", prismatic(), 35.0, Polarisation::Resolved),
    ];
    let mut group = c.benchmark_group("exact to 1e-6");
    for (name, profile, elevation, polarisation) in cases {
        let (panel, incident, mut workspace) =
            (panel(profile, polarisation), from_above(elevation), Workspace::default());
        group.bench_function(name, |b| b.iter(|| panel.shares(black_box(incident), &mut workspace)));
    }
    group.finish();
}

fn walk(c: &mut Criterion) {
    const RAYS: u64 = 16_384;
    let media = Media::in_air(&[ACRYLIC]).expect("acrylic is a medium");
    let profile = laser_cut(0.3);
    let mut group = c.benchmark_group("walk");
    group.throughput(Throughput::Elements(RAYS));
    for polarisation in [Polarisation::Averaged, Polarisation::Resolved] {
        let (walk, incident) = (Walk::new(&profile, &media, polarisation), from_above(40.0));
        let sobol = Sobol { seed: 1 };
        group.bench_function(format!("laser-cut D/W 0.3 at 40°, {polarisation:?}"), |b| {
            b.iter(|| {
                for ray in 0..RAYS as u32 {
                    black_box(walk.run(black_box(incident), &mut Draw::spread(&sobol, ray)));
                }
            });
        });
    }
    group.finish();
}

criterion_group!(benches, exact, walk);
criterion_main!(benches);
