//! Runs of whole studies: the same bits on any number of threads and after any interruption.

use std::collections::HashSet;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::{Condvar, Mutex};
use std::time::Duration;

use documents::layouts::gluing_limits::GluingLimits;
use documents::layouts::layout_settings::{LayoutLoads, Layouts, SearchSettings};
use documents::study::Study;
use documents::study::plan::Plan;
use fem_client::closed_form::ClosedFormSolver;
use fem_client::scene::{Level, Scene};
use fem_client::solver::{
    Coarser, NoEquilibrium, Position, Reached, SolveError, SolveRequest, Solved, Solver,
};
use placement::ladder::climb::answer;
use placement::points::Event;
use placement::points::RunContext;
use placement::points::RunError;
use placement::points::usage::cpu_s;

use crate::support::{MemoryArchive, Twisted, observed, shipped, text};

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
fn layouts_are_scored_and_searched_alike_on_any_number_of_threads() {
    let mut study = shipped("foot-tire");
    study.level = Level::Draft;
    study.layouts = Layouts {
        units: vec![5, 6],
        staggered: true,
        dead: true,
        search: Some(SearchSettings {
            films: vec![2, 4],
            slots: 9,
            section_deg: vec![0.0],
            directions: vec![0.0, 90.0],
            limits: GluingLimits::default(),
        }),
        ..Layouts::none()
    };
    study.layouts.positions = vec![Position::Crown];
    let on = |threads| {
        let solver = ClosedFormSolver::new();
        text(
            &observed(&study, &solver, &MemoryArchive::default(), threads)
                .0
                .unwrap(),
        )
    };
    let one = on(1);
    assert!(one.contains("best 4 films, 1") && one.contains("interval errors"));
    assert_eq!(on(3), one);
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
    let context = RunContext {
        solver: &solver,
        archive: &archive,
        threads: 2,
        stop: &stop,
        pause: None,
        observer: &stop_at_nine,
    };
    let stopped = answer(&study, &plan, context);
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

/// A pause lets every run do something even when the wish is there from the start: it comes to its end, and to the same bits.
#[test]
fn a_run_that_is_paused_again_and_again_comes_to_its_end() {
    let study = shipped("foot-tire");
    let plan = Plan::new(&study).unwrap();
    let solver = Twisted::new(|_: &SolveRequest<'_>| None);
    let archive = MemoryArchive::default();
    let (stop, pause) = (AtomicBool::new(false), AtomicBool::new(true));
    let context = RunContext {
        solver: &solver,
        archive: &archive,
        threads: 2,
        stop: &stop,
        pause: Some(&pause),
        observer: &|_| {},
    };
    let mut stored = Vec::new();
    let result = loop {
        match answer(&study, &plan, context) {
            Err(RunError::Paused) => stored.push(archive.points.lock().unwrap().len()),
            other => break other.unwrap(),
        }
    };
    let steps = || stored.windows(2).map(|pair| pair[1] - pair[0]);
    assert!(steps().all(|step| (1..=2).contains(&step)), "{stored:?}");
    assert_eq!(solver.solves.load(Ordering::Relaxed), POINTS);
    let undisturbed = observed(&study, &solver, &MemoryArchive::default(), 1)
        .0
        .unwrap();
    assert_eq!(text(&result), text(&undisturbed));
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

/// Linux alone tells it.
#[cfg(target_os = "linux")]
#[test]
fn processor_time_is_that_of_the_run_s_own_threads() {
    const OF_A_SOLVE: f64 = 0.02;
    const OTHERS: usize = 4;
    let busy = || {
        let begun = cpu_s();
        while cpu_s() - begun < OF_A_SOLVE {
            std::hint::black_box(0);
        }
    };
    let solver = Twisted::new(|_: &SolveRequest<'_>| {
        busy();
        None
    });
    let ended = AtomicBool::new(false);
    let other = || {
        while !ended.load(Ordering::Relaxed) {
            busy();
        }
        cpu_s()
    };
    std::thread::scope(|scope| {
        // At work beside it, as other designs of a sweep are.
        let others: Vec<_> = (0..OTHERS).map(|_| scope.spawn(other)).collect();
        let (study, archive) = (shipped("foot-tire"), MemoryArchive::default());
        let result = observed(&study, &solver, &archive, 2).0.unwrap();
        ended.store(true, Ordering::Relaxed);
        let own = result.cost.cpu_s;
        let others: f64 = others.into_iter().map(|o| o.join().unwrap()).sum();
        let solves = solver.solves.load(Ordering::Relaxed) as f64 * OF_A_SOLVE;
        // The rest is the analysis.
        let bound = solves..solves + 0.5 * others;
        assert!(
            bound.contains(&own),
            "{own} s, solves {solves} s, others {others} s"
        );
    });
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

/// A solver with a coarser mesh, on which all is alike.
struct OnTwoMeshes<F>(Twisted<F>);

impl<F> Solver for OnTwoMeshes<F>
where
    F: Fn(&SolveRequest<'_>) -> Option<SolveError> + Send + Sync,
{
    fn version(&self) -> String {
        self.0.version()
    }

    fn coarser(&self, _: &Scene) -> Option<Coarser> {
        Some(Coarser {
            level: Level::Draft,
            factor: 1.0,
            of_largest: 1.0,
        })
    }

    fn solve(&self, request: &SolveRequest<'_>) -> Result<Solved, SolveError> {
        self.0.solve(request)
    }
}

/// The cut point's solve waits for the other mesh's to begin, which a thread without work takes.
#[test]
fn both_meshes_are_solved_at_once_on_as_many_threads_as_are_asked_for() {
    const LONGEST: Duration = Duration::from_secs(20);
    let study = shipped("foot-tire");
    let (begun, beginning) = (Mutex::new(0), Condvar::new());
    let (at_once, most) = (AtomicUsize::new(0), AtomicUsize::new(0));
    let meets_the_other = AtomicBool::new(false);
    let solver = OnTwoMeshes(Twisted::new(|request: &SolveRequest<'_>| {
        most.fetch_max(
            at_once.fetch_add(1, Ordering::Relaxed) + 1,
            Ordering::Relaxed,
        );
        if request.start.is_none() {
            *begun.lock().unwrap() += 1;
            beginning.notify_all();
            let both =
                beginning.wait_timeout_while(begun.lock().unwrap(), LONGEST, |begun| *begun < 2);
            meets_the_other.store(*both.unwrap().0 == 2, Ordering::Relaxed);
        }
        at_once.fetch_sub(1, Ordering::Relaxed);
        None
    }));
    let (result, events) = observed(&study, &solver, &MemoryArchive::default(), 2);
    assert!(meets_the_other.load(Ordering::Relaxed));
    assert_eq!(most.load(Ordering::Relaxed), 2);
    let counts = events.iter().filter_map(|event| match event {
        Event::PointSolved { done, .. } => Some(*done),
        _ => None,
    });
    assert_eq!(
        counts.collect::<Vec<_>>(),
        (1..=2 * POINTS).collect::<Vec<_>>()
    );
    let alone = OnTwoMeshes(Twisted::new(|_: &SolveRequest<'_>| None));
    let alone = observed(&study, &alone, &MemoryArchive::default(), 1).0;
    assert_eq!(text(&result.unwrap()), text(&alone.unwrap()));
}

#[test]
fn without_the_cut_point_nothing_is_solved_on_the_coarser_mesh() {
    let study = shipped("foot-tire");
    let solver = OnTwoMeshes(Twisted::new(|_: &SolveRequest<'_>| {
        let detail = "as asked".to_owned();
        Some(SolveError::Broken { detail })
    }));
    let (result, events) = observed(&study, &solver, &MemoryArchive::default(), 1);
    assert!(
        matches!(result, Err(RunError::PointsFailed { .. })),
        "{result:?}"
    );
    // A solve that breaks is tried twice.
    assert_eq!(solver.0.solves.load(Ordering::Relaxed), 2);
    assert_eq!(events.len(), 2, "{events:?}");
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

/// A study whose layouts are pressed to 0.5, 1 and 2 mm.
fn pressed_thrice() -> Study {
    let mut study = shipped("foot-tire");
    study.layouts = Layouts {
        units: vec![6],
        loads: LayoutLoads::Depths(vec![0.5, 1.0, 2.0]),
        positions: vec![Position::Crown],
        ..Layouts::none()
    };
    study
}

/// Depths of layouts' solves, with those that they started from.
type Begun = Mutex<Vec<(f64, Option<f64>)>>;

/// Notes what layouts' solves start from; at 2 mm it may fail.
fn noting(
    begun: &Begun,
    at_2_mm: fn() -> Option<SolveError>,
) -> Twisted<impl Fn(&SolveRequest<'_>) -> Option<SolveError> + Send + Sync> {
    Twisted::new(move |request: &SolveRequest<'_>| {
        if request.readout.rings.is_empty() {
            return None;
        }
        let depth = request.scene.ground.depths_mm[0];
        let start = request.start.map(|start| start.depths_mm[0]);
        begun.lock().unwrap().push((depth, start));
        if depth == 2.0 { at_2_mm() } else { None }
    })
}

fn reached() -> Option<SolveError> {
    None
}

fn without_equilibrium() -> Option<SolveError> {
    Some(SolveError::NoEquilibrium {
        status: NoEquilibrium::NotConverged,
        detail: "as asked".to_owned(),
        reached: Reached::default(),
    })
}

fn broken() -> Option<SolveError> {
    let detail = "as asked".to_owned();
    Some(SolveError::Broken { detail })
}

#[test]
fn loads_of_layouts_start_from_the_nearest_load_that_has_an_equilibrium() {
    let study = pressed_thrice();
    for (at_2_mm, far) in [(reached as fn() -> _, 2.0), (without_equilibrium, 1.0)] {
        let begun = Begun::default();
        let result = observed(
            &study,
            &noting(&begun, at_2_mm),
            &MemoryArchive::default(),
            3,
        )
        .0;
        result.unwrap();
        let mut begun = begun.into_inner().unwrap();
        begun.sort_by(|a, b| a.0.total_cmp(&b.0));
        let starts = |depth: f64| match depth {
            1.0 => None,
            d if d < 0.6 && d != 0.5 => Some(0.5),
            d if d > 1.5 && d != 2.0 => Some(far),
            _ => Some(1.0),
        };
        assert_eq!(begun.len(), 11);
        assert!(
            begun.iter().all(|(depth, start)| *start == starts(*depth)),
            "{begun:?}"
        );
    }
}

#[test]
fn loads_that_are_stored_are_started_from_again() {
    let study = pressed_thrice();
    let archive = MemoryArchive::default();
    let whole = observed(&study, &noting(&Begun::default(), reached), &archive, 2).0;
    // What others start from is kept, and every other point of layouts lost.
    let starts: HashSet<String> = archive.starts.lock().unwrap().keys().cloned().collect();
    assert_eq!(starts.len(), 1 + 3, "the cut point, and three loads");
    archive
        .points
        .lock()
        .unwrap()
        .retain(|key, _| starts.contains(key));
    let begun = Begun::default();
    let solver = noting(&begun, reached);
    let again = observed(&study, &solver, &archive, 2).0;
    assert_eq!(text(&again.unwrap()), text(&whole.unwrap()));
    assert_eq!(solver.solves.load(Ordering::Relaxed), POINTS - 1 + 8);
    let begun = begun.lock().unwrap();
    assert!(
        begun
            .iter()
            .all(|(depth, start)| start.is_some() && *depth != 2.0)
    );
}

#[test]
fn what_started_elsewhere_because_a_solver_broke_is_not_kept() {
    let study = pressed_thrice();
    let archive = MemoryArchive::default();
    let broke = observed(&study, &noting(&Begun::default(), broken), &archive, 2).0;
    assert!(broke.is_ok(), "{broke:?}");
    // 2 mm, and the three loads beside it.
    assert_eq!(archive.points.lock().unwrap().len(), POINTS + 11 - 4);
    let begun = Begun::default();
    let solver = noting(&begun, reached);
    let mended = observed(&study, &solver, &archive, 2).0;
    assert_eq!(solver.solves.load(Ordering::Relaxed), 4);
    let begun = begun.lock().unwrap();
    let beside = begun.iter().filter(|(_, start)| *start == Some(2.0));
    assert_eq!(beside.count(), 3);
    let whole = observed(
        &study,
        &noting(&Begun::default(), reached),
        &MemoryArchive::default(),
        2,
    )
    .0;
    assert_eq!(text(&mended.unwrap()), text(&whole.unwrap()));
}

#[test]
fn a_missing_start_state_is_an_error_that_names_the_entry() {
    let study = shipped("foot-tire");
    let archive = MemoryArchive::default();
    let breaks = Twisted::new(|request: &SolveRequest<'_>| {
        request.start.map(|_| SolveError::Broken {
            detail: "lost its file".to_owned(),
        })
    });
    observed(&study, &breaks, &archive, 1).0.unwrap_err();
    let key = archive.starts.lock().unwrap().drain().next().unwrap().0;
    let result = observed(&study, &ClosedFormSolver::new(), &archive, 1).0;
    assert_eq!(result, Err(RunError::StartMissing { key }));
}

#[test]
fn films_without_room_are_no_layout_and_the_others_keep_off_the_valve() {
    let mut study = shipped("foot-tire");
    study.level = Level::Draft;
    // At the sidewall, 90 degrees, films end a wall off the bead: 11.9 degrees on, and half of 5 mm is 15.1.
    study.layouts = Layouts {
        films: vec![6],
        size_mm: Some([10.0, 5.0]),
        limits: GluingLimits {
            forbidden_deg: vec![[350.0, 10.0]],
            ..GluingLimits::default()
        },
        ..Layouts::default()
    };
    let solver = ClosedFormSolver::new();
    let (result, _) = observed(&study, &solver, &MemoryArchive::default(), 1);
    let result = result.unwrap();
    let findings = result.layout_findings.expect("layouts");
    assert_eq!(findings.menu.without_room, 4);
    let films = result.answer.expect("an answer").films;
    assert_eq!(films.len(), 6);
    // Half of a film's 5 or 10 mm is 3 or 6.1 degrees of the crown.
    let apart = |theta: f64| (theta + 180.0).rem_euclid(360.0) - 180.0;
    assert!(films.iter().all(|film| apart(film.theta_deg).abs() > 13.0));
}
