//! The gaits of the published tables, for a rig.
//!
//! Tables 3 and 7 of the study state contacts from 0 to 30 degrees, loads to 20 and to 30 N, 0.8 to 2 and 1 to 5 Hz, and 200 Hz of reading. Its larger recording has 6549
//! readings. What its low and high frequencies and its transition are isn't stated.

use documents::rig::gait_settings::{Frequency, GaitSettings, RunLength};
use documents::rig::rig_settings::RigSettings;

use crate::published::printed_figures::{HIGH, LOW, TRANSITION};

/// The gait of tables 4 and 5.
pub(crate) const RANDOMISED: &str = "randomised";
/// Readings of a recording.
const READINGS: f64 = 6549.0;
/// Readings a second, Hz.
pub const RATE_HZ: f64 = 200.0;
const CONTACT_DEG: [f64; 2] = [0.0, 30.0];
/// Loads of its tables 3 and 7, N.
const LIGHT_N: f64 = 20.0;
const HEAVY_N: f64 = 30.0;
const SLOW: Frequency = Frequency::Randomised {
    min_hz: 0.8,
    max_hz: 2.0,
};
const FAST: Frequency = Frequency::Randomised {
    min_hz: 2.0,
    max_hz: 5.0,
};
const ALL: Frequency = Frequency::Randomised {
    min_hz: 1.0,
    max_hz: 5.0,
};

/// A gait of the published tables.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct PublishedGait {
    frequency: Frequency,
    most_n: f64,
}

impl PublishedGait {
    /// Gait of tables 4 and 5.
    pub(crate) const ABLATION: Self = Self {
        frequency: SLOW,
        most_n: LIGHT_N,
    };
    /// Gait from which table 6 is learnt.
    pub(crate) const LEARNT: Self = heavy(ALL);

    /// Table 6's.
    pub const fn fixed(hz: f64) -> Self {
        heavy(Frequency::Fixed { hz })
    }

    /// Finds a gait by the name of a row of tables 8 and 9.
    pub fn named(gait: &str) -> Option<Self> {
        let frequency = match gait {
            LOW => SLOW,
            HIGH => FAST,
            TRANSITION => Frequency::Transition {
                from_hz: 1.0,
                to_hz: 5.0,
            },
            _ => return None,
        };
        Some(heavy(frequency))
    }

    /// A rig that steps so, within its own largest load.
    pub fn on(self, rig: &RigSettings) -> RigSettings {
        RigSettings {
            gait: GaitSettings {
                frequency: self.frequency,
                length: RunLength::Seconds(READINGS / RATE_HZ),
                contact_deg: CONTACT_DEG,
                load_n: [0.0, self.most_n.min(rig.gait.load_n[1])],
                ..rig.gait.clone()
            },
            film_rate_hz: RATE_HZ,
            ..rig.clone()
        }
    }
}

const fn heavy(frequency: Frequency) -> PublishedGait {
    PublishedGait {
        frequency,
        most_n: HEAVY_N,
    }
}

/// Assumptions where the study says nothing.
pub const ASSUMED: [&str; 5] = [
    "Each recording of the published tables has 6549 readings at 200 Hz, of which those without a contact are left out.",
    "Tables 4 and 5 step at 0.8 to 2 Hz with up to 20 N; a random fifth of the readings is tested.",
    "Table 6 learns from a recording of 1 to 5 Hz with up to 30 N, and is tried on another one at 1, 2 or 5 Hz, whose films have other gains.",
    "Tables 8 and 9 step at 0.8 to 2 Hz (low frequency), 2 to 5 Hz (high) or from 1 to 5 Hz (transition) with up to 30 N; before temporal cross-validation a random \
     fifth of the readings is tested, after it the three later quarters of the recording, each by what was earlier.",
    "Processes are learnt from up to 1500 readings, networks from all.",
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_gait_keeps_within_the_rigs_largest_load() {
        let mut rig = RigSettings::default();
        rig.gait.load_n = [5.0, 12.0];
        rig.film_rate_hz = 1000.0;
        let found = PublishedGait::ABLATION.on(&rig);
        assert_eq!(found.gait.load_n, [0.0, 12.0]);
        assert_eq!(found.film_rate_hz, 200.0);
        assert_eq!(found.electronics, rig.electronics);
        rig.gait.load_n = [0.0, 100.0];
        assert_eq!(PublishedGait::ABLATION.on(&rig).gait.load_n[1], 20.0);
        assert_eq!(PublishedGait::fixed(2.0).on(&rig).gait.load_n[1], 30.0);
    }

    #[test]
    fn every_named_gait_is_known() {
        assert!(
            [LOW, HIGH, TRANSITION]
                .map(PublishedGait::named)
                .iter()
                .all(Option::is_some)
        );
        assert_eq!(PublishedGait::named(RANDOMISED), None);
    }
}
