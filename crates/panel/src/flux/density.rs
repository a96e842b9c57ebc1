//! How light of one direction is spread along a facet: piece by piece, level or sloping.

use super::payload::Payload;

/// Pieces beyond which a density is spread over equal bins. Where light is reflected hundreds of times between the faces of
/// a kerf, 256 bins and 1024 give shares that differ by 10⁻⁴, 128 bins are off by up to 3·10⁻³.
const MOST_PIECES: usize = 1024;
/// Those bins.
const BINS: usize = 512;
/// Their width.
const WIDTH: f64 = 1.0 / BINS as f64;
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
        let (most, steep) = (mean.power(), 0.5 * both * slope.power().abs());
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

/// A density along a facet, parametrised 0..=1.
#[derive(Clone, Debug)]
pub struct Density<P> {
    knots: Vec<f64>,
    pieces: Vec<Piece<P>>,
    /// Once it has been spread over equal bins it stays so.
    is_binned: bool,
}

impl<P: Payload> Default for Density<P> {
    fn default() -> Self {
        Self { knots: Vec::new(), pieces: Vec::new(), is_binned: false }
    }
}

impl<P: Payload> Density<P> {
    /// No light, and no bins; the memory is kept.
    pub fn clear(&mut self) {
        self.knots.clear();
        self.pieces.clear();
        self.is_binned = false;
    }

    /// Moves all light to `other`, which must be empty. Bins stay bins.
    pub fn pour_into(&mut self, other: &mut Self) {
        std::mem::swap(self, other);
        self.clear();
        if other.is_binned {
            self.lay_bins();
            // moments of light that fills part of a bin can ask for a slope that is negative at one end
            for bin in &mut other.pieces {
                let (most, steep) = (bin.mean.power(), 0.5 * WIDTH * bin.slope.power().abs());
                if steep > most {
                    bin.slope = bin.slope.times(most / steep);
                }
            }
        }
    }

    /// The pieces that hold light, each with its ends.
    pub fn lit(&self) -> impl Iterator<Item = (f64, f64, &Piece<P>)> {
        let intervals = self.knots.windows(2).map(|w| (w[0], w[1]));
        intervals.zip(&self.pieces).filter(|(_, p)| p.total_reflections != UNTOUCHED).map(|((a, b), p)| (a, b, p))
    }

    /// Adds a piece over `start..end`, and never loses any of its power.
    pub fn add(&mut self, start: f64, end: f64, piece: Piece<P>) {
        if self.is_binned {
            self.add_to_bins(start, end, piece);
            return;
        }
        let (first, last) = (self.knot_at(start), self.knot_at(end));
        // putting in the upper knot never moves the lower one
        let (lower, upper) = (self.knots[first], self.knots[last]);
        if first == last {
            self.add_at_knot(first, piece.mean.times(end - start), piece.total_reflections);
            return;
        }
        // a knot that snapped moved an end by a rounding error: keep the power
        let mean = piece.mean.times((end - start) / (upper - lower));
        let middle = 0.5 * (lower + upper);
        for i in first..last {
            let offset = 0.5 * (self.knots[i] + self.knots[i + 1]) - middle;
            let here = &mut self.pieces[i];
            here.mean = here.mean.plus(mean).plus(piece.slope.times(offset));
            here.slope = here.slope.plus(piece.slope);
            here.total_reflections = here.total_reflections.min(piece.total_reflections);
        }
        if self.pieces.len() > MOST_PIECES {
            self.rebin();
        }
    }

    /// Adds light that all falls on one point.
    pub fn add_point(&mut self, at: f64, light: P, total_reflections: u16) {
        if self.is_binned {
            self.add_at_knot(bin_of(at), light, total_reflections);
            return;
        }
        let knot = self.knot_at(at);
        self.add_at_knot(knot, light, total_reflections);
    }

    /// Light on an interval too short to tell its ends apart joins the piece beside it.
    fn add_at_knot(&mut self, knot: usize, light: P, total_reflections: u16) {
        if self.pieces.is_empty() {
            self.knots = vec![0.0, 1.0];
            self.pieces.push(Piece::EMPTY);
        }
        let i = knot.min(self.pieces.len() - 1);
        let width = self.knots[i + 1] - self.knots[i];
        let here = &mut self.pieces[i];
        here.mean = here.mean.plus(light.times(1.0 / width));
        here.total_reflections = here.total_reflections.min(total_reflections);
    }

    /// The place of the knot at `s`, put in if there is none.
    fn knot_at(&mut self, s: f64) -> usize {
        let i = self.knots.partition_point(|&k| k < s - SAME_KNOT);
        if i == self.knots.len() {
            self.knots.push(s);
            if i > 0 {
                self.pieces.push(Piece::EMPTY);
            }
            return i;
        }
        if (self.knots[i] - s).abs() <= SAME_KNOT {
            return i;
        }
        if i == 0 {
            self.knots.insert(0, s);
            self.pieces.insert(0, Piece::EMPTY);
            return 0;
        }
        // cut the piece in two, each with its own middle
        let (a, b) = (self.knots[i - 1], self.knots[i]);
        let (middle, whole) = (0.5 * (a + b), self.pieces[i - 1]);
        self.pieces[i - 1].mean = whole.at(0.5 * (a + s) - middle);
        let rest = Piece { mean: whole.at(0.5 * (s + b) - middle), ..whole };
        self.knots.insert(i, s);
        self.pieces.insert(i, rest);
        i
    }

    /// Spreads all over equal bins.
    fn rebin(&mut self) {
        let mut fine = Self::default();
        std::mem::swap(self, &mut fine);
        self.lay_bins();
        for (start, end, &piece) in fine.lit() {
            self.add_to_bins(start, end, piece);
        }
    }

    fn lay_bins(&mut self) {
        self.knots.clear();
        self.knots.extend((0..=BINS).map(|i| i as f64 * WIDTH));
        self.pieces.clear();
        self.pieces.resize(BINS, Piece::EMPTY);
        self.is_binned = true;
    }

    /// Adds a piece to the bins it covers: each gets its power and its first moment.
    fn add_to_bins(&mut self, start: f64, end: f64, piece: Piece<P>) {
        let middle = 0.5 * (start + end);
        let (first, last) = (bin_of(start), bin_of(end));
        for i in first..=last {
            let low = i as f64 * WIDTH;
            let from = if i == first { start } else { low };
            let to = if i == last { end } else { low + WIDTH };
            if to <= from {
                continue;
            }
            let (here, length) = (0.5 * (from + to), to - from);
            let light = piece.at(here - middle).times(length);
            // first moment about the bin's middle
            let arm = here - (low + 0.5 * WIDTH);
            let moment = light.times(arm).plus(piece.slope.times(length * length * length / 12.0));
            let bin = &mut self.pieces[i];
            bin.mean = bin.mean.plus(light.times(1.0 / WIDTH));
            bin.slope = bin.slope.plus(moment.times(12.0 / (WIDTH * WIDTH * WIDTH)));
            bin.total_reflections = bin.total_reflections.min(piece.total_reflections);
        }
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
        self.lit().map(|(a, b, p)| p.mean.power() * (b - a)).sum()
    }
}

/// The bin that `s` falls into.
fn bin_of(s: f64) -> usize {
    ((s / WIDTH) as usize).min(BINS - 1)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn level(mean: f64) -> Piece<f64> {
        Piece { mean, slope: 0.0, total_reflections: 0 }
    }

    /// Overlapping pieces add where they overlap and nowhere else.
    #[test]
    fn pieces_add_where_they_overlap() {
        let mut d = Density::default();
        d.add(0.0, 0.6, level(1.0));
        d.add(0.4, 1.0, level(2.0));
        let found: Vec<_> = d.lit().map(|(a, b, p)| (a, b, p.mean)).collect();
        assert_eq!(found, [(0.0, 0.4, 1.0), (0.4, 0.6, 3.0), (0.6, 1.0, 2.0)]);
    }

    /// A gap between pieces stays dark.
    #[test]
    fn gaps_stay_dark() {
        let mut d = Density::default();
        d.add(0.7, 0.8, level(1.0));
        d.add(0.1, 0.2, level(1.0));
        assert_eq!(d.lit().count(), 2);
        assert!((d.power() - 0.2).abs() < 1e-15);
    }

    /// Thousands of random pieces are spread over bins without losing power or centre of gravity.
    #[test]
    fn binning_keeps_power_and_balance() {
        let mut d = Density::default();
        let (mut power, mut moment) = (0.0, 0.0);
        for i in 0..2000_u32 {
            let a = (f64::from(i) * 0.618_033_988_7).fract() * 0.9;
            let b = a + 0.1 * (f64::from(i) * 0.414_213_562_3).fract();
            d.add(a, b, level(1.0));
            power += b - a;
            moment += 0.5 * (b * b - a * a);
        }
        let found: f64 =
            d.lit().map(|(a, b, p)| p.mean * (b - a) * 0.5 * (a + b) + p.slope * (b - a).powi(3) / 12.0).sum();
        assert!((d.power() / power - 1.0).abs() < 1e-12);
        assert!((found / moment - 1.0).abs() < 1e-4, "{found} {moment}");
    }

    /// A sliver between two knots that are the same keeps its power.
    #[test]
    fn slivers_keep_their_power() {
        let mut d = Density::default();
        d.add(0.5, 0.5 + 1e-13, level(1.0));
        d.add(0.2, 0.5, level(1.0));
        assert!((d.power() - 0.3 - 1e-13).abs() < 1e-16);
    }
}
