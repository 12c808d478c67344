//! `strainsite force fit`.

use std::path::PathBuf;
use std::sync::atomic::Ordering;

use clap::Args;
use estimation::recipe::Recipe;
use placement::points::machine_memory::machine_memory_bytes;
use service::forces::fit_forecast::fit_forecast;
use service::forces::fit_process::{ARGUMENT, FitOrder, Learnt, Unlearnt, learn};
use service::forces::fitting::FitFailure;
use service::forces::recorded_texts::NamedText;
use service::study_document::{format_of, read_file};
use service::wire::estimator_wire::FitProgress;
use service::work::own_process::{Wish, own_program};
use tokio::runtime::Runtime;

use crate::cli::commands::force::force_table::report_text;
use crate::cli::commands::force::recording_files::recordings;
use crate::cli::terminal::estimate_text::fit_estimate;
use crate::cli::terminal::exit::Failure;
use crate::cli::terminal::files::Files;
use crate::cli::terminal::output::{JsonTarget, tell};
use crate::cli::terminal::output_place::write;
use crate::cli::terminal::progress::{count, counting_bar};
use crate::cli::terminal::signals::stop_flag;

#[derive(Debug, Args)]
pub struct Fit {
    /// Recipe of what is to be done, TOML or JSON; an empty file has all defaults
    recipe: PathBuf,
    /// Recordings, CSV, one a run: a header, then seconds, signals, and forces where they were measured
    #[arg(required = true)]
    runs: Vec<PathBuf>,
    /// Write the model here
    #[arg(short, long)]
    output: Option<PathBuf>,
    /// Write the report as JSON, `-` for standard output
    #[arg(long)]
    pub json: Option<JsonTarget>,
    /// Threads; all cores where it is left out
    #[arg(long, value_parser = clap::value_parser!(u16).range(1..=1024))]
    threads: Option<u16>,
    /// Say what it would take, and learn nothing
    #[arg(long)]
    dry_run: bool,
}

impl Fit {
    /// Returns the files that it reads and writes.
    pub fn files(&self) -> Files {
        Files::default()
            .reading([&self.recipe])
            .reading(&self.runs)
            .writing(self.output.as_deref())
            .telling(self.json.as_ref())
    }

    /// Learns, writes model and report, prints what was found.
    pub fn execute(&self) -> Result<(), Failure> {
        let recipe = read_file(&self.recipe)
            .and_then(|text| Recipe::from_text(&text, format_of(&self.recipe)));
        let (files, unread) = recordings(&self.runs);
        let mut faults = recipe.as_ref().err().cloned().unwrap_or_default();
        faults.extend(unread);
        let recipe = match recipe {
            Ok(recipe) if faults.is_empty() => recipe,
            _ => return Err(Failure::Input(faults)),
        };
        if self.dry_run {
            return self.estimate(&recipe, &files);
        }
        let found = self.learnt(recipe, files)?;
        if let Some(path) = &self.output {
            write(path, found.model.as_bytes())?;
        }
        if let Some(target) = &self.json {
            target.write(&found.report)?;
        }
        tell(&report_text(&found.report), self.json.as_ref())
    }

    fn estimate(&self, recipe: &Recipe, files: &[NamedText]) -> Result<(), Failure> {
        let found = fit_forecast(recipe, files, self.threads()).map_err(Failure::Input)?;
        if let Some(target) = &self.json {
            target.write(&found)?;
        }
        tell(&fit_estimate(&found), self.json.as_ref())
    }

    fn threads(&self) -> usize {
        let cores = || std::thread::available_parallelism().map_or(1, usize::from);
        self.threads.map_or_else(cores, usize::from)
    }

    /// Learns in a process of its own, so that a signal ends it at once and a lack of memory ends it alone.
    fn learnt(&self, recipe: Recipe, files: Vec<NamedText>) -> Result<Learnt, Failure> {
        let runtime = Runtime::new().map_err(Failure::other)?;
        let stop = stop_flag(&runtime)?;
        let bar = counting_bar(0, "models judged");
        let order = FitOrder {
            recipe,
            files,
            threads: self.threads(),
            memory_bytes: machine_memory_bytes(),
        };
        let wish = || match stop.load(Ordering::Relaxed) {
            true => Wish::Stop,
            false => Wish::GoOn,
        };
        let told = |progress: FitProgress| count(&bar, progress.done, progress.of);
        let found = learn(own_program(ARGUMENT), &order, &wish, &told);
        bar.finish_and_clear();
        found.map_err(|failure| match failure {
            Unlearnt::Failed(FitFailure::Input(faults)) => Failure::Input(faults),
            Unlearnt::Failed(FitFailure::Other(detail)) => Failure::Other(detail),
            Unlearnt::Stopped => Failure::Other("stopped on request".to_owned()),
            Unlearnt::Crashed(detail) => {
                Failure::Other(format!("the fit's process crashed: {detail}"))
            }
        })
    }
}
