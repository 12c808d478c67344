//! Forecast of a study's cost on this machine, with what this database knows.

mod known_solves;
pub mod many_designs;

use std::collections::HashSet;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

use documents::study::Study;
use documents::study::plan::{Estimable, PlanError, PlannedStudy};
use documents::sweep::Sweep;
use fem_client::scene::Level;
use fem_client::solver::Solver;
use placement::estimate::{Machine, NextLevel, Pace, Workload, estimate};
use placement::points::worker_threads::in_parallel;
use results::{Estimate, Surer};

use self::known_solves::{known, measured, solves_at_once};
use self::many_designs::{ManyDesigns, TOGETHER};
use crate::wire::sweep_wire::{DesignEstimate, SweepEstimate};
use store::queue::study_rows;
use store::{Store, StoreError};

/// Reason why there is no estimate.
#[derive(Debug, thiserror::Error)]
pub enum ForecastError {
    /// The study can't be planned.
    #[error(transparent)]
    Plan(#[from] PlanError),
    /// The database failed.
    #[error(transparent)]
    Store(#[from] StoreError),
    /// A study that would take more memory than there is.
    #[error("the study would take about {} of memory, and {} are there; a coarser level, fewer points, a smaller candidates.grid or fewer threads take less", gigabytes(*.needed_bytes), gigabytes(*.there_bytes))]
    Memory {
        /// Memory that it would take, bytes.
        needed_bytes: u64,
        /// Memory that it may take, bytes.
        there_bytes: u64,
    },
    /// Planning panicked.
    #[error("the study could not be planned; the log says why")]
    Broken,
}

pub(crate) fn gigabytes(bytes: u64) -> String {
    format!("{:.2} GB", bytes as f64 / 1e9)
}

/// Estimates what a study would cost. Times are corrected by the newest solves of the database; what it holds already costs nothing.
///
/// # Errors
/// See [`ForecastError`].
pub async fn forecast(
    store: Option<&Store>,
    solver: &Arc<dyn Solver>,
    threads: usize,
    planned: &Arc<PlannedStudy>,
) -> Result<Estimate, ForecastError> {
    let pace = pace(store, solver, threads, planned).await?;
    Ok(pace.estimate().clone())
}

/// Estimates as [`forecast`] does, to be corrected while the study runs.
///
/// # Errors
/// See [`ForecastError`].
pub async fn pace(
    store: Option<&Store>,
    solver: &Arc<dyn Solver>,
    threads: usize,
    planned: &Arc<PlannedStudy>,
) -> Result<Pace, ForecastError> {
    let work = workload(solver, planned, Workload::of).await?;
    let known = known(store, std::iter::once(&work)).await?;
    let machine = measured(store, solver.as_ref(), threads).await?;
    Ok(Pace::new(work, known, machine))
}

/// Estimates what a study would cost that need not be planned for that.
///
/// # Errors
/// See [`ForecastError`].
pub async fn forecast_of(
    store: &Store,
    solver: &Arc<dyn Solver>,
    threads: usize,
    study: Estimable,
) -> Result<Estimate, ForecastError> {
    let study = match study {
        Estimable::Planned(planned) => {
            return forecast(Some(store), solver, threads, &Arc::new(planned)).await;
        }
        Estimable::Counted(study) => study,
    };
    let work = Workload::counted(&study, solver.as_ref())?;
    let mut connection = store.read().await?;
    let solved = study_rows::points_of_twins(&mut connection, &study.spec_sha256()).await?;
    let known: HashSet<&str> = work.keys().take(solved).collect();
    drop(connection);
    let machine = measured(Some(store), solver.as_ref(), threads).await?;
    Ok(estimate(&work, &|key| known.contains(key), &machine))
}

/// Estimates what a surer answer costs than that of a study on a level: the next one. `None` at the top of the ladder.
///
/// # Errors
/// See [`ForecastError`].
pub(crate) async fn forecast_next(
    store: &Store,
    solver: &Arc<dyn Solver>,
    threads: usize,
    study: &Study,
    level: &str,
) -> Result<Option<Surer>, ForecastError> {
    let Some(answered) = Level::named(level) else {
        return Ok(None);
    };
    let (own, asked) = (study.clone(), solver.clone());
    let next = tokio::task::spawn_blocking(move || NextLevel::of(&own, answered, asked.as_ref()));
    let Some(next) = next.await.map_err(|_| ForecastError::Broken)?? else {
        return Ok(None);
    };
    let asked = match Estimable::is_counted(&next.study) {
        true => Estimable::Counted(next.study.clone()),
        false => Estimable::Planned(PlannedStudy::new(next.study.clone())?),
    };
    let estimate = forecast_of(store, solver, threads, asked).await?;
    Ok(Some(
        next.surer(estimate.wall_s.map(|wall_s| wall_s.expected)),
    ))
}

/// Plans a study. A large design takes a second, which the runtime's threads haven't.
///
/// # Errors
/// [`ForecastError::Plan`]; when planning panics.
pub async fn plan_study(study: &Study) -> Result<Arc<PlannedStudy>, ForecastError> {
    let study = study.clone();
    let planned = tokio::task::spawn_blocking(move || PlannedStudy::new(study));
    Ok(Arc::new(planned.await.map_err(|_| ForecastError::Broken)??))
}

/// Lists what a planned study asks of a solver, which takes as long again.
async fn workload(
    solver: &Arc<dyn Solver>,
    planned: &Arc<PlannedStudy>,
    of: fn(&PlannedStudy, &dyn Solver) -> Workload,
) -> Result<Workload, ForecastError> {
    let (solver, planned) = (solver.clone(), planned.clone());
    let work = tokio::task::spawn_blocking(move || of(&planned, solver.as_ref()));
    work.await.map_err(|_| ForecastError::Broken)
}

/// Lists what a design asks of a solver; a large one is counted, and shares points with those alone that have its cut point.
fn design_workload(solver: &dyn Solver, study: &Study) -> Result<Workload, PlanError> {
    match Estimable::is_counted(study) {
        true => Workload::counted(study, solver),
        false => Ok(Workload::of(&PlannedStudy::new(study.clone())?, solver)),
    }
}

/// Estimates what the designs of a sweep would cost, one after the other: what one of them solves is known to those after it.
///
/// # Errors
/// See [`ForecastError`].
pub async fn forecast_sweep(
    store: Option<&Store>,
    solver: &Arc<dyn Solver>,
    threads: usize,
    sweep: &Sweep,
) -> Result<SweepEstimate, ForecastError> {
    let mut many = ManyDesigns::begin(store, solver.as_ref(), threads).await?;
    let mut designs = Vec::new();
    for some in sweep.designs.chunks(TOGETHER) {
        let studies: Vec<Study> = some.iter().map(|design| design.study.clone()).collect();
        let solver = solver.clone();
        let planned = move || {
            let of = |i: usize| design_workload(solver.as_ref(), &studies[i]);
            let never = AtomicBool::new(false);
            let all = in_parallel(studies.len(), threads, &never, of).unwrap_or_default();
            all.into_iter()
                .map(|work| work.map(Some))
                .collect::<Result<Vec<_>, _>>()
        };
        let works = tokio::task::spawn_blocking(planned).await;
        let works = works.map_err(|_| ForecastError::Broken)??;
        let foreseen = many.next(&works).await?.into_iter().flatten();
        designs.extend(
            some.iter()
                .zip(foreseen)
                .map(|(design, foreseen)| DesignEstimate {
                    name: design.name.clone(),
                    estimate: foreseen.estimate,
                }),
        );
    }
    Ok(SweepEstimate::of(designs))
}

/// Returns what a study takes of memory with so many solves at once, bytes.
pub fn memory_bytes(work: &Workload, threads: usize) -> u64 {
    let machine = Machine::new(solves_at_once(threads));
    estimate(work, &|_| false, &machine).peak_memory_bytes
}

/// Refuses a study that would take more memory than it may, before anything of it is allocated.
///
/// # Errors
/// [`ForecastError::Memory`]; when planning panics.
pub async fn admit(
    solver: &Arc<dyn Solver>,
    threads: usize,
    there_bytes: u64,
    planned: &Arc<PlannedStudy>,
) -> Result<(), ForecastError> {
    let work = workload(solver, planned, Workload::without_keys).await?;
    let needed_bytes = memory_bytes(&work, threads);
    if needed_bytes > there_bytes {
        return Err(ForecastError::Memory {
            needed_bytes,
            there_bytes,
        });
    }
    Ok(())
}
