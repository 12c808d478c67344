//! The runs of one scene.

use fem::load::obstacle::HeightField;
use fem::problem::{Loads, State};
use fem::solid::SolidGeometry;

use super::deck::{Deck, INFLATED_TIME, PRESSED_TIME};
use super::limits;
use super::program::{Files, Program, RunError};
use crate::result_file;
use crate::rigid_ground::RigidGround;
use fem_client::scene::{Material, Scene};
use fem_client::solver::{
    NoEquilibrium, Reached, Readout, Response, ResponseError, SolveError, SolveRequest, Watch,
};
use tire::mesh::tire_grid::{Extent, MeshPlan};
use tire::model::TireModel;
use tire::readout::surface_reader::{Diagnostics, Reader};

/// Reach of the ground to all sides, in outer radii.
const GROUND_REACH: f64 = 1.5;
/// Way of the ground to the inflated tire, in walls: enough that nothing touches while the tire is inflated.
const CLEARANCE: f64 = 0.1;

/// A scene on its way through CalculiX.
pub struct Case<'s> {
    scene: &'s Scene,
    readout: &'s Readout,
    watch: &'s dyn Watch,
    program: &'s Program,
    model: TireModel,
    rubber: Material,
}

impl<'s> Case<'s> {
    /// Meshes the scene; the plan's bricks have 8 nodes.
    pub fn new(request: &SolveRequest<'s>, plan: &MeshPlan, program: &'s Program) -> Self {
        let scene = request.scene;
        let ground = &scene.ground;
        let extent = Extent::of(!ground.is_symmetric(), !ground.is_alike_across());
        Self {
            scene,
            readout: request.readout,
            watch: request.watch,
            program,
            model: TireModel::new(scene, plan, extent),
            rubber: limits::rubber(&scene.material),
        }
    }

    /// Runs the scene and reads the answer.
    ///
    /// # Errors
    /// As [`fem_client::solver::Solver::solve`].
    pub fn response(&self) -> Result<Response, SolveError> {
        let alone = self.state(&self.run(None)?, INFLATED_TIME)?;
        let field = self.model.ground_below(&self.scene.ground, &alone);
        let rigid = RigidGround::new(
            &field,
            GROUND_REACH * self.scene.geometry.outer_radius_mm,
            field.base - CLEARANCE * self.scene.geometry.wall_mm,
        );
        let files = self.run(Some(&rigid))?;
        self.read(&files, field)
    }

    /// Runs CalculiX once: the tire inflated, and pressed where there is a ground.
    fn run(&self, ground: Option<&RigidGround>) -> Result<Files, SolveError> {
        let deck = Deck {
            problem: &self.model.problem,
            rubber: &self.rubber,
            pressure: self.scene.pressure.internal_mpa,
            ground,
        };
        let folder = tempfile::Builder::new()
            .prefix("strainsite-calculix-")
            .tempdir()
            .map_err(broken)?;
        let files = self
            .program
            .run(folder.path(), &deck.text(), self.watch)
            .map_err(|error| match error {
                RunError::Stopped => SolveError::Stopped,
                error => broken(error),
            })?;
        if files.gave_up {
            let time = result_file::reached(&files.sta).map_err(broken)?;
            return Err(self.gave_up(time, ground));
        }
        Ok(files)
    }

    fn gave_up(&self, time: f64, ground: Option<&RigidGround>) -> SolveError {
        let asked = self.scene.pressure.internal_mpa;
        let pressure_mpa = asked * (time / INFLATED_TIME).min(1.0);
        let way = ((time - INFLATED_TIME) / (PRESSED_TIME - INFLATED_TIME)).max(0.0);
        let depths_mm = ground.map_or(Vec::new(), |ground| {
            let lowered = (1.0 - way) * ground.rise;
            let depths = self.scene.ground.depths_mm.iter();
            depths.map(|depth| (depth - lowered).max(0.0)).collect()
        });
        SolveError::NoEquilibrium {
            status: NoEquilibrium::NotConverged,
            detail: format!(
                "CalculiX found no equilibrium, with increments however small, beyond {pressure_mpa:.6} MPa of {asked} MPa and \
                 {:.1} % of the ground's way up; a wall that can't hold the pressure ends like this",
                100.0 * way
            ),
            reached: Reached {
                pressure_mpa,
                depths_mm,
                load_n: None,
            },
        }
    }

    /// The state that CalculiX printed at a step time. It has displacements only.
    fn state(&self, files: &Files, time: f64) -> Result<State, SolveError> {
        let mut state = State::reference(&self.model.problem);
        state.displacement =
            result_file::displacements(&files.dat, time, self.model.problem.mesh.nodes.len())
                .map_err(|error| broken(format!("{error}\n{}", files.log)))?;
        Ok(state)
    }

    fn read(&self, files: &Files, field: HeightField) -> Result<Response, SolveError> {
        let (model, scene) = (&self.model, self.scene);
        let inflated = self.state(files, INFLATED_TIME)?;
        let pressed = self.state(files, PRESSED_TIME)?;
        let force = result_file::reaction(&files.dat, PRESSED_TIME).map_err(broken)?;
        let [_, _, normal] = field.axes.coordinates(force);
        let loads = Loads {
            pressure: scene.pressure.internal_mpa,
            ground: Some(field),
            ..Loads::default()
        };
        let reader = Reader::new(scene, model, &inflated, &pressed, &loads);
        let residual_history = result_file::residuals(&files.cvg).map_err(broken)?;
        let supports = model.problem.supports.iter().flatten();
        let unknowns = supports.filter(|held| held.is_none()).count();
        let summary = model.summary(scene, unknowns);
        let diagnostics = Diagnostics {
            max_volume_change: self.max_volume_change(&pressed)?,
            newton_iterations: residual_history.iter().map(Vec::len).sum(),
            residual_history,
            model: limits::summary(scene, summary, self.program.version()),
            ..Diagnostics::default()
        };
        let response = reader.response(self.readout, diagnostics);
        let reaction_n = model.multiplicity() * normal;
        // The reader's error is the penetration's share of the embedded law's force; the share is the same here.
        let share = match response.reaction_n {
            embedded_n if embedded_n > 0.0 => reaction_n / embedded_n,
            _ => 1.0,
        };
        Ok(Response {
            reaction_n,
            force_n: None,
            moment_nmm: None,
            error: ResponseError {
                reaction_n: share * response.error.reaction_n,
                ..response.error
            },
            ..response
        })
    }

    /// Largest |J - 1| of an element's mean.
    fn max_volume_change(&self, state: &State) -> Result<f64, SolveError> {
        let mesh = &self.model.problem.mesh;
        let geometry = SolidGeometry::new(mesh).map_err(broken)?;
        let change = |element: usize| {
            let corners = mesh.brick(element).iter();
            let displacement: Vec<_> = corners
                .map(|&node| state.displacement[node as usize])
                .collect();
            (geometry.mean_volume_ratio(element, &displacement) - 1.0).abs()
        };
        Ok((0..mesh.brick_count()).map(change).fold(0.0, f64::max))
    }
}

fn broken(error: impl ToString) -> SolveError {
    SolveError::Broken {
        detail: error.to_string(),
    }
}
