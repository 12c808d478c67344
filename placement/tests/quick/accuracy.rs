//! Errors of the mesh, and the climb to a tolerance or within a budget, with a closed form that has the error of a mesh put on.

use std::time::{Duration, Instant};

use documents::study::{Accuracy, Study};
use fem_client::closed_form::ClosedFormSolver;
use fem_client::scene::{Level, Scene};
use fem_client::solver::direction::Direction;
use fem_client::solver::{Coarser, SolveError, SolveRequest, Solved, Solver};
use gsa::method::Kind;
use placement::points::RunError;
use results::location_scores::GSI;
use results::{Output, RankedLocation, StudyResult};
use tire::mesh_error;
use tire::model::mesh_plan;

use crate::support::{MemoryArchive, observed, shipped, text};

/// Strain at P3 that a mesh adds for each mm at P2 beyond 1 mm, over the square of its size.
const OF_MESH: f64 = 0.03;
/// Depth of the kink, off all nodes, mm.
const KINK_MM: f64 = 1.03;

/// The closed form on meshes that err with the square of their size, with a kink of this slope over the depth at P2.
struct Meshed {
    form: ClosedFormSolver,
    kink: f64,
}

impl Meshed {
    fn new() -> Self {
        Self::of(ClosedFormSolver::new())
    }

    fn of(form: ClosedFormSolver) -> Self {
        Self { form, kink: 0.0 }
    }
}

impl Solver for Meshed {
    fn version(&self) -> String {
        "meshed 1".to_owned()
    }

    fn coarser(&self, scene: &Scene) -> Option<Coarser> {
        mesh_error::coarser(scene)
    }

    fn solve(&self, request: &SolveRequest<'_>) -> Result<Solved, SolveError> {
        let mut solved = self.form.solve(request)?;
        let scene = request.scene;
        let cells = mesh_plan(scene, scene.model.level).cells() as f64;
        let slope = OF_MESH * cells.powf(-2.0 / 3.0);
        let depth = scene.ground.depths_mm[1];
        solved.response.locations[2].strain.x +=
            slope * (depth - 1.0) + self.kink * (depth - KINK_MM).abs();
        solved.response.model.elements = cells as usize;
        Ok(solved)
    }
}

fn at_level(level: Level) -> Study {
    let mut study = shipped("foot-tire");
    study.grid = None;
    study.level = level;
    study.scene.model.level = level;
    study
}

fn asking(accuracy: Accuracy, level: Level) -> Study {
    Study {
        accuracy,
        ..at_level(level)
    }
}

fn answer(study: &Study, solver: &dyn Solver) -> StudyResult {
    observed(study, solver, &MemoryArchive::default(), 2)
        .0
        .unwrap()
}

fn at_centre(result: &StudyResult) -> &Output {
    let found = result.outputs.iter();
    let mut found = found.filter(|o| o.location == "P3" && o.direction == Direction::X);
    found.next().unwrap()
}

#[test]
fn the_error_of_the_mesh_covers_the_truth() {
    let exact = answer(&at_level(Level::Standard), &ClosedFormSolver::new());
    let exact = at_centre(&exact).first_order.clone().unwrap();
    for level in [Level::Coarse, Level::Standard, Level::Reference] {
        let result = answer(&at_level(level), &Meshed::new());
        let output = at_centre(&result);
        let indices = output.first_order.as_ref().unwrap().iter().zip(&exact);
        let truth = indices.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        let mesh = output.error.mesh.unwrap();
        // Three times the error where the index has the strain's order, more where, as a share of the variance, it has a higher one.
        assert!(
            truth > 1e-4 && mesh > truth && mesh < 30.0 * truth,
            "{level:?} {mesh:e} {truth:e}"
        );
        assert!(output.error.total.unwrap() >= mesh && output.error.reason.is_none());
        assert_eq!(result.cost.coarser_solves, result.cost.solves);
        assert!(
            result
                .notes
                .iter()
                .all(|note| !note.contains("leave out the mesh"))
        );
    }
}

#[test]
fn a_draft_does_not_know_its_own() {
    let result = answer(&at_level(Level::Draft), &Meshed::new());
    let output = at_centre(&result);
    assert!(output.error.mesh.is_none() && output.error.reason.is_some());
    assert!(output.error.total.is_none() && output.error.quadrature.is_some());
    let claims_nothing =
        |l: &RankedLocation| l.error(GSI, Direction::X).is_none() && !l.rank_certain;
    assert!(result.locations.iter().all(claims_nothing));
    assert_eq!(result.cost.coarser_solves, 0);
    let mut notes = result.notes.iter();
    assert!(notes.any(|note| note.contains("off isn't known")));
}

#[test]
fn a_tolerance_takes_the_first_rung_that_claims_it() {
    let mut least = f64::INFINITY;
    for tolerance in [0.5, 0.1, 0.03] {
        let study = asking(Accuracy::Tolerance(tolerance), Level::Coarse);
        let climb = answer(&study, &Meshed::new()).climb.unwrap();
        let (last, before) = climb.rungs.split_last().unwrap();
        let claim = |rung: &results::ClimbRung| rung.error_claimed.unwrap();
        assert!(climb.met && claim(last) <= tolerance, "{climb:?}");
        assert!(
            before.iter().all(|rung| claim(rung) > tolerance),
            "{climb:?}"
        );
        assert!(claim(last) <= least, "a smaller tolerance, no larger claim");
        least = claim(last);
    }
}

#[test]
fn a_tolerance_out_of_reach_ends_at_the_top_and_says_so() {
    let study = asking(Accuracy::Tolerance(1e-4), Level::Coarse);
    let climb = answer(&study, &Meshed::new()).climb.unwrap();
    assert!(!climb.met);
    let last = &climb.rungs.last().unwrap().fidelity;
    assert_eq!(
        (last.level.as_str(), last.method.as_str()),
        ("reference", "auto")
    );
}

#[test]
fn at_the_top_the_method_takes_what_the_mesh_leaves() {
    let kinked = Meshed {
        kink: 8e-4,
        ..Meshed::new()
    };
    let mut adaptive = at_level(Level::Reference);
    adaptive.method.kind = Kind::Auto;
    let mesh = at_centre(&answer(&adaptive, &kinked)).error.mesh.unwrap();
    // Half of this is more than the mesh leaves.
    let tolerance = 1.05 * mesh;
    let study = asking(Accuracy::Tolerance(tolerance), Level::Coarse);
    let climb = answer(&study, &kinked).climb.unwrap();
    let claims: Vec<(&str, f64)> = climb
        .rungs
        .iter()
        .map(|rung| (rung.label.as_str(), rung.error_claimed.unwrap()))
        .collect();
    assert!(climb.met, "{tolerance}: {claims:?}");
    let [.., (before, claimed), (last, _)] = claims[..] else {
        panic!("{claims:?}");
    };
    assert!(
        before == last && claimed > tolerance,
        "{tolerance}: {claims:?}"
    );
}

#[test]
fn a_climb_resumes_to_the_same_bits() {
    let study = asking(Accuracy::Tolerance(0.03), Level::Coarse);
    let archive = MemoryArchive::default();
    let first = observed(&study, &Meshed::new(), &archive, 2).0.unwrap();
    let again = observed(&study, &Meshed::new(), &archive, 1).0.unwrap();
    assert_eq!(text(&first), text(&again));
    assert_eq!(archive.rewritten.into_inner(), 0);
}

#[test]
fn a_budget_ends_the_climb_in_time() {
    let slow = Meshed::of(ClosedFormSolver::new().with_delay(Duration::from_millis(20)));
    let budget = 1.0;
    let begun = Instant::now();
    let result = answer(&asking(Accuracy::Budget(budget), Level::Draft), &slow);
    // One solve more at most; a second is far more than a solve and the analysis take.
    assert!(begun.elapsed().as_secs_f64() < budget + 1.0);
    let climb = result.climb.unwrap();
    assert!(climb.met && !climb.rungs.is_empty());
    assert_eq!(climb.budget_s, Some(budget));
    assert_eq!(result.cost.rungs_wall_s.len(), climb.rungs.len());
}

#[test]
fn a_budget_too_small_for_a_draft_is_an_error() {
    let slow = Meshed::of(ClosedFormSolver::new().with_delay(Duration::from_millis(50)));
    let study = asking(Accuracy::Budget(0.1), Level::Draft);
    let ended = observed(&study, &slow, &MemoryArchive::default(), 1).0;
    assert_eq!(ended, Err(RunError::Budget { seconds: 0.1 }));
}
