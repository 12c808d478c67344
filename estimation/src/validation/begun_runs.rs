//! Left-out runs that begin elsewhere: under a load, and zeroed after lifting.
//!
//! A run that begins unloaded shows what its signals are without a force. One that begins under a load takes that load for nothing, and films that leak need a rest
//! before they can be zeroed. What either costs is measured on runs that weren't learnt from, against the same rows of the same runs as they were recorded.

use crate::error_metrics::rmse;
use crate::model::contract::{Effort, FitError, Prediction};
use crate::recipe::Recipe;
use crate::rows::{LabelledRows, Runs, Start};
use crate::split::Fold;
use crate::validation::begun_run::{Beginning, BegunRun, LOADS, LeftOutRun, RESTS_S};
use crate::validation::candidate::Candidate;
use crate::validation::learnt_model::LearntModel;

/// A first reading that the model's zero takes for a larger share of the largest force is a load, whatever runs at rest say; of a single run, which says nothing of others, twice this.
const LOADED: f64 = 0.05;
/// Multiple of the largest force that left-out runs have at rest by the others' zero, beyond which a first reading is a load: the largest of a few says little of the next.
const ANOTHER_ZERO: f64 = 3.0;

/// The left-out runs of a force, begun at all their places.
#[derive(Debug, Clone, PartialEq)]
pub struct BegunRuns {
    begun: Vec<BegunRun>,
    /// The largest force of all runs, N.
    largest: f64,
}

/// Predictions of one model for all begun runs: for each its rows as it begins there, and as it was recorded.
pub type Said = Vec<(Vec<Prediction>, Vec<Prediction>)>;

/// Error of runs that begin at a place, beside that of the same rows as recorded.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BegunError {
    /// Number of beginnings.
    pub beginnings: usize,
    /// N
    pub rmse: f64,
    /// RMSE of the same rows of the runs as recorded, N.
    pub recorded: f64,
}

/// Errors of runs by where they begin.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct BegunErrors {
    /// Mean load at the beginning, N, and the error, for each share of the largest force that there is.
    pub loaded: Vec<(f64, f64, BegunError)>,
    /// Rest, s, and the error.
    pub rested: Vec<(f64, BegunError)>,
}

impl BegunErrors {
    /// An error within this factor of that of the same rows as recorded is about as good.
    pub(crate) const AS_GOOD: f64 = 1.2;

    /// The least rest from which on a zeroed run is about as good as one begun unloaded, s; none where no rest is.
    pub fn rest_s(&self) -> Option<f64> {
        let long_enough =
            |(_, error): &&(f64, BegunError)| error.rmse <= Self::AS_GOOD * error.recorded;
        let enough = self.rested.iter().rev().take_while(long_enough);
        enough.last().map(|(rest_s, _)| *rest_s)
    }
}

impl BegunRuns {
    /// Begins the runs that these folds leave out.
    pub fn new(
        (runs, force, start): (&Runs, usize, Start),
        rows: &LabelledRows,
        folds: &[Fold],
        recipe: &Recipe,
    ) -> Self {
        let settings = runs.stream_settings(recipe, start);
        let taken_off = runs.taken_off(start, settings.start_rows);
        let of_fold = |(number, fold): (usize, &Fold)| {
            let left_out = runs_of(rows, &fold.test);
            let zero = runs.zero_without(&left_out);
            let run = |left_out: usize| {
                let run = LeftOutRun {
                    run: &runs.runs[left_out],
                    force,
                    labelled: labelled(rows, left_out),
                    settings: &settings,
                    taken_off: taken_off[left_out].as_ref(),
                    zero: zero.clone(),
                };
                run.begun(number)
            };
            left_out.into_iter().flat_map(run).collect::<Vec<_>>()
        };
        let sizes = rows.forces.iter().map(|force| force.abs());
        Self {
            begun: folds.iter().enumerate().flat_map(of_fold).collect(),
            largest: sizes.fold(0.0, f64::max),
        }
    }

    /// Learns a candidate from each fold's runs, and says what it thinks of those left out, wherever they begin.
    ///
    /// # Errors
    /// When the model can't be learnt.
    pub fn said(
        &self,
        candidate: Candidate,
        rows: &LabelledRows,
        folds: &[Fold],
        recipe: &Recipe,
    ) -> Result<Said, FitError> {
        let models = folds
            .iter()
            .map(|fold| LearntModel::learn(candidate, rows, &fold.train, recipe, Effort::Fold));
        let models: Vec<LearntModel> = models.collect::<Result<_, _>>()?;
        let of = |begun: &BegunRun| {
            let model = &models[begun.fold];
            let recorded = |row: &usize| rows.features.row(*row).to_vec();
            let there = begun
                .rows
                .iter()
                .map(|row| model.predict(&begun.moved(recorded(row))));
            let here = begun.rows.iter().map(|row| model.predict(&recorded(row)));
            (there.collect(), here.collect())
        };
        Ok(self.begun.iter().map(of).collect())
    }

    /// Errors by where runs begin, of what members say together; none where no run was left out.
    pub fn errors(&self, rows: &LabelledRows, members: &[Said]) -> Option<BegunErrors> {
        if self.begun.is_empty() {
            return None;
        }
        let error = |is: &dyn Fn(Beginning) -> bool| -> Option<BegunError> {
            let (mut truth, mut here, mut recorded, mut beginnings) =
                (Vec::new(), Vec::new(), Vec::new(), 0);
            for (number, begun) in self.begun.iter().enumerate().filter(|(_, it)| is(it.at)) {
                beginnings += 1;
                truth.extend(begun.rows.iter().map(|row| rows.forces[*row]));
                here.extend(together(members, |said| &said[number].0));
                recorded.extend(together(members, |said| &said[number].1));
            }
            (beginnings > 0 && !members.is_empty()).then(|| BegunError {
                beginnings,
                rmse: rmse(&truth, &here),
                recorded: rmse(&truth, &recorded),
            })
        };
        let loaded = |(number, share): (usize, &f64)| {
            let is = |at| matches!(at, Beginning::Loaded { load, .. } if load == number);
            Some((*share, self.mean_load(number), error(&is)?))
        };
        let rested = |(number, rest_s): (usize, &f64)| {
            let is = |at| matches!(at, Beginning::Rested { rest } if rest == number);
            Some((*rest_s, error(&is)?))
        };
        Some(BegunErrors {
            loaded: LOADS.iter().enumerate().filter_map(loaded).collect(),
            rested: RESTS_S.iter().enumerate().filter_map(rested).collect(),
        })
    }

    /// Force, N, beyond which a first reading is a load by the model's zero: runs at rest say how far zeros of runs differ.
    pub fn loaded_above(&self, members: &[Said]) -> f64 {
        let at_rest = self.begun.iter().enumerate();
        let at_rest = at_rest.filter(|(_, begun)| begun.at == Beginning::AtRest);
        let said = at_rest.flat_map(|(number, _)| together(members, |said| &said[number].0));
        match said.map(f64::abs).reduce(f64::max) {
            Some(most) => (ANOTHER_ZERO * most).max(LOADED * self.largest),
            None => 2.0 * LOADED * self.largest,
        }
    }

    fn mean_load(&self, number: usize) -> f64 {
        let loads = self.begun.iter().filter_map(|begun| match begun.at {
            Beginning::Loaded { load, force } if load == number => Some(force),
            _ => None,
        });
        let loads: Vec<f64> = loads.collect();
        loads.iter().sum::<f64>() / loads.len() as f64
    }
}

/// Estimates of members together for one list of rows, N.
fn together<'s>(members: &'s [Said], of: impl Fn(&'s Said) -> &'s Vec<Prediction>) -> Vec<f64> {
    let rows = members.first().map_or(0, |said| of(said).len());
    let row = |row: usize| {
        let said: Vec<Prediction> = members.iter().map(|said| of(said)[row]).collect();
        Prediction::together(&said).mean
    };
    (0..rows).map(row).collect()
}

/// Runs of these rows, each once.
fn runs_of(rows: &LabelledRows, of: &[usize]) -> Vec<usize> {
    let mut runs: Vec<usize> = of.iter().map(|row| rows.places[*row].run).collect();
    runs.dedup();
    runs
}

/// Rows of a run with the force, suspect ones apart: the row in the run, and that among all with the force.
fn labelled(rows: &LabelledRows, run: usize) -> Vec<(usize, usize)> {
    let places = rows.places.iter().enumerate();
    let of_run = places.filter(|(row, place)| place.run == run && !rows.suspect[*row].is_suspect());
    of_run.map(|(row, place)| (place.row, row)).collect()
}

#[cfg(test)]
mod tests {
    use ndarray::Array2;
    use rand::{RngExt, SeedableRng};
    use rand_chacha::ChaCha8Rng;

    use super::*;
    use crate::recipe::{FeatureSet, Kind};
    use crate::recording::Recording;
    use crate::recording::named_columns::NamedColumns;
    use crate::validation::split_set::Splits;

    /// Largest force, N; signal of one N.
    const MOST: f64 = 10.0;
    const GAIN: f64 = 2.0;
    /// Deviation of its noise.
    const NOISE: f64 = 0.4;

    /// Run of 3 s at rest and two presses at 10 Hz, each 4 s up and down with a rest of 8 s after it, of a signal of 2 a newton, which keeps a residue that fades with 1 s and has normal noise.
    fn run(number: usize, residue: f64, noise: f64) -> Recording {
        let mut random = ChaCha8Rng::seed_from_u64(number as u64);
        let pressed = |row: usize| row.checked_sub(30).map(|row| row % 120);
        let force = |row: usize| match pressed(row) {
            Some(k @ 0..40) => MOST * (k.min(40 - k) as f64 / 20.0),
            _ => 0.0,
        };
        let left = |row: usize| match pressed(row) {
            Some(k @ 40..) => residue * (-(k as f64 - 40.0) / 10.0).exp(),
            _ => 0.0,
        };
        let mut signal = |row: usize| {
            let draws: f64 = (0..12).map(|_| random.random_range(0.0..1.0)).sum();
            GAIN * force(row) + left(row) + 0.3 * number as f64 + noise * (draws - 6.0)
        };
        Recording {
            name: format!("{number}.csv"),
            time_s: (0..270).map(|row| 0.1 * row as f64).collect(),
            signals: Array2::from_shape_fn((270, 1), |(row, _)| signal(row)),
            forces: Array2::from_shape_fn((270, 1), |(row, _)| force(row)),
            cycle: None,
        }
    }

    /// Errors and the least load of three runs of which each is left out of a line, with this taken off.
    fn begun(residue: f64, start: Start) -> (BegunErrors, f64) {
        let recordings = (0..3).map(|number| run(number, residue, 0.0));
        begun_of(recordings.collect(), &Recipe::default(), start)
    }

    fn begun_of(recordings: Vec<Recording>, recipe: &Recipe, start: Start) -> (BegunErrors, f64) {
        let names = NamedColumns {
            time: "time_s".to_owned(),
            signals: vec!["s1".to_owned()],
            forces: vec!["fz_n".to_owned()],
            cycle: None,
            time_unit: None,
            converted: Vec::new(),
        };
        let runs = Runs::new(recipe, names, recordings).expect("runs");
        let features = runs.features(&runs.stream_settings(recipe, start), start);
        let rows = runs.of_force(0, &features);
        let splits = Splits::new(&rows, recipe, 0.1);
        let begun = BegunRuns::new((&runs, 0, start), &rows, splits.of_runs(), recipe);
        let line = Candidate {
            kind: Kind::Ridge,
            features: FeatureSet::Raw,
        };
        let said = begun.said(line, &rows, splits.of_runs(), recipe);
        let said = [said.expect("learns")];
        let errors = begun.errors(&rows, &said).expect("runs were left out");
        (errors, begun.loaded_above(&said))
    }

    #[test]
    fn a_load_at_the_begin_is_what_estimates_are_off_by_where_first_readings_are_taken_off() {
        let (errors, loaded_above) = begun(0.0, Start::First);
        let loads: Vec<f64> = errors.loaded.iter().map(|(_, load, _)| *load).collect();
        assert_eq!(loads, [2.5, 5.0, 10.0]);
        // A line in a signal without noise: what is left is its penalty, far below a thousandth.
        for (_, load, error) in &errors.loaded {
            assert_eq!(error.beginnings, 3);
            assert!((error.rmse / load - 1.0).abs() < 1e-3, "{error:?}");
            assert!(error.recorded < 1e-3 * MOST);
        }
        // Offsets of 0, 0.3 and 0.6 are 0.3 N apart at most by the median of the other two, which takes the upper one.
        let apart = 0.6 / GAIN;
        assert!(
            (loaded_above / (ANOTHER_ZERO * apart) - 1.0).abs() < 1e-3,
            "{loaded_above}"
        );
    }

    #[test]
    fn a_begin_under_load_costs_nothing_where_readings_are_kept() {
        let (errors, _) = begun(0.0, Start::Kept);
        for (_, _, error) in &errors.loaded {
            assert_eq!(error.rmse, error.recorded);
        }
    }

    #[test]
    fn a_residue_asks_for_a_rest() {
        let (errors, _) = begun(4.0, Start::First);
        let of = |rest_s: f64| {
            let found = errors.rested.iter().find(|(rest, _)| *rest == rest_s);
            found.expect("is tried").1
        };
        // Zeroed at once, the residue of 4 / 2 N is off at all later rows; after 5 s exp(-5) of it is.
        assert!(of(0.0).rmse > 3.0 * of(0.0).recorded, "{:?}", of(0.0));
        assert!((of(5.0).rmse / of(5.0).recorded - 1.0).abs() < 0.05);
        let rest_s = errors.rest_s().expect("a rest is long enough");
        assert!((1.0..=5.0).contains(&rest_s), "{rest_s}");
        // 8 s are the longest rest.
        assert_eq!(errors.rested.last().map(|(rest_s, _)| *rest_s), Some(5.0));
    }

    /// The median of 25 readings has root(pi / 2 / 25) = 1/4 of the noise of one, so that a run zeroed by it is off by 1.03 times the noise; 600 rows tell that to 3 %.
    #[test]
    fn a_zero_of_several_readings_has_less_noise_than_one() {
        let zeroed = |start_rows: usize| {
            let mut recipe = Recipe::default();
            recipe.preprocess.start_rows = start_rows;
            let runs = (0..3).map(|number| run(number, 0.0, NOISE));
            let (errors, _) = begun_of(runs.collect(), &recipe, Start::First);
            errors.rested.first().expect("was lifted").1.rmse
        };
        let [one, several] = [1, 25].map(zeroed);
        assert!(several < 1.1 * NOISE / GAIN, "{several}");
        assert!(one > 1.2 * NOISE / GAIN, "{one}");
    }

    #[test]
    fn nothing_is_told_of_one_run() {
        let none = BegunRuns {
            begun: Vec::new(),
            largest: MOST,
        };
        let rows = LabelledRows {
            features: Array2::zeros((0, 4)),
            forces: Vec::new(),
            places: Vec::new(),
            suspect: Vec::new(),
        };
        assert_eq!(none.errors(&rows, &[]), None);
        assert_eq!(none.loaded_above(&[]), 2.0 * LOADED * MOST);
    }
}
