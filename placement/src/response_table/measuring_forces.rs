//! Solves a rig's table, after all else of a study, and puts what it shows into the result.

use crate::response_table::study_table::StudyTable;
use crate::response_table::table_solving::TestedTable;
use crate::result::{ForceFindings, StudyResult, TableReport};
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
                Ok(tested) => forces.table = Some(report(&table, &tested)),
                Err(reason) => forces
                    .reasons
                    .push(format!("There is no table of responses: {reason}")),
            }
        }
    }
    result.forces = Some(forces);
    Ok(())
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
