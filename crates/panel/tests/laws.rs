//! Laws that hold for every panel and every direction.

use ::panel::{
    Beam, Finish, Media, Optical, Outcome, Panel, Polarisation, Profile, Sample, Shares, Workspace,
    flux::Limits,
    incident_direction,
    shape::{LaserCut, Prismatic, Ridges, pane},
    walk::estimate_shares,
};
use hemisphere::{Direction, Vec3};
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
        let outcome = panel.outcome(incident, &mut Workspace::default()).expect("smooth");
        let slack = 3e-4 + 5.0 * outcome.walked_standard_error();
        for (a, b, e) in [
            (exact.transmittance, mean.transmittance, error.transmittance),
            (exact.reflectance, mean.reflectance, error.reflectance),
            (exact.absorptance, mean.absorptance, error.absorptance),
        ] {
            // five standard errors: 144 comparisons a run
            prop_assert!((a - b).abs() <= 5.0 * e + slack, "{a} {b} ± {e} (walked {})", outcome.walked);
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
        let outcome = |profile, elevation: f64, azimuth: f64| {
            panel(profile, 1.49, 0.0, Polarisation::Resolved, 1e-6)
                .outcome(incident_direction(elevation.to_radians(), azimuth.to_radians(), Side::Front), &mut Workspace::default())
                .expect("smooth")
        };
        let one = outcome(shape(lower, upper), elevation, azimuth);
        let other = outcome(shape(upper, lower), -elevation, -azimuth);
        let upwards = |o: &Outcome, sign: f64| -> f64 {
            let is_upward = |b: &&Beam| b.direction.z > 0.0 && sign * b.direction.y > 0.0;
            o.beams.iter().filter(is_upward).map(|b| b.stokes[0]).sum()
        };
        let slack = 2e-6 + 5.0 * (one.walked_standard_error() + other.walked_standard_error());
        prop_assert!((upwards(&one, 1.0) - upwards(&other, -1.0)).abs() < slack);
        prop_assert!((upwards(&one, -1.0) - upwards(&other, 1.0)).abs() < slack);
    }

    /// Helmholtz: T(i → o) = T(o → i) |∂k_y,o / ∂k_y,i| for each lobe of unpolarised light (theory/panels.md, eq. 11).
    #[test]
    fn lobes_are_reciprocal(
        lower in 20.0..70.0_f64, upper in 20.0..70.0_f64, elevation in -75.0..75.0_f64, azimuth in -60.0..60.0_f64,
        polarisation in any_polarisation(),
    ) {
        let shape = Prismatic { pitch: 1.0, lower_deg: lower, upper_deg: upper, base: 0.4, ridges: Ridges::Back };
        let panel = panel(shape.profile().expect("valid"), 1.49, 0.2, polarisation, 1e-7);
        let outcome = |d: Direction| panel.outcome(d, &mut Workspace::default()).expect("smooth");
        let nearest = |o: &Outcome, d: Vec3| {
            let distance = |b: &Beam| (b.direction.vector() - d).length();
            o.beams.iter().copied().min_by(|a, b| distance(a).total_cmp(&distance(b))).filter(|b| distance(b) < 1e-3)
        };
        let incident = incident_direction(elevation.to_radians(), azimuth.to_radians(), Side::Front);
        let there = outcome(incident);
        // the same k_x, a little more or less k_y
        let step = 1e-6;
        let beside = |dy: f64| {
            let (x, y) = (incident.x, incident.y + dy);
            outcome(Direction::of(Vec3::new(x, y, (1.0 - x * x - y * y).sqrt())).expect("finite"))
        };
        let (below, above) = (beside(-step), beside(step));
        for beam in there.beams.iter().filter(|b| b.stokes[0] > 1e-3).take(3) {
            let direction = beam.direction.vector();
            let (Some(low), Some(high)) = (nearest(&below, direction), nearest(&above, direction)) else { continue };
            let stretch = ((high.direction.y - low.direction.y) / (2.0 * step)).abs();
            let back = outcome(-beam.direction);
            let back_power = nearest(&back, -incident.vector()).map_or(0.0, |b| b.stokes[0]);
            let (one, other) = (beam.stokes[0], back_power * stretch);
            let slack = 1e-5 + 5.0 * (there.walked_standard_error() + back.walked_standard_error() * stretch);
            prop_assert!((one - other).abs() < slack, "{one} {other} ± {slack}");
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

/// Light that runs exactly along the sheet is mirrored, whichever way it runs.
#[test]
fn light_along_the_sheet_is_mirrored() {
    let profile = LaserCut { cut_width: 0.05, ..LaserCut::ideal(0.5, 1.0) }.profile().expect("valid");
    let panel = panel(profile, 1.49, 0.1, Polarisation::Resolved, 1e-6);
    for incident in [Vec3::X, -Vec3::Y, Vec3::new(0.6, 0.8, 0.0)] {
        let shares = panel.shares(Direction::from_unit(incident), &mut Workspace::default()).expect("smooth");
        assert_eq!(sum(&shares), 1.0);
        assert_eq!(shares.absorptance, 0.0);
    }
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

/// A kerf is closed by mouths: every facet of a panel cut through looks into a closed region on both hands but for its
/// outermost faces, which look into the open.
#[test]
fn cuts_with_a_width_are_closed_by_mouths() {
    let cut = LaserCut { cut_width: 0.3, cut_tilt_deg: vec![10.0], ..LaserCut::ideal(4.0, 6.0) };
    let profile = cut.profile().expect("it can be cut");
    let topology = profile.topology();
    assert_eq!(topology.mouths().len(), 2);
    let hands = (0..profile.facets().len()).flat_map(|f| [::panel::HalfEdge::left(f), ::panel::HalfEdge::right(f)]);
    let open = hands.filter(|&h| topology.region(h).is_none()).count();
    assert_eq!(open, 2, "the two faces alone look into the open");
}

/// Light that runs almost along the sheet within a bar of acrylic meets the next cut and is not given up: tilted kerfs at 65°.
#[test]
fn light_along_the_sheet_is_followed_inside_a_bar() {
    let cut = LaserCut { cut_width: 0.3, cut_tilt_deg: vec![10.0], ..LaserCut::ideal(4.0, 6.0) };
    let one = panel(cut.profile().expect("it can be cut"), 1.49, 0.0, Polarisation::Resolved, 1e-6);
    let incident = incident_direction(65.0_f64.to_radians(), 0.0, Side::Front);
    let shares = one.shares(incident, &mut Workspace::default()).expect("it is smooth");
    assert!(shares.residual < 1e-6, "{}", shares.residual);
}
