//! How often a foot steps, where on the tire and how hard.
//!
//! The ranges are those of the paper's Tables 3 and 7. The paper doesn't state, and we assume: how often each value occurs (evenly over its range); that
//! the ground is touched for half of a turn; and any shear at all. Its rig moves straight up and down, so its small forces along and across follow from the
//! press. Here they are drawn for each stance, since an estimator that is given forces of its own making learns nothing of shear.

use serde_json::{Value, json};

/// How a foot steps.
#[derive(Debug, Clone, PartialEq)]
pub struct GaitSettings {
    /// Turns of the crank a second.
    pub frequency: Frequency,
    /// How long a run is.
    pub length: RunLength,
    /// Least and greatest wheel angle of the contact, degrees.
    pub contact_deg: [f64; 2],
    /// Least and greatest load at the deepest point of a stance, N.
    pub load_n: [f64; 2],
    /// Share of a turn in which the ground is touched.
    pub duty: f64,
    /// Share of the shift at which the contact slides that a stance may use.
    pub shear_share: f64,
}

/// Turns of the crank a second. A turn has one speed from its begin to its end.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Frequency {
    /// All the same, Hz.
    Fixed(f64),
    /// Drawn evenly between two for each turn, Hz.
    Randomised([f64; 2]),
    /// From the one to the other in equal parts over a run, Hz.
    Transition([f64; 2]),
}

/// How long a run is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum RunLength {
    /// So many stances.
    Stances(usize),
    /// So many seconds; the last stance is cut off.
    Seconds(f64),
}

impl Default for GaitSettings {
    fn default() -> Self {
        Self {
            frequency: Frequency::Randomised([1.0, 5.0]),
            length: RunLength::Seconds(60.0),
            contact_deg: [0.0, 30.0],
            load_n: [0.0, 30.0],
            duty: 0.5,
            shear_share: 0.6,
        }
    }
}

impl Frequency {
    /// The slowest turn, Hz.
    pub fn slowest_hz(self) -> f64 {
        match self {
            Self::Fixed(hz) => hz,
            Self::Randomised([a, b]) | Self::Transition([a, b]) => a.min(b),
        }
    }

    /// The table as in a document.
    fn to_value(self) -> Value {
        match self {
            Self::Fixed(hz) => json!({"kind": "fixed", "hz": hz}),
            Self::Randomised([low, high]) => {
                json!({"kind": "randomised", "min_hz": low, "max_hz": high})
            }
            Self::Transition([from, to]) => {
                json!({"kind": "transition", "from_hz": from, "to_hz": to})
            }
        }
    }
}

impl GaitSettings {
    /// No run is longer than this, s.
    pub fn longest_s(&self) -> f64 {
        match self.length {
            RunLength::Stances(stances) => stances as f64 / self.frequency.slowest_hz(),
            RunLength::Seconds(seconds) => seconds,
        }
    }

    /// The table as in a document, every default filled in.
    pub fn to_value(&self) -> Value {
        let mut value = json!({
            "frequency": self.frequency.to_value(),
            "contact_deg": self.contact_deg,
            "load_n": self.load_n,
            "duty": self.duty,
            "shear_share": self.shear_share,
        });
        match self.length {
            RunLength::Stances(stances) => value["stances"] = stances.into(),
            RunLength::Seconds(seconds) => value["run_s"] = seconds.into(),
        }
        value
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_longest_run_has_the_slowest_turns() {
        let of = |frequency, length| {
            let settings = GaitSettings {
                frequency,
                length,
                ..GaitSettings::default()
            };
            settings.longest_s()
        };
        let stances = RunLength::Stances(10);
        assert_eq!(of(Frequency::Fixed(2.0), stances), 5.0);
        assert_eq!(of(Frequency::Randomised([1.0, 5.0]), stances), 10.0);
        assert_eq!(of(Frequency::Transition([5.0, 0.5]), stances), 20.0);
        assert_eq!(of(Frequency::Fixed(2.0), RunLength::Seconds(7.0)), 7.0);
    }
}
