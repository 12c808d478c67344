//! The other code's problem, solved here.
//!
//! Its contact pressure is k (g + w)^2 / (4 w) from the gap g = -w to w = 0.004 mm and k g beyond: ours with a ramp of
//! 2 w and the ground raised by w.

use std::sync::atomic::AtomicBool;

use fem::newton::iteration::Newton;
use fem::newton::path::{Stability, follow};
use fem::problem::{Loads, State};
use fem_client::scene::Scene;
use tire::mesh::tire_grid::{Extent, MeshPlan};
use tire::model::{TireModel, ground};

use super::cord_layer::round_off;

/// Half width of the smoothed corner of the other code's contact law, mm.
pub const CONTACT_HALF_WIDTH: f64 = 0.004;
/// Bulk modulus, MPa: 1000 shear moduli.
const BULK_MODULUS: f64 = 360.0;
/// Contact stiffness, unless a case says otherwise, N/mm^3.
const CONTACT_STIFFNESS: f64 = 100.0;

static RUNNING: AtomicBool = AtomicBool::new(false);

/// The reference tire as the other code has it.
pub fn reference() -> Scene {
    let mut scene = Scene::preset("foot-tire").expect("the preset ships");
    scene.material.d1_per_mpa = 2.0 / BULK_MODULUS;
    scene.contact.penalty_n_per_mm3 = Some(CONTACT_STIFFNESS);
    scene
}

/// A model with the other code's contact law and cords.
pub fn model(scene: &Scene, plan: &MeshPlan, extent: Extent) -> TireModel {
    let mut model = TireModel::new(scene, plan, extent);
    if let Some(contact) = &mut model.problem.contact {
        contact.penalty.ramp = 2.0 * CONTACT_HALF_WIDTH;
    }
    if let Some(carcass) = &scene.carcass {
        round_off(&mut model, carcass);
    }
    model
}

/// An inflated tire, to be pressed.
pub struct Press<'m> {
    scene: Scene,
    pub model: &'m TireModel,
    newton: Newton<'m>,
    inflation: Loads,
    pub inflated: State,
}

/// A pressed tire.
pub struct Pressed {
    pub state: State,
    pub loads: Loads,
}

impl<'m> Press<'m> {
    /// Inflates a tire that holds its pressure.
    pub fn new(scene: &Scene, model: &'m TireModel) -> Self {
        let mut newton = Newton::new(&model.problem).expect("a valid mesh");
        let mut inflated = State::reference(&model.problem);
        let inflation = Loads {
            pressure: scene.pressure.internal_mpa,
            ..Loads::default()
        };
        let (start, required) = (Loads::default(), Stability::Required);
        follow(
            &mut newton,
            &mut inflated,
            &start,
            &inflation,
            required,
            &RUNNING,
        )
        .expect("it holds");
        Self {
            scene: scene.clone(),
            model,
            newton,
            inflation,
            inflated,
        }
    }

    /// Presses the inflated tire to these depths of the stations, mm, from a pressed state or from nothing.
    pub fn press(&mut self, depths: &[f64], near: Option<&Pressed>) -> Pressed {
        let raised = depths.iter().map(|depth| depth + CONTACT_HALF_WIDTH);
        self.scene.ground.depths_mm = raised.collect();
        let radius = self.model.crown_radius(&self.inflated);
        let loads = Loads {
            ground: Some(ground(&self.scene.ground, radius)),
            ..self.inflation.clone()
        };
        let (start, mut state) = match near {
            Some(near) => (&near.loads, near.state.clone()),
            None => (&self.inflation, self.inflated.clone()),
        };
        let ignored = Stability::Ignored;
        follow(
            &mut self.newton,
            &mut state,
            start,
            &loads,
            ignored,
            &RUNNING,
        )
        .expect("an equilibrium");
        Pressed { state, loads }
    }
}
