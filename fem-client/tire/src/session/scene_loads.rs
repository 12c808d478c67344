//! Loads of a scene.

use fem::load::obstacle::HeightField;
use fem::problem::{Loads, State};
use fem_client::scene::Scene;

use crate::model::TireModel;

/// Loads of a scene's inflated state.
pub(super) fn inflation(scene: &Scene) -> Loads {
    Loads {
        pressure: scene.pressure.internal_mpa,
        ..Loads::default()
    }
}

/// Loads of a scene, given its inflated state.
pub(super) fn target(scene: &Scene, model: &TireModel, inflated: &State) -> Loads {
    Loads {
        ground: Some(model.ground_below(&scene.ground, inflated)),
        ground_force: load(scene).map(|load| load / model.multiplicity()),
        ..inflation(scene)
    }
}

/// The force with which the ground is to press on the whole tire, N; no force is a ground that just touches.
pub(super) fn load(scene: &Scene) -> Option<f64> {
    scene.ground.load_n.filter(|load| *load > 0.0)
}

/// Loads whose ground stands where it stands in a state.
pub(crate) fn standing(loads: &Loads, state: &State) -> Loads {
    let ground = loads.ground.as_ref().map(|ground| HeightField {
        depths: ground
            .depths
            .iter()
            .map(|depth| depth + state.rise)
            .collect(),
        ..ground.clone()
    });
    Loads {
        ground,
        ground_force: None,
        ..loads.clone()
    }
}
