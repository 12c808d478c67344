//! Tables of what a virtual rig shows.

use estimation::recipe::SplitKind;
use placement::result::{
    ForceError, PublishedRow, RankedLayout, RigFigures, SplitError, StudyResult, TrialError,
};

use super::table::Rows;
use super::unit::{PERCENT, PURE};

/// A layout and how well it tells one force.
pub type Known<'r> = (&'r RankedLayout, &'r ForceError);

/// Each force by each layout; no row where the study has no rig.
pub fn forces(result: &StudyResult) -> Rows<Known<'_>> {
    let rows = Rows::of(result.layouts.iter().flat_map(known))
        .integer("layout_rank", |(layout, _)| Some(layout.rank))
        .integer("films", |(layout, _)| layout.film_count)
        .text("force", |(_, force)| Some(&force.axis))
        .text("chosen", |(_, force)| Some(force.chosen.as_str()))
        .text("features", |(_, force)| Some(force.features.as_str()))
        .bool("useful", |(_, force)| Some(force.useful))
        .float("leak", PURE, |(_, force)| force.leak)
        .float("bound_n", "N", |(_, force)| force.floor_n);
    let rows = trial(rows, "fresh", |force| Some(force.fresh));
    let rows = trial(rows, "dead", |force| Some(force.dead?.error));
    let rows = trial(rows, "askew", |force| Some(force.askew.error));
    rows.float("left_out_rmse_n", "N", |(_, force)| left_out(force)?.rmse_n)
        .float("left_out_nrmse_percent", PERCENT, |(_, force)| {
            left_out(force)?.nrmse_percent
        })
        .float("mean_nrmse_percent", PERCENT, |(_, force)| {
            left_out(force)?.mean_nrmse_percent
        })
        .float("worst_contact_deg", "deg", |(_, force)| {
            Some(force.worst_contact?.deg)
        })
        .float("worst_contact_rmse_n", "N", |(_, force)| {
            Some(force.worst_contact?.rmse_n)
        })
        .text("reason", |(_, force)| force.reason.as_deref())
}

fn known(layout: &RankedLayout) -> impl Iterator<Item = Known<'_>> {
    let known = layout.force_error.iter().flatten();
    known.map(move |force| (layout, force))
}

/// On runs that were left out, or cycles of one run.
fn left_out(force: &ForceError) -> Option<&SplitError> {
    let by = |kind: SplitKind| force.splits.iter().find(|split| split.by == kind);
    by(SplitKind::Cycle).or_else(|| by(SplitKind::Run))
}

fn trial<'r>(
    rows: Rows<Known<'r>>,
    name: &str,
    of: fn(&ForceError) -> Option<TrialError>,
) -> Rows<Known<'r>> {
    rows.float(format!("{name}_rmse_n"), "N", |(_, force)| {
        of(force)?.rmse_n
    })
    .float(format!("{name}_nrmse_percent"), PERCENT, |(_, force)| {
        of(force)?.nrmse_percent
    })
    .float(format!("{name}_r2"), PURE, |(_, force)| of(force)?.r2)
    .float(format!("{name}_coverage"), PURE, |(_, force)| {
        of(force)?.coverage
    })
}

/// The published tables beside the rig's; no row where the study doesn't ask for them.
pub fn published(result: &StudyResult) -> Rows<&PublishedRow> {
    let tables = result.forces.iter().filter_map(|it| it.published.as_ref());
    let rows = Rows::of(tables.flat_map(|tables| &tables.rows))
        .integer("table", |row| Some(row.table as usize))
        .text("gait", |row| Some(&row.gait))
        .text("model", |row| Some(row.model.as_str()))
        .text("features", |row| Some(row.features.as_str()))
        .text("force", |row| Some(&row.axis))
        .text("split", |row| Some(row.by.as_str()))
        .float("printed_nrmse_percent", PERCENT, |row| {
            Some(row.printed.nrmse_percent)
        })
        .float("printed_rmse_n", "N", |row| row.printed.rmse_n)
        .float("printed_r2", PURE, |row| row.printed.r2)
        .float("printed_mean_nrmse_percent", PERCENT, |row| {
            row.printed.mean_nrmse_percent
        })
        .text("contradiction", |row| {
            Some(&row.printed.contradiction.as_ref()?.detail)
        });
    let rows = of_rig(rows, "rig", |row| row.rig);
    of_rig(rows, "fresh", |row| row.fresh).text("reason", |row| row.reason.as_deref())
}

fn of_rig<'r>(
    rows: Rows<&'r PublishedRow>,
    name: &str,
    of: fn(&PublishedRow) -> Option<RigFigures>,
) -> Rows<&'r PublishedRow> {
    rows.float(format!("{name}_rmse_n"), "N", |row| Some(of(row)?.rmse_n))
        .float(format!("{name}_nrmse_percent"), PERCENT, |row| {
            of(row)?.nrmse_percent
        })
        .float(format!("{name}_mean_nrmse_percent"), PERCENT, |row| {
            of(row)?.mean_nrmse_percent
        })
        .float(format!("{name}_r2"), PURE, |row| of(row)?.r2)
}
