//! A solve on its way: a scene's model, its Newton method, and the loads they meet.
//!
//! - `told_solve`: tells whoever watches how far it is
//! - `scene_loads`: loads of a scene
//! - `derivatives`: derivatives of its response by numbers of the scene

mod derivatives;
mod scene_loads;
mod told_solve;

use fem::load::contact::Wrench;
use fem::load::obstacle::HeightField;
use fem::newton::iteration::Newton;
use fem::newton::path::{PathFailure, PathReport, Stability, follow};
use fem::problem::{Loads, State};

use crate::model::{TireModel, depth_of_load};
use fem_client::scene::Scene;
use fem_client::solver::Stage;

pub(crate) use derivatives::VariedScene;
pub(crate) use scene_loads::standing;
use scene_loads::{inflation, load, target};
pub(crate) use told_solve::ToldSolve;

/// A scene's model with its Newton method.
pub(crate) struct Session<'m> {
    pub(crate) scene: &'m Scene,
    pub(crate) model: &'m TireModel,
    pub(crate) newton: Newton<'m>,
    pub(crate) watch: ToldSolve<'m>,
}

impl Session<'_> {
    /// Loads of the inflated state.
    pub(crate) fn inflation(&self) -> Loads {
        inflation(self.scene)
    }

    pub(crate) fn follow(
        &mut self,
        state: &mut State,
        start: &Loads,
        target: &Loads,
        stability: Stability,
    ) -> Result<PathReport, Box<PathFailure>> {
        self.watch.begin(match target.ground {
            None => Stage::Inflating,
            Some(_) => Stage::Pressing,
        });
        let watch = &self.watch;
        follow(&mut self.newton, state, start, target, stability, watch)
    }

    /// Loads of the scene, given its inflated state.
    pub(crate) fn target(&self, inflated: &State) -> Loads {
        target(self.scene, self.model, inflated)
    }

    /// An equilibrium with its loads, as the beginning of a path to other loads: on ground that presses with a force, with the one it has there.
    pub(crate) fn leaving(&self, state: &State, loads: &Loads, target: &Loads) -> (State, Loads) {
        let (mut state, mut loads) = (state.clone(), loads.clone());
        if target.ground_force.is_some() {
            loads.ground_force = Some(self.ground_force(&state, &loads));
            state.rise = loads.ground.as_ref().map_or(0.0, mean_depth);
            loads.ground = target.ground.clone();
        }
        (state, loads)
    }

    /// The inflated tire as the beginning of a path to the ground.
    pub(crate) fn above_ground(&self, inflated: &State) -> State {
        let mut state = inflated.clone();
        if load(self.scene).is_some() {
            state.rise = depth_of_load(self.scene);
        }
        state
    }

    /// Force along the ground's normal on the meshed part, N.
    fn ground_force(&self, state: &State, loads: &Loads) -> f64 {
        let (Some(contact), Some(ground)) = (&self.model.problem.contact, loads.ground_in(state))
        else {
            return 0.0;
        };
        let mesh = &self.model.problem.mesh;
        contact
            .resultant(&ground, |node| state.position(mesh, node))
            .load
    }

    /// Friction's force and moment on the meshed part.
    pub(crate) fn friction(&self, state: &State, loads: &Loads) -> Wrench {
        let (Some(contact), Some(ground)) = (&self.model.problem.contact, loads.ground_in(state))
        else {
            return Wrench::default();
        };
        let mesh = &self.model.problem.mesh;
        contact.friction_wrench(&ground, &state.anchors, |node| state.position(mesh, node))
    }
}

/// Returns the mean depth of all stations, mm.
fn mean_depth(ground: &HeightField) -> f64 {
    ground.depths.iter().sum::<f64>() / ground.depths.len() as f64
}
