//! Segments and closed loops in a plane: which cross, which hold what.

/// Area of a loop, positive if it runs anticlockwise.
pub fn signed_area(l: &[[f64; 2]]) -> f64 {
    0.5 * (0..l.len()).map(|i| cross(l[i], l[(i + 1) % l.len()])).sum::<f64>()
}

fn cross(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[1] - a[1] * b[0]
}

/// Twice the signed area of a triangle, 0 within rounding of its size.
pub fn turn(a: [f64; 2], b: [f64; 2], c: [f64; 2]) -> f64 {
    let (u, v) = ([b[0] - a[0], b[1] - a[1]], [c[0] - a[0], c[1] - a[1]]);
    let area = cross(u, v);
    let scale = (u[0].abs() + u[1].abs()) * (v[0].abs() + v[1].abs());
    if area.abs() <= 1e-12 * scale { 0.0 } else { area }
}

/// Whether segments cross at an inner point of both.
pub fn segments_cross(a: [[f64; 2]; 2], b: [[f64; 2]; 2]) -> bool {
    turn(a[0], a[1], b[0]) * turn(a[0], a[1], b[1]) < 0.0 && turn(b[0], b[1], a[0]) * turn(b[0], b[1], a[1]) < 0.0
}

/// Whether segments share any point.
pub fn segments_meet(a: [[f64; 2]; 2], b: [[f64; 2]; 2]) -> bool {
    segments_cross(a, b) || b.iter().any(|&p| on_segment(a, p)) || a.iter().any(|&p| on_segment(b, p))
}

/// Whether an edge runs back along the one before it.
pub fn folds_back(a: [[f64; 2]; 2], b: [[f64; 2]; 2]) -> bool {
    // the shared vertex is the end of one and the start of the other
    let (corner, before, after) = if a[1] == b[0] { (a[1], a[0], b[1]) } else { (a[0], b[0], a[1]) };
    let (u, v) = ([before[0] - corner[0], before[1] - corner[1]], [after[0] - corner[0], after[1] - corner[1]]);
    turn(corner, before, after) == 0.0 && u[0] * v[0] + u[1] * v[1] > 0.0
}

fn on_segment([a, b]: [[f64; 2]; 2], p: [f64; 2]) -> bool {
    let d = [b[0] - a[0], b[1] - a[1]];
    let along = (p[0] - a[0]) * d[0] + (p[1] - a[1]) * d[1];
    let length2 = d[0] * d[0] + d[1] * d[1];
    let across = cross(d, [p[0] - a[0], p[1] - a[1]]).abs();
    (0.0..=length2).contains(&along) && across <= 1e-9 * length2
}

/// Whether a point lies on an edge of a loop.
pub fn on_loop(l: &[[f64; 2]], p: [f64; 2]) -> bool {
    (0..l.len()).any(|i| on_segment([l[i], l[(i + 1) % l.len()]], p))
}

/// Whether a point lies in a loop: a line from it crosses an odd number of edges.
pub fn crossings_odd(l: &[[f64; 2]], p: [f64; 2]) -> bool {
    let mut inside = false;
    for i in 0..l.len() {
        let (a, b) = (l[i], l[(i + 1) % l.len()]);
        if (a[1] > p[1]) != (b[1] > p[1]) && p[0] < a[0] + (p[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0]) {
            inside = !inside;
        }
    }
    inside
}
