//! Designs of a sweep that other machines solve, as tasks; whoever starts programs there is an engine.
//!
//! The modules, in reading order:
//!
//! - [`task_folder`]: what lies in the folder of a sweep's tasks
//! - [`grouping`]: designs that share points
//! - [`packing`]: what a sweep lacks, packed into tasks and written there
//! - [`handing_in`]: what a machine hands in of its task
//! - `checking`: a point of each task is solved again here
//! - [`gathering`]: takes in what was done
//! - [`engines`]: Slurm, or a command of the user's
//! - [`rounds`]: tasks that are begun, watched and taken in, until a sweep lacks nothing
//! - [`away`]: sweeps of a service that are given to an engine
//! - [`task_error`]: why something can't be made, done or taken in

pub mod away;
mod checking;
pub mod engines;
pub mod gathering;
pub mod grouping;
pub mod handing_in;
pub mod packing;
pub mod rounds;
pub mod task_error;
pub mod task_folder;
