//! A quantity known at some wavelengths, straight lines in between, and nothing beyond.

use crate::OpticsError;

/// Values at increasing wavelengths, interpolated linearly.
#[derive(Clone, Debug, PartialEq)]
pub struct Table {
    wavelength_nm: Vec<f64>,
    values: Vec<f64>,
}

impl Table {
    /// A table from (wavelength [nm], value) pairs. The values are checked by whoever knows what they mean.
    pub fn new(pairs: &[(f64, f64)]) -> Result<Self, OpticsError> {
        if pairs.len() < 2 {
            return Err(OpticsError::TableOrder { detail: format!("{} wavelength(s)", pairs.len()) });
        }
        if let Some((w, _)) = pairs.iter().find(|(w, _)| !w.is_finite() || *w <= 0.0) {
            return Err(OpticsError::TableOrder { detail: format!("{w}") });
        }
        if let Some(pair) = pairs.windows(2).find(|pair| pair[1].0 <= pair[0].0) {
            return Err(OpticsError::TableOrder { detail: format!("{} after {}", pair[1].0, pair[0].0) });
        }
        let (wavelength_nm, values) = pairs.iter().copied().unzip();
        Ok(Self { wavelength_nm, values })
    }

    /// First and last wavelength [nm].
    pub fn range_nm(&self) -> (f64, f64) {
        (self.wavelength_nm[0], self.wavelength_nm[self.wavelength_nm.len() - 1])
    }

    /// The wavelengths and values as they were given.
    pub fn pairs(&self) -> impl Iterator<Item = (f64, f64)> + '_ {
        self.wavelength_nm.iter().copied().zip(self.values.iter().copied())
    }

    /// The value at a wavelength of [`Self::range_nm`]; beyond an end, that end's.
    pub fn at(&self, wavelength_nm: f64) -> f64 {
        let last = self.wavelength_nm.len() - 1;
        let upper = self.wavelength_nm.partition_point(|w| *w < wavelength_nm).clamp(1, last);
        let (x0, x1) = (self.wavelength_nm[upper - 1], self.wavelength_nm[upper]);
        let share = ((wavelength_nm - x0) / (x1 - x0)).clamp(0.0, 1.0);
        self.values[upper - 1] * (1.0 - share) + self.values[upper] * share
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The table's own points come back, and between two of them a straight line.
    #[test]
    fn interpolates_linearly_through_its_points() {
        let table = Table::new(&[(400.0, 1.0), (500.0, 3.0), (600.0, 2.0)]).unwrap();
        let expected = [(400.0, 1.0), (450.0, 2.0), (500.0, 3.0), (575.0, 2.25), (600.0, 2.0)];
        for (w, value) in expected {
            assert!((table.at(w) - value).abs() < 1e-15);
        }
    }

    /// Unsorted, doubled, single and not-finite wavelengths are refused.
    #[test]
    fn refuses_what_cannot_be_interpolated() {
        for bad in [vec![(400.0, 1.0)], vec![(500.0, 1.0), (400.0, 1.0)], vec![(f64::NAN, 1.0), (400.0, 1.0)]] {
            assert!(matches!(Table::new(&bad), Err(OpticsError::TableOrder { .. })));
        }
    }
}
