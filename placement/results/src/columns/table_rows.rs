//! Rows of an answer's tables, serialised: what the pointers of columns go into.

use estimation::recipe::SplitKind;
use serde::Serialize;
use serde_json::{Value, json};

use crate::{
    AlikeError, DriftError, ElsewhereError, ForceError, RankedLayout, SplitError, StudyResult,
};

/// A part of an answer as JSON; null where it can't be said, which none of ours is.
fn of(part: impl Serialize) -> Value {
    serde_json::to_value(part).unwrap_or_default()
}

/// A row for each strain and input.
pub fn indices(result: &StudyResult) -> Vec<Value> {
    let mut rows = Vec::new();
    for output in &result.outputs {
        let whole = of(output);
        for (k, input) in result.inputs.iter().enumerate() {
            let at = |list: &Option<Vec<f64>>| list.as_ref().and_then(|list| list.get(k)).copied();
            rows.push(json!({
                "output": whole,
                "input": input,
                "own": {
                    "first_order": at(&output.first_order),
                    "total": at(&output.total),
                    "mdrm_first_order": at(&output.mdrm_first_order),
                },
            }));
        }
    }
    rows
}

/// A row for each ranked location.
pub fn locations(result: &StudyResult) -> Vec<Value> {
    let row = |location| json!({ "location": location });
    result.locations.iter().map(row).collect()
}

/// A row for each ranked layout.
pub fn layouts(result: &StudyResult) -> Vec<Value> {
    let unit = signal_unit(result);
    let layouts = result.layouts.iter();
    layouts.map(|layout| self::layout(layout, unit)).collect()
}

/// A row for each number of films of the answer's trade.
pub fn trade(result: &StudyResult) -> Vec<Value> {
    let trades = result
        .answer
        .iter()
        .filter_map(|answer| answer.trade.as_ref());
    let rows = trades.flat_map(|trade| &trade.rows);
    rows.map(|row| json!({ "trade": row })).collect()
}

/// A row for each film of the answer.
pub fn films(result: &StudyResult) -> Vec<Value> {
    let films = result.answer.iter().flat_map(|answer| &answer.films);
    films.map(|film| json!({ "film": film })).collect()
}

/// A layout's row.
pub fn layout(layout: &RankedLayout, unit: Option<&str>) -> Value {
    let scores = RankedLayout {
        // Two thirds of a layout, and no column's.
        loads: Vec::new(),
        force_error: None,
        ..layout.clone()
    };
    let mut row = json!({ "layout": scores, "unit": unit });
    // Documents leave it out where it is false.
    row["layout"]["staggered"] = layout.staggered.into();
    row
}

/// A row for each kind of film.
pub fn candidates(result: &StudyResult) -> Vec<Value> {
    let unit = signal_unit(result);
    let findings = result.layout_findings.iter();
    let films = findings.flat_map(|findings| &findings.candidates);
    films
        .map(|film| json!({ "film": film, "unit": unit }))
        .collect()
}

/// A row for each film and pressing; none where the study asks for no signals.
pub fn signals(result: &StudyResult) -> Vec<Value> {
    let rows = result.signals.iter().flat_map(|signals| &signals.rows);
    rows.map(|row| json!({ "row": row })).collect()
}

/// A row for each layout and force; none where the study has no rig.
pub fn forces(result: &StudyResult) -> Vec<Value> {
    let mut rows = Vec::new();
    for layout in &result.layouts {
        let known = layout.force_error.iter().flatten();
        rows.extend(known.map(|force| self::force(layout, force)));
    }
    rows
}

/// The row of a layout and a force.
pub fn force(layout: &RankedLayout, force: &ForceError) -> Value {
    json!({
        "layout": { "rank": layout.rank, "film_count": layout.film_count },
        "force": force,
        "left_out": left_out(force),
    })
}

/// The row of a force on another tire.
pub fn force_on(other: &ElsewhereError, force: &ForceError) -> Value {
    json!({ "other": other, "force": force })
}

/// The row of a force with another drift.
pub fn force_with(drift: &DriftError, force: &ForceError) -> Value {
    json!({ "drift": drift, "force": force })
}

/// The row of a force where contacts are alike: as one with another drift.
pub fn force_alike(alike: &AlikeError, force: &ForceError) -> Value {
    json!({ "drift": alike, "force": force })
}

/// Error on runs that were left out, or cycles of one run.
fn left_out(force: &ForceError) -> Option<&SplitError> {
    let by = |kind: SplitKind| force.splits.iter().find(|split| split.by == kind);
    by(SplitKind::Cycle).or_else(|| by(SplitKind::Run))
}

/// The unit of films' signals.
fn signal_unit(result: &StudyResult) -> Option<&str> {
    let findings = result.layout_findings.as_ref();
    findings.map(|findings| findings.unit.as_str())
}
