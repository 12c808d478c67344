//! Forecast of a study's cost on this machine, with what this database knows.

use std::collections::HashSet;
use std::num::NonZeroUsize;
use std::sync::Arc;

use documents::study::Study;
use documents::study::plan::{Estimable, PlanError, PlannedStudy};
use documents::sweep::Sweep;
use fem_client::scene::Level;
use fem_client::solver::Solver;
use placement::estimate::{Machine, NextLevel, Pace, Workload, estimate};
use results::{Estimate, Surer};

use crate::wire::sweep_wire::{DesignEstimate, SweepEstimate};
use store::points::evaluations;
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
    let (mut known, mut samples) = (HashSet::new(), Vec::new());
    if let Some(store) = store {
        let keys: Vec<&str> = work.keys().collect();
        let mut connection = store.read().await?;
        known = evaluations::known(&mut connection, &keys).await?;
        samples = evaluations::samples(&mut connection).await?;
    }
    let machine = Machine::measured(solves_at_once(threads), &samples, solver.as_ref());
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
    let known = work.keys().take(solved).map(str::to_owned).collect();
    let samples = evaluations::samples(&mut connection).await?;
    let machine = Machine::measured(solves_at_once(threads), &samples, solver.as_ref());
    Ok(estimate(&work, &known, &machine))
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

fn solves_at_once(threads: usize) -> usize {
    let cores = std::thread::available_parallelism().map_or(1, NonZeroUsize::get);
    threads.min(cores)
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
async fn design_workload(
    solver: &Arc<dyn Solver>,
    study: &Study,
) -> Result<Workload, ForecastError> {
    if Estimable::is_counted(study) {
        return Ok(Workload::counted(study, solver.as_ref())?);
    }
    workload(solver, &plan_study(study).await?, Workload::of).await
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
    let (mut known, mut samples, mut designs) = (HashSet::new(), None, Vec::new());
    for design in &sweep.designs {
        let work = design_workload(solver, &design.study).await?;
        if let Some(store) = store {
            let keys: Vec<&str> = work.keys().collect();
            let mut connection = store.read().await?;
            known.extend(evaluations::known(&mut connection, &keys).await?);
            if samples.is_none() {
                samples = Some(evaluations::samples(&mut connection).await?);
            }
        }
        let samples = samples.as_deref().unwrap_or_default();
        let machine = Machine::measured(solves_at_once(threads), samples, solver.as_ref());
        designs.push(DesignEstimate {
            name: design.name.clone(),
            estimate: estimate(&work, &known, &machine),
        });
        known.extend(work.keys().map(str::to_owned));
    }
    Ok(SweepEstimate::of(designs))
}

/// Times that designs are expected to take, s, one after the other, and which of their points a database has. A time is none where a design has no plan, or nothing is known of the solver.
///
/// # Errors
/// When the database can't be read.
pub async fn forecast_designs(
    store: &Store,
    solver: &Arc<dyn Solver>,
    threads: usize,
    works: &[Option<Workload>],
) -> Result<(Vec<Option<f64>>, HashSet<String>), StoreError> {
    let mut connection = store.read().await?;
    let keys: Vec<&str> = works.iter().flatten().flat_map(Workload::keys).collect();
    let there = evaluations::known(&mut connection, &keys).await?;
    let samples = evaluations::samples(&mut connection).await?;
    let machine = Machine::measured(solves_at_once(threads), &samples, solver.as_ref());
    let mut known = there.clone();
    let expected = works.iter().map(|work| {
        let work = work.as_ref()?;
        let estimated = estimate(work, &known, &machine);
        known.extend(work.keys().map(str::to_owned));
        estimated.wall_s.map(|wall_s| wall_s.expected)
    });
    Ok((expected.collect(), there))
}

/// Returns what a study takes of memory with so many solves at once, bytes.
pub fn memory_bytes(work: &Workload, threads: usize) -> u64 {
    let machine = Machine::new(solves_at_once(threads));
    estimate(work, &HashSet::new(), &machine).peak_memory_bytes
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
