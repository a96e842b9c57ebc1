//! Time and error of the daylight factor and of the coefficients in the reference room: `cargo run --release --example reference_room`.

#[path = "../tests/rooms/mod.rs"]
mod rooms;

use cpu_time::ProcessTime;
use hemisphere::SkyBasis;
use optics::ClearGlazing;
use room::{Settings, daylight_coefficients};

fn main() {
    let shoebox = rooms::Shoebox::reference();
    let Ok(glass) = ClearGlazing::glass(0.88) else { return };
    let scene = shoebox.scene(glass);
    let (points, normals) = shoebox.work_plane(0.8, 0.5);
    for name in ["tregenza145"] {
        let Some(basis) = SkyBasis::named(name) else { return };
        let run = |settings: &Settings| daylight_coefficients(&scene, &points, &normals, &basis, settings, |_| true);
        let Ok(converged) =
            run(&Settings { seed: 99, rounds: 128, nodes: 4096, window_samples: 2048, ..Settings::default() })
        else {
            return;
        };
        println!("{name}: reference in {:.1} s", converged.seconds);
        for (rounds, nodes, window_samples) in [
            (4, 256, 128),
            (4, 1024, 128),
            (16, 256, 64),
            (16, 1024, 256),
            (16, 4096, 1024),
            (32, 8192, 2048),
            (64, 8192, 4096),
        ] {
            let started = ProcessTime::now();
            let Ok(found) = run(&Settings { rounds, nodes, window_samples, ..Settings::default() }) else { return };
            let seconds = started.elapsed().as_secs_f64();
            let relative: f64 = found
                .weighted
                .value
                .iter()
                .zip(&converged.weighted.value)
                .map(|(a, b)| (a / b - 1.0).powi(2))
                .sum::<f64>()
                / points.len() as f64;
            let claimed = found.weighted.value.iter().zip(&found.weighted.standard_error).map(|(v, e)| (e / v).powi(2));
            let claimed = (claimed.sum::<f64>() / points.len() as f64).sqrt();
            let total = |c: &room::DaylightCoefficients| -> Vec<f64> {
                c.direct.value.iter().zip(&c.interreflected.value).map(|(a, b)| a + b).collect()
            };
            let (a, b) = (total(&found), total(&converged));
            let mean = b.iter().sum::<f64>() / b.len() as f64;
            let cv = (a.iter().zip(&b).map(|(a, b)| (a - b).powi(2)).sum::<f64>() / b.len() as f64).sqrt() / mean;
            println!(
                "{rounds:3} × {nodes:5} nodes, {window_samples:5} window points: {seconds:.3} CPU-s, DF error {:.2} % (claims {:.2} %), coefficient CV {:.1} %",
                100.0 * relative.sqrt(),
                100.0 * claimed,
                100.0 * cv
            );
        }
    }
}
