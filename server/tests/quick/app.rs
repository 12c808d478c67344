//! Starts services and waits for studies.

use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::Arc;
use std::time::{Duration, Instant};

use document::{Format, parse};
use fem_client::closed_form::ClosedFormSolver;
use fem_client::solver::{SolveError, SolveRequest, Solved, Solver};
use reqwest::redirect::Policy;
use reqwest::{Client, Response, StatusCode};
use serde_json::{Value, json};
use server::running::{Limits, Outside, Service, ServiceParts, StartError};
use service::forces::fit_process;
use service::work::analysis_process;
use sqlx::sqlite::SqliteConnectOptions;
use sqlx::{Connection, SqliteConnection};
use tasks::away::Means;
use tempfile::TempDir;

/// Time far beyond what any of these studies takes, so that only a study that hangs meets it.
pub const PATIENCE: Duration = Duration::from_secs(60);

/// Turn that is so short as to come often.
const TURN: Duration = Duration::from_millis(300);

/// A service with a client.
pub struct App {
    pub service: Service,
    pub client: Client,
}

/// A folder with a database that several services may use one after the other.
pub struct Home {
    folder: TempDir,
}

impl Home {
    pub fn new() -> Self {
        Self {
            folder: tempfile::tempdir().expect("temp dir"),
        }
    }

    pub fn database(&self) -> PathBuf {
        self.folder.path().join("test.db")
    }

    pub async fn try_start(&self, solver: ClosedFormSolver) -> Result<App, StartError> {
        serve(self.database(), Arc::new(solver)).await
    }

    /// A service that answers these alone.
    pub async fn start_for(&self, outside: Outside) -> App {
        let mut parts = parts(self.database(), Arc::new(ClosedFormSolver::new()));
        parts.outside = outside;
        started(parts).await.expect("the service starts")
    }

    pub async fn start_with(&self, solver: ClosedFormSolver, limits: Limits) -> App {
        let mut parts = parts(self.database(), Arc::new(solver));
        parts.outside.limits = limits;
        started(parts).await.expect("the service starts")
    }

    pub async fn start_on(&self, solver: Arc<dyn Solver>) -> App {
        let app = serve(self.database(), solver).await;
        app.expect("the service starts")
    }

    /// A service whose work never gives way: how much it finds solved doesn't depend on how busy the machine is.
    pub async fn start_without_turns(&self, solver: Arc<dyn Solver>) -> App {
        let mut parts = parts(self.database(), solver);
        parts.turn = Duration::from_secs(3600);
        started(parts).await.expect("the service starts")
    }

    /// A service that gives a preview so long, and a single scene.
    pub async fn start_with_limit(&self, limit: Duration, solver: Arc<dyn Solver>) -> App {
        let mut parts = parts(self.database(), solver);
        (parts.preview_limit, parts.scene_limit) = (limit, limit);
        started(parts).await.expect("the service starts")
    }

    pub async fn start(&self, solver: ClosedFormSolver) -> App {
        self.try_start(solver).await.expect("the service starts")
    }

    /// A connection of the test's own, beside the service's.
    pub async fn sql(&self) -> SqliteConnection {
        open(&self.database()).await
    }
}

/// A service on a database, on two threads.
pub async fn serve(database: PathBuf, solver: Arc<dyn Solver>) -> Result<App, StartError> {
    started(parts(database, solver)).await
}

fn parts(database: PathBuf, solver: Arc<dyn Solver>) -> ServiceParts {
    ServiceParts {
        means: Means::default(),
        address: "127.0.0.1:0".parse().expect("address"),
        database,
        previewer: solver.clone(),
        preview_limit: PATIENCE,
        scene_limit: PATIENCE,
        solver,
        learner: Box::new(|| program(fit_process::ARGUMENT)),
        analyst: Box::new(|| program(analysis_process::ARGUMENT)),
        threads: 2,
        turn: TURN,
        outside: Outside::default(),
    }
}

async fn started(parts: ServiceParts) -> Result<App, StartError> {
    Ok(App {
        service: Service::start(parts).await?,
        client: client(),
    })
}

/// The program, which works for its parent.
pub fn program(argument: &str) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_strainsite"));
    command.arg(argument);
    command
}

/// A client that shows redirections instead of following them.
fn client() -> Client {
    let client = Client::builder().redirect(Policy::none()).build();
    client.expect("a client")
}

async fn open(path: &Path) -> SqliteConnection {
    let options = SqliteConnectOptions::new().filename(path);
    SqliteConnection::connect_with(&options)
        .await
        .expect("the database opens")
}

impl App {
    pub fn url(&self, path: &str) -> String {
        format!("http://{}{path}", self.service.address())
    }

    pub async fn get(&self, path: &str) -> Response {
        self.client
            .get(self.url(path))
            .send()
            .await
            .expect("an answer")
    }

    /// The JSON document at an address that must answer 200.
    pub async fn json(&self, path: &str) -> Value {
        let response = self.get(path).await;
        assert_eq!(response.status(), StatusCode::OK, "{path}");
        response.json().await.expect("JSON")
    }

    pub async fn post(&self, document: &Value) -> Response {
        self.client
            .post(self.url("/v1/studies"))
            .json(document)
            .send()
            .await
            .expect("an answer")
    }

    /// Submits a study that must be accepted and returns its identifier.
    pub async fn submit(&self, document: &Value) -> String {
        let response = self.post(document).await;
        let (status, body) = (
            response.status(),
            response.json::<Value>().await.expect("JSON"),
        );
        assert_eq!(status, StatusCode::ACCEPTED, "{body}");
        body["id"].as_str().expect("an id").to_owned()
    }

    pub async fn delete(&self, path: &str) -> Response {
        self.client
            .delete(self.url(path))
            .send()
            .await
            .expect("an answer")
    }

    /// Waits until the study satisfies the condition, and returns it.
    pub async fn wait(&self, id: &str, until: impl Fn(&Value) -> bool) -> Value {
        let begun = Instant::now();
        loop {
            let study = self.json(&format!("/v1/studies/{id}")).await;
            if until(&study) {
                return study;
            }
            assert!(begun.elapsed() < PATIENCE, "still waiting: {study}");
            tokio::time::sleep(Duration::from_millis(5)).await;
        }
    }

    /// Waits until the study is in this state.
    pub async fn wait_for(&self, id: &str, state: &str) -> Value {
        self.wait(id, |study| study["state"] == state).await
    }
}

/// The problem document of an answer, checked for what every one of them has.
pub async fn problem(response: Response, status: StatusCode) -> Value {
    assert_eq!(response.status(), status);
    assert_eq!(
        response.headers()["content-type"],
        "application/problem+json"
    );
    let id = response.headers()["x-request-id"]
        .to_str()
        .expect("text")
        .to_owned();
    let body: Value = response.json().await.expect("JSON");
    assert_eq!(body["status"], status.as_u16());
    assert_eq!(body["request_id"], id);
    assert!(
        body["title"].is_string() && body["type"].is_string() && body["detail"].is_string(),
        "{body}"
    );
    body
}

/// The shipped study without its map and layouts, so that it is small.
pub fn study() -> Value {
    let (_, text) = documents::study::presets()[0];
    let mut document = parse(text, Format::Toml).expect("shipped studies are well-formed");
    document["candidates"] = json!({"points": "P1-P5"});
    document["layouts"] = json!({"spacings_deg": []});
    document
}

/// Returns the study with two layouts.
pub fn study_of_layouts() -> Value {
    let mut document = study();
    document["layouts"] = json!({"spacings_deg": [60, 90], "positions": ["crown"]});
    document
}

/// A solver that gives a test time to look: 26 solves on two threads take about a second and a half.
pub fn slow() -> ClosedFormSolver {
    ClosedFormSolver::new().with_delay(Duration::from_millis(100))
}

/// A solver whose studies don't end, so that a test finds the line as it left it. The test stops the service.
pub fn endless() -> ClosedFormSolver {
    ClosedFormSolver::new().with_delay(Duration::from_hours(1))
}

/// The closed form on a ground that presses by force: a tenth of a millimetre for each newton.
pub struct ByForce;

impl Solver for ByForce {
    fn version(&self) -> String {
        "closed form by force".to_owned()
    }

    fn solve(&self, request: &SolveRequest<'_>) -> Result<Solved, SolveError> {
        let mut scene = request.scene.clone();
        if let Some(load) = scene.ground.load_n {
            scene.ground = scene.ground.at_depths(vec![0.1 * load; 5]);
        }
        ClosedFormSolver::new().solve(&SolveRequest {
            scene: &scene,
            ..*request
        })
    }
}
