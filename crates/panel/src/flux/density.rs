//! How light of one direction is spread along a facet: piece by piece, level or sloping.

use super::payload::Payload;

/// Bins over which light of power 1 is spread when its pieces are too many; weaker light has fewer, by the square root of its
/// power, for its errors weigh less. Where light is reflected hundreds of times between the faces of a kerf, half as many
/// shares move by up to 10⁻³, twice as many by 3·10⁻⁴.
const RESOLUTION: f64 = 4096.0;
/// Bins at most.
const MOST_BINS: usize = 1024;
/// Bins of the weakest light.
const LEAST_BINS: usize = 16;
/// Knots nearer than this share of the facet are one.
const SAME_KNOT: f64 = 1e-11;
/// "No light yet": a piece that nothing has reached.
const UNTOUCHED: u16 = u16::MAX;

/// One piece, over the interval between its knots.
#[derive(Clone, Copy, Debug)]
pub struct Piece<P> {
    /// Light per unit of the facet's length (which counts as 1), at the middle of the piece.
    pub mean: P,
    /// Its change per unit of length.
    pub slope: P,
    /// Least number of total reflections of any light in it.
    pub total_reflections: u16,
}

impl<P: Payload> Piece<P> {
    const EMPTY: Self = Self { mean: P::ZERO, slope: P::ZERO, total_reflections: UNTOUCHED };

    /// This piece on top of another over the same interval.
    #[inline]
    fn over(&self, other: &Self) -> Self {
        Self {
            mean: self.mean.plus(other.mean),
            slope: self.slope.plus(other.slope),
            total_reflections: self.total_reflections.min(other.total_reflections),
        }
    }

    /// The piece's light per unit of length, `offset` from its middle.
    #[inline]
    pub fn at(&self, offset: f64) -> P {
        self.mean.plus(self.slope.times(offset))
    }

    /// This piece and the next as one, with their power and first moment; and how much power that displaces.
    fn joined(&self, width: f64, next: &Self, next_width: f64) -> (Self, f64) {
        let both = width + next_width;
        let mean = self.mean.times(width / both).plus(next.mean.times(next_width / both));
        let third = |w: f64| w * w * w / 12.0;
        let moment = next
            .mean
            .plus(self.mean.times(-1.0))
            .times(0.5 * width * next_width)
            .plus(self.slope.times(third(width)))
            .plus(next.slope.times(third(next_width)));
        let mut slope = moment.times(1.0 / third(both));
        // a slope so steep that light would be negative at one end is eased
        let (most, steep) = (mean.power().max(0.0), 0.5 * both * slope.power().abs());
        if steep > most {
            slope = slope.times(most / steep);
        }
        let total_reflections = self.total_reflections.min(next.total_reflections);
        let piece = Self { mean, slope, total_reflections };
        // the difference at both ends of both pieces, trapezium by trapezium
        let off = |old: P, place: f64| old.plus(piece.at(place).times(-1.0)).largest();
        let joint = width - 0.5 * both;
        let here = off(self.at(-0.5 * width), -0.5 * both) + off(self.at(0.5 * width), joint);
        let there = off(next.at(-0.5 * next_width), joint) + off(next.at(0.5 * next_width), 0.5 * both);
        // what is too much in one place is too little in another
        (piece, 0.25 * (here * width + there * next_width))
    }
}

/// A piece with its ends.
#[derive(Clone, Copy, Debug)]
pub struct Part<P> {
    /// Where it begins.
    pub start: f64,
    /// Where it ends.
    pub end: f64,
    /// Its light.
    pub piece: Piece<P>,
}

impl<P: Payload> Part<P> {
    /// What of it lies between `from` and `to`.
    #[inline]
    pub fn within(&self, from: f64, to: f64) -> Piece<P> {
        if from == self.start && to == self.end {
            return self.piece;
        }
        Piece { mean: self.piece.at(0.5 * ((from + to) - (self.start + self.end))), ..self.piece }
    }
}

/// A density along a facet, parametrised 0..=1: pieces side by side, each between two knots.
#[derive(Clone, Debug)]
pub struct Density<P> {
    knots: Vec<f64>,
    pieces: Vec<Piece<P>>,
}

impl<P: Payload> Default for Density<P> {
    fn default() -> Self {
        Self { knots: Vec::new(), pieces: Vec::new() }
    }
}

impl<P: Payload> Density<P> {
    /// No light; the memory is kept.
    pub fn clear(&mut self) {
        self.knots.clear();
        self.pieces.clear();
    }

    /// The pieces that hold light, each with its ends.
    pub fn lit(&self) -> impl DoubleEndedIterator<Item = Part<P>> {
        let part = |(i, &piece): (usize, &Piece<P>)| Part { start: self.knots[i], end: self.knots[i + 1], piece };
        self.pieces.iter().enumerate().filter(|(_, p)| p.total_reflections != UNTOUCHED).map(part)
    }

    /// Adds parts in the order of their places, none over another, and never loses any of their power. `power` is that of
    /// all the density then holds, `spare` lends its memory.
    pub fn merge(&mut self, parts: &mut [Part<P>], power: f64, spare: &mut Self) {
        if self.pieces.is_empty() {
            self.knots.extend([0.0, 1.0]);
            self.pieces.push(Piece::EMPTY);
        }
        self.snap(parts);
        spare.clear();
        let (mut i, mut j, mut x) = (0, 0, 0.0);
        spare.knots.push(x);
        while i < self.pieces.len() {
            let (start, end) = (self.knots[i], self.knots[i + 1]);
            let old = Part { start, end, piece: self.pieces[i] };
            while parts.get(j).is_some_and(|p| p.end <= x) {
                j += 1;
            }
            let (next, new) = match parts.get(j) {
                Some(part) if part.start <= x => (end.min(part.end), Some(part)),
                Some(part) => (end.min(part.start), None),
                None => (end, None),
            };
            let mut piece = old.within(x, next);
            if let Some(part) = new {
                piece = piece.over(&part.within(x, next));
            }
            spare.pieces.push(piece);
            spare.knots.push(next);
            x = next;
            if x >= end {
                i += 1;
            }
        }
        std::mem::swap(self, spare);
        self.limit(2 * worth(power), spare);
    }

    /// Moves the ends of parts that are as good as at a knot to it; a part of which nothing is left gives its power to the
    /// piece it lies in.
    fn snap(&mut self, parts: &mut [Part<P>]) {
        let mut i = 0;
        let mut knot = |s: f64, knots: &[f64]| {
            while i + 1 < knots.len() && knots[i] < s - SAME_KNOT {
                i += 1;
            }
            if (knots[i] - s).abs() <= SAME_KNOT { knots[i] } else { s }
        };
        let mut before = 0.0;
        for part in parts {
            let (start, end) = (knot(part.start, &self.knots), knot(part.end, &self.knots));
            let start: f64 = if (start - before).abs() <= SAME_KNOT { before } else { start.max(before) };
            let length = part.end - part.start;
            if end - start <= SAME_KNOT {
                let at = self.knots.partition_point(|&k| k <= start).clamp(1, self.pieces.len()) - 1;
                let width = self.knots[at + 1] - self.knots[at];
                let light = Piece { mean: part.piece.mean.times(length / width), slope: P::ZERO, ..part.piece };
                self.pieces[at] = self.pieces[at].over(&light);
                (part.start, part.end) = (start, start);
                continue;
            }
            // an end that moved by a rounding error: keep the power
            part.piece.mean = part.piece.mean.times(length / (end - start));
            (part.start, part.end) = (start, end);
            before = end;
        }
    }

    /// Moves all light to `other`, which must be empty, in no more pieces than light of this power is worth.
    pub fn pour_into(&mut self, other: &mut Self, power: f64, spare: &mut Self) {
        std::mem::swap(self, other);
        self.clear();
        other.limit(worth(power), spare);
    }

    /// Spreads all over equal bins if there are more pieces than twice as many.
    fn limit(&mut self, bins: usize, spare: &mut Self) {
        if self.pieces.len() > 2 * bins {
            self.spread(bins, spare);
        }
    }

    /// Spreads all over equal bins, each of which keeps its power and, unless light would be negative at one end, its first
    /// moment.
    fn spread(&mut self, bins: usize, spare: &mut Self) {
        let width = 1.0 / bins as f64;
        spare.clear();
        spare.knots.extend((0..=bins).map(|i| i as f64 / bins as f64));
        spare.pieces.resize(bins, Piece::EMPTY);
        let bin_of = |s: f64| ((s / width) as usize).min(bins - 1);
        for part in self.lit() {
            for i in bin_of(part.start)..=bin_of(part.end) {
                let (low, high) = (spare.knots[i], spare.knots[i + 1]);
                let (from, to) = (part.start.max(low), part.end.min(high));
                if to <= from {
                    continue;
                }
                let length = to - from;
                let light = part.within(from, to).mean.times(length);
                // first moment about the bin's middle
                let arm = 0.5 * (from + to) - 0.5 * (low + high);
                let moment = light.times(arm).plus(part.piece.slope.times(length * length * length / 12.0));
                let bin = &mut spare.pieces[i];
                bin.mean = bin.mean.plus(light.times(1.0 / width));
                bin.slope = bin.slope.plus(moment.times(12.0 / (width * width * width)));
                bin.total_reflections = bin.total_reflections.min(part.piece.total_reflections);
            }
        }
        for bin in &mut spare.pieces {
            let (most, steep) = (bin.mean.power().max(0.0), 0.5 * width * bin.slope.power().abs());
            if steep > most {
                bin.slope = bin.slope.times(most / steep);
            }
        }
        std::mem::swap(self, spare);
    }

    /// Joins neighbours that hardly differ, keeping the power and the first moment of each pair, as long as no more than
    /// `allowance` of power is displaced at any joint; returns how much was displaced in all.
    pub fn coarsen(&mut self, allowance: f64) -> f64 {
        let (mut displaced, mut kept) = (0.0, 0);
        for i in 1..self.pieces.len() {
            let (width, next_width) = (self.knots[kept + 1] - self.knots[kept], self.knots[i + 1] - self.knots[i]);
            let (one, next) = (self.pieces[kept], self.pieces[i]);
            let is_alike = one.total_reflections == next.total_reflections;
            match is_alike.then(|| one.joined(width, &next, next_width)) {
                Some((piece, moved)) if moved <= allowance => {
                    displaced += moved;
                    self.pieces[kept] = piece;
                }
                _ => {
                    kept += 1;
                    self.knots[kept] = self.knots[i];
                    self.pieces[kept] = next;
                }
            }
            self.knots[kept + 1] = self.knots[i + 1];
        }
        self.pieces.truncate(kept + 1);
        self.knots.truncate(kept + 2);
        displaced
    }

    /// Power in it.
    #[cfg(test)]
    pub fn power(&self) -> f64 {
        self.lit().map(|p| p.piece.mean.power() * (p.end - p.start)).sum()
    }
}

/// How many bins light of this power is worth.
fn worth(power: f64) -> usize {
    ((power.max(0.0).sqrt() * RESOLUTION) as usize).clamp(LEAST_BINS, MOST_BINS)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn level(start: f64, end: f64, mean: f64) -> Part<f64> {
        Part { start, end, piece: Piece { mean, slope: 0.0, total_reflections: 0 } }
    }

    fn with(parts: &[Part<f64>]) -> Density<f64> {
        let (mut d, mut spare) = (Density::default(), Density::default());
        for &part in parts {
            d.merge(&mut [part], 1.0, &mut spare);
        }
        d
    }

    fn found(d: &Density<f64>) -> Vec<(f64, f64, f64)> {
        d.lit().map(|p| (p.start, p.end, p.piece.mean)).collect()
    }

    /// Overlapping pieces add where they overlap and nowhere else.
    #[test]
    fn pieces_add_where_they_overlap() {
        let d = with(&[level(0.0, 0.6, 1.0), level(0.4, 1.0, 2.0)]);
        assert_eq!(found(&d), [(0.0, 0.4, 1.0), (0.4, 0.6, 3.0), (0.6, 1.0, 2.0)]);
    }

    /// A gap between pieces stays dark.
    #[test]
    fn gaps_stay_dark() {
        let d = with(&[level(0.7, 0.8, 1.0), level(0.1, 0.2, 1.0)]);
        assert_eq!(d.lit().count(), 2);
        assert!((d.power() - 0.2).abs() < 1e-15);
    }

    /// Where a short slope lies on a long one, means and slopes both add, each about the middle of its own piece.
    #[test]
    fn slopes_add_where_they_overlap() {
        let sloping = |end, slope| Part { start: 0.0, end, piece: Piece { mean: 1.0, slope, total_reflections: 0 } };
        let d = with(&[sloping(1.0, 2.0), sloping(0.5, -1.0)]);
        let found: Vec<_> = d.lit().map(|p| (p.start, p.end, p.piece.mean, p.piece.slope)).collect();
        assert_eq!(found, [(0.0, 0.5, 1.5, 1.0), (0.5, 1.0, 1.5, 2.0)]);
    }

    /// Many parts at once are the same as one after the other, sloping ones too.
    #[test]
    fn parts_at_once_are_parts_one_by_one() {
        let sloping = |start, end, mean, slope| Part { start, end, piece: Piece { mean, slope, total_reflections: 3 } };
        let first = [level(0.0, 0.3, 1.0), level(0.3, 0.35, 2.0), level(0.6, 1.0, 0.5)];
        let second = [sloping(0.1, 0.4, 1.0, 2.0), sloping(0.4, 0.65, 1.5, -1.0), sloping(0.9, 0.95, 4.0, 0.0)];
        let (mut at_once, mut spare) = (Density::default(), Density::default());
        at_once.merge(&mut first.clone(), 1.0, &mut spare);
        at_once.merge(&mut second.clone(), 1.0, &mut spare);
        let one_by_one = with(&[first, second].concat());
        assert_eq!(found(&at_once).len(), found(&one_by_one).len());
        for (a, b) in found(&at_once).iter().zip(found(&one_by_one)) {
            assert!((a.0 - b.0).abs() < 1e-15 && (a.2 - b.2).abs() < 1e-13, "{a:?} {b:?}");
        }
    }

    /// Thousands of random pieces are spread over bins without losing power or centre of gravity.
    #[test]
    fn binning_keeps_power_and_balance() {
        let (mut power, mut moment, mut parts) = (0.0, 0.0, Vec::new());
        for i in 0..4000_u32 {
            let a = (f64::from(i) * 0.618_033_988_7).fract() * 0.9;
            let b = a + 0.1 * (f64::from(i) * 0.414_213_562_3).fract();
            parts.push(level(a, b, 1.0));
            power += b - a;
            moment += 0.5 * (b * b - a * a);
        }
        let d = with(&parts);
        assert!(d.pieces.len() <= 4 * MOST_BINS);
        let balance = |p: Part<f64>| {
            let length = p.end - p.start;
            p.piece.mean * length * 0.5 * (p.start + p.end) + p.piece.slope * length.powi(3) / 12.0
        };
        let found: f64 = d.lit().map(balance).sum();
        assert!((d.power() / power - 1.0).abs() < 1e-12);
        assert!((found / moment - 1.0).abs() < 1e-4, "{found} {moment}");
    }

    /// A sliver between two knots that are the same keeps its power.
    #[test]
    fn slivers_keep_their_power() {
        let d = with(&[level(0.5, 0.5 + 1e-13, 1.0), level(0.2, 0.5, 1.0), level(1.0 - 1e-14, 1.0, 1.0)]);
        assert!((d.power() - 0.3 - 1.1e-13).abs() < 1e-16, "{}", d.power() - 0.3);
    }
}
