//! Points of a large study that are solved elsewhere, part by part.

use std::sync::atomic::{AtomicBool, Ordering};

use documents::study::Study;
use documents::study::plan::PlannedStudy;
use fem_client::solver::{SolveRequest, Solver};
use gsa::method::Kind;
use placement::points::RunContext;
use placement::points::archive::Archive;
use placement::sharing::{Part, is_shareable};

use crate::support::{MemoryArchive, Twisted, observed, shipped, text};

fn tensor() -> Study {
    let mut study = shipped("foot-tire");
    study.method.kind = Kind::Tensor;
    study.method.nodes = 2;
    study
}

/// A run on one thread.
fn on<'c>(
    solver: &'c dyn Solver,
    archive: &'c dyn Archive,
    stop: &'c AtomicBool,
) -> RunContext<'c> {
    RunContext {
        solver,
        archive,
        threads: 1,
        stop,
        pause: None,
        observer: &|_| {},
    }
}

#[test]
fn parts_solved_anywhere_leave_nothing_to_solve_and_change_no_bit() {
    let study = tensor();
    let planned = PlannedStudy::new(study.clone()).unwrap();
    let all = planned.plan.points.len();
    assert!(is_shareable(&study) && all >= 2_usize.pow(5), "{all}");
    let solver = Twisted::new(|_: &SolveRequest<'_>| None);
    let solves = || solver.solves.load(Ordering::Relaxed);
    let (home, stop) = (MemoryArchive::default(), AtomicBool::new(false));
    Part::solve_cut_points(&planned, on(&solver, &home, &stop)).unwrap();
    assert_eq!(solves(), 1);
    for number in 1..=3 {
        let part = Part { number, of: 3 };
        // Elsewhere they have what they start from, and nothing else.
        let elsewhere = MemoryArchive::default();
        *elsewhere.starts.lock().unwrap() = home.starts.lock().unwrap().clone();
        let cut = part.points(&planned, &solver)[0].cut.clone();
        let known = home.points.lock().unwrap()[&cut].clone();
        elsewhere.points.lock().unwrap().insert(cut, known);
        let before = solves();
        part.solve(&planned, on(&solver, &elsewhere, &stop))
            .unwrap();
        let points = part.points(&planned, &solver);
        assert_eq!(solves() - before, points.len());
        let solved = elsewhere.points.into_inner().unwrap();
        assert!(points.iter().all(|point| solved.contains_key(&point.key)));
        home.points.lock().unwrap().extend(solved);
    }
    let before = solves();
    assert_eq!(before, all);
    let (gathered, _) = observed(&study, &solver, &home, 2);
    let of_effects = solves() - before;
    let (alone, _) = observed(&study, &solver, &MemoryArchive::default(), 2);
    assert_eq!(text(&gathered.unwrap()), text(&alone.unwrap()));
    assert_eq!(solves() - before - of_effects, all + of_effects);
}

#[test]
fn points_that_depend_on_what_others_answer_are_not_shared_out() {
    let mut study = tensor();
    study.method.kind = Kind::Auto;
    assert!(!is_shareable(&study));
}
