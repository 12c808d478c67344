//! Recipe for recordings: which columns, which preprocessing, features and models, which split judges.
//!
//! Every field has a default, so that a recipe may be empty.

// What users write is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

pub(crate) mod column_names;
mod cycle_rule;
mod feature_sets;
mod field_rules;
pub mod time_unit;

use document::fault::Fault;
use document::fields::{Fields, Range};
use document::typed::field_value::Field;
use document::typed::lists::Entries;
use document::{Choice, Format, Table, Value, parse};
use serde::{Deserialize, Serialize};

pub use cycle_rule::CycleRule;
pub(crate) use feature_sets::MOST_BASELINE_S;
pub use feature_sets::{FeatureSet, Features, USUAL_BASELINE_S};
use field_rules::{MOST_WINDOW, each_once};
use time_unit::TimeUnit;

const SECONDS: Range = Range::new(1e-6, 1e9, "s");
const HERTZ: Range = Range::new(1e-6, 1e6, "Hz");
const DEVIATIONS: Range = Range::new(1.0, 1000.0, "robust deviations");
const DECAY: Range = Range::new(0.0, 1e6, "");
const TIME_CONSTANT: Range = Range::new(0.0, 1e9, "s");
const MOST_START_ROWS: u64 = 1000;
const MOST_LAYERS: usize = 8;
const NODES: (u64, u64) = (1, 256);
/// Rows of a process; 5000 make a covariance of 200 MB.
const PROCESS_ROWS: (u64, u64) = (20, 5000);

/// The whole recipe.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, Table)]
#[serde(deny_unknown_fields)]
pub struct Recipe {
    /// Columns that are meant.
    pub columns: Columns,
    /// Treatment of signals before anything is learnt.
    pub preprocess: Preprocess,
    /// Features that models are given of the signals.
    pub features: Features,
    /// Models that are tried, and how.
    pub models: Models,
    /// Validation that judges them.
    pub validation: Validation,
}

/// Columns that are meant; patterns have `*` and `?`.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, Table)]
#[table(told = [time, time_unit, signals, not_signals, forces, "cycle", "pause_s", "threshold_n", "block_s"])]
#[serde(deny_unknown_fields)]
pub struct Columns {
    /// Time; `time_s` or the like, or else the first column where none is named.
    #[field(with = column_names::one)]
    pub time: Option<String>,
    /// Unit of the time; that of the column's name where none is named, or else seconds.
    #[serde(default)]
    pub time_unit: Option<TimeUnit>,
    /// Signals; all other columns where none are named.
    #[field(with = column_names::several)]
    pub signals: Option<Vec<String>>,
    /// Columns that are no signals, whatever the patterns of signals say.
    #[field(with = column_names::several)]
    #[serde(default)]
    pub not_signals: Option<Vec<String>>,
    /// Forces, N; `fx_n`, `fy_n`, `fz_n` or the like where none are named.
    #[field(with = column_names::several)]
    pub forces: Option<Vec<String>>,
    /// Rule for what a cycle is.
    #[field(group)]
    pub cycles: CycleRule,
}

/// Treatment of signals, in this order.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, Table)]
#[serde(deny_unknown_fields)]
pub struct Preprocess {
    /// Whether each run's first reading is taken off.
    #[field(default = StartValue::Auto)]
    pub start_value: StartValue,
    /// First readings of a run, or after a zero of a stream, whose median is taken off. While they come it is that of those so far.
    #[field(default = 1, within = (1, MOST_START_ROWS))]
    #[serde(default = "first_reading")]
    pub start_rows: usize,
    /// Whether the sign of signals is turned.
    pub turn_sign: bool,
    /// The clock that signals and forces are interpolated to, Hz; none leaves rows as they are.
    #[field(within = HERTZ)]
    pub rate_hz: Option<f64>,
    /// Rows of the moving average; 1 for none.
    #[field(default = 1, within = (1, MOST_WINDOW))]
    pub smooth_rows: usize,
    /// Rows with a signal further than so many robust deviations from its median aren't learnt from; none keeps all. All are tested.
    #[field(within = DEVIATIONS)]
    pub outlier_z: Option<f64>,
    /// Whether rows that hold a suspect sample, themselves or in a window, are learnt from. All are tested.
    #[field(default = SuspectRows::Keep)]
    #[serde(default)]
    pub suspect_rows: SuspectRows,
    /// Method that brings features to one scale.
    #[field(default = Scale::Standardise)]
    pub scale: Scale,
    /// Answer to a row of a stream that isn't estimated from.
    #[field(default = BadRows::Null)]
    #[serde(default)]
    pub bad_rows: BadRows,
    /// A longer time between rows is a pause, s; none for ten typical intervals. Nothing is carried over a pause.
    #[field(within = SECONDS)]
    pub pause_s: Option<f64>,
}

/// First readings whose median was taken off before recipes had a number of them.
pub(crate) fn first_reading() -> usize {
    1
}

/// Whether each run's first reading is taken off.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Choice)]
pub enum StartValue {
    /// Whichever knows left-out runs better; of one run kept, unless its signals come back to the first reading and that is nearer to them than they are to 0.
    Auto,
    /// First readings taken off: runs begin unloaded.
    Subtract,
    /// First readings kept.
    Keep,
    /// Each run's median without a force taken off, which takes forces that are measured as none; of what is estimated later the first reading, or `--start`.
    Unloaded,
}

/// Whether rows with a sample that is hardly a measurement, as it stands alone or is far beyond all others, are learnt from.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Choice)]
pub enum SuspectRows {
    /// Learnt from as all others.
    #[default]
    Keep,
    /// Left out of learning.
    LeaveOut,
}

/// Answer to a row of a stream that isn't estimated from, as it is late, cut or no number.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Choice)]
pub enum BadRows {
    /// No estimate: empty cells.
    #[default]
    Null,
    /// The last estimate.
    Hold,
}

/// Method that brings features to one scale, learnt from training rows.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Choice)]
pub enum Scale {
    /// Mean 0, standard deviation 1.
    Standardise,
    /// Range from 0 to 1.
    Normalise,
    /// Features as they are.
    Off,
}

/// Models that are tried, and how each is learnt.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, Table)]
#[table(rule = check_kinds(kinds))]
#[serde(deny_unknown_fields)]
pub struct Models {
    /// The kinds that are tried, beside the training mean, which always is.
    #[field(default = vec![Kind::Ridge, Kind::Gpr, Kind::Ann, Kind::Blend], within = Entries::of(1, Kind::ALL.len(), "entries", ()))]
    pub kinds: Vec<Kind>,
    /// Gaussian processes.
    pub gpr: GprSettings,
    /// Neural networks.
    pub ann: AnnSettings,
    /// Seed of all that is drawn at random.
    #[field(default = 1, within = (0, u64::from(u32::MAX)))]
    pub seed: u64,
}

/// A kind of model, the simplest first.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Choice)]
pub enum Kind {
    /// The training rows' mean: what every other has to beat.
    Mean,
    /// A line in the features, held short.
    Ridge,
    /// A Gaussian process.
    Gpr,
    /// A neural network.
    Ann,
    /// The median of those that are nearly as good as the best.
    Blend,
}

/// Settings of Gaussian processes.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, Table)]
#[table(name = "Gpr")]
#[serde(deny_unknown_fields)]
pub struct GprSettings {
    /// Length scales: one, or one for each feature.
    #[field(default = Lengths::Shared)]
    pub lengths: Lengths,
    /// Whether a line in the features is added, as heavy as the rows make it: beyond what was learnt from, it goes on where the squared exponential falls
    /// back to the mean.
    #[field(default = true)]
    pub line: bool,
    /// Starts of the search for hyperparameters, drawn at random.
    #[field(default = 50, within = (1, 1000))]
    pub restarts: usize,
    /// Rows from which the hyperparameters are learnt, an even subset.
    #[field(default = 600, within = PROCESS_ROWS)]
    pub search_rows: usize,
    /// Rows that the process is conditioned on, an even subset.
    #[field(default = 3000, within = PROCESS_ROWS)]
    pub most_rows: usize,
}

/// Length scales of a Gaussian process.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Choice)]
pub enum Lengths {
    /// A length for all features.
    Shared,
    /// A length for each feature.
    Each,
}

/// Settings of neural networks.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, Table)]
#[table(name = "Ann")]
#[serde(deny_unknown_fields)]
pub struct AnnSettings {
    /// Nodes of each hidden layer.
    #[field(default = vec![24, 12], within = Entries::of(1, MOST_LAYERS, "entries", NODES))]
    pub layers: Vec<usize>,
    /// Activation of hidden layers.
    #[field(default = Activation::Tanh)]
    pub activation: Activation,
    /// Activation of the last layer.
    #[field(default = Activation::Linear, with = output)]
    pub output: Activation,
    /// Loss that is made small.
    #[field(default = Loss::Mse)]
    pub loss: Loss,
    /// Weight of the squared weights in the loss.
    #[field(default = 1e-3, within = DECAY)]
    pub decay: f64,
    /// Most iterations.
    #[field(default = 300, within = (1, 100_000))]
    pub iterations: usize,
    /// Networks whose mean is the estimate, each from weights of its own.
    #[field(default = 3, within = (1, 50))]
    pub networks: usize,
}

/// Function by which a node's value follows from its sum.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Choice)]
pub enum Activation {
    /// z
    Linear,
    /// 1 / (1 + exp(-z))
    Sigmoid,
    /// tanh z
    Tanh,
    /// max(z, 0)
    Relu,
    /// z, or exp(z) - 1 below 0
    Elu,
    /// exp(z_i) over the layer's sum
    Softmax,
}

/// Loss that training makes small.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Choice)]
pub enum Loss {
    /// Half the mean squared error.
    Mse,
    /// Poisson's negative log likelihood, exp(z) - y z: for forces that are never negative.
    Poisson,
}

/// Validation that judges models.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, Table)]
#[serde(deny_unknown_fields)]
pub struct Validation {
    /// The split that chooses model and features; the strictest there is where none is named: runs, or cycles of one run.
    pub by: Option<SplitKind>,
    /// Time constant of the signals, s: three of them and a window lie between what is learnt and what is tested by time.
    #[field(default = 0.0, within = TIME_CONSTANT)]
    pub time_constant_s: f64,
}

/// Split of the rows into those that are learnt from and those that are tested.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Choice)]
pub enum SplitKind {
    /// A fifth of the rows, drawn at random: the paper's. Neighbours of what is tested are learnt from.
    Random,
    /// Cycles left out.
    Cycle,
    /// Runs left out.
    Run,
    /// Later rows tested on earlier ones, a gap between.
    Time,
    /// Slow, middling or fast cycles left out.
    Frequency,
}

impl Recipe {
    /// Reads a recipe's text; an empty one has all defaults.
    ///
    /// # Errors
    /// Every fault with its place.
    pub fn from_text(text: &str, format: Format) -> Result<Self, Vec<Fault>> {
        Self::from_value(&parse(text, format)?)
    }

    /// Reads a recipe's document.
    ///
    /// # Errors
    /// Every fault with its place.
    pub fn from_value(document: &Value) -> Result<Self, Vec<Fault>> {
        let mut faults = Vec::new();
        let recipe = Self::read(document, "", &(), &mut faults);
        recipe.filter(|_| faults.is_empty()).ok_or(faults)
    }
}

/// Activations that a network's last layer may have.
mod output {
    use document::fields::choice;
    use document::json_schema::Schemas;

    use super::*;

    /// All but the last, softmax, which of one node is 1, whatever its sum.
    fn choices() -> Vec<(&'static str, Activation)> {
        let all = Activation::ALL.into_iter();
        let but_softmax = all.filter(|activation| *activation != Activation::Softmax);
        but_softmax
            .map(|activation| (activation.as_str(), activation))
            .collect()
    }

    pub fn read(value: &Value, at: &str, faults: &mut Vec<Fault>) -> Option<Activation> {
        choice(value, at, &choices(), faults)
    }

    pub fn write(output: &Activation) -> Option<Value> {
        output.write()
    }

    pub fn schema(_: &mut Schemas) -> Value {
        let names: Vec<&str> = choices().iter().map(|choice| choice.0).collect();
        serde_json::json!({"type": "string", "enum": names})
    }
}

fn check_kinds(kinds: &[Kind], fields: &Fields<'_>, faults: &mut Vec<Fault>) {
    each_once(kinds, "kinds", fields, faults);
    let learnt = |kind: &Kind| !matches!(kind, Kind::Mean | Kind::Blend);
    if kinds.contains(&Kind::Blend) && !kinds.iter().any(learnt) {
        let detail = "must name a model beside \"blend\", which is the median of others";
        Fault::add(faults, &fields.at("kinds"), detail);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_empty_recipe_has_all_defaults() {
        assert_eq!(Recipe::from_text("", Format::Toml), Ok(Recipe::default()));
    }

    #[test]
    fn every_field_is_read() {
        let text = r#"
            [columns]
            time = "t"
            signals = ["s*", "extra"]
            forces = "fz"
            threshold_n = 0.5
            [preprocess]
            start_value = "keep"
            turn_sign = true
            rate_hz = 200
            smooth_rows = 3
            outlier_z = 4
            suspect_rows = "leave-out"
            scale = "normalise"
            pause_s = 0.5
            [features]
            sets = ["raw", "baseline"]
            window_rows = 5
            baseline_s = 0.8
            [models]
            kinds = ["gpr", "ann"]
            seed = 7
            [models.gpr]
            lengths = "each"
            line = false
            restarts = 3
            search_rows = 100
            most_rows = 200
            [models.ann]
            layers = [5]
            activation = "softmax"
            output = "elu"
            loss = "poisson"
            decay = 0.1
            iterations = 10
            networks = 2
            [validation]
            by = "time"
            time_constant_s = 0.1
        "#;
        let read = Recipe::from_text(text, Format::Toml).expect("reads");
        assert_eq!(read.columns.cycles, CycleRule::ThresholdN(0.5));
        assert_eq!(read.columns.forces, Some(vec!["fz".to_owned()]));
        assert_eq!(read.preprocess.rate_hz, Some(200.0));
        assert_eq!(read.preprocess.suspect_rows, SuspectRows::LeaveOut);
        assert_eq!(read.features.sets, [FeatureSet::Raw, FeatureSet::Baseline]);
        assert_eq!(read.features.baseline_s(), Some(0.8));
        assert_eq!(read.models.gpr.lengths, Lengths::Each);
        assert_eq!(read.models.ann.layers, [5]);
        assert_eq!(read.models.ann.activation, Activation::Softmax);
        assert_eq!(read.validation.by, Some(SplitKind::Time));
    }

    #[test]
    fn a_blend_needs_others() {
        let text = r#"{"models": {"kinds": ["mean", "blend"]}}"#;
        let faults = Recipe::from_text(text, Format::Json).expect_err("a fault");
        assert_eq!(faults[0].pointer, "/models/kinds");
        assert!(Recipe::from_text(&text.replace("mean", "ann"), Format::Json).is_ok());
    }

    #[test]
    fn all_faults_are_told_with_their_places() {
        let text = r#"{"columns": {"time": 1, "pause_s": 1, "block_s": 2, "signal": "s"}, "preprocess": {"rate_hz": -1, "turn_sign": 1},
            "features": {"sets": []}, "models": {"kinds": ["gpr", "gpr"], "ann": {"output": "softmax", "layers": [0]}}, "validation": {"by": "row"}}"#;
        let faults = Recipe::from_text(text, Format::Json).expect_err("faults");
        let places: Vec<&str> = faults.iter().map(|fault| fault.pointer.as_str()).collect();
        for place in [
            "/columns/signal",
            "/columns/time",
            "/columns",
            "/preprocess/rate_hz",
            "/preprocess/turn_sign",
            "/features/sets",
            "/models/kinds",
            "/models/ann/output",
            "/models/ann/layers/0",
            "/validation/by",
        ] {
            assert!(places.contains(&place), "{place}: {places:?}");
        }
    }
}
