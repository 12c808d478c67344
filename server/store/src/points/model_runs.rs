//! Runs of models that other programs serve, kept by what was asked, checked when read.

use serde_json::json;
use sqlx::SqliteConnection;

use crate::clock::now;
use crate::column::counted;
use crate::content::{encode, sha256};
use crate::row::from_row;
use crate::store_error::StoreError;

/// Model that is asked.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Model {
    /// Address of its server.
    pub url: String,
    /// Name there.
    pub name: String,
    /// Settings that are sent along, a JSON object.
    pub config: String,
}

/// Outputs of a run, or why it failed.
pub type Outcome = Result<Vec<f64>, String>;

/// Run to be stored.
#[derive(Debug, Clone, PartialEq)]
pub struct ModelRun {
    /// Key by [`Model::key`].
    pub key: String,
    /// Outcome of it.
    pub outcome: Outcome,
}

struct RunRow {
    key: String,
    model: String,
    outputs: Option<String>,
    failure: Option<String>,
    sha256: String,
    created: String,
}

/// Row in answer to the key at a place of a list.
struct FoundRow {
    place: i64,
    row: RunRow,
}

from_row!(RunRow {
    key,
    model,
    outputs,
    failure,
    sha256,
    created
});
from_row!(FoundRow { place; row });

impl Model {
    /// Returns the key of the run at these values of the inputs: the same model at the same bits has the same.
    pub fn key(&self, inputs: &[f64]) -> String {
        let bits = inputs.iter().map(|value| value.to_bits().to_le_bytes());
        let bits: Vec<u8> = bits.flatten().collect();
        let texts = [&self.url, &self.name, &self.config];
        let [url, name, config] = texts.map(|text| text.as_bytes());
        sha256(&[url, name, config, &bits])
    }
}

impl RunRow {
    fn of(model: &Model, run: &ModelRun) -> Result<Self, StoreError> {
        let outputs = run.outcome.as_ref().ok();
        let mut row = Self {
            key: run.key.clone(),
            model: json!([model.url, model.name]).to_string(),
            outputs: outputs
                .map(|outputs| encode("the outputs of a run", outputs))
                .transpose()?,
            failure: run.outcome.as_ref().err().cloned(),
            sha256: String::new(),
            created: now(),
        };
        row.sha256 = row.content_sha256();
        Ok(row)
    }

    /// Hashes all other columns, one that is null as no part.
    fn content_sha256(&self) -> String {
        let kind = ["outputs", "failure"][usize::from(self.outputs.is_none())].to_owned();
        let columns = [&self.key, &self.model, &self.created, &kind];
        let outcome = self.outputs.iter().chain(&self.failure);
        let parts: Vec<&[u8]> = columns
            .into_iter()
            .chain(outcome)
            .map(|text| text.as_bytes())
            .collect();
        sha256(&parts)
    }

    fn read(self) -> Result<Outcome, StoreError> {
        let outcome = match (&self.outputs, &self.failure) {
            (Some(outputs), None) => serde_json::from_str(outputs).ok().map(Ok),
            (None, Some(failure)) => Some(Err(failure.clone())),
            _ => None,
        };
        let outcome = outcome.filter(|_| self.content_sha256() == self.sha256);
        outcome.ok_or(StoreError::Damaged {
            table: "model_runs",
            row: self.key,
        })
    }
}

/// Stores runs. One that is there already stays as it is unless it failed.
///
/// # Errors
/// [`StoreError::NotFinite`] when an output is NaN or infinite; when the database can't be written.
pub async fn insert(
    connection: &mut SqliteConnection,
    model: &Model,
    runs: &[ModelRun],
) -> Result<(), StoreError> {
    let query = "insert into model_runs (key, model, outputs, failure, sha256, created) values (?, ?, ?, ?, ?, ?)
         on conflict (key) do update set model = excluded.model, outputs = excluded.outputs, failure = excluded.failure, sha256 = excluded.sha256, created = excluded.created
         where model_runs.failure is not null";
    for run in runs {
        let row = RunRow::of(model, run)?;
        sqlx::query(query)
            .bind(row.key)
            .bind(row.model)
            .bind(row.outputs)
            .bind(row.failure)
            .bind(row.sha256)
            .bind(row.created)
            .execute(&mut *connection)
            .await?;
    }
    Ok(())
}

/// Finds the runs of these keys, in their order; nothing for those that aren't there.
///
/// # Errors
/// [`StoreError::Damaged`] when one doesn't match its hash; when the database can't be read.
pub async fn find(
    connection: &mut SqliteConnection,
    keys: &[String],
) -> Result<Vec<Option<Outcome>>, StoreError> {
    let query =
        "select asked.key as place, m.key, m.model, m.outputs, m.failure, m.sha256, m.created
         from json_each(?) as asked join model_runs m on m.key = asked.value";
    let rows: Vec<FoundRow> = sqlx::query_as(query)
        .bind(json!(keys).to_string())
        .fetch_all(connection)
        .await?;
    let mut found = vec![None; keys.len()];
    for FoundRow { place, row } in rows {
        let outcome = row.read()?;
        if let Some(cell) = counted(place).and_then(|place| found.get_mut(place)) {
            *cell = Some(outcome);
        }
    }
    Ok(found)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::database::tests::fresh;

    fn model() -> Model {
        Model {
            url: "http://127.0.0.1:4242".to_owned(),
            name: "forward".to_owned(),
            config: "{}".to_owned(),
        }
    }

    fn run(x: f64, outcome: Outcome) -> ModelRun {
        ModelRun {
            key: model().key(&[x]),
            outcome,
        }
    }

    #[test]
    fn whatever_is_asked_otherwise_has_another_key() {
        let key = model().key(&[0.0, 1.0]);
        let others = [
            Model {
                url: "http://127.0.0.1:4243".to_owned(),
                ..model()
            },
            Model {
                name: "backward".to_owned(),
                ..model()
            },
            Model {
                config: "{\"level\":1}".to_owned(),
                ..model()
            },
        ];
        assert_eq!(key, model().key(&[0.0, 1.0]));
        for other in others {
            assert_ne!(key, other.key(&[0.0, 1.0]));
        }
        for values in [&[-0.0, 1.0][..], &[0.0, 1.0 + f64::EPSILON], &[1.0, 0.0]] {
            assert_ne!(key, model().key(values));
        }
    }

    #[tokio::test]
    async fn runs_read_back_to_the_bit_and_a_failed_one_may_be_mended() {
        let (_folder, store) = fresh().await;
        let outputs = vec![0.1 + 0.2, -0.0, 5e-324, f64::MAX];
        let failed = || run(2.0, Err("diverged".to_owned()));
        let mut write = store.begin().await.expect("begins");
        let runs = [run(1.0, Ok(outputs.clone())), failed()];
        insert(&mut write, &model(), &runs).await.expect("stores");
        let keys = [1.0, 2.0, 3.0].map(|x| model().key(&[x]));
        let found = find(&mut write, &keys).await.expect("reads");
        let bits = |values: &[f64]| values.iter().map(|x| x.to_bits()).collect::<Vec<_>>();
        let first = found[0].as_ref().expect("is there").as_ref();
        assert_eq!(bits(first.expect("ran")), bits(&outputs));
        assert_eq!(found[1..], [Some(Err("diverged".to_owned())), None]);

        let again = [run(1.0, Ok(vec![7.0])), run(2.0, Ok(vec![8.0]))];
        insert(&mut write, &model(), &again).await.expect("stores");
        let found = find(&mut write, &keys).await.expect("reads");
        assert_eq!(found[0], Some(Ok(outputs)));
        assert_eq!(found[1], Some(Ok(vec![8.0])));
        let refused = insert(&mut write, &model(), &[run(4.0, Ok(vec![f64::NAN]))]).await;
        assert!(matches!(refused, Err(StoreError::NotFinite { .. })));
    }

    #[tokio::test]
    async fn a_run_that_was_altered_or_exchanged_is_named() {
        let changes = [
            "update model_runs set outputs = '[2.0]' where outputs is not null",
            "update model_runs set failure = outputs, outputs = null where outputs is not null",
            "update model_runs set key = 'x' where outputs is not null",
            "update model_runs set created = 'later'",
            "update model_runs set model = 'another'",
        ];
        for change in changes {
            let (_folder, store) = fresh().await;
            let mut write = store.begin().await.expect("begins");
            let runs = [run(1.0, Ok(vec![1.0])), run(2.0, Err("no".to_owned()))];
            insert(&mut write, &model(), &runs).await.expect("stores");
            let changed = sqlx::query(change).execute(&mut *write).await;
            changed.expect("changes");
            let keys = [model().key(&[1.0]), model().key(&[2.0]), "x".to_owned()];
            let found = find(&mut write, &keys).await;
            assert!(
                matches!(
                    found,
                    Err(StoreError::Damaged {
                        table: "model_runs",
                        ..
                    })
                ),
                "{change}"
            );
        }
    }
}
