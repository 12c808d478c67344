//! Tests of seals: every table has them, and what is changed or exchanged breaks them.

use sqlx::AssertSqlSafe;

use crate::database::tests::fresh;
use crate::seals::{OWN_HASH, broken, intact, sealed_tables};

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
    let mut known: Vec<&str> = sealed_tables().chain(OWN_HASH).collect();
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
