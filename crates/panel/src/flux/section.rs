//! The way of one broad beam through the section, strip by strip: for drawing.

use super::{
    attenuation::left,
    directions::{DirectionId, Directions},
    payload::film_reflectance,
    sight::{Sight, Source, Target, look},
};
use crate::{
    facet::{MediumId, Surface},
    media::Media,
    plane::Vec2,
    profile::Profile,
    topology::HalfEdge,
};
use hemisphere::Vec3;
use optics::Interface;

/// Strips drawn at most.
const MOST_STRIPS: usize = 20_000;
/// How far beams are drawn outside, in thicknesses of the sheet.
const OUTSIDE: f64 = 0.6;

/// One strip of light between two facets.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Strip {
    /// Both ends on the source, then the same rays on the target, in reverse: a polygon.
    pub corners: [Vec2; 4],
    /// Share of the light that enters the picture, where the strip begins.
    pub power: f64,
    /// Medium it runs in.
    pub medium: MediumId,
    /// Total internal reflections so far.
    pub total_reflections: u16,
}

/// Light about to leave one hand of a facet.
struct Leaving {
    hand: Option<HalfEdge>,
    /// How far up the facet's copy is.
    raised: f64,
    direction: DirectionId,
    start: f64,
    end: f64,
    power: f64,
    total_reflections: u16,
}

/// Draws the light that arrives along `incident` between the heights `low` and `high`, down to strips of `least_power`.
/// Light is taken as unpolarised at every facet and, dimmed on its way, as evenly spread over a strip.
pub fn strips(
    profile: &Profile,
    media: &Media,
    incident: Vec3,
    (low, high): (f64, f64),
    least_power: f64,
) -> Vec<Strip> {
    let mut directions = Directions::default();
    let medium = if incident.z > 0.0 { profile.front() } else { profile.back() };
    directions.reset(0.0, false);
    let direction = directions.enter(incident, medium, media.get(medium).n);
    let (z_min, z_max) = profile.z_range();
    let z = if incident.z > 0.0 { z_min } else { z_max };
    let sky = Source { start: Vec2::new(z, low), end: Vec2::new(z, high), hand: None, medium };
    let mut waiting = std::collections::VecDeque::from([Leaving {
        hand: None,
        raised: 0.0,
        direction,
        start: 0.0,
        end: 1.0,
        power: 1.0,
        total_reflections: 0,
    }]);
    let (mut strips, mut sights) = (Vec::new(), Vec::new());
    let outside = OUTSIDE * (z_max - z_min);
    strips.push(arriving(sky, directions.in_section(direction), outside));
    while let Some(leaving) = waiting.pop_front() {
        let source = match leaving.hand {
            None => sky,
            Some(hand) => {
                let f = &profile.facets()[hand.facet()];
                Source { start: f.start, end: f.end, hand: Some(hand), medium: profile.medium(hand) }
            }
        };
        let d = directions.in_section(leaving.direction);
        look(profile, source, d, &mut sights);
        let absorption = media.get(source.medium).absorption * directions.lengthening(leaving.direction);
        for sight in &sights {
            let (start, end) = (sight.start.max(leaving.start), sight.end.min(leaving.end));
            let power = leaving.power * (end - start) / (leaving.end - leaving.start);
            if end <= start || power < least_power || strips.len() >= MOST_STRIPS {
                continue;
            }
            let corner = |s: f64| (source.start + (source.end - source.start) * s).raised(leaving.raised);
            let reach = |s: f64| {
                let length = match sight.target {
                    Target::Facet(..) => sight.distance.0 + sight.distance.1 * s,
                    _ => outside / d.z.abs().max(0.3),
                };
                corner(s) + d * length.max(0.0)
            };
            let strip = Strip {
                corners: [corner(start), corner(end), reach(end), reach(start)],
                power,
                medium: source.medium,
                total_reflections: leaving.total_reflections,
            };
            let has_length =
                (strip.corners[0] - strip.corners[3]).length() + (strip.corners[1] - strip.corners[2]).length();
            if has_length > 1e-9 * profile.period() {
                strips.push(strip);
            }
            if let Target::Facet(hand, copy) = sight.target {
                let arrival = Arrival { hand, copy, sight: *sight, start, end };
                let power = power * left(sight, absorption, start, end);
                let parts = split(profile, media, &mut directions, &leaving, &arrival, power);
                waiting.extend(parts.into_iter().flatten().filter(|l| l.power >= least_power));
            }
        }
    }
    strips
}

/// The beam before it meets the sheet.
fn arriving(sky: Source, d: Vec2, outside: f64) -> Strip {
    let back = d * (outside / d.z.abs().max(0.3));
    Strip {
        corners: [sky.start - back, sky.end - back, sky.end, sky.start],
        power: 1.0,
        medium: sky.medium,
        total_reflections: 0,
    }
}

/// Light that has come to a facet.
struct Arrival {
    hand: HalfEdge,
    copy: i32,
    sight: Sight,
    start: f64,
    end: f64,
}

/// Snell and Fresnel where a strip ends.
fn split(
    profile: &Profile,
    media: &Media,
    directions: &mut Directions,
    from: &Leaving,
    arrival: &Arrival,
    power: f64,
) -> [Option<Leaving>; 2] {
    let Arrival { hand, copy, sight, start, end } = arrival;
    let facet = &profile.facets()[hand.facet()];
    let tangent = (facet.end - facet.start).normalized() * hand.sign();
    let normal = tangent.left();
    let v = directions.vector(from.direction);
    let cos_i = -(v.z * normal.z + v.y * normal.y);
    let n_i = media.get(profile.medium(*hand)).n;
    let film = if let Surface::Film(gap) = facet.surface { Some(gap) } else { None };
    let beyond = profile.medium(hand.other());
    let interface = Interface { n_i, n_t: media.get(film.unwrap_or(beyond)).n };
    let is_total = interface.is_total(cos_i.clamp(0.0, 1.0));
    let r = interface.reflectance(cos_i.clamp(0.0, 1.0));
    let reflectance = if film.is_some() { film_reflectance(r) } else { r };
    let mirrored = directions.mirror(from.direction, normal);
    let through = match film {
        Some(_) => Some(from.direction),
        None => directions.refract(from.direction, tangent, normal, beyond, media.get(beyond).n),
    };
    let place = |s: f64| (sight.place.0 + sight.place.1 * s).clamp(0.0, 1.0);
    let (a, b) = (place(*start), place(*end));
    let leave = |hand: HalfEdge, direction, power, total_reflections| Leaving {
        hand: Some(hand),
        raised: from.raised + f64::from(*copy) * profile.period(),
        direction,
        start: a.min(b),
        end: a.max(b),
        power,
        total_reflections,
    };
    let reflections = from.total_reflections + u16::from(is_total);
    [
        Some(leave(*hand, mirrored, power * reflectance, reflections)),
        through
            .filter(|_| reflectance < 1.0)
            .map(|id| leave(hand.other(), id, power * (1.0 - reflectance), from.total_reflections)),
    ]
}
