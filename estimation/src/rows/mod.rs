//! The rows of all runs as models learn them: checked, on one clock, in cycles, with features.
//!
//! - [`suspect_rows`]: rows that hold what is hardly a measurement

pub mod suspect_rows;

use std::borrow::Cow;

use ndarray::{Array2, ArrayView1, Axis, concatenate};

use crate::align::aligned;
use crate::cycles::cycles;
use crate::error_metrics::order_statistics::upper_median;
use crate::features::{StreamSettings, features};
use crate::recipe::{Kind, Loss, Recipe, SplitKind, StartValue};
use crate::recording::look::suspect_samples::{SuspectSample, suspect_samples};
use crate::recording::named_columns::NamedColumns;
use crate::recording::unloaded::{begins_unloaded, is_first_a_zero, reading_at, zero};
use crate::recording::{PAUSE_INTERVALS, Recording};
use crate::relations::learnt_relations::Relations;
use crate::rows::suspect_rows::{SuspectRow, suspect_rows};
use crate::split::Place;

/// Fewer cycles than this in all runs tell nothing of what a new one would bring.
pub(crate) const FEWEST_CYCLES: usize = 4;
/// Fewer rows with a force are learnt nothing from.
pub const FEWEST_ROWS: usize = 20;
/// Rates whose quotient is larger are other rates.
pub(crate) const RATE_FACTOR: f64 = 1.5;
/// Refusal of recordings that can't be used as the recipe asks.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Refusal {
    /// JSON pointer into the recipe; empty where the recordings are meant.
    pub pointer: String,
    /// Sentence that says what is wrong and what would be right.
    pub detail: String,
}

/// Reading that is taken off a run's signals.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Start {
    /// No reading: signals are kept.
    Kept,
    /// The first one.
    First,
    /// The median of those without a force.
    Unloaded,
}

/// Runs that can be learnt from.
#[derive(Debug, Clone)]
pub struct Runs {
    /// The columns' names.
    pub names: NamedColumns,
    /// The runs, on one clock where the recipe has one.
    pub runs: Vec<Recording>,
    /// Typical intervals between rows as recorded, s: the least and the greatest of the runs.
    pub interval_s: (f64, f64),
    /// A longer time between rows is a pause, s.
    pub pause_s: f64,
    /// Suspect samples of each run, as recorded.
    pub suspects: Vec<Vec<SuspectSample>>,
    /// Place of each row of all runs.
    places: Vec<Place>,
    /// Places of suspect samples in each row of all runs, forces apart.
    suspect_rows: Vec<SuspectRow>,
    /// Whether each force of each row of all runs is suspect: rows x forces.
    suspect_forces: Array2<bool>,
}

/// Rows with one force.
#[derive(Debug, Clone)]
pub struct LabelledRows {
    /// Features of these rows: rows x (4 groups of signals).
    pub features: Array2<f64>,
    /// N
    pub forces: Vec<f64>,
    /// Places of these rows.
    pub places: Vec<Place>,
    /// Places of suspect samples in these rows.
    pub suspect: Vec<SuspectRow>,
}

impl Runs {
    /// Checks recordings with the columns' names, and brings them into rows.
    ///
    /// # Errors
    /// Every reason why the recipe can't be followed: no forces, dead signals, too few cycles or rows, runs of other rates, one run where runs are to be left out.
    pub fn new(
        recipe: &Recipe,
        names: NamedColumns,
        recordings: Vec<Recording>,
    ) -> Result<Self, Vec<Refusal>> {
        let intervals: Vec<f64> = recordings
            .iter()
            .filter_map(Recording::interval_s)
            .collect();
        let least = intervals.iter().copied().fold(f64::INFINITY, f64::min);
        let greatest = intervals.iter().copied().fold(0.0, f64::max);
        let usual = PAUSE_INTERVALS * upper_median(intervals.iter().copied()).unwrap_or(1.0);
        let pause_s = recipe.preprocess.pause_s.unwrap_or(usual);
        let suspects: Vec<Vec<SuspectSample>> = recordings.iter().map(suspect_samples).collect();
        let runs: Vec<Recording> = match recipe.preprocess.rate_hz {
            Some(rate_hz) => recordings
                .iter()
                .map(|run| aligned(run, rate_hz, pause_s))
                .collect(),
            None => recordings,
        };
        let places = places(&runs, recipe);
        let mut found = Self {
            names,
            runs,
            interval_s: (least, greatest),
            pause_s,
            suspects,
            places,
            suspect_rows: Vec::new(),
            suspect_forces: Array2::default((0, 0)),
        };
        found.mark_suspects(recipe);
        let refusals = found.refusals(recipe);
        if refusals.is_empty() {
            Ok(found)
        } else {
            Err(refusals)
        }
    }

    fn mark_suspects(&mut self, recipe: &Recipe) {
        // Nothing that is taken off or turned moves a window.
        let settings = self.stream_settings(recipe, Start::Kept);
        let pairs = self.runs.iter().zip(&self.suspects);
        let (rows, forces): (Vec<Vec<SuspectRow>>, Vec<Array2<bool>>) = pairs
            .map(|(run, samples)| suspect_rows(run, samples, &settings))
            .unzip();
        let forces: Vec<_> = forces.iter().map(|forces| forces.view()).collect();
        self.suspect_rows = rows.concat();
        self.suspect_forces = concatenate(Axis(0), &forces).unwrap_or_default();
    }

    fn refusals(&self, recipe: &Recipe) -> Vec<Refusal> {
        let mut refusals = Vec::new();
        let mut refuse = |pointer: &str, detail: String| {
            refusals.push(Refusal {
                pointer: pointer.to_owned(),
                detail,
            });
        };
        let (least, greatest) = self.interval_s;
        if recipe.preprocess.rate_hz.is_none() && greatest > RATE_FACTOR * least {
            let detail = format!(
                "the runs have rates from {:.4} to {:.4} Hz; a rate_hz brings them to one clock",
                greatest.recip(),
                least.recip()
            );
            refuse("/preprocess/rate_hz", detail);
        }
        for (column, name) in self.names.signals.iter().enumerate() {
            let runs = self.runs.iter();
            if has_one_value(runs.flat_map(|run| run.signals.column(column).to_vec())) {
                refuse(
                    "/columns/signals",
                    format!(
                        "signal {} is dead: it has one value in all runs; leave it out by not_signals = [{name:?}]",
                        name.escape_debug()
                    ),
                );
            }
        }
        for (column, name) in self.names.forces.iter().enumerate() {
            let labels = self.labelled(column).len();
            if labels == 0 {
                refuse(
                    "/columns/forces",
                    format!("force {} was measured in no row", name.escape_debug()),
                );
            } else if labels < FEWEST_ROWS {
                let detail = format!(
                    "force {} was measured in {labels} rows; {FEWEST_ROWS} are the fewest to learn from",
                    name.escape_debug()
                );
                refuse("/columns/forces", detail);
            } else if has_one_value(
                self.runs
                    .iter()
                    .flat_map(|run| run.forces.column(column).to_vec()),
            ) {
                let detail = format!(
                    "force {} has one value in all rows, so that nothing is learnt of it: record it under load, or name the others by forces = [...]",
                    name.escape_debug()
                );
                refuse("/columns/forces", detail);
            }
        }
        let poisson =
            recipe.models.kinds.contains(&Kind::Ann) && recipe.models.ann.loss == Loss::Poisson;
        let negative = |force: &f64| *force < 0.0;
        if poisson && self.runs.iter().any(|run| run.forces.iter().any(negative)) {
            let detail = "the Poisson loss takes forces of 0 and more; a row has a negative one";
            refuse("/models/ann/loss", detail.to_owned());
        }
        let cycles: std::collections::BTreeSet<usize> =
            self.places.iter().map(|place| place.cycle).collect();
        if cycles.len() < FEWEST_CYCLES {
            let detail = format!(
                "there are {} cycles in all runs; {FEWEST_CYCLES} are the fewest to leave some out: say what a cycle is by cycle, pause_s, threshold_n or block_s",
                cycles.len()
            );
            refuse("/columns", detail);
        }
        if recipe.validation.by == Some(SplitKind::Run) && self.runs.len() < 2 {
            refuse(
                "/validation/by",
                "runs can't be left out of one run: give another recording, or leave cycles out"
                    .to_owned(),
            );
        }
        refusals
    }

    /// Returns the place of each row of all runs.
    pub fn places(&self) -> &[Place] {
        &self.places
    }

    /// Counts the cycles of a run.
    pub fn cycles_of(&self, run: usize) -> usize {
        let numbers = self
            .places
            .iter()
            .filter(|place| place.run == run)
            .map(|place| place.cycle);
        numbers.collect::<std::collections::BTreeSet<_>>().len()
    }

    /// Returns the settings of the stream of features, with this taken off.
    pub fn stream_settings(&self, recipe: &Recipe, start: Start) -> StreamSettings {
        StreamSettings {
            subtract_start: start != Start::Kept,
            start_rows: recipe.preprocess.start_rows,
            turn_sign: recipe.preprocess.turn_sign,
            smooth_rows: recipe.preprocess.smooth_rows,
            window_rows: recipe.features.window_rows,
            baseline_s: recipe.features.baseline_s(),
            pause_s: self.pause_s,
        }
    }

    /// Features of all rows of all runs, with this taken off; a run without an unloaded row has its first reading taken off.
    pub fn features(&self, settings: &StreamSettings, start: Start) -> Array2<f64> {
        let pairs = self
            .runs
            .iter()
            .zip(self.taken_off(start, settings.start_rows));
        let of_runs: Vec<Array2<f64>> = pairs
            .map(|(run, off)| features(run, settings, off))
            .collect();
        let views: Vec<_> = of_runs.iter().map(|features| features.view()).collect();
        concatenate(Axis(0), &views).unwrap_or_default()
    }

    /// Reading that is taken off each run's signals; `None` where none is.
    pub(crate) fn taken_off(&self, start: Start, start_rows: usize) -> Vec<Option<Vec<f64>>> {
        let first = |run: &Recording| (run.rows() > 0).then(|| reading_at(run, 0, start_rows));
        let of_run = |(run, sound): (&Recording, Cow<'_, Recording>)| match start {
            Start::Kept => None,
            // Unless that is a spike.
            Start::First => first(&sound),
            Start::Unloaded => zero(&sound).or_else(|| first(run)),
        };
        self.runs
            .iter()
            .zip(self.sound_runs())
            .map(of_run)
            .collect()
    }

    /// Rows with a force, by their numbers among all rows.
    fn labelled(&self, force: usize) -> Vec<usize> {
        let forces = self
            .runs
            .iter()
            .flat_map(|run| run.forces.column(force).to_vec());
        let measured = forces.enumerate().filter(|(_, force)| force.is_finite());
        measured.map(|(row, _)| row).collect()
    }

    /// The rows with a force, with their features among those of all rows.
    pub fn of_force(&self, force: usize, features: &Array2<f64>) -> LabelledRows {
        let rows = self.labelled(force);
        let all: Vec<f64> = self
            .runs
            .iter()
            .flat_map(|run| run.forces.column(force).to_vec())
            .collect();
        LabelledRows {
            features: features.select(Axis(0), &rows),
            forces: rows.iter().map(|row| all[*row]).collect(),
            places: rows.iter().map(|row| self.places[*row]).collect(),
            suspect: rows
                .iter()
                .map(|row| SuspectRow {
                    force: self.suspect_forces[[*row, force]],
                    ..self.suspect_rows[*row]
                })
                .collect(),
        }
    }

    /// Whether every run begins unloaded: then its first readings are what the signals are without a force.
    pub fn begin_unloaded(&self, start_rows: usize) -> bool {
        self.sound_runs()
            .all(|run| begins_unloaded(&run, start_rows))
    }

    /// Returns what is taken off; None where left-out runs are to tell.
    pub fn start(&self, recipe: &Recipe) -> Option<Start> {
        let first = |run: Cow<'_, Recording>| is_first_a_zero(&run, recipe.preprocess.start_rows);
        match recipe.preprocess.start_value {
            StartValue::Subtract => Some(Start::First),
            StartValue::Keep => Some(Start::Kept),
            StartValue::Unloaded => Some(Start::Unloaded),
            StartValue::Auto if self.runs.len() > 1 => None,
            StartValue::Auto => match self.sound_runs().all(first) {
                true => Some(Start::First),
                false => Some(Start::Kept),
            },
        }
    }

    /// The signals without a force: the medians of the runs' zeros. `None` where no run was unloaded.
    pub fn zero(&self) -> Option<Vec<f64>> {
        self.zero_without(&[])
    }

    /// The zero of the runs but these.
    pub(crate) fn zero_without(&self, left_out: &[usize]) -> Option<Vec<f64>> {
        let runs = self.sound_runs().enumerate();
        let others = runs.filter(|(number, _)| !left_out.contains(number));
        let zeros: Vec<Vec<f64>> = others.filter_map(|(_, run)| zero(&run)).collect();
        let of_signal = |signal: usize| upper_median(zeros.iter().map(|zero| zero[signal]));
        (0..self.names.signals.len()).map(of_signal).collect()
    }

    /// Returns what the signals say of each other.
    pub fn relations(&self) -> Option<Relations> {
        let runs: Vec<Cow<'_, Recording>> = self.sound_runs().collect();
        let signals: Vec<&Array2<f64>> = runs.iter().map(|run| &run.signals).collect();
        Relations::learn(&signals)
    }

    /// The runs without their suspect rows.
    fn sound_runs(&self) -> impl Iterator<Item = Cow<'_, Recording>> {
        let mut before = 0;
        self.runs.iter().map(move |run| {
            let first = before;
            before += run.rows();
            let is_sound = |row: &usize| {
                let mut forces = self.suspect_forces.row(first + row).into_iter();
                !self.suspect_rows[first + row].reading && !forces.any(|force| *force)
            };
            let sound: Vec<usize> = (0..run.rows()).filter(is_sound).collect();
            if sound.len() == run.rows() {
                return Cow::Borrowed(run);
            }
            let cycle = run.cycle.as_ref();
            Cow::Owned(Recording {
                name: run.name.clone(),
                time_s: sound.iter().map(|row| run.time_s[*row]).collect(),
                signals: run.signals.select(Axis(0), &sound),
                forces: run.forces.select(Axis(0), &sound),
                cycle: cycle.map(|cycle| sound.iter().map(|row| cycle[*row]).collect()),
            })
        })
    }

    /// Least and greatest value of each signal, as models are given it: the first group of all features.
    pub fn ranges(&self, features: &Array2<f64>) -> Vec<(f64, f64)> {
        let signals = 0..self.names.signals.len();
        signals
            .map(|column| self.feature_range(features, column))
            .collect()
    }

    /// Least and greatest value of a feature, by its column among all features, in all rows without a suspect reading in its window.
    pub fn feature_range(&self, features: &Array2<f64>, column: usize) -> (f64, f64) {
        let group = column / self.names.signals.len().max(1);
        range_of_sound(&features.column(column), &self.suspect_rows, group)
    }
}

/// Least and greatest of a feature's values, of rows in whose windows no suspect reading is; of all rows where there is no other.
pub(crate) fn range_of_sound(
    values: &ArrayView1<'_, f64>,
    suspect: &[SuspectRow],
    group: usize,
) -> (f64, f64) {
    let range = |values: &mut dyn Iterator<Item = f64>| {
        values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| {
            (low.min(x), high.max(x))
        })
    };
    let pairs = values.iter().zip(suspect);
    let sound = pairs.filter(|(_, suspect)| !suspect.groups[group]);
    let found = range(&mut sound.map(|(x, _)| *x));
    match found.0 <= found.1 {
        true => found,
        false => range(&mut values.iter().copied()),
    }
}

fn places(runs: &[Recording], recipe: &Recipe) -> Vec<Place> {
    let mut before = 0;
    let mut places = Vec::new();
    for (run, recording) in runs.iter().enumerate() {
        let found = cycles(recording, &recipe.columns.cycles);
        let most = found.iter().copied().max().map_or(0, |most| most + 1);
        places.extend(found.into_iter().enumerate().map(|(row, cycle)| Place {
            run,
            row,
            cycle: before + cycle,
            time_s: recording.time_s[row],
        }));
        before += most;
    }
    places
}
/// Whether all values are the same, those apart that weren't measured.
fn has_one_value(values: impl Iterator<Item = f64>) -> bool {
    let mut values = values.filter(|value| value.is_finite());
    let first = values.next();
    values.all(|value| Some(value) == first)
}
