//! The rig's figures for the rows of the published tables: a recording of each gait, learnt from and tested as the study says, and tried on a run with other gains.

use std::sync::atomic::AtomicBool;

use documents::rig::rig_settings::RigSettings;
use estimation::recipe::{FeatureSet, Kind, Recipe, SplitKind};
use estimation::split::Fold;
use estimation::validation::{Candidate, Splits};
use ndarray::Axis;
use results::TrialError;
use rig::contact_response::{ContactResponse, TurnableFilms};
use rig::force_error::layout_forces::force_errors;
use rig::force_error::learnt_force::{labelled, recipe};
use rig::force_error::thinned_run::ThinnedRun;

use crate::all_cores::on_all_cores;
use crate::published::printed_figures::{AXES, HIGH, LOW, TRANSITION};
use crate::published::published_gaits::{PublishedGait, RANDOMISED, RATE_HZ};
use crate::published::published_rows::{PublishedRow, published_rows};
use crate::published::tested_forces::Model;

/// Time constants of the circuit that are tried, s. The published study states none.
const TIME_CONSTANTS_S: [f64; 4] = [0.01, 0.1, 1.0, 10.0];
/// Runs are counted from here: those that layouts are judged by come before.
const FIRST_RUN: u64 = 1_000_000;
/// Number of readings of which one is tried, of a run that is only tried.
const TRIED_ONE_OF: usize = 6;
/// Readings that a process is conditioned on.
const PROCESS_ROWS: usize = 1500;

/// A recording that models learn from, and those with other gains that they are tried on, by the gait of the rows.
struct Recording {
    learnt: ThinnedRun,
    tried: Vec<(&'static str, ThinnedRun)>,
}

/// A layout's force on runs with other gains, with another time constant of its circuit.
#[derive(Debug, Clone, PartialEq)]
pub struct TimeConstantRow {
    /// s
    pub time_constant_s: f64,
    /// `fx`, `fy` or `fz`.
    pub axis: String,
    /// Error of the force.
    pub error: TrialError,
}

/// Recordings for the tables, with one layout's films.
pub struct RigTables<'r, R> {
    response: &'r R,
    rig: &'r RigSettings,
    recordings: Vec<Recording>,
    recipe: Recipe,
    rows: Vec<PublishedRow>,
    /// Rows of the same model, by their numbers.
    models: Vec<Vec<usize>>,
}

impl<'r, R: TurnableFilms + Sync> RigTables<'r, R> {
    /// Records what the rows are learnt from and tried on.
    pub fn recorded(response: &'r R, rig: &'r RigSettings) -> Self {
        let mut run = FIRST_RUN;
        let mut record = |gait: PublishedGait, one_of: usize| {
            run += 1;
            touching(&ThinnedRun::recorded(response, &gait.on(rig), run, one_of))
        };
        let mut recordings = Vec::new();
        for (gait, others) in gaits() {
            recordings.push(Recording {
                learnt: record(gait, 1),
                tried: others
                    .into_iter()
                    .map(|(name, gait)| (name, record(gait, TRIED_ONE_OF)))
                    .collect(),
            });
        }
        let rows = published_rows();
        Self {
            response,
            rig,
            models: models(&rows, &recordings),
            recordings,
            recipe: published_recipe(response, rig),
            rows,
        }
    }

    /// All rows, in the order of the tables.
    pub fn filled(&self) -> Vec<PublishedRow> {
        let learnt = on_all_cores(self.models.len(), |model| self.learnt(&self.models[model]));
        let mut rows = self.rows.clone();
        for (number, row) in learnt.into_iter().flatten() {
            rows[number] = row;
        }
        rows
    }

    /// Learns the same layout's forces with other time constants.
    pub fn time_constants(&self) -> Vec<TimeConstantRow> {
        let rows = on_all_cores(TIME_CONSTANTS_S.len(), |number| {
            self.with_time_constant(TIME_CONSTANTS_S[number])
        });
        rows.concat()
    }

    fn with_time_constant(&self, time_constant_s: f64) -> Vec<TimeConstantRow> {
        let mut rig = self.rig.clone();
        rig.electronics.time_constant_s = Some(time_constant_s);
        let errors = force_errors(self.response, &[], &rig, &AtomicBool::new(false));
        let rows = errors.expect("nobody stops it").into_iter();
        rows.map(|error| TimeConstantRow {
            time_constant_s,
            axis: error.axis,
            error: error.fresh,
        })
        .collect()
    }

    /// The rows of one model, with their numbers.
    fn learnt(&self, numbers: &[usize]) -> Vec<(usize, PublishedRow)> {
        let rows = numbers.iter().map(|number| self.rows[*number].clone());
        let mut rows: Vec<PublishedRow> = rows.collect();
        if let Err(reason) = self.fill(&mut rows) {
            for row in &mut rows {
                row.reason = Some(reason.clone());
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
        let recording = &self.recordings[recording(&self.recordings, first.gait)];
        let axis = AXES.iter().position(|axis| *axis == first.axis);
        let axis = axis.expect("a force");
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
                learnt.on(&run, 0..run.forces.len())
            });
            (row.rig, row.fresh) = match row.by {
                SplitKind::Run => (fresh, None),
                SplitKind::Time => (model.on_folds(&folds(SplitKind::Time)?)?, fresh),
                _ => {
                    let random = learnt.on(&model.rows, fold.test.iter().copied());
                    (random, fresh)
                }
            };
        }
        Ok(())
    }
}

/// Rows that the same model is learnt for, by their numbers.
fn models(rows: &[PublishedRow], recordings: &[Recording]) -> Vec<Vec<usize>> {
    let key = |row: &PublishedRow| {
        let recording = recording(recordings, row.gait);
        (recording, row.model, row.features, row.axis)
    };
    let mut models: Vec<Vec<usize>> = Vec::new();
    for (number, row) in rows.iter().enumerate() {
        let same = |numbers: &&mut Vec<usize>| key(&rows[numbers[0]]) == key(row);
        match models.iter_mut().find(same) {
            Some(numbers) => numbers.push(number),
            None => models.push(vec![number]),
        }
    }
    models
}

/// The rows of a run that touch the ground.
fn touching(run: &ThinnedRun) -> ThinnedRun {
    let all = 0..run.time_s.len();
    let rows: Vec<usize> = all.filter(|row| run.touches(*row)).collect();
    let numbers = |of: &[usize]| rows.iter().map(|row| of[*row]).collect();
    let values = |of: &[f64]| rows.iter().map(|row| of[*row]).collect();
    ThinnedRun {
        features: run.features.select(Axis(0), &rows),
        true_force_n: run.true_force_n.select(Axis(0), &rows),
        label_n: run.label_n.select(Axis(0), &rows),
        time_s: values(&run.time_s),
        contact_deg: values(&run.contact_deg),
        instant: numbers(&run.instant),
        stance: numbers(&run.stance),
        stances: run.stances,
    }
}

/// Returns what is recorded: a gait that is learnt from, and the rows' gaits that its models are tried on.
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
    recordings
        .iter()
        .position(has)
        .expect("each gait is recorded")
}

fn published_recipe<R: ContactResponse>(response: &R, rig: &RigSettings) -> Recipe {
    let mut recipe = recipe(response, rig);
    recipe.features.sets = FeatureSet::PUBLISHED.to_vec();
    recipe.models.kinds = vec![Kind::Gpr, Kind::Ann];
    recipe.models.gpr.most_rows = PROCESS_ROWS;
    recipe
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::published::pressed_wheel::with_films;

    #[test]
    fn every_row_belongs_to_one_model() {
        with_films(2, |films, rig| {
            let tables = RigTables::recorded(films, rig);
            let mut rows = tables.models.concat();
            rows.sort_unstable();
            assert_eq!(rows, (0..tables.rows.len()).collect::<Vec<_>>());
            // Tables 4 and 5 have a model a row; 6 one for three rows; 8 and 9 one for two.
            assert_eq!(tables.models.len(), 12 + 12 + 6 + 9 + 9);
        });
    }

    #[test]
    fn rows_that_touch_are_told_from_those_in_the_air() {
        with_films(2, |films, rig| {
            let settings = PublishedGait::ABLATION.on(rig);
            let all = ThinnedRun::recorded(films, &settings, 0, 1);
            let found = touching(&all);
            // Half of each turn is in the air.
            let share = found.time_s.len() as f64 / all.time_s.len() as f64;
            assert!((share - 0.5).abs() < 0.1, "{share}");
            assert!((0..found.time_s.len()).all(|row| found.touches(row)));
            assert_eq!(found.features.row(0), all.features.row(found.instant[0]));
        });
    }

    #[test]
    fn neighbours_flatter_and_other_gains_do_not() {
        with_films(30, |films, rig| {
            let tables = RigTables::recorded(films, rig);
            let is_it = |row: &PublishedRow| {
                (row.table, row.axis, row.features) == (4, "fz", FeatureSet::All)
            };
            let number = tables.rows.iter().position(is_it).expect("a row");
            let learnt = tables.learnt(&[number]);
            let [(_, row)] = &learnt[..] else {
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
        });
    }
}
