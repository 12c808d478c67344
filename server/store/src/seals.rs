//! Seals of rows: a hash of what a row says together with its place, its key and its owner, so that a row that was exchanged with another one is found as one that
//! was changed is.
//!
//! A row is written without its seal, and [`close`] seals all that have none before a transaction is committed. Whoever changes what a seal covers takes the seal
//! off. Rows of tables that aren't here have a hash of their own that covers their key ([`OWN_HASH`]).

use sqlx::{AssertSqlSafe, SqliteConnection};

use crate::content::sha256;
use crate::store_error::StoreError;

/// A table whose rows have seals.
struct Sealed {
    table: &'static str,
    key: &'static [&'static str],
    /// Columns that never change, or take the seal off when they do; the key is among them.
    covered: &'static [&'static str],
}

const fn sealed(
    table: &'static str,
    key: &'static [&'static str],
    covered: &'static [&'static str],
) -> Sealed {
    Sealed {
        table,
        key,
        covered,
    }
}

static SEALED: [Sealed; 13] = [
    sealed("studies", &["id"], &["id", "spec_sha256", "created"]),
    sealed(
        "events",
        &["id"],
        &["id", "study", "previous", "kind", "payload", "created"],
    ),
    sealed(
        "idempotency_keys",
        &["key"],
        &["key", "study", "spec_sha256"],
    ),
    sealed("crashes", &["key"], &["key", "count", "own", "cause"]),
    sealed(
        "results",
        &["study"],
        &["study", "document_sha256", "content_sha256", "created"],
    ),
    sealed(
        "trades",
        &["id"],
        &["id", "spec_sha256", "document_sha256", "created"],
    ),
    sealed(
        "sweeps",
        &["id"],
        &["id", "spec_sha256", "priority", "designs", "created"],
    ),
    sealed(
        "sweep_designs",
        &["sweep", "ordinal"],
        &["sweep", "ordinal", "name", "settings", "study"],
    ),
    sealed("sweep_keys", &["key"], &["key", "sweep", "sha256"]),
    sealed(
        "estimators",
        &["id"],
        &["id", "document_sha256", "memory_bytes", "created"],
    ),
    sealed(
        "estimator_recordings",
        &["estimator", "ordinal"],
        &["estimator", "ordinal", "file", "sha256"],
    ),
    sealed(
        "estimator_parts",
        &["estimator", "part"],
        &["estimator", "part", "sha256"],
    ),
    sealed("estimator_keys", &["key"], &["key", "estimator", "sha256"]),
];

/// Tables without seals: a hash of their own covers their key, or their owner's does; of solves in flight nothing is told to anybody.
#[cfg(test)]
const OWN_HASH: [&str; 6] = [
    "evaluations",
    "strain_fields",
    "start_states",
    "study_points",
    "result_maps",
    "solves_in_flight",
];

impl Sealed {
    fn of(table: &str) -> Option<&'static Self> {
        SEALED.iter().find(|sealed| sealed.table == table)
    }

    /// Selects key, covered columns and seal, the first two as JSON.
    fn select(&self, clause: &str) -> AssertSqlSafe<String> {
        let (key, covered) = (self.key.join(", "), self.covered.join(", "));
        AssertSqlSafe(format!(
            "select json_array({key}), json_array({covered}), seal from {} where {clause}",
            self.table
        ))
    }

    fn update(&self) -> AssertSqlSafe<String> {
        let is_it = |(place, column): (usize, &&str)| format!("{column} = ?2 ->> {place}");
        let key: Vec<String> = self.key.iter().enumerate().map(is_it).collect();
        AssertSqlSafe(format!(
            "update {} set seal = ?1 where {}",
            self.table,
            key.join(" and ")
        ))
    }

    fn seal(&self, covered: &str) -> String {
        sha256(&[self.table.as_bytes(), covered.as_bytes()])
    }
}

/// A row's key, what its seal covers, and its seal.
type Row = (String, String, Option<String>);

/// Seals all rows that have no seal.
///
/// # Errors
/// When the database can't be written.
pub(crate) async fn close(connection: &mut SqliteConnection) -> Result<(), StoreError> {
    for sealed in &SEALED {
        let select = sealed.select("seal is null");
        let rows: Vec<Row> = sqlx::query_as(select).fetch_all(&mut *connection).await?;
        for (key, covered, _) in rows {
            sqlx::query(sealed.update())
                .bind(sealed.seal(&covered))
                .bind(key)
                .execute(&mut *connection)
                .await?;
        }
    }
    Ok(())
}

/// Checks the seals of the rows of a table of which the clause holds, with this value in it. One that was written in this transaction has none yet.
///
/// # Errors
/// [`StoreError::Damaged`] when a row doesn't match its seal; when the database can't be read.
pub(crate) async fn intact(
    connection: &mut SqliteConnection,
    table: &'static str,
    clause: &str,
    value: &str,
) -> Result<(), StoreError> {
    let Some(sealed) = Sealed::of(table) else {
        return Ok(());
    };
    let rows: Vec<Row> = sqlx::query_as(sealed.select(clause))
        .bind(value)
        .fetch_all(connection)
        .await?;
    let broken = |(_, covered, seal): &&Row| {
        seal.as_ref()
            .is_some_and(|seal| *seal != sealed.seal(covered))
    };
    match rows.iter().find(broken) {
        Some(_) => Err(StoreError::Damaged {
            table,
            row: value.to_owned(),
        }),
        None => Ok(()),
    }
}

/// Rows of all tables that don't match their seals, or have none, a sentence each.
///
/// # Errors
/// When the database can't be read.
pub(crate) async fn broken(connection: &mut SqliteConnection) -> Result<Vec<String>, StoreError> {
    let mut found = Vec::new();
    for sealed in &SEALED {
        let rows: Vec<Row> = sqlx::query_as(sealed.select("true"))
            .fetch_all(&mut *connection)
            .await?;
        for (key, covered, seal) in rows {
            if seal.as_deref() != Some(&sealed.seal(&covered)) {
                let row = key.trim_matches(['[', ']']).replace('"', "");
                let table = sealed.table;
                found.push(StoreError::Damaged { table, row }.to_string());
            }
        }
    }
    Ok(found)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::database::tests::fresh;

    #[tokio::test]
    async fn every_table_has_seals_or_hashes_of_its_own() {
        let (_folder, store) = fresh().await;
        let mut connection = store.read().await.expect("reads");
        let query = "select name from sqlite_schema where type = 'table' and name not like 'sqlite_%' and name not like '\\_%' escape '\\'";
        let mut tables: Vec<String> = sqlx::query_scalar(query)
            .fetch_all(&mut *connection)
            .await
            .expect("reads");
        tables.sort();
        let sealed = SEALED.iter().map(|sealed| sealed.table);
        let mut known: Vec<&str> = sealed.chain(OWN_HASH).collect();
        known.sort_unstable();
        assert_eq!(tables, known);
    }

    #[tokio::test]
    async fn what_is_exchanged_or_changed_breaks_its_seal() {
        let changes = [
            "update trades set spec_sha256 = 'c' where id = 1",
            "update trades set id = 3 - id + 3; update trades set id = id - 3",
            "update trades set created = 'later' where id = 2",
            "update trades set seal = (select seal from trades where id = 2) where id = 1",
        ];
        for change in changes {
            let (_folder, store) = fresh().await;
            let mut write = store.begin().await.expect("begins");
            for row in ["('a', 'x', 'y', 't')", "('b', 'x', 'y', 't')"] {
                let insert = format!(
                    "insert into trades (spec_sha256, document, document_sha256, created) values {row}"
                );
                sqlx::query(AssertSqlSafe(insert))
                    .execute(&mut *write)
                    .await
                    .expect("stores");
            }
            store.commit(write, 0).await.expect("commits");
            let mut write = store.begin().await.expect("begins");
            assert_eq!(broken(&mut write).await.expect("reads"), [""; 0]);
            sqlx::raw_sql(change)
                .execute(&mut *write)
                .await
                .expect("changes");
            let found = broken(&mut write).await.expect("reads");
            assert!(!found.is_empty() && found[0].contains("trades"), "{change}");
            let read = [
                intact(&mut write, "trades", "spec_sha256 = ?", "a").await,
                intact(&mut write, "trades", "spec_sha256 = ?", "b").await,
                intact(&mut write, "trades", "spec_sha256 = ?", "c").await,
            ];
            assert!(read.iter().any(Result::is_err), "{change}");
        }
    }
}
