//! Runs of a model at the points of a plan: those that are stored, and the others asked for side by side, each stored before it counts.

use std::collections::BTreeMap;
use std::sync::Arc;

use store::points::model_runs::{self, ModelRun, Outcome};
use store::{Store, StoreError};
use tokio::sync::watch;
use tokio::task::{JoinError, JoinSet};

use crate::umbridge::asked_model::AskedModel;
use crate::umbridge::http_exchange::Away;

/// Keys that are looked up in one go.
const KEYS: usize = 1000;

/// Points by number.
pub(crate) type Points = BTreeMap<usize, Vec<f64>>;
/// Runs of points, by number.
pub(crate) type Runs = BTreeMap<usize, Outcome>;

/// Model and database that keeps its runs.
pub(crate) struct StoredRuns<'s> {
    /// Database.
    pub store: &'s Store,
    /// Model that is asked.
    pub model: Arc<AskedModel>,
    /// Points that are asked for at once, at most.
    pub at_once: usize,
    /// True from when the program is to end.
    pub stopping: watch::Receiver<bool>,
}

/// Reason why not all points have runs; those that came are stored.
#[derive(Debug)]
pub(crate) enum Unfinished {
    /// The server is away.
    Away(Away),
    /// The program is to end.
    Stopped,
    /// The model answered otherwise when it was asked before, a sentence.
    Changed(String),
    /// The database failed.
    Unstored(StoreError),
    /// A run ended in a panic.
    Broken(JoinError),
}

impl From<StoreError> for Unfinished {
    fn from(error: StoreError) -> Self {
        Self::Unstored(error)
    }
}

/// Event while points are asked for.
pub(crate) enum Seen<'s> {
    /// Count of the runs that are stored.
    Stored(usize),
    /// The server is away, and a count of runs is waited for.
    Leaving(&'s Away, usize),
}

/// Run of a point that was asked for.
type Asked = (usize, Result<Outcome, Away>);

impl StoredRuns<'_> {
    /// Runs of these points that are stored.
    ///
    /// # Errors
    /// When one has other outputs than the model has now, or the database can't be read.
    pub(crate) async fn known(&self, points: &Points) -> Result<Runs, Unfinished> {
        let model = self.model.stored();
        let ids: Vec<usize> = points.keys().copied().collect();
        let keys: Vec<String> = points.values().map(|point| model.key(point)).collect();
        let mut found = Runs::new();
        for (ids, keys) in ids.chunks(KEYS).zip(keys.chunks(KEYS)) {
            let mut connection = self.store.read().await?;
            let outcomes = model_runs::find(&mut connection, keys).await?;
            let pairs = ids.iter().copied().zip(outcomes);
            found.extend(pairs.filter_map(|(id, outcome)| Some((id, outcome?))));
        }
        let outputs: usize = self.model.output_sizes().iter().sum();
        let mut sizes = found.values().flatten().map(Vec::len);
        match sizes.find(|size| *size != outputs) {
            Some(size) => Err(Unfinished::Changed(format!(
                "the model answered with {size} numbers before, and has {outputs} now: name another database by --db"
            ))),
            None => Ok(found),
        }
    }

    /// Asks for these points, and tells `seen` how far it is. Where the server is away no more points are asked for, and what is asked for already is waited for.
    ///
    /// # Errors
    /// See [`Unfinished`].
    pub(crate) async fn ask(
        &mut self,
        points: &Points,
        seen: &dyn Fn(Seen<'_>),
    ) -> Result<Runs, Unfinished> {
        let (mut running, mut waiting) = (JoinSet::new(), points.iter());
        let (mut runs, mut away) = (Runs::new(), None);
        loop {
            while away.is_none() && running.len() < self.at_once {
                let Some((id, point)) = waiting.next() else {
                    break;
                };
                let (id, point, model) = (*id, point.clone(), self.model.clone());
                running.spawn(async move { (id, model.run(&point).await) });
            }
            let mut come = Runs::new();
            for (id, run) in self.next(&mut running).await? {
                match run {
                    Ok(outcome) => drop(come.insert(id, outcome)),
                    Err(cause) if away.is_none() => {
                        seen(Seen::Leaving(&cause, running.len()));
                        away = Some(cause);
                    }
                    Err(_) => {}
                }
            }
            if !come.is_empty() {
                self.store(points, &come).await?;
                runs.append(&mut come);
                seen(Seen::Stored(runs.len()));
            } else if running.is_empty() {
                return away.map_or(Ok(runs), |away| Err(Unfinished::Away(away)));
            }
        }
    }

    /// Runs that have come by now, at least one; none where none are asked for.
    async fn next(&mut self, running: &mut JoinSet<Asked>) -> Result<Vec<Asked>, Unfinished> {
        let first = tokio::select! {
            first = running.join_next() => first,
            _ = self.stopping.wait_for(|stopping| *stopping) => return Err(Unfinished::Stopped),
        };
        let others = std::iter::from_fn(|| running.try_join_next());
        let come: Result<Vec<Asked>, JoinError> = first.into_iter().chain(others).collect();
        come.map_err(Unfinished::Broken)
    }

    async fn store(&self, points: &Points, come: &Runs) -> Result<(), StoreError> {
        let model = self.model.stored();
        let run = |(id, outcome): (&usize, &Outcome)| {
            Some(ModelRun {
                key: model.key(points.get(id)?),
                outcome: outcome.clone(),
            })
        };
        let runs: Vec<ModelRun> = come.iter().filter_map(run).collect();
        let mut transaction = self.store.begin().await?;
        model_runs::insert(&mut transaction, &model, &runs).await?;
        self.store.commit(transaction, 0).await
    }
}
