//! Scores of layouts that somebody moves by hand, from the stored solves of a study's own.

use std::collections::HashSet;
use std::sync::atomic::{AtomicBool, Ordering};

use fem_client::scene::Level;
use fem_client::solver::{Coarser, Solver};

use crate::layout::by_hand::film_fields::{FieldLoad, FilmFields, FilmKindPlace, FilmNoise};
use crate::layout::by_hand::stored_solves::StoredSolves;
use crate::layout::solving::judged_layouts::{noise, samples};
use crate::layout::solving::layout_fields::MeshFields;
use crate::layout::solving::layout_scenes::LayoutScenes;
use crate::layout::solving::layout_workload::LayoutWorkload;
use crate::layout::solving::measuring_layouts::both_meshes;
use crate::layout::solving::study_layouts::Asked;
use crate::points::RunContext;
use crate::points::RunError;
use crate::points::memory::MemoryArchive;
use documents::layouts::layout_settings::{FreeLayout, Layouts};
use documents::study::Study;
use documents::study::plan::PlannedStudy;
use layouts::arrangement::Arrangement;
use layouts::field::film_field::{DepthFields, LoadField, Noise};
use layouts::ranking::asked_layouts::{AskedLayout, Kinds, free};
use layouts::ranking::layout_order::with_scores;
use layouts::ranking::layout_scores::{Scorer, bounds_alone};
use layouts::simulate::draws::Draws;
use results::{LayoutFindings, LayoutLoad, LayoutScore, RankedLayout};

/// Most films of a layout that is moved by hand.
pub const MOST_FILMS: usize = 96;

/// Reason why layouts of a study can't be scored from what is stored.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum HandError {
    /// Study without layouts.
    #[error(
        "the study asked for no layouts, so that nothing around the wheel is stored: add \"layouts\" to its document and run it again"
    )]
    NoLayouts,
    /// Study whose layouts have no scores either.
    #[error("the study's layouts have no scores: {0}")]
    NoScores(String),
    /// Points were removed, or none were kept.
    #[error(
        "solves of the study's layouts are no longer stored, or this version would solve others: run it again"
    )]
    NotStored,
    /// The caller asked to stop.
    #[error("stopped on request")]
    Stopped,
}

/// Request for layouts that are moved by hand.
#[derive(Debug, Clone, PartialEq)]
pub struct HandAsked {
    /// The layouts.
    pub layouts: Vec<FreeLayout>,
    /// Whether errors are simulated beside their bounds.
    pub simulated: bool,
}

/// The solves of a study's layouts as fields of its films.
pub struct HandLayouts {
    settings: Layouts,
    kinds: Kinds,
    level: Level,
    loads: Vec<LayoutLoad>,
    fine: MeshFields,
    coarse: Option<(MeshFields, Coarser)>,
    seed: u64,
}

/// A study on the mesh of its layouts, as its result names it.
pub struct StoredStudy {
    planned: PlannedStudy,
    coarser: Option<Coarser>,
    loads: Vec<LayoutLoad>,
}

impl StoredStudy {
    /// A study with what its result says of layouts; `solver` says what the coarser mesh shows of the finer one's error.
    ///
    /// # Errors
    /// [`HandError::NoLayouts`] and [`HandError::NoScores`].
    pub fn of(
        mut planned: PlannedStudy,
        findings: Option<LayoutFindings>,
        solver: &dyn Solver,
    ) -> Result<Self, HandError> {
        let findings = findings.filter(|_| planned.study.layouts.is_asked());
        let findings = findings.ok_or(HandError::NoLayouts)?;
        let level = Level::named(&findings.level);
        let Some(level) = level.filter(|_| !findings.rings.is_empty()) else {
            return Err(HandError::NoScores(findings.reasons.join(" ")));
        };
        planned.study.layouts.level = Some(level);
        let mut scene = planned.study.scene.clone();
        scene.model.level = level;
        let coarser = solver.coarser(&scene);
        let is_kept =
            |coarser: &Coarser| Some(coarser.level.as_str()) == findings.coarser_level.as_deref();
        Ok(Self {
            planned,
            coarser: coarser.filter(is_kept),
            loads: findings.loads,
        })
    }

    /// Canonical scenes of all that was solved for its layouts.
    pub fn scenes(&self) -> HashSet<String> {
        let PlannedStudy { study, plan } = &self.planned;
        let stored = StoredSolves::new(Default::default(), self.coarser);
        let series = LayoutWorkload::of(study, plan).series(&stored).into_iter();
        series
            .flat_map(|series| series.scenes)
            .map(|scene| scene.canonical_json())
            .collect()
    }

    /// The fields of its films from these stored solves.
    ///
    /// # Errors
    /// See [`HandError`].
    pub fn read(
        self,
        stored: impl FnOnce(Option<Coarser>) -> StoredSolves,
        stop: &AtomicBool,
    ) -> Result<HandLayouts, HandError> {
        let stored = stored(self.coarser);
        let PlannedStudy { study, plan } = &self.planned;
        let asked = Asked::of(study);
        let scenes =
            LayoutScenes::of(&study.layouts, &plan.points[0]).map_err(HandError::NoScores)?;
        let context = RunContext {
            solver: &stored,
            archive: &MemoryArchive::default(),
            threads: 1,
            stop,
            pause: None,
            observer: &|_| {},
        };
        let (answer, _) =
            both_meshes(0, study, plan, &asked, &scenes, context).map_err(|error| match error {
                RunError::Stopped if !stored.is_incomplete() => HandError::Stopped,
                _ => HandError::NotStored,
            })?;
        let answer = answer.map_err(HandError::NoScores)?;
        Ok(HandLayouts {
            settings: study.layouts.clone(),
            kinds: asked.kinds,
            level: answer.level,
            loads: self.loads,
            fine: answer.fine,
            coarse: answer.coarse,
            seed: study.method.seed,
        })
    }
}

/// Scorer of layouts on one mesh.
enum OnMesh<'f> {
    Bounds(&'f DepthFields, Noise, Vec<f64>),
    Simulated(Box<Scorer>),
}

impl OnMesh<'_> {
    fn scores(&self, arrangement: &Arrangement) -> Vec<LayoutScore> {
        match self {
            Self::Bounds(fields, noise, depths) => bounds_alone(fields, noise, depths, arrangement),
            Self::Simulated(scorer) => scorer.scores(arrangement),
        }
    }

    /// Returns the scores of which errors are told.
    fn figures(&self, arrangement: &Arrangement) -> Vec<LayoutScore> {
        match self {
            Self::Bounds(..) => self.scores(arrangement),
            Self::Simulated(scorer) => scorer.figures(arrangement),
        }
    }
}

/// Kinds of film that a study's layouts may be moved to: those that were read on its meshes, of its films' size.
pub fn kinds_of(study: &Study) -> Vec<FilmKindPlace> {
    let kinds = Asked::of(study).kinds;
    offered(&kinds).map(|kind| place(&kinds, kind)).collect()
}

fn offered(kinds: &Kinds) -> impl Iterator<Item = usize> + '_ {
    (0..kinds.all().len()).filter(|kind| kinds.is_laid(*kind))
}

fn place(kinds: &Kinds, kind: usize) -> FilmKindPlace {
    let kind = kinds.all()[kind];
    FilmKindPlace {
        phi_deg: kind.phi_deg,
        angle_deg: kind.angle_deg,
    }
}

impl HandLayouts {
    /// Scores of layouts of the study's kinds of film at every load, each with the error that the coarser mesh shows. `None` when it is to stop.
    pub fn scores(&self, wanted: &HandAsked, stop: &AtomicBool) -> Option<Vec<RankedLayout>> {
        let mut kinds = self.kinds.clone();
        let asked = wanted.layouts.iter().map(|layout| free(layout, &mut kinds));
        let asked: Vec<AskedLayout> = asked.collect();
        let fine = self.on_mesh(&self.fine, &asked, wanted.simulated);
        let coarse = self.coarse.as_ref().map(|(fields, coarser)| {
            let mesh = self.on_mesh(fields, &asked, wanted.simulated);
            (mesh, *coarser)
        });
        let scored = asked.into_iter().enumerate().map(|(k, asked)| {
            if stop.load(Ordering::Relaxed) {
                return None;
            }
            let AskedLayout {
                arrangement, label, ..
            } = asked;
            let coarse = coarse
                .as_ref()
                .map(|(mesh, coarser)| (mesh.figures(&arrangement), *coarser));
            let label = RankedLayout {
                rank: k + 1,
                ..label
            };
            let fine = fine.scores(&arrangement);
            Some(with_scores(label, &self.loads, fine, coarse.as_ref()))
        });
        scored.collect()
    }

    fn on_mesh<'f>(
        &self,
        fields: &'f MeshFields,
        asked: &[AskedLayout],
        simulated: bool,
    ) -> OnMesh<'f> {
        let (noise, depths) = (noise(&self.settings, fields), self.fine.depths());
        if !simulated {
            return OnMesh::Bounds(&fields.fields, noise, depths);
        }
        let layouts = asked.iter().map(|layout| &layout.arrangement);
        // Whatever else is asked at once, a layout's noise is the same.
        let draws = Draws::new(self.seed, samples(self.level), MOST_FILMS);
        let scorer = Scorer::new(&fields.fields, noise, depths, layouts, draws, false);
        OnMesh::Simulated(Box::new(scorer))
    }

    /// All kinds of film, and what they read on the mesh of the study's layouts.
    pub fn on_own_mesh(&self) -> (&Kinds, &MeshFields) {
        (&self.kinds, &self.fine)
    }

    /// Returns what every kind of film reads at every load, as the bounds of layouts follow from it.
    pub fn fields(&self) -> FilmFields {
        let kinds: Vec<usize> = offered(&self.kinds).collect();
        let fields = self.fine.fields.of_kinds(&kinds);
        let reached = self.loads.iter().filter(|load| load.reason.is_none());
        let loads = reached.zip(self.fine.depths()).map(|(load, depth_mm)| {
            let LoadField {
                force_slope, kinds, ..
            } = fields.at(depth_mm);
            let signals = kinds.iter().map(|kind| kind.signal.samples().to_vec());
            let slopes = kinds.iter().map(|kind| kind.slopes[0].samples().to_vec());
            let variances = kinds.iter().filter_map(|kind| {
                let spread = kind.spread.as_ref()?;
                Some(spread.samples().to_vec())
            });
            FieldLoad {
                variances: variances.collect(),
                depth_mm,
                load_n: load.load_n,
                force_slope_n_per_mm: force_slope,
                signals: signals.collect(),
                slopes_per_mm: slopes.collect(),
            }
        });
        let Noise {
            floor,
            gain_std,
            place_std_deg,
            ..
        } = noise(&self.settings, &self.fine);
        FilmFields {
            unit: self.settings.unit().to_owned(),
            size_mm: self.settings.size_mm,
            noise: FilmNoise {
                floor,
                gain_std,
                place_std_deg,
            },
            kinds: kinds.iter().map(|kind| place(&self.kinds, *kind)).collect(),
            loads: loads.collect(),
        }
    }
}
