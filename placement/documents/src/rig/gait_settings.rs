//! Settings of a gait: how often a foot steps, where on the tire and how hard.
//!
//! The ranges are those of the paper's Tables 3 and 7. The paper doesn't state, and we assume: how often each value occurs (evenly over its range); that
//! the ground is touched for half of a turn; and any shear at all. Its rig moves straight up and down, so its small forces along and across follow from the
//! press. Here they are drawn for each stance, since an estimator that is given forces of its own making learns nothing of shear.

// What users write is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

use document::fault::{Fault, member};
use document::fields::{Fields, Range, plain};
use document::typed::lists::Each;
use document::{Table, Variants};

const TURNS: Range = Range::new(0.01, 100.0, "Hz");
const CONTACT: Range = Range::new(-180.0, 180.0, "degrees");
const LOAD: Range = Range::new(0.0, 1e6, "N");
/// A contact of no time has no depth.
const DUTY: Range = Range::new(0.05, 1.0, "");
const SHARE: Range = Range::new(0.0, 1.0, "");

/// Gait of a foot.
#[derive(Debug, Clone, PartialEq, Table)]
#[table(
    name = "Gait",
    told = [frequency, "stances", "run_s", contact_deg, load_n, duty, shear_share],
    rule = check_frequency(frequency)
)]
pub struct GaitSettings {
    /// Turns of the crank a second.
    #[field(default = Frequency::usual())]
    pub frequency: Frequency,
    /// Least and greatest wheel angle of the contact, degrees.
    #[field(default = [0.0, 30.0], within = Each::least_and_greatest(CONTACT))]
    pub contact_deg: [f64; 2],
    /// Least and greatest load at the deepest point of a stance, N.
    #[field(default = [0.0, 30.0], within = Each::least_and_greatest(LOAD))]
    pub load_n: [f64; 2],
    /// Share of a turn in which the ground is touched.
    #[field(default = 0.5, within = DUTY)]
    pub duty: f64,
    /// Share of the shift at which the contact slides that a stance may use.
    #[field(default = 0.6, within = SHARE)]
    pub shear_share: f64,
    /// Length of a run.
    #[field(default = RunLength::Seconds(60.0), group = run_length)]
    pub length: RunLength,
}

/// Turns of the crank a second. A turn has one speed from its begin to its end.
#[derive(Debug, Clone, Copy, PartialEq, Variants)]
#[variants(tag = "kind", usual = Randomised, table)]
pub enum Frequency {
    /// All the same.
    Fixed {
        /// Turns a second, Hz.
        #[field(default = 2.0, within = TURNS)]
        hz: f64,
    },
    /// Frequency drawn evenly between two for each turn.
    Randomised {
        /// Slowest turn, Hz.
        #[field(default = 1.0, within = TURNS)]
        min_hz: f64,
        /// Fastest turn, Hz.
        #[field(default = 5.0, within = TURNS)]
        max_hz: f64,
    },
    /// Frequency that goes from the one to the other in equal parts over a run.
    Transition {
        /// Frequency at the run's begin, Hz.
        #[field(default = 1.0, within = TURNS)]
        from_hz: f64,
        /// Frequency at its end, Hz.
        #[field(default = 5.0, within = TURNS)]
        to_hz: f64,
    },
}

/// Length of a run.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum RunLength {
    /// Number of stances.
    Stances(usize),
    /// Time, s; the last stance is cut off.
    Seconds(f64),
}

/// A number of stances or of seconds.
mod run_length {
    use document::Map;
    use document::json_schema::{Properties, Schemas};
    use document::typed::field_value::Field;

    use super::*;

    const STANCES: (u64, u64) = (1, 1_000_000);
    const SECONDS: Range = Range::new(0.1, 1e6, "s");

    pub fn read_fields(
        fields: &Fields<'_>,
        usual: RunLength,
        faults: &mut Vec<Fault>,
    ) -> Option<RunLength> {
        match (fields.get("stances"), fields.get("run_s")) {
            (Some((_, at)), Some(_)) => {
                let detail = "a run has a number of stances or of seconds, run_s: leave one out";
                Fault::add(faults, &at, detail);
                None
            }
            (Some((value, at)), None) => {
                usize::read(value, &at, &STANCES, faults).map(RunLength::Stances)
            }
            (None, Some((value, at))) => {
                f64::read(value, &at, &SECONDS, faults).map(RunLength::Seconds)
            }
            (None, None) => Some(usual),
        }
    }

    pub fn write_fields(length: &RunLength, table: &mut Map) {
        let (name, value) = match *length {
            RunLength::Stances(stances) => ("stances", stances.into()),
            RunLength::Seconds(seconds) => ("run_s", seconds.into()),
        };
        table.insert(name.to_owned(), value);
    }

    pub fn describe(_: &RunLength, properties: &mut Properties, schemas: &mut Schemas) {
        let stances = usize::schema(&STANCES, schemas);
        let doc = "Number of stances of a run, in place of its length.";
        properties.add("stances", doc, stances, None, false);
        let doc = "Length of a run, s; 60 when left out.";
        properties.add("run_s", doc, SECONDS.schema(), None, false);
        properties.exclude(&["stances", "run_s"]);
    }
}

fn check_frequency(frequency: &Frequency, fields: &Fields<'_>, faults: &mut Vec<Fault>) {
    if let Frequency::Randomised { min_hz, max_hz } = *frequency
        && min_hz > max_hz
    {
        let detail = format!(
            "must be at least min_hz, {}; it is {}",
            plain(min_hz),
            plain(max_hz)
        );
        Fault::add(faults, &member(&fields.at("frequency"), "max_hz"), detail);
    }
}

impl Frequency {
    /// The slowest turn, Hz.
    pub(crate) fn slowest_hz(self) -> f64 {
        match self {
            Self::Fixed { hz } => hz,
            Self::Randomised {
                min_hz: a,
                max_hz: b,
            }
            | Self::Transition {
                from_hz: a,
                to_hz: b,
            } => a.min(b),
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
}

#[cfg(test)]
mod tests {
    use document::typed::field_value::Field;
    use document::typed::table_fields::table_value;
    use document::{Format, parse};

    use super::*;

    fn read(text: &str) -> Result<GaitSettings, Vec<String>> {
        let mut faults = Vec::new();
        let value = parse(text, Format::Toml).expect("TOML");
        let read = GaitSettings::read(&value, "", &(), &mut faults);
        let pointers = || faults.iter().map(|fault| fault.pointer.clone()).collect();
        read.filter(|_| faults.is_empty()).ok_or_else(pointers)
    }

    #[test]
    fn each_kind_of_frequency_has_fields_of_its_own() {
        let frequency = |text: &str| read(text).map(|gait| gait.frequency);
        for (text, expected) in [
            (
                "",
                Frequency::Randomised {
                    min_hz: 1.0,
                    max_hz: 5.0,
                },
            ),
            (
                "frequency = { kind = \"fixed\", hz = 0.8 }",
                Frequency::Fixed { hz: 0.8 },
            ),
            (
                "frequency = { kind = \"randomised\", max_hz = 3 }",
                Frequency::Randomised {
                    min_hz: 1.0,
                    max_hz: 3.0,
                },
            ),
            (
                "frequency = { kind = \"transition\", from_hz = 5, to_hz = 1 }",
                Frequency::Transition {
                    from_hz: 5.0,
                    to_hz: 1.0,
                },
            ),
        ] {
            assert_eq!(frequency(text), Ok(expected), "{text}");
        }
        for (text, at) in [
            ("frequency = 2", "/frequency"),
            ("frequency = { kind = \"slow\" }", "/frequency/kind"),
            (
                "frequency = { kind = \"fixed\", min_hz = 1 }",
                "/frequency/min_hz",
            ),
            ("frequency = { kind = \"fixed\", hz = 0 }", "/frequency/hz"),
            (
                "frequency = { min_hz = 3, max_hz = 2 }",
                "/frequency/max_hz",
            ),
        ] {
            assert_eq!(frequency(text), Err(vec![at.to_owned()]), "{text}");
        }
    }

    #[test]
    fn a_gait_reads_back_and_every_fault_has_its_place() {
        for text in [
            "",
            "stances = 100\nfrequency = { kind = \"fixed\" }",
            "run_s = 3600\ncontact_deg = [-5, 5]\nload_n = [10, 10]\nduty = 0.7\nshear_share = 0",
        ] {
            let settings = read(text).expect(text);
            let again = GaitSettings::read(&table_value(&settings), "", &(), &mut Vec::new());
            assert_eq!(again, Some(settings), "{text}");
        }
        assert_eq!(
            read(
                "stances = 0\ncontact_deg = [1, 2, 3]\nload_n = [3, 2]\nduty = 0\nshear_share = 2\nfoot = 1"
            ),
            Err([
                "/foot",
                "/contact_deg",
                "/load_n",
                "/duty",
                "/shear_share",
                "/stances"
            ]
            .map(str::to_owned)
            .to_vec())
        );
        let both = read("stances = 3\nrun_s = 4");
        assert_eq!(both, Err(vec!["/stances".to_owned()]));
    }
}
