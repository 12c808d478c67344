//! Films as they stand in documents.

use crate::film::amplifier::Circuit;
use crate::scene::{Film, Scene};

#[test]
fn an_empty_film_table_is_the_default_film_and_none_is_no_film() {
    let read = |text| Scene::from_toml(text).expect("reads").film;
    assert_eq!(read("[film]"), Some(Film::default()));
    assert_eq!(read(""), None);
    // At the bead's side a narrow film still fits.
    assert!(read("[film]\nphi_deg = 108\nwidth_mm = 3").is_some());
}

#[test]
fn a_film_s_tables_have_defaults_of_their_kind() {
    let film = |text: &str| Scene::from_toml(text).map(|scene| scene.film.expect("a film"));
    let charge = film("[film.amplifier]\nkind = \"charge\"\nfeedback_nf = 2").expect("reads");
    let expected = Circuit::Charge {
        feedback_nf: 2.0,
        feedback_mohm: 1000.0,
    };
    assert_eq!(charge.amplifier.circuit, expected);
    let scene = Scene {
        film: Some(charge),
        ..Scene::default()
    };
    assert_eq!(Scene::from_json(&scene.canonical_json()), Ok(scene));
}

#[test]
fn layers_are_a_list_with_one_that_makes_charge() {
    let of = |layers: &str| format!("[film]\nlayers = [{layers}]");
    let polyester = "{ modulus_mpa = 3500, thickness_mm = 0.125 }";
    let pvdf = "{ thickness_mm = 0.028, piezo = true }";
    let scene = Scene::from_toml(&of(&format!("{polyester}, {pvdf}"))).expect("reads");
    let film = scene.film.clone().expect("a film");
    assert_eq!((film.thickness_mm(), film.layers[1].piezo), (0.153, true));
    assert_eq!(Scene::from_json(&scene.canonical_json()), Ok(scene));
    // A list of one is the film of one layer.
    assert_eq!(
        Scene::from_toml(&of(pvdf)),
        Scene::from_toml("[film]\nthickness_mm = 0.028")
    );
}
