//! The line against a model of it: any sequence of submissions, turns, ends, cancellations and crashes.

use proptest::prelude::*;
use proptest::test_runner::{Config, TestRunner};
use tokio::runtime::Runtime;

use super::*;
use crate::database::tests::fresh;
use crate::queue::study_rows::{self, State};

/// Sequences that are tried; the variable `STRAINSITE_QUEUE_SEQUENCES` asks for more.
const SEQUENCES: u32 = 2000;

/// Event in the line. A number picks one of the studies so far.
#[derive(Debug, Clone)]
enum Step {
    Submit { priority: i64 },
    TakeNext,
    PassOn(usize),
    Release(usize),
    Finish(usize, State),
    Cancel(usize),
    Crash,
}

fn step() -> impl Strategy<Value = Step> {
    let any = 0usize..8;
    prop_oneof![
        3 => (-1i64..=1).prop_map(|priority| Step::Submit { priority }),
        4 => Just(Step::TakeNext),
        3 => any.clone().prop_map(Step::PassOn),
        1 => any.clone().prop_map(Step::Release),
        2 => (any.clone(), prop_oneof![Just(State::Done), Just(State::Failed)])
            .prop_map(|(study, state)| Step::Finish(study, state)),
        1 => any.prop_map(Step::Cancel),
        1 => Just(Step::Crash),
    ]
}

/// A study as the model sees it.
#[derive(Debug, Clone)]
struct Modelled {
    id: String,
    priority: i64,
    place: usize,
    state: State,
}

/// The line as it should be.
#[derive(Default)]
struct Model {
    studies: Vec<Modelled>,
    last_place: usize,
}

impl Model {
    fn end_of_line(&mut self) -> usize {
        self.last_place += 1;
        self.last_place
    }

    fn next(&self) -> Option<&Modelled> {
        let waiting = self.studies.iter().filter(|s| s.state == State::Queued);
        waiting.min_by_key(|study| (-study.priority, study.place))
    }

    /// The study that a step picks, when there is one.
    fn picked(&self, pick: usize) -> Option<usize> {
        (!self.studies.is_empty()).then(|| pick % self.studies.len())
    }

    /// Moves a study from one state to another, when it is in the first; says whether.
    fn moved(&mut self, index: usize, from: &[State], to: State) -> bool {
        let fits = from.contains(&self.studies[index].state);
        if fits {
            self.studies[index].state = to;
        }
        fits
    }
}

/// Does a step in the database and in the model, and compares what both say.
async fn both(tx: &mut SqliteConnection, model: &mut Model, step: Step) {
    const RUNNING: [State; 1] = [State::Running];
    match step {
        Step::Submit { priority } => {
            let id = study_rows::insert(tx, "a", "{}").await.expect("inserts");
            set_priority(tx, &id, priority).await.expect("writes");
            let place = model.end_of_line();
            let state = State::Queued;
            model.studies.push(Modelled {
                id,
                priority,
                place,
                state,
            });
        }
        Step::TakeNext => {
            let expected = model.next().map(|study| study.id.clone());
            let found = next(tx).await.expect("reads");
            assert_eq!(found, expected);
            let Some(id) = found else { return };
            let row = claim(tx, &id).await.expect("claims").expect("was queued");
            assert_eq!(row.state(), State::Running);
            assert_eq!(claim(tx, &id).await.expect("claims"), None, "taken once");
            let taken = model.studies.iter_mut().find(|study| study.id == id);
            taken.expect("known").state = State::Running;
        }
        Step::PassOn(pick) => {
            let Some(index) = model.picked(pick) else {
                return;
            };
            let moved = pass_on(tx, &model.studies[index].id).await.expect("writes");
            assert_eq!(moved, model.moved(index, &RUNNING, State::Queued));
            if moved {
                model.studies[index].place = model.end_of_line();
            }
        }
        Step::Release(pick) => {
            let Some(index) = model.picked(pick) else {
                return;
            };
            let moved = release(tx, &model.studies[index].id).await.expect("writes");
            assert_eq!(moved, model.moved(index, &RUNNING, State::Queued));
        }
        Step::Finish(pick, state) => {
            let Some(index) = model.picked(pick) else {
                return;
            };
            let id = &model.studies[index].id;
            let moved = study_rows::finish(tx, id, state, None)
                .await
                .expect("writes");
            assert_eq!(moved, model.moved(index, &RUNNING, state));
        }
        Step::Cancel(pick) => {
            let Some(index) = model.picked(pick) else {
                return;
            };
            let id = &model.studies[index].id;
            let moved = study_rows::cancel(tx, id).await.expect("writes");
            let open = [State::Queued, State::Running];
            assert_eq!(moved, model.moved(index, &open, State::Cancelled));
        }
        Step::Crash => {
            for id in running(tx).await.expect("reads") {
                assert!(release(tx, &id).await.expect("writes"));
            }
            for index in 0..model.studies.len() {
                model.moved(index, &RUNNING, State::Queued);
            }
        }
    }
}

/// Every study is where the model has it, and waiting is known for every priority.
async fn agree(tx: &mut SqliteConnection, model: &Model) {
    let rows = study_rows::page(tx, study_rows::Filter::default(), None, 1000)
        .await
        .expect("reads");
    let mut found: Vec<_> = rows.iter().map(|row| (&row.id, row.state())).collect();
    let mut expected: Vec<_> = model.studies.iter().map(|s| (&s.id, s.state)).collect();
    found.sort_by_key(|(id, _)| id.as_str());
    expected.sort_by_key(|(id, _)| id.as_str());
    assert_eq!(found, expected);
    for priority in -1..=1 {
        let waiting = |s: &Modelled| s.state == State::Queued && s.priority >= priority;
        let expected = model.studies.iter().any(waiting);
        assert_eq!(is_awaited(tx, priority).await.expect("reads"), expected);
    }
}

#[test]
fn the_line_does_what_its_model_does() {
    let runtime = Runtime::new().expect("a runtime");
    let (_folder, store) = runtime.block_on(fresh());
    let asked = std::env::var("STRAINSITE_QUEUE_SEQUENCES").ok();
    let cases = asked.map_or(SEQUENCES, |text| text.parse().expect("a number"));
    let mut runner = TestRunner::new_with_rng(
        Config {
            cases,
            failure_persistence: None,
            ..Config::default()
        },
        proptest::test_runner::TestRng::deterministic_rng(
            proptest::test_runner::RngAlgorithm::ChaCha,
        ),
    );
    let sequences = proptest::collection::vec(step(), 1..40);
    let checked = runner.run(&sequences, |steps| {
        runtime.block_on(async {
            // Never committed: each sequence begins with an empty table, and the disk is left in peace.
            let mut tx = store.begin().await.expect("begins");
            let mut model = Model::default();
            for step in steps {
                both(&mut tx, &mut model, step).await;
            }
            agree(&mut tx, &model).await;
            tx.rollback().await.expect("rolls back");
        });
        Ok(())
    });
    checked.unwrap();
}

#[tokio::test]
async fn nobody_has_a_second_turn_before_all_have_had_one() {
    let (_folder, store) = fresh().await;
    let mut tx = store.begin().await.expect("begins");
    let mut ids = Vec::new();
    for name in ["a", "b", "c"] {
        let id = study_rows::insert(&mut tx, name, "{}").await;
        ids.push(id.expect("inserts"));
    }
    let mut turns = Vec::new();
    for _ in 0..2 * ids.len() {
        let id = next(&mut tx).await.expect("reads").expect("one waits");
        claim(&mut tx, &id).await.expect("claims");
        assert!(pass_on(&mut tx, &id).await.expect("writes"));
        turns.push(id);
    }
    assert_eq!(turns, [ids.clone(), ids].concat());
}

#[tokio::test]
async fn an_end_is_never_overwritten() {
    let (_folder, store) = fresh().await;
    let mut tx = store.begin().await.expect("begins");
    let id = study_rows::insert(&mut tx, "a", "{}").await;
    let id = id.expect("inserts");
    claim(&mut tx, &id).await.expect("claims");
    for cancelled in [true, false] {
        let done = study_rows::cancel(&mut tx, &id).await.expect("cancels");
        assert_eq!(done, cancelled);
    }
    let done = study_rows::finish(&mut tx, &id, State::Done, None).await;
    assert!(!done.expect("finishes"));
    assert!(!release(&mut tx, &id).await.expect("releases"));
    let row = study_rows::find(&mut tx, &id).await.expect("reads");
    assert_eq!(row.map(|row| row.state()), Some(State::Cancelled));
}
