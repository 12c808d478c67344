//! Part of a scene's tire that is meshed, and the inflated state that it has.

use fem_client::hexadecimal::hexadecimal;
use fem_client::scene::Scene;
use sha2::{Digest, Sha256};

use super::dimensions::shape;
use super::glued_film::Place;
use crate::mesh::tire_grid::{Extent, MeshPlan};

/// The smallest part of the tire that the symmetry of ground and film allows. A wheel that leans, or whose ground is dragged across it, has none in its middle plane.
pub fn extent(scene: &Scene) -> Extent {
    let film = scene.film.as_ref();
    let of_film = film.map(|film| Place::of(film, &shape(scene)).extent());
    let ground = &scene.ground;
    let of_ground = Extent::of(!ground.is_symmetric(), !ground.is_alike_across());
    of_film.map_or(of_ground, |of_film| of_film.joined(of_ground))
}

/// Hash of all that determines the inflated state: the scene without its ground and contact, and the mesh.
pub(crate) fn inflated_key(scene: &Scene, plan: &MeshPlan) -> String {
    let parts = (
        &scene.geometry,
        &scene.material,
        &scene.carcass,
        &scene.film,
        &scene.pressure,
    );
    let text = format!("{parts:?} {plan:?}");
    hexadecimal(&Sha256::digest(text.as_bytes()))
}
