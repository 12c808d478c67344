//! The study document: what varies, what is asked.
//!
//! - `study_reader` and, for its parts, `candidate_reader`, `input_reader` and `method_reader`: read a study, with every fault at once
//! - `study_schema`: its JSON Schema
//! - [`question`]: what is asked of layouts
//! - [`study_fields`]: names of its fields
//! - `reading_bounds`: rules of a rig beside layouts
//! - [`plan`]: the design points of a study, a pure function of the document

pub(crate) mod candidate_reader;
pub(crate) mod input_reader;
pub(crate) mod method_reader;
pub mod plan;
pub mod question;
mod reading_bounds;
pub mod study_fields;
pub(crate) mod study_reader;
pub(crate) mod study_schema;

use document::typed::table_fields::table_value;
use fem_client::hexadecimal::hexadecimal;
use fem_client::scene::{Film, Level, Scene};
use fem_client::solver::{Grid, Readout};
use gsa::law::distribution::Distribution;
use gsa::method::{Kind, Method};
use serde_json::{Map, Value, json};
use sha2::{Digest, Sha256};

use crate::layouts::layout_settings::Layouts;
use crate::parts::directions::Directions;
use crate::parts::distribution_reader::distribution_value;
use crate::parts::film_model::FilmModel;
use crate::rig::rig_settings::RigSettings;
use crate::signals::signal_settings::SignalSettings;
use crate::study::candidate_reader::{Candidates, Points};
use crate::study::question::Question;

/// A checked study. Build it with [`Study::from_document`].
#[derive(Debug, Clone, PartialEq)]
pub struct Study {
    /// Free text, not empty.
    pub name: String,
    /// Scene to solve; at a point of the plan, with the point's values put in.
    pub scene: Scene,
    /// Inputs that vary.
    pub inputs: Vec<Input>,
    /// Directions of the strains that are asked for.
    pub directions: Directions,
    /// Dense map of candidates; absent: P1-P5 alone.
    pub grid: Option<Grid>,
    /// Layouts to score.
    pub layouts: Layouts,
    /// Question that the layouts answer; empty where none is asked.
    pub question: Question,
    /// Method that computes the indices.
    pub method: Method,
    /// Level of the mesh, at first where an accuracy is asked for; `scene.model.level` is the same.
    pub level: Level,
    /// Accuracy that is asked for.
    pub accuracy: Accuracy,
    /// Films' signals over loads, pressures and contact angles; absent: none are solved.
    pub signals: Option<SignalSettings>,
    /// A virtual rig that steps on the tire; absent: none does.
    pub rig: Option<RigSettings>,
}

/// Accuracy that is asked of the answer.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Accuracy {
    /// The study's own level and method.
    Preset,
    /// Largest error of an index, absolute.
    Tolerance(f64),
    /// Wall-clock time, s.
    Budget(f64),
}

/// An uncertain field of the scene.
#[derive(Debug, Clone, PartialEq)]
pub struct Input {
    /// Unique name, P1 to P5 in the paper's study.
    pub name: String,
    /// Path of the scene's field, as `ground.depths_mm[0]`.
    pub vary: String,
    /// Distribution of its values.
    pub distribution: Distribution,
}

/// Names and TOML texts of the studies that ship.
pub fn presets() -> [(&'static str, &'static str); 5] {
    [
        (
            "foot-tire",
            include_str!("../../../../studies/foot-tire.toml"),
        ),
        (
            "foot-tire-paper",
            include_str!("../../../../studies/foot-tire-paper.toml"),
        ),
        (
            "placement",
            include_str!("../../../../studies/placement.toml"),
        ),
        ("forces", include_str!("../../../../studies/forces.toml")),
        ("layouts", include_str!("../../../../studies/layouts.toml")),
    ]
}

impl Study {
    /// Returns what every solve of this study reads off.
    pub fn readout(&self) -> Readout {
        Readout {
            grid: self.grid,
            ..Readout::default()
        }
    }

    /// Returns its film: that of its signals, else of its scene, else the common one.
    pub fn film(&self) -> Film {
        match &self.signals {
            Some(signals) => signals.film.clone(),
            None => SignalSettings::on(&self.scene).film,
        }
    }

    /// The study as JSON text with every default filled in and the scene inline. It reads back as the same study, and
    /// equal studies have equal texts.
    pub fn canonical(&self) -> String {
        let candidates = Candidates {
            points: Points::Paper,
            directions: self.directions,
            grid: self.grid,
        };
        let mut document = json!({
            "name": self.name,
            "scene": self.scene.to_value(),
            "inputs": self.inputs.iter().map(Input::to_value).collect::<Vec<_>>(),
            "candidates": table_value(&candidates),
            "layouts": self.layouts.to_value(),
            "method": method_value(&self.method),
            "accuracy": match self.accuracy {
                Accuracy::Preset => json!({"preset": self.level.as_str()}),
                Accuracy::Tolerance(tolerance) => json!({"tolerance": tolerance}),
                Accuracy::Budget(seconds) => json!({"budget_s": seconds}),
            },
        });
        if self.layouts.is_asked() && self.layouts.glued.is_none() && self.has_film() {
            document["layouts"]["film"] = FilmModel::Bare.as_str().into();
        }
        if let Some(document) = document.as_object_mut() {
            let signals = self.signals.as_ref().map(SignalSettings::to_value);
            let rig = self.rig.as_ref().map(table_value);
            let question = (!self.question.is_empty()).then(|| table_value(&self.question));
            for (name, table) in [("question", question), ("signals", signals), ("rig", rig)] {
                document.extend(table.map(|table| (name.to_owned(), table)));
            }
        }
        document.to_string()
    }

    /// Whether it has a film that is glued on, so that those of layouts are where the document doesn't say otherwise.
    fn has_film(&self) -> bool {
        let of_signals = self.signals.as_ref().is_some_and(SignalSettings::has_glued);
        self.scene.film.is_some() || of_signals
    }

    /// SHA-256 of the canonical text, in hexadecimal digits.
    pub fn spec_sha256(&self) -> String {
        sha256_hex(&self.canonical())
    }
}

impl Input {
    /// The station whose depth this input varies, counted from 0; None when it varies something else.
    pub fn station(&self) -> Option<usize> {
        self.vary
            .strip_prefix("ground.depths_mm[")?
            .strip_suffix(']')?
            .parse()
            .ok()
    }

    fn to_value(&self) -> Value {
        json!({"name": self.name, "vary": self.vary, "distribution": distribution_value(&self.distribution)})
    }
}

/// The settings that the kind uses.
fn method_value(method: &Method) -> Value {
    let mut value = Map::new();
    let mut put = |name: &str, setting: Value| value.insert(name.to_owned(), setting);
    put("kind", method.kind.as_str().into());
    if !matches!(method.kind, Kind::Pce | Kind::Saltelli) {
        put("nodes", method.nodes.into());
        put("check_points", method.check_points.into());
    }
    if matches!(method.kind, Kind::Pce | Kind::Saltelli) {
        put("samples", method.samples.into());
    }
    if method.kind == Kind::Auto {
        put("tolerance", method.tolerance.into());
        put("most_runs", method.most_runs.into());
    }
    put("seed", method.seed.into());
    Value::Object(value)
}

/// SHA-256 of a text, in hexadecimal digits.
pub fn sha256_hex(text: &str) -> String {
    hexadecimal(&Sha256::digest(text))
}
