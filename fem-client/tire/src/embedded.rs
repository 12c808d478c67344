//! The embedded finite element solver.

use std::sync::Arc;
use std::time::Instant;

use fem::load::contact::Wrench;
use fem::newton::iteration::{Effort, Newton, NewtonSettings};
use fem::newton::path::PathReport;
use fem::problem::{Loads, State};

use crate::mesh::tire_grid::{Extent, MeshPlan};
use crate::mesh_error;
use crate::model::{
    TireModel, depth_of_load, extent, ground_axes, inflated_key, mesh_plan, mesh_plan_for,
    profiled_ground, shape,
};
use crate::neighbourhood::{GroundPlace, Neighbourhood, Neighbourhoods, Pressed, of_start};
use crate::omission;
use crate::readout::surface_reader::{Diagnostics, Reader};
use crate::session::{Session, ToldSolve, VariedScene, standing};
use fem_client::scene::Scene;
use fem_client::solver::Coarser;
use fem_client::solver::Omission;
use fem_client::solver::derivative::Derivative;
use fem_client::solver::gauge;
use fem_client::solver::sides;
use fem_client::solver::{Cost, Readout, SolveError, SolveRequest, Solved, Solver, StartState};

/// Largest relative residual of an equilibrium. On the reference tire it leaves 1e-8 in a strain and 1e-7 of the
/// reaction (measured against 1e-12), five orders below the mesh's share.
const TOLERANCE: f64 = 1e-8;

/// Rise of the ground for which contact is prepared, relative to the wall.
const CONTACT_MARGIN: f64 = 0.1;

/// Solves scenes with the `fem` crate, one equilibrium per call, on the calling thread.
#[derive(Debug)]
pub struct EmbeddedSolver {
    settings: NewtonSettings,
    neighbourhoods: Neighbourhoods,
}

impl Default for EmbeddedSolver {
    fn default() -> Self {
        Self::with_settings(Self::settings())
    }
}

impl Solver for EmbeddedSolver {
    fn version(&self) -> String {
        // The sources' hash tells results of different numerics apart, whether or not someone raised the version.
        format!(
            "strainsite-fem {}+{}",
            env!("CARGO_PKG_VERSION"),
            env!("SOLVER_SOURCES")
        )
    }

    fn coarser(&self, scene: &Scene) -> Option<Coarser> {
        mesh_error::coarser(scene)
    }

    fn omissions(&self, scene: &Scene) -> Vec<Omission> {
        omission::omissions(scene)
    }

    fn cells(&self, scene: &Scene) -> usize {
        mesh_plan(scene, scene.model.level).cells()
    }

    fn cells_read(&self, scene: &Scene, readout: &Readout) -> usize {
        mesh_plan_for(scene, scene.model.level, readout).cells()
    }

    fn has_time_law(&self) -> bool {
        true
    }

    fn solve(&self, request: &SolveRequest<'_>) -> Result<Solved, SolveError> {
        let scene = request.scene;
        let plan = mesh_plan_for(scene, scene.model.level, request.readout);
        let mut solved = self.solve_on(request, &plan)?;
        let begin = Instant::now();
        solved.response.derivatives = self.derivatives(request, &plan, &solved.state)?;
        solved.cost.wall_s += begin.elapsed().as_secs_f64();
        Ok(solved)
    }
}

impl EmbeddedSolver {
    /// Returns the settings with which the default solver finds equilibria.
    pub fn settings() -> NewtonSettings {
        NewtonSettings {
            tolerance: TOLERANCE,
            ..NewtonSettings::default()
        }
    }

    /// A solver whose equilibria are found otherwise. Its version says nothing of that: for measurements, not for storage.
    pub fn with_settings(settings: NewtonSettings) -> Self {
        Self {
            settings,
            neighbourhoods: Neighbourhoods::default(),
        }
    }

    fn derivatives(
        &self,
        request: &SolveRequest<'_>,
        plan: &MeshPlan,
        solved: &StartState,
    ) -> Result<Vec<Derivative>, SolveError> {
        let Some(varied) = VariedScene::of(request)? else {
            return Ok(Vec::new());
        };
        // On both sides of a film a state isn't made of mirror images.
        let own = extent(request.scene);
        let is_widened = own.is_whole_across() != varied.extent.is_whole_across();
        if !is_widened || request.scene.film.is_none() {
            return varied.derivatives(solved);
        }
        let begin = Instant::now();
        let request = SolveRequest {
            start: None,
            ..*request
        };
        let whole = solve_afresh(&request, plan, varied.extent, self.settings, begin)?;
        varied.derivatives(&whole.state)
    }

    /// Solves a scene on a mesh of the caller's choice, without derivatives.
    ///
    /// # Errors
    /// As [`Solver::solve`].
    pub fn solve_on(
        &self,
        request: &SolveRequest<'_>,
        plan: &MeshPlan,
    ) -> Result<Solved, SolveError> {
        let begin = Instant::now();
        let mut faults = gauge::faults(&request.readout.gauges, request.scene);
        faults.extend(sides::faults(&request.readout.derivatives, request.scene));
        if !faults.is_empty() {
            return Err(SolveError::Refused { faults });
        }
        let key = inflated_key(request.scene, plan);
        let near = request
            .start
            .filter(|start| start.inflated_key == key)
            .and_then(|start| {
                let extent = extent(request.scene);
                self.neighbourhoods.of(request.scene, plan, extent, start)
            });
        match near {
            Some(near) => solve_near(request, &near, self.settings, begin),
            None => {
                let extent = extent(request.scene);
                solve_afresh(request, plan, extent, self.settings, begin)
            }
        }
    }
}

/// Solves from a neighbouring equilibrium of the same inflated tire, with its tangent.
fn solve_near(
    request: &SolveRequest<'_>,
    near: &Neighbourhood,
    settings: NewtonSettings,
    begin: Instant,
) -> Result<Solved, SolveError> {
    let newton = Newton::with_tangent(&near.model.problem, near.tangent.clone());
    let mut newton = newton.map_err(SolveError::broken)?;
    newton.settings = settings;
    let mut session = session(request, &near.model, newton);
    let target = session.target(&near.inflated);
    let (pressed, mirrored) = match target.ground_force {
        // Its own mirror image.
        Some(_) => (Arc::new(press_near(&mut session, near, &target)?), false),
        None => press_to_depths(&mut session, near, &target)?,
    };
    let state = if mirrored {
        let image = near.model.exchanged(&pressed.state);
        image.ok_or_else(|| SolveError::broken("the mirrored state doesn't fit its mesh"))?
    } else {
        pressed.state.clone()
    };
    let target = standing(&target, &pressed.state);
    let key = near.inflated_key.clone();
    let found = Found {
        inflated_key: key,
        inflated: near.inflated.clone(),
        equilibrium: state,
        report: &pressed.report,
        iterations: pressed.iterations,
        friction: match mirrored {
            true => exchanged(&pressed.friction),
            false => pressed.friction,
        },
    };
    Ok(session.answer(request, begin, found, &target))
}

/// Force and moment with left and right exchanged.
fn exchanged(Wrench { force, moment }: &Wrench) -> Wrench {
    let ([x, y, z], [mx, my, mz]) = (force, moment);
    Wrench {
        force: [0.0 - x, *y, *z],
        moment: [*mx, 0.0 - my, 0.0 - mz],
    }
}

/// Presses to the depths of one of two mirrored grounds; says whether it is the other one.
fn press_to_depths(
    session: &mut Session<'_>,
    near: &Neighbourhood,
    target: &Loads,
) -> Result<(Arc<Pressed>, bool), SolveError> {
    let (place, mirrored) = near.canonical(GroundPlace::of(target));
    if let Some(pressed) = near.recall(&place) {
        return Ok((pressed, mirrored));
    }
    let canonical = target.with_depths(&place.depths).with_shift(place.shift);
    let pressed = press_near(session, near, &canonical);
    let pressed = Arc::new(pressed.map_err(|error| error.mirrored(mirrored))?);
    near.remember(place, pressed.clone());
    Ok((pressed, mirrored))
}

fn press_near(
    session: &mut Session<'_>,
    near: &Neighbourhood,
    target: &Loads,
) -> Result<Pressed, SolveError> {
    // With friction the equilibrium depends on the path: always the one from the inflated state.
    if session.scene.contact.friction > 0.0 {
        return session.press(&near.inflated, target, None);
    }
    let neighbour = (&near.equilibrium, &near.loads);
    session.press(&near.inflated, target, Some(neighbour))
}

/// Solves from nothing, or from the equilibrium of a similar tire on the same mesh.
fn solve_afresh(
    request: &SolveRequest<'_>,
    plan: &MeshPlan,
    extent: Extent,
    settings: NewtonSettings,
    begin: Instant,
) -> Result<Solved, SolveError> {
    let model = TireModel::new(request.scene, plan, extent);
    let newton = Newton::for_contact(
        &model.problem,
        &State::reference(&model.problem),
        &expected_contact(request.scene),
    );
    let mut newton = newton.map_err(SolveError::broken)?;
    newton.settings = settings;
    let start = request.start;
    let near_inflated = start.and_then(|start| model.fit(&start.inflated));
    let near_equilibrium = start.and_then(|start| model.fit(&start.equilibrium));
    let mut session = session(request, &model, newton);
    let inflated = session.inflate(near_inflated)?;
    let target = session.target(&inflated);
    let near_loads =
        start.map(|start| start_loads(request.scene, start, &model, (&inflated, &target)));
    let near = near_equilibrium.as_ref().zip(near_loads.as_ref());
    let near = near.filter(|_| request.scene.contact.friction == 0.0);
    let pressed = session.press(&inflated, &target, near)?;
    let target = standing(&target, &pressed.state);
    let found = Found {
        inflated_key: inflated_key(request.scene, plan),
        inflated,
        equilibrium: pressed.state,
        friction: pressed.friction,
        report: &pressed.report,
        iterations: session.newton.effort.iterations,
    };
    Ok(session.answer(request, begin, found, &target))
}

/// The scene's ground below the undeformed tire, raised a little: inflation moves wall and ground alike.
fn expected_contact(scene: &Scene) -> Loads {
    let margin = CONTACT_MARGIN * scene.geometry.wall_mm + depth_of_load(scene);
    let distance = undeformed_distance(scene) - margin;
    Loads {
        ground: Some(profiled_ground(
            &scene.ground,
            distance,
            shape(scene).centre_radius,
        )),
        ..Loads::default()
    }
}

/// Distance of the ground from the axle's middle at which it touches the undeformed tire, mm: it rests on the section's circle.
fn undeformed_distance(scene: &Scene) -> f64 {
    let [_, _, up] = ground_axes(&scene.ground).vectors();
    scene.geometry.outer_radius_mm - shape(scene).centre_radius * (1.0 - up[2])
}

fn session<'m>(
    request: &SolveRequest<'m>,
    model: &'m TireModel,
    newton: Newton<'m>,
) -> Session<'m> {
    Session {
        scene: request.scene,
        model,
        newton,
        watch: ToldSolve::new(request.watch),
    }
}

/// The loads at which a start state is in equilibrium, but for the inflated tire's size.
fn start_loads(
    scene: &Scene,
    start: &StartState,
    model: &TireModel,
    (inflated, target): (&State, &Loads),
) -> Loads {
    Loads {
        pressure: start.pressure_mpa,
        ground: Some(model.ground_below(&of_start(scene, start), inflated)),
        ..target.clone()
    }
}

/// States that a solve found.
struct Found<'a> {
    inflated_key: String,
    inflated: State,
    equilibrium: State,
    report: &'a PathReport,
    iterations: usize,
    /// Friction's force and moment on the meshed part.
    friction: Wrench,
}

impl Session<'_> {
    fn answer(
        mut self,
        request: &SolveRequest<'_>,
        begin: Instant,
        found: Found<'_>,
        loads: &Loads,
    ) -> Solved {
        let scene = request.scene;
        let (inflated, equilibrium) = (&found.inflated, &found.equilibrium);
        let reader = Reader::new(scene, self.model, inflated, equilibrium, loads);
        let steps = found.report.steps.iter();
        let diagnostics = Diagnostics {
            max_volume_change: self.newton.max_volume_change(equilibrium),
            newton_iterations: found.iterations,
            residual_history: steps
                .map(|step| step.iter().map(|r| r.worst()).collect())
                .collect(),
            model: self.model.summary(scene, self.newton.unknowns()),
            friction: found.friction,
        };
        let state = StartState {
            inflated_key: found.inflated_key,
            inflated: inflated.to_flat(),
            pressure_mpa: scene.pressure.internal_mpa,
            depths_mm: loads
                .ground
                .as_ref()
                .map_or(Vec::new(), |ground| ground.depths.clone()),
            camber_deg: scene.ground.camber_deg,
            equilibrium: equilibrium.to_flat(),
        };
        Solved {
            response: reader.response(request.readout, diagnostics),
            cost: cost(&self.newton.effort, begin),
            state,
        }
    }
}

fn cost(effort: &Effort, begin: Instant) -> Cost {
    Cost {
        wall_s: begin.elapsed().as_secs_f64(),
        factorisation_s: effort.factorisation.as_secs_f64(),
        substitution_s: effort.substitution.as_secs_f64(),
        assembly_s: effort.assembly.as_secs_f64(),
        newton_iterations: effort.iterations,
        factorisations: effort.factorisations,
    }
}
