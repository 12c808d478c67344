//! Solves a rig's table, after all else of a study, lets estimators learn from the rig's runs, and puts what they show into the result.

use std::sync::atomic::Ordering;

use crate::layout::ranking::asked_layouts::is_published;
use crate::layout::solving::on_threads::in_parallel;
use crate::response_table::force_prices::force_prices;
use crate::response_table::study_table::StudyTable;
use crate::response_table::table_solving::TestedTable;
use crate::result::{
    ForceError, ForceFindings, PublishedTables, RankedLayout, StudyResult, TableReport,
};
use crate::rig::force_error::assumed_rig::assumed;
use crate::rig::force_error::fresh_trials::OtherTire;
use crate::rig::force_error::layout_forces::force_errors;
use crate::rig::published::published_gaits;
use crate::rig::published::rig_tables::RigTables;
use crate::rig::rig_settings::{RigSettings, TireVariant};
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
                    forces.published = published(&table, &tested, rig, result, context)?;
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
    let found = in_parallel(table.layouts.len(), context, of);
    let all = found.and_then(|found| found.into_iter().collect::<Option<Vec<_>>>());
    all.filter(|_| !context.stop.load(Ordering::Relaxed))
        .ok_or(RunError::Stopped)
}

/// The published study's tables where they are asked for, on all threads.
fn published(
    table: &StudyTable,
    tested: &TestedTable,
    rig: &RigSettings,
    result: &StudyResult,
    context: RunContext<'_>,
) -> Result<Option<PublishedTables>, RunError> {
    let its = table.layouts.iter().find(|layout| is_published(layout));
    let Some(layout) = its.filter(|_| rig.paper_tables) else {
        return Ok(None);
    };
    let films = table.laid(tested, &layout.arrangement.films);
    let found = RigTables::recorded(&films, rig, context.stop).and_then(|tables| {
        let pieces = in_parallel(tables.pieces(), context, |piece| {
            tables.piece(piece, context.stop)
        })?;
        Some(tables.tables(pieces.into_iter().collect::<Option<_>>()?))
    });
    let (rows, time_constants) = found.ok_or(RunError::Stopped)?;
    let ranked = result.layouts.iter().find(|row| row.is_same(&layout.label));
    Ok(Some(PublishedTables {
        layout_rank: ranked.map_or(0, |row| row.rank),
        rows,
        time_constants,
        assumed: published_gaits::assumed(),
    }))
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
