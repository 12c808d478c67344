//! Reads how a foot steps: the table `gait` of a rig.

// What users write is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

use fem_client::document::fault::{Fault, entry};
use fem_client::document::fields::{Fields, Range, number, plain, shown};
use serde_json::Value;

use crate::rig::gait::gait_settings::{Frequency, GaitSettings, RunLength};

const TURNS: Range = Range::new(0.01, 100.0, "Hz");
const CONTACT: Range = Range::new(-180.0, 180.0, "degrees");
const LOAD: Range = Range::new(0.0, 1e6, "N");
/// A contact of no time has no depth.
const DUTY: Range = Range::new(0.05, 1.0, "");
const SHARE: Range = Range::new(0.0, 1.0, "");
const SECONDS: Range = Range::new(0.1, 1e6, "s");
const MOST_STANCES: u64 = 1_000_000;
const KINDS: [(&str, Frequency); 3] = [
    ("fixed", Frequency::Fixed(2.0)),
    ("randomised", Frequency::Randomised([1.0, 5.0])),
    ("transition", Frequency::Transition([1.0, 5.0])),
];

/// The gait; absent fields have their defaults. None after a fault.
pub fn gait(value: &Value, pointer: &str, faults: &mut Vec<Fault>) -> Option<GaitSettings> {
    let known = [
        "frequency",
        "stances",
        "run_s",
        "contact_deg",
        "load_n",
        "duty",
        "shear_share",
    ];
    let fields = Fields::open(value, pointer, &known, faults)?;
    let usual = GaitSettings::default();
    let (mut duty, mut shear_share) = (usual.duty, usual.shear_share);
    let frequency = match fields.get("frequency") {
        None => Some(usual.frequency),
        Some((value, at)) => frequency(value, &at, faults),
    };
    let length = length(&fields, usual.length, faults);
    let contact_deg = pair(&fields, "contact_deg", CONTACT, usual.contact_deg, faults);
    let load_n = pair(&fields, "load_n", LOAD, usual.load_n, faults);
    fields.numbers(
        [
            ("duty", DUTY, &mut duty),
            ("shear_share", SHARE, &mut shear_share),
        ],
        faults,
    )?;
    Some(GaitSettings {
        frequency: frequency?,
        length: length?,
        contact_deg: contact_deg?,
        load_n: load_n?,
        duty,
        shear_share,
    })
}

fn frequency(value: &Value, pointer: &str, faults: &mut Vec<Fault>) -> Option<Frequency> {
    let kind = value.get("kind").and_then(Value::as_str);
    let named = KINDS.iter().find(|(name, _)| Some(*name) == kind);
    let mut frequency = named.map_or(GaitSettings::default().frequency, |(_, of_kind)| *of_kind);
    let own: &[&str] = match frequency {
        Frequency::Fixed(_) => &["hz"],
        Frequency::Randomised(_) => &["min_hz", "max_hz"],
        Frequency::Transition(_) => &["from_hz", "to_hz"],
    };
    let fields = Fields::open(value, pointer, &[&["kind"], own].concat(), faults)?;
    let kind = fields.choice("kind", &KINDS, frequency, faults);
    let numbers = match &mut frequency {
        Frequency::Fixed(hz) => fields.numbers([("hz", TURNS, hz)], faults),
        Frequency::Randomised([low, high]) => {
            fields.numbers([("min_hz", TURNS, low), ("max_hz", TURNS, high)], faults)
        }
        Frequency::Transition([from, to]) => {
            fields.numbers([("from_hz", TURNS, from), ("to_hz", TURNS, to)], faults)
        }
    };
    kind.and(numbers)?;
    match frequency {
        Frequency::Randomised([low, high]) if low > high => {
            let detail = format!(
                "must be at least min_hz, {}; it is {}",
                plain(low),
                plain(high)
            );
            Fault::add(faults, &fields.at("max_hz"), detail);
            None
        }
        _ => Some(frequency),
    }
}

fn length(fields: &Fields<'_>, usual: RunLength, faults: &mut Vec<Fault>) -> Option<RunLength> {
    let stances = fields.get("stances").is_some();
    let seconds = fields.get("run_s").is_some();
    if stances && seconds {
        let detail = "a run has a number of stances or of seconds, run_s: leave one out";
        Fault::add(faults, &fields.at("stances"), detail);
        return None;
    }
    if stances {
        let stances = fields.integer("stances", (1, MOST_STANCES), 1, faults)?;
        return Some(RunLength::Stances(stances as usize));
    }
    if seconds {
        let seconds = fields.number("run_s", SECONDS, 0.0, faults)?;
        return Some(RunLength::Seconds(seconds));
    }
    Some(usual)
}

/// A least and a greatest number.
fn pair(
    fields: &Fields<'_>,
    name: &str,
    range: Range,
    usual: [f64; 2],
    faults: &mut Vec<Fault>,
) -> Option<[f64; 2]> {
    let Some((value, pointer)) = fields.get(name) else {
        return Some(usual);
    };
    let Some([low, high]) = value.as_array().map(Vec::as_slice) else {
        let detail = format!(
            "must be a list of two numbers, the lower first; it is {}",
            shown(value)
        );
        Fault::add(faults, &pointer, detail);
        return None;
    };
    let low = number(low, &entry(&pointer, 0), range, faults);
    let high = number(high, &entry(&pointer, 1), range, faults);
    let (low, high) = (low?, high?);
    if low > high {
        let detail = format!(
            "must have the lower number first; it is {} and {}",
            plain(low),
            plain(high)
        );
        Fault::add(faults, &pointer, detail);
        return None;
    }
    Some([low, high])
}

#[cfg(test)]
mod tests {
    use fem_client::document::{Format, parse};

    use super::*;

    fn read(text: &str) -> Result<GaitSettings, Vec<String>> {
        let mut faults = Vec::new();
        let value = parse(text, Format::Toml).expect("TOML");
        let read = gait(&value, "", &mut faults);
        let pointers = || faults.iter().map(|fault| fault.pointer.clone()).collect();
        read.filter(|_| faults.is_empty()).ok_or_else(pointers)
    }

    #[test]
    fn each_kind_of_frequency_has_fields_of_its_own() {
        let frequency = |text: &str| read(text).map(|gait| gait.frequency);
        for (text, expected) in [
            ("", Frequency::Randomised([1.0, 5.0])),
            (
                "frequency = { kind = \"fixed\", hz = 0.8 }",
                Frequency::Fixed(0.8),
            ),
            (
                "frequency = { kind = \"randomised\", max_hz = 3 }",
                Frequency::Randomised([1.0, 3.0]),
            ),
            (
                "frequency = { kind = \"transition\", from_hz = 5, to_hz = 1 }",
                Frequency::Transition([5.0, 1.0]),
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
            let again = gait(&settings.to_value(), "", &mut Vec::new());
            assert_eq!(again, Some(settings), "{text}");
        }
        assert_eq!(
            read(
                "stances = 0\ncontact_deg = [1, 2, 3]\nload_n = [3, 2]\nduty = 0\nshear_share = 2\nfoot = 1"
            ),
            Err([
                "/foot",
                "/stances",
                "/contact_deg",
                "/load_n",
                "/duty",
                "/shear_share"
            ]
            .map(str::to_owned)
            .to_vec())
        );
        let both = read("stances = 3\nrun_s = 4");
        assert_eq!(both, Err(vec!["/stances".to_owned()]));
    }
}
