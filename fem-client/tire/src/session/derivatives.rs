//! Derivatives of a scene's response by its numbers, from the tangents of its inflated and its pressed state.
//!
//! Both states are moved along their derivatives to either side of a number. The difference of what is read there holds all that the number changes: mesh,
//! laws, loads, and the place of what is read.

use fem::newton::iteration::Newton;
use fem::newton::state_rate::{Beside, NoRate, StateRate};
use fem::problem::{Loads, Problem, State};

use super::scene_loads::{inflation, standing, target};
use crate::mesh::tire_grid::Extent;
use crate::model::{TireModel, extent, inflated_key, mesh_plan_for};
use crate::readout::surface_reader::{Diagnostics, Reader};
use fem_client::scene::Scene;
use fem_client::solver::derivative::Derivative;
use fem_client::solver::sides::{Sides, refused};
use fem_client::solver::{Readout, SolveError, SolveRequest, StartState};

/// A request's scene with each number changed by which its response is differentiated.
pub(crate) struct VariedScene<'r> {
    request: &'r SolveRequest<'r>,
    sides: Vec<Sides>,
    /// Part of the tire that has to be meshed: a number may break the scene's symmetry.
    pub(crate) extent: Extent,
}

impl<'r> VariedScene<'r> {
    /// Changes each number; `None` where no derivative is asked for.
    ///
    /// # Errors
    /// [`SolveError::Refused`] where a number can't be changed.
    pub(crate) fn of(request: &'r SolveRequest<'r>) -> Result<Option<Self>, SolveError> {
        let paths = request.readout.derivatives.iter().enumerate();
        let sides: Result<Vec<Sides>, SolveError> = paths
            .map(|(i, by)| Sides::of(request.scene, by).map_err(|why| refused(i, why)))
            .collect();
        let sides = sides?;
        if sides.is_empty() {
            return Ok(None);
        }
        let varied = sides.iter().flat_map(|sides| &sides.scenes).map(extent);
        Ok(Some(Self {
            request,
            extent: varied.fold(extent(request.scene), Extent::joined),
            sides,
        }))
    }

    /// Derivatives in the order asked, about an equilibrium that fits the meshed part.
    ///
    /// # Errors
    /// [`SolveError::Refused`] where there is none by one of the numbers.
    pub(crate) fn derivatives(&self, solved: &StartState) -> Result<Vec<Derivative>, SolveError> {
        let model = model(self.request.scene, self.request.readout, self.extent);
        let mut middle = Middle::new(self.request, &model, solved)?;
        let sides = self.sides.iter().enumerate();
        sides
            .map(|(i, sides)| {
                if self.request.watch.is_stopped() {
                    return Err(SolveError::Stopped);
                }
                middle.derivative(sides).map_err(|why| {
                    let by = &sides.by;
                    let detail =
                        format!("there is no derivative by {by} here: {why}; change it a little");
                    refused(i, detail)
                })
            })
            .collect()
    }
}

fn model(scene: &Scene, readout: &Readout, extent: Extent) -> TireModel {
    TireModel::new(
        scene,
        &mesh_plan_for(scene, scene.model.level, readout),
        extent,
    )
}

/// The equilibria about which a scene's numbers change, with their tangents.
struct Middle<'m> {
    readout: &'m Readout,
    inflated: Equilibrium<'m>,
    pressed: Equilibrium<'m>,
    extent: Extent,
}

/// An equilibrium with Newton's method there, whose tangent is made by the first derivative.
struct Equilibrium<'m> {
    state: State,
    loads: Loads,
    newton: Newton<'m>,
}

impl<'m> Middle<'m> {
    fn new(
        request: &SolveRequest<'m>,
        model: &'m TireModel,
        start: &StartState,
    ) -> Result<Self, SolveError> {
        let scene = request.scene;
        let unfit = || SolveError::broken("the solved state doesn't fit its mesh");
        let inflated = model.fit_sides(&start.inflated).ok_or_else(unfit)?;
        let mut pressed = model.fit_sides(&start.equilibrium).ok_or_else(unfit)?;
        let loads = target(scene, model, &inflated);
        if loads.ground_force.is_some() {
            // All stations have risen alike.
            pressed.rise = start.depths_mm.first().copied().unwrap_or_default();
        }
        let problem = &model.problem;
        Ok(Self {
            readout: request.readout,
            pressed: Equilibrium {
                newton: Newton::for_contact(problem, &pressed, &loads)
                    .map_err(SolveError::broken)?,
                state: pressed,
                loads,
            },
            inflated: Equilibrium {
                newton: Newton::new(problem).map_err(SolveError::broken)?,
                state: inflated,
                loads: inflation(scene),
            },
            extent: model.grid.extent,
        })
    }

    /// Derivative by one number: both sides are read in equilibrium, up to terms of second order in the step.
    fn derivative(&mut self, sides: &Sides) -> Result<Derivative, NoRate> {
        let Sides {
            scenes, half_step, ..
        } = sides;
        let steps = [-half_step, *half_step];
        let models = scenes
            .each_ref()
            .map(|scene| model(scene, self.readout, self.extent));
        let problems = models.each_ref().map(|model| &model.problem);
        let loads = scenes.each_ref().map(inflation);
        let rate = match is_inflated_alike(scenes, self.readout) {
            true => StateRate::zero(&self.inflated.state),
            false => self.inflated.rate(problems, &loads, *half_step)?,
        };
        let inflated = steps.map(|step| rate.moved(&self.inflated.state, step));
        let loads = [0, 1].map(|i| target(&scenes[i], &models[i], &inflated[i]));
        let rate = self.pressed.rate(problems, &loads, *half_step)?;
        let pressed = steps.map(|step| rate.moved(&self.pressed.state, step));
        let responses = [0, 1].map(|i| {
            let loads = standing(&loads[i], &pressed[i]);
            Reader::new(&scenes[i], &models[i], &inflated[i], &pressed[i], &loads)
                .response(self.readout, Diagnostics::default())
        });
        Ok(sides.derivative(responses.each_ref()))
    }
}

impl Equilibrium<'_> {
    fn rate(
        &mut self,
        problems: [&Problem; 2],
        loads: &[Loads; 2],
        half_step: f64,
    ) -> Result<StateRate, NoRate> {
        let beside = [0, 1].map(|i| Beside {
            problem: problems[i],
            loads: &loads[i],
        });
        self.newton
            .state_rate(&self.state, &self.loads, beside, half_step)
    }
}

/// Whether two scenes differ in the ground or the contact alone.
fn is_inflated_alike(scenes: &[Scene; 2], readout: &Readout) -> bool {
    let [low, high] = scenes
        .each_ref()
        .map(|scene| inflated_key(scene, &mesh_plan_for(scene, scene.model.level, readout)));
    low == high
}
