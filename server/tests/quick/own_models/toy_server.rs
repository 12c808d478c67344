//! Ishigami's function as a model of UM-Bridge, and whatever else a server may answer.

use std::collections::BTreeMap;
use std::sync::{Arc, Mutex};
use std::time::Duration;

use axum::Router;
use axum::extract::{Path, State};
use axum::http::StatusCode;
use axum::routing::{get, post};
use serde_json::{Value, json};
use tokio::runtime::Runtime;

use super::ishigami;

/// Status and body of an answer, and the time that it takes.
pub(super) type Answer = (u16, String, Duration);
/// Answers to a point, which was asked for so many times before.
type Answering = Box<dyn Fn(&[f64], usize) -> Answer + Send>;

/// A server on a port of its own, which ends with this value.
pub(super) struct Toy {
    pub(super) url: String,
    shared: Arc<Shared>,
    runtime: Option<Runtime>,
}

struct Shared {
    models: Vec<&'static str>,
    inputs: Vec<usize>,
    outputs: Mutex<Vec<usize>>,
    answering: Mutex<Answering>,
    /// Times that each point was asked for, by its bits.
    asked: Mutex<BTreeMap<Vec<u64>, usize>>,
}

/// Answer with these output vectors, at once.
pub(super) fn output(vectors: &Value) -> Answer {
    let body = json!({"output": vectors}).to_string();
    (200, body, Duration::ZERO)
}

/// Answer of this status and text, at once.
pub(super) fn reply(status: u16, body: &str) -> Answer {
    (status, body.to_owned(), Duration::ZERO)
}

/// Ishigami's function, and a sum.
pub(super) fn both(x: &[f64]) -> Answer {
    output(&json!([[ishigami(x)], [3.0 + x[0]]]))
}

impl Toy {
    /// Serves [`both`] as a model of three inputs in two vectors.
    pub(super) fn start() -> Self {
        Self::with(vec!["toy"], vec![1, 2], vec![1, 1])
    }

    pub(super) fn with(models: Vec<&'static str>, inputs: Vec<usize>, outputs: Vec<usize>) -> Self {
        let shared = Arc::new(Shared {
            models,
            inputs,
            outputs: Mutex::new(outputs),
            answering: Mutex::new(Box::new(|x, _| both(x))),
            asked: Mutex::default(),
        });
        let app = Router::new()
            .route("/Info", get(info))
            .route("/{operation}", post(operation))
            .with_state(shared.clone());
        let runtime = Runtime::new().expect("a runtime");
        let listener = tokio::net::TcpListener::bind(("127.0.0.1", 0));
        let listener = runtime.block_on(listener).expect("a free port");
        let address = listener.local_addr().expect("an address");
        runtime.spawn(async move { axum::serve(listener, app).await });
        Self {
            url: format!("http://{address}"),
            shared,
            runtime: Some(runtime),
        }
    }

    /// Answers otherwise from now on.
    pub(super) fn answer(&self, answering: impl Fn(&[f64], usize) -> Answer + Send + 'static) {
        *self.shared.answering.lock().expect("whole") = Box::new(answering);
    }

    /// Has outputs of these sizes from now on.
    pub(super) fn resize(&self, outputs: Vec<usize>) {
        *self.shared.outputs.lock().expect("whole") = outputs;
    }

    /// Times that each point was asked for; they are forgotten.
    pub(super) fn asked(&self) -> Vec<usize> {
        let mut asked = self.shared.asked.lock().expect("whole");
        std::mem::take(&mut *asked).into_values().collect()
    }

    /// Points that were asked for so far.
    pub(super) fn count(&self) -> usize {
        self.shared.asked.lock().expect("whole").len()
    }
}

impl Drop for Toy {
    fn drop(&mut self) {
        if let Some(runtime) = self.runtime.take() {
            runtime.shutdown_background();
        }
    }
}

async fn info(State(shared): State<Arc<Shared>>) -> String {
    json!({"protocolVersion": 1.0, "models": shared.models}).to_string()
}

async fn operation(
    State(shared): State<Arc<Shared>>,
    Path(operation): Path<String>,
    body: String,
) -> (StatusCode, String) {
    let asked: Value = serde_json::from_str(&body).expect("JSON");
    let name = asked["name"].as_str().expect("a name");
    assert!(
        shared.models.contains(&name) && asked["config"].is_object(),
        "{asked}"
    );
    let answer = match operation.as_str() {
        "ModelInfo" => json!({"support": {"Evaluate": true}}),
        "InputSizes" => json!({"inputSizes": shared.inputs}),
        "OutputSizes" => json!({"outputSizes": *shared.outputs.lock().expect("whole")}),
        "Evaluate" => return evaluate(&shared, &asked).await,
        other => panic!("nobody asks for {other}"),
    };
    (StatusCode::OK, answer.to_string())
}

async fn evaluate(shared: &Shared, asked: &Value) -> (StatusCode, String) {
    let vectors = asked["input"].as_array().expect("vectors");
    let vectors: Vec<Vec<f64>> = vectors
        .iter()
        .map(|vector| serde_json::from_value(vector.clone()).expect("numbers"))
        .collect();
    let sizes: Vec<usize> = vectors.iter().map(Vec::len).collect();
    assert_eq!(sizes, shared.inputs);
    let x = vectors.concat();
    let bits = x.iter().map(|value| value.to_bits()).collect();
    let before = {
        let mut asked = shared.asked.lock().expect("whole");
        let count = asked.entry(bits).or_default();
        *count += 1;
        *count - 1
    };
    let (status, body, time) = shared.answering.lock().expect("whole")(&x, before);
    tokio::time::sleep(time).await;
    (StatusCode::from_u16(status).expect("a status"), body)
}
