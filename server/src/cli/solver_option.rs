//! `--solver` and its like: who solves.

use std::path::PathBuf;
use std::sync::Arc;
use std::time::Duration;

use clap::{Args, ValueEnum};
use fem_client::solver::Solver;
use service::solving::solver_choice::{NotInstalled, SolverName, solver};

use crate::config::seconds;

/// Solver that a command runs with.
#[derive(Debug, Clone, Args)]
pub struct SolverOption {
    /// Solver: this program's own finite elements, or an installed CalculiX
    #[arg(
        long,
        env = "STRAINSITE_SOLVER",
        value_enum,
        value_name = "NAME",
        default_value = "embedded"
    )]
    solver: Name,
    /// CalculiX's program, for --solver calculix
    #[arg(
        long,
        env = "STRAINSITE_CCX",
        value_name = "PROGRAM",
        default_value = "ccx"
    )]
    ccx: PathBuf,
    /// Longest time of one solve, seconds: a point that takes longer goes without an answer
    #[arg(
        long,
        env = "STRAINSITE_SOLVE_LIMIT_S",
        value_name = "SECONDS",
        default_value = "3600",
        value_parser = seconds
    )]
    solve_limit_s: Duration,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Name {
    Embedded,
    Calculix,
}

impl SolverOption {
    /// Whether a solve hands over its mesh and its equilibrium.
    pub(crate) fn keeps_equilibria(&self) -> bool {
        self.solver == Name::Embedded
    }

    /// The solver.
    ///
    /// # Errors
    /// When CalculiX is asked for and isn't installed.
    pub fn solver(&self) -> Result<Arc<dyn Solver>, NotInstalled> {
        let name = match self.solver {
            Name::Embedded => SolverName::Embedded,
            Name::Calculix => SolverName::Calculix(&self.ccx),
        };
        solver(name, self.solve_limit_s)
    }
}
