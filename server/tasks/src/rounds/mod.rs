//! Rounds of tasks, one after the other, until a sweep lacks nothing or three brought too little.
//!
//! Each round has what is still lacking, in shorter tasks than the last. So a task that was lost is done again, and what ends the program each time is found in ever smaller company;
//! what is left after that is solved at home, where such a point costs itself alone.
//!
//! - [`head`]: database and wishes of whoever asked for the sweep
//! - `round`: one folder of tasks, from its making until nothing of it runs

pub mod head;
mod round;

use std::collections::BTreeMap;
use std::fs;
use std::path::PathBuf;
use std::sync::Arc;
use std::time::{Duration, Instant};

use fem_client::solver::Solver;
use tokio::runtime::Handle;

use crate::engines::{Engine, Standing};
use crate::gathering::gather;
use crate::packing::write;
use crate::task_error::TaskError;
use crate::task_folder::{Kept, Refusal, TaskFolder};
use head::{Head, Told, Wish};
use round::{Round, place};

/// Rounds that are tried before the rest is solved at home.
const MOST: usize = 3;
/// Shortest and longest interval at which an engine is asked.
const ASKED_EVERY: [Duration; 2] = [Duration::from_millis(500), Duration::from_secs(10)];
/// Longest time that tasks have to hand in what they have.
const PATIENCE: Duration = Duration::from_secs(45);
/// Interval at which wishes are looked for.
const MOMENT: Duration = Duration::from_millis(100);
/// Interval at which what was handed in is taken in.
const TAKEN_EVERY: Duration = Duration::from_secs(10);

/// Rounds of a sweep's tasks.
pub struct Rounds<'r> {
    /// Runtime of the database.
    pub runtime: &'r Handle,
    /// Database and wishes.
    pub head: &'r dyn Head,
    /// Identifier of the sweep.
    pub sweep: &'r str,
    /// Folder of its rounds.
    pub folder: PathBuf,
    /// Solver of the points that are compared.
    pub solver: Arc<dyn Solver>,
    /// Time that a task of the first round should take on this machine's threads, minutes.
    pub minutes: f64,
    /// Extent of what is kept of what tasks hand in.
    pub kept: Kept,
}

/// Outcome of a round.
#[derive(Debug, Default)]
struct Outcome {
    /// Designs that have ended, of the tasks that were looked at.
    ended: BTreeMap<usize, usize>,
    is_refused: bool,
}

impl Rounds<'_> {
    /// Goes on with the round that isn't over, then begins others while something is lacking. Blocks: call it on a plain thread.
    ///
    /// # Errors
    /// [`TaskError::Stopped`] when that is wished; when a folder or the database fails; when the engine is missing, full or refuses.
    pub fn solve(&self, engine: &mut dyn Engine) -> Result<(), TaskError> {
        let (mut open, before) = Round::last(&self.folder)?;
        let (mut number, mut is_refused) = (before, false);
        let mut minutes = self.minutes;
        for _ in 0..MOST {
            let round = match open.take() {
                Some(round) => Some(round),
                None => {
                    number += 1;
                    self.made(number, minutes)?
                }
            };
            let Some(round) = round else {
                break;
            };
            is_refused |= self.work_off(engine, round)?.is_refused;
            minutes /= 2.0;
        }
        if is_refused {
            self.warn(&format!(
                "what was refused is kept in {}",
                self.folder.display()
            ));
            return Ok(());
        }
        // Nothing of it is needed once it is in the database.
        let _ = fs::remove_dir_all(&self.folder);
        Ok(())
    }

    /// Writes the next round, whole or not at all; none when nothing is lacking.
    fn made(&self, number: usize, minutes: f64) -> Result<Option<Round>, TaskError> {
        let given = self.head.lacking(minutes)?;
        if given.is_empty() {
            return Ok(None);
        }
        let failed = |error: std::io::Error| {
            TaskError::Failed(format!(
                "{} can't be written: {error}",
                self.folder.display()
            ))
        };
        fs::create_dir_all(&self.folder).map_err(failed)?;
        let unfinished = self.folder.join(format!("{number}.unfinished"));
        if unfinished.exists() {
            fs::remove_dir_all(&unfinished).map_err(failed)?;
        }
        let of = (self.solver.version(), self.sweep.to_owned(), self.kept);
        write(self.runtime, self.head.merging()?, &unfinished, of, given)?;
        let finished = place(&self.folder, number);
        fs::rename(&unfinished, &finished).map_err(failed)?;
        let (folder, tasks) = TaskFolder::open(&finished)?;
        Ok(Some(Round::new(folder, tasks, number)))
    }

    /// Has an engine do a round, and takes in what comes of it.
    fn work_off(&self, engine: &mut dyn Engine, mut round: Round) -> Result<Outcome, TaskError> {
        engine.begin(&round.work())?;
        let mut outcome = Outcome::default();
        self.head.told(Told::Begun {
            designs: round.designs(),
            tasks: round.tasks.tasks.len(),
        });
        let worked = self.watch(engine, &mut round, &mut outcome);
        self.head.told(Told::Over);
        worked?;
        for refusal in refusals(&round) {
            self.head.told(Told::Refused(&refusal));
        }
        round.close()?;
        Ok(outcome)
    }

    fn watch(
        &self,
        engine: &mut dyn Engine,
        round: &mut Round,
        outcome: &mut Outcome,
    ) -> Result<(), TaskError> {
        let (mut pause, mut taken, mut silent) = (ASKED_EVERY[0], Instant::now(), false);
        let designs = round.designs();
        loop {
            match self.wish_within(pause) {
                Wish::GoOn => {}
                Wish::Leave => return Err(TaskError::Stopped),
                Wish::Forget => {
                    self.end(engine, round);
                    let _ = fs::remove_dir_all(&self.folder);
                    return Err(TaskError::Stopped);
                }
                Wish::End => {
                    self.end(engine, round);
                    self.take_in(round, outcome)?;
                    return Err(TaskError::Stopped);
                }
            }
            pause = (2 * pause).min(ASKED_EVERY[1]);
            let standing = engine.standing(&round.work());
            if let Err(words) = &standing
                && !std::mem::replace(&mut silent, true)
            {
                self.warn(&format!("{words}; waiting until it answers"));
            }
            silent &= standing.is_err();
            let is_over = standing.as_ref().is_ok_and(Standing::is_over);
            if is_over || taken.elapsed() > TAKEN_EVERY {
                self.take_in(round, outcome)?;
                taken = Instant::now();
            }
            let ended = outcome.ended.values().sum();
            if let Ok(standing) = &standing {
                self.tell(standing, ended);
            }
            if is_over {
                return Ok(());
            }
            // What goes on then is done already: a task of a node that was lost, and begun again.
            if ended == designs {
                self.end(engine, round);
                return Ok(());
            }
        }
    }

    fn tell(&self, standing: &Standing, ended: usize) {
        self.head.told(Told::Standing { standing, ended });
        if let Some(news) = &standing.news {
            self.warn(news);
        }
    }

    fn warn(&self, words: &str) {
        self.head.told(Told::Warned(words));
    }

    /// Waits while nothing else is wished.
    fn wish_within(&self, pause: Duration) -> Wish {
        let begun = Instant::now();
        while begun.elapsed() < pause {
            let wish = self.head.wish();
            if wish != Wish::GoOn {
                return wish;
            }
            std::thread::sleep(MOMENT);
        }
        self.head.wish()
    }

    /// Takes in what was handed in since the last time.
    fn take_in(&self, round: &mut Round, outcome: &mut Outcome) -> Result<(), TaskError> {
        let new = round.handed_in();
        if new.is_empty() {
            return Ok(());
        }
        let tasks = (&round.folder, &round.tasks);
        let solver = (&self.solver, self.kept);
        let gathering = gather(self.head.merging()?, tasks, &new, solver, &|_, _| {});
        for one in self.runtime.block_on(gathering)? {
            outcome.ended.insert(one.task, one.ended);
            if let Some(because) = one.refused {
                outcome.is_refused = true;
                self.warn(&format!("task {}: {because}", one.task));
            }
        }
        Ok(())
    }

    /// Ends a round's tasks, and waits until those at work have handed in what they have.
    fn end(&self, engine: &mut dyn Engine, round: &Round) {
        if let Err(words) = engine.cancel(&round.work()) {
            self.warn(&words);
        }
        let begun = Instant::now();
        let is_over =
            |standing: Result<Standing, _>| standing.is_ok_and(|standing| standing.is_over());
        while begun.elapsed() < PATIENCE && !is_over(engine.standing(&round.work())) {
            std::thread::sleep(ASKED_EVERY[0]);
        }
    }
}

/// Reasons of the nodes that handed in nothing, one of each.
fn refusals(round: &Round) -> Vec<Refusal> {
    let all = (1..=round.tasks.tasks.len()).filter_map(|number| round.folder.refusal(number));
    let by_node: BTreeMap<String, Refusal> = all.map(|one| (one.node.clone(), one)).collect();
    by_node.into_values().collect()
}
