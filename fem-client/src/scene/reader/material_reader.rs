//! Reads the rubber.

use serde_json::Value;

use super::shared_ranges::{MODULUS, MODULUS_OR_ZERO};
use crate::document::fault::{Fault, entry, member};
use crate::document::fields::{Fields, Range, alternatives, number, plain, shown};
use crate::scene::{Law, Material, OgdenTerm};

const COMPRESSIBILITY: Range = Range::new(0.0, 1e6, "1/MPa");
/// Weights that may soften the rubber.
const WEIGHT: Range = Range::new(-1e6, 1e6, "MPa");
const EXPONENT: Range = Range::new(-30.0, 30.0, "");
/// Least size of an exponent: the terms are divided by its square.
const SMALLEST_EXPONENT: f64 = 1e-3;
const MOST_TERMS: usize = 6;

pub(super) fn material(value: &Value, pointer: &str, faults: &mut Vec<Fault>) -> Option<Material> {
    let default = Material::default();
    let law = match value.get("model") {
        None => Some(default.law),
        Some(model) => Law::all()
            .into_iter()
            .find(|law| model.as_str() == Some(law.model())),
    };
    let Some(law) = law else {
        return unknown_model(value, pointer, faults);
    };
    let fields = open(value, pointer, &law, faults)?;
    let law = parameters(&fields, law, faults);
    let d1 = fields.number("d1_per_mpa", COMPRESSIBILITY, default.d1_per_mpa, faults);
    Some(Material {
        law: law?,
        d1_per_mpa: d1?,
    })
}

/// Opens the table; a parameter of another law gets a fault that says so.
fn open<'v>(
    value: &'v Value,
    pointer: &str,
    law: &Law,
    faults: &mut Vec<Fault>,
) -> Option<Fields<'v>> {
    let own = [&["model"], law.fields(), &["d1_per_mpa"]].concat();
    let laws = Law::all();
    let is_foreign =
        |name: &&str| !own.contains(name) && laws.iter().any(|other| other.fields().contains(name));
    let names = value.as_object().into_iter().flat_map(|table| table.keys());
    let foreign: Vec<&str> = names.map(String::as_str).filter(is_foreign).collect();
    let fields = Fields::open(value, pointer, &[own.as_slice(), &foreign].concat(), faults)?;
    for name in foreign {
        let detail = format!(
            "is no parameter of model \"{}\", which has {}",
            law.model(),
            law.fields().join(", ")
        );
        Fault::add(faults, &fields.at(name), detail);
    }
    Some(fields)
}

/// Without the law nobody knows which fields are right: one fault, whatever the others are.
fn unknown_model(value: &Value, pointer: &str, faults: &mut Vec<Fault>) -> Option<Material> {
    let detail = format!(
        "must be {}; it is {}",
        alternatives(Law::all().iter().map(Law::model)),
        shown(&value["model"])
    );
    Fault::add(faults, &member(pointer, "model"), detail);
    None
}

/// Reads the parameters of a law, whose own ones are the defaults.
fn parameters(fields: &Fields<'_>, mut law: Law, faults: &mut Vec<Fault>) -> Option<Law> {
    let numbers = match &mut law {
        Law::NeoHookean { c10_mpa } => vec![("c10_mpa", MODULUS, c10_mpa)],
        Law::MooneyRivlin { c10_mpa, c01_mpa } => vec![
            ("c10_mpa", MODULUS, c10_mpa),
            ("c01_mpa", MODULUS_OR_ZERO, c01_mpa),
        ],
        Law::Yeoh {
            c10_mpa,
            c20_mpa,
            c30_mpa,
        } => vec![
            ("c10_mpa", MODULUS, c10_mpa),
            ("c20_mpa", WEIGHT, c20_mpa),
            ("c30_mpa", WEIGHT, c30_mpa),
        ],
        Law::Ogden { .. } => {
            return match fields.get("terms") {
                None => Some(law),
                Some((value, pointer)) => ogden(value, &pointer, faults),
            };
        }
    };
    fields.numbers(numbers, faults)?;
    Some(law)
}

fn ogden(value: &Value, pointer: &str, faults: &mut Vec<Fault>) -> Option<Law> {
    let items = value.as_array().map_or(&[] as &[Value], Vec::as_slice);
    if items.is_empty() || items.len() > MOST_TERMS {
        let detail = format!(
            "must be a list of 1 to {MOST_TERMS} terms {{ mu_mpa, alpha }}; it is {}",
            shown(value)
        );
        Fault::add(faults, pointer, detail);
        return None;
    }
    let read = |(i, item)| term(item, &entry(pointer, i), faults);
    // Every term is read, so that every fault is found.
    let terms: Vec<Option<OgdenTerm>> = items.iter().enumerate().map(read).collect();
    let law = Law::Ogden {
        terms: terms.into_iter().collect::<Option<_>>()?,
    };
    let modulus = law.shear_modulus_mpa();
    if modulus < MODULUS.low {
        let detail = format!(
            "the rubber is unstable: its initial shear modulus, the sum of mu_mpa, must be at least {} MPa; it is {}",
            plain(MODULUS.low),
            plain(modulus)
        );
        Fault::add(faults, pointer, detail);
    }
    Some(law)
}

fn term(value: &Value, pointer: &str, faults: &mut Vec<Fault>) -> Option<OgdenTerm> {
    let fields = Fields::open(value, pointer, &["mu_mpa", "alpha"], faults)?;
    let mut required = |name, range| {
        let (value, pointer) = fields.required(name, "a number", faults)?;
        number(value, &pointer, range, faults)
    };
    let (mu, alpha) = (required("mu_mpa", WEIGHT), required("alpha", EXPONENT));
    if let Some(alpha) = alpha.filter(|alpha| alpha.abs() < SMALLEST_EXPONENT) {
        let detail = format!(
            "must be at least {SMALLEST_EXPONENT} away from 0; it is {}",
            plain(alpha)
        );
        Fault::add(faults, &fields.at("alpha"), detail);
    }
    Some(OgdenTerm {
        mu_mpa: mu?,
        alpha: alpha?,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::Scene;

    fn faults(text: &str) -> Vec<(String, String)> {
        let faults = Scene::from_toml(&format!("[material]\n{text}")).expect_err(text);
        faults.into_iter().map(|f| (f.pointer, f.detail)).collect()
    }

    fn pointers(text: &str) -> Vec<String> {
        faults(text).into_iter().map(|f| f.0).collect()
    }

    fn law(text: &str) -> Law {
        let scene = Scene::from_toml(&format!("[material]\n{text}")).expect(text);
        scene.material.law
    }

    #[test]
    fn every_law_reads_its_parameters_and_has_defaults() {
        for expected in Law::all() {
            assert_eq!(law(&format!("model = \"{}\"", expected.model())), expected);
        }
        assert_eq!(
            law("model = \"yeoh\"\nc10_mpa = 0.17\nc20_mpa = -0.002\nc30_mpa = 6e-5"),
            Law::Yeoh {
                c10_mpa: 0.17,
                c20_mpa: -0.002,
                c30_mpa: 6e-5
            }
        );
        let text = "model = \"ogden\"\nterms = [{ mu_mpa = 0.5, alpha = 1.3 }, { mu_mpa = -0.1, alpha = -2 }]";
        let term = |mu_mpa, alpha| OgdenTerm { mu_mpa, alpha };
        let terms = vec![term(0.5, 1.3), term(-0.1, -2.0)];
        assert_eq!(law(text), Law::Ogden { terms });
    }

    #[test]
    fn a_parameter_of_another_law_is_a_fault() {
        let found = faults("model = \"neo-hookean\"\nc01_mpa = 0.036\nterms = []\ncolour = 1");
        let places: Vec<&str> = found.iter().map(|f| f.0.as_str()).collect();
        assert_eq!(
            places,
            ["/material/colour", "/material/c01_mpa", "/material/terms"]
        );
        assert_eq!(
            found[1].1,
            "is no parameter of model \"neo-hookean\", which has c10_mpa"
        );
        assert_eq!(pointers("c20_mpa = 1"), ["/material/c20_mpa"]);
        assert_eq!(
            pointers("model = \"ogden\"\nc10_mpa = 1"),
            ["/material/c10_mpa"]
        );
    }

    #[test]
    fn unknown_laws_and_wrong_terms_are_named() {
        assert_eq!(
            faults("model = \"gent\"\nj_m = 1"),
            [(
                "/material/model".to_owned(),
                "must be \"mooney-rivlin\", \"neo-hookean\", \"yeoh\" or \"ogden\"; it is \"gent\""
                    .to_owned()
            )]
        );
        let ogden = |terms: &str| pointers(&format!("model = \"ogden\"\nterms = {terms}"));
        for bad in ["[]", "1", "{ mu_mpa = 1, alpha = 2 }"] {
            assert_eq!(ogden(bad), ["/material/terms"]);
        }
        assert_eq!(
            ogden("[{ alpha = 0 }, { mu_mpa = 1, alpha = 31, beta = 2 }, 3]"),
            [
                "/material/terms/0/mu_mpa",
                "/material/terms/0/alpha",
                "/material/terms/1/beta",
                "/material/terms/1/alpha",
                "/material/terms/2"
            ]
        );
    }

    #[test]
    fn a_rubber_without_shear_modulus_is_unstable() {
        let text = "model = \"ogden\"\nterms = [{ mu_mpa = 0.3, alpha = 2 }, { mu_mpa = -0.3, alpha = -2 }]";
        let found = faults(text);
        assert_eq!(found[0].0, "/material/terms");
        assert!(found[0].1.contains("unstable"), "{}", found[0].1);
        assert_eq!(
            pointers("model = \"yeoh\"\nc10_mpa = -0.1"),
            ["/material/c10_mpa"]
        );
    }
}
