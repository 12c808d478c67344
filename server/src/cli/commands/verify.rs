//! `strainsite verify`: problems whose answer is known, solved and compared.

use std::fmt::Write;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Instant;

use anstyle::Style;
use clap::Args;
use placement::points::worker_threads::in_parallel;
use serde_json::json;
use verify::extremes;
use verify::extremes::studies;
use verify::{self, Case, Family, Verdict};

use crate::cli::terminal::exit::Failure;
use crate::cli::terminal::files::Files;
use crate::cli::terminal::output::{JsonTarget, tell, warn};
use crate::cli::terminal::paint::{BAD, GOOD, HEADER, left, painted};
use crate::cli::terminal::progress::counting_bar;
use crate::cli::terminal::signals::stop_flag;

/// Solve problems whose answer is known, and compare
#[derive(Debug, Args)]
pub(crate) struct Verify {
    /// The ends of what can be asked for, instead: incompressible rubber, thin walls, limit loads, first touch, other units
    #[arg(long)]
    extremes: bool,
    /// Only these families of cases; repeat for several
    #[arg(long, value_name = "FAMILY")]
    only: Vec<String>,
    /// Write the cases as JSON to a file, or to standard output with -
    #[arg(long, value_name = "FILE|-")]
    json: Option<JsonTarget>,
}

impl Verify {
    /// Returns the files that it writes.
    pub fn files(&self) -> Files {
        Files::default().telling(self.json.as_ref())
    }

    /// Solves all cases and prints them as a Markdown table. Fails when one of them does.
    pub fn execute(&self) -> Result<(), Failure> {
        let families = self.families()?;
        let runtime = tokio::runtime::Runtime::new().map_err(Failure::other)?;
        let stop = stop_flag(&runtime)?;
        let begun = Instant::now();
        let cases = solve(&families, &stop);
        if stop.load(Ordering::Relaxed) {
            return Err(Failure::Other("stopped on request".to_owned()));
        }
        if let Some(target) = &self.json {
            target.write(&json!({"cases": cases}))?;
        }
        tell(&table(&cases), self.json.as_ref())?;
        let failed = cases
            .iter()
            .filter(|case| case.verdict == Verdict::Fail)
            .count();
        let (count, wall) = (cases.len(), begun.elapsed().as_secs_f64());
        let style = if failed > 0 { BAD } else { GOOD };
        let failures = painted(style, format!("{failed} failed"));
        warn(&format!("{count} cases, {failures}, {wall:.1} s\n"));
        if failed > 0 {
            return Err(Failure::Other(format!("{failed} of {count} cases failed")));
        }
        Ok(())
    }

    /// The families asked for, in their order.
    fn families(&self) -> Result<Vec<Family>, Failure> {
        let all = match self.extremes {
            true => all_extremes(),
            false => verify::FAMILIES.to_vec(),
        };
        let names: Vec<&str> = all.iter().map(|family| family.name).collect();
        if let Some(unknown) = self
            .only
            .iter()
            .find(|name| !names.contains(&name.as_str()))
        {
            let names = names.join(", ");
            return Err(Failure::input(format!(
                "there is no family {unknown:?} here; there are {names}"
            )));
        }
        let chosen = |family: &Family| {
            self.only.is_empty() || self.only.iter().any(|name| name == family.name)
        };
        Ok(all.into_iter().filter(chosen).collect())
    }
}

/// Every family of the extremes, roughly from the quickest to the slowest.
fn all_extremes() -> Vec<Family> {
    let mut families = extremes::FAMILIES.to_vec();
    families.push(studies::FAMILY);
    families
}

/// Solves the families on all cores, the last and slowest first, and returns their cases in order.
fn solve(families: &[Family], stop: &AtomicBool) -> Vec<Case> {
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    let bar = counting_bar(families.len(), "families of cases");
    // Families that are told to stop end by themselves, each with its cases.
    let go_on = AtomicBool::new(false);
    let solved = in_parallel(families.len(), threads, &go_on, |number| {
        let cases = families[families.len() - 1 - number].cases(stop);
        bar.inc(1);
        cases
    });
    bar.finish_and_clear();
    solved.into_iter().flatten().rev().flatten().collect()
}

fn table(cases: &[Case]) -> String {
    let header = ["case", "computed", "expected", "error", "tolerance"];
    let more = ["slope (theory)", "verdict", "expected value from"];
    let mut rows: Vec<Vec<String>> =
        vec![header.into_iter().chain(more).map(str::to_owned).collect()];
    rows.extend(cases.iter().map(row));
    let widths: Vec<usize> = (0..rows[0].len())
        .map(|column| {
            rows.iter()
                .map(|row| row[column].chars().count())
                .max()
                .unwrap_or(0)
        })
        .collect();
    let mut text = String::new();
    for (index, row) in rows.iter().enumerate() {
        for (cell, width) in row.iter().zip(&widths) {
            // Writing to a string cannot fail.
            let _ = write!(text, "| {} ", left(style_of(index, cell), cell, *width));
        }
        text.push_str("|\n");
        if index == 0 {
            for width in &widths {
                let _ = write!(text, "| {:-<width$} ", "");
            }
            text.push_str("|\n");
        }
    }
    text
}

/// Returns the style of a cell in a row, the first of which is the header.
fn style_of(row: usize, cell: &str) -> Style {
    match cell {
        _ if row == 0 => HEADER,
        PASS => GOOD,
        FAIL => BAD,
        _ => Style::new(),
    }
}

const PASS: &str = "pass";
const FAIL: &str = "FAIL";

fn row(case: &Case) -> Vec<String> {
    let value = |value: Option<f64>| value.map_or_else(|| "none".to_owned(), number);
    let small =
        |value: Option<f64>| value.map_or_else(|| "none".to_owned(), |v| format!("{v:.1e}"));
    let slope = case
        .slope
        .map(|slope| format!("{:.2} ({})", slope.observed, slope.theoretical));
    let verdict = match case.verdict {
        Verdict::Pass => PASS,
        Verdict::Fail => FAIL,
    };
    vec![
        case.name.clone(),
        value(case.computed),
        value(Some(case.expected)),
        small(case.error),
        small(Some(case.tolerance)),
        slope.unwrap_or_default(),
        verdict.to_owned(),
        last(case),
    ]
}

/// Eight decimals, or four digits of what that would hide.
fn number(value: f64) -> String {
    const SMALL: f64 = 1e-4;
    if value == 0.0 || value.abs() >= SMALL {
        format!("{value:.8}")
    } else {
        format!("{value:.3e}")
    }
}

/// Says where the expected value comes from, and how the solve ended.
fn last(case: &Case) -> String {
    match &case.detail {
        Some(detail) if case.source.is_empty() => detail.clone(),
        Some(detail) => format!("{}; {detail}", case.source),
        None => case.source.to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cli::terminal::shown::plain;
    use verify::Measure;

    #[test]
    fn a_case_without_an_answer_fails_and_says_why() {
        let case = Case {
            name: "sphere".to_owned(),
            computed: None,
            expected: 1.5,
            error: None,
            tolerance: 0.0,
            measure: Measure::Relative,
            slope: None,
            source: "",
            verdict: Verdict::Fail,
            detail: Some("no limit point".to_owned()),
        };
        let text = plain(&table(&[case]));
        let lines: Vec<&str> = text.lines().collect();
        assert_eq!(lines.len(), 3, "{text}");
        assert!(lines[2].contains("| none ") && lines[2].contains("| FAIL "));
        assert!(lines[2].contains("no limit point"));
        let lengths: Vec<usize> = lines.iter().map(|line| line.len()).collect();
        assert_eq!(lengths, [lengths[0]; 3], "columns line up");
    }
}
