use std::sync::atomic::AtomicBool;

use fem_client::closed_form::ClosedFormSolver;
use fem_client::scene::Scene;
use fem_client::solver::{Grid, Readout, SolveRequest, Solver};
use placement::points::archive::PointRecord;
use serde_json::Map;

use super::pruning::{Mode, Pruned, prune};
use super::retention::Retention;
use super::*;
use crate::database::tests::fresh;
use crate::file::upkeep;
use crate::points::evaluations;
use crate::queue::design_rows;
use crate::queue::study_rows;
use crate::queue::sweep_rows;

/// A study that is done, with these points: each with strain fields and a start state.
async fn study(connection: &mut SqliteConnection, name: &str, points: &[&str]) -> String {
    let id = study_rows::insert(connection, name, "{}").await;
    let id = id.expect("inserts");
    let (scene, stop) = (Scene::default(), AtomicBool::new(false));
    let readout = Readout {
        grid: Some(Grid {
            circumferential: 3,
            meridional: 3,
            half_width_deg: 20.0,
        }),
        ..Readout::default()
    };
    let request = SolveRequest {
        scene: &scene,
        readout: &readout,
        start: None,
        watch: &stop,
    };
    let solved = ClosedFormSolver::new().solve(&request).expect("solves");
    let outcome = Ok(solved.response);
    for (ordinal, key) in points.iter().enumerate() {
        let point = PointRecord {
            key,
            ordinal,
            scene: "{}",
            outcome: &outcome,
            cost: solved.cost,
            start: Some(&solved.state),
        };
        let stored = evaluations::insert(connection, &id, &point).await;
        stored.expect("stores");
    }
    end(connection, &id, "done", "2026-01-01T00:00:00.000Z").await;
    id
}

async fn end(connection: &mut SqliteConnection, id: &str, state: &str, finished: &str) {
    let ended =
        sqlx::query("update studies set state_seal = null, state = ?, finished = ? where id = ?")
            .bind(state)
            .bind(finished)
            .bind(id);
    ended.execute(connection).await.expect("ends");
}

/// Rows of a point in the three tables that have any.
async fn rows(connection: &mut SqliteConnection, key: &str) -> [i64; 3] {
    let query = "select (select count(*) from evaluations where key = ?1),
                        (select count(*) from start_states where key = ?1),
                        (select count(*) from strain_fields where key = ?1)";
    let (a, b, c) = sqlx::query_as(query)
        .bind(key)
        .fetch_one(connection)
        .await
        .expect("reads");
    [a, b, c]
}

async fn names(connection: &mut SqliteConnection) -> Vec<String> {
    let query = "select name from studies order by name";
    let names = sqlx::query_scalar(query).fetch_all(connection).await;
    names.expect("reads")
}

fn before(time: &str) -> Retention {
    Retention {
        before: time.to_owned(),
        keeps_named: false,
    }
}

#[tokio::test]
async fn a_point_goes_with_the_last_study_that_has_it() {
    let (folder, store) = fresh().await;
    let mut tx = store.begin().await.expect("begins");
    let first = study(&mut tx, "first", &["a", "b"]).await;
    let second = study(&mut tx, "second", &["b"]).await;
    let points = remove_study(&mut tx, &first).await.expect("removes");
    assert_eq!(points, ["a", "b"]);
    assert_eq!(remove_points(&mut tx, &points).await.expect("removes"), 1);
    assert_eq!(rows(&mut tx, "a").await, [0; 3]);
    assert_eq!(rows(&mut tx, "b").await, [1; 3]);
    let found = study_rows::find(&mut tx, &first).await.expect("reads");
    assert_eq!(found, None);
    store.commit(tx, 0).await.expect("commits");
    let path = folder.path().join("test.db");
    let whole = upkeep::inspect(&path, &|_, _| {}).await.expect("reads");
    // These studies end without a word and a result; of points nothing is missing.
    let words = ["is done and has no result", "its events don't say so"];
    let faults = whole.faults.iter();
    let others = faults.filter(|fault| !words.iter().any(|word| fault.contains(word)));
    assert_eq!(others.collect::<Vec<_>>(), Vec::<&String>::new());

    let mut tx = store.begin().await.expect("begins");
    let points = remove_study(&mut tx, &second).await.expect("removes");
    assert_eq!(remove_points(&mut tx, &points).await.expect("removes"), 1);
    assert_eq!(rows(&mut tx, "b").await, [0; 3]);
}

#[tokio::test]
async fn a_design_of_a_sweep_goes_with_the_sweep_alone() {
    let (_folder, store) = fresh().await;
    let mut tx = store.begin().await.expect("begins");
    let [own, shared] = [
        study(&mut tx, "own", &[]).await,
        study(&mut tx, "shared", &[]).await,
    ];
    let mut sweeps = Vec::new();
    for designs in [vec![&own, &shared], vec![&shared]] {
        let sweep = sweep_rows::insert(&mut tx, "sweep", "{}", 0).await;
        let sweep = sweep.expect("inserts");
        for design in designs {
            let added = design_rows::add_design(&mut tx, &sweep, "d", &Map::new(), design).await;
            added.expect("adds");
        }
        sweeps.push(sweep);
    }
    // The database itself refuses to leave a design without its study.
    let mut refused = sqlx::Connection::begin(&mut *tx).await.expect("begins");
    assert!(remove_study(&mut refused, &own).await.is_err());
    refused.rollback().await.expect("is as before");

    let left = remove_sweep(&mut tx, &sweeps[0]).await.expect("removes");
    assert_eq!(left, [own]);
    let left = remove_sweep(&mut tx, &sweeps[1]).await.expect("removes");
    assert_eq!(left, [shared]);
}

#[tokio::test]
async fn pruning_takes_what_ended_before_and_what_an_interruption_left() {
    let (folder, store) = fresh().await;
    let path = folder.path().join("test.db");
    let mut tx = store.begin().await.expect("begins");
    let old = study(&mut tx, "old", &["a", "b"]).await;
    let young = study(&mut tx, "young", &["b"]).await;
    let interrupted = study(&mut tx, "interrupted", &["c"]).await;
    let waiting = study(&mut tx, "waiting", &[]).await;
    end(&mut tx, &old, "failed", "2026-01-02T00:00:00.000Z").await;
    end(&mut tx, &young, "done", "2026-01-03T00:00:00.000Z").await;
    end(&mut tx, &waiting, "queued", "2026-01-01T00:00:00.000Z").await;
    let gone = remove_study(&mut tx, &interrupted).await;
    gone.expect("removes");
    store.commit(tx, 0).await.expect("commits");
    store.close().await.expect("closes");
    drop(store);

    let retention = before("2026-01-03T00:00:00.000Z");
    let expected = Pruned {
        studies: 1,
        points: 2,
        ..Pruned::default()
    };
    for (mode, removed) in [
        (Mode::Count, expected),
        (Mode::Remove, expected),
        (Mode::Remove, Pruned::default()),
    ] {
        let pruned = prune(&path, &retention, mode).await.expect("prunes");
        assert_eq!(pruned, removed, "{mode:?}");
    }
    let store = crate::Store::open(&path).await.expect("opens");
    let mut tx = store.begin().await.expect("begins");
    assert_eq!(names(&mut tx).await, ["waiting", "young"]);
    assert_eq!(rows(&mut tx, "b").await, [1; 3]);
}

#[tokio::test]
async fn the_newest_result_of_each_name_may_stay() {
    let (folder, store) = fresh().await;
    let path = folder.path().join("test.db");
    let mut tx = store.begin().await.expect("begins");
    for name in ["wall", "wall", "cord"] {
        study(&mut tx, name, &[]).await;
    }
    let failed = study(&mut tx, "cord", &[]).await;
    end(&mut tx, &failed, "failed", "2026-01-01T00:00:00.000Z").await;
    store.commit(tx, 0).await.expect("commits");
    store.close().await.expect("closes");
    drop(store);

    let retention = Retention {
        keeps_named: true,
        ..before("2026-06-01T00:00:00.000Z")
    };
    let pruned = prune(&path, &retention, Mode::Remove).await;
    assert_eq!(pruned.expect("prunes").studies, 2);
    let store = crate::Store::open(&path).await.expect("opens");
    let mut tx = store.begin().await.expect("begins");
    assert_eq!(names(&mut tx).await, ["cord", "wall"]);
}
