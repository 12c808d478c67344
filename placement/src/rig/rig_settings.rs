//! Everything of a virtual rig that can be set.
//!
//! The paper states the rate of the films' readings, 200 Hz, and the ranges of its gait. It states no circuit, no noise, no clock of the force sensor and no
//! relaxation; those defaults are assumed. Sensing films are said to spread by 5 to 10 % in gain; rubber as soft as the paper's loses some tenth of its
//! force in the first seconds.

use fem_client::film::amplifier::Circuit;
use fem_client::scene::Level;
use serde_json::{Value, json};

use crate::rig::gait::gait_settings::GaitSettings;

/// A virtual rig.
#[derive(Debug, Clone, PartialEq)]
pub struct RigSettings {
    /// How the foot steps.
    pub gait: GaitSettings,
    /// What films are wired to.
    pub electronics: Electronics,
    /// What is read beside the films' own signals.
    pub noise: Noise,
    /// What measures the forces.
    pub force_sensor: ForceSensor,
    /// How the rubber relaxes; empty where it doesn't.
    pub relaxation: Vec<Branch>,
    /// Whether the films' charges relax as the force does: those of stiff glued films do, which the force stretches; those of soft ones follow the depth.
    pub films_follow_force: bool,
    /// Readings of each film a second, Hz.
    pub film_rate_hz: f64,
    /// Runs, each with gains of its own: sessions.
    pub runs: usize,
    /// Of all that is drawn at random.
    pub seed: u64,
    /// Whether the published study's tables are asked for.
    pub paper_tables: bool,
    /// Tires that estimators are tried on, too.
    pub other_tires: Vec<TireVariant>,
}

/// A tire that differs from the study's.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TireVariant {
    /// Its mesh, where it has another one.
    pub level: Option<Level>,
    /// Its wall's thickness over that of the study's.
    pub wall_factor: f64,
    /// Its pressure over that of the study's.
    pub pressure_factor: f64,
    /// The ground's coefficient of friction over that of the study's.
    pub friction_factor: f64,
    /// Whether estimators learn from it, too: runs are shared out by turns, the study's own tire first.
    pub learnt: bool,
}

/// What films are wired to.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Electronics {
    /// The circuit.
    pub circuit: Circuit,
    /// A time constant in place of the circuit's own, s; the volts of a held charge stay.
    pub time_constant_s: Option<f64>,
    /// Bits of the converter; 0 for one that doesn't round.
    pub bits: u32,
    /// It reads from minus this to this, V; where none is set, twice each film's full scale.
    pub range_v: Option<f64>,
}

/// What is read beside the films' own signals.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Noise {
    /// Standard deviation of white noise, as a share of a film's full scale in held volts.
    pub white_share: f64,
    /// Temperature of the circuit's resistance, K; 0 for none of its noise.
    pub thermal_k: f64,
    /// Standard deviation that the drift comes to, as a share of full scale.
    pub drift_share: f64,
    /// Time constant of the drift, s.
    pub drift_time_s: f64,
    /// Warming of all films, K a minute.
    pub warming_k_per_min: f64,
    /// Standard deviation of the films' gains, drawn once a run.
    pub gain_std: f64,
}

/// What measures the forces.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ForceSensor {
    /// Readings a second by its own clock, Hz.
    pub rate_hz: f64,
    /// Its first reading, s after the films' first one.
    pub offset_s: f64,
    /// By how much its intervals are longer than they should be, parts in a million.
    pub ppm: f64,
    /// Standard deviation of its white noise, N.
    pub noise_n: f64,
}

/// A Prony branch of the rubber.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Branch {
    /// What it bears at first, as a share of the slow force.
    pub share: f64,
    /// Time constant, s.
    pub time_s: f64,
}

impl Default for RigSettings {
    fn default() -> Self {
        Self {
            gait: GaitSettings::default(),
            electronics: Electronics::default(),
            noise: Noise::default(),
            force_sensor: ForceSensor::default(),
            relaxation: vec![Branch::default()],
            films_follow_force: true,
            film_rate_hz: 200.0,
            runs: 4,
            seed: 1,
            paper_tables: false,
            other_tires: Vec::new(),
        }
    }
}

impl Default for Electronics {
    fn default() -> Self {
        Self {
            circuit: Circuit::CHARGE,
            time_constant_s: None,
            bits: 12,
            range_v: None,
        }
    }
}

impl Default for Noise {
    fn default() -> Self {
        Self {
            white_share: 0.01,
            thermal_k: 293.0,
            drift_share: 0.005,
            drift_time_s: 60.0,
            warming_k_per_min: 0.1,
            gain_std: 0.05,
        }
    }
}

impl Default for Branch {
    fn default() -> Self {
        Self {
            share: 0.1,
            time_s: 0.3,
        }
    }
}

impl Default for TireVariant {
    fn default() -> Self {
        Self {
            level: None,
            wall_factor: 1.0,
            pressure_factor: 1.0,
            friction_factor: 1.0,
            learnt: false,
        }
    }
}

impl TireVariant {
    /// In what it differs, in words.
    pub fn described(&self) -> String {
        let mesh = self.level.map(|level| format!("{} mesh", level.as_str()));
        let factors = [
            ("wall", self.wall_factor, ["thinner", "thicker"]),
            ("pressure", self.pressure_factor, ["lower", "higher"]),
            ("friction", self.friction_factor, ["lower", "higher"]),
        ];
        let other = factors.iter().filter(|(_, factor, _)| *factor != 1.0);
        let words = other.map(|(what, factor, words)| {
            let percent = 100.0 * (factor - 1.0);
            let word = words[usize::from(percent > 0.0)];
            format!("{what} {} % {word}", (10.0 * percent.abs()).round() / 10.0)
        });
        let parts: Vec<String> = mesh.into_iter().chain(words).collect();
        parts.join(", ")
    }

    /// Whether it is the study's own.
    pub fn is_own(&self) -> bool {
        let usual = Self {
            learnt: self.learnt,
            ..Self::default()
        };
        *self == usual
    }

    fn to_value(self) -> Value {
        let mut value = json!({
            "wall_factor": self.wall_factor,
            "pressure_factor": self.pressure_factor,
            "friction_factor": self.friction_factor,
            "learnt": self.learnt,
        });
        if let Some(level) = self.level {
            value["level"] = level.as_str().into();
        }
        value
    }
}

impl Default for ForceSensor {
    fn default() -> Self {
        Self {
            rate_hz: 200.0,
            offset_s: 0.0017,
            ppm: 20.0,
            noise_n: 0.05,
        }
    }
}

impl RigSettings {
    /// The table as in a document, every default filled in.
    pub fn to_value(&self) -> Value {
        let Noise {
            white_share,
            thermal_k,
            drift_share,
            drift_time_s,
            warming_k_per_min,
            gain_std,
        } = self.noise;
        let ForceSensor {
            rate_hz,
            offset_s,
            ppm,
            noise_n,
        } = self.force_sensor;
        let branch = |branch: &Branch| json!({"share": branch.share, "time_s": branch.time_s});
        json!({
            "gait": self.gait.to_value(),
            "electronics": self.electronics.to_value(),
            "noise": {
                "white_share": white_share,
                "thermal_k": thermal_k,
                "drift_share": drift_share,
                "drift_time_s": drift_time_s,
                "warming_k_per_min": warming_k_per_min,
                "gain_std": gain_std,
            },
            "force_sensor": {
                "rate_hz": rate_hz,
                "offset_s": offset_s,
                "ppm": ppm,
                "noise_n": noise_n,
            },
            "relaxation": self.relaxation.iter().map(branch).collect::<Vec<_>>(),
            "films_follow_force": self.films_follow_force,
            "film_rate_hz": self.film_rate_hz,
            "runs": self.runs,
            "seed": self.seed,
            "paper_tables": self.paper_tables,
            "other_tires": self.other_tires.iter().map(|tire| tire.to_value()).collect::<Vec<_>>(),
        })
    }
}

impl Electronics {
    fn to_value(self) -> Value {
        let mut value = json!(self.circuit);
        value["bits"] = self.bits.into();
        let set = [
            ("time_constant_s", self.time_constant_s),
            ("range_v", self.range_v),
        ];
        for (name, set) in set {
            if let Some(set) = set {
                value[name] = set.into();
            }
        }
        value
    }
}
