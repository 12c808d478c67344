//! The one trait between the product and any solver.

pub mod derivative;
pub mod direction;
pub mod film_comparison;
pub(crate) mod film_state;
pub mod gauge;
pub mod object_schema;
pub mod readout;
pub mod response;
pub mod sides;
pub(crate) mod solve_error;
pub(crate) mod solve_watch;
pub(crate) mod start_state;
pub(crate) mod value_range;

use serde::{Deserialize, Serialize};

use crate::scene::{Level, Scene};
pub use crate::solver::film_state::{FilmCondition, FilmError, FilmMeans, FilmSignal, FilmState};
pub use crate::solver::readout::{Grid, Position, Readout, RingLine};
pub use crate::solver::response::{
    CarcassState, Choice, Inflated, LocationError, LocationStrain, MapShape, ModelSummary,
    Response, ResponseError, Ring, Section, StrainMap,
};
pub use crate::solver::solve_error::{NoEquilibrium, Reached, SolveError};
pub use crate::solver::solve_watch::{SolveProgress, Stage, Watch};
pub use crate::solver::value_range::Extremes;
use document::fault::Fault;

/// The fault of a scene that a solver which presses by depth alone can't solve.
pub fn by_depth_only(scene: &Scene) -> Vec<Fault> {
    let fault = |_| Fault {
        pointer: "/ground/load_n".to_owned(),
        detail: "isn't what this solver knows, which presses by depth: give depths_mm".to_owned(),
    };
    scene.ground.load_n.map(fault).into_iter().collect()
}

/// Answers for one equilibrium of a scene.
pub trait Solver: Send + Sync {
    /// Name and version, part of the key under which results are stored.
    fn version(&self) -> String;

    /// A coarser level on which the same scene shows what its own level misses; `None` where there is none.
    fn coarser(&self, _scene: &Scene) -> Option<Coarser> {
        None
    }

    /// Returns what the model of the scene leaves out and could have.
    fn omissions(&self, _scene: &Scene) -> Vec<Omission> {
        Vec::new()
    }

    /// Cells between the nodes of its mesh in a quarter of the tire: what a solve's time and memory follow from.
    fn cells(&self, scene: &Scene) -> usize {
        scene.model.level.cells_of_reference_tire()
    }

    /// Returns the number of cells of the mesh on which this is read of the scene.
    fn cells_read(&self, scene: &Scene, _readout: &Readout) -> usize {
        self.cells(scene)
    }

    /// Whether the law of solve times in `placement` was fitted to it.
    fn has_time_law(&self) -> bool {
        false
    }

    /// Solves one equilibrium.
    ///
    /// The response is a function of scene and readout up to the solver's tolerance, and to the bit of scene, readout
    /// and start together.
    ///
    /// # Errors
    /// See [`SolveError`]; only [`SolveError::Broken`] is worth a retry at once.
    fn solve(&self, request: &SolveRequest<'_>) -> Result<Solved, SolveError>;

    /// Solves one equilibrium where a crash doesn't end this program, if the solver knows such a place; the answer is the same to the bit.
    ///
    /// # Errors
    /// As [`Solver::solve`], and [`SolveError::Crashed`].
    fn solve_isolated(&self, request: &SolveRequest<'_>) -> Result<Solved, SolveError> {
        self.solve(request)
    }
}

/// Request to a solver.
#[derive(Clone, Copy)]
pub struct SolveRequest<'a> {
    /// Scene to solve.
    pub scene: &'a Scene,
    /// Places where the strain is read.
    pub readout: &'a Readout,
    /// A neighbouring equilibrium to start from, as an earlier solve returned it.
    pub start: Option<&'a StartState>,
    /// Observer that may end the solve at the next Newton iteration, and hears how far it is.
    pub watch: &'a dyn Watch,
}

/// A coarser level as a witness of a finer one's error.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Coarser {
    /// The coarser level.
    pub level: Level,
    /// Error of the finer level over its difference from the coarser one, of a single value: two meshes may agree on it by chance.
    pub factor: f64,
    /// Error over the largest difference of several values that are judged together.
    pub of_largest: f64,
}

/// A part of reality that a scene's model doesn't have.
#[derive(Debug, Clone, PartialEq)]
pub struct Omission {
    /// The part.
    pub what: &'static str,
    /// The reason.
    pub why: String,
    /// Scene with that part in a typical size; `None` where no scene can have it, or where it doesn't fit this one.
    pub richer: Option<Scene>,
}

/// Outcome of a solve: the answer, its price, and the state from which a neighbour may start.
#[derive(Debug, Clone)]
pub struct Solved {
    /// The answer; the same bits for the same request.
    pub response: Response,
    /// Cost of the solve; varies from run to run.
    pub cost: Cost,
    /// The equilibrium itself.
    pub state: StartState,
}

/// Cost of a solve.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct Cost {
    /// Wall-clock time, s.
    pub wall_s: f64,
    /// Time in numeric factorisation, s.
    pub factorisation_s: f64,
    /// Time in substitutions with the factor, and in the contact solved between them, s.
    pub substitution_s: f64,
    /// Time in assembly of residual and tangent, s.
    pub assembly_s: f64,
    /// Newton iterations.
    pub newton_iterations: usize,
    /// Numeric factorisations; the tangent shared by the solves of a study isn't counted.
    pub factorisations: usize,
}

/// An equilibrium from which a neighbour may start: opaque, but it survives storage bit for bit.
#[derive(Debug, Clone, PartialEq)]
pub struct StartState {
    /// Says which inflated problem `inflated` solves; the solver's own business.
    pub inflated_key: String,
    /// Unknowns of the inflated state.
    pub inflated: Vec<f64>,
    /// Internal pressure of the equilibrium, MPa.
    pub pressure_mpa: f64,
    /// Station depths of the equilibrium, mm.
    pub depths_mm: Vec<f64>,
    /// Inclination of the wheel there, degrees.
    pub camber_deg: f64,
    /// Unknowns of the equilibrium.
    pub equilibrium: Vec<f64>,
}
