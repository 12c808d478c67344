//! Which solver answers: chosen here and nowhere else.

use std::path::PathBuf;
use std::sync::Arc;
use std::time::Duration;

use clap::{Args, ValueEnum};
use fem_client::calculix::{CalculixSolver, NotInstalled};
use fem_client::embedded::EmbeddedSolver;
use fem_client::solver::Solver;

/// Longest time of one run of CalculiX: a quarter tire on the standard mesh takes about a minute.
const CALCULIX_TIME_LIMIT: Duration = Duration::from_secs(3600);

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
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum SolverName {
    Embedded,
    Calculix,
}

impl SolverChoice {
    /// The solver.
    ///
    /// # Errors
    /// When CalculiX is asked for and isn't installed.
    pub fn solver(&self) -> Result<Arc<dyn Solver>, NotInstalled> {
        Ok(match self.solver {
            SolverName::Embedded => Arc::new(EmbeddedSolver::default()),
            SolverName::Calculix => Arc::new(CalculixSolver::new(&self.ccx, CALCULIX_TIME_LIMIT)?),
        })
    }
}
