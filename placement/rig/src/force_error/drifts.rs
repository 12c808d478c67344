//! Drifts that a layout is learnt with anew. How far its films' readings wander decides how many of them are needed, and few know it of theirs.

use documents::rig::rig_settings::{Noise, RigSettings};
use results::film::force_error::DriftError;

use crate::force_error::fresh_trials::Fresh;

/// Deviations that a bounded drift comes to, as shares of full scale; the largest is the level of the published study's signals.
const SHARES: [f64; 4] = [0.0, 0.005, 0.01, 0.02];
/// A walk without bounds: share of full scale per root second.
const WALK: f64 = 0.002;
/// Time constant of a walk, s: no run comes near it, so that its variance grows evenly.
const WALK_TIME_S: f64 = 1e7;

/// A drift of readings.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Drift {
    described: String,
    share: f64,
    time_s: f64,
}

/// Returns the drifts beside a rig's own, the least first.
pub(crate) fn drifts(own: &Noise) -> Vec<Drift> {
    let time_s = own.drift_time_s;
    let bounded = SHARES.map(|share| Drift {
        described: match share {
            0.0 => "none".to_owned(),
            _ => format!("{} % within {time_s} s", 100.0 * share),
        },
        share,
        time_s,
    });
    let walk = Drift {
        described: format!("a walk of {} % per root second", 100.0 * WALK),
        // Variance grows by 2 s^2 / tau a second.
        share: WALK * (0.5 * WALK_TIME_S).sqrt(),
        time_s: WALK_TIME_S,
    };
    let others = bounded
        .into_iter()
        .filter(|drift| drift.share != own.drift_share);
    others.chain([walk]).collect()
}

impl Drift {
    /// Returns a rig with this drift in place of its own.
    pub(crate) fn of(&self, settings: &RigSettings) -> RigSettings {
        let noise = Noise {
            drift_share: self.share,
            drift_time_s: self.time_s,
            ..settings.noise
        };
        RigSettings {
            noise,
            ..settings.clone()
        }
    }

    /// Returns what is said of a force that was learnt with it.
    pub(crate) fn error(&self, found: &Fresh) -> DriftError {
        DriftError {
            drift: self.described.clone(),
            error: found.fresh,
            in_contact: found.in_contact,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_walk_grows_with_the_root_of_time() {
        let drifts = drifts(&Noise::default());
        let walk = drifts.last().expect("a walk");
        // Gauss and Markov's variance, which begins at nothing.
        let variance = |time_s: f64| walk.share.powi(2) * -(-2.0 * time_s / walk.time_s).exp_m1();
        for time_s in [1.0, 60.0, 3600.0] {
            let expected = WALK * WALK * time_s;
            assert!((variance(time_s) / expected - 1.0).abs() < 1e-3, "{time_s}");
        }
    }

    #[test]
    fn a_rig_is_tried_with_other_drifts_than_its_own() {
        let described = |share: f64| -> Vec<String> {
            let noise = Noise {
                drift_share: share,
                ..Noise::default()
            };
            let drifts = drifts(&noise).into_iter();
            drifts.map(|drift| drift.described).collect()
        };
        let walk = "a walk of 0.2 % per root second";
        assert_eq!(
            described(0.005),
            ["none", "1 % within 60 s", "2 % within 60 s", walk]
        );
        assert_eq!(described(0.3).len(), 5);
        let settings = RigSettings::default();
        let own = Drift {
            described: String::new(),
            share: settings.noise.drift_share,
            time_s: settings.noise.drift_time_s,
        };
        assert_eq!(own.of(&settings), settings);
    }
}
