//! How many nodes each side of each cell gets, by what a pilot found of it.

use super::density::Cells;
use super::walk::Walker;

/// Share of the nodes that goes by area and what sees it, whatever the brightness: it may have been found dark by chance.
const EVENLY: f64 = 0.25;

/// Least mattering of what a ray has met, in shares of the mean.
const LITTLE: f64 = 0.02;

/// Weights of the sides of the cells: area, times how much it matters, times how bright it is. The best density of points goes with
/// the root mean square of what they give.
pub fn weights_of(
    walker: &Walker<'_>,
    cells: &Cells,
    matters: &[[f64; 2]],
    met: &[[bool; 2]],
    bright: &[[f64; 2]],
) -> Vec<[f64; 2]> {
    let scene = walker.scene;
    // of each side of each surface: area seen, brightness and mattering over it
    let mut sums = vec![[[0.0; 3]; 2]; scene.surfaces.len()];
    let all = matters.iter().flatten().filter(|m| **m > 0.0);
    // what a ray has met matters a little, whatever the points say
    let little = LITTLE * all.clone().sum::<f64>() / (all.count() as f64).max(1.0);
    for (surface, cell) in cells.each() {
        for side in [0, 1] {
            if matters[cell][side] > 0.0 || met[cell][side] {
                let sum = &mut sums[surface as usize][side];
                sum[0] += 1.0;
                sum[1] += matters[cell][side].max(little);
                sum[2] += bright[cell][side];
            }
        }
    }
    let mut weight = vec![[0.0; 2]; cells.count()];
    let (mut all, mut by_brightness) = (0.0, 0.0);
    for (surface, cell) in cells.each() {
        for side in [0, 1] {
            let [seen, matter, light] = sums[surface as usize][side];
            if seen == 0.0 {
                continue;
            }
            // a cell's few points may mislead: half by them, half by the whole surface
            let matter = 0.5 * (matters[cell][side] + matter / seen) * cells.area(scene, surface);
            let light = 0.5 * (bright[cell][side] + light / seen);
            weight[cell][side] = matter * light;
            all += matter;
            by_brightness += matter * light;
        }
    }
    let mean = (by_brightness / f64::max(all, f64::MIN_POSITIVE)).max(f64::MIN_POSITIVE);
    for (surface, cell) in cells.each() {
        for side in [0, 1] {
            let [seen, matter, _] = sums[surface as usize][side];
            if seen > 0.0 {
                let matter = 0.5 * (matters[cell][side] + matter / seen) * cells.area(scene, surface);
                weight[cell][side] = (1.0 - EVENLY) * weight[cell][side] + EVENLY * mean * matter;
            }
        }
    }
    weight
}
