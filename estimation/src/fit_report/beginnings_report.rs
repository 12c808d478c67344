//! Errors of left-out runs by where they begin, as a report tells them.

use serde::{Deserialize, Serialize};

use crate::validation::{BegunError, BegunErrors};

/// Errors of left-out runs by where they begin.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, utoipa::ToSchema)]
pub struct BeginningsReport {
    /// Runs that begin under a load, which is taken for nothing where the first reading is taken off.
    pub loaded: Vec<LoadedReport>,
    /// Runs that are zeroed after lifting.
    pub rested: Vec<RestedReport>,
    /// Least rest after which the error is at most 1.2 times that of the same rows as recorded, s; null where no recorded rest is long enough.
    pub rest_s: Option<f64>,
    /// Sentences that follow from it: when to zero, and what a begin under load does.
    pub advice: String,
}

/// Left-out runs that begin under a load.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, utoipa::ToSchema)]
pub struct LoadedReport {
    /// Share of the run's largest force.
    pub share: f64,
    /// Mean load at the beginning, N.
    pub load_n: f64,
    /// N
    pub rmse_n: f64,
    /// RMSE of the same rows of the runs as recorded, N.
    pub recorded_rmse_n: f64,
}

/// Left-out runs that are zeroed after lifting.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, utoipa::ToSchema)]
pub struct RestedReport {
    /// Rest between lifting and zero, s.
    pub rest_s: f64,
    /// Number of liftings that were followed by such a rest.
    pub liftings: usize,
    /// N
    pub rmse_n: f64,
    /// RMSE of the same rows of the runs as recorded, N.
    pub recorded_rmse_n: f64,
}

impl From<&BegunErrors> for BeginningsReport {
    fn from(errors: &BegunErrors) -> Self {
        let loaded = |(share, load_n, error): &(f64, f64, BegunError)| LoadedReport {
            share: *share,
            load_n: *load_n,
            rmse_n: error.rmse,
            recorded_rmse_n: error.recorded,
        };
        let rested = |(rest_s, error): &(f64, BegunError)| RestedReport {
            rest_s: *rest_s,
            liftings: error.beginnings,
            rmse_n: error.rmse,
            recorded_rmse_n: error.recorded,
        };
        Self {
            loaded: errors.loaded.iter().map(loaded).collect(),
            rested: errors.rested.iter().map(rested).collect(),
            rest_s: errors.rest_s(),
            advice: format!("{} {}", zero_advice(errors), begin_advice(errors)),
        }
    }
}

/// Sentence on when a zero holds.
fn zero_advice(errors: &BegunErrors) -> String {
    let longest = errors.rested.last().map(|(rest_s, _)| *rest_s);
    match (errors.rest_s(), longest) {
        (Some(0.0), _) => "A zero holds as soon as no force acts.".to_owned(),
        (Some(rest_s), _) => format!("A zero holds once {rest_s} s have passed after lifting."),
        (None, Some(longest)) => format!(
            "No zero holds within {longest} s after lifting, the longest rest recorded; start_rows takes the median of more readings."
        ),
        (None, None) => {
            "No force was lifted in a run, so that nothing is known of a zero.".to_owned()
        }
    }
}

/// Sentence on what a begin under load does.
fn begin_advice(errors: &BegunErrors) -> &'static str {
    let bears = |(_, _, error): &(f64, f64, BegunError)| {
        error.rmse <= BegunErrors::AS_GOOD * error.recorded
    };
    match errors.loaded.iter().all(bears) {
        true => "A begin under load costs nothing, as first readings are kept.",
        false => "A load under which a run begins is taken for nothing.",
    }
}
