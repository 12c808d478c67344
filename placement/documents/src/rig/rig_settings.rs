//! Settings of a virtual rig.
//!
//! The paper states the rate of the films' readings, 200 Hz, and the ranges of its gait. It states no circuit, no noise, no clock of the force sensor and no
//! relaxation; those defaults are assumed. Sensing films are said to spread by 5 to 10 % in gain; rubber as soft as the paper's loses some tenth of its
//! force in the first seconds.

// What users write is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

use document::Table;
use document::fault::Fault;
use document::fields::{Fields, Range, plain};
use document::typed::lists::Entries;
use fem_client::film::amplifier::Circuit;
use fem_client::scene::Level;

use crate::rig::gait_settings::GaitSettings;

const RATE: Range = Range::new(1.0, 1e5, "Hz");
const TIME_CONSTANT: Range = Range::new(1e-6, 1e9, "s");
const VOLTS: Range = Range::new(1e-9, 1e9, "V");
const SHARE: Range = Range::new(0.0, 10.0, "");
const TEMPERATURE: Range = Range::new(0.0, 1e4, "K");
const WARMING: Range = Range::new(-1e3, 1e3, "K/min");
const GAIN: Range = Range::new(0.0, 1.0, "");
const OFFSET: Range = Range::new(0.0, 60.0, "s");
const PPM: Range = Range::new(-1e5, 1e5, "parts in a million");
const FORCE: Range = Range::new(0.0, 1e6, "N");
const FACTOR: Range = Range::new(0.5, 2.0, "");
/// Bits of a converter: beyond, a number of 64 bits has no such steps.
const BITS: (u64, u64) = (0, 32);
/// Each has a table of its own, some minutes of two cores on the coarse mesh.
const MOST_TIRES: usize = 4;
const MOST_BRANCHES: usize = 8;
const RUNS: (u64, u64) = (1, 1000);
/// Instants of a run by either clock: five hours and a half at 200 Hz, some 700 MB of twelve films.
const MOST_INSTANTS: f64 = 4e6;

/// A virtual rig.
#[derive(Debug, Clone, PartialEq, Table)]
#[table(name = "Rig", rule = check_instants)]
pub struct RigSettings {
    /// Gait of the foot.
    pub gait: GaitSettings,
    /// Circuit and converter that films are wired to.
    pub electronics: Electronics,
    /// Noise beside the films' own signals.
    pub noise: Noise,
    /// Sensor that measures the forces.
    pub force_sensor: ForceSensor,
    /// Relaxation of the rubber; empty where it doesn't relax.
    #[field(default = vec![Branch::default()], within = Entries::distinct(MOST_BRANCHES, ()))]
    pub relaxation: Vec<Branch>,
    /// Whether the films' charges relax as the force does: those of stiff glued films do, which the force stretches; those of soft ones follow the depth.
    #[field(default = true)]
    pub films_follow_force: bool,
    /// Readings of each film a second, Hz.
    #[field(default = 200.0, within = RATE)]
    pub film_rate_hz: f64,
    /// Runs, each with gains of its own: sessions.
    #[field(default = 4, within = RUNS)]
    pub runs: usize,
    /// Seed of all that is drawn at random.
    #[field(default = 1, within = (0, u64::MAX))]
    pub seed: u64,
    /// Tires that estimators are tried on, too.
    #[field(within = Entries::distinct(MOST_TIRES, ()))]
    pub other_tires: Vec<TireVariant>,
}

/// A tire that differs from the study's.
#[derive(Debug, Clone, Copy, PartialEq, Table)]
#[table(name = "OtherTire", told = [level, learnt, wall_factor, pressure_factor, friction_factor], rule = check_other)]
pub struct TireVariant {
    /// Thickness of its wall over that of the study's.
    #[field(default = 1.0, within = FACTOR)]
    pub wall_factor: f64,
    /// Pressure over that of the study's.
    #[field(default = 1.0, within = FACTOR)]
    pub pressure_factor: f64,
    /// Coefficient of friction of the ground over that of the study's.
    #[field(default = 1.0, within = FACTOR)]
    pub friction_factor: f64,
    /// Whether estimators learn from it, too: runs are shared out by turns, the study's own tire first.
    pub learnt: bool,
    /// Mesh level, where it has another one.
    pub level: Option<Level>,
}

/// Circuit and converter that films are wired to.
#[derive(Debug, Clone, Copy, PartialEq, Table)]
#[table(told = [circuit, time_constant_s, bits, range_v])]
pub struct Electronics {
    /// The circuit.
    #[field(default = Circuit::CHARGE, group)]
    pub circuit: Circuit,
    /// Bits of the converter; 0 for one that doesn't round.
    #[field(default = 12, within = BITS)]
    pub bits: u32,
    /// A time constant in place of the circuit's own, s; the volts of a held charge stay.
    #[field(within = TIME_CONSTANT)]
    pub time_constant_s: Option<f64>,
    /// Largest reading, V: it reads from minus this to this; twice each film's full scale where none is set.
    #[field(within = VOLTS)]
    pub range_v: Option<f64>,
}

/// Noise beside the films' own signals.
#[derive(Debug, Clone, Copy, PartialEq, Table)]
pub struct Noise {
    /// Standard deviation of white noise, as a share of a film's full scale in held volts.
    #[field(default = 0.01, within = SHARE)]
    pub white_share: f64,
    /// Temperature of the circuit's resistance, K; 0 for none of its noise.
    #[field(default = 293.0, within = TEMPERATURE)]
    pub thermal_k: f64,
    /// Standard deviation that the drift comes to, as a share of full scale.
    #[field(default = 0.005, within = SHARE)]
    pub drift_share: f64,
    /// Time constant of the drift, s.
    #[field(default = 60.0, within = TIME_CONSTANT)]
    pub drift_time_s: f64,
    /// Warming of all films, K a minute.
    #[field(default = 0.1, within = WARMING)]
    pub warming_k_per_min: f64,
    /// Standard deviation of the films' gains, drawn once a run.
    #[field(default = 0.05, within = GAIN)]
    pub gain_std: f64,
}

/// Sensor that measures the forces.
#[derive(Debug, Clone, Copy, PartialEq, Table)]
pub struct ForceSensor {
    /// Readings a second by its own clock, Hz.
    #[field(default = 200.0, within = RATE)]
    pub rate_hz: f64,
    /// Time of its first reading after the films' first one, s.
    #[field(default = 0.0017, within = OFFSET)]
    pub offset_s: f64,
    /// Excess of its intervals over what they should be, parts in a million.
    #[field(default = 20.0, within = PPM)]
    pub ppm: f64,
    /// Standard deviation of its white noise, N.
    #[field(default = 0.05, within = FORCE)]
    pub noise_n: f64,
}

/// A Prony branch of the rubber.
#[derive(Debug, Clone, Copy, PartialEq, Table)]
pub struct Branch {
    /// Force that it bears at first, as a share of the slow force.
    #[field(default = 0.1, within = SHARE)]
    pub share: f64,
    /// Time constant, s.
    #[field(default = 0.3, within = TIME_CONSTANT)]
    pub time_s: f64,
}

impl TireVariant {
    /// Says in what it differs.
    pub fn described(&self) -> String {
        let mesh = self.level.map(|level| format!("{} mesh", level.as_str()));
        let factors = [
            ("wall", self.wall_factor, ["thinner", "thicker"]),
            ("pressure", self.pressure_factor, ["lower", "higher"]),
            ("friction", self.friction_factor, ["lower", "higher"]),
        ];
        let other = factors.iter().filter(|(_, factor, _)| *factor != 1.0);
        let words = other.map(|(what, factor, [less, more])| {
            let percent = 100.0 * (factor - 1.0);
            let word = if percent > 0.0 { more } else { less };
            format!("{what} {} % {word}", (10.0 * percent.abs()).round() / 10.0)
        });
        let parts: Vec<String> = mesh.into_iter().chain(words).collect();
        parts.join(", ")
    }

    /// Whether it is the study's own.
    pub(crate) fn is_own(&self) -> bool {
        let usual = Self {
            learnt: self.learnt,
            ..Self::default()
        };
        *self == usual
    }
}

fn check_other(tire: &TireVariant, fields: &Fields<'_>, faults: &mut Vec<Fault>) -> Option<()> {
    if !tire.is_own() {
        return Some(());
    }
    let detail = "is the study's own tire: give it another level, wall_factor, pressure_factor or friction_factor";
    Fault::add(faults, fields.pointer(), detail);
    None
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
    use document::typed::field_value::Field;
    use document::typed::table_fields::table_value;
    use document::{Format, parse};
    use fem_client::film::amplifier::Circuit;

    use super::*;

    #[derive(Debug, PartialEq, Table)]
    struct Study {
        rig: Option<RigSettings>,
    }

    fn read_text(text: &str) -> Result<Option<RigSettings>, Vec<Fault>> {
        let mut faults = Vec::new();
        let value = parse(text, Format::Toml).expect("TOML");
        let read = Study::read(&value, "", &(), &mut faults).filter(|_| faults.is_empty());
        read.map(|study| study.rig).ok_or(faults)
    }

    fn pointers(text: &str) -> Vec<String> {
        let faults = read_text(text).expect_err(text);
        faults.into_iter().map(|fault| fault.pointer).collect()
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
            "[rig]\nother_tires = [{ level = \"draft\" }, { wall_factor = 1.05, level = \"coarse\", pressure_factor = 0.9, friction_factor = 1.2, learnt = true }]",
            "[[rig.relaxation]]\nshare = 0.2\ntime_s = 1\n[[rig.relaxation]]\nshare = 0.1\ntime_s = 0.03",
        ] {
            let settings = read_text(text).expect(text).expect("a rig");
            let again = RigSettings::read(&table_value(&settings), "", &(), &mut Vec::new());
            assert_eq!(again, Some(settings), "{text}");
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
            "electronics/bits",
            "electronics/time_constant_s",
            "electronics/range_v",
            "noise/white_share",
            "force_sensor/rate",
            "relaxation/1/time_s",
            "films_follow_force",
            "film_rate_hz",
            "runs",
            "seed",
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
