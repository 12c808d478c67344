//! The embedded finite element solver.

use std::sync::atomic::AtomicBool;
use std::time::Instant;

use fem::newton::{Cause, Effort, Newton};
use fem::path::{PathFailure, PathReport, Stability, follow};
use fem::problem::{Loads, State};
use sha2::{Digest, Sha256};

use crate::readout::Reader;
use crate::scene::Scene;
use crate::solver::{
    Cost, NoEquilibrium, Reached, SolveError, SolveRequest, Solved, Solver, StartState,
};
use crate::tire::{TireModel, ground, is_symmetric, mesh_plan};
use crate::tire_mesh::{Extent, MeshPlan};

/// Solves scenes with the `fem` crate, one equilibrium per call, on the calling thread.
#[derive(Debug, Clone, Copy, Default)]
pub struct EmbeddedSolver;

impl Solver for EmbeddedSolver {
    fn version(&self) -> String {
        // The sources' hash tells results of different numerics apart, whether or not someone raised the version.
        format!(
            "strainsite-fem {}+{}",
            env!("CARGO_PKG_VERSION"),
            env!("SOLVER_SOURCES")
        )
    }

    fn solve(&self, request: &SolveRequest<'_>) -> Result<Solved, SolveError> {
        let plan = mesh_plan(request.scene, request.scene.model.level);
        solve_on(request, &plan)
    }
}

/// Solves a scene on a mesh of the caller's choice.
///
/// # Errors
/// As [`Solver::solve`].
pub fn solve_on(request: &SolveRequest<'_>, plan: &MeshPlan) -> Result<Solved, SolveError> {
    let begin = Instant::now();
    let scene = request.scene;
    let extent = if is_symmetric(&scene.ground) {
        Extent::Quarter
    } else {
        Extent::Half
    };
    let model = TireModel::new(scene, plan, extent);
    let newton = Newton::new(&model.problem).map_err(|error| SolveError::Broken {
        detail: error.to_string(),
    })?;
    let mut session = Session {
        scene,
        model: &model,
        newton,
        stop: request.stop,
    };
    let key = inflated_key(scene, plan);
    let start = request
        .start
        .and_then(|start| Start::new(&model, start, &key));

    let inflated = session.inflate(start.as_ref())?;
    let radius = -inflated.position(&model.problem.mesh, model.grid.lowest_node())[2];
    let target = Loads {
        ground: Some(ground(&scene.ground, radius)),
        ..session.inflation()
    };
    let (equilibrium, report) = session.press(&inflated, &target, start.as_ref())?;

    let reader = Reader::new(scene, &model, &inflated, &equilibrium, &target);
    let max_volume_change = session.newton.max_volume_change(&equilibrium);
    let effort = session.newton.effort;
    let mut response = reader.response(request.readout);
    response.max_volume_change = max_volume_change;
    response.newton_iterations = effort.iterations;
    response.residual_history = report
        .steps
        .iter()
        .map(|step| step.iter().map(|r| r.worst()).collect())
        .collect();
    response.model = model.summary(scene, session.newton.unknowns());
    let state = StartState {
        inflated_key: key,
        inflated: inflated.to_flat(),
        pressure_mpa: scene.pressure.internal_mpa,
        depths_mm: scene.ground.depths_mm.clone(),
        equilibrium: equilibrium.to_flat(),
    };
    Ok(Solved {
        response,
        cost: cost(&effort, begin),
        state,
    })
}

fn cost(effort: &Effort, begin: Instant) -> Cost {
    Cost {
        wall_s: begin.elapsed().as_secs_f64(),
        factorisation_s: (effort.factorisation + effort.substitution).as_secs_f64(),
        assembly_s: effort.assembly.as_secs_f64(),
        newton_iterations: effort.iterations,
    }
}

/// Hash of all that determines the inflated state: the scene without its ground and contact, and the mesh.
fn inflated_key(scene: &Scene, plan: &MeshPlan) -> String {
    let parts = (
        &scene.geometry,
        &scene.material,
        &scene.carcass,
        &scene.pressure,
    );
    let text = format!("{parts:?} {plan:?}");
    Sha256::digest(text.as_bytes())
        .iter()
        .map(|byte| format!("{byte:02x}"))
        .collect()
}

/// A neighbouring equilibrium, fitted to this model's mesh.
struct Start {
    inflated: State,
    equilibrium: State,
    loads: (f64, Vec<f64>),
    /// Whether the inflated state is this scene's own.
    same_inflation: bool,
}

impl Start {
    /// `None` when the state belongs to another mesh.
    fn new(model: &TireModel, start: &StartState, key: &str) -> Option<Self> {
        Some(Self {
            inflated: model.fit(&start.inflated)?,
            equilibrium: model.fit(&start.equilibrium)?,
            loads: (start.pressure_mpa, start.depths_mm.clone()),
            same_inflation: start.inflated_key == key,
        })
    }
}

/// One solve on its way.
struct Session<'m> {
    scene: &'m Scene,
    model: &'m TireModel,
    newton: Newton<'m>,
    stop: &'m AtomicBool,
}

impl Session<'_> {
    /// Loads of the inflated state.
    fn inflation(&self) -> Loads {
        Loads {
            pressure: self.scene.pressure.internal_mpa,
            ground: None,
            support_factor: 0.0,
        }
    }

    /// The inflated state: the start's own when it is this scene's, else from the start's, else from nothing.
    fn inflate(&mut self, start: Option<&Start>) -> Result<State, SolveError> {
        if let Some(start) = start {
            if start.same_inflation {
                return Ok(start.inflated.clone());
            }
            let mut state = start.inflated.clone();
            if self
                .newton
                .solve(&mut state, &self.inflation(), self.stop)
                .is_ok()
            {
                return Ok(state);
            }
        }
        let mut state = State::reference(&self.model.problem);
        let target = self.inflation();
        match follow(
            &mut self.newton,
            &mut state,
            &Loads::default(),
            &target,
            Stability::Required,
            self.stop,
        ) {
            Ok(_) => Ok(state),
            Err(failure) => Err(inflation_error(self.scene, &failure)),
        }
    }

    /// The equilibrium on the ground: along the depths from the start's, else by pressing the inflated tire.
    fn press(
        &mut self,
        inflated: &State,
        target: &Loads,
        start: Option<&Start>,
    ) -> Result<(State, PathReport), SolveError> {
        if let Some(start) = start {
            let mut state = start.equilibrium.clone();
            let from = self.loads_of(start, target);
            if let Ok(report) = follow(
                &mut self.newton,
                &mut state,
                &from,
                target,
                Stability::Ignored,
                self.stop,
            ) {
                return Ok((state, report));
            }
        }
        let mut state = inflated.clone();
        let unpressed = self.inflation();
        match follow(
            &mut self.newton,
            &mut state,
            &unpressed,
            target,
            Stability::Ignored,
            self.stop,
        ) {
            Ok(report) => Ok((state, report)),
            Err(failure) => Err(pressing_error(self.scene, &failure)),
        }
    }

    fn loads_of(&self, start: &Start, target: &Loads) -> Loads {
        let (pressure, depths) = &start.loads;
        let ground = target
            .ground
            .as_ref()
            .map(|ground| fem::obstacle::HeightField {
                depths: depths.clone(),
                ..ground.clone()
            });
        Loads {
            pressure: *pressure,
            ground,
            support_factor: 0.0,
        }
    }
}

fn inflation_error(scene: &Scene, failure: &PathFailure) -> SolveError {
    let reached = Reached {
        pressure_mpa: failure.loads.pressure,
        depths_mm: Vec::new(),
    };
    let asked = scene.pressure.internal_mpa;
    let at = failure.loads.pressure;
    if failure.indefinite {
        let detail = format!(
            "inflation lost its stability just above {at:.6} MPa of the {asked} MPa asked for: this wall cannot hold the \
             pressure; use a thicker wall, a stiffer rubber, a carcass or less pressure"
        );
        return no_equilibrium(NoEquilibrium::LimitPoint, detail, reached, failure.cause);
    }
    let detail = format!(
        "inflation stopped at {at:.6} MPa of the {asked} MPa asked for ({})",
        cause(failure.cause)
    );
    no_equilibrium(NoEquilibrium::NotConverged, detail, reached, failure.cause)
}

fn pressing_error(scene: &Scene, failure: &PathFailure) -> SolveError {
    let depths = failure
        .loads
        .ground
        .as_ref()
        .map(|ground| ground.depths.clone())
        .unwrap_or_default();
    let detail = format!(
        "pressing stopped at {:.1} % of the way to the depths {:?} mm ({})",
        100.0 * failure.reached,
        scene.ground.depths_mm,
        cause(failure.cause)
    );
    let reached = Reached {
        pressure_mpa: failure.loads.pressure,
        depths_mm: depths,
    };
    no_equilibrium(NoEquilibrium::NotConverged, detail, reached, failure.cause)
}

fn no_equilibrium(
    status: NoEquilibrium,
    detail: String,
    reached: Reached,
    cause: Cause,
) -> SolveError {
    match cause {
        Cause::Stopped => SolveError::Stopped,
        _ => SolveError::NoEquilibrium {
            status,
            detail,
            reached,
        },
    }
}

fn cause(cause: Cause) -> &'static str {
    match cause {
        Cause::Iterations => "too many Newton iterations at the smallest load step",
        Cause::Diverged => "the residual grew without bound at the smallest load step",
        Cause::Inverted => "an element would turn inside out",
        Cause::Singular(_) => "the tangent is singular",
        Cause::Unstable => "the equilibrium found is unstable",
        Cause::Stopped => "stopped on request",
    }
}
