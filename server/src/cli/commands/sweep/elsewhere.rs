//! `--engine` of `sweep` and `run`: other machines solve the designs, as tasks, before what is left is solved here.

use std::cell::RefCell;
use std::sync::atomic::{AtomicBool, Ordering};

use clap::Args;
use indicatif::ProgressBar;
use tokio::runtime::Runtime;

use crate::cli::commands::sweep::asked::with_engine;
use crate::cli::engine_options::EngineOptions;
use crate::cli::solver_option::SolverOption;
use crate::cli::terminal::exit::Failure;
use crate::cli::terminal::output::warn;
use crate::cli::terminal::progress::{count, counting_bar};
use crate::cli::terminal::report::next_steps::shell_word;
use crate::config::Config;
use document::visible::visible;
use store::merging::target::Merging;
use store::queue::sweep_rows::SweepRow;
use tasks::engines::engine_name::EngineName;
use tasks::engines::{Engine, Standing};
use tasks::packing::{Given, Packer, packed};
use tasks::rounds::Rounds;
use tasks::rounds::head::{Head, Told, Wish};
use tasks::task_error::TaskError;

/// Numbers of machines of which a dry run speaks.
const MACHINES: [usize; 4] = [1, 4, 16, 64];

/// Machines that solve designs, as the command line names them.
#[derive(Debug, Args)]
pub(crate) struct Elsewhere {
    /// Have other machines solve the designs before what is left is solved here
    #[arg(long, value_enum, value_name = "NAME")]
    engine: Option<EngineName>,
    #[command(flatten)]
    options: EngineOptions,
}

impl Elsewhere {
    /// Whether other machines are to solve anything.
    pub(crate) fn is_asked(&self) -> bool {
        self.engine.is_some()
    }

    /// The engine that is asked for.
    pub(crate) fn engine(&self) -> Result<Option<Box<dyn Engine>>, Failure> {
        let settings = self.options.settings();
        let engine = self.engine.map(|name| settings.engine(name));
        Ok(engine.transpose()?)
    }

    /// Has other machines solve what a sweep lacks; the database is free meanwhile.
    pub(crate) fn solve(
        &self,
        own: OwnMeans<'_>,
        sweep: &SweepRow,
        engine: &mut dyn Engine,
    ) -> Result<(), Failure> {
        let database = &own.config.db;
        let head = OwnHead {
            own,
            sweep: &sweep.id,
            shown: RefCell::default(),
        };
        let rounds = Rounds {
            runtime: own.runtime.handle(),
            head: &head,
            sweep: &sweep.id,
            folder: self.options.folder(database).join(&sweep.id),
            solver: own.solver.solver().map_err(Failure::other)?,
            minutes: self.options.minutes,
            kept: self.options.keep,
        };
        rounds.solve(engine).map_err(|error| {
            Failure::Other(format!(
                "{}: strainsite sweep --resume {} --db {} goes on here, and with --engine there",
                error.to_string().trim_end(),
                sweep.id,
                shell_word(database)
            ))
        })?;
        self.options.tidy(database);
        Ok(())
    }

    /// A line about the tasks of designs that take so long each on this machine, s, one after the other, and about machines like this one; none where no engine is asked for.
    pub(super) fn foreseen(&self, designs_s: &[f64]) -> String {
        if !self.is_asked() {
            return String::new();
        }
        let alone = (0..designs_s.len()).map(|design| vec![design]).collect();
        let most_s = 60.0 * self.options.minutes;
        let tasks = packed(alone, |design| designs_s[design], most_s);
        let tasks_s: Vec<f64> = tasks
            .iter()
            .map(|task| task.iter().map(|&design| designs_s[design]).sum())
            .collect();
        let longest_s = tasks_s.iter().copied().fold(0.0, f64::max);
        let all_s: f64 = tasks_s.iter().sum();
        // No machine is done before a task of it is, nor all of them before the work is.
        let by_machines = MACHINES.map(|count| {
            let time_s = (all_s / count as f64).max(longest_s);
            format!("{count}: {time_s:.0} s")
        });
        format!(
            "tasks for other machines: {}, the longest {longest_s:.0} s; on so many like this one they take {}, and what they wait for\n",
            tasks_s.len(),
            by_machines.join(", ")
        )
    }
}

/// Means of the command line to solve studies.
#[derive(Clone, Copy)]
pub(crate) struct OwnMeans<'m> {
    pub runtime: &'m Runtime,
    pub config: &'m Config,
    pub solver: &'m SolverOption,
    pub stop: &'m AtomicBool,
}

/// The command line as head of a sweep: it has the database for itself, and closes it while others work.
struct OwnHead<'h> {
    own: OwnMeans<'h>,
    sweep: &'h str,
    /// The bar of the round, and how many designs it has.
    shown: RefCell<Option<(ProgressBar, usize)>>,
}

impl Head for OwnHead<'_> {
    fn lacking(&self, minutes: f64) -> Result<Vec<Given>, TaskError> {
        let OwnMeans {
            runtime,
            config,
            solver,
            stop,
        } = self.own;
        let packed = with_engine(runtime, config, solver, |engine| {
            let packer = Packer {
                runtime: runtime.handle(),
                engine,
                minutes,
                stop,
            };
            Ok(packer.pack(self.sweep)?)
        });
        packed.map_err(|failure| TaskError::Failed(failure.to_string()))
    }

    fn merging(&self) -> Result<Merging, TaskError> {
        let database = &self.own.config.db;
        Ok(self.own.runtime.block_on(Merging::open(database))?)
    }

    fn wish(&self) -> Wish {
        match self.own.stop.load(Ordering::Relaxed) {
            true => Wish::End,
            false => Wish::GoOn,
        }
    }

    fn told(&self, told: Told<'_>) {
        let mut shown = self.shown.borrow_mut();
        match told {
            Told::Begun { designs, .. } => {
                *shown = Some((counting_bar(designs, "designs elsewhere"), designs));
            }
            Told::Standing { standing, ended } => {
                if let Some((bar, designs)) = &*shown {
                    count(bar, ended, *designs);
                    bar.set_message(message(standing));
                }
            }
            Told::Refused(refusal) => warn(&format!("{}\n", visible(&refusal.because))),
            Told::Warned(words) => warn(&format!("{words}\n")),
            Told::Over => {
                if let Some((bar, _)) = shown.take() {
                    bar.finish_and_clear();
                }
            }
        }
    }
}

fn message(standing: &Standing) -> String {
    let because = standing.because.as_deref().map(visible);
    let because = because.map_or(String::new(), |because| format!(" ({because})"));
    format!(
        "{} tasks wait{because}, {} run",
        standing.waiting, standing.running
    )
}
