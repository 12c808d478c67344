//! Cords at an equilibrium.

use fem::problem::State;
use fem::surface::membrane::Membrane;
use fem::surface::surface_law::InPlane;
use fem_client::scene::Scene;
use fem_client::solver::{CarcassState, Extremes};

use crate::model::{TireModel, cord_families};

/// Extremes over all integration points of the textile layer and both families.
pub(super) fn carcass(
    scene: &Scene,
    model: &TireModel,
    equilibrium: &State,
) -> Option<CarcassState> {
    let families = cord_families(scene.carcass.as_ref()?);
    let membrane = model.carcass()?;
    let (mut stretch, mut tension) = (Extremes::NONE, Extremes::NONE);
    for strain in strains(membrane, equilibrium) {
        for family in &families {
            stretch.include(family.stretch(&strain));
            tension.include(family.tension(&strain));
        }
    }
    Some(CarcassState {
        fibre_stretch: stretch,
        tension_n_per_mm: tension,
    })
}

/// Strains at all integration points of a layer.
fn strains(membrane: &Membrane, state: &State) -> impl Iterator<Item = InPlane> {
    let faces = membrane.surface.iter().enumerate();
    faces.flat_map(|(face, nodes)| {
        let displacement: Vec<[f64; 3]> = nodes
            .iter()
            .map(|&node| state.displacement[node as usize])
            .collect();
        membrane.strains(face, &displacement).collect::<Vec<_>>()
    })
}
