//! The best layouts and the paper's, for people.

use std::fmt::Write;

use document::visible::visible;
use documents::layouts::layout_settings::VOLT_UNIT;
use results::columns::{self, Table, table_rows};
use results::{RankedLayout, StudyResult};

use crate::cli::terminal::figures::Figures;
use crate::cli::terminal::paint::{FAINT, GOOD, HEADER, painted};
use crate::cli::terminal::report::glued_films::glued;
use crate::cli::terminal::report::shared_rank::rank_cell;
use crate::cli::terminal::wrapping::{cut, labelled, wrapped};

/// Sentence on what layouts are ordered by.
const ORDER: &str =
    "The order goes by the angle's error at the worst load times the root of the number of films.";
/// Words above ranks and layouts.
const NAMES: &str = "rank  layout";
/// Columns of ranks and layouts.
pub(super) const NAMED: usize = DESCRIBED + 6;
/// Columns of what a layout is.
pub(super) const DESCRIBED: usize = 40;
/// Layouts that are printed, beside the paper's.
const SHOWN: usize = 5;
/// Units of the paper's layout, each with a film along and one across.
const PAPER_UNITS: usize = 6;

/// The layouts of a result; nothing where it has none.
pub fn layouts(result: &StudyResult) -> String {
    let Some(first) = result.layouts.first() else {
        return String::new();
    };
    let question = format!("how well is the contact known{}?", loads(result));
    let mut text = format!("\n{}", labelled(HEADER, "layouts", &question));
    let paper = result.layouts.iter().position(is_the_papers);
    let beyond = paper.filter(|paper| *paper >= SHOWN);
    let shown = (0..result.layouts.len().min(SHOWN)).chain(beyond);
    let shown: Vec<&RankedLayout> = shown.map(|row| &result.layouts[row]).collect();
    let ranks = || result.layouts.iter().map(|layout| layout.rank);
    let table = columns::layouts();
    let figures = figures(&table, "ranked", &shown);
    text.push_str(&figures.head(NAMES, NAMED, "  rank is"));
    for (row, layout) in shown.iter().enumerate() {
        let rank = rank_cell(layout.rank, ranks());
        text.push_str(&ranked(layout, &rank, &figures.row(row)));
    }
    let rest = result
        .layouts
        .len()
        .saturating_sub(SHOWN + usize::from(beyond.is_some()));
    if rest > 0 {
        let _ = writeln!(text, "{rest} more are in the result: --json -");
    }
    text.push_str(&wrapped(ORDER, 0));
    if let Some(reason) = first
        .score
        .reason
        .as_ref()
        .filter(|_| first.loads.is_empty())
    {
        text.push_str(&wrapped(&visible(reason), 0));
    }
    text.push_str(&dead(&table, &shown));
    text.push_str(&shear(&table, &shown, &result.layouts));
    text.push_str(&films(result));
    text
}

/// Says which films they are, where they aren't points that read strains.
fn films(result: &StudyResult) -> String {
    let findings = result.layout_findings.as_ref();
    let sized = findings.and_then(|findings| Some((findings.size_mm?, &findings.unit)));
    let score = result.layouts.first().map(|layout| &layout.score);
    let noise = score.and_then(|score| score.noise_strain.or(score.noise_v));
    let coupled = findings.and_then(|findings| findings.films.as_ref());
    match (sized, noise.filter(|noise| *noise > 0.0)) {
        (Some(([length, width], unit)), Some(noise)) => {
            let film = if unit == VOLT_UNIT {
                "glued films"
            } else {
                "films"
            };
            let unit = unit.escape_debug();
            format!("{film} of {length} x {width} mm, noise {noise:.3e} {unit}\n")
                + &coupled.map(glued).unwrap_or_default()
        }
        _ => String::new(),
    }
}

/// Says at which loads, the worst of which is shown.
fn loads(result: &StudyResult) -> String {
    let findings = result.layout_findings.as_ref();
    let loads = findings.map_or(&[][..], |findings| &findings.loads);
    let texts: Vec<String> = loads
        .iter()
        .filter_map(|load| Some(format!("{:.3} mm ({:.1} N)", load.depth_mm?, load.load_n?)))
        .collect();
    match texts.as_slice() {
        [] => String::new(),
        [one] => format!(" at {one}"),
        all => format!(" at the worst of {}", all.join(", ")),
    }
}

/// Figures of a view of layouts.
fn figures(table: &Table, view: &str, layouts: &[&RankedLayout]) -> Figures {
    let row = |layout: &&RankedLayout| table_rows::layout(layout, None);
    let rows: Vec<_> = layouts.iter().map(row).collect();
    Figures::of(&table.view(view), &rows)
}

fn ranked(layout: &RankedLayout, rank: &str, figures: &str) -> String {
    let certain = match layout.rank_certain {
        Some(true) => painted(GOOD, "certain"),
        _ => painted(FAINT, "uncertain"),
    };
    format!(
        "{rank} {:<DESCRIBED$}{figures}  {certain}\n",
        described(layout)
    )
}

/// A further view of some layouts below the table, with remarks below their lines; nothing without layouts.
fn further(
    table: &Table,
    view: &str,
    names: &str,
    layouts: &[&RankedLayout],
    remark: impl Fn(&RankedLayout) -> Option<&str>,
) -> String {
    if layouts.is_empty() {
        return String::new();
    }
    let figures = figures(table, view, layouts);
    let mut text = format!("\n{}", figures.head(names, NAMED, ""));
    for (row, layout) in layouts.iter().enumerate() {
        let _ = writeln!(
            text,
            "{:>4}  {:<DESCRIBED$}{}",
            layout.rank,
            described(layout),
            figures.row(row)
        );
        if let Some(remark) = remark(layout) {
            let remark = wrapped(&format!("      {}", visible(remark)), 6);
            text.push_str(&painted(FAINT, remark));
        }
    }
    text
}

/// Says what is left of those shown without the film whose loss costs most; nothing where that wasn't asked for.
fn dead(table: &Table, shown: &[&RankedLayout]) -> String {
    let asked = shown.iter().filter(|layout| layout.score.dead.is_some());
    let asked: Vec<&RankedLayout> = asked.copied().collect();
    let names = "rank  without the film whose loss costs most";
    further(table, "dead", names, &asked, |_| None)
}

/// Bounds with forces along and across the wheel unknown, too, of those shown and of the best one that tells them; nothing where that wasn't asked for.
fn shear(table: &Table, shown: &[&RankedLayout], all: &[RankedLayout]) -> String {
    let tells = |layout: &&RankedLayout| {
        let shear = layout.score.shear.as_ref();
        shear.is_some_and(|shear| shear.reason.is_none())
    };
    let best = all.iter().find(tells);
    let best = best.filter(|best| !shown.iter().any(|layout| std::ptr::eq(*layout, *best)));
    let asked = shown.iter().copied().chain(best);
    let asked: Vec<_> = asked
        .filter(|layout| layout.score.shear.is_some())
        .collect();
    let names = "rank  forces along and across unknown: bounds";
    further(table, "shear", names, &asked, |layout| {
        layout.score.shear.as_ref()?.reason.as_deref()
    })
}

/// Describes a layout in a few words.
pub(super) fn described(layout: &RankedLayout) -> String {
    if let Some(name) = &layout.name {
        return cut(name.escape_debug().to_string(), DESCRIBED);
    }
    let staggered = if layout.staggered { ", staggered" } else { "" };
    let spacing = layout.spacing_deg.unwrap_or_default();
    let words = format!(
        "{} of {}, {}, {} deg{staggered}",
        layout.units,
        layout.films.join("+"),
        layout.position,
        (spacing * 10.0).round() / 10.0
    );
    cut(words, DESCRIBED)
}

fn is_the_papers(layout: &RankedLayout) -> bool {
    layout.units == PAPER_UNITS
        && layout.name.is_none()
        && layout.position == "crown"
        && layout.films == ["x", "y"]
        && !layout.staggered
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn layouts_are_described_in_words() {
        let mut layout = RankedLayout {
            units: 7,
            spacing_deg: Some(360.0 / 7.0),
            position: "crown".to_owned(),
            films: vec!["x".to_owned(), "y".to_owned()],
            ..RankedLayout::default()
        };
        assert_eq!(described(&layout), "7 of x+y, crown, 51.4 deg");
        assert!(!is_the_papers(&layout));
        (layout.units, layout.staggered) = (6, true);
        assert!(!is_the_papers(&layout) && described(&layout).ends_with("staggered"));
        layout.staggered = false;
        assert!(is_the_papers(&layout));
        let figures = figures(&columns::layouts(), "ranked", &[&layout]);
        assert!(ranked(&layout, "   1 ", &figures.row(0)).contains(" - "));
        layout.name = Some("mine".to_owned());
        assert_eq!(described(&layout), "mine");
    }
}
