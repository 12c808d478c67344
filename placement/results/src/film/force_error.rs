//! Errors of a force of the ground by a layout's films.

use estimation::error_metrics::{nrmse_percent, r2, rmse};
use estimation::recipe::{FeatureSet, Kind, SplitKind};
use estimation::validation::SplitFigures;
use serde::{Deserialize, Serialize};

/// Error of one force by a layout's films, with an estimator that is learnt from runs of a virtual rig.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, utoipa::ToSchema)]
pub struct ForceError {
    /// `fx`: along the wheel, `fy`: across it, `fz`: vertical.
    pub axis: String,
    /// The model that is chosen by left-out runs; `mean` where none is better than the training mean.
    pub chosen: Kind,
    /// The features it reads.
    pub features: FeatureSet,
    /// Whether its error on left-out runs is at most 95 % of the training mean's.
    pub useful: bool,
    /// The chosen model by random rows, by later rows, and by whole runs (cycles where there is one run).
    pub splits: Vec<SplitError>,
    /// Error on left-out runs over that on random rows, both as shares of the training mean's error on the same rows: how far a random split would have misled.
    /// Null of the training mean.
    pub leak: Option<f64>,
    /// Error on runs that nobody learnt from: films have other gains there.
    pub fresh: TrialError,
    /// Error there of the rows with a contact alone.
    #[serde(default)]
    pub in_contact: TrialError,
    /// Errors there where readings drift otherwise, learnt anew with each drift.
    #[serde(skip_serializing_if = "Vec::is_empty", default)]
    pub drift: Vec<DriftError>,
    /// Error on an upright wheel over flat ground at the scene's pressure, learnt anew; absent where all contacts are such.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub alike: Option<AlikeError>,
    /// Error there with the one film dead whose loss costs most; null where the training mean is given, which reads no film.
    pub dead: Option<DeadFilmError>,
    /// Error there with films that lie elsewhere than those that were learnt from.
    pub askew: AskewError,
    /// Errors of these films on other tires.
    #[serde(skip_serializing_if = "Vec::is_empty", default)]
    pub elsewhere: Vec<ElsewhereError>,
    /// Place on the wheel where contacts are known worst; null where too few touch.
    pub worst_contact: Option<WorstContact>,
    /// Estimate of the least root of the mean squared error that one instant's readings allow, N: the bound of Cramer and Rao with what is known of the gait
    /// before, for films that hold their charge.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub floor_n: Option<f64>,
    /// Reason why numbers are null.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub reason: Option<String>,
}

/// The chosen model on rows that were left out by one split.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, utoipa::ToSchema)]
pub struct SplitError {
    /// The split: `random` readings of the begin of one run, whose neighbours are learnt from; later `time`; whole `run`s or `cycle`s.
    pub by: SplitKind,
    /// Root of the mean squared error, N.
    pub rmse_n: Option<f64>,
    /// 95 % of the bootstrap's samples of whole cycles, N.
    pub rmse_interval_n: Option<(f64, f64)>,
    /// RMSE over the range of the tested forces, %.
    pub nrmse_percent: Option<f64>,
    /// NRMSE of the training mean, %.
    pub mean_nrmse_percent: Option<f64>,
    /// Coefficient of determination.
    pub r2: Option<f64>,
    /// Share of tested rows within their 95 % intervals, whose width was learnt from other groups.
    pub coverage: Option<f64>,
    /// Mean width of these intervals, N.
    pub width_n: Option<f64>,
    /// Reason why numbers are null.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub reason: Option<String>,
}

impl SplitError {
    /// Figures of a split, or why there are none; those that aren't finite are null.
    pub fn of(by: SplitKind, figures: Result<&SplitFigures, &str>) -> Self {
        let known = figures.ok();
        let number = |of: fn(&SplitFigures) -> Option<f64>| {
            known.and_then(of).filter(|x: &f64| x.is_finite())
        };
        let interval = known.and_then(|figures| figures.rmse_interval);
        Self {
            by,
            rmse_n: number(|figures| Some(figures.rmse)),
            rmse_interval_n: interval.filter(|(low, high)| low.is_finite() && high.is_finite()),
            nrmse_percent: number(|figures| figures.nrmse_percent),
            mean_nrmse_percent: number(|figures| figures.mean_nrmse_percent),
            r2: number(|figures| figures.r2),
            coverage: number(|figures| figures.intervals.map(|fared| fared.coverage)),
            width_n: number(|figures| figures.intervals.map(|fared| fared.width)),
            reason: figures.err().map(str::to_owned),
        }
    }
}

/// Estimates against true forces on runs that nobody learnt from, rows in the air among them.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize, utoipa::ToSchema)]
pub struct TrialError {
    /// Root of the mean squared error, N.
    pub rmse_n: Option<f64>,
    /// RMSE over the range of the true forces, %; null where these don't vary.
    pub nrmse_percent: Option<f64>,
    /// Coefficient of determination; null where the true forces don't vary.
    pub r2: Option<f64>,
    /// Share of the true forces within their 95 % intervals.
    pub coverage: Option<f64>,
    /// Share of the rows that are flagged: one of their signals is beyond what was learnt from.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub outside: Option<f64>,
}

impl ForceError {
    /// Least and greatest error by the drift of the readings, its own among them, N; `None` where no other was tried.
    pub fn range_by_drift_n(&self) -> Option<(f64, f64)> {
        let drifts = self.drift.iter().filter_map(|drift| drift.error.rmse_n);
        let own = self.fresh.rmse_n?;
        drifts.fold(None, |range, error| {
            let (low, high) = range.unwrap_or((own, own));
            Some((f64::min(low, error), f64::max(high, error)))
        })
    }
}

impl TrialError {
    /// Errors of estimates, one for each true force, N, with the shares of rows whose interval holds the truth and that are flagged.
    pub fn of(truth_n: &[f64], estimates_n: &[f64], covered: f64, flagged: f64) -> Self {
        let error = rmse(truth_n, estimates_n);
        let finite = |x: &f64| x.is_finite();
        Self {
            rmse_n: Some(error).filter(finite),
            nrmse_percent: nrmse_percent(truth_n, error).filter(finite),
            r2: r2(truth_n, estimates_n).filter(finite),
            coverage: Some(covered),
            outside: Some(flagged),
        }
    }
}

/// Error with another drift of the readings.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, utoipa::ToSchema)]
pub struct DriftError {
    /// The drift in words, as a share of a film's full scale.
    pub drift: String,
    /// Error of the estimates then.
    pub error: TrialError,
    /// Error of the rows with a contact alone.
    pub in_contact: TrialError,
}

/// Error where contacts differ in angle, load and shear alone.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, utoipa::ToSchema)]
pub struct AlikeError {
    /// Error of the estimates then.
    pub error: TrialError,
    /// Error of the rows with a contact alone.
    pub in_contact: TrialError,
}

/// Error with a film dead.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, utoipa::ToSchema)]
pub struct DeadFilmError {
    /// The film, counted from 0.
    pub film: usize,
    /// Error of the estimates without it.
    pub error: TrialError,
}

/// Error on another tire.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, utoipa::ToSchema)]
pub struct ElsewhereError {
    /// Difference from the study's tire, in words.
    pub tire: String,
    /// Whether estimators learnt from runs on it, too.
    pub learnt: bool,
    /// Error of the estimates there.
    pub error: TrialError,
}

/// Error with films askew.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize, utoipa::ToSchema)]
pub struct AskewError {
    /// Standard deviation of the films' places around the wheel, degrees.
    pub std_deg: f64,
    /// Error of the estimates then.
    pub error: TrialError,
}

/// Contacts about one wheel angle.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, utoipa::ToSchema)]
pub struct WorstContact {
    /// Middle of five degrees of the wheel.
    pub deg: f64,
    /// Root of the mean squared error of rows with a contact there, N.
    pub rmse_n: f64,
}

#[cfg(test)]
mod tests {
    use super::*;

    fn off_by(rmse_n: f64) -> TrialError {
        TrialError {
            rmse_n: Some(rmse_n),
            ..TrialError::default()
        }
    }

    #[test]
    fn the_range_by_drift_holds_the_rigs_own() {
        let with = |own: f64, others: &[f64]| {
            let drift = others.iter().map(|rmse_n| DriftError {
                drift: String::new(),
                error: off_by(*rmse_n),
                in_contact: TrialError::default(),
            });
            let error = ForceError {
                axis: "fz".to_owned(),
                chosen: Kind::Ridge,
                features: FeatureSet::Raw,
                useful: true,
                splits: Vec::new(),
                leak: None,
                fresh: off_by(own),
                in_contact: TrialError::default(),
                drift: drift.collect(),
                alike: None,
                dead: None,
                askew: AskewError::default(),
                elsewhere: Vec::new(),
                worst_contact: None,
                floor_n: None,
                reason: None,
            };
            error.range_by_drift_n()
        };
        assert_eq!(with(1.0, &[0.5, 3.0]), Some((0.5, 3.0)));
        assert_eq!(with(4.0, &[0.5, 3.0]), Some((0.5, 4.0)));
        assert_eq!(with(1.0, &[]), None);
    }
}
