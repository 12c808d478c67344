//! Omissions of a scene's model, each with the scene that has it.
//!
//! How much that matters is measured, not guessed: the richer scene is solved beside the plain one (`placement::ladder::effects`).

use serde_json::{Value, json};

use fem_client::scene::{Film, Scene};
use fem_client::solver::Omission;

/// Coefficient of dry rubber on a hard ground, at its lower end.
const DRY_FRICTION: f64 = 0.5;
/// 2/kappa of rubber with a bulk modulus of 1000 MPa, at the soft end of what vulcanisates have.
const SOFT_RUBBER_D1_PER_MPA: f64 = 0.002;

/// Returns all that could be modelled, and isn't in this scene.
pub fn omissions(scene: &Scene) -> Vec<Omission> {
    let omission = |what: &'static str, why: String, overrides: Value| Omission {
        what,
        why,
        richer: laid_over(scene, &overrides),
    };
    let mut list = Vec::new();
    if scene.contact.friction == 0.0 {
        list.push(omission(
            "friction",
            format!("contact.friction is 0; its effect is that of {DRY_FRICTION}"),
            json!({"contact": {"friction": DRY_FRICTION}}),
        ));
    }
    list.push(match &scene.film {
        None => omission("film stiffness", film_text(), json!({"film": {}})),
        Some(_) => Omission {
            what: "film folding",
            why: "in compression the film resists as a smooth shell: where it is compressed beyond the strain at which it folds, its state says wrinkled. No scene has \
                  folds, so that their effect isn't known"
                .to_owned(),
            richer: None,
        },
    });
    if scene.carcass.is_none() {
        list.push(omission(
            "carcass",
            "the scene has none; its effect is that of two families of cords at 55 degrees with 100 N/mm each".to_owned(),
            json!({"carcass": {}}),
        ));
    }
    if scene.material.d1_per_mpa == 0.0 {
        let bulk_mpa = 2.0 / SOFT_RUBBER_D1_PER_MPA;
        list.push(omission(
            "compressibility",
            format!(
                "material.d1_per_mpa is 0; its effect is that of a bulk modulus of {bulk_mpa} MPa"
            ),
            json!({"material": {"d1_per_mpa": SOFT_RUBBER_D1_PER_MPA}}),
        ));
    }
    list
}

fn film_text() -> String {
    let film = Film::default();
    format!(
        "the film follows the inner surface without stiffening it: right only where its modulus times its thickness is far below the \
         wall's. The effect is that of a PVDF film of {} x {} x {} mm at P3, {} MPa; a [film] table models the one at hand",
        film.length_mm,
        film.width_mm,
        film.thickness_mm(),
        film.layers[0].modulus_mpa
    )
}

fn laid_over(scene: &Scene, overrides: &Value) -> Option<Scene> {
    scene.overlaid(overrides.as_object()?, "", &mut Vec::new())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_richer_scene_leaves_out_one_thing_less() {
        for scene in [Scene::default(), Scene::preset("foot-tire").unwrap()] {
            let names = |scene: &Scene| -> Vec<&str> {
                omissions(scene)
                    .iter()
                    .map(|omission| omission.what)
                    .collect()
            };
            let all = names(&scene);
            for omission in omissions(&scene) {
                let richer = omission.richer.expect("fits the reference tire");
                let mut left = names(&richer);
                left.retain(|what| *what != "film folding");
                let expected: Vec<&str> = all
                    .iter()
                    .copied()
                    .filter(|what| *what != omission.what)
                    .collect();
                assert_eq!(left, expected);
            }
        }
    }

    #[test]
    fn what_does_not_fit_the_scene_has_no_richer_one() {
        let mut scene = Scene::default();
        // The default film would be a sixth of this wall: no membrane.
        scene.geometry.wall_mm = 0.3;
        let film = omissions(&scene)
            .into_iter()
            .find(|o| o.what == "film stiffness");
        assert_eq!(film.unwrap().richer, None);
    }
}
