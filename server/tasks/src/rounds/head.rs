//! Head of a sweep whose designs other machines solve: its database, and the wishes of whoever asked for it.

use store::merging::target::Merging;

use crate::engines::Standing;
use crate::packing::Given;
use crate::task_error::TaskError;
use crate::task_folder::Refusal;

/// Database of a sweep, and whoever asked for it.
pub trait Head {
    /// Tells what the sweep lacks, in tasks of so many minutes.
    ///
    /// # Errors
    /// When the database can't be read or written, or somebody wishes to stop.
    fn lacking(&self, minutes: f64) -> Result<Vec<Given>, TaskError>;

    /// The database, to write tasks from and to take them in.
    ///
    /// # Errors
    /// When it can't be opened.
    fn merging(&self) -> Result<Merging, TaskError>;

    /// Tells what is wished by now.
    fn wish(&self) -> Wish;

    /// Hears what happens.
    fn told(&self, told: Told<'_>);
}

/// Wish about tasks that wait and run.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Wish {
    /// Wish that they go on.
    GoOn,
    /// Leave them alone: somebody comes back later.
    Leave,
    /// End them, and take in what they have.
    End,
    /// End them, and take in nothing.
    Forget,
}

/// Event of a round.
#[derive(Debug, Clone, Copy)]
pub enum Told<'t> {
    /// The engine has a round of so many tasks, with so many designs.
    Begun {
        /// Designs of the round.
        designs: usize,
        /// Tasks that have them.
        tasks: usize,
    },
    /// State of the tasks, and how many designs have ended.
    Standing {
        /// Tasks that haven't ended.
        standing: &'t Standing,
        /// Designs of the round that have.
        ended: usize,
    },
    /// A node handed in nothing.
    Refused(&'t Refusal),
    /// News that somebody should know, a sentence.
    Warned(&'t str),
    /// The round is over.
    Over,
}
