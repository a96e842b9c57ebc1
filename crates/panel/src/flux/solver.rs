//! The exact solver: plane waves between facets, split by Fresnel, merged wherever they meet again.
//!
//! Light that arrives at one hand of a facet in one direction is a *bundle*: a density along the facet. The strongest bundles
//! are taken, split into a mirrored and a refracted part, and each part handed to the facets it sees, where it is added to
//! what already waits there. The work grows with the number of bundles, not with the number of paths
//! (theory/panels.md, section "The exact solver").

mod emission;
mod places;

use super::{
    density::{Density, Part, Piece},
    directions::{DirectionId, Directions},
    payload::{Payload, Turns},
    sight::{Sight, Source, Target, look},
};
use crate::{
    differential::Differential, facet::Surface, media::Media, plane::Vec2, profile::Profile, topology::HalfEdge,
};
use hemisphere::Vec3;
use optics::{Interface, Mueller, Slopes, Split};
use places::Places;

/// When to stop.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limits {
    /// Share of the incident power that may stay unfollowed.
    pub tolerance: f64,
    /// Pieces of light to follow at most.
    pub most_pieces: u64,
}

impl Default for Limits {
    fn default() -> Self {
        Self { tolerance: 1e-6, most_pieces: 1_000_000 }
    }
}

/// Bundles (facet, hand and direction) kept at most: cuts whose tilt is no even part of a turn send light into ever new
/// directions, and there the walk that finishes is the better tool.
const MOST_BUNDLES: usize = 1500;
/// A bundle's turn comes when it has this share of what the strongest has: few looks at all of them, and light that comes
/// from many has time to gather.
const STRONG: f64 = 0.25;
/// Share of the tolerance that joining neighbours may displace in all, and at one joint.
const DISPLACED_SHARE: f64 = 1.0;
const MERGE_SHARE: f64 = 1e-3;

/// A plane wave of power one.
#[derive(Clone, Copy, Debug)]
pub struct Wave<P> {
    /// Where it travels: a unit vector with z ≠ 0.
    pub incident: Vec3,
    /// What it carries.
    pub light: P,
    /// Whether beams that leave along one direction but part as it moves are told apart.
    pub moves: bool,
}

/// Light that has left.
#[derive(Clone, Copy, Debug)]
pub struct Leaving<P> {
    /// Where it travels.
    pub direction: DirectionId,
    /// What it carries.
    pub light: P,
    /// Least number of total reflections on its way.
    pub total_reflections: u16,
}

/// Light leaving one hand of a facet in one direction: what it sees.
#[derive(Clone, Copy, Debug)]
struct Channel {
    /// Its stretches, in `Solver::stretches`.
    first: u32,
    last: u32,
    /// Absorption per unit of distance within the section.
    absorption: f64,
}

/// A sight whose target has been looked up.
#[derive(Clone, Copy, Debug)]
struct Stretch {
    sight: Sight,
    sink: Sink,
}

#[derive(Clone, Copy, Debug)]
enum Sink {
    Bundle(u32),
    Leaving(u32),
    Nowhere,
}

/// Where a part of a bundle goes on.
#[derive(Clone, Copy, Debug)]
struct Exit<A> {
    channel: u32,
    action: A,
    adds_total_reflection: bool,
}

/// Light that arrives at one hand of a facet in one direction.
#[derive(Clone, Debug)]
struct Bundle<P: Payload> {
    at: HalfEdge,
    direction: DirectionId,
    density: Density<P>,
    /// Where it goes: known once it has been taken for the first time.
    exits: Option<[Option<Exit<P::Action>>; 2]>,
}

/// The working memory of the solver; used again from one direction to the next.
#[derive(Debug)]
pub struct Solver<P: Payload> {
    directions: Directions,
    places: Places,
    channels: Vec<Channel>,
    stretches: Vec<Stretch>,
    bundles: Vec<Bundle<P>>,
    bundle_count: usize,
    /// Power that waits in each bundle.
    waiting: Vec<f64>,
    leaving: Vec<Leaving<P>>,
    absorbed: f64,
    lost: f64,
    /// Power moved by joining neighbours that hardly differ, and how much of that is allowed.
    displaced: f64,
    allowance: f64,
    pieces: u64,
    sights: Vec<Sight>,
    taken: Density<P>,
    spare: Density<P>,
    sent: Vec<Part<P>>,
    arriving: Vec<Part<P>>,
}

impl<P: Payload> Default for Solver<P> {
    fn default() -> Self {
        Self {
            directions: Directions::default(),
            places: Places::default(),
            channels: Vec::new(),
            stretches: Vec::new(),
            bundles: Vec::new(),
            bundle_count: 0,
            waiting: Vec::new(),
            leaving: Vec::new(),
            absorbed: 0.0,
            lost: 0.0,
            displaced: 0.0,
            allowance: 0.0,
            pieces: 0,
            sights: Vec::new(),
            taken: Density::default(),
            spare: Density::default(),
            sent: Vec::new(),
            arriving: Vec::new(),
        }
    }
}

impl<P: Payload> Solver<P> {
    /// Follows a plane wave until no more than the tolerance waits.
    pub fn solve(
        &mut self,
        profile: &Profile,
        media: &Media,
        Wave { incident, light, moves }: Wave<P>,
        limits: Limits,
    ) {
        self.reset(incident.x, moves);
        self.places.reset(2 * profile.facets().len());
        self.allowance = DISPLACED_SHARE * limits.tolerance;
        let medium = if incident.z > 0.0 { profile.front() } else { profile.back() };
        let direction = self.directions.enter(incident, medium, media.get(medium).n);
        let (z_min, z_max) = profile.z_range();
        let z = if incident.z > 0.0 { z_min } else { z_max };
        let sky = Source { start: Vec2::new(z, 0.0), end: Vec2::new(z, profile.period()), hand: None, medium };
        let entry = self.open_channel(profile, media, sky, direction);
        let piece = Piece { mean: light, slope: P::ZERO, total_reflections: 0 };
        self.emit(entry, &[Part { start: 0.0, end: 1.0, piece }]);
        loop {
            let strongest = self.waiting.iter().fold(0.0, |most: f64, &power| most.max(power));
            if self.waiting_power() <= limits.tolerance {
                break;
            }
            let enough = STRONG * strongest;
            for i in 0..self.bundle_count {
                if self.waiting[i] < enough {
                    continue;
                }
                if self.pieces >= limits.most_pieces || self.bundle_count >= MOST_BUNDLES {
                    return;
                }
                self.take(profile, media, i);
            }
        }
    }

    /// What has left, by direction.
    pub fn leaving(&self) -> &[Leaving<P>] {
        &self.leaving
    }

    /// The three-dimensional direction of `id`.
    pub fn direction(&self, id: DirectionId) -> Vec3 {
        self.directions.vector(id)
    }

    /// How it turns with the incident light.
    pub fn turning(&self, id: DirectionId) -> Differential {
        self.directions.turning(id)
    }

    /// Slopes of (x, y) of the direction of `id` with those of the incident light.
    pub fn slopes(&self, id: DirectionId) -> Slopes {
        self.directions.slopes(id)
    }

    /// Share of the power absorbed.
    pub fn absorbed(&self) -> f64 {
        self.absorbed
    }

    /// Share that still waits or runs along the sheet for ever.
    pub fn residual(&self) -> f64 {
        self.lost + self.waiting_power()
    }

    /// Share that still waits.
    pub fn waiting_power(&self) -> f64 {
        self.waiting.iter().sum()
    }

    /// Share that runs along the sheet for ever.
    pub fn lost(&self) -> f64 {
        self.lost
    }

    /// Power displaced along facets by joining neighbours that hardly differ: a bound on the error of that.
    pub fn displaced(&self) -> f64 {
        self.displaced
    }

    /// Pieces of light followed.
    pub fn pieces(&self) -> u64 {
        self.pieces
    }

    /// What still waits: where, in which direction, over which stretch of the facet.
    pub fn waiting(&self) -> impl Iterator<Item = (HalfEdge, DirectionId, Part<P>)> {
        self.bundles[..self.bundle_count]
            .iter()
            .flat_map(|b| b.density.lit().map(move |part| (b.at, b.direction, part)))
    }

    fn reset(&mut self, k_x: f64, tell_apart: bool) {
        self.directions.reset(k_x, tell_apart);
        self.channels.clear();
        self.stretches.clear();
        self.bundle_count = 0;
        self.waiting.clear();
        self.leaving.clear();
        (self.absorbed, self.lost, self.displaced, self.pieces) = (0.0, 0.0, 0.0, 0);
    }

    /// Takes all that waits in a bundle and sends it on.
    fn take(&mut self, profile: &Profile, media: &Media, index: usize) {
        let exits = match self.bundles[index].exits {
            Some(exits) => exits,
            None => {
                let exits = self.split_bundle(profile, media, index);
                self.bundles[index].exits = Some(exits);
                exits
            }
        };
        let mut taken = std::mem::take(&mut self.taken);
        let mut sent = std::mem::take(&mut self.sent);
        self.bundles[index].density.pour_into(&mut taken, self.waiting[index], &mut self.spare);
        if self.displaced < self.allowance {
            self.displaced += taken.coarsen(self.allowance * MERGE_SHARE);
        }
        self.waiting[index] = 0.0;
        for exit in exits.into_iter().flatten() {
            sent.clear();
            sent.extend(taken.lit().map(|part| Part {
                piece: Piece {
                    mean: part.piece.mean.after(&exit.action),
                    slope: part.piece.slope.after(&exit.action),
                    total_reflections:
                        part.piece.total_reflections.saturating_add(u16::from(exit.adds_total_reflection)),
                },
                ..part
            }));
            self.emit(exit.channel, &sent);
        }
        taken.clear();
        (self.taken, self.sent) = (taken, sent);
    }

    /// Snell and Fresnel for a bundle: the part that is mirrored and the part that goes through.
    fn split_bundle(&mut self, profile: &Profile, media: &Media, index: usize) -> [Option<Exit<P::Action>>; 2] {
        let Bundle { at, direction, .. } = self.bundles[index];
        let facet = &profile.facets()[at.facet()];
        let tangent = (facet.end - facet.start).normalized() * at.sign();
        // the normal points back to the side the light comes from
        let normal = tangent.left();
        let arriving = self.directions.vector(direction);
        let cos_i = -(arriving.z * normal.z + arriving.y * normal.y);
        let n_i = media.get(profile.medium(at)).n;
        let (film, n_t) = match facet.surface {
            Surface::Film(gap) => (true, media.get(gap).n),
            Surface::Interface => (false, media.get(profile.medium(at.other())).n),
        };
        let split = Interface { n_i, n_t }.split(cos_i.clamp(0.0, 1.0));
        let mirrored = self.directions.mirror(direction, normal);
        let through = match split {
            Split::Total { .. } => None,
            Split::Partial { .. } if film => Some(direction),
            Split::Partial { .. } => {
                let medium = profile.medium(at.other());
                self.directions.refract(direction, tangent, normal, medium, media.get(medium).n)
            }
        };
        let actions = P::actions(split, film, || self.turns(arriving, normal, mirrored, through));
        let is_total = matches!(split, Split::Total { .. });
        let mirrored = Exit {
            channel: self.channel(profile, media, at, mirrored),
            action: actions.reflected,
            adds_total_reflection: is_total,
        };
        let through = through.map(|id| Exit {
            channel: self.channel(profile, media, at.other(), id),
            action: actions.transmitted,
            adds_total_reflection: false,
        });
        [Some(mirrored), through]
    }

    fn turns(&self, arriving: Vec3, normal: Vec2, mirrored: DirectionId, through: Option<DirectionId>) -> Turns {
        let normal = Vec3::new(0.0, normal.y, normal.z);
        // across the plane of incidence; at normal incidence any axis will do
        let across = normal.cross(arriving);
        let s = if across.length_squared() > 1e-24 { across.normalize() } else { optics::reference_axes(arriving).0 };
        let out = |id: DirectionId| Mueller::out_of_plane(self.directions.vector(id), s);
        let mirrored = out(mirrored);
        Turns { arriving: Mueller::into_plane(arriving, s), mirrored, through: through.map_or(mirrored, out) }
    }

    /// The channel from this hand in this direction, opened on first use.
    fn channel(&mut self, profile: &Profile, media: &Media, from: HalfEdge, direction: DirectionId) -> u32 {
        if let Some(known) = self.places.channel(from, direction) {
            return known;
        }
        let facet = &profile.facets()[from.facet()];
        let source = Source { start: facet.start, end: facet.end, hand: Some(from), medium: profile.medium(from) };
        self.open_channel(profile, media, source, direction)
    }

    fn open_channel(&mut self, profile: &Profile, media: &Media, source: Source, direction: DirectionId) -> u32 {
        let mut sights = std::mem::take(&mut self.sights);
        look(profile, source, self.directions.in_section(direction), &mut sights);
        let first = self.stretches.len() as u32;
        for &sight in &sights {
            let sink = match sight.target {
                Target::Facet(hand, _) => Sink::Bundle(self.bundle(hand, direction)),
                Target::Outside => Sink::Leaving(self.exit(direction)),
                Target::Nowhere => Sink::Nowhere,
            };
            self.stretches.push(Stretch { sight, sink });
        }
        self.sights = sights;
        let absorption = media.get(source.medium).absorption * self.directions.lengthening(direction);
        let number = self.channels.len() as u32;
        self.channels.push(Channel { first, last: self.stretches.len() as u32, absorption });
        // the sky is no facet: its channel is found by no later search
        if let Some(from) = source.hand {
            self.places.set_channel(from, direction, number);
        }
        number
    }

    fn bundle(&mut self, at: HalfEdge, direction: DirectionId) -> u32 {
        if let Some(known) = self.places.bundle(at, direction) {
            return known;
        }
        let i = self.bundle_count;
        self.places.set_bundle(at, direction, i as u32);
        if i == self.bundles.len() {
            self.bundles.push(Bundle { at, direction, density: Density::default(), exits: None });
        } else {
            let b = &mut self.bundles[i];
            (b.at, b.direction, b.exits) = (at, direction, None);
            b.density.clear();
        }
        self.bundle_count += 1;
        self.waiting.push(0.0);
        i as u32
    }

    fn exit(&mut self, direction: DirectionId) -> u32 {
        if let Some(known) = self.places.leaving(direction) {
            return known;
        }
        let number = self.leaving.len() as u32;
        self.leaving.push(Leaving { direction, light: P::ZERO, total_reflections: u16::MAX });
        self.places.set_leaving(direction, number);
        number
    }
}
