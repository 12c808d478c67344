//! Are tolerances and budgets kept? Three studies, asked for errors of 0.1, 0.03 and 0.01 and for 2, 10 and 60 s, against the
//! finest mesh with the interactions of all pairs. The table of `docs/proof/claims.md`.
//!
//! `cargo run --release -p lab --example promises [-- NAME]`, half an hour on two cores.

use std::sync::atomic::AtomicBool;

use document::Format;
use documents::study::Study;
use documents::study::plan::Plan;
use fem_client::scene::{Level, Scene};
use fem_client::solver::{SolveError, SolveRequest, Solved, Solver};
use gsa::method::Kind;
use lab::all_cores::cores;
use placement::ladder::climb;
use placement::ladder::fidelity::Fidelity;
use placement::ladder::trade;
use placement::points::RunContext;
use placement::points::RunError;
use placement::points::memory::MemoryArchive;
use results::StudyResult;
use serde_json::{Value, json};
use tire::embedded::EmbeddedSolver;

const TOLERANCES: [f64; 3] = [0.1, 0.03, 0.01];
const BUDGETS_S: [f64; 3] = [2.0, 10.0, 60.0];

/// The embedded solver without a coarser mesh: what it solves is the truth of others.
struct Finest(EmbeddedSolver);

impl Solver for Finest {
    fn version(&self) -> String {
        self.0.version()
    }

    fn cells(&self, scene: &Scene) -> usize {
        self.0.cells(scene)
    }

    fn has_time_law(&self) -> bool {
        self.0.has_time_law()
    }

    fn solve(&self, request: &SolveRequest<'_>) -> Result<Solved, SolveError> {
        self.0.solve(request)
    }
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let wanted = std::env::args().nth(1);
    println!("| study | asked for | answered by | rungs | wall s | claimed | true | covered |");
    println!("| --- | --- | --- | --- | --- | --- | --- | --- |");
    for (name, document) in studies() {
        if wanted.as_ref().is_none_or(|wanted| wanted == name) {
            kept(name, &document)?;
        }
    }
    Ok(())
}

/// The shipped study, a thick tire without cords under deeper contact, and one whose pressure varies with a depth.
fn studies() -> [(&'static str, Value); 3] {
    let uniform = |min: f64, max: f64| json!({"kind": "uniform", "min": min, "max": max});
    let input = |name: &str, vary: &str, law: Value| json!({"name": name, "vary": vary, "distribution": law});
    let depth = |k: usize, min: f64, max: f64| {
        let vary = format!("ground.depths_mm[{k}]");
        input(&format!("P{}", k + 1), &vary, uniform(min, max))
    };
    let depths = |min: f64, max: f64| (0..5).map(|k| depth(k, min, max)).collect::<Vec<_>>();
    let study = |scene: Value, inputs: Vec<Value>| {
        json!({
            "name": "kept", "scene": scene, "inputs": inputs, "layouts": {"spacings_deg": []},
            "method": {"kind": "mdrm", "nodes": 5, "check_points": 5},
        })
    };
    let thick = json!({
        "preset": "foot-tire", "carcass": null, "geometry": {"wall_mm": 5.0},
        "ground": {"depths_mm": [1.5, 1.5, 1.5, 1.5, 1.5]},
    });
    let pressed = [
        input("pressure", "pressure.internal_mpa", uniform(0.15, 0.25)),
        depth(2, 0.7, 1.3),
    ];
    let shipped = json!({"preset": "foot-tire"});
    [
        ("shipped", study(shipped.clone(), depths(0.7, 1.3))),
        ("thick", study(thick, depths(1.2, 1.8))),
        ("pressure", study(shipped, pressed.to_vec())),
    ]
}

fn read(document: &Value, accuracy: Value) -> Result<Study, String> {
    let mut document = document.clone();
    document["accuracy"] = accuracy;
    let read = |path: &str| Err(format!("{path}: not needed"));
    Study::from_document(&document.to_string(), Format::Json, &read)
        .map_err(|faults| format!("{faults:?}"))
}

fn kept(name: &str, document: &Value) -> Result<(), Box<dyn std::error::Error>> {
    let truth = truth(&read(document, json!({"preset": "reference"}))?)?;
    let tolerances = TOLERANCES.map(|t| (format!("error {t}"), json!({"tolerance": t})));
    let budgets = BUDGETS_S.map(|s| (format!("{s} s"), json!({"budget_s": s})));
    for (asked, accuracy) in tolerances.into_iter().chain(budgets) {
        let study = read(document, accuracy)?;
        match answered(&study) {
            Ok(result) => println!("| {name} | {asked} | {} |", row(&result, &truth)),
            Err(error) => println!("| {name} | {asked} | {error} | | | | | |"),
        }
    }
    Ok(())
}

fn truth(study: &Study) -> Result<StudyResult, RunError> {
    let fidelity = Fidelity {
        level: Level::Reference,
        kind: Kind::Bivariate,
        nodes: 5,
    };
    let stop = AtomicBool::new(false);
    let solver = Finest(EmbeddedSolver::default());
    trade::answer(study, fidelity, &solver, cores(), &stop, &|_| ())
}

fn answered(study: &Study) -> Result<StudyResult, RunError> {
    let stop = AtomicBool::new(false);
    let context = RunContext {
        solver: &EmbeddedSolver::default(),
        archive: &MemoryArchive::default(),
        threads: cores(),
        stop: &stop,
        pause: None,
        observer: &|_| (),
    };
    climb::answer(study, &Plan::new(study)?, context)
}

/// Prints a row: what was asked for is of every index of every strain, and so are these errors.
fn row(result: &StudyResult, truth: &StudyResult) -> String {
    let rungs = result.climb.iter().flat_map(|climb| &climb.rungs);
    let last = rungs.clone().last().map_or("", |rung| &rung.label);
    let met = match result.climb.as_ref().is_some_and(|climb| climb.met) {
        true => "",
        false => ", not met",
    };
    let (mut claimed, mut off, mut covered, mut all) = (0.0f64, 0.0f64, 0, 0);
    for (own, truth) in result.outputs.iter().zip(&truth.outputs) {
        let (Some(own_indices), Some(exact)) = (&own.first_order, &truth.first_order) else {
            continue;
        };
        let pairs = own_indices.iter().zip(exact);
        let error = pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        let claim = own.error.total.unwrap_or(f64::NAN);
        (claimed, off) = (claimed.max(claim), off.max(error));
        covered += usize::from(error <= claim);
        all += 1;
    }
    format!(
        "{last}{met} | {} | {:.1} | {claimed:.4} | {off:.4} | {covered} of {all}",
        rungs.count(),
        result.cost.wall_s
    )
}
