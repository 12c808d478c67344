//! Columns of recordings, for people: what is read at all first, then each recording with its columns.

use std::fmt::Write as _;

use document::visible::visible;
use results::columns::Column;
use serde_json::json;
use service::wire::look_wire::{ColumnLook, Look, RecordingLook, Taken};

use crate::cli::terminal::figures::Figures;
use crate::cli::terminal::paint::{WARNING, painted};
use crate::cli::terminal::wrapping::{cut, labelled, wrapped};

/// Characters of a column's name, and of what it is taken for.
const NAMED: usize = 20;
const TAKEN: usize = 18;

/// The look as text.
pub(crate) fn look_text(look: &Look) -> String {
    let mut text = answer(look);
    for recording in &look.recordings {
        text.push('\n');
        text.push_str(&of_recording(recording));
    }
    if !look.refusals.is_empty() {
        text.push('\n');
    }
    for refusal in &look.refusals {
        text.push_str(&labelled(
            WARNING,
            "force fit refuses this",
            &refusal.to_string(),
        ));
    }
    if !look.faults.is_empty() {
        text.push('\n');
    }
    text
}

/// Counts of what can be read, and of what is suspect.
fn answer(look: &Look) -> String {
    let count = look.recordings.len();
    let Some(first) = look.recordings.first() else {
        return "No recording can be read.\n".to_owned();
    };
    let all = || look.recordings.iter();
    let rows: usize = all().map(|recording| recording.rows).sum();
    let columns = || all().flat_map(|recording| &recording.columns);
    let suspicions: usize = columns().map(|column| column.suspicions.len()).sum();
    let of = |taken: Taken| -> Vec<String> {
        let columns = first.columns.iter().filter(|column| column.taken == taken);
        columns.map(|column| visible(&column.column)).collect()
    };
    let (times, signals, forces) = (of(Taken::Time), of(Taken::Signal), of(Taken::Force));
    let text = format!(
        "{} with {}: time {}, {}, {}. {}.",
        counted(count, "recording"),
        counted(rows, "row"),
        times.join(" and "),
        match forces.as_slice() {
            [] => "no force".to_owned(),
            names => format!("{} ({})", counted(names.len(), "force"), names.join(", ")),
        },
        counted(signals.len(), "signal"),
        match (suspicions, look.refusals.len()) {
            (0, 0) => "Nothing looks wrong".to_owned(),
            (count, 0) => format!("{} below", counted(count, "suspicion")),
            (0, _) => "Nothing is learnt from this, as said below".to_owned(),
            (count, _) => format!(
                "{}, and nothing is learnt from this, as said below",
                counted(count, "suspicion")
            ),
        }
    );
    wrapped(&text, 0)
}

fn counted(count: usize, what: &str) -> String {
    match count {
        1 => format!("1 {what}"),
        count => format!("{count} {what}s"),
    }
}

fn of_recording(recording: &RecordingLook) -> String {
    let rate = recording
        .rate_hz
        .map_or(String::new(), |rate| format!(" at {} Hz", figure(rate)));
    let gaps = match &recording.gaps.longest {
        None => "no gap".to_owned(),
        Some(gap) => format!(
            "{}, the longest of {} s after line {}",
            counted(recording.gaps.count, "gap"),
            figure(gap.length_s),
            gap.line
        ),
    };
    let head = format!(
        "{}: {} in {} s{rate}, {gaps}, {}, {} with a force",
        visible(&recording.file),
        counted(recording.rows, "row"),
        figure(recording.duration_s),
        counted(recording.cycles, "cycle"),
        recording.labelled
    );
    let mut text = wrapped(&head, 2);
    text.push_str(&columns(&recording.columns));
    for note in &recording.notes {
        text.push_str(&wrapped(&visible(note), 2));
    }
    for suspicion in recording
        .columns
        .iter()
        .flat_map(|column| &column.suspicions)
    {
        text.push_str(&labelled(WARNING, "suspect", &visible(suspicion)));
    }
    text
}

fn columns(columns: &[ColumnLook]) -> String {
    let shown = |number: Option<f64>| number.map(figure);
    let row = |column: &ColumnLook| {
        json!({
            "least": shown(column.least), "greatest": shown(column.greatest), "empty": column.empty,
            "noise": shown(column.noise), "unloaded": shown(column.unloaded), "drift": shown(column.drift),
        })
    };
    let rows: Vec<_> = columns.iter().map(row).collect();
    let text = |name: &str| Column::text(name, &format!("/{name}"));
    let all = [
        text("least"),
        text("greatest"),
        Column::integer("empty", "/empty"),
        text("noise"),
        text("unloaded"),
        text("drift"),
    ];
    let all: Vec<&Column> = all.iter().collect();
    let figures = Figures::of(&all, &rows);
    let names = format!("{:<NAMED$}taken for", "column");
    let mut text = figures.head(&names, NAMED + TAKEN, "");
    for (row, column) in columns.iter().enumerate() {
        let name = cut(visible(&column.column), NAMED - 1);
        // Writing to a text can't fail.
        let _ = writeln!(text, "{name:<NAMED$}{}{}", taken(column), figures.row(row));
    }
    text
}

/// Words for the part that a column is taken for, with its unit.
fn taken(column: &ColumnLook) -> String {
    let unit = |unit: &Option<String>| unit.clone().unwrap_or_default();
    let words = match column.taken {
        Taken::Time => match unit(&column.time_unit).as_str() {
            "seconds" => "time, s".to_owned(),
            other => format!("time, {} made s", short(other)),
        },
        Taken::Force if column.newtons == Some(1.0) => "force, N".to_owned(),
        Taken::Force => "force, made N".to_owned(),
        Taken::Signal => "signal".to_owned(),
        Taken::Cycle => "cycle".to_owned(),
        Taken::Nothing => "nothing".to_owned(),
    };
    let cell = format!("{words:<TAKEN$}");
    match column.suspicions.is_empty() {
        true => cell,
        false => painted(WARNING, format!("{:<TAKEN$}", format!("{words} (!)"))),
    }
}

fn short(unit: &str) -> &str {
    match unit {
        "dates or clock times" => "dates",
        "milliseconds" => "ms",
        "microseconds" => "us",
        "nanoseconds" => "ns",
        other => other,
    }
}

/// Four digits, and no more than a reader needs: a number whose size is far from 1 with its power of ten.
fn figure(number: f64) -> String {
    let size = number.abs();
    if size == 0.0 {
        return "0".to_owned();
    }
    if !(1e-3..1e6).contains(&size) {
        return format!("{number:.3e}");
    }
    let before = size.log10().floor() as i32 + 1;
    let decimals = usize::try_from(4 - before).unwrap_or(0);
    format!("{number:.decimals$}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn figures_have_four_digits() {
        for (number, shown) in [
            (0.0, "0"),
            (12.3456, "12.35"),
            (-0.05, "-0.05000"),
            (123_456.0, "123456"),
            (1.7956e9, "1.796e9"),
            (2e-5, "2.000e-5"),
        ] {
            assert_eq!(figure(number), shown);
        }
    }
}
