//! The beams that one point of the sun sends through a scene: every direction its light takes after mirrors and windows, and what
//! turned it there (theory/room.md, eq. 12; theory/mirrored_sun.md, eq. 1).

use super::turners::Turners;
use crate::RoomError;
use crate::scene::Scene;
use crate::surface::Kind;
use hemisphere::{Direction, Vec3};
use optics::Lobes;
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// The most of a window's light that may have no definite direction; what there is of it counts as cut off.
const RESIDUAL: f64 = 3e-3;

/// A beam of less than this share of the sun's normal illuminance is not followed to another turn.
const LEAST_STRENGTH: f64 = 1e-4;

/// Directions that the light of one point of the sun may take; the strongest come first.
pub const MOST_WAYS: usize = 1024;

/// Directions nearer than this are one \[rad\].
const SAME: f64 = 1e-6;

/// The number of the way straight from the sun.
pub const FROM_SUN: u32 = 0;

/// Light that a facet sends along one way.
#[derive(Clone, Debug)]
pub struct Beam {
    /// The mirror's facet, or the window.
    pub facet: u32,
    /// Which way it belongs to: all light of one direction.
    pub way: u32,
    /// Which way the light comes along before.
    pub before: u32,
    /// Where it travels.
    pub direction: Vec3,
    /// How far it has come for each metre off the facet's plane.
    pub way_per_height: f64,
    /// Illuminance across it over that across the light before.
    pub strength: f64,
    pub redirected: bool,
    /// Whether it is sunlight that passes straight through a clear window.
    pub passes: bool,
}

/// What one point of the sun sends.
#[derive(Default)]
pub struct Beams {
    /// Directions of the ways, the sun's own first.
    pub ways: Vec<Vec3>,
    /// Those that may light something, then those that are only turned again.
    pub beams: Vec<Beam>,
    /// How many may light something.
    pub lighting: usize,
    /// Summed strength of the beams that were not followed on, and of light of which no direction is known.
    pub cut_off: f64,
}

/// All directions found so far, and what is still to be followed, the strongest first.
struct Growth<'a> {
    scene: &'a Scene,
    turners: &'a Turners,
    /// Their directions, and which turners have met, and sent on, light along each.
    ways: Vec<Vec3>,
    met: Vec<bool>,
    sent: Vec<bool>,
    beams: Vec<(Beam, bool)>,
    /// Strength, as the bits of a positive number are in order too, way and turner of the light still to be followed.
    to_follow: BinaryHeap<(u64, Reverse<(u32, usize)>)>,
    cut_off: f64,
    lobes: Lobes,
}

impl Beams {
    /// Those of the sun `towards` here.
    pub fn of(scene: &Scene, turners: &Turners, towards: Vec3) -> Result<Self, RoomError> {
        // a sun that has set sends none
        if towards.z <= 0.0 {
            return Ok(Self::default());
        }
        let mut growth = Growth {
            scene,
            turners,
            ways: Vec::new(),
            met: Vec::new(),
            sent: Vec::new(),
            beams: Vec::new(),
            to_follow: BinaryHeap::new(),
            cut_off: 0.0,
            lobes: Lobes::default(),
        };
        growth.way(-towards);
        for turner in 0..turners.all.len() {
            if growth.is_lit(turner, towards) {
                growth.pass(turner, -towards);
                growth.turn(turner, FROM_SUN, 1.0)?;
            }
        }
        while let Some((strength, Reverse((way, turner)))) = growth.to_follow.pop() {
            let strength = f64::from_bits(strength);
            let onward: Vec<usize> = turners.onward(scene, turner, growth.ways[way as usize]).collect();
            for next in onward {
                if strength < LEAST_STRENGTH {
                    growth.cut_off += strength;
                    break;
                }
                growth.turn(next, way, strength)?;
            }
        }
        let Growth { ways, mut beams, cut_off, .. } = growth;
        beams.sort_by_key(|(_, lights)| !lights);
        let lighting = beams.iter().filter(|(_, lights)| *lights).count();
        Ok(Self { ways, beams: beams.into_iter().map(|(beam, _)| beam).collect(), lighting, cut_off })
    }
}

impl Growth<'_> {
    /// The number of the way of this direction; `None` if there are too many.
    fn way(&mut self, direction: Vec3) -> Option<u32> {
        let known = self.ways.iter().position(|way| (*way - direction).length_squared() < SAME * SAME);
        if known.is_none() && self.ways.len() < MOST_WAYS {
            self.ways.push(direction);
            let turners = self.turners.all.len();
            self.met.resize(self.ways.len() * turners, false);
            self.sent.resize(self.ways.len() * turners, false);
            return Some(self.ways.len() as u32 - 1);
        }
        known.map(|way| way as u32)
    }

    /// Whether the sun may reach a turner straight: its middle is seen from there, or no shadow covers the whole.
    fn is_lit(&self, turner: usize, towards: Vec3) -> bool {
        let facet = self.turners.all[turner].facet;
        let shape = self.scene.facet(facet);
        shape.normal.dot(towards) != 0.0
            && (self.scene.is_open(facet, shape.point([0.5; 2]), towards)
                || !self.turners.screens.hide(self.scene, facet, towards))
    }

    /// The light that a clear window passes straight on.
    fn pass(&mut self, turner: usize, direction: Vec3) {
        let facet = self.turners.all[turner].facet;
        let Kind::Window { glazing, frame } = &self.scene.surface_of(facet).kind else { return };
        let incident = frame.inward(direction);
        let Some(straight) = glazing.straight(Direction::from_unit(incident)) else { return };
        if straight.transmittance > 0.0 {
            let (lights, way_per_height) = (self.turners.lights(self.scene, turner, direction), 1.0 / incident.z);
            let strength = straight.transmittance;
            let way = FROM_SUN;
            let beam =
                Beam { facet, way, before: way, direction, way_per_height, strength, redirected: false, passes: true };
            self.beams.push((beam, lights));
        }
    }

    /// What becomes of the light of a way at a turner it meets for the first time: `strength` is that of the light there.
    fn turn(&mut self, turner: usize, before: u32, strength: f64) -> Result<(), RoomError> {
        let known = before as usize * self.turners.all.len() + turner;
        if std::mem::replace(&mut self.met[known], true) {
            return Ok(());
        }
        let (facet, direction) = (self.turners.all[turner].facet, self.ways[before as usize]);
        let surface = self.scene.surface_of(facet);
        match &surface.kind {
            Kind::Opaque(material) => {
                self.send(turner, before, self.mirrored(facet, before), material.specular, false, strength)
            }
            Kind::Window { glazing, frame } => {
                let incident = Direction::from_unit(frame.inward(direction));
                if let Some(straight) = glazing.straight(incident) {
                    self.send(turner, before, self.mirrored(facet, before), straight.reflectance, false, strength);
                    return Ok(());
                }
                let mut lobes = std::mem::take(&mut self.lobes);
                glazing.lobes(incident, &mut lobes);
                if lobes.residual > RESIDUAL {
                    return Err(RoomError::NoLobes { name: surface.name.clone(), residual: lobes.residual });
                }
                // what has no direction is missing: as much as if it left square to the window
                self.cut_off += strength * lobes.residual.max(0.0) * incident.z.abs();
                for lobe in &lobes.beams {
                    // the beam keeps its width along the window: across, it is narrowed or widened with its cosine
                    let share = lobe.power * (incident.z / lobe.direction.z).abs();
                    let leaves = frame.outward(*lobe.direction);
                    self.send(turner, before, leaves, share, lobe.total_reflections > 0, strength);
                }
                self.lobes = lobes;
            }
            Kind::Interface { .. } => {}
        }
        Ok(())
    }

    fn mirrored(&self, facet: u32, way: u32) -> Vec3 {
        let (normal, direction) = (self.scene.facet(facet).normal, self.ways[way as usize]);
        direction - 2.0 * direction.dot(normal) * normal
    }

    /// Light that leaves a turner: a beam, to be followed if it is the first there along its way.
    fn send(&mut self, turner: usize, before: u32, direction: Vec3, share: f64, redirected: bool, strength: f64) {
        let facet = self.turners.all[turner].facet;
        let cos = self.scene.facet(facet).normal.dot(direction);
        if share <= 0.0 || cos == 0.0 {
            return;
        }
        let Some(way) = self.way(direction) else {
            self.cut_off += share * strength;
            return;
        };
        // rounding apart, the direction of all light of this way
        let direction = self.ways[way as usize];
        let lights = self.turners.lights(self.scene, turner, direction);
        let beam = Beam {
            facet,
            way,
            before,
            direction,
            way_per_height: 1.0 / cos,
            strength: share,
            redirected,
            passes: false,
        };
        self.beams.push((beam, lights));
        let known = way as usize * self.turners.all.len() + turner;
        if !std::mem::replace(&mut self.sent[known], true) {
            self.to_follow.push(((share * strength).to_bits(), Reverse((way, turner))));
        }
    }
}
