//! Limits of CalculiX: what of a scene it can model, and what has to be changed or refused.

use document::fault::Fault;
use fem_client::scene::{Law, Material, Scene};
use fem_client::solver::{Choice, ModelSummary};

use super::deck::MAX_OGDEN_TERMS;

/// Largest bulk modulus over shear modulus for CalculiX's 8-node bricks with one integration point. They are within 1 % of mixed
/// elements there; at ten times as much they are 20 % off without a warning, and its other bricks lock or fail.
pub(crate) const LARGEST_BULK_RATIO: f64 = 100.0;

/// Returns all in a scene that CalculiX can't be asked for.
pub fn faults(scene: &Scene) -> Vec<Fault> {
    let mut faults = Vec::new();
    if scene.carcass.is_some() {
        let detail = "isn't available with CalculiX, which has no membrane of cords that go slack in compression; leave \
                      the table out, or use the embedded solver";
        Fault::add(&mut faults, "/carcass", detail);
    }
    if scene.film.is_some() {
        let detail =
            "isn't modelled with CalculiX; leave the table out, or use the embedded solver";
        Fault::add(&mut faults, "/film", detail);
    }
    if let Law::Ogden { terms } = &scene.material.law
        && terms.len() > MAX_OGDEN_TERMS
    {
        let detail = format!(
            "must be at most {MAX_OGDEN_TERMS} terms with CalculiX; there are {}; or use the embedded solver",
            terms.len()
        );
        Fault::add(&mut faults, "/material/terms", detail);
    }
    if scene.contact.friction != 0.0 {
        let detail = "must be 0 with CalculiX, whose contact here is without friction; or use the embedded solver";
        Fault::add(&mut faults, "/contact/friction", detail);
    }
    if scene.ground.is_dragged() {
        let detail = "must be [0, 0] with CalculiX, whose ground here isn't dragged; or use the embedded solver";
        Fault::add(&mut faults, "/ground/shift_mm", detail);
    }
    if scene.ground.profile.is_some() {
        let detail = "isn't modelled with CalculiX, whose ground here is one of stations; leave it out, or use the embedded solver";
        Fault::add(&mut faults, "/ground/profile", detail);
    }
    faults
}

/// The rubber as CalculiX gets it, no stiffer against change of volume than [`LARGEST_BULK_RATIO`].
pub fn rubber(material: &Material) -> Material {
    Material {
        law: material.law.clone(),
        d1_per_mpa: material.d1_per_mpa.max(least_d1(material)),
    }
}

fn least_d1(material: &Material) -> f64 {
    2.0 / (LARGEST_BULK_RATIO * material.law.shear_modulus_mpa())
}

/// Returns the summary of CalculiX's model: how each part of the scene is modelled, and what is left out on top of `summary`, the embedded solver's.
pub fn summary(scene: &Scene, summary: ModelSummary, version: &str) -> ModelSummary {
    let choice = |what: &str, why: String| Choice {
        what: what.to_owned(),
        why,
        effect: None,
    };
    let bulk_modulus = 2.0 / rubber(&scene.material).d1_per_mpa;
    let modelled = vec![
        choice(
            "solver",
            format!("CalculiX {version}: inflated alone for the ground's height, then inflated and pressed in one step"),
        ),
        choice(
            "wall",
            "three-dimensional, 8-node bricks with one integration point and hourglass control (C3D8R); CalculiX's other \
             bricks lock or fail"
                .to_owned(),
        ),
        choice(
            "rubber",
            format!(
                "{}, bulk modulus {bulk_modulus:.6} MPa",
                scene.material.law.title()
            ),
        ),
        choice(
            "pressure",
            "live load: it follows the deformed inner surface".to_owned(),
        ),
        choice(
            "contact",
            "rigid ground, node to surface, linear pressure over penetration".to_owned(),
        ),
    ];
    let mut left_out = summary.left_out;
    if scene.material.d1_per_mpa < least_d1(&scene.material) {
        left_out.push(Choice {
            what: "incompressibility".to_owned(),
            why: format!(
                "d1_per_mpa is {}; CalculiX gets {:.6}, a bulk modulus of {LARGEST_BULK_RATIO} shear moduli, beyond which its \
                 bricks fail; the effect is of the order of their ratio",
                scene.material.d1_per_mpa,
                least_d1(&scene.material)
            ),
            effect: Some(1.0 / LARGEST_BULK_RATIO),
        });
    }
    ModelSummary {
        modelled,
        left_out,
        ..summary
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use fem_client::scene::{Carcass, Film, OgdenTerm};

    #[test]
    fn a_faulty_scene_gets_every_fault_at_its_place() {
        assert_eq!(faults(&Scene::default()), []);
        let mut scene = Scene {
            carcass: Some(Carcass::default()),
            film: Some(Film::default()),
            ..Scene::default()
        };
        scene.contact.friction = 0.3;
        scene.ground.shift_mm = [0.5, 0.0];
        let term = OgdenTerm {
            mu_mpa: 0.1,
            alpha: 2.0,
        };
        scene.material.law = Law::Ogden {
            terms: vec![term; 4],
        };
        let pointers: Vec<String> = faults(&scene).into_iter().map(|f| f.pointer).collect();
        assert_eq!(
            pointers,
            [
                "/carcass",
                "/film",
                "/material/terms",
                "/contact/friction",
                "/ground/shift_mm"
            ]
        );
    }

    #[test]
    fn rubber_is_only_softened_when_it_is_too_stiff_and_the_summary_says_so() {
        let mut scene = Scene::default();
        let noted = |scene: &Scene| {
            let summary = summary(scene, ModelSummary::default(), "9.9");
            summary
                .left_out
                .iter()
                .any(|c| c.what == "incompressibility")
        };
        // mu = 0.36 MPa, kappa = 36 MPa.
        assert!((rubber(&scene.material).d1_per_mpa - 2.0 / 36.0).abs() < 1e-15);
        assert!(noted(&scene));
        scene.material.d1_per_mpa = 0.1;
        assert_eq!(rubber(&scene.material), scene.material);
        assert!(!noted(&scene));
    }
}
