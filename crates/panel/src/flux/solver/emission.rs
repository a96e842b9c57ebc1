//! Light that has left a facet in one direction, handed to all that the facet sees.

use super::{Channel, Payload, Sight, Sink, Solver, Stretch};
use crate::flux::{
    attenuation,
    density::{Part, Piece},
};

/// Shortest stretch of a facet that light can fall on.
const SLIVER: f64 = 1e-15;

impl<P: Payload> Solver<P> {
    /// Hands light that leaves through a channel, in the order of its places, to all that the channel sees.
    pub(super) fn emit(&mut self, channel: u32, sent: &[Part<P>]) {
        let Channel { first, last, absorption, .. } = self.channels[channel as usize];
        let mut arriving = std::mem::take(&mut self.arriving);
        let mut next = 0;
        for i in first..last {
            let Stretch { sight, sink } = self.stretches[i as usize];
            // what rounding put beyond the ends belongs to the outermost stretches
            let (low, high) =
                (if i == first { f64::MIN } else { sight.start }, if i + 1 == last { f64::MAX } else { sight.end });
            while sent.get(next).is_some_and(|part| part.end <= low) {
                next += 1;
            }
            let here = sent[next..].iter().take_while(|part| part.start < high);
            let parts = here.map(|part| {
                let (start, end) = (part.start.max(low), part.end.min(high));
                Part { start, end, piece: part.within(start, end) }
            });
            match sink {
                Sink::Leaving(i) => {
                    let leaving = &mut self.leaving[i as usize];
                    for part in parts {
                        self.pieces += 1;
                        leaving.light = leaving.light.plus(part.piece.mean.times(part.end - part.start));
                        leaving.total_reflections = leaving.total_reflections.min(part.piece.total_reflections);
                    }
                }
                Sink::Nowhere => self.lost += parts.map(|p| p.piece.mean.power() * (p.end - p.start)).sum::<f64>(),
                Sink::Bundle(i) => {
                    arriving.clear();
                    for part in parts {
                        self.pieces += 1;
                        if absorption == 0.0 {
                            arriving.push(part);
                            continue;
                        }
                        // where absorption changes much along the piece, its parts are dimmed one by one
                        let count = attenuation::parts(&sight, absorption, part.start, part.end);
                        let step = (part.end - part.start) / f64::from(count);
                        for k in 0..count {
                            let start = part.start + f64::from(k) * step;
                            let end = if k + 1 == count { part.end } else { start + step };
                            let whole = part.within(start, end);
                            let piece = attenuation::dimmed(&whole, &sight, absorption, start, end);
                            self.absorbed += (whole.mean.power() - piece.mean.power()) * (end - start);
                            arriving.push(Part { start, end, piece });
                        }
                    }
                    self.arrive(i, &sight, &mut arriving);
                }
            }
        }
        self.arriving = arriving;
    }

    /// Adds parts that left along their source to the bundle they reach.
    fn arrive(&mut self, bundle: u32, sight: &Sight, arriving: &mut [Part<P>]) {
        let (offset, stretch) = sight.place;
        for part in arriving.iter_mut() {
            let light = part.piece.mean.times(part.end - part.start);
            self.waiting[bundle as usize] += light.power();
            let at = |s: f64| (offset + stretch * s).clamp(0.0, 1.0);
            let (a, b) = (at(part.start), at(part.end));
            let (start, end) = (a.min(b), a.max(b));
            // per unit of the target's length; light that falls on one point keeps its power as light upon a sliver
            let end = if end - start < SLIVER { start + SLIVER } else { end };
            let slope = part.piece.slope.times(1.0 / (stretch * stretch.abs()));
            let mean = light.times(1.0 / (end - start));
            *part = Part { start, end, piece: Piece { mean, slope, ..part.piece } };
        }
        if stretch < 0.0 {
            arriving.reverse();
        }
        if !arriving.is_empty() {
            self.bundles[bundle as usize].density.merge(arriving, self.waiting[bundle as usize], &mut self.spare);
        }
    }
}
