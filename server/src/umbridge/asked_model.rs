//! A model that another program serves by UM-Bridge's protocol: numbers to numbers.

// What others send is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

use document::visible::visible;
use serde_json::{Map, Value, json};
use store::points::model_runs::Outcome;

use crate::umbridge::http_exchange::{Away, Exchange, Reply};

/// Most bytes of an answer that isn't an evaluation's.
const MOST_BYTES: usize = 1 << 20;
/// Bytes of a number that has all of its digits, and white space.
const BYTES_OF_A_NUMBER: usize = 64;
/// Most numbers of all outputs together.
const MOST_OUTPUTS: usize = 10_000;
/// Times that a run which fails is asked for.
const TRIES: usize = 2;

/// Model, as it introduced itself.
pub(crate) struct AskedModel {
    exchange: Exchange,
    name: String,
    config: Value,
    input_sizes: Vec<usize>,
    output_sizes: Vec<usize>,
}

/// Reason why there is no model to ask.
#[derive(Debug)]
pub(crate) enum NoModel {
    /// The server is away.
    Away(Away),
    /// The server has no such model, or it doesn't fit, a sentence.
    Unfit(String),
}

impl From<Away> for NoModel {
    fn from(away: Away) -> Self {
        Self::Away(away)
    }
}

impl AskedModel {
    /// Meets the model of a name, or else the only one that the server has, and sees that it takes so many inputs.
    ///
    /// # Errors
    /// See [`NoModel`].
    pub(crate) async fn meet(
        exchange: Exchange,
        name: Option<&str>,
        config: Map<String, Value>,
        inputs: usize,
    ) -> Result<Self, NoModel> {
        // The same settings in another order are the same.
        let mut config = Value::Object(config);
        config.sort_all_objects();
        let info = told(exchange.ask("Info", None, MOST_BYTES).await?)?;
        let mut model = Self {
            name: chosen(&info, name)?,
            exchange,
            config,
            input_sizes: Vec::new(),
            output_sizes: Vec::new(),
        };
        let info = model.asked("ModelInfo").await?;
        if info
            .get("support")
            .and_then(|support| support.get("Evaluate"))
            == Some(&Value::Bool(false))
        {
            return Err(NoModel::Unfit(format!(
                "model {:?} can't be evaluated",
                model.name
            )));
        }
        model.input_sizes = sizes(&model.asked("InputSizes").await?, "inputSizes")?;
        model.output_sizes = sizes(&model.asked("OutputSizes").await?, "outputSizes")?;
        let takes: usize = model.input_sizes.iter().sum();
        if takes != inputs {
            return Err(NoModel::Unfit(format!(
                "model {:?} takes {takes} numbers (inputSizes {:?}), and the document has {inputs} inputs",
                model.name, model.input_sizes
            )));
        }
        match model.outputs() {
            1..=MOST_OUTPUTS => Ok(model),
            outputs => Err(NoModel::Unfit(format!(
                "model {:?} answers with {outputs} numbers; 1 to {MOST_OUTPUTS} can be analysed",
                model.name
            ))),
        }
    }

    async fn asked(&self, operation: &str) -> Result<Map<String, Value>, NoModel> {
        let body = json!({"name": self.name, "config": self.config}).to_string();
        told(self.exchange.ask(operation, Some(body), MOST_BYTES).await?)
    }

    /// Model as the database knows it.
    pub(crate) fn stored(&self) -> store::points::model_runs::Model {
        store::points::model_runs::Model {
            url: self.exchange.url().to_owned(),
            name: self.name.clone(),
            config: self.config.to_string(),
        }
    }

    /// Sizes of the output vectors.
    pub(crate) fn output_sizes(&self) -> &[usize] {
        &self.output_sizes
    }

    fn outputs(&self) -> usize {
        self.output_sizes.iter().sum()
    }

    /// Runs the model at these values of its inputs; once more where it fails.
    ///
    /// # Errors
    /// When the server is away.
    pub(crate) async fn run(&self, inputs: &[f64]) -> Result<Outcome, Away> {
        let mut rest = inputs.iter();
        let vectors = self
            .input_sizes
            .iter()
            .map(|size| rest.by_ref().take(*size).collect());
        let vectors: Vec<Vec<&f64>> = vectors.collect();
        let body = json!({"name": self.name, "input": vectors, "config": self.config}).to_string();
        let most_bytes = MOST_BYTES + BYTES_OF_A_NUMBER * self.outputs();
        let mut outcome = Err(String::new());
        for _ in 0..TRIES {
            outcome = match self
                .exchange
                .ask("Evaluate", Some(body.clone()), most_bytes)
                .await?
            {
                Reply::Document(answer) => self.output(&answer),
                Reply::Refused(reason) => Err(reason),
            };
            if outcome.is_ok() {
                break;
            }
        }
        Ok(outcome)
    }

    /// All numbers of an answer, in order.
    fn output(&self, answer: &Map<String, Value>) -> Outcome {
        let vectors = answer.get("output").and_then(Value::as_array);
        let vectors: Option<Vec<&Vec<Value>>> =
            vectors.and_then(|vectors| vectors.iter().map(Value::as_array).collect());
        let vectors = vectors.ok_or("its answer has no output, a list of lists")?;
        let found: Vec<usize> = vectors.iter().map(|vector| vector.len()).collect();
        if found != self.output_sizes {
            return Err(format!(
                "its output has the sizes {found:?}, not {:?}",
                self.output_sizes
            ));
        }
        let numbers = vectors
            .into_iter()
            .flatten()
            .enumerate()
            .map(|(at, value)| {
                let number = value.as_f64().filter(|number| number.is_finite());
                number.ok_or_else(|| format!("number {} of its output isn't finite", at + 1))
            });
        numbers.collect()
    }
}

fn told(reply: Reply) -> Result<Map<String, Value>, NoModel> {
    match reply {
        Reply::Document(document) => Ok(document),
        Reply::Refused(reason) => Err(NoModel::Unfit(format!("the server refuses: {reason}"))),
    }
}

/// Name of the model to ask, of those that a server has.
fn chosen(info: &Map<String, Value>, name: Option<&str>) -> Result<String, NoModel> {
    let unfit = |detail: String| Err(NoModel::Unfit(detail));
    let version = info.get("protocolVersion").and_then(Value::as_f64);
    if version.is_none_or(|version| version.floor() != 1.0) {
        return unfit("the server doesn't speak UM-Bridge's protocol 1".to_owned());
    }
    let models = info.get("models").and_then(Value::as_array);
    let models: Vec<&str> = models
        .into_iter()
        .flatten()
        .filter_map(Value::as_str)
        .collect();
    let named: Vec<String> = models.iter().map(|model| visible(model)).collect();
    let named = named.join(", ");
    match (name, models.as_slice()) {
        (Some(name), models) if models.contains(&name) => Ok(name.to_owned()),
        (Some(name), _) => unfit(format!("the server has no model {name:?}, but {named}")),
        (None, [model]) => Ok((*model).to_owned()),
        (None, []) => unfit("the server has no model".to_owned()),
        (None, _) => unfit(format!(
            "the server has several models: choose one by --name: {named}"
        )),
    }
}

/// Sizes of vectors under a name.
fn sizes(answer: &Map<String, Value>, name: &str) -> Result<Vec<usize>, NoModel> {
    let size = |value: &Value| {
        let size = value.as_u64().and_then(|size| usize::try_from(size).ok());
        // So that no sum of them overflows.
        size.filter(|size| *size <= MOST_BYTES)
    };
    let sizes = answer.get(name).and_then(Value::as_array);
    let sizes = sizes.and_then(|sizes| sizes.iter().map(size).collect());
    sizes.ok_or_else(|| NoModel::Unfit(format!("the server's {name} aren't a list of sizes")))
}
