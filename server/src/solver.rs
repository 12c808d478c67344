//! Which solver answers: chosen here and nowhere else.

use std::path::PathBuf;
use std::sync::Arc;
use std::time::Duration;

use calculix::{CalculixSolver, NotInstalled};
use clap::{Args, ValueEnum};
use fem_client::solver::Solver;
use tire::embedded::EmbeddedSolver;

use crate::config::seconds;
use crate::watched::Watched;

/// A Newton iteration on the largest mesh that is allowed takes seconds; what hasn't ended then won't.
const GRACE: Duration = Duration::from_secs(60);

/// Who solves.
#[derive(Debug, Clone, Args)]
pub struct SolverChoice {
    /// Who solves: this program's own finite elements, or an installed CalculiX
    #[arg(
        long,
        env = "STRAINSITE_SOLVER",
        value_enum,
        value_name = "NAME",
        default_value = "embedded"
    )]
    solver: SolverName,
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
enum SolverName {
    Embedded,
    Calculix,
}

impl SolverChoice {
    /// Whether a solve hands over its mesh and its equilibrium.
    pub fn keeps_equilibria(&self) -> bool {
        self.solver == SolverName::Embedded
    }

    /// The solver.
    ///
    /// # Errors
    /// When CalculiX is asked for and isn't installed.
    pub fn solver(&self) -> Result<Arc<dyn Solver>, NotInstalled> {
        let limit = self.solve_limit_s;
        let solver: Arc<dyn Solver> = match self.solver {
            SolverName::Embedded => Arc::new(EmbeddedSolver::default()),
            SolverName::Calculix => Arc::new(CalculixSolver::new(&self.ccx, limit + GRACE)?),
        };
        Ok(Arc::new(Watched::new(solver, limit, GRACE)))
    }
}
