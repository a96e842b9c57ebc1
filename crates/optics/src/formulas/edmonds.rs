//! Edmonds' two rules for laser-cut panels: how much is deflected, and how far to tilt the panel.

/// Angle above the horizontal at which light from a panel of Edmonds' tilt leaves into the room [rad].
const EXIT_ABOVE_HORIZONTAL: f64 = 8.0 * std::f64::consts::PI / 180.0;

/// Share of the light inside an ideal laser-cut panel that meets an odd number of cuts, and so leaves deflected:
/// a triangle wave of x = (W/D) tan θ_t, sin θ_t = sin θ / n (theory/glass.md, eqs. 9–10;
/// I. R. Edmonds, Solar Energy Materials and Solar Cells 29, 1–26, 1993). `width_over_spacing` is W/D: thickness over spacing.
///
/// Total internal reflection at the cuts is taken for granted; Fresnel losses are not in it.
pub fn edmonds_deflected_fraction(cos_i: f64, n: f64, width_over_spacing: f64) -> f64 {
    let sin_t = (1.0 - cos_i * cos_i).max(0.0).sqrt() / n;
    // how many spacings the light climbs while it crosses the panel
    let x = width_over_spacing * sin_t / (1.0 - sin_t * sin_t).sqrt();
    // climbing 0, 2, 4 … spacings all light meets an even number of cuts; 1, 3, 5 … an odd one
    let phase = x.rem_euclid(2.0);
    if phase <= 1.0 { phase } else { 2.0 - phase }
}

/// Tilt of a panel that sends light of altitude E (its cuts turned by the tilt, so that it leaves at E − 2·tilt) into
/// the room at 8° above the horizontal: ½ (E − 8°) (theory/glass.md, eq. 11; Edmonds 1993). Radians in and out.
pub fn edmonds_panel_tilt(altitude: f64) -> f64 {
    0.5 * (altitude - EXIT_ABOVE_HORIZONTAL)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Nothing at normal incidence, all of it after one spacing, nothing again after two.
    #[test]
    fn triangle_wave_turns_at_whole_spacings() {
        let n = 1.49;
        let cos_i = 60_f64.to_radians().cos();
        let tan_t = (60_f64.to_radians().sin() / n).asin().tan();
        let fraction = |spacings: f64| edmonds_deflected_fraction(cos_i, n, spacings / tan_t);
        for (spacings, expected) in [(0.0, 0.0), (0.25, 0.25), (1.0, 1.0), (1.5, 0.5), (2.0, 0.0), (3.25, 0.75)] {
            assert!((fraction(spacings) - expected).abs() < 1e-12, "{spacings}");
        }
        assert_eq!(edmonds_deflected_fraction(1.0, n, 2.0), 0.0);
    }

    /// Light from 60° leaves a panel tilted by 26° at 60 − 2·26 = 8 degrees.
    #[test]
    fn tilted_panel_sends_light_out_at_eight_degrees() {
        let tilt = edmonds_panel_tilt(60_f64.to_radians());
        assert!((tilt.to_degrees() - 26.0).abs() < 1e-12);
    }
}
