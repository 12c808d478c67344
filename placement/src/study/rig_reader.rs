//! Reads a study's virtual rig: the table `rig`.

// What users write is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

use fem_client::document::fault::Fault;
use fem_client::document::fields::{Fields, Range, plain, shown};
use fem_client::scene::Level;
use fem_client::scene::reader::circuit_reader::{circuit_fields, named_circuit, read_circuit};
use serde_json::Value;

use crate::layout::ranking::asked_layouts::is_published;
use crate::layout::solving::study_layouts::Asked;
use crate::rig::gait::gait_reader::gait;
use crate::rig::rig_settings::{Branch, Electronics, ForceSensor, Noise, RigSettings, TireVariant};
use crate::study::Study;
use crate::study::candidate_reader::list;

const RATE: Range = Range::new(1.0, 1e5, "Hz");
const TIME_CONSTANT: Range = Range::new(1e-6, 1e9, "s");
const RANGE: Range = Range::new(1e-9, 1e9, "V");
/// Beyond, a number of 64 bits has no such steps.
const MOST_BITS: u64 = 32;
const SHARE: Range = Range::new(0.0, 10.0, "");
const TEMPERATURE: Range = Range::new(0.0, 1e4, "K");
const WARMING: Range = Range::new(-1e3, 1e3, "K/min");
const GAIN: Range = Range::new(0.0, 1.0, "");
const OFFSET: Range = Range::new(0.0, 60.0, "s");
const PPM: Range = Range::new(-1e5, 1e5, "parts in a million");
const FORCE: Range = Range::new(0.0, 1e6, "N");
const FACTOR: Range = Range::new(0.5, 2.0, "");
/// Each has a table of its own, some minutes of two cores on the coarse mesh.
const MOST_TIRES: usize = 4;
const MOST_BRANCHES: usize = 8;
const MOST_RUNS: u64 = 1000;
/// Instants of a run by either clock: five hours and a half at 200 Hz, some 700 MB of twelve films.
const MOST_INSTANTS: f64 = 4e6;
/// Readings of all films in a run: 400 MB.
const MOST_READINGS: f64 = 5e7;
/// Readings of all runs and layouts: some minutes of a core.
const MOST_OF_ALL: f64 = 2e9;

/// The rig; Some(None) where the study has none, None after a fault.
pub fn rig(fields: &Fields<'_>, faults: &mut Vec<Fault>) -> Option<Option<RigSettings>> {
    let Some((value, pointer)) = fields.get("rig") else {
        return Some(None);
    };
    let before = faults.len();
    let read = read(value, &pointer, faults)?;
    (faults.len() == before).then_some(Some(read))
}

fn read(value: &Value, pointer: &str, faults: &mut Vec<Fault>) -> Option<RigSettings> {
    let known = [
        "gait",
        "electronics",
        "noise",
        "force_sensor",
        "relaxation",
        "films_follow_force",
        "film_rate_hz",
        "runs",
        "seed",
        "paper_tables",
        "other_tires",
    ];
    let fields = Fields::open(value, pointer, &known, faults)?;
    let usual = RigSettings::default();
    // Each table is read whatever is wrong with the others: all faults are told at once.
    let gait = table(&fields, "gait", usual.gait, faults, gait);
    let electronics = table(
        &fields,
        "electronics",
        usual.electronics,
        faults,
        electronics,
    );
    let noise = table(&fields, "noise", usual.noise, faults, noise);
    let force_sensor = table(&fields, "force_sensor", usual.force_sensor, faults, sensor);
    let relaxation = table(&fields, "relaxation", usual.relaxation, faults, relaxation);
    let follow = table(
        &fields,
        "films_follow_force",
        usual.films_follow_force,
        faults,
        flag,
    );
    let film_rate_hz = fields.number("film_rate_hz", RATE, usual.film_rate_hz, faults);
    let runs = fields.integer("runs", (1, MOST_RUNS), usual.runs as u64, faults);
    let seed = fields.integer("seed", (0, u64::MAX), usual.seed, faults);
    let paper_tables = table(&fields, "paper_tables", usual.paper_tables, faults, flag);
    let others = table(
        &fields,
        "other_tires",
        usual.other_tires,
        faults,
        other_tires,
    );
    let settings = RigSettings {
        gait: gait?,
        electronics: electronics?,
        noise: noise?,
        force_sensor: force_sensor?,
        relaxation: relaxation?,
        films_follow_force: follow?,
        film_rate_hz: film_rate_hz?,
        runs: runs? as usize,
        seed: seed?,
        paper_tables: paper_tables?,
        other_tires: others?,
    };
    check_instants(&settings, &fields, faults)?;
    Some(settings)
}

/// What is read of a field, or the usual where it is absent.
fn table<T>(
    fields: &Fields<'_>,
    name: &str,
    usual: T,
    faults: &mut Vec<Fault>,
    read: fn(&Value, &str, &mut Vec<Fault>) -> Option<T>,
) -> Option<T> {
    match fields.get(name) {
        None => Some(usual),
        Some((value, pointer)) => read(value, &pointer, faults),
    }
}

fn electronics(value: &Value, pointer: &str, faults: &mut Vec<Fault>) -> Option<Electronics> {
    let usual = Electronics::default();
    let circuit = named_circuit(value, usual.circuit);
    let known = [
        circuit_fields(circuit),
        &["time_constant_s", "bits", "range_v"],
    ]
    .concat();
    let fields = Fields::open(value, pointer, &known, faults)?;
    let circuit = read_circuit(&fields, circuit, faults);
    let mut optional = |name, range| match fields.get(name) {
        None => Some(None),
        Some(_) => fields.number(name, range, 0.0, faults).map(Some),
    };
    let time_constant_s = optional("time_constant_s", TIME_CONSTANT);
    let range_v = optional("range_v", RANGE);
    let bits = fields.integer("bits", (0, MOST_BITS), usual.bits.into(), faults);
    Some(Electronics {
        circuit: circuit?,
        time_constant_s: time_constant_s?,
        bits: bits? as u32,
        range_v: range_v?,
    })
}

fn noise(value: &Value, pointer: &str, faults: &mut Vec<Fault>) -> Option<Noise> {
    let mut noise = Noise::default();
    let numbers = [
        ("white_share", SHARE, &mut noise.white_share),
        ("thermal_k", TEMPERATURE, &mut noise.thermal_k),
        ("drift_share", SHARE, &mut noise.drift_share),
        ("drift_time_s", TIME_CONSTANT, &mut noise.drift_time_s),
        ("warming_k_per_min", WARMING, &mut noise.warming_k_per_min),
        ("gain_std", GAIN, &mut noise.gain_std),
    ];
    Fields::of_numbers(value, pointer, &[], numbers, faults)?;
    Some(noise)
}

fn sensor(value: &Value, pointer: &str, faults: &mut Vec<Fault>) -> Option<ForceSensor> {
    let mut sensor = ForceSensor::default();
    let numbers = [
        ("rate_hz", RATE, &mut sensor.rate_hz),
        ("offset_s", OFFSET, &mut sensor.offset_s),
        ("ppm", PPM, &mut sensor.ppm),
        ("noise_n", FORCE, &mut sensor.noise_n),
    ];
    Fields::of_numbers(value, pointer, &[], numbers, faults)?;
    Some(sensor)
}

fn relaxation(value: &Value, pointer: &str, faults: &mut Vec<Fault>) -> Option<Vec<Branch>> {
    list(value, pointer, MOST_BRANCHES, faults, branch)
}

fn branch(value: &Value, pointer: &str, faults: &mut Vec<Fault>) -> Option<Branch> {
    let mut branch = Branch::default();
    let numbers = [
        ("share", SHARE, &mut branch.share),
        ("time_s", TIME_CONSTANT, &mut branch.time_s),
    ];
    Fields::of_numbers(value, pointer, &[], numbers, faults)?;
    Some(branch)
}

fn other_tires(value: &Value, pointer: &str, faults: &mut Vec<Fault>) -> Option<Vec<TireVariant>> {
    list(value, pointer, MOST_TIRES, faults, other_tire)
}

fn other_tire(value: &Value, pointer: &str, faults: &mut Vec<Fault>) -> Option<TireVariant> {
    let mut tire = TireVariant::default();
    let numbers = [
        ("wall_factor", FACTOR, &mut tire.wall_factor),
        ("pressure_factor", FACTOR, &mut tire.pressure_factor),
        ("friction_factor", FACTOR, &mut tire.friction_factor),
    ];
    let fields = Fields::of_numbers(value, pointer, &["level", "learnt"], numbers, faults)?;
    let learnt = table(&fields, "learnt", tire.learnt, faults, flag);
    let level = match fields.get("level") {
        None => Some(None),
        Some(_) => fields
            .choice("level", &Level::NAMES, Level::Draft, faults)
            .map(Some),
    };
    (tire.level, tire.learnt) = (level?, learnt?);
    if tire.is_own() {
        let detail = "is the study's own tire: give it another level, wall_factor, pressure_factor or friction_factor";
        Fault::add(faults, pointer, detail.to_owned());
        return None;
    }
    Some(tire)
}

fn flag(value: &Value, pointer: &str, faults: &mut Vec<Fault>) -> Option<bool> {
    let flag = value.as_bool();
    if flag.is_none() {
        let detail = format!("must be true or false; it is {}", shown(value));
        Fault::add(faults, pointer, detail);
    }
    flag
}

/// Whether what the films of a study's layouts read can be kept in memory, and be learnt from in reasonable time.
pub(crate) fn check_readings(study: &Study, faults: &mut Vec<Fault>) {
    let Some(rig) = &study.rig else {
        return;
    };
    let layouts = Asked::of(study).layouts;
    if rig.paper_tables && !layouts.iter().any(is_published) {
        let detail = "needs the published layout among the study's: six units of an x and a y film at the crown (layouts.units = [6])";
        Fault::add(faults, "/rig/paper_tables", detail.to_owned());
    }
    let films = layouts
        .into_iter()
        .map(|layout| layout.arrangement.films.len());
    let of_film = rig.gait.longest_s() * rig.film_rate_hz;
    let most = films.clone().max().unwrap_or(0) as f64;
    let all = films.sum::<usize>() as f64;
    let limits = [
        (
            "a run of the largest layout has",
            most * of_film,
            MOST_READINGS,
        ),
        (
            "all runs of all layouts have",
            all * of_film * rig.runs as f64,
            MOST_OF_ALL,
        ),
    ];
    for (what, readings, limit) in limits {
        if readings > limit {
            let detail = format!(
                "{what} up to {} readings of films; at most {} are recorded",
                plain(readings.round()),
                plain(limit)
            );
            Fault::add(faults, "/rig", detail);
        }
    }
}

/// A run's readings are kept in memory.
fn check_instants(
    settings: &RigSettings,
    fields: &Fields<'_>,
    faults: &mut Vec<Fault>,
) -> Option<()> {
    let fastest_hz = settings.film_rate_hz.max(settings.force_sensor.rate_hz);
    let instants = settings.gait.longest_s() * fastest_hz;
    if instants <= MOST_INSTANTS {
        return Some(());
    }
    let detail = format!(
        "makes runs of up to {} readings; at most {} are recorded: take more runs of fewer stances",
        plain(instants.round()),
        plain(MOST_INSTANTS)
    );
    Fault::add(faults, &fields.at("gait"), detail);
    None
}

#[cfg(test)]
mod tests {
    use fem_client::document::{Format, parse};
    use fem_client::film::amplifier::Circuit;
    use serde_json::json;

    use super::*;
    use crate::study::presets;

    fn read_text(text: &str) -> Result<Option<RigSettings>, Vec<Fault>> {
        let mut faults = Vec::new();
        let value = parse(text, Format::Toml).expect("TOML");
        let read = Fields::open(&value, "", &["rig"], &mut faults)
            .and_then(|fields| rig(&fields, &mut faults));
        read.ok_or(faults)
    }

    fn pointers(text: &str) -> Vec<String> {
        let faults = read_text(text).expect_err(text);
        faults.into_iter().map(|fault| fault.pointer).collect()
    }

    fn preset(name: &str) -> &'static str {
        let found = presets().into_iter().find(|(other, _)| *other == name);
        found.expect("it ships").1
    }

    #[test]
    fn more_readings_than_can_be_kept_are_refused() {
        let told = |rig: &str| {
            let text = preset("forces").replace("[rig] ", &format!("[rig]\n{rig}\n#"));
            let no_files = |path: &str| Err(path.to_owned());
            Study::from_document(&text, Format::Toml, &no_files)
                .err()
                .unwrap_or_default()
        };
        assert_eq!(told("runs = 8"), []);
        // 48 films of 24 units at 20 kHz for 60 s; with 100 films in all, four times and a thousand times.
        let details = |rig| -> Vec<String> {
            let faults = told(rig).into_iter();
            faults.map(|fault| fault.to_string()).collect()
        };
        let fast = details("film_rate_hz = 20000");
        assert!(
            fast.len() == 1 && fast[0].contains("largest layout has up to 5.76e7"),
            "{fast:?}"
        );
        let many = details("film_rate_hz = 2000\nruns = 1000");
        assert!(many.len() == 1 && many[0].contains("1.2e10"), "{many:?}");
    }

    #[test]
    fn no_table_is_no_rig_and_an_empty_one_has_all_defaults() {
        assert_eq!(read_text(""), Ok(None));
        assert_eq!(read_text("[rig]"), Ok(Some(RigSettings::default())));
    }

    #[test]
    fn a_rig_reads_back_from_its_canonical_table() {
        for text in [
            "[rig]",
            "[rig]\nruns = 7\nseed = 0\nfilms_follow_force = false\nfilm_rate_hz = 1000\nrelaxation = []",
            "[rig.electronics]\nkind = \"voltage\"\ninput_mohm = 1\ncable_pf = 100\nbits = 0\nrange_v = 5",
            "[rig.electronics]\nkind = \"open-circuit\"\ntime_constant_s = 0.01",
            "[rig.noise]\nwhite_share = 0\nthermal_k = 0\n[rig.force_sensor]\nppm = -40\n[rig.gait]\nstances = 12",
            "[rig]\npaper_tables = true\nother_tires = [{ level = \"draft\" }, { wall_factor = 1.05, level = \"coarse\", pressure_factor = 0.9, friction_factor = 1.2, learnt = true }]",
            "[[rig.relaxation]]\nshare = 0.2\ntime_s = 1\n[[rig.relaxation]]\nshare = 0.1\ntime_s = 0.03",
        ] {
            let settings = read_text(text).expect(text).expect("a rig");
            let document = json!({"rig": settings.to_value()});
            let fields = Fields::open(&document, "", &["rig"], &mut Vec::new()).expect("a table");
            assert_eq!(
                rig(&fields, &mut Vec::new()),
                Some(Some(settings)),
                "{text}"
            );
        }
    }

    #[test]
    fn a_time_constant_stands_beside_the_circuit() {
        let read = |text| read_text(text).expect(text).expect("a rig").electronics;
        let found = read("[rig.electronics]\ntime_constant_s = 0.1");
        assert_eq!(
            (found.circuit, found.time_constant_s),
            (Circuit::CHARGE, Some(0.1))
        );
        let found = read("[rig.electronics]\nkind = \"charge\"\nfeedback_nf = 2");
        let expected = Circuit::Charge {
            feedback_nf: 2.0,
            feedback_mohm: 1000.0,
        };
        assert_eq!((found.circuit, found.time_constant_s), (expected, None));
    }

    #[test]
    fn every_fault_has_its_place() {
        let text = "
            [rig]
            film_rate_hz = 0
            runs = 0
            other_tires = [{ level = \"fine\" }, { wall_factor = 1 }, { wall_factor = 3 }]
            seed = -1
            films_follow_force = 1
            paper_tables = 1
            colour = 1
            [rig.gait]
            duty = 2
            [rig.electronics]
            kind = \"voltage\"
            feedback_nf = 1
            time_constant_s = 0
            bits = 33
            range_v = nan
            [rig.noise]
            white_share = -1
            [rig.force_sensor]
            rate = 100
            [[rig.relaxation]]
            share = 0.1
            [[rig.relaxation]]
            share = 0.1
            time_s = 0
        ";
        let expected = [
            "colour",
            "gait/duty",
            "electronics/feedback_nf",
            "electronics/time_constant_s",
            "electronics/range_v",
            "electronics/bits",
            "noise/white_share",
            "force_sensor/rate",
            "relaxation/1/time_s",
            "films_follow_force",
            "film_rate_hz",
            "runs",
            "seed",
            "paper_tables",
            "other_tires/0/level",
            "other_tires/1",
            "other_tires/2/wall_factor",
        ];
        assert_eq!(pointers(text), expected.map(|name| format!("/rig/{name}")));
        assert_eq!(pointers("rig = 3"), ["/rig"]);
        assert_eq!(pointers("[rig]\nrelaxation = 3"), ["/rig/relaxation"]);
        let twice = "[rig]\nrelaxation = [{}, {}]";
        assert_eq!(pointers(twice), ["/rig/relaxation/1"]);
        assert_eq!(
            pointers("[rig.electronics]\nkind = \"tube\""),
            ["/rig/electronics/kind"]
        );
    }

    #[test]
    fn a_run_is_held_in_memory() {
        assert!(read_text("[rig.gait]\nrun_s = 20000").is_ok());
        assert_eq!(pointers("[rig.gait]\nrun_s = 20001"), ["/rig/gait"]);
        // At the slowest turn.
        assert!(read_text("[rig.gait]\nstances = 20000").is_ok());
        assert_eq!(pointers("[rig.gait]\nstances = 20001"), ["/rig/gait"]);
    }
}
