//! Layouts moved by hand, from the points that a study has stored.

use std::collections::{HashMap, HashSet};
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

use document::Format;
use fem_client::scene::Scene;
use fem_client::solver::Solver;
use placement::layout::by_hand::scored_by_hand::{HandError, HandLayouts, StoredStudy};
use placement::layout::by_hand::stored_solves::StoredSolves;
use placement::points::archive::Outcome;
use results::LayoutFindings;
use serde::de::IgnoredAny;

use crate::study_document::stored_plan;
use crate::work::shutdown::Waiting;
use store::points::evaluations;
use store::queue::study_rows::StudyRow;
use store::{Store, StoreError};

/// Reason why there are no scores.
#[derive(Debug, thiserror::Error)]
pub enum HandLayoutsError {
    /// A study whose stored fields don't give them.
    #[error(transparent)]
    Lacking(#[from] HandError),
    /// A document that this version can't read.
    #[error("{cause}")]
    Unreadable {
        /// A sentence.
        cause: String,
    },
    /// A panic; the log has it.
    #[error("reading the study's layouts broke; the service's log says why")]
    Broken,
    /// The database failed.
    #[error(transparent)]
    Store(#[from] StoreError),
}

/// Computes `work` of the study's stored fields. It is told to stop when the caller goes away.
///
/// # Errors
/// See [`HandLayoutsError`].
pub async fn of<T: Send + 'static>(
    store: &Store,
    row: &StudyRow,
    findings: Option<LayoutFindings>,
    solver: Arc<dyn Solver>,
    work: impl FnOnce(&HandLayouts, &AtomicBool) -> Option<T> + Send + 'static,
) -> Result<T, HandLayoutsError> {
    let owned = row.clone();
    let planned = off_thread(move || {
        let planned =
            stored_plan(&owned).map_err(|cause| HandLayoutsError::Unreadable { cause })?;
        let study = StoredStudy::of(planned, findings, solver.as_ref())?;
        let scenes = study.scenes();
        Ok((study, scenes))
    });
    let (study, scenes) = planned.await?;
    let outcomes = outcomes(store, &row.id, &scenes).await?;
    let waiting = Waiting::default();
    let stop = waiting.flag();
    off_thread(move || {
        let fields = study.read(|coarser| StoredSolves::new(outcomes, coarser), &stop)?;
        let made = work(&fields, &stop).ok_or(HandError::Stopped)?;
        Ok(made)
    })
    .await
}

/// Works on a thread that may be busy for long.
async fn off_thread<T: Send + 'static>(
    work: impl FnOnce() -> Result<T, HandLayoutsError> + Send + 'static,
) -> Result<T, HandLayoutsError> {
    let made = tokio::task::spawn_blocking(work).await;
    made.map_err(|_| HandLayoutsError::Broken)?
}

/// The study's outcomes of these scenes. Of two of one scene the one with strains around the wheel counts: the study's own points have none.
async fn outcomes(
    store: &Store,
    study: &str,
    scenes: &HashSet<String>,
) -> Result<HashMap<String, Outcome>, StoreError> {
    let mut connection = store.read().await?;
    let parts = evaluations::parts_of::<IgnoredAny>(&mut connection, study).await?;
    let wanted = parts.into_iter().filter_map(|(_, key, evaluation)| {
        let scene = Scene::from_text(&evaluation.scene, Format::Json).ok()?;
        let scene = scene.canonical_json();
        scenes.contains(&scene).then_some((key, scene))
    });
    let (keys, scenes): (Vec<String>, Vec<String>) = wanted.unzip();
    let found = evaluations::find(&mut connection, &keys).await?;
    let mut outcomes = HashMap::new();
    for (scene, evaluation) in scenes.into_iter().zip(found) {
        let Some(evaluation) = evaluation else {
            continue;
        };
        let is_whole = |outcome: &Outcome| {
            outcome
                .as_ref()
                .is_ok_and(|response| !response.rings.is_empty())
        };
        if outcomes.get(&scene).is_none_or(|known| !is_whole(known)) {
            outcomes.insert(scene, evaluation.outcome);
        }
    }
    Ok(outcomes)
}
