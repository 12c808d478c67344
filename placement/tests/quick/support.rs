//! Support for the tests of whole studies: an archive in memory, and solvers that misbehave at one point.

use std::collections::HashMap;
use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

use document::Format;
use documents::layouts::layout_settings::Layouts;
use documents::study::plan::Plan;
use documents::study::{Study, presets};
use fem_client::closed_form::ClosedFormSolver;
use fem_client::solver::{Cost, SolveError, SolveRequest, Solved, Solver, StartState};
use placement::ladder::climb::answer;
use placement::points::Event;
use placement::points::RunContext;
use placement::points::RunError;
use placement::points::archive::{Archive, ArchiveError, Outcome, PointRecord};
use results::{StudyCost, StudyResult};

/// Stores texts and bytes, as a database would, so that a test sees what storage does to numbers.
#[derive(Default)]
pub struct MemoryArchive {
    pub points: Mutex<HashMap<String, (String, Cost)>>,
    pub starts: Mutex<HashMap<String, Vec<u8>>>,
    /// Number of times that something was written under a key that was there already.
    pub rewritten: AtomicUsize,
}

impl Archive for MemoryArchive {
    fn load(
        &self,
        keys: &[String],
        _: usize,
    ) -> Result<Vec<Option<(Outcome, Cost)>>, ArchiveError> {
        let points = self.points.lock().unwrap();
        let read = |(text, cost): &(String, Cost)| (serde_json::from_str(text).unwrap(), *cost);
        Ok(keys.iter().map(|key| points.get(key).map(read)).collect())
    }

    fn save(&self, point: &PointRecord<'_>) -> Result<(), ArchiveError> {
        let text = serde_json::to_string(point.outcome).unwrap();
        let before = self
            .points
            .lock()
            .unwrap()
            .insert(point.key.to_owned(), (text, point.cost));
        self.rewritten
            .fetch_add(usize::from(before.is_some()), Ordering::Relaxed);
        if let Some(start) = point.start {
            self.starts
                .lock()
                .unwrap()
                .insert(point.key.to_owned(), start.to_bytes());
        }
        Ok(())
    }

    fn load_start(&self, key: &str) -> Result<Option<StartState>, ArchiveError> {
        let starts = self.starts.lock().unwrap();
        Ok(starts
            .get(key)
            .map(|bytes| StartState::from_bytes(bytes).unwrap()))
    }
}

/// The closed form, with a twist: `twist` may answer instead, and every solve is counted.
pub struct Twisted<F> {
    pub twist: F,
    pub solves: AtomicUsize,
}

impl<F> Twisted<F> {
    pub fn new(twist: F) -> Self {
        Self {
            twist,
            solves: AtomicUsize::new(0),
        }
    }
}

impl<F> Solver for Twisted<F>
where
    F: Fn(&SolveRequest<'_>) -> Option<SolveError> + Send + Sync,
{
    fn version(&self) -> String {
        ClosedFormSolver::new().version()
    }

    fn solve(&self, request: &SolveRequest<'_>) -> Result<Solved, SolveError> {
        self.solves.fetch_add(1, Ordering::Relaxed);
        match (self.twist)(request) {
            Some(error) => Err(error),
            None => ClosedFormSolver::new().solve(request),
        }
    }
}

/// A shipped study, by name, without its layouts: they have solves of their own.
pub fn shipped(name: &str) -> Study {
    let text = presets()
        .into_iter()
        .find(|(preset, _)| *preset == name)
        .unwrap()
        .1;
    Study {
        layouts: Layouts::none(),
        ..study(text)
    }
}

pub fn study(text: &str) -> Study {
    Study::from_document(text, Format::Toml, &|path| Err(format!("no file {path}"))).unwrap()
}

/// Runs without a stop, collecting the events.
pub fn observed(
    study: &Study,
    solver: &dyn Solver,
    archive: &dyn Archive,
    threads: usize,
) -> (Result<StudyResult, RunError>, Vec<Event>) {
    let events = Mutex::new(Vec::new());
    let stop = AtomicBool::new(false);
    let plan = Plan::new(study).unwrap();
    let observer = |event| events.lock().unwrap().push(event);
    let context = RunContext {
        solver,
        archive,
        threads,
        stop: &stop,
        pause: None,
        observer: &observer,
    };
    let result = answer(study, &plan, context);
    (result, events.into_inner().unwrap())
}

/// The result of the closed form.
pub fn answered(study: &Study) -> StudyResult {
    observed(
        study,
        &ClosedFormSolver::new(),
        &MemoryArchive::default(),
        2,
    )
    .0
    .unwrap()
}

/// The result as text, without what varies from run to run.
pub fn text(result: &StudyResult) -> String {
    let mut result = result.clone();
    result.cost = StudyCost::default();
    serde_json::to_string(&result).unwrap()
}
