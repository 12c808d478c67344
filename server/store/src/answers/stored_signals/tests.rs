use sqlx::migrate::Migrator;
use sqlx::sqlite::SqliteConnectOptions;
use sqlx::{Connection, SqliteConnection};

use super::*;
use crate::Store;
use crate::database::tests::fresh;
use crate::file::schema::MIGRATIONS;

fn signals() -> Signals {
    let row = |(load_n, state): (f64, Option<FilmCondition>)| SignalRow {
        tire: "own".to_owned(),
        film: FilmModel::Coupled,
        position: POSITIONS[1].1,
        direction: Direction::Y,
        over: SignalAxis::Load,
        load_n,
        pressure_mpa: 0.2,
        contact_deg: 0.0,
        depth_mm: Some(0.1 + 0.2),
        strain: state.map(|_| 1e-3 / 3.0),
        tension_1_n_per_mm: None,
        charge_nc: Some(-0.0),
        open_circuit_v: Some(1e-300),
        output_v: None,
        output_std_v: None,
        state,
        error: state.map(|_| SignalError {
            strain: 1e-5,
            charge_nc: 0.1,
            open_circuit_v: 0.2,
            output_v: 0.3,
        }),
        reason: state.is_none().then(|| "it touches itself".to_owned()),
    };
    let states = FilmCondition::NAMES.map(|(_, condition)| Some(condition));
    let rows = [1.0, 2.0, 5.0]
        .into_iter()
        .zip(states)
        .chain([(10.0, None)]);
    Signals {
        rows: rows.map(row).collect(),
        widths: vec![StressWidth {
            tire: "own".to_owned(),
            load_n: 1.0,
            depth_mm: None,
            amplitude_mpa: Some(0.1),
            width_deg: Some(6.1),
            offset_mpa: Some(0.01),
            r2: Some(0.998),
            reason: None,
        }],
        ..Signals::default()
    }
}

/// A study with a result.
async fn add_result(connection: &mut SqliteConnection) {
    for change in [
        "insert into studies (id, name, spec, spec_sha256, state, created) values ('a', 'films', '{}', '', 'done', 't')",
        "insert into results (study, document, document_sha256, content_sha256, created) values ('a', '{}', '', 'c', 't')",
    ] {
        let changed = sqlx::query(change).execute(&mut *connection).await;
        changed.expect("stores");
    }
}

/// A database with a study's result that has these signals.
async fn stored(signals: &Signals) -> (tempfile::TempDir, Store) {
    let (folder, store) = fresh().await;
    let mut write = store.begin().await.expect("begins");
    add_result(&mut write).await;
    insert(&mut write, "a", signals).await.expect("stores");
    store.commit(write, 0).await.expect("commits");
    (folder, store)
}

#[tokio::test]
async fn signals_are_found_as_they_were_stored_and_never_when_damaged() {
    let signals = signals();
    for damage in [
        "update signals set open_circuit_v = 1 where ordinal = 1",
        "delete from signals where ordinal = 3",
        "delete from signal_findings",
        "update signal_findings set findings = '{}'",
    ] {
        let (_folder, store) = stored(&signals).await;
        let mut write = store.begin().await.expect("begins");
        let found = find(&mut write, "a").await.expect("reads");
        assert_eq!(found.as_ref(), Some(&signals));
        assert_eq!(find(&mut write, "b").await.expect("reads"), None);
        let damaged = sqlx::query(damage).execute(&mut *write).await;
        assert!(damaged.expect("damages").rows_affected() > 0, "{damage}");
        let refused = find(&mut write, "a").await;
        assert!(
            matches!(
                refused,
                Err(StoreError::Damaged {
                    table: "signals",
                    ..
                })
            ),
            "{damage}: {refused:?}"
        );
    }
}

#[tokio::test]
async fn a_database_of_before_opens_and_has_no_signals_yet() {
    let folder = tempfile::tempdir().expect("temp dir");
    let path = folder.path().join("before.db");
    let options = SqliteConnectOptions::new().filename(&path);
    let opened = SqliteConnection::connect_with(&options.create_if_missing(true)).await;
    let mut sql = opened.expect("opens");
    let before = MIGRATIONS.iter().filter(|change| change.version < 20);
    let before = Migrator::with_migrations(before.cloned().collect());
    before.run(&mut sql).await.expect("migrates");
    add_result(&mut sql).await;
    sql.close().await.expect("closes");

    let store = Store::open(&path).await.expect("opens");
    let mut write = store.begin().await.expect("begins");
    assert_eq!(find(&mut write, "a").await.expect("reads"), None);
    insert(&mut write, "a", &signals()).await.expect("stores");
    let found = find(&mut write, "a").await.expect("reads");
    assert_eq!(found, Some(signals()));
}
