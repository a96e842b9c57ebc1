//! Laws that hold for every panel and every direction.

use ::panel::{
    Finish, Media, Optical, Panel, Polarisation, Profile, Sample, Shares, Workspace,
    flux::Limits,
    incident_direction,
    shape::{LaserCut, Prismatic, Ridges, pane},
    walk::estimate_shares,
};
use optics::Side;
use proptest::prelude::*;
use std::sync::Arc;

fn panel(profile: Profile, n: f64, absorption: f64, polarisation: Polarisation, tolerance: f64) -> Panel {
    let media = Media::in_air(&[Optical { n, absorption }]).expect("valid media");
    let limits = Limits { tolerance, most_pieces: 200_000 };
    Panel::new(Arc::new(profile), vec![Sample { media, weight: 1.0 }], polarisation, limits).expect("valid panel")
}

fn any_profile() -> impl Strategy<Value = Profile> {
    let laser_cut = (0.2..2.0_f64, 0.0..0.2_f64, -15.0..15.0_f64, 0.2..1.0_f64, prop::bool::ANY, prop::bool::ANY)
        .prop_map(|(spacing, width, tilt, depth, has_width, is_partial)| LaserCut {
            cut_width: if has_width { width * spacing } else { 0.0 },
            cut_tilt_deg: vec![tilt],
            cut_depth: is_partial.then(|| vec![depth]),
            ..LaserCut::ideal(spacing, 1.0)
        });
    let prismatic =
        (15.0..75.0_f64, 15.0..75.0_f64, 0.0..1.0_f64, prop::bool::ANY).prop_map(|(lower, upper, base, front)| {
            let ridges = if front { Ridges::Front } else { Ridges::Back };
            Prismatic { pitch: 1.0, lower_deg: lower, upper_deg: upper, base, ridges }
        });
    prop_oneof![
        laser_cut.prop_map(|p| p.profile().expect("valid cuts")),
        prismatic.prop_map(|p| p.profile().expect("valid prisms")),
    ]
}

fn any_polarisation() -> impl Strategy<Value = Polarisation> {
    prop_oneof![Just(Polarisation::Averaged), Just(Polarisation::Resolved)]
}

fn any_side() -> impl Strategy<Value = Side> {
    prop_oneof![Just(Side::Front), Just(Side::Back)]
}

fn sum(s: &Shares) -> f64 {
    s.transmittance + s.reflectance + s.absorptance + s.residual
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 48, ..ProptestConfig::default() })]

    /// Power is never made nor lost: all shares sum to 1 within 1e-12, whatever the panel, the direction and the medium.
    #[test]
    fn every_part_of_the_light_is_accounted_for(
        profile in any_profile(), n in 1.05..1.9_f64, absorption in prop_oneof![Just(0.0), 0.0..1.0_f64],
        elevation in -89.9..89.9_f64, azimuth in -80.0..80.0_f64, side in any_side(), polarisation in any_polarisation(),
    ) {
        let panel = panel(profile, n, absorption, polarisation, 1e-4);
        let incident = incident_direction(elevation.to_radians(), azimuth.to_radians(), side);
        let outcome = panel.outcome(incident, &mut Workspace::default()).expect("smooth");
        let shares = panel.shares(incident, &mut Workspace::default()).expect("smooth");
        prop_assert!((sum(&shares) - 1.0).abs() < 1e-12, "{:e}", sum(&shares) - 1.0);
        prop_assert!(outcome.beams.iter().all(|b| b.stokes[0] > -1e-9));
        prop_assert!(absorption > 0.0 || shares.absorptance.abs() < 1e-12);
    }

    /// The exact solver and the walk are written apart and agree within four standard errors.
    #[test]
    fn exact_shares_agree_with_the_walk(
        profile in any_profile(), n in 1.3..1.7_f64, absorption in prop_oneof![Just(0.0), 0.0..0.5_f64],
        elevation in -75.0..75.0_f64, azimuth in -60.0..60.0_f64, side in any_side(), polarisation in any_polarisation(),
    ) {
        let panel = panel(profile, n, absorption, polarisation, 1e-5);
        let incident = incident_direction(elevation.to_radians(), azimuth.to_radians(), side);
        let exact = panel.shares(incident, &mut Workspace::default()).expect("smooth");
        let estimate = estimate_shares(panel.walks(), incident, 20_000, 7);
        let (mean, error) = (estimate.mean, estimate.standard_error);
        // what the exact result may lack: its tolerance, the bins (2e-4) and the walk that finished it (half over √4096)
        let walked = panel.outcome(incident, &mut Workspace::default()).expect("smooth").walked;
        let slack = 3e-4 + 4.0 * walked * 0.5 / 64.0;
        for (a, b, e) in [
            (exact.transmittance, mean.transmittance, error.transmittance),
            (exact.reflectance, mean.reflectance, error.reflectance),
            (exact.absorptance, mean.absorptance, error.absorptance),
        ] {
            // five standard errors: 144 comparisons a run
            prop_assert!((a - b).abs() <= 5.0 * e + slack, "{a} {b} ± {e} (walked {walked:e})");
        }
        prop_assert!(error.transmittance < 0.01);
    }

    /// Only ratios of lengths count (theory/panels.md, eq. 1).
    #[test]
    fn scale_changes_nothing(
        spacing in 0.2..2.0_f64, tilt in -5.0..5.0_f64, scale in 1e-3..1e3_f64, elevation in -80.0..80.0_f64,
    ) {
        let shape = |k: f64| LaserCut { cut_tilt_deg: vec![tilt], ..LaserCut::ideal(k * spacing, k) }.profile().expect("valid");
        let incident = incident_direction(elevation.to_radians(), 0.3, Side::Front);
        let shares = |k: f64| {
            panel(shape(k), 1.49, 0.1 / k, Polarisation::Resolved, 1e-5).shares(incident, &mut Workspace::default()).expect("smooth")
        };
        let (one, other) = (shares(1.0), shares(scale));
        prop_assert!((one.transmittance - other.transmittance).abs() < 1e-4);
        prop_assert!((one.transmittance_deflected - other.transmittance_deflected).abs() < 1e-4);
    }

    /// A panel turned upside down treats light from below as it treated light from above.
    #[test]
    fn mirror_image_panels_treat_mirror_image_light_alike(
        lower in 20.0..70.0_f64, upper in 20.0..70.0_f64, elevation in -80.0..80.0_f64, azimuth in -60.0..60.0_f64,
    ) {
        let shape = |lower_deg, upper_deg| {
            Prismatic { pitch: 1.0, lower_deg, upper_deg, base: 0.4, ridges: Ridges::Back }.profile().expect("valid")
        };
        let shares = |profile, elevation: f64, azimuth: f64| {
            panel(profile, 1.49, 0.0, Polarisation::Resolved, 1e-6)
                .shares(incident_direction(elevation.to_radians(), azimuth.to_radians(), Side::Front), &mut Workspace::default())
                .expect("smooth")
        };
        let (one, other) = (shares(shape(lower, upper), elevation, azimuth), shares(shape(upper, lower), -elevation, -azimuth));
        prop_assert!((one.transmittance - other.transmittance).abs() < 1e-5);
        prop_assert!((one.transmittance_deflected - other.transmittance_deflected).abs() < 1e-5);
    }

    /// Helmholtz: the power a beam sends along another, over the other's breadth, is the same both ways.
    /// T(i → o) cos θ_i = T(o → i) cos θ_o for one lobe of unpolarised light, both seen as shares of the incident power.
    #[test]
    fn lobes_are_reciprocal(
        lower in 20.0..70.0_f64, upper in 20.0..70.0_f64, elevation in -75.0..75.0_f64, azimuth in -60.0..60.0_f64,
        polarisation in any_polarisation(),
    ) {
        let profile = Prismatic { pitch: 1.0, lower_deg: lower, upper_deg: upper, base: 0.4, ridges: Ridges::Back }.profile().expect("valid");
        let panel = panel(profile, 1.49, 0.2, polarisation, 1e-7);
        let incident = incident_direction(elevation.to_radians(), azimuth.to_radians(), Side::Front);
        let there = panel.outcome(incident, &mut Workspace::default()).expect("smooth");
        for beam in there.beams.iter().filter(|b| b.stokes[0] > 1e-3).take(3) {
            let back = panel.outcome(-beam.direction, &mut Workspace::default()).expect("smooth");
            let found = back.beams.iter().find(|b| (b.direction.vector() + incident.vector()).length() < 1e-8);
            let back_power = found.map_or(0.0, |b| b.stokes[0]);
            // both per unit of area of the sheet
            let (one, other) = (beam.stokes[0] * incident.z.abs(), back_power * beam.direction.z.abs());
            prop_assert!((one - other).abs() < 1e-4, "{one} {other}");
        }
    }
}

/// A rough cut scatters, but loses nothing: the walk's shares sum to one, and the exact solver refuses.
#[test]
fn rough_cuts_lose_nothing() {
    let finish = Finish { slope: 0.03, diffuse: 0.1 };
    let rough = LaserCut { finish, ..LaserCut::ideal(0.5, 1.0) };
    let panel = panel(rough.profile().expect("valid"), 1.49, 0.0, Polarisation::Resolved, 1e-6);
    let incident = incident_direction(0.9, 0.2, Side::Front);
    let estimate = estimate_shares(panel.walks(), incident, 50_000, 1);
    assert!((sum(&estimate.mean) - 1.0).abs() < 1e-12);
    let smooth = estimate_shares(
        self::panel(LaserCut::ideal(0.5, 1.0).profile().expect("valid"), 1.49, 0.0, Polarisation::Resolved, 1e-6)
            .walks(),
        incident,
        50_000,
        1,
    );
    let fall = smooth.mean.transmittance_deflected - estimate.mean.transmittance_deflected;
    assert!(
        fall > 10.0 * estimate.standard_error.transmittance_deflected,
        "haze takes from the deflected beam: {fall}"
    );
    assert!(panel.outcome(incident, &mut Workspace::default()).is_err());
}

/// The result does not depend on the number of threads.
#[test]
fn threads_change_nothing() {
    let panel = panel(pane(1.0).expect("valid"), 1.5, 0.1, Polarisation::Resolved, 1e-6);
    let incident = incident_direction(0.7, 0.1, Side::Front);
    let on = |threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("a pool");
        pool.install(|| estimate_shares(panel.walks(), incident, 10_000, 5))
    };
    assert_eq!(on(1), on(3));
    assert_ne!(on(1), estimate_shares(panel.walks(), incident, 10_000, 6));
}
