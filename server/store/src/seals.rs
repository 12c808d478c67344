//! Seals of rows: a hash of what a row says together with its place, its key and its owner, so that a row that was exchanged with another one is found as one that
//! was changed is.
//!
//! A row is written without its seal, and [`close`] seals all that have none before a transaction is committed. Whoever changes what a seal covers takes the seal
//! off. Rows of tables that aren't here have a hash of their own that covers their key ([`OWN_HASH`]).

use std::sync::LazyLock;

use sqlx::{AssertSqlSafe, SqliteConnection};

use crate::column::counted;
use crate::content::sha256;
use crate::store_error::StoreError;

/// A table whose rows have seals.
struct Sealed {
    table: &'static str,
    /// Column of the seal.
    seal: &'static str,
    key: &'static [&'static str],
    /// Columns that the seal covers, the key among them.
    covered: &'static [&'static str],
}

const fn sealed(
    table: &'static str,
    seal: &'static str,
    key: &'static [&'static str],
    covered: &'static [&'static str],
) -> Sealed {
    Sealed {
        table,
        seal,
        key,
        covered,
    }
}

/// Seal of what a row is.
const IDENTITY: &str = "seal";
/// Seal of how far it is, apart: who changes that takes this seal off, and leaves the other one as it is.
const STATE: &str = "state_seal";

static SEALED: [Sealed; 18] = [
    sealed(
        "studies",
        IDENTITY,
        &["id"],
        &["id", "spec_sha256", "created"],
    ),
    sealed(
        "studies",
        STATE,
        &["id"],
        &[
            "id",
            "name",
            "state",
            "priority",
            "place",
            "points_total",
            "points_done",
            "estimate",
            "error",
            "started",
            "finished",
            "archived",
        ],
    ),
    sealed(
        "events",
        IDENTITY,
        &["id"],
        &["id", "study", "previous", "kind", "payload", "created"],
    ),
    sealed(
        "idempotency_keys",
        IDENTITY,
        &["key"],
        &["key", "study", "spec_sha256"],
    ),
    sealed(
        "crashes",
        IDENTITY,
        &["key"],
        &["key", "count", "own", "cause"],
    ),
    sealed(
        "results",
        IDENTITY,
        &["study"],
        &["study", "document_sha256", "content_sha256", "created"],
    ),
    sealed(
        "trades",
        IDENTITY,
        &["id"],
        &["id", "spec_sha256", "document_sha256", "created"],
    ),
    sealed(
        "sweeps",
        IDENTITY,
        &["id"],
        &["id", "spec_sha256", "priority", "designs", "created"],
    ),
    sealed("sweeps", STATE, &["id"], &["id", "name", "archived"]),
    sealed(
        "sweep_designs",
        IDENTITY,
        &["sweep", "ordinal"],
        &["sweep", "ordinal", "name", "settings", "study"],
    ),
    sealed(
        "sweep_keys",
        IDENTITY,
        &["key"],
        &["key", "sweep", "sha256"],
    ),
    sealed(
        "sweep_engines",
        IDENTITY,
        &["sweep"],
        &["sweep", "engine", "begun", "sha256", "ended"],
    ),
    sealed(
        "estimators",
        IDENTITY,
        &["id"],
        &["id", "document_sha256", "memory_bytes", "created"],
    ),
    sealed(
        "estimators",
        STATE,
        &["id"],
        &[
            "id", "name", "state", "error", "crashes", "started", "finished",
        ],
    ),
    sealed(
        "estimator_recordings",
        IDENTITY,
        &["estimator", "ordinal"],
        &["estimator", "ordinal", "file", "sha256"],
    ),
    sealed(
        "estimator_parts",
        IDENTITY,
        &["estimator", "part"],
        &["estimator", "part", "sha256"],
    ),
    sealed(
        "estimator_zeros",
        IDENTITY,
        &["estimator"],
        &["estimator", "sha256"],
    ),
    sealed(
        "estimator_keys",
        IDENTITY,
        &["key"],
        &["key", "estimator", "sha256"],
    ),
];

/// Tables without seals: a hash of their own covers their key, or their owner's does; of solves in flight nothing is told to anybody.
#[cfg(test)]
pub(crate) const OWN_HASH: [&str; 8] = [
    "evaluations",
    "model_runs",
    "strain_fields",
    "start_states",
    "study_points",
    "result_maps",
    "result_extracts",
    "solves_in_flight",
];

impl Sealed {
    /// Seal of what the rows of a table are.
    fn of(table: &str) -> Option<&'static Self> {
        let mut identities = SEALED.iter().filter(|sealed| sealed.seal == IDENTITY);
        identities.find(|sealed| sealed.table == table)
    }

    /// Selects key, covered columns and seal, the first two as JSON.
    fn select(&self, clause: &str) -> AssertSqlSafe<String> {
        let (key, covered) = (self.key.join(", "), self.covered.join(", "));
        AssertSqlSafe(format!(
            "select json_array({key}), json_array({covered}), {} from {} where {clause}",
            self.seal, self.table
        ))
    }

    fn update(&self) -> AssertSqlSafe<String> {
        let is_it = |(place, column): (usize, &&str)| format!("{column} = ?2 ->> {place}");
        let key: Vec<String> = self.key.iter().enumerate().map(is_it).collect();
        AssertSqlSafe(format!(
            "update {} set {} = ?1 where {}",
            self.table,
            self.seal,
            key.join(" and ")
        ))
    }

    fn sealed(&self, covered: &str) -> String {
        let parts = [self.table, self.seal, covered];
        sha256(&parts.map(str::as_bytes))
    }
}

/// A row's key, what its seal covers, and its seal.
type Row = (String, String, Option<String>);

/// Selects the rows of all tables that have no seal: the number of the seal, key, and what it covers.
static UNSEALED: LazyLock<String> = LazyLock::new(|| {
    let of_table = |(number, sealed): (usize, &Sealed)| {
        let (key, covered) = (sealed.key.join(", "), sealed.covered.join(", "));
        let (table, seal) = (sealed.table, sealed.seal);
        format!(
            "select {number}, json_array({key}), json_array({covered}) from {table} where {seal} is null"
        )
    };
    let each: Vec<String> = SEALED.iter().enumerate().map(of_table).collect();
    each.join(" union all ")
});

/// Seals all rows that have no seal.
///
/// # Errors
/// When the database can't be written.
pub(crate) async fn close(connection: &mut SqliteConnection) -> Result<(), StoreError> {
    let rows: Vec<(i64, String, String)> = sqlx::query_as(AssertSqlSafe(UNSEALED.as_str()))
        .fetch_all(&mut *connection)
        .await?;
    for (number, key, covered) in rows {
        let Some(sealed) = counted(number).and_then(|number| SEALED.get(number)) else {
            continue;
        };
        sqlx::query(sealed.update())
            .bind(sealed.sealed(&covered))
            .bind(key)
            .execute(&mut *connection)
            .await?;
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
            .is_some_and(|seal| *seal != sealed.sealed(covered))
    };
    match rows.iter().find(broken) {
        Some((key, ..)) => Err(damaged(table, key)),
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
            if seal.as_deref() != Some(&sealed.sealed(&covered)) {
                found.push(damaged(sealed.table, &key).to_string());
            }
        }
    }
    Ok(found)
}

/// A row by its key, JSON.
fn damaged(table: &'static str, key: &str) -> StoreError {
    StoreError::Damaged {
        table,
        row: key.trim_matches(['[', ']']).replace('"', ""),
    }
}

/// Tables whose rows have seals.
#[cfg(test)]
pub(crate) fn sealed_tables() -> impl Iterator<Item = &'static str> {
    let identities = SEALED.iter().filter(|sealed| sealed.seal == IDENTITY);
    identities.map(|sealed| sealed.table)
}
