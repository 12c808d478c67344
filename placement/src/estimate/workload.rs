//! Workload of a study, all that it will or may have solved: a pure function of its document and the solver's kind.

use std::cell::Cell;
use std::collections::HashSet;

use fem_client::scene::{Level, Scene};
use fem_client::solver::direction::Direction;
use fem_client::solver::{Readout, Solver};
use gsa::method::{Kind, Method};

use super::database_room::{point_bytes, result_bytes};
use super::solve_time::{How, Task};
use crate::assumptions::changed_scenes::{assumption_series, changed_scorings};
use crate::ladder::fidelity::Fidelity;
use crate::layout::solving::layout_workload::LayoutWorkload;
use crate::points::{SceneSeries, Starts, keys, mirror_class, tire};
use crate::response_table::study_table::StudyTable;
use crate::signals::measuring::signal_series;
use documents::layouts::contact_laws::Scatter;
use documents::study::plan::{Plan, PlanError, PlannedStudy};
use documents::study::{Accuracy, Study};

/// Times as many points as it starts with that the adaptive method is expected to ask for: it took 3.9 and 4.5 times as many in the
/// measured trades of `docs/use/trade.md`.
const OF_ADAPTING: usize = 4;

/// Nodes for each input of the lines that stand for a larger design: a mean point, and one on each side.
const LINE_NODES: usize = 3;

/// Workload of a study, all that it will or may have solved, in the order in which it goes.
#[derive(Debug, Clone, PartialEq)]
pub struct Workload {
    pub(crate) stages: Vec<Stage>,
    /// The study asks for this.
    pub(crate) accuracy: Accuracy,
    /// Whether the law of solves' times is the solver's.
    pub(crate) law_holds: bool,
    /// Numbers read off each point.
    pub(crate) readings: usize,
    /// Whether its points were counted, not planned.
    pub(crate) is_counted: bool,
    /// Room that its result takes in a database, bytes.
    pub(crate) result_bytes: f64,
    /// Unlikely values of the study.
    pub(crate) unlikely: Vec<String>,
}

/// Unlikely values as sentences.
fn unlikely(planned: &PlannedStudy) -> Vec<String> {
    let slips = planned.plan.slips(&planned.study).into_iter();
    slips.map(|slip| slip.to_string()).collect()
}

/// The study on one mesh with one method.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Stage {
    pub fidelity: Fidelity,
    pub own: Vec<Point>,
    /// Points solved once more, on the coarser mesh.
    pub coarser: Vec<Point>,
    /// Points that show the effects of what the model leaves out.
    pub effects: Vec<Point>,
    /// Points that show films' signals: each series starts from an equilibrium of its own.
    pub signals: Vec<Vec<Point>>,
    /// Points that show layouts' loads, a series for each mesh.
    pub layouts: Vec<Vec<Point>>,
    /// Points of a rig's tables.
    pub tables: Vec<Vec<Point>>,
    /// Number of times that a layout is scored at a load on a mesh, as assumed or with an assumption changed.
    pub scorings: usize,
    /// Scatter of contacts as scores take it, where they differ.
    pub scatter: Option<Scatter>,
    /// Layouts that a search looks at by each criterion, and its places.
    pub searched: (f64, usize),
    /// Layouts whose forces are learnt from a rig's runs.
    pub learnt: usize,
    /// Films of the largest layout.
    pub films: usize,
    /// Points that an adaptive method may ask for beyond its first.
    pub extra: Extra,
}

impl Stage {
    /// Points that start from one equilibrium each.
    pub fn series(&self) -> impl Iterator<Item = &Vec<Point>> {
        [&self.own, &self.coarser, &self.effects]
            .into_iter()
            .chain(&self.signals)
            .chain(&self.layouts)
            .chain(&self.tables)
    }

    /// Points on both meshes, those included that an adaptive method is expected to ask for.
    pub fn points(&self) -> usize {
        self.own.len() + self.coarser.len() + self.meshes() * self.extra.expected
    }

    /// Returns on how many meshes its points are solved.
    pub fn meshes(&self) -> usize {
        1 + usize::from(!self.coarser.is_empty() || self.extra.coarser)
    }
}

/// Number of further points that there may be.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct Extra {
    /// Whether each is solved on the coarser mesh too, and wasn't by an earlier stage.
    pub coarser: bool,
    pub expected: usize,
    pub most: usize,
}

/// A solve.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Point {
    pub key: String,
    pub task: Task,
    /// Room that it takes in a database, bytes.
    pub stored_bytes: f64,
}

impl Workload {
    /// Lists what a study asks of a solver.
    pub fn of(planned: &PlannedStudy, solver: &dyn Solver) -> Self {
        let keys = |scenes: &[Scene], starts: &Starts, readout: &Readout| {
            keys(scenes, starts, solver, readout).collect()
        };
        Self::with_keys(planned, solver, &keys, &|points| points)
    }

    /// Lists what a large design asks of a solver: as many points as it has, each as dear as one of the few on its lines. Its keys are none of the archive.
    ///
    /// # Errors
    /// When the points on the lines have no plan.
    pub fn counted(study: &Study, solver: &dyn Solver) -> Result<Self, PlanError> {
        let mut on_lines = study.clone();
        on_lines.method = Method {
            nodes: LINE_NODES,
            seed: study.method.seed,
            ..Method::of(Kind::Mdrm)
        };
        let planned = PlannedStudy {
            plan: Plan::new(&on_lines)?,
            study: study.clone(),
        };
        let count = study.method.first_points(study.inputs.len());
        let stretched = |sample: Vec<Point>| {
            let Some((cut, others)) = sample.split_first() else {
                return sample;
            };
            let rest = others.iter().cycle().take(count.saturating_sub(1));
            let all = std::iter::once(cut).chain(rest).enumerate();
            let numbered = |(ordinal, point): (usize, &Point)| Point {
                key: format!("{} {ordinal}", cut.key),
                ..point.clone()
            };
            all.map(numbered).collect()
        };
        Ok(Self {
            is_counted: true,
            ..Self::with_keys(&planned, solver, &numbers(), &stretched)
        })
    }

    /// Lists what a study asks of a solver, for an estimate of its memory: without looking which solves are alike, which takes half of the time.
    pub fn without_keys(planned: &PlannedStudy, solver: &dyn Solver) -> Self {
        Self::with_keys(planned, solver, &numbers(), &|points| points)
    }

    fn with_keys(
        planned: &PlannedStudy,
        solver: &dyn Solver,
        keys: Keys<'_>,
        of_own_method: &dyn Fn(Vec<Point>) -> Vec<Point>,
    ) -> Self {
        let study = &planned.study;
        let path = rungs(study);
        let (mut known, mut stages) = (HashSet::new(), Vec::new());
        let mut effects_due = true;
        let laid = LayoutWorkload::of(study, &planned.plan);
        for fidelity in path {
            let raised = fidelity.raise(study);
            // A climb that gets to a method that can't be planned ends there.
            let Ok(plan) = planned.plan.raised(study, &raised) else {
                break;
            };
            let is_own_method = raised.method == study.method;
            let readout = study.readout();
            let mut fresh_of = |scenes: &[Scene], starts: &Starts, readout: &Readout| {
                let mut points = points(scenes, starts, readout, solver, keys);
                points.retain(|point| known.insert(point.key.clone()));
                points
            };
            let mut fresh =
                |scenes: &[Scene]| fresh_of(scenes, &Starts::from_first(scenes.len()), &readout);
            let sized = |points| {
                if is_own_method {
                    of_own_method(points)
                } else {
                    points
                }
            };
            let own = sized(fresh(&plan.points));
            let coarser_level = solver.coarser(&raised.scene).map(|coarser| coarser.level);
            let coarser = coarser_level.map(|level| sized(fresh(&plan.on_level(level).points)));
            let mut effects = Vec::new();
            if effects_due && fidelity.level != Level::Draft {
                effects_due = false;
                effects = fresh(&effect_scenes(&plan, solver));
            }
            let is_first = stages.is_empty();
            let mut further = |all: &dyn Fn() -> Vec<SceneSeries>| -> Vec<Vec<Point>> {
                let all = if is_first { all() } else { Vec::new() };
                let fresh = all
                    .iter()
                    .map(|series| fresh_of(&series.scenes, &series.starts, &series.readout));
                fresh.collect()
            };
            let signals = further(&|| signal_series(study, &planned.plan, solver));
            let layouts = further(&|| {
                let mut all = laid.series(solver);
                all.extend(assumption_series(&laid));
                all
            });
            let tables = further(&|| StudyTable::series_of(study, &planned.plan));
            let solved_there =
                |stage: &Stage| Some(stage.fidelity.level) == coarser_level && stage.extra.most > 0;
            let extra = Extra {
                coarser: coarser_level.is_some() && !stages.iter().any(solved_there),
                ..extra(&raised, plan.points.len())
            };
            stages.push(Stage {
                fidelity,
                own,
                coarser: coarser.unwrap_or_default(),
                effects,
                signals,
                layouts,
                tables,
                scorings: if is_first {
                    laid.scorings(solver) + changed_scorings(&laid)
                } else {
                    0
                },
                scatter: (!study.layouts.contacts.laws.is_empty())
                    .then_some(study.layouts.contacts.scatter),
                searched: match is_first {
                    true => laid.searched(),
                    false => (0.0, 0),
                },
                learnt: match (&study.rig, is_first) {
                    (Some(_), true) => laid.asked.layouts.len(),
                    _ => 0,
                },
                films: laid.largest_layout(),
                extra,
            });
        }
        let told = match study.layouts.is_asked() {
            true => laid.told(),
            false => 0,
        };
        Self {
            stages,
            accuracy: study.accuracy,
            law_holds: solver.has_time_law(),
            readings: readings(study),
            result_bytes: result_bytes(study, told),
            is_counted: false,
            unlikely: unlikely(planned),
        }
    }

    /// The content keys of all its points.
    pub fn keys(&self) -> impl Iterator<Item = &str> {
        self.points().map(|point| point.key.as_str())
    }

    pub(crate) fn points(&self) -> impl Iterator<Item = &Point> {
        self.stages
            .iter()
            .flat_map(|stage| stage.series().flatten())
    }
}

/// Gives the content keys of scenes that are read so.
type Keys<'k> = &'k dyn Fn(&[Scene], &Starts, &Readout) -> Vec<String>;

/// Different keys for all points that they are asked for.
fn numbers() -> impl Fn(&[Scene], &Starts, &Readout) -> Vec<String> {
    let next = Cell::new(0_usize);
    move |scenes, _, _| {
        let first = next.get();
        next.set(first + scenes.len());
        (first..next.get()).map(|key| key.to_string()).collect()
    }
}

/// Rungs that a study is answered on, as far as is known before.
pub(crate) fn rungs(study: &Study) -> Vec<Fidelity> {
    match study.accuracy {
        Accuracy::Preset => vec![Fidelity::of(study)],
        Accuracy::Tolerance(_) | Accuracy::Budget(_) => path(Fidelity::of(study)),
    }
}

/// The rungs of a climb as they follow each other on the paper's study: the adaptive method on the first mesh with an error, then finer meshes.
fn path(first: Fidelity) -> Vec<Fidelity> {
    let mut path = vec![first];
    for level in Level::ALL.into_iter().filter(|level| *level >= first.level) {
        let own = Fidelity { level, ..first };
        if level != first.level && level == Level::Coarse {
            path.push(own);
        }
        let adaptive = Fidelity {
            kind: Kind::Auto,
            ..own
        };
        if level > Level::Draft && adaptive != first {
            path.push(adaptive);
        }
    }
    path.dedup();
    path
}

fn extra(study: &Study, planned: usize) -> Extra {
    if !study.method.kind.is_adaptive() {
        return Extra::default();
    }
    let most = study.method.most_runs.saturating_sub(planned);
    Extra {
        coarser: false,
        expected: ((OF_ADAPTING - 1) * planned).min(most),
        most,
    }
}

/// The plain scene and the richer ones, as `effects` solves them.
fn effect_scenes(plan: &Plan, solver: &dyn Solver) -> Vec<Scene> {
    let mut plain = plan.points[0].clone();
    plain.model.level = Level::Coarse;
    let richer = solver.omissions(&plain).into_iter();
    let richer: Vec<Scene> = richer.filter_map(|omission| omission.richer).collect();
    if richer.is_empty() {
        return Vec::new();
    }
    std::iter::once(plain).chain(richer).collect()
}

/// Points of a series; none of no scenes.
fn points(
    scenes: &[Scene],
    starts: &Starts,
    readout: &Readout,
    solver: &dyn Solver,
    keys: Keys<'_>,
) -> Vec<Point> {
    let Some(cut) = scenes.first() else {
        return Vec::new();
    };
    let keys = keys(scenes, starts, readout);
    let tire_of_cut = tire(cut);
    let symmetric = cut.ground.is_symmetric() && cut.ground.is_alike_across();
    let mut classes = HashSet::new();
    let how = |ordinal: usize, scene: &Scene, classes: &mut HashSet<Vec<u64>>| {
        if ordinal == 0 {
            How::Cut
        } else if tire(scene) != tire_of_cut {
            How::Afresh
        } else if symmetric && scene.contact == cut.contact && !classes.insert(mirror_class(scene))
        {
            How::Image
        } else {
            How::Near
        }
    };
    scenes
        .iter()
        .zip(keys)
        .enumerate()
        .map(|(ordinal, (scene, key))| Point {
            key,
            task: Task::read(scene, readout, solver, how(ordinal, scene, &mut classes)),
            stored_bytes: point_bytes((cut, scene), readout, solver, starts.is_left(ordinal)),
        })
        .collect()
}

/// Strains at P1, P2, ... and on the map, two each.
fn readings(study: &Study) -> usize {
    let readout = study.readout();
    let grid = readout
        .grid
        .map_or(0, |grid| grid.circumferential * grid.meridional);
    Direction::ALL.len() * (study.scene.ground.stations + grid)
}
