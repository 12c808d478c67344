//! Requests and refusals of UM-Bridge's protocol 1.0, JSON over HTTP.

// What others send is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

use std::sync::Arc;
use std::time::Duration;

use axum::Router;
use axum::extract::{FromRequest, Request, State};
use axum::http::StatusCode;
use axum::response::{IntoResponse, Json, Response};
use axum::routing::{get, post};
use fem_client::scene::Level;
use serde_json::{Map, Value, json};
use tokio::sync::Semaphore;

use crate::http::edge::document_body::{self, BodyLimits};
use crate::http::edge::problem_document::Problem;
use crate::umbridge::forward_model::{Answer, ForwardModel, NoAnswer, OUTPUTS};

/// Name of the model.
const MODEL: &str = "forward";
/// Limits on a request.
const REQUEST: BodyLimits = BodyLimits {
    what: "a request has",
    bytes: 1 << 20,
    discarded: 16 << 20,
    time: Duration::from_secs(30),
};

/// Text of a request.
struct Sent(String);

impl<S: Send + Sync> FromRequest<S> for Sent {
    type Rejection = Problem;

    async fn from_request(request: Request, _: &S) -> Result<Self, Problem> {
        document_body::read(request, REQUEST, |_| Ok(()))
            .await
            .map(Self)
    }
}

/// Model and slots that all requests share.
#[derive(Clone)]
struct Shared {
    model: Arc<ForwardModel>,
    /// Solves that run at once.
    slots: Arc<Semaphore>,
}

/// Refusal, by the protocol: a type and a message.
struct Refusal {
    status: StatusCode,
    kind: &'static str,
    message: String,
}

impl IntoResponse for Refusal {
    fn into_response(self) -> Response {
        let body = json!({"error": {"type": self.kind, "message": self.message}});
        (self.status, Json(body)).into_response()
    }
}

fn invalid(message: impl Into<String>) -> Refusal {
    Refusal {
        status: StatusCode::BAD_REQUEST,
        kind: "InvalidInput",
        message: message.into(),
    }
}

fn unsupported(message: impl Into<String>) -> Refusal {
    Refusal {
        kind: "UnsupportedFeature",
        ..invalid(message)
    }
}

/// Routes of a model that solves so many points at once.
pub(crate) fn routes(model: Arc<ForwardModel>, threads: usize) -> Router {
    let shared = Shared {
        model,
        slots: Arc::new(Semaphore::new(threads)),
    };
    Router::new()
        .route("/Info", get(info))
        .route("/ModelInfo", post(model_info))
        .route("/InputSizes", post(input_sizes))
        .route("/OutputSizes", post(output_sizes))
        .route("/Evaluate", post(evaluate))
        .route("/Gradient", post(gradient))
        .route("/ApplyJacobian", post(apply_jacobian))
        .route("/ApplyHessian", post(apply_hessian))
        .with_state(shared)
}

async fn info() -> Json<Value> {
    Json(json!({"protocolVersion": 1.0, "models": [MODEL]}))
}

async fn model_info(
    State(shared): State<Shared>,
    Sent(body): Sent,
) -> Result<Json<Value>, Refusal> {
    read(&body)?;
    let has_derivatives = shared.model.has_derivatives();
    Ok(Json(json!({"support": {
        "Evaluate": true, "Gradient": has_derivatives, "ApplyJacobian": has_derivatives, "ApplyHessian": false,
    }})))
}

async fn input_sizes(
    State(shared): State<Shared>,
    Sent(body): Sent,
) -> Result<Json<Value>, Refusal> {
    let asked = read(&body)?;
    level(&asked, &shared.model)?;
    Ok(Json(json!({"inputSizes": [shared.model.inputs()]})))
}

async fn output_sizes(
    State(shared): State<Shared>,
    Sent(body): Sent,
) -> Result<Json<Value>, Refusal> {
    let asked = read(&body)?;
    level(&asked, &shared.model)?;
    Ok(Json(json!({"outputSizes": shared.model.sizes()})))
}

async fn evaluate(State(shared): State<Shared>, Sent(body): Sent) -> Result<Json<Value>, Refusal> {
    let asked = read(&body)?;
    let answer = answer(&shared, &asked, false).await?;
    Ok(Json(json!({"output": answer.values})))
}

/// Sensitivity of an output, weighted, to each input.
async fn gradient(State(shared): State<Shared>, Sent(body): Sent) -> Result<Json<Value>, Refusal> {
    let asked = read(&body)?;
    let (output, size) = wanted(&asked, &shared.model)?;
    let weights = numbers(&asked, "sens", size)?;
    let answer = answer(&shared, &asked, true).await?;
    let by_input = answer
        .derivatives
        .iter()
        .map(|of| of.get(output).map_or(0.0, |of| dot(of, &weights)));
    Ok(Json(json!({"output": by_input.collect::<Vec<f64>>()})))
}

/// Change of an output with a change of the inputs.
async fn apply_jacobian(
    State(shared): State<Shared>,
    Sent(body): Sent,
) -> Result<Json<Value>, Refusal> {
    let asked = read(&body)?;
    let (output, size) = wanted(&asked, &shared.model)?;
    let change = numbers(&asked, "vec", shared.model.inputs())?;
    let answer = answer(&shared, &asked, true).await?;
    let mut sums = vec![0.0; size];
    for (of, change) in answer.derivatives.iter().zip(&change) {
        for (sum, derivative) in sums.iter_mut().zip(of.get(output).into_iter().flatten()) {
            *sum += change * derivative;
        }
    }
    Ok(Json(json!({"output": sums})))
}

async fn apply_hessian() -> Refusal {
    unsupported("there are no second derivatives")
}

/// A request about this model.
fn read(body: &str) -> Result<Map<String, Value>, Refusal> {
    let asked: Map<String, Value> = serde_json::from_str(body)
        .map_err(|error| invalid(format!("the request isn't a JSON object: {error}")))?;
    match asked.get("name").and_then(Value::as_str) {
        Some(MODEL) => Ok(asked),
        name => Err(Refusal {
            kind: "ModelNotFound",
            ..invalid(format!(
                "there is no model {:?}, but {MODEL:?} alone",
                name.unwrap_or_default()
            ))
        }),
    }
}

/// Mesh level that a request asks for.
fn level(asked: &Map<String, Value>, model: &ForwardModel) -> Result<Level, Refusal> {
    let config = match asked.get("config") {
        None | Some(Value::Null) => return Ok(model.level()),
        Some(Value::Object(config)) => config,
        Some(_) => return Err(invalid("config is an object")),
    };
    if let Some(other) = config.keys().find(|key| *key != "level") {
        return Err(invalid(format!("config has no {other:?}, but level alone")));
    }
    let Some(named) = config.get("level") else {
        return Ok(model.level());
    };
    let level = named.as_str().and_then(Level::named);
    level.ok_or_else(|| {
        let names: Vec<&str> = Level::ALL.iter().map(|level| level.as_str()).collect();
        invalid(format!("config.level is one of {}", names.join(", ")))
    })
}

/// Numbers under a name, so many of them.
fn numbers(asked: &Map<String, Value>, name: &str, count: usize) -> Result<Vec<f64>, Refusal> {
    let list = asked.get(name).and_then(Value::as_array);
    let list: Option<Vec<f64>> = list.and_then(|list| list.iter().map(Value::as_f64).collect());
    list.filter(|list| list.len() == count)
        .ok_or_else(|| invalid(format!("{name} is a list of {count} numbers")))
}

/// Output that a derivative is asked of, and its size; it is by the one input vector.
fn wanted(asked: &Map<String, Value>, model: &ForwardModel) -> Result<(usize, usize), Refusal> {
    if !model.has_derivatives() {
        return Err(unsupported(
            "this study has no derivatives: with friction the equilibrium depends on the way there",
        ));
    }
    if asked.get("inWrt").and_then(Value::as_u64) != Some(0) {
        return Err(invalid("inWrt is 0: there is one input"));
    }
    let output = asked.get("outWrt").and_then(Value::as_u64);
    let output = output.and_then(|output| usize::try_from(output).ok());
    let sized = output.and_then(|output| Some((output, *model.sizes().get(output)?)));
    sized.ok_or_else(|| invalid(format!("outWrt is 0, 1 or 2: {}", OUTPUTS.join(", "))))
}

/// The answer at the point that a request is about, once there is a slot for its solve.
async fn answer(
    shared: &Shared,
    asked: &Map<String, Value>,
    with_derivatives: bool,
) -> Result<Arc<Answer>, Refusal> {
    let model = shared.model.clone();
    let level = level(asked, &model)?;
    let count = model.inputs();
    let one = asked
        .get("input")
        .and_then(Value::as_array)
        .filter(|list| list.len() == 1);
    let values: Option<Vec<f64>> = one
        .and_then(|list| list.first()?.as_array())
        .and_then(|list| list.iter().map(Value::as_f64).collect());
    let values = values
        .filter(|values| values.len() == count)
        .ok_or_else(|| {
            invalid(format!(
                "input is one list of {count} numbers: {}",
                model.names()
            ))
        })?;
    let broken = |message: String| Refusal {
        status: StatusCode::INTERNAL_SERVER_ERROR,
        kind: "InternalError",
        message,
    };
    let slot = shared.slots.clone().acquire_owned().await;
    let slot = slot.map_err(|error| broken(error.to_string()))?;
    let solving = tokio::task::spawn_blocking(move || {
        let _slot = slot;
        model.answer(&values, level, with_derivatives)
    });
    let solved = solving
        .await
        .map_err(|_| broken("the solver panicked; its message is on standard error".to_owned()))?;
    solved.map_err(|none| match none {
        NoAnswer::Refused(faults) => invalid(faults),
        NoAnswer::NoEquilibrium(reason) => Refusal {
            kind: "NoEquilibrium",
            ..invalid(reason)
        },
        NoAnswer::Broken(cause) => broken(cause),
    })
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}
