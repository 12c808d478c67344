//! `strainsite gsa run`: plans, asks a model that another program serves, stores, and analyses.

use std::path::PathBuf;
use std::sync::Arc;
use std::time::Duration;

use clap::Args;
use documents::own_model::inputs_document::Inputs;
use documents::own_model::own_analysis::OwnAnalysis;
use documents::own_model::value_table::ValueTable;
use indicatif::ProgressBar;
use serde_json::{Map, Value};
use store::Store;
use store::points::model_runs::Outcome;
use tokio::runtime::Runtime;
use tokio::sync::watch;

use crate::cli::commands::gsa::own_values::read_inputs;
use crate::cli::commands::gsa::run_outputs::{Names, names_list, values_csv};
use crate::cli::commands::gsa::told_indices::tell_indices;
use crate::cli::terminal::exit::Failure;
use crate::cli::terminal::files::Files;
use crate::cli::terminal::output::{JsonTarget, warn};
use crate::cli::terminal::output_place::write;
use crate::cli::terminal::paint::{WARNING, painted};
use crate::cli::terminal::progress::{count, counting_bar};
use crate::cli::terminal::signals::Signals;
use crate::config::{patience, seconds};
use crate::umbridge::asked_model::{AskedModel, NoModel};
use crate::umbridge::http_exchange::{Away, Exchange, Manners, server_url};
use crate::umbridge::stored_runs::{Points, Runs, Seen, StoredRuns, Unfinished};

/// Plan, run a model that a server has by UM-Bridge's protocol, and analyse; given again it goes on where it was
#[derive(Debug, Args)]
pub(crate) struct Run {
    /// Inputs and method, TOML or JSON
    inputs: PathBuf,
    /// Server of the model, or a load balancer before several
    #[arg(long, value_name = "http://HOST:PORT", value_parser = server_url)]
    model: String,
    /// Name of the model, where the server has several
    #[arg(long)]
    name: Option<String>,
    /// Settings that the model is sent with each question, a JSON object
    #[arg(long, value_name = "JSON", default_value = "{}", value_parser = object)]
    config: Map<String, Value>,
    /// Runs that are asked for at once, at most
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = clap::value_parser!(u16).range(1..=1000))]
    at_once: u16,
    /// Time that an answer may take, seconds; any when absent
    #[arg(long, value_name = "SECONDS", value_parser = seconds)]
    timeout_s: Option<Duration>,
    /// Time that the server may be away before the command ends, seconds
    #[arg(long, value_name = "SECONDS", default_value = "60", value_parser = patience)]
    patience_s: Duration,
    /// Names of the outputs, in the order of the answer's numbers; y, or y1, y2 and so on, when absent
    #[arg(long, value_name = "NAME,...", value_parser = names_list)]
    outputs: Option<Names>,
    /// Ask for runs that failed before once more
    #[arg(long)]
    again: bool,
    /// Database file that keeps the runs; created when it isn't there
    #[arg(
        long,
        env = "STRAINSITE_DB",
        value_name = "FILE",
        default_value = "strainsite.db"
    )]
    db: PathBuf,
    /// Write the values as CSV, which `gsa analyse` reads
    #[arg(short = 'o', long, value_name = "FILE")]
    values: Option<PathBuf>,
    /// Write the answer as JSON, `-` for standard output
    #[arg(long, value_name = "FILE|-")]
    pub json: Option<JsonTarget>,
}

/// Time that an analysis which goes on has to end by itself after a signal.
const GRACE: Duration = Duration::from_secs(2);
/// End of a sentence about a command that didn't come to its end.
const GOES_ON: &str = "all answers so far are stored: the same command goes on";
/// Failed runs whose reasons are told.
const TOLD: usize = 2;

/// Runs so far, and how many of them were stored before.
#[derive(Default)]
struct Progress {
    runs: Runs,
    known: usize,
}

impl Run {
    /// Returns the files that it reads and writes.
    pub fn files(&self) -> Files {
        Files::of_database(&self.db)
            .reading([&self.inputs])
            .writing(self.values.as_deref())
            .telling(self.json.as_ref())
    }

    /// Asks until nothing is wanted, and tells the indices.
    pub fn execute(&self) -> Result<(), Failure> {
        let inputs = read_inputs(&self.inputs)?;
        let runtime = Runtime::new().map_err(Failure::other)?;
        let stopping = stopping(&runtime)?;
        let bar = counting_bar(0, "points");
        let model = runtime.block_on(self.met(&inputs, &bar, stopping.clone()))?;
        let names = match &self.outputs {
            Some(names) => names.of(&model, &inputs)?,
            None => Names::usual(&model, &inputs)?,
        };
        let store = runtime
            .block_on(Store::open(&self.db))
            .map_err(Failure::other)?;
        let asking = StoredRuns {
            store: &store,
            model: Arc::new(model),
            at_once: usize::from(self.at_once),
            stopping,
        };
        let analysed = self.analyse(&inputs, &names, &runtime, asking, &bar);
        bar.finish_and_clear();
        let closed = runtime.block_on(store.close()).map_err(Failure::other);
        // What a server that was given up still owes is nobody's concern.
        runtime.shutdown_background();
        analysed.and(closed)
    }

    /// Meets the model.
    async fn met(
        &self,
        inputs: &Inputs,
        bar: &ProgressBar,
        mut stopping: watch::Receiver<bool>,
    ) -> Result<AskedModel, Failure> {
        let bar = bar.clone();
        let manners = Manners {
            timeout: self.timeout_s,
            patience: self.patience_s,
            say: Box::new(move |line| bar.suspend(|| warn(line))),
        };
        let exchange = Exchange::with(&self.model, manners);
        let (name, config) = (self.name.as_deref(), self.config.clone());
        let meeting = AskedModel::meet(exchange, name, config, inputs.names.len());
        let met = tokio::select! {
            met = meeting => met,
            _ = stopping.wait_for(|stopping| *stopping) => return Err(Failure::Other("stopped on request; nothing was asked".to_owned())),
        };
        met.map_err(|none| match none {
            NoModel::Away(Away(cause)) => Failure::Other(cause),
            NoModel::Unfit(detail) => Failure::input(detail),
        })
    }

    /// Asks in rounds, as the method does, and tells what comes out.
    fn analyse(
        &self,
        inputs: &Inputs,
        names: &Names,
        runtime: &Runtime,
        mut asking: StoredRuns<'_>,
        bar: &ProgressBar,
    ) -> Result<(), Failure> {
        let mut so_far = Progress::default();
        loop {
            let text = values_csv(names, &so_far.runs);
            // Read as the file of values is: it has the same answer, to the bit.
            let table = match so_far.runs.is_empty() {
                true => ValueTable::empty(),
                false => ValueTable::of_model(&text, &inputs.names).map_err(Failure::Input)?,
            };
            let analysis = OwnAnalysis::of(inputs, &table).map_err(Failure::Input)?;
            let numbered = analysis.wanted().into_iter().filter_map(|id| {
                let point = analysis.points().get(id)?;
                Some((id, point.clone()))
            });
            let points: Points = numbered.collect();
            if points.is_empty() {
                if let Some(path) = &self.values {
                    write(path, text.as_bytes())?;
                }
                bar.finish_and_clear();
                warn(&so_far.said());
                return match analysis.found() {
                    Some(found) => tell_indices(&analysis, found, self.json.as_ref()),
                    None => Err(Failure::Other(analysis.advice().unwrap_or_default())),
                };
            }
            let round = self.round(&mut so_far, points, &mut asking, bar);
            runtime.block_on(round).map_err(failure)?;
        }
    }

    /// Runs these points, but for those that are stored.
    async fn round(
        &self,
        so_far: &mut Progress,
        mut points: Points,
        asking: &mut StoredRuns<'_>,
        bar: &ProgressBar,
    ) -> Result<(), Unfinished> {
        let mut known = asking.known(&points).await?;
        if self.again {
            known.retain(|_, outcome| outcome.is_ok());
        }
        points.retain(|id, _| !known.contains_key(id));
        so_far.known += known.len();
        so_far.runs.append(&mut known);
        let before = so_far.runs.len();
        let all = before + points.len();
        let seen = |seen: Seen<'_>| {
            match seen {
            Seen::Stored(stored) => count(bar, before + stored, all),
            Seen::Leaving(_, 0) => {}
            Seen::Leaving(Away(cause), in_flight) => bar.suspend(|| {
                warn(&format!(
                    "{cause}; nothing more is asked for, {in_flight} runs in flight are waited for\n"
                ));
            }),
        }
        };
        let mut asked = asking.ask(&points, &seen).await?;
        so_far.runs.append(&mut asked);
        Ok(())
    }
}

impl Progress {
    /// Count of the runs, and the reasons why some failed.
    fn said(&self) -> String {
        let known = match self.known {
            0 => String::new(),
            known => format!(", {known} of them known before"),
        };
        let reason = |(id, outcome): (&usize, &Outcome)| {
            let reason = outcome.as_ref().err()?;
            Some(format!("- point {id}: {reason}\n"))
        };
        let reasons: Vec<String> = self.runs.iter().filter_map(reason).collect();
        let mut text = format!("{} runs{known}\n", self.runs.len());
        if !reasons.is_empty() {
            let failed = format!("{} failed; --again asks for these anew:", reasons.len());
            text += &format!("{}\n", painted(WARNING, failed));
            text.extend(reasons.into_iter().take(TOLD));
        }
        text
    }
}

fn failure(ended: Unfinished) -> Failure {
    match ended {
        Unfinished::Away(Away(cause)) => Failure::Other(format!("{cause}; {GOES_ON}")),
        Unfinished::Stopped => Failure::Other(format!("stopped on request; {GOES_ON}")),
        Unfinished::Changed(detail) => Failure::input(detail),
        Unfinished::Unstored(error) => Failure::other(error),
        Unfinished::Broken(error) => Failure::other(error),
    }
}

/// True from the first signal on. A second one ends the program at once, and so does the end of the grace: all answers are stored.
fn stopping(runtime: &Runtime) -> Result<watch::Receiver<bool>, Failure> {
    let mut signals = runtime.block_on(async { Signals::listen() })?;
    let (sender, receiver) = watch::channel(false);
    runtime.spawn(async move {
        signals.next().await;
        sender.send_replace(true);
        if tokio::time::timeout(GRACE, signals.next()).await.is_err() {
            warn(&format!("stopped on request; {GOES_ON}\n"));
        }
        std::process::exit(1);
    });
    Ok(receiver)
}

/// Reads a JSON object.
fn object(text: &str) -> Result<Map<String, Value>, String> {
    serde_json::from_str(text).map_err(|error| format!("not a JSON object: {error}"))
}
