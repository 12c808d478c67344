//! Solves a rig's table, after all else of a study, lets estimators learn from the rig's runs, and puts what they show into the result.

use std::sync::atomic::Ordering;

use crate::points::RunContext;
use crate::points::RunError;
use crate::points::worker_threads::in_parallel;
use crate::response_table::study_table::StudyTable;
use crate::response_table::table_solving::TestedTable;
use documents::rig::rig_settings::{RigSettings, TireVariant};
use documents::study::Study;
use documents::study::plan::Plan;
use results::{ForceError, ForceFindings, RankedLayout, StudyResult, TableReport};
use rig::force_error::assumed_rig::assumed;
use rig::force_error::force_prices::force_prices;
use rig::force_error::fresh_trials::OtherTire;
use rig::force_error::layout_forces::force_errors;

/// Fills in a result's forces. The points have ordinals from `first` on.
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
    let Some(rig) = &study.rig else {
        return Ok(());
    };
    let mut forces = ForceFindings::default();
    match StudyTable::of(study, rig, plan) {
        Err(reason) => forces.reasons.push(reason),
        Ok(table) => {
            let tested = table.solved_from(first, plan, context)?;
            result.cost.table_solves = table.solves();
            match tested {
                Ok(tested) => {
                    let mut others = Vec::new();
                    for (tire, other) in table.others_solved_from(first, plan, context)? {
                        match other {
                            Ok(other) => others.push((tire, other)),
                            Err(reason) => forces.reasons.push(format!(
                                "Nothing was tried on the other tire ({}): {reason}",
                                tire.described()
                            )),
                        }
                    }
                    let errors = errors(&table, &tested, &others, rig, context)?;
                    put(&table, errors, &mut result.layouts);
                    forces.price = force_prices(&result.layouts);
                    forces.table = Some(report(&table, &tested));
                    forces.assumed = assumed(rig, &study.layouts.contacts.laws);
                }
                Err(reason) => forces
                    .reasons
                    .push(format!("There is no table of responses: {reason}")),
            }
        }
    }
    result.forces = Some(forces);
    Ok(())
}

/// Learns how well each of the study's layouts tells the forces, in their order; on all threads, each layout on one.
fn errors(
    table: &StudyTable,
    tested: &TestedTable,
    others: &[(TireVariant, TestedTable)],
    rig: &RigSettings,
    context: RunContext<'_>,
) -> Result<Vec<Vec<ForceError>>, RunError> {
    let of = |layout: usize| {
        let films = table.laid(tested, &table.layouts[layout].arrangement.films);
        let others = others.iter();
        let others: Vec<_> = others
            .map(|(tire, other)| OtherTire {
                described: tire.described(),
                learnt: tire.learnt,
                response: films.on(&other.table),
            })
            .collect();
        force_errors(&films, &others, rig, context.stop)
    };
    let found = in_parallel(table.layouts.len(), context.threads, context.stop, of);
    let all = found.and_then(|found| found.into_iter().collect::<Option<Vec<_>>>());
    all.filter(|_| !context.stop.load(Ordering::Relaxed))
        .ok_or(RunError::Stopped)
}

/// Puts them beside the ranked layouts that they belong to. Layouts that a search found are none of the study's own.
fn put(table: &StudyTable, errors: Vec<Vec<ForceError>>, ranked: &mut [RankedLayout]) {
    for (layout, errors) in table.layouts.iter().zip(errors) {
        let found = ranked
            .iter_mut()
            .find(|row| row.is_same(&layout.label) && row.force_error.is_none());
        if let Some(row) = found {
            row.force_error = Some(errors);
        }
    }
}

fn report(table: &StudyTable, tested: &TestedTable) -> TableReport {
    let settings = table.settings();
    TableReport {
        level: settings.level.as_str().to_owned(),
        largest_load_n: settings.largest_load_n,
        largest_shift_mm: settings.largest_shift_mm,
        solves: table.own_solves(),
        error: tested.error,
        films: tested.films.clone(),
    }
}
