//! Recordings of a virtual rig on a layout of a finished study.

use std::sync::atomic::AtomicBool;

use documents::study::plan::PlannedStudy;
use placement::points::RunContext;
use placement::points::RunError;
use placement::response_table::study_table::StudyTable;
use results::StudyResult;
use rig::rig_run::RigRun;
use rig::run_csv::recipe_toml;
use std::sync::Arc;
use tokio::runtime::Handle;

use crate::database_archive::StoreArchive;
use crate::engine::Engine;
use crate::forces::recorded_texts::NamedText;
use crate::solving::timekeeper::Timekeeper;

/// Reason why there are no recordings.
#[derive(Debug, thiserror::Error)]
pub enum RecordFailure {
    /// The study has nothing to record.
    #[error("{0}")]
    Input(String),
    /// Stop on request.
    #[error("stopped on request")]
    Stopped,
    /// The database or the solver.
    #[error("{0}")]
    Other(String),
}

/// A finished study, and where its points are.
#[derive(Clone, Copy)]
pub struct Finished<'f> {
    /// The engine that ran it.
    pub engine: &'f Engine,
    /// Document and points of the study.
    pub planned: &'f PlannedStudy,
    /// Answer of the study.
    pub result: &'f StudyResult,
    /// Runs what waits for the database.
    pub runtime: &'f Handle,
    /// Ends it early.
    pub stop: &'f AtomicBool,
}

impl Finished<'_> {
    /// The rig's runs on the layout of a rank, a CSV file each, and the recipe that reads them.
    ///
    /// # Errors
    /// See [`RecordFailure`].
    pub fn recordings(self, rank: usize) -> Result<Vec<NamedText>, RecordFailure> {
        let PlannedStudy { study, plan } = self.planned;
        let rig = study.rig.as_ref().ok_or_else(|| {
            RecordFailure::Input(
                "the study has no rig: add a table [rig]; it may be empty".to_owned(),
            )
        })?;
        let table = StudyTable::of(study, rig, plan).map_err(RecordFailure::Input)?;
        let ranked = self
            .result
            .layouts
            .iter()
            .find(|layout| layout.rank == rank);
        let ranked = ranked.ok_or_else(|| {
            RecordFailure::Input(format!(
                "no layout has the rank {rank}; there are {}",
                self.result.layouts.len()
            ))
        })?;
        let layout = table.asked(ranked).ok_or_else(|| {
            RecordFailure::Input(format!(
                "the layout of rank {rank} was found by the search: name its films in layouts.free to record it"
            ))
        })?;
        let archive = StoreArchive::new(
            self.engine.store.clone(),
            self.runtime.clone(),
            &self.result.study.id,
            self.engine.metrics.clone(),
            Arc::new(Timekeeper::new(None)),
        );
        let context = RunContext {
            solver: &*self.engine.solver,
            archive: &archive,
            threads: self.engine.threads,
            stop: self.stop,
            pause: None,
            observer: &|_| {},
        };
        let tested = match table.solved(plan, context) {
            Ok(tested) => tested.map_err(RecordFailure::Other)?,
            Err(RunError::Stopped) => return Err(RecordFailure::Stopped),
            Err(error) => return Err(RecordFailure::Other(error.to_string())),
        };
        let films = table.laid(&tested, &layout.arrangement.films);
        let recipe = NamedText {
            name: RECIPE.to_owned(),
            text: recipe_toml(layout.arrangement.films.len(), rig.film_rate_hz),
        };
        let run = |run: usize| NamedText {
            name: run_name(run),
            text: RigRun::recorded(&films, rig, run as u64).csv(),
        };
        Ok((0..rig.runs).map(run).chain([recipe]).collect())
    }
}

/// The recipe's file.
pub const RECIPE: &str = "recipe.toml";

/// The file of a run, counted from 0.
pub fn run_name(run: usize) -> String {
    format!("run-{}.csv", run + 1)
}
