//! The tree of boxes finds what trying every triangle finds.

use hemisphere::{Rng, Vec3};
use room::{Material, Scene, SceneBuilder};
use std::f64::consts::{PI, TAU};

/// A mesh, and its triangles once more for trying every one.
struct Mesh {
    scene: Scene,
    triangles: Vec<[Vec3; 3]>,
}

impl Mesh {
    fn new(vertices: &[Vec3], indices: &[[i64; 3]]) -> Self {
        let mut b = SceneBuilder::default();
        b.mesh("mesh", vertices, indices, Material::diffuse(0.5)).expect("sound");
        let triangles = indices.iter().map(|t| t.map(|k| vertices[k as usize])).collect();
        Self { scene: b.build().expect("sound"), triangles }
    }

    /// The least distance along a ray, by Cramer's rule on every triangle; and how far inside its nearest edge the triangle is hit.
    fn by_trial(&self, o: Vec3, d: Vec3) -> Option<(f64, f64)> {
        self.triangles
            .iter()
            .filter_map(|&[c, p, q]| {
                let (a, b, s) = (p - c, q - c, o - c);
                let volume = a.cross(b).dot(d);
                let (u, v) = (s.cross(b).dot(d) / volume, a.cross(s).dot(d) / volume);
                let t = -a.cross(b).dot(s) / volume;
                let inside = u.min(v).min(1.0 - u - v);
                (t > 1e-9 && inside >= -1e-9).then_some((t, inside))
            })
            .min_by(|x, y| x.0.total_cmp(&y.0))
    }
}

fn direction(rng: &mut Rng) -> Vec3 {
    let (z, a) = (2.0 * rng.uniform() - 1.0, TAU * rng.uniform());
    let r = (1.0 - z * z).sqrt();
    Vec3::new(r * a.cos(), r * a.sin(), z)
}

fn within(rng: &mut Rng, half: f64) -> Vec3 {
    Vec3::from_array(std::array::from_fn(|_| half * (2.0 * rng.uniform() - 1.0)))
}

/// Loose triangles, small and large, slivers among them, about a point.
fn soup(n: usize, about: Vec3, scale: f64) -> Mesh {
    let mut rng = Rng::new(3, n as u64);
    let mut vertices = Vec::new();
    while vertices.len() < 3 * n {
        let size = 0.05 * 100.0_f64.powf(rng.uniform());
        let (o, a) = (within(&mut rng, 5.0), within(&mut rng, size));
        let thin = if rng.uniform() < 0.1 { 1e-4 } else { 1.0 };
        let b = within(&mut rng, size * thin) + if thin < 1.0 { 0.5 * a } else { Vec3::ZERO };
        vertices.extend([o, o + a, o + b].map(|p| about + scale * p));
    }
    let indices: Vec<[i64; 3]> = (0..n as i64).map(|k| [3 * k, 3 * k + 1, 3 * k + 2]).collect();
    Mesh::new(&vertices, &indices)
}

/// A closed bumpy ball about a point, its bumps low enough that none hides another from rays that begin within.
fn ball(rings: usize, sectors: usize, about: Vec3) -> Mesh {
    let mut vertices = vec![about + 5.0 * Vec3::Z, about - 5.0 * Vec3::Z];
    for i in 1..rings {
        for j in 0..sectors {
            let (t, p) = (PI * i as f64 / rings as f64, TAU * j as f64 / sectors as f64);
            let r = 5.0 + 0.3 * t.sin().powi(2) * (9.0 * t).sin() * (11.0 * p).cos();
            vertices.push(about + r * Vec3::new(t.sin() * p.cos(), t.sin() * p.sin(), t.cos()));
        }
    }
    let at = |i: usize, j: usize| match i {
        0 => 0,
        _ if i == rings => 1,
        _ => (2 + (i - 1) * sectors + j % sectors) as i64,
    };
    let mut indices = Vec::new();
    for i in 0..rings {
        for j in 0..sectors {
            if i + 1 < rings {
                indices.push([at(i, j), at(i + 1, j), at(i + 1, j + 1)]);
            }
            if i > 0 {
                indices.push([at(i, j), at(i + 1, j + 1), at(i, j + 1)]);
            }
        }
    }
    Mesh::new(&vertices, &indices)
}

/// Near, far from the origin, in tenths of millimetres and in thousands of kilometres.
#[test]
fn closest_hits_are_those_of_trying_every_triangle() {
    for (about, scale) in
        [(Vec3::ZERO, 1.0), (Vec3::new(3.1e5, -7.3e5, 1.2e4), 1.0), (Vec3::ZERO, 1e-5), (Vec3::ZERO, 1e6)]
    {
        let mesh = soup(3000, about, scale);
        let mut rng = Rng::new(5, 0);
        let (mut hits, mut misses) = (0, 0);
        for k in 0..2500 {
            // from within, from around, from a thousand times as far, and along the axes
            let from = within(&mut rng, [5.0, 12.0, 5000.0][k % 3]);
            let mut to = direction(&mut rng);
            if k % 3 > 0 {
                to = (within(&mut rng, 5.0) - from).normalize();
            } else if k % 5 == 0 {
                to = [Vec3::X, -Vec3::Y, Vec3::Z][k % 15 / 5];
            }
            let origin = about + scale * from;
            let (got, want) = (mesh.scene.closest(origin, to), mesh.by_trial(origin, to));
            // within rounding of an edge the two may differ; 1e-9 is what a facet is widened by
            let rounding = 1e-8 * (scale + 1e-4 * about.length());
            match (got, want) {
                (Some((t, _)), Some((t_trial, _))) if (t - t_trial).abs() <= rounding * (1.0 + from.length()) => {
                    hits += 1
                }
                (None, None) => misses += 1,
                (_, Some((_, inside))) if inside.abs() < 1e-7 => {}
                _ => panic!("ray {k} from {origin} to {to}: {got:?}, by trial {want:?}"),
            }
        }
        assert!(hits > 1500 && misses > 50, "{hits} hits, {misses} misses say too little");
    }
}

/// Rays at the very edges and corners of a closed surface never slip through, near the origin or far from it.
#[test]
fn no_ray_slips_between_neighbours() {
    for about in [Vec3::ZERO, Vec3::new(4e5, 1e5, -9e4)] {
        let mesh = ball(40, 60, about);
        let mut rng = Rng::new(7, 0);
        for k in 0..20_000 {
            let origin = about + within(&mut rng, 2.0);
            let [a, b, _] = mesh.triangles[(rng.uniform() * mesh.triangles.len() as f64) as usize];
            let share = [0.0, rng.uniform(), 0.5, 1.0][k % 4];
            let aim = a + share * (b - a);
            let hit = mesh.scene.closest(origin, (aim - origin).normalize());
            let (t, _) = hit.unwrap_or_else(|| panic!("a ray from {origin} slips through at {aim}"));
            assert!(t <= (aim - origin).length() * (1.0 + 1e-6), "ray {k} goes on behind {aim}");
        }
    }
}
