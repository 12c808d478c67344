//! The best layouts and the paper's, for people.

use std::fmt::Write;

use fem_client::document::visible::visible;
use placement::result::{LayoutScore, RankedLayout, StudyResult};

use crate::cli::terminal::paint::{FAINT, GOOD, HEADER, header, painted};
use crate::cli::terminal::report::shared_rank::rank_cell;
use crate::cli::terminal::wrapping::{cut, labelled, wrapped};

const HEAD: &str = "                                                    angle error, deg          lost  force\n\
                    rank  layout                                   films     95 % below  bound      %      N  rank is\n";
/// What layouts are ordered by.
const ORDER: &str =
    "The order goes by the angle's error at the worst load times the root of the number of films.";
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
    text.push_str(&header(HEAD));
    let paper = result.layouts.iter().position(is_the_papers);
    let beyond = paper.filter(|paper| *paper >= SHOWN);
    let shown = (0..result.layouts.len().min(SHOWN)).chain(beyond);
    let shown: Vec<&RankedLayout> = shown.map(|row| &result.layouts[row]).collect();
    let ranks = || result.layouts.iter().map(|layout| layout.rank);
    for layout in &shown {
        text.push_str(&row(layout, &rank_cell(layout.rank, ranks())));
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
    text.push_str(&dead(&shown));
    text.push_str(&shear(&shown, &result.layouts));
    text.push_str(&films(result));
    text.push_str(&knees(result));
    text
}

/// Which films they are, where they aren't points that read strains.
fn films(result: &StudyResult) -> String {
    let findings = result.layout_findings.as_ref();
    let sized = findings.and_then(|findings| Some((findings.size_mm?, &findings.unit)));
    let noise = result
        .layouts
        .first()
        .map(|layout| layout.score.noise_strain);
    match (sized, noise.filter(|noise| *noise > 0.0)) {
        (Some(([length, width], unit)), Some(noise)) => {
            let film = if unit == "V" { "glued films" } else { "films" };
            let unit = unit.escape_debug();
            format!("{film} of {length} x {width} mm, noise {noise:.3e} {unit}\n")
        }
        _ => String::new(),
    }
}

/// At which loads, the worst of which is shown.
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

fn row(layout: &RankedLayout, rank: &str) -> String {
    let score = &layout.score;
    let certain = match layout.rank_certain {
        Some(true) => painted(GOOD, "certain"),
        _ => painted(FAINT, "uncertain"),
    };
    format!(
        "{rank} {:<DESCRIBED$}{:>6} {:>15}{:>7}{:>7}{:>7}  {certain}\n",
        described(layout),
        number(layout.film_count.map(|films| films as f64), 0),
        with_error(score),
        number(score.worst_angle_error_deg, 2),
        number(score.lost_share.map(|share| 100.0 * share), 1),
        number(score.force_error_n, 2),
    )
}

pub(super) fn number(value: Option<f64>, digits: usize) -> String {
    value.map_or("-".to_owned(), |value| format!("{value:.digits$}"))
}

/// What is left of those shown without the film whose loss costs most; nothing where that wasn't asked for.
fn dead(shown: &[&RankedLayout]) -> String {
    let mut text = String::new();
    for layout in shown {
        let Some(dead) = &layout.score.dead else {
            continue;
        };
        if text.is_empty() {
            text.push_str(&header(
                "\nrank  without the film whose loss costs most    angle error, deg: 95 % below\n",
            ));
        }
        let _ = writeln!(
            text,
            "{:>4}  {:<DESCRIBED$}{:>34}",
            layout.rank,
            described(layout),
            number(dead.simulated_p95_angle_error_deg, 2)
        );
    }
    text
}

/// Bounds with forces along and across the wheel unknown, too, of those shown and of the best one that tells them; nothing where that wasn't asked for.
fn shear(shown: &[&RankedLayout], all: &[RankedLayout]) -> String {
    let tells = |layout: &&RankedLayout| {
        let shear = layout.score.shear.as_ref();
        shear.is_some_and(|shear| shear.reason.is_none())
    };
    let best = all.iter().find(tells);
    let best = best.filter(|best| !shown.iter().any(|layout| std::ptr::eq(*layout, *best)));
    let mut text = String::new();
    for layout in shown.iter().copied().chain(best) {
        let Some(shear) = &layout.score.shear else {
            continue;
        };
        if text.is_empty() {
            text.push_str(&header(
                "\nrank  with forces along and across unknown: bounds    angle, deg  along, N  across, N     up, N\n",
            ));
        }
        let force =
            |axis: usize| number(shear.worst_force_error_n.and_then(|forces| forces[axis]), 2);
        let _ = writeln!(
            text,
            "{:>4}  {:<46}{:>12}{:>10}{:>11}{:>10}",
            layout.rank,
            described(layout),
            number(shear.worst_angle_error_deg, 2),
            force(0),
            force(1),
            force(2)
        );
        if let Some(reason) = &shear.reason {
            text.push_str(&painted(
                FAINT,
                wrapped(&format!("      {}", visible(reason)), 6),
            ));
        }
    }
    text
}

/// What a layout is, in a few words.
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

fn with_error(score: &LayoutScore) -> String {
    let Some(value) = score.simulated_p95_angle_error_deg else {
        return "-".to_owned();
    };
    let error = score.error.as_ref();
    let error = error.and_then(|error| error.simulated_p95_angle_error_deg);
    error.map_or_else(
        || format!("{value:.2}"),
        |error| format!("{value:.2} +-{error:.2}"),
    )
}

fn is_the_papers(layout: &RankedLayout) -> bool {
    layout.units == PAPER_UNITS
        && layout.name.is_none()
        && layout.position == "crown"
        && layout.films == ["x", "y"]
        && !layout.staggered
}

/// From how many units on more bring no more than their number, for each load.
fn knees(result: &StudyResult) -> String {
    let Some(findings) = &result.layout_findings else {
        return String::new();
    };
    let of_load = |load: &placement::result::LayoutLoad| {
        let knee = load.knees.first()?;
        let units = knee.units?;
        Some(format!("{units} at {:.1} N", load.load_n?))
    };
    let texts: Vec<String> = findings.loads.iter().filter_map(of_load).collect();
    let first = findings.loads.iter().find_map(|load| load.knees.first());
    match (texts.as_slice(), first) {
        ([], _) | (_, None) => String::new(),
        (texts, Some(knee)) => wrapped(
            &format!(
                "dense enough (bounds within twice a dense ring's) from so many units of {} at {} deg on: {}",
                knee.films.join("+"),
                knee.section_deg,
                texts.join(", ")
            ),
            2,
        ),
    }
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
        assert!(row(&layout, "   1 ").contains(" - "));
        layout.name = Some("mine".to_owned());
        assert_eq!(described(&layout), "mine");
    }
}
