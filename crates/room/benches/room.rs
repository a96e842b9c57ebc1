//! Speed of closest hits and of daylight factors: `cargo bench -p room`.

#![allow(missing_docs)]

#[path = "../tests/rooms/mod.rs"]
mod rooms;

use cpu_time::ThreadTime;
use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use hemisphere::{Rng, Vec3};
use optics::ClearGlazing;
use room::{Material, Scene, SceneBuilder, Settings, daylight_coefficients};
use std::f64::consts::{PI, TAU};
use std::hint::black_box;

/// A bumpy sphere of so many triangles around the origin.
fn bumpy_sphere(rings: usize, sectors: usize) -> Scene {
    let mut vertices = Vec::new();
    for i in 0..=rings {
        for j in 0..sectors {
            let (t, p) = (PI * i as f64 / rings as f64, TAU * j as f64 / sectors as f64);
            let r = 5.0 + 0.3 * (9.0 * t).sin() * (11.0 * p).cos();
            vertices.push(r * Vec3::new(t.sin() * p.cos(), t.sin() * p.sin(), t.cos()));
        }
    }
    let at = |i: usize, j: usize| (i * sectors + j % sectors) as i64;
    let triangles: Vec<[i64; 3]> = (0..rings)
        .flat_map(|i| (0..sectors).map(move |j| (i, j)))
        .flat_map(|(i, j)| [[at(i, j), at(i + 1, j), at(i + 1, j + 1)], [at(i, j), at(i + 1, j + 1), at(i, j + 1)]])
        .collect();
    let mut b = SceneBuilder::default();
    b.mesh("sphere", &vertices, &triangles, Material::diffuse(0.5)).expect("sound");
    b.build().expect("sound")
}

/// Rays from within a box, in all directions.
fn rays(low: Vec3, high: Vec3) -> Vec<(Vec3, Vec3)> {
    let mut rng = Rng::new(1, 0);
    (0..10_000)
        .map(|_| {
            let u = Vec3::from_array(std::array::from_fn(|_| rng.uniform()));
            let (z, a) = (2.0 * rng.uniform() - 1.0, TAU * rng.uniform());
            let r = (1.0 - z * z).sqrt();
            (low + u * (high - low), Vec3::new(r * a.cos(), r * a.sin(), z))
        })
        .collect()
}

fn closest_hits(c: &mut Criterion) {
    let mut group = c.benchmark_group("closest hit");
    let glass = ClearGlazing::glass(0.88).expect("possible");
    let bare = rooms::Shoebox::reference().scene(glass);
    let scenes = [
        ("bare room", bare, rays(Vec3::splat(0.1), Vec3::new(3.9, 7.9, 2.9))),
        ("1 000 triangles", bumpy_sphere(20, 25), rays(Vec3::splat(-2.0), Vec3::splat(2.0))),
        ("10 000 triangles", bumpy_sphere(50, 100), rays(Vec3::splat(-2.0), Vec3::splat(2.0))),
        ("100 000 triangles", bumpy_sphere(200, 250), rays(Vec3::splat(-2.0), Vec3::splat(2.0))),
        ("1 000 000 triangles", bumpy_sphere(500, 1000), rays(Vec3::splat(-2.0), Vec3::splat(2.0))),
    ];
    for (name, scene, rays) in scenes {
        group.throughput(Throughput::Elements(rays.len() as u64));
        group.bench_function(name, |b| {
            // CPU time: other programs at work take nothing from it but the cache
            b.iter_custom(|passes| {
                let began = ThreadTime::now();
                for _ in 0..passes {
                    black_box(rays.iter().filter(|(o, d)| black_box(scene.closest(*o, *d)).is_some()).count());
                }
                began.elapsed()
            });
        });
    }
    group.finish();
}

fn daylight_factors(c: &mut Criterion) {
    let room = rooms::Shoebox::reference();
    let scene = room.scene(ClearGlazing::glass(0.88).expect("possible"));
    let (points, normals) = room.work_plane(0.8, 0.5);
    let basis = rooms::tregenza();
    let mut group = c.benchmark_group("reference room");
    group.sample_size(10);
    let settings = Settings { rounds: 2, nodes: 1024, window_samples: 64, ..Settings::default() };
    group.bench_function("daylight factors to 2 %, 128 sensors", |b| {
        b.iter(|| daylight_coefficients(&scene, &points, &normals, &basis, &settings, |_| true).is_ok());
    });
    group.finish();
}

criterion_group!(benches, closest_hits, daylight_factors);
criterion_main!(benches);
