//! Solvers, and how a solve is watched.
//!
//! - [`solver_choice`]: which solver answers
//! - [`watched`]: solves that come to an end in time
//! - [`isolated`]: solves in a process of their own
//! - `apart`: solves that are all of this sort
//! - [`live`]: the solves under way
//! - [`numerics`]: solves told apart by the processor's last digits
//! - `awake_clock`: time without that during which the program was stopped
//! - `timekeeper`: how long they take beside what was expected
//! - `traced`: solves whose lines in the log say for which study

pub(crate) mod apart;
pub(crate) mod awake_clock;
pub mod isolated;
pub mod live;
pub mod numerics;
pub mod solver_choice;
pub(crate) mod timekeeper;
pub(crate) mod traced;
pub mod watched;

/// Forwards what a solver around another one, its field `solver`, has that one tell of scenes.
macro_rules! inner_tells {
    () => {
        fn coarser(&self, scene: &fem_client::scene::Scene) -> Option<fem_client::solver::Coarser> {
            self.solver.coarser(scene)
        }

        fn omissions(&self, scene: &fem_client::scene::Scene) -> Vec<fem_client::solver::Omission> {
            self.solver.omissions(scene)
        }

        fn cells(&self, scene: &fem_client::scene::Scene) -> usize {
            self.solver.cells(scene)
        }

        fn cells_read(
            &self,
            scene: &fem_client::scene::Scene,
            readout: &fem_client::solver::Readout,
        ) -> usize {
            self.solver.cells_read(scene, readout)
        }

        fn has_time_law(&self) -> bool {
            self.solver.has_time_law()
        }
    };
}

use inner_tells;
