//! The ranked places, for people.

use std::fmt::Write;

use document::visible::visible;
use fem_client::solver::direction::PerDirection;
use results::location_scores::{GSI, MEAN_GSI, OWN_GSI};
use results::{RankedLocation, StudyResult};

use crate::cli::terminal::paint::{FAINT, HEADER, STRONG, header, painted};
use crate::cli::terminal::report::shared_rank::rank_cell;
use crate::cli::terminal::wrapping::{COLUMNS, cut};

/// Returns a row per location, best first; equal ones share their rank. Global sensitivity indices in percent; the first pair with its error.
pub fn ranked(result: &StudyResult) -> String {
    let name = cut(visible(&result.study.name), COLUMNS);
    let mut text = painted(HEADER, name) + "\n\n";
    text.push_str(&header(
        "                gsi: own depth, strain at         mean over all     strain at the\n",
    ));
    text.push_str(&header(
        "                the centre, %, with its error     locations, %      location, %\n",
    ));
    text.push_str(&header("rank  location         x               y             x       y         x       y   rank is\n"));
    let ranks = || result.locations.iter().map(|location| location.rank);
    for location in &result.locations {
        text.push_str(&row(location, &rank_cell(location.rank, ranks())));
    }
    text
}

fn row(location: &RankedLocation, rank: &str) -> String {
    let mut text = format!("{rank} {:<8} ", location.name);
    for gsi in location.scores.of_score(GSI).iter() {
        let error = gsi.error.map_or(String::new(), |e| format!("+-{e:.2}"));
        let _ = write!(text, "{} {error:<7} ", percent(gsi.value));
    }
    for score in [MEAN_GSI, OWN_GSI] {
        let PerDirection { x, y } = location.scores.of_score(score);
        let _ = write!(text, " {} {} ", percent(x.value), percent(y.value));
    }
    let (style, rank_is) = match location.rank_certain {
        true => (STRONG, "certain"),
        false => (FAINT, "uncertain"),
    };
    let _ = writeln!(text, " {}", painted(style, rank_is));
    text
}

/// Writes percent in seven columns; a dash where there is none.
fn percent(number: Option<f64>) -> String {
    number.map_or_else(|| format!("{:>7}", "-"), |number| format!("{number:7.2}"))
}
