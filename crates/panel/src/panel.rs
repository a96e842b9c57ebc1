//! A panel: a profile, its media at one or several wavelengths, and how exactly to follow light through it.

use crate::{
    differential::move_alike,
    error::PanelError,
    finish::{self, finish},
    flux::{Limits, Payload, Solver, Wave},
    media::Media,
    profile::Profile,
    walk::Walk,
};
use hemisphere::{Direction, Vec3};
use optics::{Side, Slopes, Stokes};
use std::sync::Arc;

/// How polarisation is treated.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Polarisation {
    /// Light is unpolarised again at every hit: what the literature on these panels does.
    Averaged,
    /// Stokes vectors are carried along each beam.
    Resolved,
}

/// The media at one wavelength, and how much that wavelength counts.
#[derive(Clone, Debug, PartialEq)]
pub struct Sample {
    /// Indices and absorption.
    pub media: Media,
    /// Share of the whole, all samples together 1.
    pub weight: f64,
}

/// A light-redirecting panel, ready to be asked where light goes.
#[derive(Clone, Debug)]
pub struct Panel {
    profile: Arc<Profile>,
    spectrum: Vec<Sample>,
    walks: Vec<(Walk, f64)>,
    polarisation: Polarisation,
    limits: Limits,
}

/// One parallel beam that leaves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Beam {
    /// Where it travels.
    pub direction: Direction,
    /// Power, as a share of the incident, and polarisation about the reference axes of the direction.
    pub stokes: Stokes,
    /// Least number of total internal reflections on its way.
    pub total_reflections: u16,
    /// How its direction changes with that of the light, if that was asked for.
    pub slopes: Option<Slopes>,
}

/// All that becomes of one incident beam: the powers and `absorbed` and `residual` sum to 1.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Outcome {
    /// The beams, strongest first, no two of one direction.
    pub beams: Vec<Beam>,
    /// Share absorbed.
    pub absorbed: f64,
    /// Share not followed to its end.
    pub residual: f64,
    /// Share that was still under way when the budget ended and was followed by a quasi-random walk.
    pub walked: f64,
    /// Pieces of light followed.
    pub pieces: u64,
    /// Share that was moved along a facet to save work: a bound on the error by that.
    pub displaced: f64,
}

/// How the light of one incident beam divides.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Shares {
    /// Leaves on the far side.
    pub transmittance: f64,
    /// Leaves on the side it came from.
    pub reflectance: f64,
    /// Absorbed.
    pub absorptance: f64,
    /// Leaves on the far side with its vertical sense reversed.
    pub transmittance_deflected: f64,
    /// Leaves on the far side with its vertical sense kept.
    pub transmittance_undeflected: f64,
    /// Not followed to its end.
    pub residual: f64,
}

/// Working memory for one thread.
#[derive(Debug, Default)]
pub struct Workspace {
    averaged: Solver<f64>,
    in_plane: Solver<[f64; 2]>,
    skew: Solver<Stokes>,
}

impl Panel {
    /// A panel whose media are known at every wavelength of `spectrum`.
    pub fn new(
        profile: Arc<Profile>,
        spectrum: Vec<Sample>,
        polarisation: Polarisation,
        limits: Limits,
    ) -> Result<Self, PanelError> {
        if spectrum.is_empty() {
            return Err(PanelError::Empty { name: "wavelength_nm" });
        }
        for sample in &spectrum {
            sample.media.suffice_for(&profile)?;
        }
        if !(limits.tolerance > 0.0 && limits.tolerance < 1.0) {
            let rule = "between 0 and 1".into();
            return Err(PanelError::OutOfRange { name: "tolerance", rule, value: limits.tolerance });
        }
        let walk = |s: &Sample| (Walk::new(&profile, &s.media, polarisation), s.weight);
        let walks = spectrum.iter().map(walk).collect();
        Ok(Self { profile, spectrum, walks, polarisation, limits })
    }

    /// Its cross-section.
    pub fn profile(&self) -> &Profile {
        &self.profile
    }

    /// Its media.
    pub fn spectrum(&self) -> &[Sample] {
        &self.spectrum
    }

    /// Monte Carlo walks through it, one for each wavelength, with the weights of those.
    pub fn walks(&self) -> &[(Walk, f64)] {
        &self.walks
    }

    /// How it treats polarisation.
    pub fn polarisation(&self) -> Polarisation {
        self.polarisation
    }

    /// Where the light of a plane wave goes: exact, no random numbers.
    pub fn outcome(&self, incident: Direction, workspace: &mut Workspace) -> Result<Outcome, PanelError> {
        self.outcome_of((incident, UNPOLARISED), workspace)
    }

    /// The same for light of these Stokes parameters, about the reference axes of its direction and of power one. In the plane
    /// across the cuts s and p light never mix, and the last two parameters, which no power depends on there, are left out.
    pub fn outcome_of(&self, wave: (Direction, Stokes), workspace: &mut Workspace) -> Result<Outcome, PanelError> {
        self.follow(wave, false, workspace)
    }

    /// The same for unpolarised light, and how each beam moves with it: beams of one direction that part are two.
    pub fn moving_outcome(&self, incident: Direction, workspace: &mut Workspace) -> Result<Outcome, PanelError> {
        self.follow((incident, UNPOLARISED), true, workspace)
    }

    fn follow(
        &self,
        (incident, light): (Direction, Stokes),
        moves: bool,
        workspace: &mut Workspace,
    ) -> Result<Outcome, PanelError> {
        if !self.profile.is_smooth() {
            return Err(PanelError::RoughCut);
        }
        let mut outcome = Outcome::default();
        if let Some(mirrored) = skimming(incident) {
            let slopes = moves.then_some([[1.0, 0.0], [0.0, 1.0]]);
            outcome.add(Beam { direction: mirrored, stokes: light, total_reflections: 0, slopes });
            return Ok(outcome);
        }
        let in_plane = is_across_the_cuts(incident);
        let wave = Wave { incident: incident.vector(), light, moves };
        for i in 0..self.spectrum.len() {
            match (self.polarisation, in_plane) {
                (Polarisation::Averaged, _) => self.add(&mut workspace.averaged, i, wave, &mut outcome),
                (Polarisation::Resolved, true) => self.add(&mut workspace.in_plane, i, wave, &mut outcome),
                (Polarisation::Resolved, false) => self.add(&mut workspace.skew, i, wave, &mut outcome),
            }
        }
        outcome.beams.sort_by(|a, b| b.stokes[0].total_cmp(&a.stokes[0]));
        Ok(outcome)
    }

    /// How the light of a plane wave divides.
    pub fn shares(&self, incident: Direction, workspace: &mut Workspace) -> Result<Shares, PanelError> {
        let outcome = self.outcome(incident, workspace)?;
        let mut shares = Shares { absorptance: outcome.absorbed, residual: outcome.residual, ..Shares::default() };
        for beam in &outcome.beams {
            shares.count(incident, beam.direction.vector(), beam.stokes[0]);
        }
        Ok(shares)
    }

    fn add<P: Payload>(
        &self,
        solver: &mut Solver<P>,
        sample: usize,
        Wave { incident, light, moves }: Wave<Stokes>,
        outcome: &mut Outcome,
    ) {
        let Sample { media, weight } = &self.spectrum[sample];
        solver.solve(&self.profile, media, Wave { incident, light: P::of_stokes(light), moves }, self.limits);
        for leaving in solver.leaving() {
            let stokes = leaving.light.times(*weight).stokes();
            let direction = Direction::from_unit(solver.direction(leaving.direction));
            let slopes = moves.then(|| solver.slopes(leaving.direction));
            outcome.add(Beam { direction, stokes, total_reflections: leaving.total_reflections, slopes });
        }
        outcome.absorbed += weight * solver.absorbed();
        outcome.displaced += weight * solver.displaced();
        outcome.pieces += solver.pieces();
        if solver.waiting_power() <= self.limits.tolerance {
            outcome.residual += weight * solver.residual();
        } else {
            outcome.residual += weight * solver.lost();
            finish(solver, moves, (&self.walks[sample].0, *weight), outcome);
        }
    }
}

impl Outcome {
    /// A bound on the standard error of any share by the walk that finished: that of as many independent rays, of which
    /// half go one way.
    pub fn walked_standard_error(&self) -> f64 {
        0.5 * self.walked / f64::from(finish::rays(self.walked)).sqrt()
    }

    /// Adds light to the beam of its direction, if there is one that moves alike.
    pub(crate) fn add(&mut self, light: Beam) {
        let is_same = |b: &&mut Beam| {
            // most are told apart by their height alone
            (b.direction.y - light.direction.y).powi(2) < SAME_DIRECTION
                && (b.direction.vector() - light.direction.vector()).length_squared() < SAME_DIRECTION
                && move_alike(b.slopes, light.slopes)
        };
        match self.beams.iter_mut().find(is_same) {
            Some(beam) => {
                beam.stokes.iter_mut().zip(light.stokes).for_each(|(sum, x)| *sum += x);
                beam.total_reflections = beam.total_reflections.min(light.total_reflections);
            }
            None => self.beams.push(light),
        }
    }
}

/// Whether light stays in the plane across the cuts.
pub(crate) fn is_across_the_cuts(incident: Direction) -> bool {
    incident.x.abs() < 1e-15
}

/// Unpolarised light of power one.
const UNPOLARISED: Stokes = [1.0, 0.0, 0.0, 0.0];

/// Light that runs along the sheet to rounding meets no facet: all of it is mirrored, the limit of grazing incidence.
/// The direction it takes, or nothing for any other light.
pub(crate) fn skimming(incident: Direction) -> Option<Direction> {
    let v = incident.vector();
    (v.z.abs() < LEAST_COMPONENT).then(|| Direction::from_unit(Vec3::new(v.x, v.y, -v.z)))
}

/// Least component across the sheet that is followed: 6·10⁻⁸ degrees from it.
const LEAST_COMPONENT: f64 = 1e-9;

/// Square of the angle below which two directions are one.
pub(crate) const SAME_DIRECTION: f64 = 1e-18;

impl Shares {
    /// Adds light that came along `incident` and leaves along `leaving`. Light that comes in level has no vertical sense
    /// to reverse: all of it counts as undeflected.
    pub fn count(&mut self, incident: Direction, leaving: Vec3, power: f64) {
        if Side::left_along(leaving) == Side::entered_along(incident.vector()) {
            self.reflectance += power;
            return;
        }
        self.transmittance += power;
        if leaving.y * incident.y < -1e-15 {
            self.transmittance_deflected += power;
        } else {
            self.transmittance_undeflected += power;
        }
    }
}

/// The direction of incidence of house words: elevation > 0 from above, azimuth about the panel's y axis (NOTATION.md).
pub fn incident_direction(elevation: f64, azimuth: f64, side: Side) -> Direction {
    let (sin_e, cos_e) = elevation.sin_cos();
    let (sin_a, cos_a) = azimuth.sin_cos();
    let z = cos_a * cos_e;
    let z = if side == Side::Front { z } else { -z };
    // a component along the cuts that is only rounding is none
    let x = if sin_a.abs() < 1e-15 { 0.0 } else { sin_a * cos_e };
    Direction::from_unit(Vec3::new(x, -sin_e, z))
}
