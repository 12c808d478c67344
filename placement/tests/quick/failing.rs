//! Costs of a failed solve: its point where the load has no equilibrium; where the solver is to blame, the study, but no other point.

use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

use documents::study::Study;
use documents::study::plan::Plan;
use fem_client::closed_form::ClosedFormSolver;
use fem_client::scene::{Level, Scene};
use fem_client::solver::{
    Coarser, NoEquilibrium, Reached, SolveError, SolveRequest, Solved, Solver,
};
use gsa::method::{Kind, Method};
use placement::points::Event;
use placement::points::RunContext;
use placement::points::RunError;
use placement::run::run;

use crate::support::{MemoryArchive, Twisted, answered, observed, shipped, study, text};

const POINTS: usize = 26;

/// Limit between the last and the last but one of five Gauss nodes on [0.7, 1.3]: 1.1615 and 1.2718 mm.
const LIMIT_MM: f64 = 1.26;

/// Returns what the closed form with a depth limit says.
fn beyond_limit(request: &SolveRequest<'_>) -> Option<SolveError> {
    let limited = ClosedFormSolver::new().with_depth_limit(LIMIT_MM);
    limited.solve(request).err()
}

/// The points of a plan with a depth beyond the limit.
fn too_deep(plan: &Plan) -> Vec<usize> {
    let deep = |i: &usize| plan.values()[*i].iter().any(|depth| *depth > LIMIT_MM);
    (0..plan.values().len()).filter(deep).collect()
}

#[test]
fn points_without_equilibrium_are_named_and_cost_accuracy() {
    let study = shipped("foot-tire");
    let plan = Plan::new(&study).unwrap();
    let (result, events) = observed(
        &study,
        &Twisted::new(beyond_limit),
        &MemoryArchive::default(),
        2,
    );
    let result = result.unwrap();
    let ordinals: Vec<usize> = result.failed_points.iter().map(|p| p.ordinal).collect();
    assert_eq!(ordinals, too_deep(&plan));
    assert!((5..POINTS).contains(&ordinals.len()), "{ordinals:?}");
    for point in &result.failed_points {
        assert_eq!(&point.values, &plan.values()[point.ordinal]);
        let cause = "not-converged: no equilibrium beyond a depth of 1.26 mm";
        assert!(
            point.cause.to_string().starts_with(cause),
            "{}",
            point.cause
        );
        assert_eq!(point.cause.status, Some(NoEquilibrium::NotConverged));
    }
    let note = &result.notes[0];
    let count = format!("{} of 26 points without an equilibrium", ordinals.len());
    assert!(note.starts_with(&count), "{note}");
    assert!(note.contains("(P1 = 1.272): not-converged"), "{note}");
    assert_eq!(result.cost.solves, POINTS);

    let whole = answered(&study);
    for (output, whole) in result.outputs.iter().zip(&whole.outputs) {
        assert!(
            output.error.quadrature > whole.error.quadrature,
            "{output:?}"
        );
        let bound = output.error.total.unwrap() + whole.error.total.unwrap();
        let pairs = output.first_order.iter().flatten();
        for (less, all) in pairs.zip(whole.first_order.iter().flatten()) {
            assert!((less - all).abs() <= bound, "{less} for {all} +-{bound}");
        }
    }

    let failures = events
        .iter()
        .filter(|event| matches!(event, Event::PointFailed { .. }));
    assert_eq!(failures.count(), ordinals.len());
    let counts = events.iter().filter_map(|event| match event {
        Event::PointSolved { done, .. } | Event::PointFailed { done, .. } => Some(*done),
        _ => None,
    });
    assert!(counts.eq(1..=POINTS), "each point counts, solved or not");
}

#[test]
fn a_point_without_equilibrium_is_solved_once_and_the_result_is_the_same_to_the_bit() {
    let study = shipped("foot-tire");
    let plan = Plan::new(&study).unwrap();
    let undisturbed = {
        let solver = Twisted::new(beyond_limit);
        let result = observed(&study, &solver, &MemoryArchive::default(), 1).0;
        text(&result.unwrap())
    };
    let (archive, solver) = (MemoryArchive::default(), Twisted::new(beyond_limit));
    let (stop, failures) = (AtomicBool::new(false), AtomicUsize::new(0));
    let stop_at_the_second_failure = |event| {
        let failed = matches!(event, Event::PointFailed { .. });
        if failed && failures.fetch_add(1, Ordering::Relaxed) == 1 {
            stop.store(true, Ordering::Relaxed);
        }
    };
    let context = RunContext {
        solver: &solver,
        archive: &archive,
        threads: 1,
        stop: &stop,
        pause: None,
        observer: &stop_at_the_second_failure,
    };
    let stopped = run(&study, &plan, context);
    assert_eq!(stopped, Err(RunError::Stopped));
    let resumed = observed(&study, &solver, &archive, 3).0.unwrap();
    assert_eq!(text(&resumed), undisturbed);
    assert_eq!(solver.solves.load(Ordering::Relaxed), POINTS);

    let refuses = Twisted::new(|_: &SolveRequest<'_>| Some(SolveError::Stopped));
    let again = observed(&study, &refuses, &archive, 2).0.unwrap();
    assert_eq!(text(&again), undisturbed);
    assert_eq!(refuses.solves.load(Ordering::Relaxed), 0);
}

#[test]
fn what_a_solve_says_while_it_is_stopped_is_not_kept() {
    let study = shipped("foot-tire");
    let plan = Plan::new(&study).unwrap();
    let archive = MemoryArchive::default();
    let stop = AtomicBool::new(false);
    let solver = Twisted::new(|request: &SolveRequest<'_>| {
        let error = beyond_limit(request)?;
        stop.store(true, Ordering::Relaxed);
        Some(error)
    });
    let context = RunContext {
        solver: &solver,
        archive: &archive,
        threads: 1,
        stop: &stop,
        pause: None,
        observer: &|_| {},
    };
    let stopped = run(&study, &plan, context);
    assert_eq!(stopped, Err(RunError::Stopped));
    let stored = archive.points.lock().unwrap();
    assert!(!stored.is_empty());
    assert!(
        stored
            .values()
            .all(|(text, _)| !text.contains("no equilibrium"))
    );
}

/// Three depths, without a map.
fn small(kind: Kind) -> Study {
    let mut study = shipped("foot-tire");
    study.grid = None;
    study.inputs.truncate(3);
    study.method = Method {
        samples: 100,
        ..Method::of(kind)
    };
    study
}

#[test]
fn every_method_goes_on_without_the_points_that_failed() {
    for kind in Kind::ALL {
        let study = small(kind);
        let on = |threads| {
            let solver = Twisted::new(beyond_limit);
            let run = observed(&study, &solver, &MemoryArchive::default(), threads);
            run.0.unwrap()
        };
        let result = on(1);
        let failed = &result.failed_points;
        println!(
            "{}: {} of {} points failed",
            kind.as_str(),
            failed.len(),
            result.cost.solves
        );
        assert!(!failed.is_empty(), "{kind:?}");
        let deep = |values: &[f64]| values.iter().any(|depth| *depth > LIMIT_MM);
        assert!(failed.iter().all(|point| deep(&point.values)), "{kind:?}");
        for output in &result.outputs {
            let indices = output.first_order.iter().chain(&output.total).flatten();
            let indices: Vec<f64> = indices.copied().collect();
            assert_eq!(indices.len(), 6, "{kind:?} {output:?}");
            assert!(
                indices.iter().all(|s| (0.0..=1.0).contains(s)),
                "{kind:?} {output:?}"
            );
            let claimed = output.error.total.unwrap();
            assert!((0.0..=1.0).contains(&claimed), "{kind:?} {output:?}");
            // The points are named where the numbers are.
            let reason = output.reason.as_deref().unwrap_or("");
            assert!(
                reason.contains("without a finite value"),
                "{kind:?} {output:?}"
            );
        }
        assert_eq!(text(&on(3)), text(&result), "{kind:?}");
    }
}

#[test]
fn a_study_whose_other_points_give_no_index_fails_and_names_them() {
    let mut study = shipped("foot-tire");
    // Without the outer one of three nodes a line says nothing about its input.
    study.method.nodes = 3;
    let solver = ClosedFormSolver::new().with_depth_limit(1.2);
    let archive = MemoryArchive::default();
    let error = observed(&study, &solver, &archive, 2).0.unwrap_err();
    let RunError::TooManyFailed { failed } = &error else {
        panic!("{error}")
    };
    assert!(failed.len() >= 5, "{error}");
    let sentence = error.to_string();
    assert!(
        sentence.starts_with("the other points don't give any index: "),
        "{sentence}"
    );
    assert!(
        sentence.contains("no equilibrium beyond a depth of 1.2 mm"),
        "{sentence}"
    );
    let refuses = Twisted::new(|_: &SolveRequest<'_>| Some(SolveError::Stopped));
    let again = observed(&study, &refuses, &archive, 2).0;
    assert_eq!(again, Err(error), "the failures are in the archive");
}

#[test]
fn a_cut_point_without_equilibrium_ends_the_run_at_once() {
    let study = shipped("foot-tire");
    let solver = Twisted::new(|request: &SolveRequest<'_>| {
        let limited = ClosedFormSolver::new().with_depth_limit(0.5);
        limited.solve(request).err()
    });
    let archive = MemoryArchive::default();
    for expected in [1, 0] {
        let before = solver.solves.load(Ordering::Relaxed);
        let (result, events) = observed(&study, &solver, &archive, 2);
        let Err(RunError::PointsFailed { failed }) = result else {
            panic!("{result:?}")
        };
        assert_eq!((failed.len(), failed[0].ordinal), (1, 0));
        assert_eq!(
            events.len(),
            1 + expected,
            "the start, and the failure when it is news"
        );
        assert_eq!(solver.solves.load(Ordering::Relaxed) - before, expected);
    }
}

#[test]
fn a_panic_costs_its_point_alone() {
    let study = shipped("foot-tire");
    let plan = Plan::new(&study).unwrap();
    let victim = plan.points[7].clone();
    let solver = Twisted::new(move |request: &SolveRequest<'_>| {
        assert!(*request.scene != victim, "element 12 is inside out");
        None
    });
    let archive = MemoryArchive::default();
    let (result, events) = observed(&study, &solver, &archive, 2);
    let failed = result.unwrap().failed_points;
    assert_eq!((failed.len(), failed[0].ordinal), (1, 7));
    assert_eq!(
        failed[0].cause.to_string(),
        "solver-failed: panic: element 12 is inside out"
    );
    let told = |event: &&Event| matches!(event, Event::PointFailed { ordinal: 7, .. });
    assert_eq!(events.iter().filter(told).count(), 1);
    assert_eq!(archive.points.lock().unwrap().len(), POINTS - 1);
    let repaired = observed(&study, &ClosedFormSolver::new(), &archive, 2)
        .0
        .unwrap();
    assert_eq!(repaired.cost.reused, POINTS - 1);
    assert!(repaired.failed_points.is_empty());
}

#[test]
fn a_broken_solver_is_asked_once_more_and_no_more() {
    let study = shipped("foot-tire");
    for (breaks, expected) in [(1, true), (2, false)] {
        let left = AtomicUsize::new(breaks);
        let solver = Twisted::new(move |_: &SolveRequest<'_>| {
            let broken =
                left.fetch_update(Ordering::Relaxed, Ordering::Relaxed, |n| n.checked_sub(1));
            broken.ok().map(|_| SolveError::Broken {
                detail: "lost its file".to_owned(),
            })
        });
        let (result, _) = observed(&study, &solver, &MemoryArchive::default(), 1);
        assert_eq!(result.is_ok(), expected, "{breaks} breaks");
    }
}

#[test]
fn a_response_that_is_not_finite_is_never_stored() {
    struct NotANumber;
    impl Solver for NotANumber {
        fn version(&self) -> String {
            "nan".to_owned()
        }
        fn solve(&self, request: &SolveRequest<'_>) -> Result<Solved, SolveError> {
            let mut solved = ClosedFormSolver::new().solve(request)?;
            if request.start.is_some() {
                solved.response.map.as_mut().unwrap().strain.y[3] = f64::NAN;
            }
            Ok(solved)
        }
    }
    let archive = MemoryArchive::default();
    let result = observed(&shipped("foot-tire"), &NotANumber, &archive, 1).0;
    let Err(RunError::TooManyFailed { failed }) = result else {
        panic!("{result:?}")
    };
    assert_eq!(failed.len(), POINTS - 1);
    assert!(
        failed[0]
            .cause
            .to_string()
            .contains("a strain of the map isn't a finite number")
    );
    assert_eq!(archive.points.lock().unwrap().len(), 1);
}

/// The closed form on two meshes, of which the finer one has no equilibrium on uneven ground.
struct Burst;

impl Solver for Burst {
    fn version(&self) -> String {
        ClosedFormSolver::new().version()
    }

    fn coarser(&self, scene: &Scene) -> Option<Coarser> {
        (scene.model.level == Level::Coarse).then_some(Coarser {
            level: Level::Draft,
            factor: 1.0,
            of_largest: 1.0,
        })
    }

    fn solve(&self, request: &SolveRequest<'_>) -> Result<Solved, SolveError> {
        let scene = request.scene;
        let depths = &scene.ground.depths_mm;
        if scene.model.level == Level::Coarse && depths.iter().any(|depth| *depth != depths[0]) {
            return Err(SolveError::NoEquilibrium {
                status: NoEquilibrium::NotConverged,
                detail: "it burst".to_owned(),
                reached: Reached::default(),
            });
        }
        ClosedFormSolver::new().solve(request)
    }
}

/// Answers of the coarser mesh aren't taken for what the finer one lacks.
#[test]
fn a_contact_without_equilibrium_leaves_layouts_without_scores() {
    let document = "name = \"burst\"
scene = { preset = \"foot-tire\" }
inputs = [{ name = \"c\", vary = \"pressure.internal_mpa\", distribution = { kind = \"uniform\", min = 0.01, max = 0.02 } }]
method = { kind = \"mdrm\", nodes = 2, check_points = 0, seed = 1 }
accuracy = { preset = \"coarse\" }
[layouts]
units = [6]
positions = [\"crown\"]
depths_mm = [1]
[layouts.contacts]
uneven = { kind = \"uniform\", min = -0.1, max = 0.1 }
pressure_factor = { kind = \"uniform\", min = 0.9, max = 1.1 }
";
    let study = study(document);
    let (result, _) = observed(&study, &Burst, &MemoryArchive::default(), 2);
    let result = result.unwrap();
    let reasons = result.layout_findings.unwrap().reasons.join(" ");
    assert!(reasons.contains("it burst"), "{reasons}");
    for layout in &result.layouts {
        assert_eq!(layout.score.simulated_p95_angle_error_deg, None);
    }
}
