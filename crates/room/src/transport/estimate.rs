//! Means of independent rounds, with their standard errors.

/// Running means and sums of squared deviations of many quantities at once (B. P. Welford, Technometrics 4(3), 1962).
pub struct Estimate {
    rounds: f64,
    mean: Vec<f64>,
    squares: Vec<f64>,
}

impl Estimate {
    /// Of this many quantities, before the first round.
    pub fn new(quantities: usize) -> Self {
        Self { rounds: 0.0, mean: vec![0.0; quantities], squares: vec![0.0; quantities] }
    }

    /// Takes in one round.
    pub fn add(&mut self, values: &[f64]) {
        self.rounds += 1.0;
        let share = 1.0 / self.rounds;
        for ((mean, squares), value) in self.mean.iter_mut().zip(&mut self.squares).zip(values) {
            let off = value - *mean;
            *mean += off * share;
            *squares += off * (value - *mean);
        }
    }

    /// The means so far.
    pub fn mean(&self) -> &[f64] {
        &self.mean
    }

    /// The standard error of mean `i`; NaN before the second round.
    pub fn standard_error(&self, i: usize) -> f64 {
        if self.rounds < 2.0 { f64::NAN } else { (self.squares[i] / (self.rounds * (self.rounds - 1.0))).sqrt() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Mean and standard error of 1, 2, 3, 4 by hand: 2.5 and √(5/3/4).
    #[test]
    fn four_rounds_by_hand() {
        let mut estimate = Estimate::new(1);
        assert!(estimate.standard_error(0).is_nan());
        (1..=4).for_each(|x| estimate.add(&[f64::from(x)]));
        assert!((estimate.mean()[0] - 2.5).abs() < 1e-15);
        assert!((estimate.standard_error(0) - (5.0_f64 / 3.0 / 4.0).sqrt()).abs() < 1e-15);
    }
}
