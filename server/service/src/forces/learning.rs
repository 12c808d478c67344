//! An estimator that is being learnt: its process, and how far that is.

use std::process::Command;
use std::sync::Arc;
use std::sync::atomic::{AtomicU8, Ordering};
use std::sync::{Mutex, PoisonError};
use std::thread;

use document::fault::Fault;
use store::queue::estimator_parts::Part;
use store::queue::estimator_rows::EstimatorRow;
use tokio::sync::oneshot;

use crate::forces::fit_process::{FitOrder, Unlearnt, learn};
use crate::forces::fitting::FitFailure;
use crate::forces::learnt_parts::parts;
use crate::wire::estimator_wire::FitProgress;
use crate::work::memory_share::TakenMemory;
use crate::work::own_process::Wish;

/// Ending of the work on an estimator.
#[derive(Debug)]
pub(crate) enum Ending {
    /// Parts that were learnt.
    Learnt(Vec<(Part, String)>),
    /// Failure, a sentence.
    Failed(String),
    /// End of its process by what it learnt: how.
    Crashed(String),
    /// Stop on request.
    Stopped,
}

/// An estimator whose process works or rests.
pub(crate) struct Learning {
    pub row: EstimatorRow,
    pub work: Arc<FitWork>,
    ended: oneshot::Receiver<Ending>,
}

impl Learning {
    /// Starts a process by the command, and a thread that listens to it; the memory is given back with its end.
    pub(crate) fn start(
        row: EstimatorRow,
        command: Command,
        order: FitOrder,
        memory: TakenMemory,
    ) -> Self {
        let (tell, ended) = oneshot::channel();
        let work = Arc::new(FitWork::default());
        let shared = work.clone();
        let attend = move || {
            let ending = ending(command, &order, &shared);
            drop(memory);
            // The receiver is gone when the service ends first.
            let _ = tell.send(ending);
        };
        // Without a thread the receiver is told nothing, which is an ending too.
        let _ = thread::Builder::new().name("fit".to_owned()).spawn(attend);
        Self { row, work, ended }
    }

    /// Waits for its end.
    pub(crate) async fn ended(&mut self) -> Ending {
        let ended = (&mut self.ended).await;
        ended.unwrap_or_else(|_| {
            Ending::Failed("no thread could attend to the fit's process".to_owned())
        })
    }
}

/// State that a fit and those who look at it share.
#[derive(Debug, Default)]
pub(crate) struct FitWork {
    wish: AtomicU8,
    progress: Mutex<FitProgress>,
}

const GO_ON: u8 = 0;
const REST: u8 = 1;
const STOP: u8 = 2;

impl FitWork {
    /// Has its process end at once.
    pub(crate) fn stop(&self) {
        self.wish.store(STOP, Ordering::Relaxed);
    }

    /// Has its process rest, unless it is to end.
    pub(crate) fn rest(&self) {
        self.turn(GO_ON, REST);
    }

    /// Has its process go on after a rest, unless it is to end.
    pub(crate) fn go_on(&self) {
        self.turn(REST, GO_ON);
    }

    /// Returns how far it is.
    pub(crate) fn progress(&self) -> FitProgress {
        *self.progress.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn turn(&self, from: u8, to: u8) {
        let _ = self
            .wish
            .compare_exchange(from, to, Ordering::Relaxed, Ordering::Relaxed);
    }

    fn wish(&self) -> Wish {
        match self.wish.load(Ordering::Relaxed) {
            GO_ON => Wish::GoOn,
            REST => Wish::Rest,
            _ => Wish::Stop,
        }
    }

    /// Takes note of what was told; threads tell in any order.
    fn told(&self, told: FitProgress) {
        let mut progress = self.progress.lock().unwrap_or_else(PoisonError::into_inner);
        if told.stage != progress.stage || told.done > progress.done {
            *progress = told;
        }
    }
}

fn ending(command: Command, order: &FitOrder, work: &FitWork) -> Ending {
    let learnt = learn(command, order, &|| work.wish(), &|told| work.told(told));
    match learnt {
        Ok(learnt) => parts(&learnt).map_or_else(Ending::Failed, Ending::Learnt),
        Err(Unlearnt::Failed(FitFailure::Input(faults))) => Ending::Failed(sentence(&faults)),
        Err(Unlearnt::Failed(FitFailure::Other(detail))) => Ending::Failed(detail),
        Err(Unlearnt::Stopped) => Ending::Stopped,
        Err(Unlearnt::Crashed(detail)) => Ending::Crashed(detail),
    }
}

/// Faults in one sentence.
pub(crate) fn sentence(faults: &[Fault]) -> String {
    let faults: Vec<String> = faults.iter().map(Fault::to_string).collect();
    faults.join("; ")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::wire::estimator_wire::FitStage;

    #[test]
    fn faults_become_one_sentence() {
        let fault = |pointer: &str| Fault {
            pointer: pointer.to_owned(),
            detail: "is wrong".to_owned(),
        };
        assert_eq!(
            sentence(&[fault("/a"), fault("")]),
            "/a: is wrong; is wrong"
        );
    }

    #[test]
    fn a_wish_to_stop_outlasts_turns() {
        let work = FitWork::default();
        work.rest();
        assert_eq!(work.wish(), Wish::Rest);
        work.go_on();
        assert_eq!(work.wish(), Wish::GoOn);
        work.stop();
        work.rest();
        work.go_on();
        assert_eq!(work.wish(), Wish::Stop);
    }

    #[test]
    fn progress_goes_forward_and_from_stage_to_stage() {
        let work = FitWork::default();
        let told = |stage, done| FitProgress { stage, done, of: 3 };
        for (stage, done, seen) in [
            (FitStage::Judging, 0, 0),
            (FitStage::Judging, 2, 2),
            (FitStage::Judging, 1, 2),
            (FitStage::Learning, 0, 0),
        ] {
            work.told(told(stage, done));
            assert_eq!(work.progress(), told(stage, seen));
        }
    }
}
