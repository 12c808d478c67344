//! Choice of the solver: here and nowhere else.

use std::path::Path;
use std::process::ExitCode;
use std::sync::Arc;
use std::time::Duration;

use calculix::CalculixSolver;
use fem_client::solver::Solver;
use tire::embedded::EmbeddedSolver;

use crate::solving::isolated::child;
use crate::solving::isolated::parent::Isolated;
use crate::solving::numerics::Fingerprinted;
use crate::solving::watched::Watched;
use crate::work::own_process::own_program;

pub use calculix::NotInstalled;

/// A Newton iteration on the largest mesh that is allowed takes seconds; what hasn't ended then won't.
const GRACE: Duration = Duration::from_secs(60);

/// A preview that takes longer is of no use to somebody who writes.
pub const PREVIEW_LIMIT: Duration = Duration::from_secs(10);

/// Name of a solver.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SolverName<'p> {
    /// Finite elements of this program.
    Embedded,
    /// An installed CalculiX: its program.
    Calculix(&'p Path),
}

/// The solver of this name; a solve that takes longer than `limit` ends without an answer.
///
/// # Errors
/// When CalculiX is asked for and isn't installed.
pub fn solver(name: SolverName<'_>, limit: Duration) -> Result<Arc<dyn Solver>, NotInstalled> {
    let solver: Arc<dyn Solver> = match name {
        SolverName::Embedded => {
            let solver = Arc::new(EmbeddedSolver::default());
            let isolated = Isolated::new(solver, || own_program(child::ARGUMENT));
            Arc::new(Fingerprinted::new(Arc::new(isolated)))
        }
        // Its solves are in a process of their own already.
        SolverName::Calculix(program) => Arc::new(CalculixSolver::new(program, limit + GRACE)?),
    };
    Ok(Arc::new(Watched::new(solver, limit, GRACE)))
}

/// Returns the solver of previews: this program's own finite elements, whoever solves studies. A preview's cut point isn't kept, so that its numerics need no
/// name.
pub fn preview_solver() -> Arc<dyn Solver> {
    let solver = Arc::new(EmbeddedSolver::default());
    Arc::new(Watched::new(solver, PREVIEW_LIMIT, GRACE))
}

/// Solves for the parent process of this one, by this program's own finite elements.
pub fn solve_for_parent() -> ExitCode {
    child::answer(&EmbeddedSolver::default())
}
