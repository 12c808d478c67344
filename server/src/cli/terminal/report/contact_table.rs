//! Errors of the layout that answers by contacts as they come, for people.

use std::fmt::Write;

use document::visible::visible;
use results::{ContactFindings, RankedLayout, StudyResult, ToldQuantity};

use crate::cli::terminal::paint::{FAINT, HEADER, painted};
use crate::cli::terminal::report::layout_table::{NAMED, described};
use crate::cli::terminal::wrapping::{labelled, wrapped};

/// Errors of the layout that answers by each quantity alone, and how far the surface is off; nothing where contacts don't differ.
pub(super) fn contacts(result: &StudyResult) -> String {
    let findings = result.layout_findings.as_ref();
    let Some(findings) = findings.and_then(|findings| findings.contacts.as_ref()) else {
        return String::new();
    };
    let over = format!("errors are over {}", findings.laws.join(", "));
    let mut text = format!("\n{}", labelled(HEADER, "contacts", &visible(&over)));
    let answer = result.answer.as_ref();
    let answers = answer.and_then(|answer| result.layout_of_rank(answer.layout.as_ref()?.rank));
    if let Some(layout) = answers.or(result.layouts.first()) {
        text.push_str(&by_quantity(layout));
        text.push_str(&told(layout));
    }
    text.push_str(&wrapped(&surface_words(findings), 0));
    for short in &findings.short {
        let short = format!("Drawn no further than could be solved: {short}.");
        text.push_str(&painted(FAINT, wrapped(&visible(&short), 0)));
    }
    text
}

/// Errors of the surface over contacts, and what they claim of others.
fn surface_words(findings: &ContactFindings) -> String {
    let within = |claim: Option<f64>| {
        claim.map_or_else(String::new, |claim| {
            format!(" (95 % within {:.1} %)", 100.0 * claim)
        })
    };
    let slopes = match (findings.slope_error_rms, findings.slope_error_largest) {
        (Some(rms), Some(largest)) => format!(
            " their slopes over the angle by {:.1} % of its steepest{}, and by {:.0} % at most;",
            100.0 * rms,
            within(findings.slope_claim),
            100.0 * largest
        ),
        _ => String::new(),
    };
    let force = findings
        .force_claim_n
        .map_or_else(String::new, |claim| format!(" (95 % within {claim:.2} N)"));
    format!(
        "Signals of contacts are off by {:.1} % of the crown's largest, root mean square{}, and by {:.0} % at most;{slopes} forces by {:.2} N{force}: at {} contacts of all at once, which they weren't made from.",
        100.0 * findings.signal_error_rms,
        within(findings.signal_claim),
        100.0 * findings.signal_error_largest,
        findings.force_error_n,
        findings.checks
    )
}

/// Errors of what the films tell of the contact beside angle and force; nothing where an estimate averages over it.
fn told(layout: &RankedLayout) -> String {
    let known = |own: &ToldQuantity| {
        let words = visible(&own.words).to_string();
        let (error, deviation) = (told_figure(own.error), told_figure(own.deviation));
        let claim = own
            .claim
            .map_or_else(String::new, |claim| format!(" +-{}", told_figure(claim)));
        match own.known {
            true => format!("{words} to {error}{claim} of {deviation}"),
            false => format!("nothing of {words} ({error} of {deviation})"),
        }
    };
    let all: Vec<String> = layout.told.iter().map(known).collect();
    match all.is_empty() {
        true => String::new(),
        false => wrapped(
            &format!(
                "They tell, root mean square of deviation, each at its worst load: {}.",
                all.join(", ")
            ),
            0,
        ),
    }
}

/// A told quantity with as many digits as bear.
fn told_figure(value: f64) -> String {
    match value.abs() {
        10.0.. => format!("{value:.0}"),
        _ => format!("{value:.2}"),
    }
}

fn by_quantity(layout: &RankedLayout) -> String {
    let head = format!("{}, each at its worst load", described(layout));
    let mut text = format!("{head:<NAMED$}  angle, 95 %, deg  force, rms, N\n");
    let mut row = |words: &str, angle: Option<f64>, force: Option<f64>| {
        let shown = |figure: Option<f64>| figure.map_or("-".to_owned(), |x| format!("{x:.2}"));
        let (angle, force) = (shown(angle), shown(force));
        let _ = writeln!(
            text,
            "      {words:<width$}  {angle:>16}  {force:>13}",
            width = NAMED - 6
        );
    };
    for own in &layout.contacts {
        let alone = format!("{} alone", visible(&own.words));
        row(
            &alone,
            Some(own.p95_angle_error_deg),
            Some(own.force_error_n),
        );
    }
    let force = layout.worst_force.map(|force| force.error_n);
    row("all", layout.score.simulated_p95_angle_error_deg, force);
    text
}
