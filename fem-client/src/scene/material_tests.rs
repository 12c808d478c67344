//! Rubber as it stands in documents.

use document::Variants as _;
use document::typed::field_value::Field;

use super::*;
use crate::scene::Scene;

#[test]
fn all_defaults_have_the_papers_shear_modulus() {
    for law in Law::all() {
        let modulus = law.shear_modulus_mpa();
        assert!((modulus - 0.36).abs() < 1e-15, "{law:?}: {modulus}");
    }
}

#[test]
fn a_document_has_the_model_its_parameters_and_the_compressibility() {
    for law in Law::all() {
        let (model, fields) = (law.name(), law.own_names());
        let d1_per_mpa = 0.5;
        let document = Material { law, d1_per_mpa }.write().unwrap();
        assert_eq!(document["model"], model);
        let names: Vec<&str> = document
            .as_object()
            .unwrap()
            .keys()
            .map(String::as_str)
            .collect();
        let expected = [&["model"], fields, &["d1_per_mpa"]].concat();
        assert_eq!(names, expected);
    }
}

fn law(text: &str) -> Law {
    let scene = Scene::from_toml(&format!("[material]\n{text}")).expect(text);
    scene.material.law
}

#[test]
fn every_law_reads_its_parameters_and_has_defaults() {
    for expected in Law::all() {
        assert_eq!(law(&format!("model = \"{}\"", expected.name())), expected);
    }
    assert_eq!(
        law("model = \"yeoh\"\nc10_mpa = 0.17\nc20_mpa = -0.002\nc30_mpa = 6e-5"),
        Law::Yeoh {
            c10_mpa: 0.17,
            c20_mpa: -0.002,
            c30_mpa: 6e-5
        }
    );
    let text =
        "model = \"ogden\"\nterms = [{ mu_mpa = 0.5, alpha = 1.3 }, { mu_mpa = -0.1, alpha = -2 }]";
    let term = |mu_mpa, alpha| OgdenTerm { mu_mpa, alpha };
    let terms = vec![term(0.5, 1.3), term(-0.1, -2.0)];
    assert_eq!(law(text), Law::Ogden { terms });
}
