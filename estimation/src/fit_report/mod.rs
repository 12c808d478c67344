//! Report of a fit: what the validation found, for people and programs.

mod beginnings_report;

use serde::{Deserialize, Serialize};

pub use beginnings_report::{BeginningsReport, LoadedReport, RestedReport};

use crate::recipe::{FeatureSet, Kind, SplitKind};
use crate::validation::{BegunErrors, Candidate, Judged, SoundErrors, SplitFigures};

/// A model that isn't this much better than the training mean is useless: its RMSE must be at most this share of the mean's.
pub(crate) const USEFUL_SHARE: f64 = 0.95;
/// Errors that differ by less than this factor are as good as each other: cycles of one run tell them apart no better, and the simpler model is
/// surer beyond them.
const AS_GOOD: f64 = 1.05;

/// The report of a fit.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, utoipa::ToSchema)]
pub struct Report {
    /// Recordings that were learnt from.
    pub recordings: Vec<RecordingFigures>,
    /// Findings for each force.
    pub forces: Vec<ForceReport>,
    /// Promise of the intervals, a sentence.
    pub promise: String,
    /// Notes that a reader should know before believing it, a sentence each.
    pub notes: Vec<String>,
    /// Cost of the fit.
    pub cost: FitCost,
}

/// Figures of a recording.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, utoipa::ToSchema)]
pub struct RecordingFigures {
    /// File of the recording.
    pub file: String,
    /// Count of its rows.
    pub rows: usize,
    /// Rows with at least one force.
    pub labelled: usize,
    /// Count of its cycles.
    pub cycles: usize,
    /// Rows a second, pauses apart.
    pub rate_hz: Option<f64>,
    /// Hash of its text.
    pub sha256: String,
}

/// Findings for a force.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, utoipa::ToSchema)]
pub struct ForceReport {
    /// Column of the force.
    pub force: String,
    /// The model that estimates it; `mean` where nothing is better.
    pub chosen: Kind,
    /// The features it reads.
    pub chosen_features: FeatureSet,
    /// R2 of the chosen model where forces are rolled against signals: what chance would do.
    pub rolled_r2: Option<f64>,
    /// Errors of the chosen model on left-out runs by where they begin; left out where no run was.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub beginnings: Option<BeginningsReport>,
    /// All candidates, the chosen one first, then by their error.
    pub models: Vec<ModelReport>,
}

/// Report of a candidate.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, utoipa::ToSchema)]
pub struct ModelReport {
    /// The model.
    pub model: Kind,
    /// The features it reads.
    pub features: FeatureSet,
    /// The models whose median a blend is; left out of others.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub members: Vec<MemberReport>,
    /// Figures on the split that chooses.
    pub validation: SplitReport,
    /// Figures on every split; null where there is none, the reason in the notes.
    pub splits: SplitReports,
    /// RMSE on the strictest split over that on the random one: how far a random split would have misled.
    pub leak_factor: Option<f64>,
    /// Whether its error is at most 95 % of the training mean's on the split that chooses.
    pub better_than_mean: bool,
}

/// A model that is part of a blend.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize, utoipa::ToSchema)]
pub struct MemberReport {
    /// The model.
    pub model: Kind,
    /// The features it reads.
    pub features: FeatureSet,
}

/// A candidate on every split.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, utoipa::ToSchema)]
pub struct SplitReports {
    /// A fifth of the rows, drawn at random.
    pub random: Option<SplitReport>,
    /// Cycles left out.
    pub cycle: Option<SplitReport>,
    /// Runs left out.
    pub run: Option<SplitReport>,
    /// Later rows on earlier ones.
    pub time: Option<SplitReport>,
    /// Slow, middling or fast cycles left out.
    pub frequency: Option<SplitReport>,
}

/// A candidate on one split.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, utoipa::ToSchema)]
pub struct SplitReport {
    /// The split.
    pub by: SplitKind,
    /// Root of the mean squared error, N.
    pub rmse_n: f64,
    /// RMSE of the tested rows that aren't suspect, which chooses, N; left out where none is suspect.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub sound_rmse_n: Option<f64>,
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
}

/// Cost of a fit.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize, utoipa::ToSchema)]
pub struct FitCost {
    /// Candidates that were judged, of all forces.
    pub candidates: usize,
    /// Wall clock, s.
    pub wall_s: f64,
}

/// Trials of the chosen model beside the splits.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Tried {
    /// R2 where forces are rolled against signals.
    pub rolled_r2: Option<f64>,
    /// Errors by where left-out runs begin.
    pub begun: Option<BegunErrors>,
}

/// The candidates of a force, best first.
#[derive(Debug, Clone, PartialEq)]
pub struct Ranking {
    /// Best first, of the split that chooses; the training mean among them.
    pub judged: Vec<Judged>,
    /// The split that chooses.
    pub by: SplitKind,
}

impl Ranking {
    /// Puts the candidates in order: by their errors, but first, of those that are useful and as good as the best, the blend, or the simplest where none is; the
    /// training mean where none is useful.
    pub fn new(mut judged: Vec<Judged>, by: SplitKind) -> Self {
        let error = |judged: &Judged| judged.choosing_rmse(by);
        judged.sort_by(|a, b| error(a).total_cmp(&error(b)));
        let least = judged.first().map_or(f64::INFINITY, error);
        let useful = |judged: &Judged| {
            judged.candidate.kind != Kind::Mean && judged.on(by).is_some_and(is_useful)
        };
        let any = judged.first().is_some_and(useful);
        let preferred = |judged: &Judged| {
            let Candidate { kind, features } = judged.candidate;
            (kind != Kind::Blend, kind, features)
        };
        let as_good = judged.iter().enumerate().filter(|(_, judged)| match any {
            true => useful(judged) && error(judged) <= least * AS_GOOD,
            false => judged.candidate.kind == Kind::Mean,
        });
        if let Some((place, _)) = as_good.min_by_key(|(_, judged)| preferred(judged)) {
            judged[..=place].rotate_right(1);
        }
        Self { judged, by }
    }

    /// The chosen candidate.
    pub fn chosen(&self) -> Option<&Judged> {
        self.judged.first()
    }

    /// Returns the ranking as it is told.
    pub fn report(&self, force: &str, tried: &Tried) -> Option<ForceReport> {
        let chosen = self.chosen()?.candidate;
        Some(ForceReport {
            force: force.to_owned(),
            chosen: chosen.kind,
            chosen_features: chosen.features,
            rolled_r2: tried.rolled_r2,
            beginnings: tried.begun.as_ref().map(BeginningsReport::from),
            models: self
                .judged
                .iter()
                .filter_map(|judged| model_report(judged, self.by))
                .collect(),
        })
    }

    /// Returns what a reader should know of this force, a sentence each.
    pub fn notes(&self, force: &str) -> Vec<String> {
        let Some(figures) = self.chosen().and_then(|chosen| chosen.on(self.by)) else {
            return Vec::new();
        };
        let mut notes = Vec::new();
        if !is_useful(figures) {
            let best = self
                .judged
                .iter()
                .filter(|judged| judged.candidate.kind != Kind::Mean)
                .find_map(|judged| judged.on(self.by));
            let best = best.map_or(String::new(), |best| {
                format!(": the best model is off by {:.3} N", best.choosing().rmse)
            });
            notes.push(format!(
                "{force}: useless. No model is 5 % better than the training mean, which is off by {:.3} N{best}; the mean is given",
                figures.choosing().mean_rmse
            ));
        }
        if let Some(sound) = figures.sound {
            notes.push(format!(
                "{force}: off by {:.3} N in the tested rows that aren't suspect, which chose the model; the RMSE holds the suspect ones, too",
                sound.rmse
            ));
        }
        if let Some(reasons) = self.chosen().map(|chosen| &chosen.splits) {
            for (kind, figures) in reasons {
                if let Err(reason) = figures {
                    notes.push(format!("{force}: no split by {}: {reason}", kind.as_str()));
                }
            }
        }
        notes
    }
}

fn is_useful(figures: &SplitFigures) -> bool {
    let SoundErrors { rmse, mean_rmse } = figures.choosing();
    rmse <= USEFUL_SHARE * mean_rmse
}

fn model_report(judged: &Judged, by: SplitKind) -> Option<ModelReport> {
    let figures = judged.on(by)?;
    let of_split = |kind: SplitKind| judged.on(kind).map(|figures| split_report(kind, figures));
    let random = judged
        .on(SplitKind::Random)
        .filter(|random| random.choosing().rmse > 0.0);
    let strict = [SplitKind::Run, SplitKind::Cycle]
        .into_iter()
        .find_map(|kind| judged.on(kind));
    Some(ModelReport {
        model: judged.candidate.kind,
        features: judged.candidate.features,
        members: match judged.candidate.kind {
            Kind::Blend => judged.members.iter().map(member_report).collect(),
            _ => Vec::new(),
        },
        validation: split_report(by, figures),
        splits: SplitReports {
            random: of_split(SplitKind::Random),
            cycle: of_split(SplitKind::Cycle),
            run: of_split(SplitKind::Run),
            time: of_split(SplitKind::Time),
            frequency: of_split(SplitKind::Frequency),
        },
        leak_factor: strict
            .zip(random)
            .map(|(strict, random)| strict.choosing().rmse / random.choosing().rmse),
        better_than_mean: judged.candidate.kind != Kind::Mean && is_useful(figures),
    })
}

fn member_report(member: &Candidate) -> MemberReport {
    MemberReport {
        model: member.kind,
        features: member.features,
    }
}

fn split_report(by: SplitKind, figures: &SplitFigures) -> SplitReport {
    SplitReport {
        by,
        rmse_n: figures.rmse,
        sound_rmse_n: figures.sound.map(|sound| sound.rmse),
        rmse_interval_n: figures.rmse_interval,
        nrmse_percent: figures.nrmse_percent,
        mean_nrmse_percent: figures.mean_nrmse_percent,
        r2: figures.r2,
        coverage: figures.intervals.map(|fared| fared.coverage),
        width_n: figures.intervals.map(|fared| fared.width),
    }
}

/// Returns what intervals promise, by the split that chose.
pub fn promise(by: SplitKind) -> String {
    match by {
        SplitKind::Run => "95 % of the rows of another run like these lie within their intervals: the widths are those of runs that were left out",
        SplitKind::Random => "95 % of rows among those that were learnt from lie within their intervals: nothing is promised of other cycles or runs",
        _ => "95 % of the rows of other cycles of the same runs lie within their intervals; of another run nothing is promised, as none was left out: record a second one",
    }
    .to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::validation::{Outcome, Tested};

    /// Candidates with these errors where the training mean's is 1.
    fn ranked(candidates: &[(Kind, FeatureSet, f64)]) -> (Kind, FeatureSet) {
        let judged = |(kind, features, rmse): &(Kind, FeatureSet, f64)| {
            let candidate = Candidate {
                kind: *kind,
                features: *features,
            };
            let figures = SplitFigures {
                rmse: *rmse,
                mean_rmse: 1.0,
                sound: None,
                rmse_interval: None,
                nrmse_percent: None,
                mean_nrmse_percent: None,
                r2: None,
                intervals: None,
            };
            let tested = Tested {
                left_out: Vec::new(),
                means: Vec::new(),
            };
            Judged {
                candidate,
                members: vec![candidate],
                splits: [(SplitKind::Run, Ok(Outcome { figures, tested }))].into(),
            }
        };
        let mean = (Kind::Mean, FeatureSet::Raw, 1.0);
        let judged = candidates.iter().chain([&mean]).map(judged).collect();
        let ranking = Ranking::new(judged, SplitKind::Run);
        let Candidate { kind, features } = ranking.chosen().expect("the mean at least").candidate;
        (kind, features)
    }

    #[test]
    fn a_blend_that_is_as_good_comes_first_then_the_simplest() {
        use FeatureSet::{All, Raw, Slopes};
        let models = [
            (Kind::Ann, All, 0.50),
            (Kind::Gpr, Slopes, 0.51),
            (Kind::Gpr, Raw, 0.524),
            (Kind::Ridge, Raw, 0.53),
        ];
        assert_eq!(ranked(&models), (Kind::Gpr, Raw));
        let with = |error: f64| [&models[..], &[(Kind::Blend, All, error)]].concat();
        assert_eq!(ranked(&with(0.52)), (Kind::Blend, All));
        assert_eq!(ranked(&with(0.53)), (Kind::Gpr, Raw));
    }

    #[test]
    fn what_is_useless_is_not_chosen_for_being_as_good() {
        let models = [
            (Kind::Gpr, FeatureSet::Raw, 0.94),
            (Kind::Ridge, FeatureSet::Raw, 0.96),
        ];
        assert_eq!(ranked(&models), (Kind::Gpr, FeatureSet::Raw));
        assert_eq!(ranked(&models[1..]), (Kind::Mean, FeatureSet::Raw));
    }
}
