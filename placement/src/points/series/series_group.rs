//! Series of points that are solved at once, on the same threads.
//!
//! A series begins with one solve that others start from, and with a tangent that they share: a core alone has work then, and another series has some for
//! the next. What is solved of a series doesn't depend on that.

use std::sync::atomic::Ordering;

use fem_client::scene::Scene;
use fem_client::solver::Readout;
use rayon::iter::{IndexedParallelIterator, IntoParallelIterator, ParallelIterator};

use super::planned_points::{Answers, Place, Points, Shared};
use super::point_keys::keys;
use super::starts::Starts;
use crate::points::run_context::RunContext;
use crate::points::run_error::RunError;
use crate::points::run_event::Event;
use crate::points::worker_threads::on_threads;

/// Scenes of which the first starts from nothing, each other one from a point before it.
#[derive(Clone)]
pub(crate) struct PointSeries<'s> {
    /// The scene of each point.
    pub scenes: &'s [Scene],
    /// Point that each starts from.
    pub starts: Starts,
    /// Input values of each.
    pub values: &'s [Vec<f64>],
    /// Places at which strains are read of each.
    pub readout: &'s Readout,
}

/// Scenes of a series, for those who only count them or ask for their keys.
pub(crate) struct SceneSeries {
    /// The scene of each point.
    pub scenes: Vec<Scene>,
    /// Point that each starts from.
    pub starts: Starts,
    /// Places at which strains are read of each.
    pub readout: Readout,
}

impl SceneSeries {
    /// Scenes that start from the first one.
    pub(crate) fn from_first(scenes: Vec<Scene>, readout: Readout) -> Self {
        Self {
            starts: Starts::from_first(scenes.len()),
            scenes,
            readout,
        }
    }
}

/// Loads or solves all points of some series, whose ordinals follow each other. The first series decides: where it has no answers, the others begin no point more, and
/// its error alone is given.
///
/// # Errors
/// Of the archive, and a stop, before anything is solved; each series has an error of its own.
pub(crate) fn answers_of_all(
    series: &[PointSeries<'_>],
    place: Place,
    context: RunContext<'_>,
) -> Result<Vec<Result<Answers, RunError>>, RunError> {
    let shared = Shared::default();
    let (mut all, mut first) = (Vec::new(), place.first);
    for one in series {
        let points = points(one, Place { first, ..place }, context, &shared)?;
        let found = points.loaded()?;
        first += one.scenes.len();
        all.push((points, found));
    }
    let found = all.iter().flat_map(|(_, found)| found.iter().flatten());
    let reused = found.count();
    (context.observer)(Event::Started {
        points: place.of,
        reused: place.first + reused,
    });
    *shared.done() = place.first + reused;
    let lacking = first - place.first - reused;
    let answers = |(k, (points, found)): (usize, (Points<'_>, Vec<_>))| {
        if shared.has_ended() {
            return Err(RunError::Stopped);
        }
        let answers = points.answers(found);
        if k == 0 && answers.is_err() {
            shared.end();
        }
        answers
    };
    let mut found: Vec<_> = on_threads(context.threads.min(lacking), || {
        all.into_par_iter().enumerate().map(answers).collect()
    });
    if shared.has_ended() {
        found.truncate(1);
    }
    Ok(found)
}

/// A series with the keys of its points.
fn points<'r>(
    series: &PointSeries<'r>,
    place: Place,
    context: RunContext<'r>,
    shared: &'r Shared,
) -> Result<Points<'r>, RunError> {
    let PointSeries {
        scenes,
        values,
        readout,
        ..
    } = *series;
    let unless_stopped = |key| match context.stop.load(Ordering::Relaxed) {
        true => Err(RunError::Stopped),
        false => Ok(key),
    };
    let keys = keys(scenes, &series.starts, context.solver, readout).map(unless_stopped);
    Ok(Points {
        scenes,
        starts: series.starts.clone(),
        values,
        readout,
        solver: context.solver,
        archive: context.archive,
        stop: context.stop,
        pause: context.pause,
        observer: context.observer,
        keys: keys.collect::<Result<_, _>>()?,
        place,
        shared,
    })
}
