//! `strainsite compare`: studies of a database side by side, without a service.

use std::fmt::Write;
use std::path::PathBuf;

use anstyle::Style;
use clap::Args;
use document::visible::visible;
use fem_client::solver::direction::Direction;
use placement::compare::{
    ComparedIndex, ComparedLocation, ComparedStudy, Comparison, Entry, MOST_TOLD, Verdict, compare,
};
use results::columns;
use serde_json::{Value, json};
use sqlx::SqliteConnection;

use crate::cli::commands::export::{deliver, readable};
use crate::cli::commands::library::{Database, study, the_only};
use crate::cli::terminal::exit::Failure;
use crate::cli::terminal::figures::Figures;
use crate::cli::terminal::files::Files;
use crate::cli::terminal::output::{JsonTarget, tell};
use crate::cli::terminal::paint::{FAINT, HEADER, STRONG, header, left, of_state, painted};
use crate::cli::terminal::wrapping::{COLUMNS, cut, labelled, told_apart, wrapped};
use service::comparison::{of_designs, of_studies};
use service::export::{ComparisonExport, ComparisonFormat, ComparisonTable};
use store::queue::design_rows;
use store::queue::short_names::{Listing, meant};

/// Compare studies, or the designs of a sweep: what differs, and which differences are real
#[derive(Debug, Args)]
pub(crate) struct Compare {
    /// Identifiers of studies or of one sweep, or their beginnings; latest is the last sweep alone, the last study beside others
    #[arg(required = true, value_name = "ID")]
    ids: Vec<String>,
    /// Study to take differences from; the first that has a result when absent
    #[arg(long, value_name = "ID")]
    baseline: Option<String>,
    #[command(flatten)]
    database: Database,
    /// Write the comparison as JSON to a file, or to standard output with -
    #[arg(long, value_name = "FILE|-")]
    pub json: Option<JsonTarget>,
    /// Write a file for other programs instead of the table
    #[arg(long, value_enum, value_name = "FORMAT", conflicts_with = "json")]
    format: Option<ComparisonFormat>,
    /// Content of CSV and Parquet
    #[arg(
        long,
        value_enum,
        value_name = "TABLE",
        default_value = "locations",
        requires = "format"
    )]
    table: ComparisonTable,
    /// File to write; standard output when absent
    #[arg(short, long, value_name = "FILE", requires = "format")]
    output: Option<PathBuf>,
}

impl Compare {
    /// Returns the files that it reads and writes.
    pub fn files(&self) -> Files {
        Files::of_database(self.database.file())
            .telling(self.json.as_ref())
            .writing(self.output.as_deref())
    }

    /// Prints the comparison, or writes it as a file.
    pub fn execute(&self) -> Result<(), Failure> {
        if let Some(format) = self.format {
            readable(format.file(), self.output.as_deref())?;
        }
        let entries = self
            .database
            .read(async |connection| self.entries(connection).await)?;
        let baseline = self.baseline.as_deref().map(|beginning| {
            let fits = |entry: &&Entry| entry.id.starts_with(beginning);
            the_only(entries.iter().filter(fits).collect(), "study", beginning)
        });
        let baseline = baseline.transpose()?.map(|entry| entry.id.as_str());
        let comparison = compare(&entries, baseline);
        if let Some(format) = self.format {
            let table = self.table;
            let bytes = ComparisonExport { format, table }.bytes(&comparison);
            let bytes = bytes.map_err(Failure::other)?;
            return deliver(format.file(), bytes, self.output.as_deref());
        }
        if let Some(target) = &self.json {
            target.write(&comparison)?;
        }
        tell(&table(&comparison.best(MOST_TOLD)), self.json.as_ref())
    }

    async fn entries(&self, connection: &mut SqliteConnection) -> Result<Vec<Entry>, Failure> {
        if let [id] = &self.ids[..] {
            let found = meant(connection, Listing::Sweeps, id).await;
            let found = found.map_err(Failure::other)?;
            if let [sweep] = &found[..] {
                let designs = design_rows::designs(connection, sweep, design_rows::ALL).await;
                let designs = designs.map_err(Failure::other)?;
                let entries = of_designs(connection, &designs).await;
                return entries.map_err(Failure::other);
            }
        }
        let mut rows = Vec::new();
        for id in &self.ids {
            rows.push(study(connection, id).await?);
        }
        of_studies(connection, &rows).await.map_err(Failure::other)
    }
}

/// All that is printed of a comparison.
pub fn table(comparison: &Comparison) -> String {
    let names: Vec<String> = comparison
        .studies
        .iter()
        .map(|study| study.name.escape_debug().to_string())
        .collect();
    let names = told_apart(&names, NAME);
    let width = names.iter().map(|name| name.chars().count()).max();
    let width = width.unwrap_or(0).max(6);
    let mut text = answers(comparison, &names, width);
    text.push_str(&overview(comparison, &names, width));
    for (direction, strain) in [
        (Direction::X, "circumferential (x)"),
        (Direction::Y, "meridional (y)"),
    ] {
        text.push_str(&matrix(comparison, direction, strain, &names, width));
    }
    for study in &comparison.studies {
        if let Some(reason) = &study.reason {
            let label = format!("- {}: {}", study.name.escape_debug(), study.state);
            text.push_str(&wrapped(&format!("{label}: {}", reason.escape_debug()), 2));
        }
    }
    for note in &comparison.notes {
        text.push_str(&wrapped(&format!("- {note}"), 2));
    }
    text
}

/// The study that answers best, and the layout of each, best first.
fn answers(comparison: &Comparison, names: &[String], width: usize) -> String {
    let answered = comparison.studies.iter().zip(names);
    let mut answered: Vec<_> = answered
        .filter(|(study, _)| study.answer.is_some())
        .collect();
    if answered.is_empty() {
        return String::new();
    }
    answered.sort_by_key(|(study, _)| study.answer.as_ref().map(|answer| answer.rank));
    let mut text = String::new();
    if let Some(best) = &comparison.answer {
        let sentence = visible(&best.sentence);
        text.push_str(&labelled(STRONG, best.verdict.as_str(), &sentence));
    }
    let rows: Vec<Value> = answered
        .iter()
        .map(|(study, _)| json!({ "study": study }))
        .collect();
    let figures = Figures::of(&columns::designs().view("answers"), &rows);
    text += &figures.head("design", width, "");
    for (row, (study, name)) in answered.iter().enumerate() {
        let words = study.answer.as_ref().map_or("", |answer| &*answer.words);
        let line = format!("{name:width$}{}", figures.row(row));
        let _ = writeln!(text, "{}", line.trim_end());
        let words = cut(visible(words), COLUMNS - 2);
        let _ = writeln!(text, "  {}", painted(FAINT, &words));
    }
    text.push('\n');
    text
}

/// A line for each study: force, signals, who wins, what it took.
fn overview(comparison: &Comparison, names: &[String], width: usize) -> String {
    let mut text = header(&format!(
        "{:width$} {:<9} {:>8} {:>6} {:>6} {:<12} {:>6} {:>6} {:>7}\n{:width$} {:<9} {:>8} {}\n",
        "design",
        "state",
        "force, N",
        "std x",
        "std y",
        "best",
        "solves",
        "reused",
        "time, s",
        "",
        "",
        "",
        "strain, 1e-6"
    ));
    for (study, name) in comparison.studies.iter().zip(names) {
        text.push_str(&line(study, name, width));
    }
    text.push('\n');
    text
}

fn line(study: &ComparedStudy, name: &str, width: usize) -> String {
    let number = |value: Option<f64>, decimals: usize| {
        value.map_or_else(|| "-".to_owned(), |value| format!("{value:.decimals$}"))
    };
    let micro = |strain: Option<f64>| number(strain.map(|strain| 1e6 * strain), 0);
    let (style, best) = match (&study.best, study.best_certain) {
        (Some(best), Some(true)) => (STRONG, format!("{best} certain")),
        (Some(best), _) => (FAINT, format!("{best} uncertain")),
        (None, _) => (FAINT, "-".to_owned()),
    };
    let cost = study.cost.as_ref();
    let count = |part: Option<usize>| part.map_or_else(|| "-".to_owned(), |part| part.to_string());
    format!(
        "{:width$} {} {:>8} {:>6} {:>6} {} {:>6} {:>6} {:>7}\n",
        name,
        left(of_state(&study.state), &study.state, 9),
        number(study.reaction_n, 2),
        micro(study.std_strain_x),
        micro(study.std_strain_y),
        left(style, &best, 12),
        count(cost.map(|cost| cost.solves
            + cost.coarser_solves
            + cost.effect_solves
            + cost.signal_solves)),
        count(cost.map(|cost| cost.reused)),
        number(cost.map(|cost| cost.wall_s), 1),
    )
}

/// Studies by locations: the index of each location's own depth, and its difference from the baseline.
fn matrix(
    comparison: &Comparison,
    direction: Direction,
    strain: &str,
    names: &[String],
    width: usize,
) -> String {
    let mut places: Vec<&str> = comparison
        .rows
        .iter()
        .map(|row| row.location.as_str())
        .collect();
    places.sort_unstable();
    places.dedup();
    if places.is_empty() {
        return String::new();
    }
    let caption = format!(
        "first-order index of each location's own depth for the {strain} strain at the centre, %; in brackets the difference from {}, with its error, * where it is real",
        baseline_name(comparison)
    );
    let mut text = wrapped(&caption, 0);
    // As many places beside each other as there is room for.
    for few in places.chunks(((COLUMNS - width) / (CELL + 1)).max(1)) {
        text.push_str(&block(comparison, direction, few, names, width));
    }
    text.push('\n');
    text
}

/// Some of the places, for every study that has them.
fn block(
    comparison: &Comparison,
    direction: Direction,
    places: &[&str],
    names: &[String],
    width: usize,
) -> String {
    let mut heads = format!("{:width$}", "design");
    for place in places {
        let _ = write!(heads, " {place:<CELL$}");
    }
    let mut text = painted(HEADER, heads.trim_end()) + "\n";
    for (study, name) in comparison.studies.iter().zip(names) {
        let of_study: Vec<&ComparedLocation> = comparison
            .rows
            .iter()
            .filter(|row| row.study == study.id)
            .collect();
        if of_study.is_empty() {
            continue;
        }
        let _ = write!(text, "{name:width$}");
        for place in places {
            let row = of_study.iter().find(|row| row.location == *place);
            let index = row.map(|row| row.in_direction(direction));
            let cell = index.map_or_else(|| pad("-", "", Style::new()), cell);
            let _ = write!(text, " {cell}");
        }
        // Padding at a line's end is of no use to anybody.
        text.truncate(text.trim_end().len());
        text.push('\n');
    }
    text
}

/// Most columns of a design's name.
const NAME: usize = 19;

/// Width of a cell.
const CELL: usize = 24;

fn baseline_name(comparison: &Comparison) -> String {
    let id = comparison.baseline.as_deref();
    let base = comparison
        .studies
        .iter()
        .find(|study| Some(study.id.as_str()) == id);
    base.map_or_else(
        || "nobody".to_owned(),
        |study| study.name.escape_debug().to_string(),
    )
}

/// The index, and behind it the difference: what is noise stands back.
fn cell(index: &ComparedIndex) -> String {
    let Some(percent) = index.gsi_percent else {
        return pad("-", "", Style::new());
    };
    let percent = format!("{percent:6.2}");
    let Some(difference) = index.difference_percent else {
        return pad(&percent, "", Style::new());
    };
    let error = index
        .difference_error_percent
        .map_or_else(|| "+-?".to_owned(), |error| format!("+-{error:.2}"));
    let (style, mark) = match index.verdict {
        Some(Verdict::Real) => (STRONG, "*"),
        _ => (FAINT, ""),
    };
    pad(
        &(percent + " "),
        &format!("({difference:+.2}{error}{mark})"),
        style,
    )
}

/// A cell whose second part is painted.
fn pad(first: &str, second: &str, style: Style) -> String {
    let rest = CELL.saturating_sub(first.chars().count());
    first.to_owned() + &left(style, second, rest)
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;
    use crate::cli::terminal::shown::{plain, shown};

    #[test]
    fn a_real_difference_stands_out_and_noise_stands_back_in_cells_of_one_width() {
        let index = |verdict, error| ComparedIndex {
            gsi_percent: Some(71.64),
            difference_percent: Some(3.55),
            difference_error_percent: error,
            verdict: Some(verdict),
            ..ComparedIndex::default()
        };
        let real = cell(&index(Verdict::Real, Some(1.82)));
        let noise = cell(&index(Verdict::Noise, Some(5.0)));
        assert!(
            shown(&real).contains("\u{1b}[1m(+3.55+-1.82*)\u{1b}[0m"),
            "{real:?}"
        );
        assert!(
            shown(&noise).contains("\u{1b}[2m(+3.55+-5.00)\u{1b}[0m"),
            "{noise:?}"
        );
        for cell in [real, noise] {
            let plain = plain(&cell);
            assert_eq!(plain.chars().count(), CELL, "{plain:?}");
        }
    }

    #[test]
    fn long_names_and_many_places_fit_the_columns() -> Result<(), serde_json::Error> {
        let ids = ["one", "two"];
        let studies: Vec<_> = ids.map(study).into();
        let index = json!({"gsi_percent": 71.64, "difference_percent": -13.55, "difference_error_percent": 11.82, "verdict": "real"});
        let places = ["P1", "P2", "P3", "P4", "P5"];
        let of = |id: &str| {
            places.map(|place| json!({"study": id, "location": place, "rank": 1, "rank_certain": true, "x": index, "y": index}))
        };
        let rows: Vec<_> = ids.into_iter().flat_map(of).collect();
        let notes = ["A note of many words. ".repeat(9)];
        let comparison = json!({"answer": {"sentence": "With up to 24 films they are alike. ".repeat(5), "verdict": "tied"}, "baseline": "one", "studies": studies, "rows": rows, "notes": notes});
        let text = table(&serde_json::from_value(comparison)?);
        let plain = plain(&text);
        for line in plain.lines() {
            assert!(line.chars().count() <= COLUMNS, "{line:?}");
        }
        for seen in [
            "... one",
            "... two",
            "P5",
            "1.92 +-0.13",
            "-1.50 +-0.25",
            "tied: ",
            "(-13.55+-11.82*)",
        ] {
            assert!(plain.contains(seen), "{seen}: {plain}");
        }
        Ok(())
    }

    fn study(id: &str) -> Value {
        let name = format!("a study with a name that many others of the database begin with, {id}");
        json!({"id": id, "name": name, "state": "cancelled", "reaction_n": 123.456, "std_strain_x": 0.0125, "std_strain_y": 0.0069,
            "best": "P3", "best_certain": false, "layout_spacing_deg": 180.0, "layout_position": "shoulder",
            "answer": {"rank": 1, "layout_rank": 4, "words": "24 films along x and y in turn at the shoulder, one every 15 degrees, the first at 13.8 degrees",
                       "film_count": 24, "meets": null, "verdict": "certain", "force_n": null, "trade": [],
                       "angle_deg": {"value": 1.92, "error": 0.13, "difference": -1.5, "difference_error": 0.25, "verdict": "real"}}})
    }
}
