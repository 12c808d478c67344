//! Checks for every recording and every model file that a reader is given, whatever is in it: no panic, and faults that say where.
//!
//! The fuzzer calls these with texts of its own making, `estimation/tests/quick/fuzzed.rs` with those that it kept.

use estimation::estimator::Estimator;
use estimation::live::live_estimates::Live;
use estimation::recipe::{Columns, CycleRule, Recipe};
use estimation::recording::Recording;
use estimation::recording::csv_recording::{header, read};
use estimation::recording::dialect::usual;
use estimation::recording::named_columns::NamedColumns;
use estimation::recording::recording_fault::{MOST_FAULTS, RecordingFault};
use estimation::rows::{Runs, Start};

/// A recording is refused with its faults, or has rows in the order of time whose features are finite, whatever makes its cycles.
pub fn recording(text: &str) {
    let (file, text) = ("r.csv", &*usual(text));
    let header = match header(file, text) {
        Ok(header) => header,
        Err(faults) => return say_where_of_recording(&faults),
    };
    let rules = [
        CycleRule::Tenths,
        CycleRule::PauseS(0.5),
        CycleRule::ThresholdN(1.0),
        CycleRule::BlockS(0.3),
        CycleRule::Column("c".to_owned()),
    ];
    for (number, cycles) in rules.into_iter().enumerate() {
        let mut recipe = Recipe {
            columns: Columns {
                cycles,
                ..Columns::default()
            },
            ..Recipe::default()
        };
        recipe.preprocess.rate_hz = (number == 1).then_some(10.0);
        let names = NamedColumns::find(&recipe.columns, [&header]);
        match read(
            file,
            text,
            &recipe.columns,
            &names,
            recipe.preprocess.rate_hz.is_some(),
        ) {
            Ok(recording) => learnable(&recipe, names, recording),
            Err(faults) => say_where_of_recording(&faults),
        }
    }
}

/// Recordings longer than this on a clock of their own take longer than a fuzzer should wait.
const LONGEST_S: f64 = 1e4;

fn learnable(recipe: &Recipe, names: NamedColumns, recording: Recording) {
    assert!(recording.time_s.windows(2).all(|pair| pair[0] < pair[1]));
    let span = recording.time_s.last().unwrap_or(&0.0) - recording.time_s.first().unwrap_or(&0.0);
    if recipe.preprocess.rate_hz.is_some() && span > LONGEST_S {
        return;
    }
    match Runs::new(recipe, names, vec![recording]) {
        Ok(runs) => {
            // Whether there are any depends on the rows; they are checked where they are made.
            runs.relations();
            for start in [Start::Kept, Start::First, Start::Unloaded] {
                let settings = runs.stream_settings(recipe, start);
                let features = runs.features(&settings, start);
                assert!(features.iter().all(|x| x.is_finite()));
            }
        }
        Err(refusals) => assert!(
            !refusals.is_empty() && refusals.iter().all(|refusal| !refusal.detail.is_empty())
        ),
    }
}

fn say_where_of_recording(faults: &[RecordingFault]) {
    assert!((1..=MOST_FAULTS + 1).contains(&faults.len()));
    assert!(
        faults
            .iter()
            .all(|fault| fault.to_string().starts_with("r.csv") && !fault.detail.is_empty())
    );
}

/// A model is refused with a sentence, or answers rows of signals, and its text reads back as the same model.
pub fn model(text: &str) {
    let Ok(mut estimator) = serde_json::from_str::<Estimator>(text) else {
        return;
    };
    if let Err(refused) = estimator.prepare() {
        return assert!(!refused.is_empty());
    }
    let again = serde_json::to_string(&estimator).expect("a model that was read has a text");
    let mut again: Estimator = serde_json::from_str(&again).expect("reads back");
    assert_eq!(again.prepare(), Ok(()));
    assert_eq!(again, estimator);
    let signals = vec![0.5; estimator.columns.signals.len()];
    let mut live = Live::new(&estimator);
    for row in 0..3 {
        for estimated in live.push(f64::from(row), None, &signals) {
            assert_eq!(estimated.forces.len(), estimator.columns.forces.len());
        }
    }
}
