//! The model of one force: chosen by left-out runs, then judged by the flattering splits too, and learnt from all runs.
//!
//! A random split flatters by the neighbours of what it tests. Few rows of long runs have none, so it is made of readings one after another.

use std::sync::atomic::{AtomicBool, Ordering};

use estimation::estimator::ForceModel;
use estimation::features::GROUPS;
use estimation::fit_report::Ranking;
use estimation::recipe::{
    FeatureSet, Features, GprSettings, Kind, Models, Recipe, SplitKind, StartValue,
};
use estimation::rows::LabelledRows;
use estimation::rows::suspect_rows::SuspectRow;
use estimation::split::Place;
use estimation::validation::{Candidate, Splits, candidates, judge};
use ndarray::{ArrayView2, Axis, concatenate};

use crate::contact_response::ContactResponse;
use crate::electronics::film_circuit::Wired;
use crate::force_error::thinned_run::{ThinnedRun, WINDOW_ROWS};
use documents::rig::rig_settings::RigSettings;
use results::film::force_error::SplitError;

/// Parts of a run whose stances are drawn and left out together.
const CYCLES: usize = 20;
/// Three time constants of a signal's memory lie before what is tested by time. They take at most a quarter of a run's quarter, of which the first is learnt
/// from alone: nothing would be left of it.
const MEMORY_SHARE: f64 = 1.0 / 48.0;
/// A process with one length scale and a line has few hills: two starts on few rows find the highest.
const PROCESS: GprSettings = GprSettings {
    lengths: estimation::recipe::Lengths::Shared,
    line: true,
    restarts: 2,
    search_rows: 200,
    most_rows: 800,
};

/// Reason why nothing was learnt.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Unlearnt {
    /// The caller asked to stop.
    Stopped,
    /// A sentence.
    Reason(String),
}

/// Model of one force, as learnt.
#[derive(Debug, Clone, PartialEq)]
pub struct LearntForce {
    /// Model and features.
    pub chosen: Candidate,
    /// Learnt from all runs, with the width of its intervals.
    pub model: ForceModel,
    /// Least and greatest value of each film's signal that was learnt from.
    pub ranges: Vec<(f64, f64)>,
    /// Errors of the force on what was left out: at random, by time, by runs, and by cycles where these choose.
    pub splits: Vec<SplitError>,
    /// Error on the split that chooses over that on random rows, both over the training mean's; none of the training mean itself, which nothing flatters.
    pub leak: Option<f64>,
}

/// The rows of one force.
#[derive(Debug, Clone)]
pub struct AxisRows {
    /// Rows of all runs, few of each.
    pub few: LabelledRows,
    /// Rows of the begin of the first run, each beside the next.
    pub neighbours: LabelledRows,
}

/// The rows of runs with the force of one axis as a force sensor reads it.
pub fn labelled(runs: &[ThinnedRun], axis: usize) -> LabelledRows {
    let features: Vec<ArrayView2<'_, f64>> = runs.iter().map(|run| run.features.view()).collect();
    let forces = runs
        .iter()
        .flat_map(|run| run.label_n.column(axis).to_vec());
    LabelledRows {
        // Runs of one rig have the same films.
        features: concatenate(Axis(0), &features).unwrap_or_default(),
        forces: forces.collect(),
        places: runs
            .iter()
            .enumerate()
            .flat_map(|(run, rows)| places(run, rows))
            .collect(),
        // Films of a computed tire have no lone samples.
        suspect: vec![SuspectRow::default(); runs.iter().map(|run| run.time_s.len()).sum()],
    }
}

fn places(run: usize, rows: &ThinnedRun) -> Vec<Place> {
    let place = |row: usize| Place {
        run,
        row: rows.instant[row],
        cycle: run * CYCLES + rows.stance[row] * CYCLES / rows.stances.max(1),
        time_s: rows.time_s[row],
    };
    (0..rows.time_s.len()).map(place).collect()
}

/// Returns how long a signal remembers, s: its circuit or its rubber, whichever is longer, up to what a run allows.
fn memory_s<R: ContactResponse + ?Sized>(response: &R, settings: &RigSettings) -> f64 {
    let films = response.capacitance_pf().iter();
    let circuits = films.map(|pf| Wired::new(&settings.electronics, *pf).time_constant_s);
    let branches = settings.relaxation.iter().map(|branch| Some(branch.time_s));
    // A circuit that never forgets has no time to wait for.
    let longest = circuits.chain(branches).flatten().fold(0.0, f64::max);
    longest.min(MEMORY_SHARE * settings.gait.longest_s())
}

/// Returns the recipe that is tried on the runs of a rig.
pub fn recipe<R: ContactResponse + ?Sized>(response: &R, settings: &RigSettings) -> Recipe {
    let mut recipe = Recipe {
        features: Features {
            sets: vec![
                FeatureSet::Raw,
                FeatureSet::Baseline,
                FeatureSet::Slopes,
                FeatureSet::All,
            ],
            window_rows: WINDOW_ROWS,
            ..Features::default()
        },
        models: Models {
            kinds: vec![Kind::Ridge, Kind::Gpr],
            gpr: PROCESS,
            seed: settings.seed,
            ..Models::default()
        },
        ..Recipe::default()
    };
    recipe.preprocess.start_value = StartValue::Keep;
    recipe.validation.time_constant_s = memory_s(response, settings);
    recipe
}

/// Learns one force.
///
/// # Errors
/// See [`Unlearnt`].
pub fn learnt(
    AxisRows {
        few: rows,
        neighbours,
    }: &AxisRows,
    recipe: &Recipe,
    interval_s: f64,
    stop: &AtomicBool,
) -> Result<LearntForce, Unlearnt> {
    let splits = Splits::new(rows, recipe, interval_s);
    let mut judged = Vec::new();
    let mut failure = "there are no rows to learn from".to_owned();
    for candidate in candidates(recipe) {
        go_on(stop)?;
        match judge(candidate, rows, &splits, recipe, false) {
            Ok(one) => judged.push(one),
            Err(reason) => failure = reason,
        }
    }
    let ranking = Ranking::new(judged, splits.by);
    let chosen = ranking.chosen().ok_or(Unlearnt::Reason(failure))?;
    let model = ForceModel::learn(chosen, splits.by, rows, recipe)
        .map_err(|error| Unlearnt::Reason(error.to_string()))?;
    let mut kinds = vec![SplitKind::Random, SplitKind::Time, SplitKind::Run];
    kinds.extend((!kinds.contains(&splits.by)).then_some(splits.by));
    let mut errors = Vec::new();
    for by in kinds {
        go_on(stop)?;
        errors.push(match (by, chosen.on(by)) {
            (SplitKind::Random, _) => {
                let splits = Splits::new(neighbours, recipe, interval_s);
                on_split(chosen.candidate, by, neighbours, &splits, recipe)
            }
            (_, Some(figures)) => SplitError::of(by, Ok(figures)),
            (_, None) => on_split(chosen.candidate, by, rows, &splits, recipe),
        });
    }
    // Other rows have other forces: each error is taken over that of the training mean on the same rows.
    let share = |by: SplitKind| {
        let error = errors.iter().find(|error| error.by == by)?;
        Some(error.nrmse_percent? / error.mean_nrmse_percent?)
    };
    let leak = share(splits.by).zip(share(SplitKind::Random));
    let leak = leak.map(|(strict, random)| strict / random);
    Ok(LearntForce {
        chosen: chosen.candidate,
        model,
        ranges: ranges(rows),
        leak: leak.filter(|leak| leak.is_finite() && chosen.candidate.kind != Kind::Mean),
        splits: errors,
    })
}

fn ranges(rows: &LabelledRows) -> Vec<(f64, f64)> {
    let films = rows.features.ncols() / GROUPS;
    let of_film = |film: usize| {
        let column = rows.features.column(film).into_iter();
        column.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| {
            (low.min(*x), high.max(*x))
        })
    };
    (0..films).map(of_film).collect()
}

fn go_on(stop: &AtomicBool) -> Result<(), Unlearnt> {
    match stop.load(Ordering::Relaxed) {
        true => Err(Unlearnt::Stopped),
        false => Ok(()),
    }
}

fn on_split(
    candidate: Candidate,
    by: SplitKind,
    rows: &LabelledRows,
    splits: &Splits,
    recipe: &Recipe,
) -> SplitError {
    let alone = Splits {
        by,
        folds: splits.folds.clone(),
    };
    match judge(candidate, rows, &alone, recipe, false) {
        Ok(judged) => {
            let none = Err("the split wasn't made");
            SplitError::of(by, judged.on(by).map_or(none, Ok))
        }
        Err(reason) => SplitError::of(by, Err(&reason)),
    }
}
