//! The best layouts and the paper's, for people.

use std::fmt::Write;

use placement::result::{LayoutScore, RankedLayout, StudyResult};

use crate::cli::terminal::paint::{FAINT, GOOD, HEADER, header, painted};

/// Layouts that are printed, beside the paper's.
const SHOWN: usize = 5;
/// Units of the paper's layout, each with a film along and one across.
const PAPER_UNITS: usize = 6;

/// The layouts of a result; nothing where it has none.
pub fn layouts(result: &StudyResult) -> String {
    let Some(first) = result.layouts.first() else {
        return String::new();
    };
    let mut text = format!(
        "\n{}: how well is the contact known{}?\n",
        painted(HEADER, "layouts"),
        loads(result)
    );
    text.push_str(&header(
        "rank  layout                                       films  angle, deg: 95 %        its bound   lost, %  force, N  one dead  rank is\n",
    ));
    let paper = result.layouts.iter().position(is_the_papers);
    let beyond = paper.filter(|paper| *paper >= SHOWN);
    let shown = (0..result.layouts.len().min(SHOWN)).chain(beyond);
    for layout in shown.map(|row| &result.layouts[row]) {
        text.push_str(&row(layout));
    }
    let rest = result
        .layouts
        .len()
        .saturating_sub(SHOWN + usize::from(beyond.is_some()));
    if rest > 0 {
        let _ = writeln!(text, "{rest} more are in the result: --json -");
    }
    if let Some(reason) = first
        .score
        .reason
        .as_ref()
        .filter(|_| first.loads.is_empty())
    {
        let _ = writeln!(text, "{}", reason.escape_debug());
    }
    text.push_str(&knees(result));
    text
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

fn row(layout: &RankedLayout) -> String {
    let score = &layout.score;
    let number = |value: Option<f64>, digits: usize| {
        value.map_or("-".to_owned(), |value| format!("{value:.digits$}"))
    };
    let certain = match layout.rank_certain {
        Some(true) => painted(GOOD, "certain"),
        _ => painted(FAINT, "uncertain"),
    };
    format!(
        "{:>4}  {:<43}{:>7}  {:<20}{:>13}{:>10}{:>10}{:>10}  {certain}\n",
        layout.rank,
        described(layout),
        number(layout.film_count.map(|films| films as f64), 0),
        with_error(score),
        number(score.worst_angle_error_deg, 2),
        number(score.lost_share.map(|share| 100.0 * share), 1),
        number(score.force_error_n, 2),
        number(
            score
                .dead
                .as_ref()
                .and_then(|dead| dead.simulated_p95_angle_error_deg),
            2
        ),
    )
}

/// What a layout is, in a few words.
fn described(layout: &RankedLayout) -> String {
    if let Some(name) = &layout.name {
        return name.escape_debug().to_string();
    }
    let staggered = if layout.staggered { ", staggered" } else { "" };
    let spacing = layout.spacing_deg.unwrap_or_default();
    format!(
        "{} of {} at the {}, {} deg{staggered}",
        layout.units,
        layout.films.join("+"),
        layout.position,
        (spacing * 10.0).round() / 10.0
    )
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
        (texts, Some(knee)) => format!(
            "dense enough (bounds within twice a dense ring's) from so many units of {} at {} deg on: {}\n",
            knee.films.join("+"),
            knee.section_deg,
            texts.join(", ")
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
        assert_eq!(described(&layout), "7 of x+y at the crown, 51.4 deg");
        assert!(!is_the_papers(&layout));
        (layout.units, layout.staggered) = (6, true);
        assert!(!is_the_papers(&layout) && described(&layout).ends_with("staggered"));
        layout.staggered = false;
        assert!(is_the_papers(&layout));
        assert!(row(&layout).contains(" - "));
        layout.name = Some("mine".to_owned());
        assert_eq!(described(&layout), "mine");
    }
}
