//! A recording in the usual form: time in seconds, signals, forces in newtons, what tells cycles apart.

// What users write is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

use std::collections::HashSet;
use std::fmt::Write as _;

use document::fault::Fault;
use documents::own_model::csv_cell;
use estimation::recipe::Recipe;
use estimation::recording::csv_recording::{lines, read_for_look};
use estimation::recording::named_columns::NamedColumns;
use estimation::recording::recording_fault::FaultList;
use estimation::recording::row_reader::{Row, RowReader};

use crate::forces::recorded_texts::{NamedText, add, columned, doubtful_time};

/// Name of the time in seconds.
const TIME: &str = "time_s";

/// The recording's columns that a recipe reads, as commas and points: from it the same is learnt to the bit, by a recipe that needs to say nothing of time and units.
///
/// # Errors
/// Its faults; times that may be no seconds; a name that two columns would have.
pub fn converted(recipe: &Recipe, file: &NamedText) -> Result<String, Vec<Fault>> {
    let files = std::slice::from_ref(file);
    let columned = columned(recipe, files)?;
    let gaps = recipe.preprocess.rate_hz.is_some();
    let (Some(text), header) = (columned.usual.first(), columned.headers.first()) else {
        return Ok(String::new());
    };
    let run = read_for_look(&file.name, text, &recipe.columns, &columned.names, gaps);
    let mut faults = Vec::new();
    match run {
        Ok(run) => faults.extend(doubtful_time(recipe, &columned, &[run])),
        Err(found) => add(&mut faults, found),
    }
    let header = header.and_then(Option::as_deref).unwrap_or_default();
    let names = columned.names.among(header);
    let written = names_of(&names);
    faults.extend(twice(&file.name, &written));
    let Some(reader) = RowReader::new(&names, header, gaps).filter(|_| faults.is_empty()) else {
        return Err(faults);
    };
    let mut out = csv_cell::line(&written);
    let mut unread = FaultList::of(&file.name);
    for (number, line) in lines(text).skip(1) {
        if let Some(row) = reader.row(number, line, &mut unread) {
            push(&mut out, &row);
        }
    }
    Ok(out)
}

fn names_of(names: &NamedColumns) -> Vec<String> {
    let rest = names
        .signals
        .iter()
        .chain(&names.forces)
        .chain(&names.cycle);
    std::iter::once(TIME.to_owned())
        .chain(rest.cloned())
        .collect()
}

/// A fault for each name that would stand twice.
fn twice(file: &str, names: &[String]) -> Vec<Fault> {
    let mut seen = HashSet::new();
    let again = names.iter().filter(|name| !seen.insert(*name));
    let told = again.map(|name| Fault {
        pointer: String::new(),
        detail: format!(
            "{file}: two columns would be called {}: leave one out by not_signals = [...] under [columns]",
            name.escape_debug()
        ),
    });
    told.collect()
}

/// A row with the fewest digits that read back bit for bit.
fn push(out: &mut String, row: &Row) {
    // Writing to a text can't fail.
    let _ = write!(out, "{:?}", row.time_s);
    for value in row.signals.iter().chain(&row.forces) {
        let _ = match value.is_finite() {
            true => write!(out, ",{value:?}"),
            false => write!(out, ","),
        };
    }
    if let Some(cycle) = &row.cycle {
        let _ = write!(out, ",{}", csv_cell::cell(cycle));
    }
    out.push('\n');
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::forces::fitting::{Fit, Work, fit};

    fn file(name: &str, text: String) -> NamedText {
        let name = name.to_owned();
        NamedText { name, text }
    }

    fn recipe(columns: &str) -> Recipe {
        let text = format!(
            "[columns]\n{columns}\n[features]\nsets = [\"raw\"]\n[models]\nkinds = [\"ridge\", \"gpr\"]\ngpr = {{ restarts = 1, search_rows = 40 }}\n"
        );
        Recipe::from_text(&text, document::Format::Toml).expect("a recipe")
    }

    fn learnt(recipe: &Recipe, files: &[NamedText]) -> Fit {
        let work = Work {
            threads: 2,
            told: &|_| {},
        };
        fit(recipe, files, work).expect("learns")
    }

    /// Rows by a writer of one: time in ms, two signals, a force in grams, empty in every fifth row, a press.
    fn rows(session: f64, line: impl Fn(u32, f64, f64, Option<f64>, &str) -> String) -> String {
        let row = |row: u32| {
            let t = 0.05 * f64::from(row);
            let grams = 500.0 * (0.9 * t).sin().powi(2);
            let noise = (f64::from(row * row) * (7.7 + session)).sin();
            let (a, b) = (
                session + 0.01 * grams + 0.03 * noise,
                grams.sqrt() - 0.1 * noise,
            );
            let force = (row % 5 != 4).then_some(grams);
            line(
                50 * row,
                a,
                b,
                force,
                ["one", "two, b", "three", "four"][(row / 30 % 4) as usize],
            )
        };
        (0..240).map(row).collect()
    }

    #[test]
    fn the_same_is_learnt_from_what_was_converted_to_the_bit() {
        let comma = |x: f64| format!("{x:?}").replace('.', ",");
        let made = |session: f64| {
            let text = rows(session, |ms, a, b, force, press| {
                let force = force.map_or(String::new(), comma);
                format!("{ms};{};{};note;{force};{press}\r\n", comma(a), comma(b))
            });
            format!("# rig 3\r\ntime_ms;a;\"b, V\";remark;force_g;press\r\n{text}")
        };
        let original = [file("a.csv", made(0.1)), file("b.csv", made(0.4))];
        let asked = recipe("cycle = \"press\"\nnot_signals = [\"remark\"]");
        let after = [0, 1].map(|k| {
            let text = converted(&asked, &original[k]).expect("converts");
            assert!(
                text.starts_with("time_s,a,\"b, V\",force_n,press\n0.0,"),
                "{text}"
            );
            file(&original[k].name, text)
        });
        let (first, second) = (learnt(&asked, &original), learnt(&asked, &after));
        // All but the names of the columns that were read.
        let as_converted = |fit: &Fit| {
            let mut estimator = fit.estimator.clone();
            estimator.columns = second.estimator.columns.clone();
            serde_json::to_string(&estimator).expect("writes")
        };
        assert_eq!(as_converted(&first), as_converted(&second));
        assert_eq!(first.left_out, second.left_out);
        assert_eq!(second.estimator.columns.time, TIME);
        // What was converted stays as it is.
        assert_eq!(converted(&asked, &after[0]), Ok(after[0].text.clone()));
    }

    #[test]
    fn what_may_mean_two_things_is_not_written() {
        let refused = |columns: &str, text: &str| {
            let found = converted(&recipe(columns), &file("a.csv", text.to_owned()));
            found.expect_err("is refused")[0].detail.clone()
        };
        let far = "t,a,fz_n\n0,1,2\n50,2,3\n100,3,4\n";
        assert!(refused("", far).contains("whose name says no unit"));
        let twice = "clock,time_s,fz_n\n0,1,2\n0.1,2,3\n";
        let found = refused("time = \"clock\"", twice);
        assert!(found.contains("would be called time_s"), "{found}");
        let faulty = "time_s,a,fz_n\n0,x,2\n";
        assert!(refused("", faulty).starts_with("a.csv, line 2, column a"));
    }

    #[test]
    fn a_recording_without_forces_is_converted() {
        let text = "sec,nanosec,a\n0,0,1\n0,50000000,-0\n".to_owned();
        let found = converted(&Recipe::default(), &file("a.csv", text));
        assert_eq!(found, Ok("time_s,a\n0.0,1.0\n0.05,-0.0\n".to_owned()));
    }
}
