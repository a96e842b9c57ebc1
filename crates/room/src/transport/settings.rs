//! How much work to do, and how far it is.

use crate::RoomError;

/// How much work to do.
#[derive(Clone, Debug)]
pub struct Settings {
    /// Which random numbers.
    pub seed: u64,
    /// Independent rounds, without a target.
    pub rounds: usize,
    /// Shared points on surfaces, a round.
    pub nodes: usize,
    /// Points each sensor draws on the windows, a round.
    pub window_samples: usize,
    /// Light after more diffuse reflections is reported as lost; `None` follows it to its end.
    pub max_bounces: Option<u32>,
    /// Rounds are added until the standard error of Σ coefficient · weight is at most this share of it at every sensor.
    pub target_relative_error: Option<f64>,
    /// But not more rounds than this.
    pub max_rounds: usize,
    /// Shared points lie where they serve suns anywhere in the sky, not where those that are asked for shine; of the sun alone.
    pub any_sun: bool,
    /// Luminances of the patches that the target speaks of; by default the overcast sky over ground of reflectance 0.2.
    pub weights: Option<Vec<f64>>,
}

impl Default for Settings {
    fn default() -> Self {
        Self {
            seed: 0,
            rounds: 16,
            nodes: 512,
            window_samples: 512,
            max_bounces: None,
            target_relative_error: None,
            max_rounds: 4096,
            any_sun: false,
            weights: None,
        }
    }
}

/// Fewer rounds do not tell their own standard error.
const LEAST_ROUNDS: usize = 8;

/// How far the work is.
#[derive(Clone, Copy, Debug)]
pub struct Progress {
    /// Rounds done.
    pub rounds: usize,
    /// Rounds it will take, as far as one can tell.
    pub expected_rounds: usize,
    /// Largest relative standard error of Σ coefficient · weight over the sensors that have any; NaN before the second round.
    pub worst_relative_error: f64,
    /// Time since the start \[s\].
    pub seconds: f64,
}

impl Settings {
    /// Refuses numbers that make no sense.
    pub(super) fn check(&self) -> Result<(), RoomError> {
        let settings = self;
        let wrong = |name, rule, value: String, way_out| Err(RoomError::Setting { name, rule, value, way_out });
        for (name, value) in [("rounds", settings.rounds), ("max_rounds", settings.max_rounds)] {
            if value < 2 {
                return wrong(name, "at least 2", value.to_string(), "one round alone has no standard error");
            }
        }
        for (name, value) in [("nodes", settings.nodes), ("window_samples", settings.window_samples)] {
            if value == 0 || value > 1 << 24 {
                return wrong(name, "in 1..16777216", value.to_string(), "a few hundred do; add rounds for precision");
            }
        }
        if let Some(target) = settings.target_relative_error {
            if !(target > 0.0 && target.is_finite()) {
                return wrong("target_relative_error", "above 0", target.to_string(), "0.02 is 2 %");
            }
        }
        Ok(())
    }

    /// Rounds it takes in all, judged after `rounds` of them: errors fall with the root of their number.
    pub(super) fn expected(&self, rounds: usize, worst: f64) -> usize {
        let Some(target) = self.target_relative_error else { return self.rounds };
        if rounds < LEAST_ROUNDS {
            return LEAST_ROUNDS.min(self.max_rounds);
        }
        if worst <= target {
            return rounds;
        }
        let more = (rounds as f64 * (worst / target).powi(2)).ceil();
        (more as usize).max(rounds + 1).min(self.max_rounds.max(rounds))
    }
}
