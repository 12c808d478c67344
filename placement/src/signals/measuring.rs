//! Solves what signals ask for, after the study's own points, and puts what they show into its result.

use fem_client::scene::{Level, Scene};
use fem_client::solver::{Readout, Solver};

use crate::points::Place;
use crate::points::RunContext;
use crate::points::RunError;
use crate::points::{PointSeries, SceneSeries, Starts, outcomes_of};
use crate::signals::amplifier_notes::amplifier_notes;
use crate::signals::answers::{Answer, MeshAnswers};
use crate::signals::signal_claims::claims;
use crate::signals::signal_curves::curves;
use crate::signals::signal_rows::TireAnswers;
use documents::signals::series::Series;
use documents::signals::signal_settings::{OWN_TIRE, SignalSettings};
use documents::study::Study;
use documents::study::plan::Plan;
use results::{Signals, StudyResult};

/// Fills in a result's signals. The points have ordinals from `first` on.
///
/// # Errors
/// See [`RunError`]; the result is unchanged then.
pub(crate) fn measure(
    first: usize,
    study: &Study,
    plan: &Plan,
    result: &mut StudyResult,
    context: RunContext<'_>,
) -> Result<(), RunError> {
    let Some(settings) = &study.signals else {
        return Ok(());
    };
    let tires = tires(settings, study, plan);
    let solves = signal_series(study, plan, context.solver);
    let mut place = Place {
        first,
        of: first
            + solves
                .iter()
                .map(|series| series.scenes.len())
                .sum::<usize>(),
    };
    let mut signals = Signals::default();
    let values = &plan.values()[0];
    for (name, scene, settings) in &tires {
        let mut on_mesh =
            |level: Level| answers(settings, scene, level, values, &mut place, context);
        let fine = on_mesh(scene.model.level)?;
        let coarser = context.solver.coarser(scene);
        let coarse =
            coarser.map(|coarser| Ok::<_, RunError>((on_mesh(coarser.level)?, coarser.factor)));
        let tire = TireAnswers {
            name,
            scene,
            fine,
            coarse: coarse.transpose()?,
        };
        let rows = tire.rows(settings);
        signals.curves.extend(curves(&rows));
        signals.claims.extend(claims(&rows));
        signals.rows.extend(rows);
        signals.pairs.extend(tire.pairs(settings));
        signals.widths.extend(tire.widths(settings));
    }
    for note in amplifier_notes(settings, &signals.rows) {
        result.note(note);
    }
    result.cost.signal_solves = place.first - first;
    result.signals = Some(signals);
    Ok(())
}

/// The study's own tire at its means, and the further ones, each with its name and what is asked of it.
fn tires<'s>(
    settings: &'s SignalSettings,
    study: &Study,
    plan: &Plan,
) -> Vec<(&'s str, Scene, SignalSettings)> {
    let mut own = plan.points[0].clone();
    own.model.level = study.level;
    let further = settings.tires.iter().map(|tire| {
        (
            tire.name.as_str(),
            tire.scene.clone(),
            settings.of_tire(tire),
        )
    });
    std::iter::once((OWN_TIRE, own, settings.clone()))
        .chain(further)
        .collect()
}

/// All that is solved for a study's signals: the scenes of each series, and what is read of them.
pub(crate) fn signal_series(study: &Study, plan: &Plan, solver: &dyn Solver) -> Vec<SceneSeries> {
    let Some(settings) = &study.signals else {
        return Vec::new();
    };
    let mut all = Vec::new();
    for (_, tire, settings) in tires(settings, study, plan) {
        let coarser = solver.coarser(&tire).map(|coarser| coarser.level);
        for level in [Some(tire.model.level), coarser].into_iter().flatten() {
            let tire = on_level(&tire, level);
            let series = settings.series(&tire).into_iter();
            all.extend(series.map(|series| {
                let scenes = settings.scenes(&tire, &series);
                SceneSeries::from_first(scenes, settings.readout(&series))
            }));
        }
    }
    all
}

fn on_level(tire: &Scene, level: Level) -> Scene {
    let mut tire = tire.clone();
    tire.model.level = level;
    tire
}

/// Solves a tire on one mesh; the place moves behind its points.
fn answers<'s>(
    settings: &'s SignalSettings,
    tire: &Scene,
    level: Level,
    values: &[f64],
    place: &mut Place,
    context: RunContext<'_>,
) -> Result<MeshAnswers<'s>, RunError> {
    let tire = on_level(tire, level);
    let mut solved = Vec::new();
    for series in settings.series(&tire) {
        let answers = series_answers(settings, &tire, &series, values, place, context)?;
        solved.push((series, answers));
    }
    Ok(MeshAnswers::new(
        settings,
        solved,
        tire.pressure.internal_mpa,
    ))
}

/// Solves a series. Where its first scene has no equilibrium, all begin at the least load instead; where that has none either, nothing is solved.
fn series_answers(
    settings: &SignalSettings,
    tire: &Scene,
    series: &Series,
    values: &[f64],
    place: &mut Place,
    context: RunContext<'_>,
) -> Result<Vec<Answer>, RunError> {
    let scenes = settings.scenes(tire, series);
    let readout = settings.readout(series);
    let least = series.least_load();
    answers_from_first(&scenes, least, &readout, values, place, context)
}

/// Solves scenes that start from the first one's equilibrium, or, where that has none, from that of the `least` loaded one. The place moves behind them.
pub(crate) fn answers_from_first(
    scenes: &[Scene],
    least: Option<usize>,
    readout: &Readout,
    values: &[f64],
    place: &mut Place,
    context: RunContext<'_>,
) -> Result<Vec<Answer>, RunError> {
    let values = vec![values.to_vec(); scenes.len()];
    let begun_at = |begin: usize, place: Place| {
        let mut ordered = scenes.to_vec();
        ordered.swap(0, begin);
        let series = PointSeries {
            scenes: &ordered,
            starts: Starts::from_first(ordered.len()),
            values: &values,
            readout,
        };
        let mut outcomes = outcomes_of(series, place, context)?;
        outcomes.swap(0, begin);
        Ok::<_, RunError>(outcomes)
    };
    let mut found = begun_at(0, *place);
    place.first += scenes.len();
    if let (Err(RunError::PointsFailed { .. }), Some(least)) = (&found, least) {
        place.of += scenes.len();
        found = begun_at(least, *place);
        place.first += scenes.len();
    }
    match found {
        Ok(outcomes) => Ok(outcomes
            .into_iter()
            .map(|outcome| outcome.map_err(|unsolved| unsolved.to_string()))
            .collect()),
        // It costs the signals, not the study.
        Err(error @ (RunError::PointsFailed { .. } | RunError::Refused { .. })) => {
            Ok(vec![Err(error.to_string()); scenes.len()])
        }
        Err(error) => Err(error),
    }
}
