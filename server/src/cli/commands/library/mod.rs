//! `strainsite list` and `show`: the database without a service, also while one runs; `presets`: what ships.

mod presets;

use std::fmt::Write;
use std::path::{Path, PathBuf};

use clap::Args;
use results::StudyResult;
use serde_json::{Value, json};
use sqlx::SqliteConnection;
use tokio::runtime::Runtime;

pub use presets::Presets;

use crate::cli::terminal::exit::Failure;
use crate::cli::terminal::files::Files;
use crate::cli::terminal::output::{JsonTarget, is_seen, tell};
use crate::cli::terminal::paint::{BAD, header, left, of_state, painted};
use crate::cli::terminal::progress::clock;
use crate::cli::terminal::report::report;
use service::wire::study_wire::StudySummary;
use service::wire::sweep_wire::SweepSummary;
use store::answers::result_rows::{self, Extent};
use store::file::opening;
use store::queue::design_rows;
use store::queue::listed::{Archived, Listed};
use store::queue::short_names::{Listing, meant};
use store::queue::study_rows::{self, Filter, State, StudyRow};
use store::queue::sweep_rows::{self, SweepRow};

/// The database to read.
#[derive(Debug, Args)]
pub struct Database {
    /// Database file
    #[arg(
        long,
        env = "STRAINSITE_DB",
        value_name = "FILE",
        default_value = "strainsite.db"
    )]
    db: PathBuf,
}

impl Database {
    /// Returns its file.
    pub fn file(&self) -> &Path {
        &self.db
    }

    /// Lends a connection that can only read.
    pub fn read<T>(
        &self,
        task: impl AsyncFnOnce(&mut SqliteConnection) -> Result<T, Failure>,
    ) -> Result<T, Failure> {
        let runtime = Runtime::new().map_err(Failure::other)?;
        runtime.block_on(async {
            let mut connection = opening::to_read(&self.db).await.map_err(Failure::other)?;
            let waiting = clock("reading the database");
            let done = task(&mut connection).await;
            waiting.finish_and_clear();
            done
        })
    }
}

/// The study of this identifier, of the only one that begins so, or the latest.
pub async fn study(connection: &mut SqliteConnection, id: &str) -> Result<StudyRow, Failure> {
    let found = meant(connection, Listing::Studies, id).await;
    let id = the_only(found.map_err(Failure::other)?, "study", id)?;
    let study = study_rows::find(connection, &id).await;
    let study = study.map_err(Failure::other)?;
    study.ok_or_else(|| Failure::input(format!("study {id} was removed meanwhile")))
}

/// The sweep of this identifier, of the only one that begins so, or the latest.
pub(crate) async fn sweep(
    connection: &mut SqliteConnection,
    id: &str,
) -> Result<SweepRow, Failure> {
    let found = meant(connection, Listing::Sweeps, id).await;
    let id = the_only(found.map_err(Failure::other)?, "sweep", id)?;
    let sweep = sweep_rows::find(connection, &id).await;
    let sweep = sweep.map_err(Failure::other)?;
    sweep.ok_or_else(|| Failure::input(format!("sweep {id} was removed meanwhile")))
}

/// Returns what was found under the beginning of an identifier, where that is one.
pub(crate) fn the_only<T>(mut found: Vec<T>, kind: &str, beginning: &str) -> Result<T, Failure> {
    match (found.pop(), found.is_empty()) {
        (Some(one), true) => Ok(one),
        (Some(_), false) => Err(Failure::input(format!(
            "more than one {kind} begins with {beginning:?}: give more of the identifier"
        ))),
        (None, _) => Err(Failure::input(format!(
            "there is no {kind} {beginning:?}; strainsite list shows those there are"
        ))),
    }
}

/// List the studies of a database, newest first
#[derive(Debug, Args)]
pub(crate) struct List {
    #[command(flatten)]
    database: Database,
    /// Studies of this state alone: queued, running, done, failed, cancelled
    #[arg(long, value_name = "STATE", value_parser = state)]
    state: Option<State>,
    /// List the sweeps instead
    #[arg(long, conflicts_with = "state")]
    sweeps: bool,
    /// Part of the name, in small or capital letters, or beginning of the identifier, of those that are listed alone
    #[arg(long, value_name = "TEXT")]
    search: Option<String>,
    /// List what was archived, which is left out otherwise
    #[arg(long)]
    archived: bool,
    /// Most studies or sweeps to list
    #[arg(long, value_name = "N", default_value_t = 50)]
    limit: u32,
    /// Write the list as JSON to a file, or to standard output with -
    #[arg(long, value_name = "FILE|-")]
    pub json: Option<JsonTarget>,
}

fn state(name: &str) -> Result<State, String> {
    State::named(name)
        .ok_or_else(|| "a state is queued, running, done, failed or cancelled".to_owned())
}

impl List {
    /// Returns the files that it reads and writes.
    pub fn files(&self) -> Files {
        Files::of_database(self.database.file()).telling(self.json.as_ref())
    }

    /// Prints a line for each study or sweep.
    pub fn execute(&self) -> Result<(), Failure> {
        if self.sweeps {
            return self.list_sweeps();
        }
        let rows = self.database.read(async |connection| {
            let filter = Filter {
                state: self.state,
                sweep: None,
                listed: self.listed(),
            };
            let page = study_rows::page(connection, filter, None, self.limit).await;
            page.map_err(Failure::other)
        })?;
        if let Some(target) = &self.json {
            let studies: Vec<StudySummary> = rows.iter().map(StudySummary::of).collect();
            target.write(&json!({"studies": studies}))?;
        }
        let text = headed_studies(&rows, self.json.as_ref());
        tell(&text, self.json.as_ref())
    }

    fn listed(&self) -> Listed<'_> {
        Listed {
            search: self.search.as_deref(),
            archived: if self.archived {
                Archived::Alone
            } else {
                Archived::Without
            },
        }
    }

    fn list_sweeps(&self) -> Result<(), Failure> {
        let summaries = self.database.read(async |connection| {
            let page = sweep_rows::page(connection, self.listed(), None, self.limit).await;
            let mut summaries = Vec::new();
            for row in page.map_err(Failure::other)? {
                let standing = design_rows::standing(connection, &row.id).await;
                summaries.push(SweepSummary::of(&row, &standing.map_err(Failure::other)?));
            }
            Ok(summaries)
        })?;
        if let Some(target) = &self.json {
            target.write(&json!({"sweeps": summaries}))?;
        }
        let lines: Vec<Line> = summaries.iter().map(line_of_sweep).collect();
        let text = headed("sweep", "designs done", &lines, self.json.as_ref());
        tell(&text, self.json.as_ref())
    }
}

/// Line of a list on a study or a sweep.
struct Line<'r> {
    id: &'r str,
    state: &'static str,
    done: String,
    total: String,
    created: &'r str,
    name: &'r str,
    /// Answer in few characters.
    brief: Option<&'r str>,
}

fn line_of_study(row: &StudyRow) -> Line<'_> {
    Line {
        id: &row.id,
        state: row.state().as_str(),
        done: row.points_done.to_string(),
        total: row
            .points_total
            .map_or("?".to_owned(), |total| total.to_string()),
        created: &row.created,
        name: &row.name,
        brief: row.brief.as_deref(),
    }
}

fn line_of_sweep(sweep: &SweepSummary) -> Line<'_> {
    let counts = &sweep.counts;
    let total = counts.queued + counts.running + counts.done + counts.failed + counts.cancelled;
    Line {
        id: &sweep.id,
        state: sweep.state.as_str(),
        done: counts.done.to_string(),
        total: total.to_string(),
        created: &sweep.created,
        name: &sweep.name,
        brief: None,
    }
}

fn headed_studies(rows: &[StudyRow], json: Option<&JsonTarget>) -> String {
    let lines: Vec<Line> = rows.iter().map(line_of_study).collect();
    headed("study", "points", &lines, json)
}

/// The lines below a header, which only people need: scripts take a line for a study.
fn headed(kind: &str, counted: &str, lines: &[Line], json: Option<&JsonTarget>) -> String {
    let mut text = String::new();
    if is_seen(json) && !lines.is_empty() {
        let head = format!(
            "{kind:<36}  {:<9}  {counted:<16}  {:<24}  name\n",
            "state", "created"
        );
        text = header(&head);
    }
    for line in lines {
        let _ = writeln!(
            text,
            "{}  {}  {:>6} of {:<6}  {}  {}",
            line.id,
            left(of_state(line.state), line.state, 9),
            line.done,
            line.total,
            line.created,
            line.name.escape_debug()
        );
        if let Some(brief) = line.brief {
            text.insert_str(text.len() - 1, &format!(": {}", brief.escape_debug()));
        }
    }
    text
}

/// Show a study: its ranked table, or how far it is
#[derive(Debug, Args)]
pub(crate) struct Show {
    /// Identifier of the study, its beginning, or latest
    id: String,
    #[command(flatten)]
    database: Database,
    /// Write study and result as JSON to a file, or to standard output with -
    #[arg(long, value_name = "FILE|-")]
    pub json: Option<JsonTarget>,
}

impl Show {
    /// Returns the files that it reads and writes.
    pub fn files(&self) -> Files {
        Files::of_database(self.database.file()).telling(self.json.as_ref())
    }

    /// Prints the study.
    pub fn execute(&self) -> Result<(), Failure> {
        let (row, found) = self.database.read(async |connection| {
            let row = study(connection, &self.id).await?;
            let found = result_rows::find(connection, &row.id, Extent::Whole).await;
            Ok((row, found.map_err(Failure::other)?))
        })?;
        let found: Option<StudyResult> = found.map(|(result, _)| result);
        if let Some(target) = &self.json {
            let document = row.document().map_err(Failure::other)?;
            let document: Value = serde_json::from_str(document).map_err(Failure::other)?;
            let study = StudySummary::of(&row);
            target.write(&json!({"study": study, "document": document, "result": found}))?;
        }
        let mut text = headed_studies(std::slice::from_ref(&row), self.json.as_ref());
        if let Some(error) = &row.error {
            let _ = writeln!(text, "{}", painted(BAD, error.escape_debug()));
        }
        if let Some(result) = &found {
            text = format!("{text}\n{}", report(result));
        }
        tell(&text, self.json.as_ref())
    }
}
