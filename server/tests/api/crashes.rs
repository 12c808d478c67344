//! A point that brings the program down costs itself alone, after three times.

use std::path::PathBuf;
use std::process::Command;
use std::sync::Arc;

use fem_client::closed_form::ClosedFormSolver;
use fem_client::solver::{SolveError, SolveRequest, Solved, Solver};
use serde_json::Value;

use crate::support::{App, Home, serve, study};

/// Names the database to the child.
const DATABASE: &str = "STRAINSITE_CRASHING_TEST_DATABASE";
/// Starts that the study may take: three that die, one that ends, and some to show that it isn't more.
const MOST_STARTS: usize = 8;

/// Ends the process at the deepest node of the middle station.
struct Deadly(ClosedFormSolver);

impl Solver for Deadly {
    fn version(&self) -> String {
        self.0.version()
    }

    fn solve(&self, request: &SolveRequest<'_>) -> Result<Solved, SolveError> {
        let depths = &request.scene.ground.depths_mm;
        if depths[2] > 1.25 && [0, 1, 3, 4].iter().all(|k| depths[*k] == 1.0) {
            std::process::abort();
        }
        self.0.solve(request)
    }
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
    let solver = Arc::new(Deadly(ClosedFormSolver::new()));
    let app = serve(PathBuf::from(database), solver).await;
    let app = app.expect("starts after every crash");
    let id = match first_study(&app).await {
        Some(id) => id,
        None => app.submit(&study()).await,
    };
    app.wait_for(&id, "done").await;
    app.service.stop().await;
}

#[tokio::test(flavor = "multi_thread")]
async fn a_point_that_kills_the_program_is_left_alone_after_three_times() {
    let home = Home::new();
    let survives = || {
        let program = std::env::current_exe().expect("a path");
        let child = Command::new(program)
            .args(["--exact", "crashes::service_that_dies", "--ignored"])
            .env(DATABASE, home.database())
            .output();
        child.expect("starts").status.success()
    };
    let deaths = (0..MOST_STARTS).take_while(|_| !survives()).count();
    assert_eq!(deaths, 3);

    let app = home.start(ClosedFormSolver::new()).await;
    let id = first_study(&app).await.expect("the study");
    let result = app.json(&format!("/v1/studies/{id}/result")).await;
    let failed = result["failed_points"].as_array().expect("a list");
    assert_eq!(failed.len(), 1, "{failed:?}");
    let cause = failed[0]["cause"].as_str().expect("a sentence");
    assert!(
        cause.starts_with("quarantined: the program died 3 times"),
        "{cause}"
    );
    assert!(
        failed[0]["values"][2]
            .as_f64()
            .is_some_and(|depth| depth > 1.25)
    );
    let note = result["notes"][0].as_str().expect("a sentence");
    assert!(note.contains("quarantined"), "{note}");
    // The one that was being solved beside it at the first crash was tried again by itself, and is there.
    let points = app.json(&format!("/v1/studies/{id}/evaluations")).await;
    assert_eq!(points["evaluations"].as_array().map(Vec::len), Some(25));
    let outputs = result["outputs"].as_array().expect("a list");
    assert!(
        outputs
            .iter()
            .all(|output| output["first_order"] != Value::Null)
    );
}
