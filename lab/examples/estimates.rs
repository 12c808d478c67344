//! Worth of a study's estimate: before it begins, and after a tenth of its solves. Twelve studies of all sorts, each in a process of its own on a
//! machine of which nothing is known. The table of `docs/proof/speed.md`.
//!
//! `cargo run --release -p lab --example estimates [-- NAME]`, ten minutes on two cores.

use std::collections::HashSet;
use std::process::Command;
use std::sync::Mutex;
use std::sync::atomic::AtomicBool;
use std::time::Instant;

use documents::study::plan::PlannedStudy;
use fem_client::solver::{Cost, StartState};
use placement::estimate::{Machine, Pace, Workload};
use placement::ladder::climb;
use placement::points::Event;
use placement::points::RunContext;
use placement::points::archive::{Archive, ArchiveError, Outcome, PointRecord};
use placement::points::memory::MemoryArchive;
use placement::points::usage::peak_memory_bytes;
use serde_json::{Value, json};
use tire::embedded::EmbeddedSolver;

const THREADS: usize = 2;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    if let Some(wanted) = std::env::args().nth(1) {
        let found = studies().into_iter().find(|(name, _)| *name == wanted);
        let (name, document) = found.ok_or("no study of this name")?;
        return measured(name, document);
    }
    println!(
        "| study | solves | expected s | after a tenth s | took s | off by | estimated MB | took MB |"
    );
    println!("| --- | --- | --- | --- | --- | --- | --- | --- |");
    for (name, _) in studies() {
        Command::new(std::env::current_exe()?).arg(name).status()?;
    }
    Ok(())
}

/// The five depths, and what each study changes of the shipped one.
fn studies() -> [(&'static str, Value); 12] {
    let depths = |least: f64, greatest: f64| {
        let depth = |station: usize| {
            json!({"name": format!("P{}", station + 1), "vary": format!("ground.depths_mm[{station}]"),
                   "distribution": {"kind": "uniform", "min": least, "max": greatest}})
        };
        (0..5).map(depth).collect::<Vec<Value>>()
    };
    let varied = |field: &str, least: f64, greatest: f64| json!({"name": field, "vary": field, "distribution": {"kind": "uniform", "min": least, "max": greatest}});
    let study = |level: &str, scene: Value, inputs: Vec<Value>, more: Value| {
        let mut scene = scene;
        scene["preset"] = json!("foot-tire");
        let mut document = json!({"name": "estimates", "scene": scene, "inputs": inputs, "accuracy": {"preset": level},
               "candidates": {"points": "P1-P5"}, "method": {"kind": "mdrm", "nodes": 5, "check_points": 5}});
        for (field, value) in more.as_object().into_iter().flatten() {
            document[field] = value.clone();
        }
        document
    };
    let shallow = || depths(0.7, 1.3);
    let deep = json!({"ground": {"depths_mm": [5.0, 5.0, 5.0, 5.0, 5.0]}});
    let bare =
        json!({"geometry": {"wall_mm": 5.0}, "pressure": {"internal_mpa": 0.05}, "carcass": null});
    let map = |x: usize, y: usize| json!({"points": "P1-P5", "grid": {"circumferential": x, "meridional": y}});
    let mut many = shallow();
    many.push(varied("pressure.internal_mpa", 0.18, 0.22));
    many.push(varied("geometry.wall_mm", 2.8, 3.2));
    many.push(varied("carcass.stiffness_n_per_mm", 90.0, 110.0));
    let none = || json!({});
    [
        ("draft", study("draft", none(), shallow(), none())),
        ("coarse", study("coarse", none(), shallow(), none())),
        ("standard", study("standard", none(), shallow(), none())),
        ("reference", study("reference", none(), shallow(), none())),
        ("deep", study("coarse", deep, depths(4.0, 6.0), none())),
        ("bare", study("coarse", bare, shallow(), none())),
        (
            "stiff",
            study(
                "coarse",
                json!({"carcass": {"stiffness_n_per_mm": 800.0}}),
                shallow(),
                none(),
            ),
        ),
        (
            "thin",
            study(
                "coarse",
                json!({"geometry": {"wall_mm": 1.0}}),
                shallow(),
                none(),
            ),
        ),
        (
            "slipping",
            study(
                "draft",
                json!({"contact": {"friction": 0.5}}),
                shallow(),
                none(),
            ),
        ),
        ("many inputs", study("coarse", none(), many, none())),
        (
            "large map",
            study(
                "draft",
                none(),
                shallow(),
                json!({"candidates": map(101, 101)}),
            ),
        ),
        (
            "pce on a map",
            study(
                "coarse",
                none(),
                shallow(),
                json!({"candidates": map(61, 21), "method": {"kind": "pce", "samples": 60}}),
            ),
        ),
    ]
}

/// Prints a row.
fn measured(name: &str, document: Value) -> Result<(), Box<dyn std::error::Error>> {
    let planned = PlannedStudy::from_value(&document, &|path| Err(path.to_owned()));
    let planned = planned.map_err(|faults| format!("{name}: {faults:?}"))?;
    let solver = EmbeddedSolver::default();
    let work = Workload::of(&planned, &solver);
    let pace = Pace::new(work, HashSet::new(), Machine::new(THREADS));
    let estimate = pace.estimate().clone();
    let expected_s = estimate
        .wall_s
        .ok_or("the embedded solver has a law of its times")?
        .expected;
    let tenth = estimate.solves.left.expected.div_ceil(10);
    let archive = Timed {
        archive: MemoryArchive::default(),
        pace: Mutex::new(pace),
    };
    let shown = Mutex::new((0, expected_s, None));
    let begun = Instant::now();
    let observer = |event: Event| {
        let revised = archive
            .pace
            .lock()
            .expect("whole")
            .revised(begun.elapsed().as_secs_f64());
        let (solves, shown_s, after_a_tenth) = &mut *shown.lock().expect("whole");
        if let Some(wall_s) = revised.and_then(|estimate| estimate.wall_s) {
            *shown_s = wall_s.expected;
        }
        *solves += usize::from(matches!(
            event,
            Event::PointSolved { .. } | Event::PointFailed { .. }
        ));
        if *solves >= tenth {
            after_a_tenth.get_or_insert(*shown_s);
        }
    };
    let context = RunContext {
        solver: &solver,
        archive: &archive,
        threads: THREADS,
        stop: &AtomicBool::new(false),
        pause: None,
        observer: &observer,
    };
    let outcome = climb::answer(&planned.study, &planned.plan, context);
    let took_s = begun.elapsed().as_secs_f64();
    let (solves, _, after_a_tenth) = *shown.lock().expect("whole");
    let then_s = after_a_tenth.unwrap_or(expected_s);
    let nearest = [expected_s, then_s].map(|said| (took_s / said).max(said / took_s));
    println!(
        "| {name} | {solves} | {expected_s:.2} | {then_s:.2} | {took_s:.2} | {:.1}, {:.1} | {:.0} | {:.0} |",
        nearest[0],
        nearest[1],
        estimate.peak_memory_bytes as f64 / 1e6,
        peak_memory_bytes() as f64 / 1e6
    );
    if let Err(error) = outcome {
        println!("({name} ended without a result: {error})");
    }
    Ok(())
}

/// An archive in memory that tells how long solves take.
struct Timed {
    archive: MemoryArchive,
    pace: Mutex<Pace>,
}

impl Archive for Timed {
    fn load(
        &self,
        keys: &[String],
        first: usize,
    ) -> Result<Vec<Option<(Outcome, Cost)>>, ArchiveError> {
        self.archive.load(keys, first)
    }

    fn save(&self, point: &PointRecord<'_>) -> Result<(), ArchiveError> {
        self.archive.save(point)?;
        self.pace
            .lock()
            .expect("whole")
            .solved(point.key, point.cost.wall_s);
        Ok(())
    }

    fn load_start(&self, key: &str) -> Result<Option<StartState>, ArchiveError> {
        self.archive.load_start(key)
    }
}
