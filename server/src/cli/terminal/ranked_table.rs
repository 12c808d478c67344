//! The ranked table and the notes, for people.

use std::collections::BTreeMap;
use std::fmt::Write;

use fem_client::solver::direction::{Direction, PerDirection};
use placement::result::{RankedLocation, StudyResult};
use placement::score::location_scores::{GSI, MDRM_GSI, MEAN_GSI, OWN_GSI, Score};

use crate::cli::terminal::estimate_text::comparison;
use crate::cli::terminal::layout_table::layouts;
use crate::cli::terminal::paint::{BAD, FAINT, GOOD, HEADER, STRONG, header, painted};
use crate::cli::terminal::signal_table::signals;

/// Table 2 of the paper (Sensors 2025, 25, 4026): P1 to P5, x and y, percent.
const PAPER: [(&str, f64, f64); 5] = [
    ("P1", 1.4719, 0.0662),
    ("P2", 6.1071, 9.4910),
    ("P3", 29.9733, 32.1724),
    ("P4", 6.6748, 10.1924),
    ("P5", 1.5767, 0.0662),
];

/// Everything that `run` prints of a result.
pub fn report(result: &StudyResult) -> String {
    let mut text = ranked(result);
    text.push_str(&layouts(result));
    text.push_str(&signals(result));
    text.push_str(&notes(result));
    text.push_str(&climb(result));
    text.push_str(&cost(result));
    text.push_str(&comparison(result));
    text
}

/// One row per location, best first; equal ones share their rank. Global sensitivity indices in percent; the first pair with its error.
fn ranked(result: &StudyResult) -> String {
    let mut text = painted(HEADER, result.study.name.escape_debug()) + "\n\n";
    text.push_str(&header("                gsi: own depth, strain at         mean over all     strain at the     M-DRM's gsi,      paper's\n"));
    text.push_str(&header("                the centre, %, with its error     locations, %      location, %       valid or not, %   Table 2, %\n"));
    text.push_str(&header("rank  location         x               y             x       y         x       y         x       y         x       y   rank is\n"));
    for location in &result.locations {
        text.push_str(&row(location));
    }
    text
}

fn row(location: &RankedLocation) -> String {
    let paper = PAPER.iter().find(|(name, ..)| *name == location.name);
    let mut text = format!("{:4}  {:<8} ", location.rank, location.name);
    for gsi in location.scores.of_score(GSI).iter() {
        let error = gsi.error.map_or(String::new(), |e| format!("+-{e:.2}"));
        let _ = write!(text, "{} {error:<7} ", percent(gsi.value));
    }
    for score in [MEAN_GSI, OWN_GSI, MDRM_GSI] {
        let PerDirection { x, y } = location.scores.of_score(score);
        let _ = write!(text, " {} {} ", percent(x.value), percent(y.value));
    }
    let (x, y) = (paper.map(|(_, x, _)| *x), paper.map(|(_, _, y)| *y));
    let _ = write!(text, " {} {} ", percent(x), percent(y));
    let (style, rank_is) = match location.rank_certain {
        true => (STRONG, "certain"),
        false => (FAINT, "uncertain"),
    };
    let _ = writeln!(text, " {}", painted(style, rank_is));
    text
}

/// What M-DRM's numbers are worth beside the paper's, where they come close to it and the valid ones don't.
fn paper_remark(result: &StudyResult) -> Option<String> {
    let furthest = |score: &Score| {
        PAPER.iter().try_fold(0.0, |furthest: f64, (name, x, _)| {
            let location = result
                .locations
                .iter()
                .find(|location| location.name == *name)?;
            let index = location.value(score, Direction::X)?;
            Some(furthest.max((index - x).abs()))
        })
    };
    let mdrm = furthest(MDRM_GSI)?;
    let valid = furthest(GSI)?;
    (mdrm < 5.0 && valid > 2.0 * mdrm).then(|| {
        format!(
            "M-DRM's x column is within {mdrm:.1} points of the paper's Table 2, and it is wrong here: the circumferential \
             strain changes sign within the range of depths, so its product form is broken; the valid indices are up to \
             {valid:.1} points away from the paper's."
        )
    })
}

fn percent(number: Option<f64>) -> String {
    number.map_or_else(|| format!("{:>7}", "-"), |number| format!("{number:7.2}"))
}

fn notes(result: &StudyResult) -> String {
    let remark = paper_remark(result);
    let without = without_index(result);
    let notes = without.iter().chain(&remark).chain(&result.notes);
    notes.fold(String::from("\n"), |text, note| text + "- " + note + "\n")
}

/// Why dashes stand in the table: each reason why outputs have no index, with how many they are.
fn without_index(result: &StudyResult) -> Vec<String> {
    let mut counts: BTreeMap<&str, usize> = BTreeMap::new();
    let without = result
        .outputs
        .iter()
        .filter(|output| output.first_order.is_none());
    for reason in without.filter_map(|output| output.reason.as_deref()) {
        *counts.entry(reason).or_default() += 1;
    }
    let all = result.outputs.len();
    let sentence = |(reason, count)| format!("{count} of {all} outputs have no index: {reason}.");
    counts.into_iter().map(sentence).collect()
}

/// The way to the accuracy asked for, a line for each rung.
fn climb(result: &StudyResult) -> String {
    let Some(climb) = &result.climb else {
        return String::new();
    };
    let (met, missed) = (painted(GOOD, "is met"), painted(BAD, "is out of reach"));
    let mut text = match (climb.tolerance, climb.budget_s) {
        (Some(tolerance), _) if climb.met => format!("\nA tolerance of {tolerance} {met}:\n"),
        (Some(tolerance), _) => format!("\nA tolerance of {tolerance} {missed}:\n"),
        (None, budget) => format!("\nWithin {} s:\n", budget.unwrap_or_default()),
    };
    for (rung, wall_s) in climb.rungs.iter().zip(&result.cost.rungs_wall_s) {
        let error =
            |value: Option<f64>| value.map_or_else(|| "unknown".to_owned(), |e| format!("{e:.4}"));
        let _ = writeln!(
            text,
            "- {}: {} solves, {wall_s:.2} s; largest claimed error of an index {}, of the mesh {}",
            rung.label,
            rung.solves,
            error(rung.error_claimed),
            error(rung.error_of_mesh)
        );
    }
    text
}

fn cost(result: &StudyResult) -> String {
    let cost = &result.cost;
    let coarser = match cost.coarser_solves {
        0 => String::new(),
        solves => format!(", {solves} more on a coarser mesh for its error"),
    };
    let signals = match cost.signal_solves {
        0 => String::new(),
        solves => format!(", {solves} for films' signals"),
    };
    let layouts = match cost.layout_solves {
        0 => String::new(),
        solves => format!(", {solves} for layouts"),
    };
    format!(
        "\nwhole study {:.2} s; {} solves, {} of them known before{coarser}{layouts}{signals}; {} Newton iterations, {} factorisations\n\
         of the solves' time: factorisation {:.0} %, substitution and contact {:.0} %, assembly {:.0} %, the rest \
         {:.0} %\n",
        cost.wall_s,
        cost.solves,
        cost.reused,
        cost.newton_iterations,
        cost.factorisations,
        100.0 * cost.factorisation_share,
        100.0 * cost.substitution_share,
        100.0 * cost.assembly_share,
        100.0 * cost.other_share,
    )
}
