//! Statements that copy rows of an attached database, `other`, which was read whole and has the same tables.

use sqlx::SqliteConnection;

use super::parts::{Counted, Merged, Taken};
use crate::clock::now;
use crate::seals;
use crate::store_error::StoreError;

/// Points, and what is kept beside them.
const POINTS: &str =
    "insert into main.evaluations (key, scene, response, failure, cost, sha256, created)
     select key, scene, response, failure, cost, sha256, ?1 from other.evaluations
     where key not in (select key from main.evaluations)";
const STRAIN_FIELDS: &str = "insert into main.strain_fields select * from other.strain_fields
     where key not in (select key from main.strain_fields)";
const START_STATES: &str = "insert into main.start_states select * from other.start_states
     where key not in (select key from main.start_states)";

/// Runs of models that aren't here, or failed here alone.
const MODEL_RUNS: &str = "insert or replace into main.model_runs select o.* from other.model_runs o left join main.model_runs m on m.key = o.key
     where m.key is null or m.outputs is null and o.outputs is not null";

/// Studies that come to an end by what the other database has of them: those that aren't here, and those that are and have none, or failed where they are done there; cancelled ones where that is asked.
const ENDING: &str = "create temp table ending as
     select o.id, m.id is not null as is_known from other.studies o left join main.studies m on m.id = o.id
     where o.state = 'done' and m.state is not 'done' and (?1 or m.state is not 'cancelled') or o.state = 'failed' and (m.state is null or m.state in ('queued', 'running'))";
/// A study's place is at the end of the ring of turns.
const STUDIES: &str = "insert into main.studies
     (id, name, spec, spec_sha256, state, priority, place, points_total, points_done, estimate, error, created, started, finished, archived)
     select id, name, spec, spec_sha256, state, priority,
         (select coalesce(max(place), 0) from main.studies) + row_number() over (order by id),
         points_total, iif(?1, points_done, 0), estimate, error, created, started, finished, archived
     from other.studies where id in (select id from ending where not is_known)";
const ENDED_STUDIES: &str = "update main.studies set state_seal = null, state = o.state, points_total = o.points_total,
         points_done = iif(?1, o.points_done, 0), estimate = o.estimate, error = o.error, started = o.started, finished = o.finished
     from other.studies o where o.id = studies.id and studies.id in (select id from ending where is_known)";
const STUDY_POINTS: &str = "insert into main.study_points select * from other.study_points
     where study in (select id from ending) on conflict do nothing";
/// Events come behind those that a study has, each with a number of its own; of its solved points where those come.
const EVENTS: &str = "with coming as (
         select (select coalesce(max(seq), 0) from main.sqlite_sequence where name = 'events') + row_number() over (order by id) as id,
             study, kind, payload, created
         from other.events o where study in (select id from ending)
         and (kind <> 'queued' or study not in (select study from main.events)) and (?1 or kind <> 'point-solved'))
     insert into main.events (id, study, previous, kind, payload, created)
     select id, study, coalesce(lag(id) over (partition by study order by id), (select max(m.id) from main.events m where m.study = coming.study)),
         kind, payload, created
     from coming order by id";
const RESULTS: &str =
    "insert into main.results select * from other.results where study in (select id from ending)";
const RESULT_MAPS: &str = "insert into main.result_maps select * from other.result_maps where study in (select id from ending)";
const RESULT_EXTRACTS: &str = "insert into main.result_extracts select * from other.result_extracts where study in (select id from ending)";

/// Sweeps all of whose designs are here by now.
const SWEEPS: &str = "insert into main.sweeps select * from other.sweeps where id not in (select id from main.sweeps)
     and not exists (select 1 from other.sweep_designs where sweep = other.sweeps.id and study not in (select id from main.studies))";
const SWEEP_DESIGNS: &str = "insert into main.sweep_designs select * from other.sweep_designs
     where sweep in (select id from main.sweeps) on conflict do nothing";
const TRADES: &str = "insert into main.trades (spec_sha256, document, document_sha256, created)
     select spec_sha256, document, document_sha256, created from other.trades o
     where not exists (select 1 from main.trades m where m.spec_sha256 = o.spec_sha256 and m.document_sha256 = o.document_sha256)";

/// Estimators that have ended, then what belongs to them.
const LEARNT: &str = "create temp table learnt as select id from other.estimators
     where state in ('done', 'failed') and id not in (select id from main.estimators)";
const ESTIMATORS: &str = "insert into main.estimators select * from other.estimators where id in (select id from learnt)";
const OF_ESTIMATORS: [&str; 3] = [
    "insert into main.estimator_recordings select * from other.estimator_recordings where estimator in (select id from learnt)",
    "insert into main.estimator_parts select * from other.estimator_parts where estimator in (select id from learnt)",
    "insert into main.estimator_zeros select * from other.estimator_zeros where estimator in (select id from learnt)",
];

/// Takes what there is, and counts it.
pub(super) async fn take(
    connection: &mut SqliteConnection,
    taken: Taken,
) -> Result<Merged, StoreError> {
    let mut merged = Merged::default();
    let is = |any: &[Taken]| any.contains(&taken);
    let with_points = taken.has_points();
    if with_points {
        merged.points = points(connection).await?;
    }
    if is(&[Taken::Everything, Taken::Points]) {
        let new = run(connection, MODEL_RUNS, None).await?;
        merged.model_runs =
            counted(connection, "select count(*) from other.model_runs", new).await?;
    }
    if taken != Taken::Points {
        // A machine may be done with what was cancelled meanwhile.
        let and_cancelled = !is(&[Taken::Solved, Taken::Answers]);
        (merged.studies, merged.ended) = studies(connection, with_points, and_cancelled).await?;
    }
    if is(&[Taken::Everything, Taken::Results]) {
        let new = run(connection, SWEEPS, None).await?;
        run(connection, SWEEP_DESIGNS, None).await?;
        merged.sweeps = counted(connection, "select count(*) from other.sweeps", new).await?;
        let new = run(connection, TRADES, None).await?;
        merged.trades = counted(connection, "select count(*) from other.trades", new).await?;
    }
    if taken == Taken::Everything {
        merged.estimators = estimators(connection).await?;
    }
    seals::close(connection).await?;
    Ok(merged)
}

async fn points(connection: &mut SqliteConnection) -> Result<Counted, StoreError> {
    let stored = sqlx::query(POINTS).bind(now()).execute(&mut *connection);
    let new = stored.await?.rows_affected();
    run(connection, STRAIN_FIELDS, None).await?;
    run(connection, START_STATES, None).await?;
    counted(connection, "select count(*) from other.evaluations", new).await
}

/// Studies, and how many of the new ones were known.
async fn studies(
    connection: &mut SqliteConnection,
    with_points: bool,
    and_cancelled: bool,
) -> Result<(Counted, u64), StoreError> {
    run(connection, ENDING, Some(and_cancelled)).await?;
    let new = run(connection, STUDIES, Some(with_points)).await?;
    let ended = run(connection, ENDED_STUDIES, Some(with_points)).await?;
    if with_points {
        run(connection, STUDY_POINTS, None).await?;
    }
    run(connection, EVENTS, Some(with_points)).await?;
    run(connection, RESULTS, None).await?;
    run(connection, RESULT_MAPS, None).await?;
    run(connection, RESULT_EXTRACTS, None).await?;
    run(connection, "drop table temp.ending", None).await?;
    let all = "select count(*) from other.studies where state in ('done', 'failed')";
    Ok((counted(connection, all, new + ended).await?, ended))
}

async fn estimators(connection: &mut SqliteConnection) -> Result<Counted, StoreError> {
    run(connection, LEARNT, None).await?;
    let new = run(connection, ESTIMATORS, None).await?;
    for of_estimators in OF_ESTIMATORS {
        run(connection, of_estimators, None).await?;
    }
    run(connection, "drop table temp.learnt", None).await?;
    let all = "select count(*) from other.estimators where state in ('done', 'failed')";
    counted(connection, all, new).await
}

/// Runs a statement, which may ask a question; returns how many rows it changed.
async fn run(
    connection: &mut SqliteConnection,
    statement: &'static str,
    is: Option<bool>,
) -> Result<u64, StoreError> {
    let query = sqlx::query(statement);
    let query = match is {
        Some(is) => query.bind(is),
        None => query,
    };
    Ok(query.execute(connection).await?.rows_affected())
}

/// All rows of a kind, of which so many are new.
async fn counted(
    connection: &mut SqliteConnection,
    all: &'static str,
    new: u64,
) -> Result<Counted, StoreError> {
    let all: i64 = sqlx::query_scalar(all).fetch_one(connection).await?;
    Ok(Counted {
        new,
        known: u64::try_from(all).unwrap_or(0).saturating_sub(new),
    })
}
