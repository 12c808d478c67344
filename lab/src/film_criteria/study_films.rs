//! Kinds of film of a study, and what they read on the mesh of its layouts.

use std::collections::HashMap;
use std::error::Error;
use std::sync::Mutex;
use std::sync::atomic::AtomicBool;

use documents::layouts::layout_settings::farthest_section_deg;
use documents::study::plan::PlannedStudy;
use fem_client::solver::{Cost, StartState};
use layouts::field::film_field::DepthFields;
use placement::ladder::climb::answer;
use placement::layout::by_hand::scored_by_hand::StoredStudy;
use placement::layout::by_hand::stored_solves::StoredSolves;
use placement::points::archive::{Archive, ArchiveError, Outcome, PointRecord};
use placement::points::memory::MemoryArchive;
use results::CandidateFilm;
use tire::embedded::EmbeddedSolver;

use crate::study_runs::undisturbed;

/// Kinds of film as a study's result compares them, and what they read.
pub struct StudyFilms {
    /// Each kind with what one film of it knows.
    pub films: Vec<CandidateFilm>,
    /// Fields of the films, in their order.
    pub fields: DepthFields,
    /// Depths of the loads that layouts are scored at, mm.
    pub depths_mm: Vec<f64>,
}

/// Runs a study with layouts, without its signals and its rig.
///
/// # Errors
/// Why its films aren't known.
pub fn study_films(mut planned: PlannedStudy) -> Result<StudyFilms, Box<dyn Error>> {
    planned.study.signals = None;
    planned.study.rig = None;
    let (solver, archive) = (EmbeddedSolver::default(), SceneArchive::default());
    let result = answer(
        &planned.study,
        &planned.plan,
        undisturbed(&solver, &archive),
    )?;
    let settings = planned.study.layouts.clone();
    let farthest_deg = farthest_section_deg(&planned.study.scene.geometry);
    let findings = result.layout_findings.clone();
    let solved = archive.by_scene.into_inner()?;
    let stored = |coarser| StoredSolves::new(solved, coarser);
    let study = StoredStudy::of(planned, result.layout_findings, &solver)?;
    let read = study.read(stored, &AtomicBool::new(false))?;
    let (kinds, mesh) = read.on_own_mesh();
    let compared = kinds
        .clone()
        .candidates(farthest_deg, &settings.candidate_sizes_mm);
    Ok(StudyFilms {
        films: findings.map_or_else(Vec::new, |findings| findings.candidates),
        fields: mesh.fields.of_kinds(&compared),
        depths_mm: mesh.loads.iter().flatten().copied().collect(),
    })
}

/// An archive in memory that knows what was found of each scene, too. Of two outcomes of one scene the one with strains around the wheel counts: the study's own points have none.
#[derive(Default)]
struct SceneArchive {
    by_key: MemoryArchive,
    by_scene: Mutex<HashMap<String, Outcome>>,
}

impl Archive for SceneArchive {
    fn load(
        &self,
        keys: &[String],
        first: usize,
    ) -> Result<Vec<Option<(Outcome, Cost)>>, ArchiveError> {
        self.by_key.load(keys, first)
    }

    fn save(&self, point: &PointRecord<'_>) -> Result<(), ArchiveError> {
        let mut by_scene = self.by_scene.lock().expect("nobody panics with it");
        let is_whole =
            |known: &Outcome| matches!(known, Ok(response) if !response.rings.is_empty());
        if !by_scene.get(point.scene).is_some_and(is_whole) {
            by_scene.insert(point.scene.to_owned(), point.outcome.clone());
        }
        self.by_key.save(point)
    }

    fn load_start(&self, key: &str) -> Result<Option<StartState>, ArchiveError> {
        self.by_key.load_start(key)
    }
}
