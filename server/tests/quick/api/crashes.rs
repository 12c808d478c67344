//! A point that panics, never ends or brings the program down costs itself alone; the last after it has crashed three processes of its own.

use std::path::PathBuf;
use std::process::Command;
use std::sync::Arc;
use std::time::Duration;

use fem_client::closed_form::ClosedFormSolver;
use fem_client::solver::{SolveError, SolveRequest, Solved, Solver};
use serde_json::Value;
use service::solving::isolated::parent::Isolated;
use service::solving::watched::Watched;
use store::file::upkeep;

use crate::app::{App, Home, serve, study};

/// Names the database to the child.
const DATABASE: &str = "STRAINSITE_CRASHING_TEST_DATABASE";
/// Starts that the study may take: one that dies, one that ends, and some to show that it isn't more.
const MOST_STARTS: usize = 8;

/// Does something at the deepest node of the middle station instead of solving.
struct Trapped {
    solver: ClosedFormSolver,
    trap: fn(),
    /// Process in which that point is solved alone.
    isolated: Isolated,
}

impl Trapped {
    fn new(trap: fn()) -> Self {
        let solver = ClosedFormSolver::new();
        let aborting = || {
            let mut shell = Command::new("sh");
            shell.args(["-c", "echo lost >&2; kill -ABRT $$"]);
            shell
        };
        let isolated = Isolated::new(Arc::new(solver.clone()), aborting);
        Self {
            solver,
            trap,
            isolated,
        }
    }

    fn is_trap(request: &SolveRequest<'_>) -> bool {
        let depths = &request.scene.ground.depths_mm;
        depths[2] > 1.25 && [0, 1, 3, 4].iter().all(|k| depths[*k] == 1.0)
    }
}

impl Solver for Trapped {
    fn version(&self) -> String {
        self.solver.version()
    }

    fn solve(&self, request: &SolveRequest<'_>) -> Result<Solved, SolveError> {
        if Self::is_trap(request) {
            (self.trap)();
        }
        self.solver.solve(request)
    }

    fn solve_isolated(&self, request: &SolveRequest<'_>) -> Result<Solved, SolveError> {
        match Self::is_trap(request) {
            true => self.isolated.solve_isolated(request),
            false => self.solver.solve(request),
        }
    }
}

/// The one point of a done study's result that failed, and its cause; all strains have indices from the others.
async fn failed_point(app: &App, id: &str) -> String {
    let result = app.json(&format!("/v1/studies/{id}/result")).await;
    let failed = result["failed_points"].as_array().expect("a list");
    assert_eq!(failed.len(), 1, "{failed:?}");
    let depth = failed[0]["values"][2].as_f64();
    assert!(depth.is_some_and(|depth| depth > 1.25), "{failed:?}");
    let outputs = result["outputs"].as_array().expect("a list");
    let indexed = |output: &Value| output["first_order"] != Value::Null;
    assert!(outputs.iter().all(indexed));
    let note = result["notes"][0].as_str().expect("a sentence");
    let cause = failed[0]["cause"].as_str().expect("a sentence");
    let status = cause.split(':').next().expect("a word");
    assert!(note.contains(status), "{note}");
    cause.to_owned()
}

/// A point that left nothing isn't taken for one that was lost.
async fn assert_whole(home: &Home) {
    let found = upkeep::inspect(&home.database(), &|_, _| {}).await;
    assert_eq!(found.expect("reads").faults, Vec::<String>::new());
}

async fn first_study(app: &App) -> Option<String> {
    let list = app.json("/v1/studies").await;
    list["studies"][0]["id"].as_str().map(str::to_owned)
}

/// Submits the study at its first start, and waits for its end at every one.
#[tokio::test(flavor = "multi_thread")]
#[ignore = "the child of the test below"]
async fn service_that_dies() {
    let Ok(database) = std::env::var(DATABASE) else {
        return;
    };
    let solver = Arc::new(Trapped::new(|| std::process::abort()));
    let app = serve(PathBuf::from(database), solver).await;
    let app = app.expect("starts after every crash");
    let id = match first_study(&app).await {
        Some(id) => id,
        None => app.submit(&study()).await,
    };
    app.wait_for(&id, "done").await;
    app.service.stop().await.expect("stops");
}

#[tokio::test(flavor = "multi_thread")]
async fn a_point_that_kills_the_program_once_is_left_alone_after_three_crashes_of_its_own() {
    let home = Home::new();
    let survives = || {
        let program = std::env::current_exe().expect("a path");
        let child = Command::new(program)
            .args(["--exact", "api::crashes::service_that_dies", "--ignored"])
            .env(DATABASE, home.database())
            .output();
        child.expect("starts").status.success()
    };
    let deaths = (0..MOST_STARTS).take_while(|_| !survives()).count();
    assert_eq!(deaths, 1);

    let app = home.start(ClosedFormSolver::new()).await;
    let id = first_study(&app).await.expect("the study");
    assert_whole(&home).await;
    let cause = failed_point(&app, &id).await;
    assert!(
        cause.starts_with("quarantined: solved alone")
            && cause.contains("ended that 3 times, at last by SIGABRT: lost"),
        "{cause}"
    );
    // The one that was being solved beside it was tried again by itself, and is there.
    let points = app.json(&format!("/v1/studies/{id}/evaluations")).await;
    assert_eq!(points["evaluations"].as_array().map(Vec::len), Some(25));
}

#[tokio::test(flavor = "multi_thread")]
async fn a_panic_or_an_endless_loop_costs_its_point_alone() {
    let endless = || loop {
        std::thread::park_timeout(Duration::from_secs(3600));
    };
    // A panic prints where it came from, which takes longer than half a second on a busy machine.
    let traps: [(fn(), Duration, &str); 2] = [
        (
            || panic!("lost"),
            Duration::from_secs(60),
            "solver-failed: panic: lost",
        ),
        (
            endless,
            Duration::from_millis(500),
            "solver-failed: no answer within the 0.5 s",
        ),
    ];
    for (trap, limit, expected) in traps {
        let grace = Duration::from_millis(100);
        let solver = Watched::new(Arc::new(Trapped::new(trap)), limit, grace);
        let home = Home::new();
        let app = serve(home.database(), Arc::new(solver)).await;
        let app = app.expect("starts");
        let id = app.submit(&study()).await;
        app.wait_for(&id, "done").await;
        let cause = failed_point(&app, &id).await;
        assert!(cause.starts_with(expected), "{cause}");
        assert_whole(&home).await;
        // It isn't stored as if it were known, and a sound solver is asked for it alone.
        let points = app.json(&format!("/v1/studies/{id}/evaluations")).await;
        assert_eq!(points["evaluations"].as_array().map(Vec::len), Some(25));
        app.service.stop().await.expect("stops");
        let app = home.start(ClosedFormSolver::new()).await;
        let again = app.submit(&study()).await;
        app.wait_for(&again, "done").await;
        let result = app.json(&format!("/v1/studies/{again}/result")).await;
        assert_eq!(result["cost"]["reused"], 25);
        assert_eq!(result["failed_points"].as_array().map(Vec::len), Some(0));
    }
}
