//! Solves a table's pressings as points of a study: stored, shared and resumed as all others.

use fem_client::scene::Scene;
use fem_client::solver::Response;

use crate::layout::solving::mirror_parts::mirrored;
use crate::points::Place;
use crate::points::RunContext;
use crate::points::RunError;
use crate::points::SceneSeries;
use crate::points::archive::Outcome;
use crate::points::outcomes;
use crate::response_table::differing_contacts::DifferingContacts;
use crate::response_table::drag_basis::DRAGS;
use crate::response_table::solved_table::ResponseTable;
use crate::response_table::table_error::table_error;
use crate::response_table::table_scenes::{Pressing, TableScenes};
use layouts::arrangement::FilmKind;
use results::{FilmAnglesReport, TableError};

/// A table with its error.
#[derive(Debug, Clone, PartialEq)]
pub struct TestedTable {
    /// The table.
    pub table: ResponseTable,
    /// Error of the table; None where a tested solve has no equilibrium.
    pub error: Option<TableError>,
    /// Wheel angles of glued films, which are an axis.
    pub films: Option<FilmAnglesReport>,
    /// Quantities that contacts differ in besides angle, depth and shift; none where they are alike.
    pub differing: Option<DifferingContacts>,
}

/// Pressings with what became of them, the undragged ones first.
pub(crate) type Solved = Vec<(Pressing, Outcome)>;

/// All that is solved for a table: two series, each of which starts from its first equilibrium, and what is read of them.
pub(crate) fn table_series(scenes: &TableScenes, kinds: &[FilmKind]) -> [SceneSeries; 2] {
    series(scenes).map(|pressings| {
        let scenes = pressings.iter().map(|pressing| scenes.scene(pressing));
        SceneSeries::from_first(scenes.collect(), mirrored(kinds))
    })
}

/// Undragged pressings, and dragged ones with those that test the table.
fn series(scenes: &TableScenes) -> [Vec<Pressing>; 2] {
    let tested = scenes.tested().concat();
    let is_dragged = scenes.settings().largest_shift_mm > 0.0;
    match is_dragged {
        true => [scenes.undragged(), [scenes.dragged(), tested].concat()],
        false => [[scenes.undragged(), tested].concat(), Vec::new()],
    }
}

/// Solves a table's pressings; the place moves behind their points.
///
/// # Errors
/// See [`RunError`]; within, why nothing was solved.
pub(crate) fn solve(
    scenes: &TableScenes,
    kinds: &[FilmKind],
    means: &[f64],
    place: &mut Place,
    context: RunContext<'_>,
) -> Result<Result<Solved, String>, RunError> {
    let mut solved: Solved = Vec::new();
    for pressings in series(scenes) {
        if pressings.is_empty() {
            continue;
        }
        let all: Vec<Scene> = pressings
            .iter()
            .map(|pressing| scenes.scene(pressing))
            .collect();
        match outcomes(&all, &mirrored(kinds), means, place, context)? {
            Ok(outcomes) => solved.extend(pressings.into_iter().zip(outcomes)),
            Err(reason) => return Ok(Err(reason)),
        }
    }
    Ok(Ok(solved))
}

/// The table and its error from what became of its pressings.
///
/// # Errors
/// Why there is no table.
pub(crate) fn tabulated(
    scenes: &TableScenes,
    kinds: &[FilmKind],
    solved: &Solved,
) -> Result<TestedTable, String> {
    let of = |pressing: &Pressing| -> Result<(Pressing, &Response), String> {
        let found = solved.iter().find(|(other, _)| other == pressing);
        let (_, outcome) = found.ok_or("it wasn't solved")?;
        match outcome {
            Ok(response) => Ok((*pressing, response)),
            Err(unsolved) => Err(format!(
                "{} N with shifts {:?} of the largest: {unsolved}",
                pressing.load_n, pressing.shares
            )),
        }
    };
    let undragged: Vec<_> = scenes
        .undragged()
        .iter()
        .map(of)
        .collect::<Result<_, _>>()?;
    let dragged: Vec<_> = scenes.dragged().iter().map(of).collect::<Result<_, _>>()?;
    debug_assert_eq!(dragged.len() % DRAGS.len(), 0);
    let table = ResponseTable::new(scenes.settings(), kinds, &undragged, &dragged)?;
    let pairs = scenes
        .tested()
        .into_iter()
        .map(|[low, high]| Some([of(&low).ok()?, of(&high).ok()?]));
    let pairs: Option<Vec<_>> = pairs.collect();
    let error = pairs.and_then(|pairs| table_error(&table, kinds, &pairs));
    Ok(TestedTable {
        table,
        error,
        films: None,
        differing: None,
    })
}
