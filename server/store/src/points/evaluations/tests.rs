use std::sync::atomic::AtomicBool;

use fem_client::closed_form::ClosedFormSolver;
use fem_client::scene::Scene;
use fem_client::solver::{
    Grid, NoEquilibrium, Reached, Readout, Response, RingLine, SolveRequest, Solver,
};
use results::Unsolved;

use placement::points::archive::Outcome;

use super::*;
use crate::database::tests::fresh;
use crate::queue::study_rows;

async fn found(connection: &mut SqliteConnection) -> Result<Option<Evaluation>, StoreError> {
    let mut found = find(connection, &["k".to_owned()]).await?;
    Ok(found.pop().flatten())
}

#[derive(serde::Deserialize)]
struct Force {
    reaction_n: f64,
}

/// A response with a map and two rings.
fn solved() -> (Outcome, Cost, StartState) {
    let (scene, stop) = (Scene::default(), AtomicBool::new(false));
    let readout = Readout {
        grid: Some(Grid {
            circumferential: 5,
            meridional: 3,
            half_width_deg: 20.0,
        }),
        positions: true,
        rings: [0.0, 90.0].map(RingLine::at).to_vec(),
        ..Readout::default()
    };
    let request = SolveRequest {
        scene: &scene,
        readout: &readout,
        start: None,
        watch: &stop,
    };
    let solved = ClosedFormSolver::new().solve(&request).expect("solves");
    (Ok(solved.response), solved.cost, solved.state)
}

fn response(outcome: &mut Outcome) -> &mut Response {
    outcome.as_mut().expect("a response")
}

fn record((outcome, cost, state): &(Outcome, Cost, StartState)) -> PointRecord<'_> {
    PointRecord {
        key: "k",
        ordinal: 3,
        scene: "{}",
        outcome,
        cost: *cost,
        start: outcome.is_ok().then_some(state),
    }
}

#[tokio::test]
async fn a_point_reads_back_bit_for_bit_and_is_written_once() {
    let (_folder, store) = fresh().await;
    let mut tx = store.begin().await.expect("begins");
    let study = study_rows::insert(&mut tx, "a", "{}")
        .await
        .expect("inserts");
    let first = solved();
    insert(&mut tx, &study, &record(&first))
        .await
        .expect("stores");
    let mut other = first.clone();
    response(&mut other.0).reaction_n += 1.0;
    insert(&mut tx, &study, &record(&other))
        .await
        .expect("is no error");

    let stored = found(&mut tx).await.expect("reads").expect("is there");
    assert_eq!((&stored.outcome, stored.cost), (&first.0, first.1));
    assert_eq!(
        find_start(&mut tx, "k").await.expect("reads"),
        Some(first.2)
    );
    let parts: Vec<(_, _, Evaluation<Force>)> = parts_of(&mut tx, &study).await.expect("reads");
    let [(3, key, part)] = &parts[..] else {
        panic!("one point, the third: {}", parts.len());
    };
    let force = part.outcome.as_ref().expect("a response").reaction_n;
    assert_eq!((key.as_str(), part.cost), ("k", first.1));
    assert_eq!(Ok(force), first.0.map(|response| response.reaction_n));
    // The third is known, the fourth is not, the fifth has no evaluation.
    let keys = ["k", "k", "absent"].map(str::to_owned);
    for new in [1, 0] {
        let linked = study_points::link(&mut tx, &study, 3, &keys).await;
        assert_eq!(linked.expect("links"), new);
    }
    let absent = find(&mut tx, &["absent".to_owned(), "k".to_owned()]).await;
    assert!(matches!(&absent.expect("reads")[..], [None, Some(_)]));
}

#[tokio::test]
async fn a_point_without_equilibrium_is_an_answer_like_any_other() {
    let (_folder, store) = fresh().await;
    let mut tx = store.begin().await.expect("begins");
    let study = study_rows::insert(&mut tx, "a", "{}")
        .await
        .expect("inserts");
    let unsolved = Unsolved {
        status: NoEquilibrium::Crushed,
        detail: "squeezed to 0.31 at 70.1 %".to_owned(),
        reached: Reached {
            pressure_mpa: 0.2,
            depths_mm: vec![0.1 + 0.2; 5],
            load_n: Some(13.1),
        },
    };
    let (_, cost, state) = solved();
    let failed = (Err(unsolved), cost, state);
    insert(&mut tx, &study, &record(&failed))
        .await
        .expect("stores");
    let stored = found(&mut tx).await.expect("reads").expect("is there");
    assert_eq!((stored.outcome, stored.cost), (failed.0, cost));
    assert_eq!(find_start(&mut tx, "k").await.expect("reads"), None);
    sqlx::query("update evaluations set failure = replace(failure, '70.1', '70.2')")
        .execute(&mut *tx)
        .await
        .expect("damages");
    assert!(matches!(
        found(&mut tx).await,
        Err(StoreError::Damaged { .. })
    ));
}

#[tokio::test]
async fn a_number_that_is_not_finite_is_not_stored() {
    let (_folder, store) = fresh().await;
    let mut tx = store.begin().await.expect("begins");
    let study = study_rows::insert(&mut tx, "a", "{}")
        .await
        .expect("inserts");
    let mut wrong = solved();
    response(&mut wrong.0).locations[2].strain.x = f64::NAN;
    let mut on_ring = solved();
    response(&mut on_ring.0).rings[1].strain.y[359] = f64::INFINITY;
    for wrong in [wrong, on_ring] {
        let refused = insert(&mut tx, &study, &record(&wrong)).await;
        assert!(matches!(refused, Err(StoreError::NotFinite { .. })));
        assert_eq!(found(&mut tx).await.expect("reads"), None);
    }
}

#[tokio::test]
async fn strain_fields_that_are_lost_changed_or_too_short_are_found() {
    let (_folder, store) = fresh().await;
    let mut tx = store.begin().await.expect("begins");
    let study = study_rows::insert(&mut tx, "a", "{}")
        .await
        .expect("inserts");
    insert(&mut tx, &study, &record(&solved()))
        .await
        .expect("stores");
    for damage in [
        "update strain_fields set lists = substr(lists, 1, length(lists) - 8)",
        "update strain_fields set sha256 = 'another'",
        "delete from strain_fields",
    ] {
        sqlx::query(damage)
            .execute(&mut *tx)
            .await
            .expect("damages");
        let damaged = found(&mut tx).await;
        let named = matches!(
            damaged,
            Err(StoreError::Damaged {
                table: "strain_fields",
                ..
            })
        );
        assert!(named, "{damage}");
    }
}

#[tokio::test]
async fn a_lost_or_changed_byte_is_found() {
    let (_folder, store) = fresh().await;
    let mut tx = store.begin().await.expect("begins");
    let study = study_rows::insert(&mut tx, "a", "{}")
        .await
        .expect("inserts");
    let solved = solved();
    insert(&mut tx, &study, &record(&solved))
        .await
        .expect("stores");
    sqlx::query("update start_states set state = substr(state, 1, length(state) - 1)")
        .execute(&mut *tx)
        .await
        .expect("damages");
    let damaged = find_start(&mut tx, "k").await;
    assert!(matches!(
        damaged,
        Err(StoreError::Damaged {
            table: "start_states",
            ..
        })
    ));
    sqlx::query("update evaluations set cost = replace(cost, 'wall_s', 'wall_t')")
        .execute(&mut *tx)
        .await
        .expect("damages");
    assert!(matches!(
        found(&mut tx).await,
        Err(StoreError::Damaged {
            table: "evaluations",
            ..
        })
    ));
}
