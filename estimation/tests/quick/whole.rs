//! Estimates of a run that nobody learnt from, from recordings on.

use estimation::estimator::{Estimator, FORMAT, FeatureRanges, ForceModel, Stream, VERSION};
use estimation::fit_report::Ranking;
use estimation::live::live_estimates::Live;
use estimation::recipe::{
    AnnSettings, CycleRule, FeatureSet, Features, GprSettings, Kind, Models, Preprocess, Recipe,
    SplitKind, StartValue,
};
use estimation::recording::Recording;
use estimation::recording::named_columns::NamedColumns;
use estimation::rows::{Runs, Start};
use estimation::validation::{Judged, Splits, blend, candidates, judge, rolled, rolled_r2};

use rand::RngExt;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;

use crate::virtual_rig::run;

fn names() -> NamedColumns {
    NamedColumns {
        time: "time_s".to_owned(),
        signals: (1..=4).map(|channel| format!("s{channel}")).collect(),
        forces: vec!["fz_n".to_owned()],
        cycle: None,
        time_unit: None,
        converted: Vec::new(),
    }
}

fn recipe() -> Recipe {
    let mut recipe = Recipe {
        features: Features {
            sets: vec![FeatureSet::Raw, FeatureSet::All],
            window_rows: 5,
            ..Features::default()
        },
        models: Models {
            gpr: GprSettings {
                restarts: 3,
                search_rows: 80,
                most_rows: 150,
                ..GprSettings::default()
            },
            ann: AnnSettings {
                layers: vec![6],
                iterations: 60,
                networks: 2,
                ..AnnSettings::default()
            },
            ..Models::default()
        },
        preprocess: Preprocess {
            start_value: StartValue::Subtract,
            ..Preprocess::default()
        },
        ..Recipe::default()
    };
    recipe.columns.cycles = CycleRule::ThresholdN(1.0);
    recipe
}

/// Judges all candidates and learns the best from all rows.
fn fitted(recipe: &Recipe, recordings: Vec<Recording>) -> (Estimator, Ranking, Runs) {
    let runs = Runs::new(recipe, names(), recordings).expect("runs");
    let settings = runs.stream_settings(recipe, Start::First);
    let features = runs.features(&settings, Start::First);
    let rows = runs.of_force(0, &features);
    let splits = Splits::new(&rows, recipe, runs.interval_s.1);
    let judged = candidates(recipe)
        .into_iter()
        .map(|candidate| judge(candidate, &rows, &splits, recipe, true).expect("judged"));
    let mut judged: Vec<Judged> = judged.collect();
    judged.extend(blend(&judged, splits.by, &rows, recipe));
    let ranking = Ranking::new(judged, splits.by);
    let chosen = ranking.chosen().expect("a best one");
    let forces = vec![ForceModel::learn(chosen, splits.by, &rows, recipe).expect("learns")];
    let estimator = Estimator {
        format: FORMAT.to_owned(),
        version: VERSION,
        columns: names(),
        stream: Stream::new(&runs, recipe, Start::First),
        zero: runs.zero(),
        interval_s: runs.interval_s,
        ranges: runs.ranges(&features),
        feature_ranges: FeatureRanges::of(&forces, &runs, &features),
        relations: runs.relations(),
        promise: splits.by,
        forces,
        recipe: recipe.clone(),
    };
    let of_member = |member| rolled(member, &rows, &splits, recipe).expect("rolled");
    let rolled: Vec<_> = chosen.members.iter().copied().map(of_member).collect();
    let rolled = rolled_r2(&rolled).expect("varies");
    assert!(
        rolled < 0.2,
        "forces that don't belong to the signals are estimated with R2 {rolled}"
    );
    (estimator, ranking, runs)
}

/// RMSE and the share of rows within their intervals.
fn tried(estimator: &Estimator, recording: &Recording) -> (f64, f64) {
    let mut live = Live::new(estimator);
    let (mut squares, mut inside) = (0.0, 0.0);
    for row in 0..recording.rows() {
        let found = live.push(
            recording.time_s[row],
            None,
            &recording.signals.row(row).to_vec(),
        );
        let truth = recording.forces[[row, 0]];
        let estimate = found[0].forces[0];
        squares += (estimate.force - truth).powi(2);
        inside += f64::from((estimate.low..=estimate.high).contains(&truth));
    }
    let rows = recording.rows() as f64;
    ((squares / rows).sqrt(), inside / rows)
}

#[test]
fn claims_hold_on_a_run_that_nobody_learnt_from() {
    let recipe = recipe();
    let (estimator, ranking, _) =
        fitted(&recipe, (1..=3).map(|session| run(session, 300)).collect());
    assert_eq!(ranking.by, SplitKind::Run);
    let claimed = ranking
        .chosen()
        .and_then(|chosen| chosen.on(SplitKind::Run))
        .expect("figures");
    assert!(claimed.r2.expect("varies") > 0.95);
    for session in 4..8 {
        let (rmse, inside) = tried(&estimator, &run(session, 300));
        assert!(
            rmse < 2.5 * claimed.rmse && claimed.rmse < 2.5 * rmse,
            "{rmse} for {}",
            claimed.rmse
        );
        assert!(inside > 0.85, "{inside}");
    }
    let random = ranking
        .chosen()
        .and_then(|chosen| chosen.on(SplitKind::Random))
        .expect("figures");
    assert!(
        random.rmse < claimed.rmse,
        "a random split sees the run that it is tested on"
    );
}

#[test]
fn signals_that_know_nothing_are_called_useless() {
    let mut recordings: Vec<Recording> = (1..=2).map(|session| run(session, 200)).collect();
    let mut generator = ChaCha8Rng::seed_from_u64(5);
    for recording in &mut recordings {
        recording
            .signals
            .mapv_inplace(|_| generator.random_range(-1.0..1.0));
    }
    let mut recipe = recipe();
    recipe.models.kinds = vec![Kind::Ridge, Kind::Gpr];
    let (estimator, ranking, _) = fitted(&recipe, recordings);
    assert_eq!(
        ranking.chosen().map(|chosen| chosen.candidate.kind),
        Some(Kind::Mean)
    );
    assert!(ranking.notes("fz_n")[0].starts_with("fz_n: useless"));
    assert_eq!(estimator.forces[0].members[0].candidate().kind, Kind::Mean);
}

#[test]
fn what_is_learnt_and_said_is_the_same_to_the_bit() {
    let recipe = recipe();
    let recordings = || vec![run(1, 200), run(2, 200)];
    let (estimator, ..) = fitted(&recipe, recordings());
    let (again, ..) = fitted(&recipe, recordings());
    let text = serde_json::to_string(&estimator).expect("a text");
    assert_eq!(text, serde_json::to_string(&again).expect("a text"));
    let mut read: Estimator = serde_json::from_str(&text).expect("reads");
    read.prepare().expect("can be used");
    let recording = run(3, 100);
    let said = |estimator: &Estimator| {
        let mut live = Live::new(estimator);
        let rows = (0..recording.rows()).flat_map(|row| {
            live.push(
                recording.time_s[row],
                None,
                &recording.signals.row(row).to_vec(),
            )
        });
        rows.collect::<Vec<_>>()
    };
    assert_eq!(said(&estimator), said(&read));
}

#[test]
fn what_cannot_be_learnt_from_says_all_that_is_wrong() {
    let mut dead = run(1, 100);
    dead.signals.column_mut(2).fill(1.0);
    dead.forces.fill(f64::NAN);
    let mut recipe = recipe();
    recipe.validation.by = Some(SplitKind::Run);
    let refusals = Runs::new(&recipe, names(), vec![dead]).expect_err("refused");
    let told: Vec<&str> = refusals
        .iter()
        .map(|refusal| refusal.detail.as_str())
        .collect();
    for part in [
        "signal s3 is dead",
        "fz_n was measured in no row",
        "cycles",
        "one run",
    ] {
        assert!(
            told.iter().any(|told| told.contains(part)),
            "{part}: {told:?}"
        );
    }
    let mut fast = run(2, 100);
    fast.time_s.iter_mut().for_each(|t| *t *= 0.5);
    let refusals = Runs::new(&recipe, names(), vec![run(1, 100), fast]).expect_err("rates");
    assert!(
        refusals[0]
            .detail
            .contains("rates from 20.0000 to 40.0000 Hz"),
        "{}",
        refusals[0].detail
    );
}

/// A run that is loaded in every second row; signals are then 1 or -1 in turn, and else `unloaded` or its opposite.
fn returning(unloaded: f64, first_force: f64) -> Recording {
    let mut made = run(1, 401);
    for row in 1..made.rows() {
        let (force, size) = if row % 2 == 0 {
            (10.0, 1.0)
        } else {
            (0.0, unloaded)
        };
        let sign = if row % 4 < 2 { 1.0 } else { -1.0 };
        made.forces[[row, 0]] = force;
        made.signals.row_mut(row).fill(sign * size);
    }
    made.forces[[0, 0]] = first_force;
    made.signals.row_mut(0).fill(0.0);
    made
}

#[test]
fn a_first_reading_is_taken_off_one_run_where_signals_come_back_to_it() {
    let auto = |recording: Recording| {
        let runs = Runs::new(&recipe(), names(), vec![recording]).expect("a run");
        runs.start(&Recipe::default())
    };
    // u away from the first reading without a force, of a deviation root((u^2 + 1) / 2): the share is 1/2 at u = 1 / root 7 = 0.378, the first of the 401 rows apart.
    assert_eq!(auto(returning(0.37, 0.0)), Some(Start::First));
    assert_eq!(auto(returning(0.385, 0.0)), Some(Start::Kept));
    assert_eq!(auto(returning(0.37, 10.0)), Some(Start::Kept));
    let two = vec![run(1, 200), run(2, 200)];
    let runs = Runs::new(&recipe(), names(), two).expect("runs");
    assert_eq!(runs.start(&Recipe::default()), None);
}

#[test]
fn rows_that_a_spike_in_their_window_moves_are_told_as_outside() {
    let mut recipe = recipe();
    recipe.features.sets = vec![FeatureSet::All];
    let (estimator, ..) = fitted(&recipe, (1..=2).map(|session| run(session, 300)).collect());
    let clean = run(3, 300);
    let mut spiked = clean.clone();
    spiked.signals[[150, 0]] = 500.0;
    let answers = |recording: &Recording| {
        let mut live = Live::new(&estimator);
        let rows = (0..recording.rows()).map(|row| {
            let signals = recording.signals.row(row).to_vec();
            live.push(recording.time_s[row], None, &signals).remove(0)
        });
        rows.collect::<Vec<_>>()
    };
    let (clean, spiked) = (answers(&clean), answers(&spiked));
    let mut moved = 0;
    for (clean, spiked) in clean.iter().zip(&spiked) {
        let [right, found] = [clean.forces[0], spiked.forces[0]];
        if !(right.low..=right.high).contains(&found.force) {
            assert!(spiked.outside, "{found:?} for {right:?}");
            moved += 1;
        }
    }
    // As many as a window of five rows holds.
    assert_eq!(moved, 5);
    let outside = clean.iter().filter(|row| row.outside).count();
    assert!(outside <= 9, "{outside} of 300 clean rows");
}
