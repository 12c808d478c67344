//! Documents changed at random: read or refused, never a panic.

use document::Format;
use documents::study::{Study, presets};
use proptest::prelude::*;
use serde_json::{Value, json};

use super::valid;
use crate::support::shipped;

/// A leaf of a document, or what could stand in its place.
fn any_value() -> impl Strategy<Value = Value> {
    prop_oneof![
        Just(Value::Null),
        any::<bool>().prop_map(Value::from),
        any::<i64>().prop_map(Value::from),
        any::<f64>().prop_map(Value::from),
        (0.0..3.0_f64).prop_map(Value::from),
        ".{0,12}".prop_map(Value::from),
        Just(json!([])),
        Just(json!([1, 2, 3])),
        Just(json!({})),
        Just(json!({"kind": "normal", "mean": 1, "std": 0.05})),
        Just(json!("ground.depths_mm[99999999999999]")),
        Just(json!("draft")),
    ]
}

/// Pointers of all values below this one.
fn all_pointers(value: &Value, at: &str, found: &mut Vec<String>) {
    let children: Vec<(String, &Value)> = match value {
        Value::Object(object) => object
            .iter()
            .map(|(k, v)| (format!("{at}/{k}"), v))
            .collect(),
        Value::Array(items) => items
            .iter()
            .enumerate()
            .map(|(i, v)| (format!("{at}/{i}"), v))
            .collect(),
        _ => Vec::new(),
    };
    for (pointer, child) in children {
        all_pointers(child, &pointer, found);
        found.push(pointer);
    }
}

proptest! {
    #[test]
    fn mutated_documents_are_read_or_refused_with_pointers(
        changes in prop::collection::vec((any::<prop::sample::Index>(), any_value(), any::<bool>()), 1..6),
        inline in any::<bool>(),
    ) {
        let mut document = valid();
        if inline {
            document["scene"] = shipped("foot-tire").scene.to_value();
        }
        for (index, value, rename) in changes {
            let mut found = Vec::new();
            all_pointers(&document, "", &mut found);
            let pointer = &found[index.index(found.len())];
            let (parent, name) = pointer.rsplit_once('/').unwrap();
            match document.pointer_mut(parent) {
                Some(Value::Object(object)) if rename => {
                    object.remove(name);
                    object.insert("renamed".to_owned(), value);
                }
                _ => *document.pointer_mut(pointer).unwrap() = value,
            }
            if !document.is_object() || found.len() < 2 {
                break;
            }
        }
        match Study::from_value(&document, &|path| Err(format!("no file {path}"))) {
            Ok(study) => reads_back(&study)?,
            Err(faults) => {
                prop_assert!(!faults.is_empty());
                for fault in faults {
                    prop_assert!(fault.pointer.is_empty() || fault.pointer.starts_with('/'));
                    prop_assert!(!fault.detail.is_empty());
                }
            }
        }
    }

    #[test]
    fn cut_and_garbled_texts_never_panic(
        which in 0..2_usize, from in 0..3000_usize, length in 0..40_usize, garbage in ".{0,20}",
    ) {
        let text = presets()[which].1;
        let boundary = |i: usize| (0..=i.min(text.len())).rev().find(|i| text.is_char_boundary(*i)).unwrap();
        let (from, to) = (boundary(from), boundary(from + length));
        let garbled = format!("{}{garbage}{}", &text[..from], &text[to.max(from)..]);
        for format in [Format::Toml, Format::Json] {
            if let Ok(study) = Study::from_document(&garbled, format, &|_| Err("none".to_owned())) {
                reads_back(&study)?;
            }
        }
    }

    #[test]
    fn canonical_texts_read_back_as_the_same_study(
        depths in prop::collection::vec((0.3..0.9_f64, 0.01..2.0_f64), 5),
        nodes in 1..=15_usize, check_points in 0..40_usize, seed in any::<u64>(),
        grid in prop::option::of((1..40_usize, 1..20_usize, 0.1..180.0_f64)),
    ) {
        let inputs: Vec<Value> = depths.iter().enumerate().map(|(i, (min, width))| json!({
            "name": format!("d{i}"), "vary": format!("ground.depths_mm[{i}]"),
            "distribution": {"kind": "uniform", "min": min, "max": min + width},
        })).collect();
        let mut document = json!({
            "name": "random", "scene": {"preset": "foot-tire"}, "inputs": inputs,
            "method": {"nodes": nodes, "check_points": check_points, "seed": seed},
        });
        if let Some((half_columns, half_rows, width)) = grid {
            document["candidates"] = json!({"grid": {
                "circumferential": 2 * half_columns + 1, "meridional": 2 * half_rows + 1, "half_width_deg": width,
            }});
        }
        let study = Study::from_value(&document, &|_| Err(String::new()));
        reads_back(&study.map_err(|faults| TestCaseError::fail(format!("{faults:?}")))?)?;
    }
}

fn reads_back(study: &Study) -> Result<(), TestCaseError> {
    let text = study.canonical();
    let again = Study::from_document(&text, Format::Json, &|_| Err("no files".to_owned()));
    let again = again.map_err(|faults| TestCaseError::fail(format!("{faults:?}")))?;
    prop_assert_eq!(&again, study);
    prop_assert_eq!(again.canonical(), text);
    prop_assert_eq!(again.spec_sha256().len(), 64);
    Ok(())
}
