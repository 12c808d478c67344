//! What is to be done with recordings: which columns, which preprocessing, features and models, which split judges.
//!
//! Every field has a default, so that a recipe may be empty.

use serde::{Deserialize, Serialize};

/// The whole recipe.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Recipe {
    /// Which columns are meant.
    pub columns: Columns,
    /// What is done with signals before anything is learnt.
    pub preprocess: Preprocess,
    /// What models are given of the signals.
    pub features: Features,
    /// Which models are tried, and how.
    pub models: Models,
    /// What judges them.
    pub validation: Validation,
}

/// Which columns are meant; patterns have `*` and `?`.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Columns {
    /// Seconds; `time_s` or else the first column where none is named.
    pub time: Option<String>,
    /// Signals; all other columns where none are named.
    pub signals: Option<Vec<String>>,
    /// Forces, N; `fx_n`, `fy_n`, `fz_n` or the like where none are named.
    pub forces: Option<Vec<String>>,
    /// What a cycle is.
    pub cycles: CycleRule,
}

/// What a cycle is: a press, a stroke, a stance.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub enum CycleRule {
    /// Rows with the same entry of this column, one after another.
    Column(String),
    /// Rows between pauses longer than this, s.
    PauseS(f64),
    /// From one rise of the total force above this threshold to the next, N.
    ThresholdN(f64),
    /// Pieces of this length, s.
    BlockS(f64),
    /// Ten pieces a run, of equal length in time.
    #[default]
    Tenths,
}

/// What is done with signals, in this order.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Preprocess {
    /// Whether each run's first reading is taken off.
    pub start_value: StartValue,
    /// Whether the sign of signals is turned.
    pub turn_sign: bool,
    /// The clock that signals and forces are interpolated to, Hz; none leaves rows as they are.
    pub rate_hz: Option<f64>,
    /// Rows of the moving average; 1 for none.
    pub smooth_rows: usize,
    /// Rows with a signal further than so many standard deviations from its mean aren't learnt from; none keeps all.
    pub outlier_z: Option<f64>,
    /// How features are brought to one scale.
    pub scale: Scale,
    /// A longer time between rows is a pause, s; none for ten typical intervals. Nothing is carried over a pause.
    pub pause_s: Option<f64>,
}

impl Default for Preprocess {
    fn default() -> Self {
        Self {
            start_value: StartValue::Auto,
            turn_sign: false,
            rate_hz: None,
            smooth_rows: 1,
            outlier_z: None,
            scale: Scale::Standardise,
            pause_s: None,
        }
    }
}

/// Whether each run's first reading is taken off.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum StartValue {
    /// Whichever knows left-out runs better; with one run, whether it begins unloaded.
    #[default]
    Auto,
    /// Always: runs begin unloaded.
    Subtract,
    /// Never.
    Keep,
}

/// How features are brought to one scale, learnt from training rows.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Scale {
    /// Mean 0, standard deviation 1.
    #[default]
    Standardise,
    /// From 0 to 1.
    Normalise,
    /// As they are.
    Off,
}

/// What models are given of the signals.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Features {
    /// The sets that are tried.
    pub sets: Vec<FeatureSet>,
    /// Rows of the rolling mean and variance.
    pub window_rows: usize,
}

impl Default for Features {
    fn default() -> Self {
        Self {
            sets: FeatureSet::ALL.to_vec(),
            window_rows: 10,
        }
    }
}

/// A set of features (the ablations of the paper's tables 4 and 5), in the order of their sizes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
#[serde(rename_all = "kebab-case")]
pub enum FeatureSet {
    /// The signals.
    Raw,
    /// Signals and their slopes.
    Slopes,
    /// Signals, their rolling means and variances.
    Rolling,
    /// All of them.
    All,
}

impl FeatureSet {
    /// All sets, the smallest first.
    pub const ALL: [Self; 4] = [Self::Raw, Self::Slopes, Self::Rolling, Self::All];

    /// Its name in documents.
    pub fn as_str(self) -> &'static str {
        match self {
            Self::Raw => "raw",
            Self::Slopes => "slopes",
            Self::Rolling => "rolling",
            Self::All => "all",
        }
    }

    /// The smallest set that holds both.
    pub fn with(self, other: Self) -> Self {
        match (self, other) {
            (Self::Slopes, Self::Rolling) | (Self::Rolling, Self::Slopes) => Self::All,
            _ => self.max(other),
        }
    }
}

/// Which models are tried, and how each is learnt.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Models {
    /// The kinds that are tried, beside the training mean, which always is.
    pub kinds: Vec<Kind>,
    /// Gaussian processes.
    pub gpr: GprSettings,
    /// Neural networks.
    pub ann: AnnSettings,
    /// Of all that is drawn at random.
    pub seed: u64,
}

impl Default for Models {
    fn default() -> Self {
        Self {
            kinds: vec![Kind::Ridge, Kind::Gpr, Kind::Ann, Kind::Blend],
            gpr: GprSettings::default(),
            ann: AnnSettings::default(),
            seed: 1,
        }
    }
}

/// A kind of model, the simplest first.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
#[serde(rename_all = "kebab-case")]
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

impl Kind {
    /// All kinds.
    pub const ALL: [Self; 5] = [Self::Mean, Self::Ridge, Self::Gpr, Self::Ann, Self::Blend];

    /// Its name in documents.
    pub fn as_str(self) -> &'static str {
        match self {
            Self::Mean => "mean",
            Self::Ridge => "ridge",
            Self::Gpr => "gpr",
            Self::Ann => "ann",
            Self::Blend => "blend",
        }
    }
}

/// How a Gaussian process is learnt.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct GprSettings {
    /// Length scales: one, or one for each feature.
    pub lengths: Lengths,
    /// Whether a line in the features is added, as heavy as the rows make it: beyond what was learnt from, it goes on where the squared exponential falls
    /// back to the mean.
    pub line: bool,
    /// Starts of the search for hyperparameters, drawn at random.
    pub restarts: usize,
    /// Rows from which the hyperparameters are learnt, an even subset.
    pub search_rows: usize,
    /// Rows that the process is conditioned on, an even subset.
    pub most_rows: usize,
}

impl Default for GprSettings {
    fn default() -> Self {
        Self {
            lengths: Lengths::Shared,
            line: true,
            restarts: 50,
            search_rows: 600,
            most_rows: 3000,
        }
    }
}

/// Length scales of a Gaussian process.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Lengths {
    /// One for all features.
    #[default]
    Shared,
    /// One for each feature.
    Each,
}

/// How a neural network is learnt.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct AnnSettings {
    /// Nodes of each hidden layer.
    pub layers: Vec<usize>,
    /// Of hidden layers.
    pub activation: Activation,
    /// Of the last layer.
    pub output: Activation,
    /// What is made small.
    pub loss: Loss,
    /// Weight of the squared weights in the loss.
    pub decay: f64,
    /// Most iterations.
    pub iterations: usize,
    /// Networks whose mean is the estimate, each from weights of its own.
    pub networks: usize,
}

impl Default for AnnSettings {
    fn default() -> Self {
        Self {
            layers: vec![24, 12],
            activation: Activation::Tanh,
            output: Activation::Linear,
            loss: Loss::Mse,
            decay: 1e-3,
            iterations: 300,
            networks: 3,
        }
    }
}

/// What a node makes of its sum.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
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

/// What training makes small.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Loss {
    /// Half the mean squared error.
    Mse,
    /// Poisson's negative log likelihood, exp(z) - y z: for forces that are never negative.
    Poisson,
}

/// What judges.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Validation {
    /// The split that chooses model and features; the strictest there is where none is named: runs, or cycles of one run.
    pub by: Option<SplitKind>,
    /// Time constant of the signals, s: three of them and a window lie between what is learnt and what is tested by time.
    pub time_constant_s: f64,
}

/// How rows are divided into those that are learnt from and those that are tested.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
#[serde(rename_all = "kebab-case")]
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

impl SplitKind {
    /// All splits.
    pub const ALL: [Self; 5] = [
        Self::Random,
        Self::Cycle,
        Self::Run,
        Self::Time,
        Self::Frequency,
    ];

    /// Its name in documents.
    pub fn as_str(self) -> &'static str {
        match self {
            Self::Random => "random",
            Self::Cycle => "cycle",
            Self::Run => "run",
            Self::Time => "time",
            Self::Frequency => "frequency",
        }
    }
}
