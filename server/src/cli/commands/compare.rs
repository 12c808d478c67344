//! `strainsite compare`: studies of a database side by side, without a service.

use std::fmt::Write;
use std::path::PathBuf;

use anstyle::Style;
use clap::Args;
use fem_client::solver::direction::Direction;
use placement::compare::{
    ComparedIndex, ComparedLocation, ComparedStudy, Comparison, Entry, Verdict, compare,
};
use sqlx::SqliteConnection;

use crate::cli::commands::export::{deliver, readable};
use crate::cli::commands::library::{Database, study, the_only};
use crate::cli::terminal::exit::Failure;
use crate::cli::terminal::files::Files;
use crate::cli::terminal::output::{JsonTarget, tell};
use crate::cli::terminal::paint::{FAINT, HEADER, STRONG, header, left, of_state, painted};
use service::comparison::{of_designs, of_studies};
use service::export::{ComparisonExport, ComparisonFormat, ComparisonTable};
use store::queue::sweep_rows;

/// Compare studies, or the designs of a sweep: what differs, and which differences are real
#[derive(Debug, Args)]
pub struct Compare {
    /// Identifiers of studies or of one sweep, or their beginnings
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
    /// What CSV and Parquet hold
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
    /// What it reads and writes.
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
        tell(&table(&comparison), self.json.as_ref())
    }

    async fn entries(&self, connection: &mut SqliteConnection) -> Result<Vec<Entry>, Failure> {
        if let [id] = &self.ids[..] {
            let found = sweep_rows::beginning_with(connection, id, 2).await;
            let mut found = found.map_err(Failure::other)?;
            if let (Some(sweep), true) = (found.pop(), found.is_empty()) {
                let designs = sweep_rows::designs(connection, &sweep.id).await;
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
    let width = comparison
        .studies
        .iter()
        .map(|study| study.name.chars().count())
        .max()
        .unwrap_or(0)
        .clamp(6, 60);
    let mut text = overview(comparison, width);
    for (direction, strain) in [
        (Direction::X, "circumferential (x)"),
        (Direction::Y, "meridional (y)"),
    ] {
        text.push_str(&matrix(comparison, direction, strain, width));
    }
    for study in &comparison.studies {
        if let Some(reason) = &study.reason {
            let _ = writeln!(
                text,
                "- {}: {}: {}",
                study.name.escape_debug(),
                painted(of_state(&study.state), &study.state),
                reason.escape_debug()
            );
        }
    }
    for note in &comparison.notes {
        let _ = writeln!(text, "- {note}");
    }
    text
}

/// A line for each study: force, signals, who wins, what it took.
fn overview(comparison: &Comparison, width: usize) -> String {
    let mut text = header(&format!(
        "{:width$}  {:<9} {:>8} {:>9} {:>9}  {:<14} {:<14} {:>7} {:>7} {:>8}\n{:width$}  {:<9} {:>8} {:>9} {:>9}\n",
        "design",
        "state",
        "force, N",
        "signal x",
        "signal y",
        "best",
        "best layout",
        "solves",
        "reused",
        "time, s",
        "",
        "",
        "",
        "(std of the strain, 1e-6)",
        ""
    ));
    for study in &comparison.studies {
        text.push_str(&line(study, width));
    }
    text.push('\n');
    text
}

fn line(study: &ComparedStudy, width: usize) -> String {
    let number = |value: Option<f64>, decimals: usize| {
        value.map_or_else(|| "-".to_owned(), |value| format!("{value:.decimals$}"))
    };
    let micro = |strain: Option<f64>| number(strain.map(|strain| 1e6 * strain), 0);
    let (style, best) = match (&study.best, study.best_certain) {
        (Some(best), Some(true)) => (STRONG, format!("{best} certain")),
        (Some(best), _) => (FAINT, format!("{best} uncertain")),
        (None, _) => (FAINT, "-".to_owned()),
    };
    let layout = match (study.layout_spacing_deg, &study.layout_position) {
        (Some(spacing), Some(position)) => format!("{spacing} deg {position}"),
        _ => "-".to_owned(),
    };
    let cost = study.cost.as_ref();
    let count = |part: Option<usize>| part.map_or_else(|| "-".to_owned(), |part| part.to_string());
    format!(
        "{:width$}  {} {:>8} {:>9} {:>9}  {} {:<14} {:>7} {:>7} {:>8}\n",
        shortened(&study.name, width),
        left(of_state(&study.state), &study.state, 9),
        number(study.reaction_n, 2),
        micro(study.std_strain_x),
        micro(study.std_strain_y),
        left(style, &best, 14),
        layout,
        count(cost.map(|cost| cost.solves
            + cost.coarser_solves
            + cost.effect_solves
            + cost.signal_solves)),
        count(cost.map(|cost| cost.reused)),
        number(cost.map(|cost| cost.wall_s), 2),
    )
}

fn shortened(name: &str, width: usize) -> String {
    let name: String = name.escape_debug().collect();
    if name.chars().count() <= width {
        return name;
    }
    let start: String = name.chars().take(width - 3).collect();
    start + "..."
}

/// Studies by locations: the index of each location's own depth, and its difference from the baseline.
fn matrix(comparison: &Comparison, direction: Direction, strain: &str, width: usize) -> String {
    let mut names: Vec<&str> = comparison
        .rows
        .iter()
        .map(|row| row.location.as_str())
        .collect();
    names.sort_unstable();
    names.dedup();
    if names.is_empty() {
        return String::new();
    }
    let caption = format!(
        "first-order index of each location's own depth for the {strain} strain at the centre, %; in brackets the difference from {}, with its error, * where it is real\n",
        baseline_name(comparison)
    );
    let mut heads = format!("{:width$}", "design");
    for name in &names {
        let _ = write!(heads, "  {name:<CELL$}");
    }
    let mut text = caption + &painted(HEADER, heads) + "\n";
    for study in &comparison.studies {
        let of_study: Vec<&ComparedLocation> = comparison
            .rows
            .iter()
            .filter(|row| row.study == study.id)
            .collect();
        if of_study.is_empty() {
            continue;
        }
        let _ = write!(text, "{:width$}", shortened(&study.name, width));
        for name in &names {
            let row = of_study.iter().find(|row| row.location == *name);
            let index = row.map(|row| row.in_direction(direction));
            let cell = index.map_or_else(|| pad("-", "", Style::new()), cell);
            let _ = write!(text, "  {cell}");
        }
        // Padding at a line's end is of no use to anybody.
        text.truncate(text.trim_end().len());
        text.push('\n');
    }
    text.push('\n');
    text
}

/// Width of a cell.
const CELL: usize = 22;

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
    use super::*;

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
            real.contains("\u{1b}[1m(+3.55+-1.82*)\u{1b}[0m"),
            "{real:?}"
        );
        assert!(
            noise.contains("\u{1b}[2m(+3.55+-5.00)\u{1b}[0m"),
            "{noise:?}"
        );
        for cell in [real, noise] {
            let plain = anstream::adapter::strip_str(&cell).to_string();
            assert_eq!(plain.chars().count(), CELL, "{plain:?}");
        }
    }
}
