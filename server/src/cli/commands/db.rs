//! `strainsite db`: looks after the database file.

use std::path::{Path, PathBuf};
use std::pin::pin;
use std::time::Duration;

use clap::{Args, Subcommand, ValueEnum};
use serde::Serialize;
use tokio::runtime::Runtime;

use crate::cli::terminal::exit::Failure;
use crate::cli::terminal::files::Files;
use crate::cli::terminal::output::{JsonTarget, tell};
use crate::cli::terminal::paint::{BAD, GOOD, painted};
use crate::cli::terminal::progress::{TICK, bytes_bar, clock, count, counting_bar};
use crate::config::age;
use store::StoreError;
use store::clock::before;
use store::file::copies::{self, Replaced};
use store::file::opening;
use store::file::upkeep::{self, Inspection};
use store::merging::parts::{Counted, Merged, Taken};
use store::merging::target::Merging;
use store::merging::whole_file::read_ahead;
use store::removal::pruning::{Mode, Pruned, prune};
use store::removal::retention::Retention;

/// Look after the database file
#[derive(Debug, Args)]
pub(crate) struct Db {
    #[command(subcommand)]
    task: Task,
    /// Database file
    #[arg(
        long,
        global = true,
        env = "STRAINSITE_DB",
        value_name = "FILE",
        default_value = "strainsite.db"
    )]
    db: PathBuf,
    /// Write what was found as JSON to a file, or to standard output with -
    #[arg(long, global = true, value_name = "FILE|-")]
    pub json: Option<JsonTarget>,
}

#[derive(Debug, Subcommand)]
enum Task {
    /// Read every row and compare it with its hash; also while the service runs
    Check,
    /// Write a copy to a file that isn't there yet; also while the service runs
    Backup {
        /// The copy
        target: PathBuf,
    },
    /// Put a copy in the place of the database; not while the service runs
    Restore {
        /// The copy: all of it is read and compared with its hashes first
        backup: PathBuf,
        /// Don't keep the database that was there beside the new one
        #[arg(long)]
        discard: bool,
    },
    /// Take in what other databases have: points and runs of models by their keys, ended studies by their identifiers; not while the service runs
    Merge {
        /// Databases, each read whole and compared with its hashes first; one that says something else than this one does is refused
        #[arg(required = true, value_name = "FILE")]
        files: Vec<PathBuf>,
        /// Part that is taken; everything when nothing is said
        #[arg(long, value_enum, value_name = "PART")]
        keep: Option<Part>,
    },
    /// Remove old studies and sweeps, with the points that no other study has; not while the service runs
    Prune {
        /// Least time since they ended: a number of minutes, hours, days or weeks, as in 90d
        #[arg(long, value_name = "AGE", value_parser = age)]
        older_than: Duration,
        /// Keep the newest result, and the newest sweep, of each name
        #[arg(long)]
        keep_named: bool,
        /// Count what would be removed, and remove nothing
        #[arg(long)]
        dry_run: bool,
    },
    /// Give free pages back to the disk; not while the service runs
    Vacuum,
    /// Let points be solved again that the program died of three times; not while the service runs
    Release,
}

/// Part of a database.
#[derive(Debug, Clone, Copy, ValueEnum)]
enum Part {
    /// Points and runs of models alone, which studies and `gsa run` here then find
    Points,
    /// All but points, runs of models and estimators: results, with nothing to analyse them again from
    Results,
}

/// File that was merged, or refused, as JSON.
#[derive(Debug, Serialize)]
struct MergedFile {
    file: PathBuf,
    #[serde(skip_serializing_if = "Option::is_none")]
    taken: Option<Merged>,
    #[serde(skip_serializing_if = "Option::is_none")]
    refused: Option<String>,
}

impl Db {
    /// Returns the files that it reads and writes.
    pub fn files(&self) -> Files {
        Files::of_database(&self.db).telling(self.json.as_ref())
    }

    /// Does the task.
    pub fn execute(&self) -> Result<(), Failure> {
        let runtime = Runtime::new().map_err(Failure::other)?;
        match &self.task {
            Task::Check => self.check(&runtime),
            Task::Backup { target } => self.backup(&runtime, target),
            Task::Restore { backup, discard } => self.restore(&runtime, backup, *discard),
            Task::Prune {
                older_than,
                keep_named,
                dry_run,
            } => {
                let retention = Retention {
                    before: before(*older_than),
                    keeps_named: *keep_named,
                };
                self.prune(&runtime, &retention, *dry_run)
            }
            Task::Merge { files, keep } => self.merge(&runtime, files, *keep),
            Task::Vacuum => self.vacuum(&runtime),
            Task::Release => self.release(&runtime),
        }
    }

    fn check(&self, runtime: &Runtime) -> Result<(), Failure> {
        let found = runtime.block_on(async {
            let bar = counting_bar(0, "rows");
            let seen = |done, of| count(&bar, done, of);
            let found = upkeep::inspect(&self.db, &seen).await;
            bar.finish_and_clear();
            found
        });
        let found = found.map_err(Failure::other)?;
        if let Some(target) = &self.json {
            target.write(&found)?;
        }
        tell(&report(&self.db, &found), self.json.as_ref())?;
        match found.faults.len() {
            0 => Ok(()),
            1 => Err(Failure::Other("the database has a fault".to_owned())),
            faults => Err(Failure::Other(format!("the database has {faults} faults"))),
        }
    }

    fn backup(&self, runtime: &Runtime, target: &Path) -> Result<(), Failure> {
        let copied = runtime.block_on(async {
            let mut connection = opening::to_read(&self.db).await?;
            let bar = bytes_bar(upkeep::used_bytes(&mut connection).await?);
            let copy = copies::begin(&self.db, target)?;
            let written = || size(copy.path()).unwrap_or(0);
            let copying = copies::write(&mut connection, &copy);
            let copied = watched(copying, || bar.set_position(written())).await;
            bar.finish_and_clear();
            copied.and_then(|()| copy.place())
        });
        copied.map_err(Failure::other)?;
        let text = format!("{} was copied to {}\n", self.db.display(), target.display());
        tell(&text, self.json.as_ref())
    }

    fn restore(&self, runtime: &Runtime, backup: &Path, discard: bool) -> Result<(), Failure> {
        let replaced = match discard {
            true => Replaced::Discarded,
            false => Replaced::Kept,
        };
        let bar = counting_bar(0, "rows");
        let seen = |done, of| count(&bar, done, of);
        let kept = runtime.block_on(copies::restore(backup, &self.db, replaced, &seen));
        bar.finish_and_clear();
        let mut text = format!(
            "{} holds what {} does\n",
            self.db.display(),
            backup.display()
        );
        if let Some(kept) = kept.map_err(Failure::other)? {
            text.push_str(&format!(
                "the database that was there is kept as {}\n",
                kept.display()
            ));
        }
        tell(&text, self.json.as_ref())
    }

    fn merge(
        &self,
        runtime: &Runtime,
        files: &[PathBuf],
        keep: Option<Part>,
    ) -> Result<(), Failure> {
        let taken = match keep {
            None => Taken::Everything,
            Some(Part::Points) => Taken::Points,
            Some(Part::Results) => Taken::Results,
        };
        let merged = runtime.block_on(async {
            let mut merging = Merging::open(&self.db).await?;
            let reader = merging.reader();
            let bar = counting_bar(0, "rows");
            let seen = |done, of| count(&bar, done, of);
            let read = async |file: &PathBuf| reader.read(file, &seen).await;
            let merged = read_ahead(files, read, async |file, whole| {
                let found = match whole {
                    Ok(whole) => merging.take(&whole, taken).await,
                    Err(refused) => Err(refused),
                };
                MergedFile::of(file, found)
            });
            let merged = merged.await?;
            bar.finish_and_clear();
            merging.close().await?;
            Ok(merged)
        });
        let merged: Vec<MergedFile> = merged.map_err(|error: StoreError| Failure::other(error))?;
        if let Some(target) = &self.json {
            target.write(&merged)?;
        }
        let text: String = merged.iter().map(MergedFile::text).collect();
        tell(&text, self.json.as_ref())?;
        match merged.iter().filter(|one| one.refused.is_some()).count() {
            0 => Ok(()),
            refused => Err(Failure::Other(format!(
                "{refused} of {} weren't merged",
                counted(files.len() as u64, "file", "files")
            ))),
        }
    }

    fn release(&self, runtime: &Runtime) -> Result<(), Failure> {
        let released = runtime.block_on(upkeep::release(&self.db));
        let text = match released.map_err(Failure::other)? {
            1 => "one point may be tried again\n".to_owned(),
            points => format!("{points} points may be tried again\n"),
        };
        tell(&text, self.json.as_ref())
    }

    fn prune(
        &self,
        runtime: &Runtime,
        retention: &Retention,
        dry_run: bool,
    ) -> Result<(), Failure> {
        let mode = if dry_run { Mode::Count } else { Mode::Remove };
        let waiting = clock("pruning");
        let pruned = runtime.block_on(prune(&self.db, retention, mode));
        waiting.finish_and_clear();
        let pruned = pruned.map_err(Failure::other)?;
        if let Some(target) = &self.json {
            target.write(&pruned)?;
        }
        tell(&pruned_text(&pruned, mode), self.json.as_ref())
    }

    fn vacuum(&self, runtime: &Runtime) -> Result<(), Failure> {
        let before = size(&self.db)?;
        let waiting = clock("compacting");
        let compacted = runtime.block_on(upkeep::compact(&self.db));
        waiting.finish_and_clear();
        compacted.map_err(Failure::other)?;
        let text = format!(
            "{} went from {before} to {} bytes\n",
            self.db.display(),
            size(&self.db)?
        );
        tell(&text, self.json.as_ref())
    }
}

impl MergedFile {
    /// A file that was taken or refused; what else failed isn't the file's fault.
    fn of(file: &Path, found: Result<Merged, StoreError>) -> Result<Self, StoreError> {
        let (taken, refused) = match found {
            Ok(taken) => (Some(taken), None),
            Err(
                error @ (StoreError::Merge { .. }
                | StoreError::Open { .. }
                | StoreError::InUse { .. }),
            ) => (None, Some(error.to_string())),
            Err(error) => return Err(error),
        };
        Ok(Self {
            file: file.to_owned(),
            taken,
            refused,
        })
    }

    fn text(&self) -> String {
        let Some(taken) = &self.taken else {
            let refused = self.refused.as_deref().unwrap_or_default();
            return format!("- {}\n", painted(BAD, refused));
        };
        let kinds = [
            (taken.studies, "study", "studies"),
            (taken.sweeps, "sweep", "sweeps"),
            (taken.points, "point", "points"),
            (taken.model_runs, "run of a model", "runs of models"),
            (taken.trades, "measured trade", "measured trades"),
            (taken.estimators, "estimator", "estimators"),
        ];
        let words = |count: fn(Counted) -> u64| {
            let some = kinds.iter().filter(|(kind, ..)| count(*kind) > 0);
            let words: Vec<String> = some
                .map(|(kind, one, many)| counted(count(*kind), one, many))
                .collect();
            (!words.is_empty()).then(|| words.join(", "))
        };
        let taken = words(|kind| kind.new).unwrap_or_else(|| "nothing new".to_owned());
        let known = words(|kind| kind.known)
            .map_or(String::new(), |known| format!("; known before: {known}"));
        format!("{}: {taken}{known}\n", self.file.display())
    }
}

fn counted(count: u64, one: &str, many: &str) -> String {
    match count {
        1 => format!("1 {one}"),
        count => format!("{count} {many}"),
    }
}

fn pruned_text(pruned: &Pruned, mode: Mode) -> String {
    let done = match mode {
        Mode::Remove => "removed",
        Mode::Count => "would remove",
    };
    let text = format!(
        "{done} {}, {}, {} that no other study has, {}\n",
        counted(pruned.studies as u64, "study", "studies"),
        counted(pruned.sweeps as u64, "sweep", "sweeps"),
        counted(pruned.points, "point", "points"),
        counted(pruned.trades, "measured trade", "measured trades"),
    );
    let more = match mode {
        Mode::Remove if *pruned != Pruned::default() => {
            "new studies use the space; strainsite db vacuum gives it back to the disk\n"
        }
        _ => "",
    };
    text + more
}

/// Looks now and then how far something is.
async fn watched<T>(work: impl Future<Output = T>, look: impl Fn()) -> T {
    let mut ticks = tokio::time::interval(TICK);
    let mut work = pin!(work);
    loop {
        tokio::select! {
            done = &mut work => return done,
            _ = ticks.tick() => look(),
        }
    }
}

fn size(path: &Path) -> Result<u64, Failure> {
    let metadata = std::fs::metadata(path);
    metadata.map(|metadata| metadata.len()).map_err(|error| {
        Failure::Other(format!(
            "the database {} can't be opened: {error}",
            path.display()
        ))
    })
}

fn report(path: &Path, found: &Inspection) -> String {
    let mut text = format!("{}: read", path.display());
    for (index, (table, rows)) in found.rows.iter().enumerate() {
        let comma = if index == 0 { "" } else { "," };
        text.push_str(&format!("{comma} {rows} {}", table.replace('_', " ")));
    }
    text.push('\n');
    for fault in &found.faults {
        text.push_str(&format!("- {}\n", painted(BAD, fault)));
    }
    if found.faults.is_empty() {
        let whole = "every row matches its hash, every reference leads somewhere, every study has its points";
        text.push_str(&(painted(GOOD, whole) + "\n"));
    }
    text
}
