//! Solves a rig's table, after all else of a study, lets estimators learn from the rig's runs, and puts what they show into the result.

use std::sync::atomic::Ordering;

use crate::layout::solving::on_threads::in_parallel;
use crate::response_table::study_table::StudyTable;
use crate::response_table::table_solving::TestedTable;
use crate::result::{ForceError, ForceFindings, RankedLayout, StudyResult, TableReport};
use crate::rig::force_error::assumed_rig::assumed;
use crate::rig::force_error::layout_forces::force_errors;
use crate::rig::rig_settings::RigSettings;
use crate::run::{RunContext, RunError};
use crate::study::Study;
use crate::study::plan::Plan;

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
                    let errors = errors(&table, &tested, rig, context)?;
                    put(&table, errors, &mut result.layouts);
                    forces.table = Some(report(&table, &tested));
                    forces.assumed = assumed(rig);
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

/// How well each of the study's layouts tells the forces, in their order; on all threads, each layout on one.
fn errors(
    table: &StudyTable,
    tested: &TestedTable,
    rig: &RigSettings,
    context: RunContext<'_>,
) -> Result<Vec<Vec<ForceError>>, RunError> {
    let of = |layout: usize| {
        let films = table.laid(tested, &table.layouts[layout].arrangement.films);
        force_errors(&films, rig, context.stop)
    };
    let found = in_parallel(table.layouts.len(), context, of);
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
        solves: table.solves(),
        error: tested.error,
    }
}
