//! Estimate of a study before anything is solved: solves, time, memory, and the accuracy to expect.
//!
//! [`Workload::of`] lists the solves, `solve_time` says how long each takes, and [`estimate`] adds them up for a machine and a database that may have
//! some of them already. [`Pace`] corrects that while a study runs, and [`NextLevel`] says what a surer answer would take. All of it is a function of its arguments: who asks brings what was measured and what is known.

mod accuracy;
mod database_room;
mod estimated_cost;
mod lone_memory;
mod next_level;
mod pace;
mod peak_memory;
mod solve_time;
mod workload;

pub use self::estimated_cost::estimate;
pub use self::lone_memory::solve_memory_bytes;
pub use self::next_level::NextLevel;
pub use self::pace::Pace;
pub use self::solve_time::{Machine, Sample};
pub use self::workload::Workload;
pub(crate) use self::workload::rungs;
