//! The rig's figures for the rows of the published tables: a recording of each gait, learnt from and tested as the study says, and tried on a run with other gains.

use std::sync::atomic::{AtomicBool, Ordering};

use estimation::error_metrics::{nrmse_percent, r2, rmse};
use estimation::model::contract::Effort;
use estimation::recipe::{FeatureSet, Kind, Recipe, SplitKind};
use estimation::rows::LabelledRows;
use estimation::split::Fold;
use estimation::validation::{Candidate, LearntModel, Splits};

use crate::result::{PublishedRow, RigFigures, TimeConstantRow};
use crate::rig::contact_response::{ContactResponse, TurnableFilms};
use crate::rig::force_error::layout_forces::force_errors;
use crate::rig::force_error::learnt_force::{labelled, recipe};
use crate::rig::force_error::thinned_run::ThinnedRun;
use crate::rig::published::printed_figures::{AXES, HIGH, LOW, TRANSITION};
use crate::rig::published::published_gaits::{PublishedGait, RANDOMISED, RATE_HZ};
use crate::rig::published::published_rows::published_rows;
use crate::rig::rig_settings::RigSettings;

/// Time constants of the circuit that are tried, s.
const TIME_CONSTANTS_S: [f64; 4] = [0.01, 0.1, 1.0, 10.0];
/// Runs are counted from here: those that layouts are judged by come before.
const FIRST_RUN: u64 = 1_000_000;
/// Of a run that is only tried, one of so many readings is.
const TRIED_ONE_OF: usize = 6;
/// Readings that a process is conditioned on.
const PROCESS_ROWS: usize = 1500;

/// A recording that models learn from, and those with other gains that they are tried on, by the gait of the rows.
struct Recording {
    learnt: ThinnedRun,
    tried: Vec<(&'static str, ThinnedRun)>,
}

/// Everything that is recorded for the tables, with one layout's films.
pub struct RigTables<'r, R> {
    response: &'r R,
    rig: &'r RigSettings,
    recordings: Vec<Recording>,
    recipe: Recipe,
    rows: Vec<PublishedRow>,
    /// Rows of the same model, by their numbers.
    models: Vec<Vec<usize>>,
}

/// What one piece of work found.
pub enum Piece {
    /// Rows with the rig's figures, by their numbers.
    Rows(Vec<(usize, PublishedRow)>),
    /// Forces with another time constant.
    TimeConstant(Vec<TimeConstantRow>),
}

impl<'r, R: TurnableFilms> RigTables<'r, R> {
    /// Records; None where the caller stops meanwhile.
    pub fn recorded(response: &'r R, rig: &'r RigSettings, stop: &AtomicBool) -> Option<Self> {
        let mut run = FIRST_RUN;
        let mut record = |gait: PublishedGait, one_of: usize| {
            run += 1;
            let settings = gait.on(rig);
            let stopped = stop.load(Ordering::Relaxed);
            (!stopped).then(|| ThinnedRun::recorded(response, &settings, run, one_of).touching())
        };
        let mut recordings = Vec::new();
        for (gait, others) in gaits() {
            recordings.push(Recording {
                learnt: record(gait, 1)?,
                tried: others
                    .into_iter()
                    .map(|(name, gait)| Some((name, record(gait, TRIED_ONE_OF)?)))
                    .collect::<Option<_>>()?,
            });
        }
        let rows = published_rows();
        let mut models: Vec<Vec<usize>> = Vec::new();
        for (number, row) in rows.iter().enumerate() {
            let same = |other: &PublishedRow| {
                recording(&recordings, &other.gait) == recording(&recordings, &row.gait)
                    && (other.model, other.features, &other.axis)
                        == (row.model, row.features, &row.axis)
            };
            match models.iter_mut().find(|numbers| same(&rows[numbers[0]])) {
                Some(numbers) => numbers.push(number),
                None => models.push(vec![number]),
            }
        }
        Some(Self {
            response,
            rig,
            recordings,
            recipe: published_recipe(response, rig),
            rows,
            models,
        })
    }

    /// How many pieces of work there are.
    pub fn pieces(&self) -> usize {
        TIME_CONSTANTS_S.len() + self.models.len()
    }

    /// One of them; None where the caller stops meanwhile. Each depends on nothing but its number.
    pub fn piece(&self, number: usize, stop: &AtomicBool) -> Option<Piece> {
        match TIME_CONSTANTS_S.get(number) {
            Some(time_constant_s) => self.with_time_constant(*time_constant_s, stop),
            None => {
                let rows = &self.models[number - TIME_CONSTANTS_S.len()];
                Some(Piece::Rows(self.learnt(rows)))
            }
        }
    }

    /// All rows, in the order of the tables, and those of the time constants.
    pub fn tables(&self, pieces: Vec<Piece>) -> (Vec<PublishedRow>, Vec<TimeConstantRow>) {
        let (mut rows, mut time_constants) = (self.rows.clone(), Vec::new());
        for piece in pieces {
            match piece {
                Piece::Rows(found) => found
                    .into_iter()
                    .for_each(|(number, row)| rows[number] = row),
                Piece::TimeConstant(found) => time_constants.extend(found),
            }
        }
        (rows, time_constants)
    }

    fn with_time_constant(&self, time_constant_s: f64, stop: &AtomicBool) -> Option<Piece> {
        let mut rig = self.rig.clone();
        rig.electronics.time_constant_s = Some(time_constant_s);
        let errors = force_errors(self.response, &[], &rig, stop)?;
        let row = |error: crate::result::ForceError| TimeConstantRow {
            time_constant_s,
            axis: error.axis,
            chosen: error.chosen,
            error: error.fresh,
        };
        Some(Piece::TimeConstant(errors.into_iter().map(row).collect()))
    }

    /// The rows of one model.
    fn learnt(&self, numbers: &[usize]) -> Vec<(usize, PublishedRow)> {
        let rows = numbers.iter().map(|number| self.rows[*number].clone());
        let mut rows: Vec<PublishedRow> = rows.collect();
        if let Err(reason) = self.fill(&mut rows) {
            for row in &mut rows {
                row.reason.get_or_insert_with(|| reason.clone());
            }
        }
        numbers.iter().copied().zip(rows).collect()
    }

    /// Fills in the rig's figures of one model.
    ///
    /// # Errors
    /// Why it isn't learnt.
    fn fill(&self, rows: &mut [PublishedRow]) -> Result<(), String> {
        let first = &rows[0];
        let recording = &self.recordings[recording(&self.recordings, &first.gait)];
        let axis = AXES
            .iter()
            .position(|axis| *axis == first.axis)
            .unwrap_or(0);
        let labelled = |run: &ThinnedRun| labelled(std::slice::from_ref(run), axis);
        let model = Model {
            candidate: Candidate {
                kind: first.model,
                features: first.features,
            },
            recipe: &self.recipe,
            rows: labelled(&recording.learnt),
        };
        let splits = Splits::new(&model.rows, &self.recipe, RATE_HZ.recip());
        let folds = |by: SplitKind| match splits.folds.get(&by) {
            Some(folds) => folds.clone(),
            None => Err("the split wasn't made".to_owned()),
        };
        let all: Vec<usize> = (0..model.rows.forces.len()).collect();
        // Table 6 learns from a whole recording; all others leave a random fifth out.
        let fold = match first.by {
            SplitKind::Run => Fold {
                train: all,
                test: Vec::new(),
            },
            _ => folds(SplitKind::Random)?.swap_remove(0),
        };
        let learnt = model.learn(&fold.train)?;
        for row in rows {
            let tried = recording.tried.iter().find(|(name, _)| *name == row.gait);
            let fresh = tried.and_then(|(_, run)| {
                let run = labelled(run);
                learnt.tested(&run, 0..run.forces.len()).figures()
            });
            let of_time = |folds: &[Fold]| model.on_folds(folds);
            (row.rig, row.fresh) = match row.by {
                SplitKind::Run => (fresh, None),
                SplitKind::Time => (of_time(&folds(SplitKind::Time)?)?, fresh),
                _ => {
                    let tested = learnt.tested(&model.rows, fold.test.iter().copied());
                    (tested.figures(), fresh)
                }
            };
        }
        Ok(())
    }
}

/// What is recorded: a gait that is learnt from, and the rows' gaits that its models are tried on.
fn gaits() -> Vec<(PublishedGait, Vec<(&'static str, PublishedGait)>)> {
    let fixed = [("1 Hz", 1.0), ("2 Hz", 2.0), ("5 Hz", 5.0)];
    let mut gaits = vec![
        (
            PublishedGait::ABLATION,
            vec![(RANDOMISED, PublishedGait::ABLATION)],
        ),
        (
            PublishedGait::LEARNT,
            fixed
                .map(|(name, hz)| (name, PublishedGait::fixed(hz)))
                .to_vec(),
        ),
    ];
    let named = |name| Some((PublishedGait::named(name)?, name));
    let named = [LOW, HIGH, TRANSITION].into_iter().filter_map(named);
    gaits.extend(named.map(|(gait, name)| (gait, vec![(name, gait)])));
    gaits
}

/// Number of the recording that a row's gait is tried by.
fn recording(recordings: &[Recording], gait: &str) -> usize {
    let has = |recording: &Recording| recording.tried.iter().any(|(name, _)| *name == gait);
    recordings.iter().position(has).unwrap_or(0)
}

fn published_recipe<R: ContactResponse>(response: &R, rig: &RigSettings) -> Recipe {
    let mut recipe = recipe(response, rig);
    recipe.features.sets = FeatureSet::ALL.to_vec();
    recipe.models.kinds = vec![Kind::Gpr, Kind::Ann];
    recipe.models.gpr.most_rows = PROCESS_ROWS;
    recipe
}

/// A model of one force that is to be learnt from a recording.
struct Model<'r> {
    candidate: Candidate,
    recipe: &'r Recipe,
    rows: LabelledRows,
}

/// A model that was learnt, beside the mean of the forces it learnt from.
struct Learnt {
    learner: LearntModel,
    mean_n: f64,
}

impl Model<'_> {
    fn learn(&self, train: &[usize]) -> Result<Learnt, String> {
        if train.is_empty() {
            return Err("nothing touched in its recording".to_owned());
        }
        let learner = LearntModel::learn(
            self.candidate,
            &self.rows,
            train,
            self.recipe,
            Effort::Whole,
        );
        let sum: f64 = train.iter().map(|row| self.rows.forces[*row]).sum();
        Ok(Learnt {
            learner: learner.map_err(|error| error.to_string())?,
            mean_n: sum / train.len() as f64,
        })
    }

    /// On what each fold leaves out.
    fn on_folds(&self, folds: &[Fold]) -> Result<Option<RigFigures>, String> {
        let mut all = TestedRows::default();
        for fold in folds {
            let learnt = self.learn(&fold.train)?;
            all.append(learnt.tested(&self.rows, fold.test.iter().copied()));
        }
        Ok(all.figures())
    }
}

impl Learnt {
    fn tested(&self, rows: &LabelledRows, tested: impl Iterator<Item = usize>) -> TestedRows {
        let mut all = TestedRows::default();
        for row in tested {
            let features = rows.features.row(row).to_vec();
            all.truth.push(rows.forces[row]);
            all.estimate.push(self.learner.predict(&features).mean);
            all.mean.push(self.mean_n);
        }
        all
    }
}

/// Forces that were measured, with what was said of them.
#[derive(Default)]
struct TestedRows {
    truth: Vec<f64>,
    estimate: Vec<f64>,
    mean: Vec<f64>,
}

impl TestedRows {
    fn append(&mut self, other: Self) {
        self.truth.extend(other.truth);
        self.estimate.extend(other.estimate);
        self.mean.extend(other.mean);
    }

    /// None without rows.
    fn figures(&self) -> Option<RigFigures> {
        let percent = |rmse| nrmse_percent(&self.truth, rmse).filter(|x| x.is_finite());
        let rmse_n = rmse(&self.truth, &self.estimate);
        rmse_n.is_finite().then(|| RigFigures {
            rmse_n,
            nrmse_percent: percent(rmse_n),
            mean_nrmse_percent: percent(rmse(&self.truth, &self.mean)),
            r2: r2(&self.truth, &self.estimate).filter(|x| x.is_finite()),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::rig::bump_response::BumpResponse;

    static GO_ON: AtomicBool = AtomicBool::new(false);

    fn piece_of(
        tables: &RigTables<'_, BumpResponse>,
        table: u32,
        axis: &str,
        model: Kind,
    ) -> usize {
        let is_it = |numbers: &Vec<usize>| {
            let row = &tables.rows[numbers[0]];
            (row.table, row.axis.as_str(), row.model, row.features)
                == (table, axis, model, FeatureSet::All)
        };
        TIME_CONSTANTS_S.len() + tables.models.iter().position(is_it).expect("a model")
    }

    #[test]
    fn every_row_belongs_to_one_model() {
        let (tire, rig) = (BumpResponse::new(2), RigSettings::default());
        let tables = RigTables::recorded(&tire, &rig, &GO_ON).expect("not stopped");
        let mut rows = tables.models.concat();
        rows.sort_unstable();
        assert_eq!(rows, (0..tables.rows.len()).collect::<Vec<_>>());
        // Tables 4 and 5 have a model a row; 6 one for three rows; 8 and 9 one for two.
        assert_eq!(tables.models.len(), 12 + 12 + 6 + 9 + 9);
        assert!(RigTables::recorded(&tire, &rig, &AtomicBool::new(true)).is_none());
    }

    #[test]
    fn neighbours_flatter_and_other_gains_do_not() {
        let (tire, rig) = (BumpResponse::new(12), RigSettings::default());
        let tables = RigTables::recorded(&tire, &rig, &GO_ON).expect("not stopped");
        let number = piece_of(&tables, 4, "fz", Kind::Gpr);
        let Some(Piece::Rows(found)) = tables.piece(number, &GO_ON) else {
            panic!("rows");
        };
        let [(_, row)] = &found[..] else {
            panic!("one row");
        };
        let (random, fresh) = (row.rig.expect("learnt"), row.fresh.expect("tried"));
        // Forces of up to 20 N, evenly drawn: the mean is off by a quarter of the range or so; gains of 5 % by some 2 % of it.
        let mean = random.mean_nrmse_percent.expect("varies");
        assert!((15.0..35.0).contains(&mean), "{row:?}");
        assert!(
            random.nrmse_percent.expect("varies") < 0.3 * mean,
            "{row:?}"
        );
        assert!(fresh.rmse_n > 1.2 * random.rmse_n, "{row:?}");
        let (rows, _) = tables.tables(vec![Piece::Rows(found.clone())]);
        assert_eq!(rows.iter().filter(|row| row.rig.is_some()).count(), 1);
    }
}
