//! Reflectance of one clear surface, in the words of Edmonds, Greenup and Compagnon.

/// Unpolarised reflectance of one surface of relative index A, light arriving from the thinner side at cosine c:
///
/// r_te = (c − √(A² − 1 + c²)) / (c + √(A² − 1 + c²)), r_tm = (A²c − √(A² − 1 + c²)) / (A²c + √(A² − 1 + c²)),
/// R = ½ (r_te² + r_tm²) (theory/glass.md, eqs. 5–7;
/// P. Greenup, I. R. Edmonds, R. Compagnon, Lighting Research and Technology 32, 49–54, 2000).
pub fn edmonds_greenup_compagnon(cos_i: f64, n: f64) -> f64 {
    let (c, a2) = (cos_i, n * n);
    // A times the cosine of refraction
    let root = (a2 - 1.0 + c * c).sqrt();
    if root + c == 0.0 {
        // no boundary at all (A = 1), met along itself
        return 0.0;
    }
    let r_te = (c - root) / (c + root);
    let r_tm = (a2 * c - root) / (a2 * c + root);
    0.5 * (r_te * r_te + r_tm * r_tm)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Interface;

    /// It is Fresnel's law written otherwise.
    #[test]
    fn agrees_with_fresnel() {
        for degrees in 0..90 {
            let cos_i = f64::from(degrees).to_radians().cos();
            for n in [1.0, 1.33, 1.49, 1.526, 2.4] {
                let fresnel = Interface { n_i: 1.0, n_t: n }.reflectance(cos_i);
                assert!((edmonds_greenup_compagnon(cos_i, n) - fresnel).abs() < 1e-13);
            }
        }
    }
}
