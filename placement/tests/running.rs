//! Runs of whole studies: the same bits on any number of threads and after any interruption, and failures that cost
//! no more than they must.

mod support;

use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::time::Duration;

use fem_client::closed_form::ClosedFormSolver;
use fem_client::solver::{SolveError, SolveRequest, Solver};
use placement::plan::Plan;
use placement::run::{Event, RunError, run};
use support::{MemoryArchive, Twisted, observed, shipped, text};

const POINTS: usize = 26;

#[test]
fn the_result_is_the_same_to_the_bit_on_any_number_of_threads() {
    let study = shipped("foot-tire");
    let on = |threads| {
        let solver = ClosedFormSolver::new().with_delay(Duration::from_millis(1));
        text(
            &observed(&study, &solver, &MemoryArchive::default(), threads)
                .0
                .unwrap(),
        )
    };
    let one = on(1);
    assert_eq!(on(2), one);
    assert_eq!(on(7), one);
}

#[test]
fn a_stopped_run_goes_on_where_it_ended_and_gives_the_same_bits() {
    let study = shipped("foot-tire");
    let plan = Plan::new(&study).unwrap();
    let (archive, solver) = (
        MemoryArchive::default(),
        Twisted::new(|_: &SolveRequest<'_>| None),
    );
    let stop = AtomicBool::new(false);
    let stop_at_nine = |event| {
        if matches!(event, Event::PointSolved { done: 9, .. }) {
            stop.store(true, Ordering::Relaxed);
        }
    };
    let stopped = run(&study, &plan, &solver, &archive, 2, &stop, &stop_at_nine);
    assert_eq!(stopped, Err(RunError::Stopped));
    // The other thread may have been in the middle of one more solve.
    let stored = archive.points.lock().unwrap().len();
    assert!((9..=10).contains(&stored), "{stored}");

    let (resumed, events) = observed(&study, &solver, &archive, 2);
    let resumed = resumed.unwrap();
    assert_eq!(
        events[0],
        Event::Started {
            points: POINTS,
            reused: stored
        }
    );
    assert_eq!(resumed.cost.reused, stored);
    assert_eq!(archive.rewritten.load(Ordering::Relaxed), 0);
    let solved = events
        .iter()
        .filter(|event| matches!(event, Event::PointSolved { .. }))
        .count();
    assert_eq!(solved, POINTS - stored);
    let undisturbed = observed(&study, &solver, &MemoryArchive::default(), 1)
        .0
        .unwrap();
    assert_eq!(text(&resumed), text(&undisturbed));
}

#[test]
fn a_finished_study_is_answered_from_the_archive_alone() {
    let study = shipped("foot-tire");
    let archive = MemoryArchive::default();
    let first = observed(&study, &ClosedFormSolver::new(), &archive, 2)
        .0
        .unwrap();
    let refuses = Twisted::new(|_: &SolveRequest<'_>| Some(SolveError::Stopped));
    let (again, events) = observed(&study, &refuses, &archive, 2);
    assert_eq!(text(&again.unwrap()), text(&first));
    assert_eq!(
        events,
        [
            Event::Started {
                points: POINTS,
                reused: POINTS
            },
            Event::Analysing
        ]
    );
    assert_eq!(refuses.solves.load(Ordering::Relaxed), 0);
}

#[test]
fn events_come_in_order() {
    let study = shipped("foot-tire");
    let (result, events) = observed(
        &study,
        &ClosedFormSolver::new(),
        &MemoryArchive::default(),
        4,
    );
    result.unwrap();
    assert_eq!(
        events.first(),
        Some(&Event::Started {
            points: POINTS,
            reused: 0
        })
    );
    assert!(matches!(
        events[1],
        Event::PointSolved {
            ordinal: 0,
            done: 1,
            of: POINTS,
            ..
        }
    ));
    assert_eq!(events.last(), Some(&Event::Analysing));
    let counts: Vec<usize> = events
        .iter()
        .filter_map(|event| match event {
            Event::PointSolved { done, .. } => Some(*done),
            _ => None,
        })
        .collect();
    assert_eq!(counts, (1..=POINTS).collect::<Vec<_>>());
}

#[test]
fn every_other_point_starts_from_the_cut_point() {
    let study = shipped("foot-tire");
    let starts = Mutex::new(Vec::new());
    let watch = Twisted::new(|request: &SolveRequest<'_>| {
        starts
            .lock()
            .unwrap()
            .push(request.start.map(|start| start.depths_mm.clone()));
        None
    });
    observed(&study, &watch, &MemoryArchive::default(), 3)
        .0
        .unwrap();
    let starts = starts.lock().unwrap();
    assert_eq!(starts[0], None);
    assert!(
        starts[1..]
            .iter()
            .all(|start| start.as_deref() == Some(&[1.0; 5]))
    );
}

#[test]
fn a_point_without_equilibrium_is_named_and_its_siblings_are_kept() {
    let study = shipped("foot-tire");
    let archive = MemoryArchive::default();
    // The outermost of five Gauss nodes on [0.7, 1.3] lie at 1 +-0.2718, the next at 1 +-0.1615.
    let solver = ClosedFormSolver::new().with_depth_limit(1.2);
    let (result, events) = observed(&study, &solver, &archive, 2);
    let Err(RunError::PointsFailed { failed }) = result else {
        panic!("{result:?}")
    };
    let plan = Plan::new(&study).unwrap();
    let too_deep = |values: &Vec<f64>| values.iter().any(|depth| *depth > 1.2);
    let expected: Vec<usize> = (0..POINTS)
        .filter(|i| too_deep(&plan.values()[*i]))
        .collect();
    assert_eq!(
        failed.iter().map(|point| point.ordinal).collect::<Vec<_>>(),
        expected
    );
    for point in &failed {
        assert_eq!(&point.values, &plan.values()[point.ordinal]);
        assert!(
            point
                .cause
                .starts_with("not-converged: no equilibrium beyond a depth of 1.2 mm")
        );
    }
    assert_eq!(archive.points.lock().unwrap().len(), POINTS - failed.len());
    let reported = events
        .iter()
        .filter(|event| matches!(event, Event::PointFailed { .. }))
        .count();
    assert_eq!(reported, failed.len());
}

#[test]
fn a_cut_point_without_equilibrium_ends_the_run_at_once() {
    let study = shipped("foot-tire");
    let solver = ClosedFormSolver::new().with_depth_limit(0.5);
    let (result, events) = observed(&study, &solver, &MemoryArchive::default(), 2);
    let Err(RunError::PointsFailed { failed }) = result else {
        panic!("{result:?}")
    };
    assert_eq!(
        failed.iter().map(|point| point.ordinal).collect::<Vec<_>>(),
        [0]
    );
    assert_eq!(events.len(), 2);
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
    let (result, _) = observed(&study, &solver, &archive, 2);
    let Err(RunError::PointsFailed { failed }) = result else {
        panic!("{result:?}")
    };
    assert_eq!((failed.len(), failed[0].ordinal), (1, 7));
    assert!(
        failed[0].cause.contains("element 12 is inside out"),
        "{}",
        failed[0].cause
    );
    assert_eq!(archive.points.lock().unwrap().len(), POINTS - 1);
    let repaired = observed(&study, &ClosedFormSolver::new(), &archive, 2)
        .0
        .unwrap();
    assert_eq!(repaired.cost.reused, POINTS - 1);
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
fn a_missing_start_state_is_an_error_that_names_the_entry() {
    let study = shipped("foot-tire");
    let archive = MemoryArchive::default();
    let solver = ClosedFormSolver::new().with_depth_limit(1.2);
    observed(&study, &solver, &archive, 1).0.unwrap_err();
    let key = archive.starts.lock().unwrap().drain().next().unwrap().0;
    let result = observed(&study, &ClosedFormSolver::new(), &archive, 1).0;
    assert_eq!(result, Err(RunError::StartMissing { key }));
}

#[test]
fn a_response_that_is_not_finite_is_never_stored() {
    struct NotANumber;
    impl Solver for NotANumber {
        fn version(&self) -> String {
            "nan".to_owned()
        }
        fn solve(
            &self,
            request: &SolveRequest<'_>,
        ) -> Result<fem_client::solver::Solved, SolveError> {
            let mut solved = ClosedFormSolver::new().solve(request)?;
            if request.start.is_some() {
                solved.response.rings[1].strain_y[3] = f64::NAN;
            }
            Ok(solved)
        }
    }
    let archive = MemoryArchive::default();
    let result = observed(&shipped("foot-tire"), &NotANumber, &archive, 1).0;
    let Err(RunError::PointsFailed { failed }) = result else {
        panic!("{result:?}")
    };
    assert_eq!(failed.len(), POINTS - 1);
    assert!(
        failed[0]
            .cause
            .contains("a strain of a ring isn't a finite number")
    );
    assert_eq!(archive.points.lock().unwrap().len(), 1);
}
