//! Recordings with spikes: what is learnt from them, and what is told.

use estimation::fit_report::Ranking;
use estimation::recipe::{FeatureSet, Kind, Recipe, SuspectRows};
use estimation::recording::csv_recording::{header, read};
use estimation::recording::look::suspect_samples::MeasuredColumn;
use estimation::recording::named_columns::NamedColumns;
use estimation::rows::{Runs, Start};
use estimation::validation::{Candidate, Judged, Splits, candidates, judge};

/// Twenty-seven rows of a force and two signals of it, of which the first reads 10000 in row 13.
const ONE_SPIKE: &str = include_str!("../data/one-spike.csv");
const ROWS: usize = 27;
const SPIKE: usize = 13;
/// Reading of the spiked row without the spike.
const READING: &str = "0.3414";

fn recipe(suspect_rows: SuspectRows, outlier_z: Option<f64>) -> Recipe {
    let mut recipe = Recipe::default();
    recipe.models.kinds = vec![Kind::Ridge, Kind::Gpr];
    recipe.preprocess.suspect_rows = suspect_rows;
    recipe.preprocess.outlier_z = outlier_z;
    recipe
}

fn runs_of(recipe: &Recipe, text: &str) -> Runs {
    let header = header("r", text).expect("a header");
    let names = NamedColumns::find(&recipe.columns, [&header]);
    let run = read("r", text, &recipe.columns, &names, false).expect("a recording");
    Runs::new(recipe, names, vec![run]).expect("runs")
}

fn ranked(recipe: &Recipe, runs: &Runs) -> Ranking {
    let start = runs.start(recipe).expect("one run");
    let features = runs.features(&runs.stream_settings(recipe, start), start);
    let rows = runs.of_force(0, &features);
    let splits = Splits::new(&rows, recipe, runs.interval_s.1);
    let judged = candidates(recipe).into_iter();
    let judged = judged.map(|candidate| judge(candidate, &rows, &splits, recipe, true));
    let judged: Vec<Judged> = judged.map(|judged| judged.expect("judged")).collect();
    Ranking::new(judged, splits.by)
}

/// Rows of the suspect samples, and their columns.
fn suspects(runs: &Runs) -> Vec<(usize, MeasuredColumn)> {
    let samples = runs.suspects.iter().flatten();
    samples.map(|sample| (sample.row, sample.column)).collect()
}

/// RMSE of the chosen model: of all tested rows, and of those that aren't suspect.
fn errors(ranking: &Ranking) -> (f64, f64) {
    let chosen = ranking.chosen().expect("a best one");
    assert_ne!(chosen.candidate.kind, Kind::Mean, "useless");
    // Whatever is learnt from, every row is tested.
    assert_eq!(chosen.left_out(ranking.by).len(), ROWS);
    let figures = chosen.on(ranking.by).expect("figures");
    (figures.rmse, figures.choosing().rmse)
}

/// RMSE of a line in the signals without any spike.
fn error_of_a_clean_line() -> f64 {
    let recipe = recipe(SuspectRows::Keep, None);
    let runs = runs_of(&recipe, &ONE_SPIKE.replace("10000", READING));
    let ranking = ranked(&recipe, &runs);
    let line = Candidate {
        kind: Kind::Ridge,
        features: FeatureSet::Raw,
    };
    let found = ranking.judged.iter().find(|of| of.candidate == line);
    found.map_or(0.0, |line| line.choosing_rmse(ranking.by))
}

#[test]
fn a_spike_of_one_row_or_two_ruins_no_choice() {
    let line = error_of_a_clean_line();
    let two = ONE_SPIKE.replace("0.700,-0.0174", "0.700,-9000");
    for (text, rows) in [(ONE_SPIKE, 1), (&two, 2)] {
        for (treated, outlier_z) in [
            (SuspectRows::Keep, None),
            (SuspectRows::LeaveOut, None),
            (SuspectRows::Keep, Some(4.0)),
        ] {
            let recipe = recipe(treated, outlier_z);
            let runs = runs_of(&recipe, text);
            let expected = (SPIKE..SPIKE + rows).map(|row| (row, MeasuredColumn::Signal(0)));
            assert_eq!(suspects(&runs), expected.collect::<Vec<_>>());
            let (all, sound) = errors(&ranked(&recipe, &runs));
            // A process stays better than a line that saw no spike.
            assert!(
                sound < line,
                "{treated:?} {outlier_z:?}: {sound} for {line}"
            );
            // With the mean in place of the spike a row is off by the range of the forces, 1.95 N, at most.
            let most = (sound.powi(2) + rows as f64 * 1.95f64.powi(2) / ROWS as f64).sqrt();
            assert!(all <= most, "{treated:?} {outlier_z:?}: {all} for {most}");
        }
    }
}

#[test]
fn a_spike_widens_no_range() {
    let recipe = recipe(SuspectRows::Keep, None);
    let ranges = |text: &str| {
        let runs = runs_of(&recipe, text);
        let settings = runs.stream_settings(&recipe, Start::First);
        let features = runs.features(&settings, Start::First);
        let columns = 0..features.ncols();
        let of_features: Vec<(f64, f64)> = columns
            .map(|column| runs.feature_range(&features, column))
            .collect();
        (runs.ranges(&features), of_features, runs.zero())
    };
    let (clean, of_features, zero) = ranges(&ONE_SPIKE.replace("10000", READING));
    let (spiked, of_spiked, zero_of_spiked) = ranges(ONE_SPIKE);
    // The spiked row's own reading is at neither end.
    assert_eq!((spiked, zero_of_spiked), (clean, zero));
    for ((low, high), (clean_low, clean_high)) in of_spiked.iter().zip(&of_features) {
        assert!(clean_low <= low && high <= clean_high);
    }
}

#[test]
fn a_spike_of_the_force_is_left_out_of_learning_where_it_is_asked() {
    let text = ONE_SPIKE.replace("10000", READING).replace("1.1612", "500");
    let recipe = recipe(SuspectRows::LeaveOut, None);
    let runs = runs_of(&recipe, &text);
    assert_eq!(suspects(&runs), [(SPIKE, MeasuredColumn::Force(0))]);
    let (all, sound) = errors(&ranked(&recipe, &runs));
    assert!(sound < error_of_a_clean_line());
    // The row is off by what its reference is: 500 N less its force, within what a line is off by.
    assert!(
        (all - (500.0 - 1.1612) / (ROWS as f64).sqrt()).abs() < 0.1,
        "{all}"
    );
    // A run's zero is that of its unloaded rows, which a spike of the force doesn't make of all.
    let clean = runs_of(&recipe, &ONE_SPIKE.replace("10000", READING));
    assert_eq!(runs.zero(), clean.zero());
}

#[test]
fn where_nothing_is_suspect_nothing_changes() {
    let text = ONE_SPIKE.replace("10000", READING);
    let of = |treated: SuspectRows| {
        let recipe = recipe(treated, None);
        let runs = runs_of(&recipe, &text);
        assert_eq!(suspects(&runs), []);
        ranked(&recipe, &runs)
    };
    let kept = of(SuspectRows::Keep);
    assert_eq!(kept, of(SuspectRows::LeaveOut));
    let mut figures = kept.judged.iter().filter_map(|judged| judged.on(kept.by));
    assert!(figures.all(|figures| figures.sound.is_none()));
}
