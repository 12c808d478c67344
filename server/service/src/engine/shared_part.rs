//! Solves a part of a study's points for somebody who analyses them elsewhere: points alone, the study stays as it is.

use std::sync::Arc;
use std::sync::atomic::AtomicBool;

use placement::points::{Event, RunContext};
use placement::sharing::Part;
use tokio::runtime::Handle;

use super::{End, Engine};
use crate::database_archive::StoreArchive;
use crate::solving::timekeeper::Timekeeper;
use crate::solving::traced::Traced;
use crate::study_document::stored_plan;
use store::queue::study_rows::StudyRow;

impl Engine {
    /// Solves a part of a study's points, or its cut points where no part is named; false when it was stopped. Blocks: call it on a plain thread.
    ///
    /// # Errors
    /// A sentence.
    pub fn solve_part(
        &self,
        row: &StudyRow,
        part: Option<Part>,
        runtime: &Handle,
        stop: &AtomicBool,
        progress: &(dyn Fn(&Event) + Sync),
    ) -> Result<bool, String> {
        let span = tracing::error_span!("study", study = row.id);
        let _entered = span.enter();
        let planned = stored_plan(row)?;
        let archive = StoreArchive::new(
            self.store.clone(),
            runtime.clone(),
            &row.id,
            self.metrics.clone(),
            Arc::new(Timekeeper::new(None)),
        );
        let observer = |event: Event| progress(&event);
        let solver = Traced::new(self.solver.clone(), span.clone());
        let context = RunContext {
            solver: &solver,
            archive: &archive,
            threads: self.threads,
            stop,
            pause: None,
            observer: &observer,
        };
        let solved = match part {
            Some(part) => part.solve(&planned, context),
            None => Part::solve_cut_points(&planned, context),
        };
        match solved.map_err(|error| End::of(&error, &archive)) {
            Ok(()) => Ok(true),
            Err(End::Failed { error, .. }) => Err(error),
            Err(End::Unstorable(error)) => Err(error.to_string()),
            Err(_) => Ok(false),
        }
    }
}
