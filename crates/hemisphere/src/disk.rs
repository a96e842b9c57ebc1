//! The unit disk as a unit square, areas kept: how directions of one side become the two coordinates of a tensor tree.

use std::f64::consts::FRAC_PI_4;

/// The place in the unit square of a point of the unit disk. Equal areas stay equal, circles become squares, and the axes stay axes.
///
/// P. Shirley, K. Chiu, *Journal of Graphics Tools* 2(3), 1997 (theory/bsdf_averaging.md, eq. 2).
pub fn disk_to_square(x: f64, y: f64) -> [f64; 2] {
    let r = x.hypot(y).min(1.0);
    // one of four wedges; across it the place along the side of the square is the angle as a share of the wedge
    let (a, b) = if x.abs() >= y.abs() {
        if r == 0.0 {
            return [0.5, 0.5];
        }
        let a = r.copysign(x);
        (a, a * (y / x).atan() / FRAC_PI_4)
    } else {
        let b = r.copysign(y);
        (b * (x / y).atan() / FRAC_PI_4, b)
    };
    [0.5 * (a + 1.0), 0.5 * (b + 1.0)]
}

/// The point of the unit disk at a place in the unit square: the inverse of [`disk_to_square`].
pub fn square_to_disk(u: f64, v: f64) -> [f64; 2] {
    let (a, b) = (2.0 * u - 1.0, 2.0 * v - 1.0);
    if a.abs() >= b.abs() {
        if a == 0.0 {
            return [0.0, 0.0];
        }
        let (sine, cosine) = (FRAC_PI_4 * b / a).sin_cos();
        [a * cosine, a * sine]
    } else {
        let (sine, cosine) = (FRAC_PI_4 * a / b).sin_cos();
        [b * sine, b * cosine]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn places() -> impl Iterator<Item = [f64; 2]> {
        (0..=40).flat_map(|i| (0..=40).map(move |j| [f64::from(i) / 40.0, f64::from(j) / 40.0]))
    }

    /// There and back again is where one was.
    #[test]
    fn the_maps_are_inverse() {
        for [u, v] in places() {
            let [x, y] = square_to_disk(u, v);
            let back = disk_to_square(x, y);
            assert!((back[0] - u).abs() < 1e-14 && (back[1] - v).abs() < 1e-14, "{u} {v} {back:?}");
        }
    }

    /// Each small square keeps its area, by the Jacobian's determinant.
    #[test]
    fn areas_are_kept() {
        let h = 1e-6;
        for [u, v] in places() {
            // inside, off the seams between wedges
            let (u, v) = (0.01 + 0.97 * u, 0.017 + 0.97 * v);
            if (u - v).abs() < 1e-3 || (u + v - 1.0).abs() < 1e-3 {
                continue;
            }
            let (p, q, r) = (square_to_disk(u, v), square_to_disk(u + h, v), square_to_disk(u, v + h));
            let area = ((q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])) / (h * h);
            assert!((area - std::f64::consts::PI).abs() < 1e-4, "{u} {v} {area}");
        }
    }

    /// Known places: the axes stay axes, diagonals go to corners, mirror images mirror.
    #[test]
    fn axes_and_corners_are_where_they_should_be() {
        assert_eq!(disk_to_square(1.0, 0.0), [1.0, 0.5]);
        assert_eq!(disk_to_square(0.0, -1.0), [0.5, 0.0]);
        let half = 0.5_f64.sqrt();
        let corner = disk_to_square(-half, half);
        assert!((corner[0]).abs() < 1e-15 && (corner[1] - 1.0).abs() < 1e-15);
        let (a, b) = (disk_to_square(0.3, -0.7), disk_to_square(-0.3, -0.7));
        assert!((a[0] + b[0] - 1.0).abs() < 1e-15 && (a[1] - b[1]).abs() < 1e-15);
    }
}
