//! `strainsite trade`: what accuracy a second buys, measured on one study.

mod plot;
mod trade_table;

use std::path::PathBuf;
use std::sync::atomic::AtomicBool;

use clap::Args;
use clap::builder::PossibleValuesParser;
use documents::study::Study;
use fem_client::scene::Level;
use gsa::method::Kind;
use placement::ladder::fidelity::Fidelity;
use placement::ladder::trade::{Trade as Measured, answer, compare};
use placement::points::RunError;
use results::StudyResult;
use tokio::runtime::Runtime;

use crate::cli::solver_option::SolverOption;
use crate::cli::terminal::exit::Failure;
use crate::cli::terminal::files::Files;
use crate::cli::terminal::output::{JsonTarget, tell, warn};
use crate::cli::terminal::output_place::write;
use crate::cli::terminal::paint::{WARNING, painted};
use crate::cli::terminal::progress::{progress_bar, show};
use crate::cli::terminal::signals::stop_flag;
use crate::config::Config;
use service::study_document::{named_files, read_changed};
use store::answers::trades;
use store::{Store, StoreError};

/// Measure the trade of speed for accuracy: the study on a ladder of meshes and methods, against the best of them
#[derive(Debug, Args)]
pub struct Trade {
    /// Study file, TOML or JSON, or the name of a shipped study
    study: PathBuf,
    /// Set a field of the study or its scene otherwise; may be given more than once
    #[arg(long, value_name = "KEY=VALUE")]
    set: Vec<String>,
    #[command(flatten)]
    config: Config,
    #[command(flatten)]
    solver: SolverOption,
    /// Finest mesh level of the ladder
    #[arg(long, value_name = "LEVEL", default_value = "reference",
          value_parser = PossibleValuesParser::new(Level::ALL.map(Level::as_str)))]
    up_to: String,
    /// Mesh level of the reference
    #[arg(long, value_name = "LEVEL", default_value = "reference",
          value_parser = PossibleValuesParser::new(Level::ALL.map(Level::as_str)))]
    reference_level: String,
    /// Method of the reference, with 5 nodes for each input
    #[arg(long, value_name = "KIND", default_value = "bivariate",
          value_parser = PossibleValuesParser::new(Kind::ALL.map(Kind::as_str)))]
    reference_method: String,
    /// Write trade.csv and trade.svg into this folder
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// Write the trade as JSON to a file, or to standard output with -
    #[arg(long, value_name = "FILE|-")]
    pub json: Option<JsonTarget>,
}

/// The files of `--out`.
const TABLE: &str = "trade.csv";
const PLOT: &str = "trade.svg";

/// Nodes of the reference's rules.
const REFERENCE_NODES: usize = 5;

impl Trade {
    /// Returns the files that it reads and writes.
    pub fn files(&self) -> Files {
        Files::of_database(&self.config.db)
            .reading(named_files(&self.study))
            .telling(self.json.as_ref())
            .filling(self.out.as_deref(), &[TABLE, PLOT])
    }

    /// Runs the ladder and its reference, and prints what they took and how far off they are.
    pub fn execute(&self) -> Result<(), Failure> {
        let study = read_changed(&self.study, &self.set)
            .map_err(Failure::Input)?
            .study;
        let runtime = Runtime::new().map_err(Failure::other)?;
        let stop = stop_flag(&runtime)?;
        // Opened before the work, so that a database that is in use is said at once.
        let store = runtime
            .block_on(self.config.open())
            .map_err(Failure::other)?;
        let measured = self.measure(&study, &stop);
        let kept = measured.and_then(|trade| {
            runtime
                .block_on(keep(&store, &trade))
                .map_err(Failure::other)?;
            Ok(trade)
        });
        let closed = runtime.block_on(store.close());
        let trade = kept?;
        closed.map_err(Failure::other)?;
        if let Some(folder) = &self.out {
            std::fs::create_dir_all(folder).map_err(|error| {
                Failure::Other(format!("{} can't be made: {error}", folder.display()))
            })?;
            write(&folder.join(TABLE), trade_table::csv(&trade).as_ref())?;
            let drawn = plot::svg(&trade).map_err(Failure::Other)?;
            write(&folder.join(PLOT), drawn.as_ref())?;
        }
        if let Some(target) = &self.json {
            target.write(&trade)?;
        }
        tell(&trade_table::report(&trade), self.json.as_ref())
    }

    fn measure(&self, study: &Study, stop: &AtomicBool) -> Result<Measured, Failure> {
        let reference = self.reference();
        let mut rungs = Vec::new();
        let mut left_out = Vec::new();
        let finest = level(&self.up_to);
        for fidelity in Fidelity::ladder().filter(|rung| rung.level <= finest) {
            match self.answer(study, fidelity, stop)? {
                Ok(result) => rungs.push((fidelity, result)),
                Err(RunError::Stopped) => return Err(stopped()),
                Err(error) => left_out.push(format!("{}: {error}", fidelity.label())),
            }
        }
        for rung in left_out {
            warn(&format!("{}: {rung}\n", painted(WARNING, "left out")));
        }
        let truth = self.answer(study, reference, stop)?;
        let truth = truth.map_err(|error| match error {
            RunError::Stopped => stopped(),
            error => Failure::Other(format!("the reference has no answer: {error}")),
        })?;
        Ok(compare(study, (reference, &truth), &rungs))
    }

    fn reference(&self) -> Fidelity {
        let kind = Kind::ALL
            .iter()
            .find(|kind| kind.as_str() == self.reference_method);
        Fidelity {
            level: level(&self.reference_level),
            kind: kind.copied().unwrap_or(Kind::Bivariate),
            nodes: REFERENCE_NODES,
        }
    }

    /// Answers a study on one rung, with a solver that has seen nothing yet.
    fn answer(
        &self,
        study: &Study,
        fidelity: Fidelity,
        stop: &AtomicBool,
    ) -> Result<Result<StudyResult, RunError>, Failure> {
        let solver = self.solver.solver().map_err(Failure::other)?;
        let bar = progress_bar(&format!("{:24} ", fidelity.label()));
        let threads = self.config.threads();
        let result = answer(study, fidelity, solver.as_ref(), threads, stop, &|event| {
            show(&bar, &event)
        });
        bar.finish_and_clear();
        Ok(result)
    }
}

/// Stores a trade for the service to show.
async fn keep(store: &Store, trade: &Measured) -> Result<(), StoreError> {
    let mut transaction = store.begin().await?;
    trades::insert(&mut transaction, trade).await?;
    store.commit(transaction, 0).await
}

/// The level of this name, which the command line has checked.
fn level(name: &str) -> Level {
    Level::named(name).unwrap_or(Level::Reference)
}

fn stopped() -> Failure {
    Failure::Other("stopped on request".to_owned())
}
