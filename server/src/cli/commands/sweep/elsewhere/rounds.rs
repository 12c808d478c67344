//! Rounds of tasks, one after the other, until a sweep lacks nothing or three brought too little.
//!
//! Each round has what is still lacking, in shorter tasks than the last. So a task that was lost is done again, and what ends the program each time is found in ever smaller company;
//! what is left after that is solved here, where such a point costs itself alone.

use std::collections::BTreeMap;
use std::fmt::Display;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

use document::visible::visible;
use fem_client::solver::Solver;
use indicatif::ProgressBar;
use tokio::runtime::Runtime;

use super::engine::{Engine, Standing};
use super::round::{Round, place};
use crate::cli::commands::sweep::tasks::gathering::gather;
use crate::cli::commands::sweep::tasks::packing::{Given, write};
use crate::cli::commands::sweep::tasks::task_folder::TaskFolder;
use crate::cli::terminal::exit::Failure;
use crate::cli::terminal::output::warn;
use crate::cli::terminal::progress::{count, counting_bar};
use crate::cli::terminal::report::next_steps::shell_word;

/// Rounds that are tried before the rest is solved here.
const MOST: usize = 3;
/// Shortest and longest interval at which an engine is asked.
const ASKED_EVERY: [Duration; 2] = [Duration::from_millis(500), Duration::from_secs(10)];
/// Longest time that tasks have to hand in what they have.
const PATIENCE: Duration = Duration::from_secs(45);
/// Interval at which a user's wish to stop is looked for.
const MOMENT: Duration = Duration::from_millis(100);
/// Interval at which what was handed in is taken in.
const TAKEN_EVERY: Duration = Duration::from_secs(10);

/// Rounds of a sweep's tasks.
pub(crate) struct Rounds<'r> {
    pub runtime: &'r Runtime,
    pub database: &'r Path,
    /// Identifier of the sweep.
    pub sweep: &'r str,
    /// Folder of its rounds.
    pub folder: PathBuf,
    pub solver: Arc<dyn Solver>,
    /// Tells what the sweep lacks, in tasks of so many minutes; the database is closed again when it returns.
    pub lacking: Box<dyn Fn(f64) -> Result<Vec<Given>, Failure> + 'r>,
    pub minutes: f64,
    pub stop: &'r AtomicBool,
}

/// Outcome of a round.
#[derive(Debug, Default)]
struct Outcome {
    /// Designs that have ended, of the tasks that were looked at.
    ended: BTreeMap<usize, usize>,
    is_refused: bool,
}

impl Rounds<'_> {
    /// Goes on with the round that isn't over, then begins others while something is lacking.
    ///
    /// # Errors
    /// When the user stops it; when a folder or the database fails; when the engine is missing, full or refuses.
    pub fn solve(&self, engine: &mut dyn Engine) -> Result<(), Failure> {
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
            warn(&format!(
                "what was refused is kept in {}\n",
                self.folder.display()
            ));
            return Ok(());
        }
        // Nothing of it is needed once it is in the database.
        let _ = fs::remove_dir_all(&self.folder);
        Ok(())
    }

    /// Writes the next round, whole or not at all; none when nothing is lacking.
    fn made(&self, number: usize, minutes: f64) -> Result<Option<Round>, Failure> {
        let given = (self.lacking)(minutes).map_err(|failure| self.resumable(&failure))?;
        if given.is_empty() {
            return Ok(None);
        }
        let failed = |error: std::io::Error| {
            Failure::Other(format!(
                "{} can't be written: {error}",
                self.folder.display()
            ))
        };
        fs::create_dir_all(&self.folder).map_err(failed)?;
        let unfinished = self.folder.join(format!("{number}.unfinished"));
        if unfinished.exists() {
            fs::remove_dir_all(&unfinished).map_err(failed)?;
        }
        let tasks = (self.solver.version(), self.sweep.to_owned(), given);
        write(self.runtime, self.database, &unfinished, tasks)?;
        let finished = place(&self.folder, number);
        fs::rename(&unfinished, &finished).map_err(failed)?;
        let (folder, tasks) = TaskFolder::open(&finished)?;
        Ok(Some(Round::new(folder, tasks, number)))
    }

    /// Has an engine do a round, and takes in what comes of it.
    fn work_off(&self, engine: &mut dyn Engine, mut round: Round) -> Result<Outcome, Failure> {
        engine
            .begin(&round.work())
            .map_err(|failure| self.resumable(&failure))?;
        let designs: usize = round
            .tasks
            .tasks
            .iter()
            .map(|task| task.studies.len())
            .sum();
        let bar = counting_bar(designs, "designs elsewhere");
        let mut outcome = Outcome::default();
        let worked = self.watch(engine, &mut round, (&bar, designs), &mut outcome);
        bar.finish_and_clear();
        worked?;
        self.say_refusals(&round);
        round.close()?;
        Ok(outcome)
    }

    fn watch(
        &self,
        engine: &mut dyn Engine,
        round: &mut Round,
        (bar, designs): (&ProgressBar, usize),
        outcome: &mut Outcome,
    ) -> Result<(), Failure> {
        let (mut pause, mut taken, mut silent) = (ASKED_EVERY[0], Instant::now(), false);
        loop {
            if self.waited(pause) {
                self.ended(engine, round);
                self.take_in(round, outcome)?;
                return Err(self.resumable(&"stopped; what came of the tasks is kept"));
            }
            pause = (2 * pause).min(ASKED_EVERY[1]);
            let standing = engine.standing(&round.work());
            if let Err(words) = &standing
                && !std::mem::replace(&mut silent, true)
            {
                warn(&format!("{words}; waiting until it answers\n"));
            }
            let is_over = standing.as_ref().is_ok_and(Standing::is_over);
            silent &= standing.is_err();
            if is_over || taken.elapsed() > TAKEN_EVERY {
                self.take_in(round, outcome)?;
                taken = Instant::now();
                count(bar, outcome.ended.values().sum(), designs);
            }
            if let Ok(Standing {
                waiting,
                running,
                because,
            }) = standing
            {
                let because =
                    because.map_or(String::new(), |because| format!(" ({})", visible(&because)));
                bar.set_message(format!("{waiting} tasks wait{because}, {running} run"));
            }
            if is_over {
                return Ok(());
            }
            // What goes on then is done already: a task of a node that was lost, and begun again.
            if outcome.ended.values().sum::<usize>() == designs {
                self.ended(engine, round);
                return Ok(());
            }
        }
    }

    /// Waits, and says whether the user asked to stop.
    fn waited(&self, pause: Duration) -> bool {
        let begun = Instant::now();
        while begun.elapsed() < pause {
            if self.stop.load(Ordering::Relaxed) {
                return true;
            }
            std::thread::sleep(MOMENT);
        }
        self.stop.load(Ordering::Relaxed)
    }

    /// Takes in what was handed in since the last time.
    fn take_in(&self, round: &mut Round, outcome: &mut Outcome) -> Result<(), Failure> {
        let new = round.handed_in();
        if new.is_empty() {
            return Ok(());
        }
        let tasks = (&round.folder, &round.tasks);
        let gathered = self
            .runtime
            .block_on(gather(self.database, tasks, &new, &self.solver))?;
        for one in gathered {
            outcome.ended.insert(one.task, one.ended);
            if let Some(because) = one.refused {
                outcome.is_refused = true;
                warn(&format!("task {}: {because}\n", one.task));
            }
        }
        Ok(())
    }

    /// Says which nodes handed in nothing, and why.
    fn say_refusals(&self, round: &Round) {
        let refusals =
            (1..=round.tasks.tasks.len()).filter_map(|number| round.folder.refusal(number));
        let mut said = BTreeMap::new();
        for refusal in refusals {
            said.insert(refusal.node, refusal.because);
        }
        for because in said.values() {
            warn(&format!("{}\n", visible(because)));
        }
    }

    /// Ends a round's tasks, and waits until those at work have handed in what they have.
    fn ended(&self, engine: &mut dyn Engine, round: &Round) {
        engine.cancel(&round.work());
        let begun = Instant::now();
        let is_over =
            |standing: Result<Standing, _>| standing.is_ok_and(|standing| standing.is_over());
        while begun.elapsed() < PATIENCE && !is_over(engine.standing(&round.work())) {
            std::thread::sleep(ASKED_EVERY[0]);
        }
    }

    /// A failure after which the sweep goes on where it was.
    fn resumable(&self, because: &dyn Display) -> Failure {
        let (because, database) = (because.to_string(), shell_word(self.database));
        Failure::Other(format!(
            "{}: strainsite sweep --resume {} --db {database} goes on here, and with --engine there",
            because.trim_end(),
            self.sweep
        ))
    }
}
