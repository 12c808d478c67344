//! Features that models are given of the signals, and the sets that are tried.

// What users write is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

use document::fault::Fault;
use document::fields::{Fields, Range};
use document::typed::lists::Entries;
use document::{Choice, Table};
use serde::{Deserialize, Serialize};

use super::field_rules::{MOST_WINDOW, each_once};

/// Seconds of a baseline's median where a recipe says none: several strides of a walk.
pub const USUAL_BASELINE_S: f64 = 1.5;
/// Most seconds of a baseline: memory and time of a row grow with them.
pub(crate) const MOST_BASELINE_S: f64 = 60.0;
const BASELINE_S: Range = Range::new(0.01, MOST_BASELINE_S, "s");

/// Features that models are given of the signals.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, Table)]
#[table(rule = check_sets(sets))]
#[serde(deny_unknown_fields)]
pub struct Features {
    /// The sets that are tried.
    #[field(default = FeatureSet::PUBLISHED.to_vec(), within = Entries::of(1, FeatureSet::ALL.len(), "entries", ()))]
    pub sets: Vec<FeatureSet>,
    /// Rows of the rolling mean and variance.
    #[field(default = 10, within = (2, MOST_WINDOW))]
    pub window_rows: usize,
    /// Seconds of the median that is a signal's baseline.
    #[field(default = USUAL_BASELINE_S, within = BASELINE_S)]
    #[serde(default = "usual_baseline_s")]
    pub baseline_s: f64,
}

/// A set of features, in the order of their sizes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Choice)]
pub enum FeatureSet {
    /// The signals.
    Raw,
    /// Signals over their baselines, the medians of the last seconds.
    Baseline,
    /// Signals and their slopes.
    Slopes,
    /// Signals, their rolling means and variances.
    Rolling,
    /// Signals, their slopes, rolling means and variances.
    All,
    /// Signals, slopes, means and variances, and signals over their baselines.
    Whole,
}

impl Features {
    /// Seconds of the baseline; `None` where no set reads what is over it.
    pub fn baseline_s(&self) -> Option<f64> {
        let is_read = self.sets.iter().any(|set| set.reads_baseline());
        is_read.then_some(self.baseline_s)
    }
}

impl FeatureSet {
    /// The sets of the paper's tables 4 and 5.
    pub const PUBLISHED: [Self; 4] = [Self::Raw, Self::Slopes, Self::Rolling, Self::All];

    /// Whether it holds signals over their baselines.
    fn reads_baseline(self) -> bool {
        matches!(self, Self::Baseline | Self::Whole)
    }

    /// The smallest set that holds both.
    pub fn with(self, other: Self) -> Self {
        match (self, other) {
            (Self::Baseline, other) | (other, Self::Baseline) if other != Self::Baseline => {
                Self::Whole
            }
            (Self::Slopes, Self::Rolling) | (Self::Rolling, Self::Slopes) => Self::All,
            _ => self.max(other),
        }
    }
}

fn usual_baseline_s() -> f64 {
    USUAL_BASELINE_S
}

fn check_sets(sets: &[FeatureSet], fields: &Fields<'_>, faults: &mut Vec<Fault>) {
    each_once(sets, "sets", fields, faults);
}
