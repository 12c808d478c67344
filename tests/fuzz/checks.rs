//! Checks for every text that a reader is given, whatever is in it: no panic, no number that isn't finite, and faults that say where.
//!
//! The fuzzer calls these with texts of its own making, `placement/tests/quick/fuzzed.rs` with those that it kept.

use std::sync::OnceLock;

use document::fault::{Fault, MAX_FAULTS};
use document::{Format, parse};
use documents::own_model::inputs_document::Inputs;
use documents::own_model::value_table::ValueTable;
use documents::study::plan::Plan;
use documents::study::{Study, presets};
use documents::sweep::{Design, MOST_SUBMITTED, Sweep, designs_of, sweep_of, typed_grid};
use fem_client::scene::Scene;
use gsa::campaign::Campaign;
use gsa::law::distribution::Distribution;
use gsa::method::analysis::Analysis;
use gsa::method::{Kind, Method};
use serde_json::{Value, json};

const OF_SCENE: [&str; 8] = [
    "geometry", "material", "carcass", "film", "pressure", "ground", "contact", "model",
];
const OF_STUDY: [&str; 8] = [
    "name",
    "scene",
    "inputs",
    "candidates",
    "layouts",
    "method",
    "accuracy",
    "signals",
];
const OF_INPUTS: [&str; 2] = ["inputs", "method"];
const OF_SWEEP: [&str; 4] = ["name", "study", "grid", "designs"];

/// More points than this take longer to plan than a fuzzer should wait.
const MOST_PLANNED: usize = 2000;

/// A scene is refused with its faults, or its canonical text reads back as the same scene.
pub fn scene(text: &str) {
    match Scene::from_text(text, format_of(text)) {
        Ok(scene) => {
            let canonical = scene.canonical_json();
            assert_eq!(Scene::from_json(&canonical), Ok(scene), "{canonical}");
        }
        Err(faults) => say_where(&faults, text, &OF_SCENE),
    }
}

/// A study is refused with its faults, or has a plan of finite points, and its canonical text reads back as the same study.
pub fn study(text: &str) {
    match Study::from_document(text, format_of(text), &shipped) {
        Ok(study) => {
            let canonical = study.canonical();
            let again = Study::from_document(&canonical, Format::Json, &shipped);
            assert_eq!(again.as_ref(), Ok(&study), "{canonical}");
            let plan = Plan::new(&study).expect("a study that was read has a plan");
            assert!(plan.values().iter().flatten().all(|x| x.is_finite()));
            assert_eq!(plan.values().len(), plan.points.len());
        }
        Err(faults) => say_where(&faults, text, &OF_STUDY),
    }
}

/// A sweep's document, further designs of one (a document without a study), or grids as typed, a line each: refused with the faults, or its
/// designs hold.
pub fn sweep(text: &str) {
    if text.starts_with("--grid ") {
        return typed(text);
    }
    let document = match parse(text, format_of(text)) {
        Ok(document) => document,
        Err(faults) => return say_where(&faults, text, &OF_SWEEP),
    };
    if document.get("study").is_none() {
        return match designs_of(base(), &document, MOST_SUBMITTED) {
            Ok(designs) => hold(base(), &designs),
            Err(faults) => say_where_of_sweep(&faults, text),
        };
    }
    match Sweep::from_value(&document, MOST_SUBMITTED, &shipped) {
        Ok(sweep) => hold(&sweep.base, &sweep.designs),
        Err(faults) => say_where_of_sweep(&faults, text),
    }
}

/// Grids of a command line.
fn typed(text: &str) {
    let texts: Vec<String> = text
        .lines()
        .filter_map(|line| line.strip_prefix("--grid "))
        .map(str::to_owned)
        .collect();
    let swept = typed_grid(&texts).and_then(|grid| sweep_of(base().clone(), None, &grid));
    match swept {
        Ok(sweep) => hold(&sweep.base, &sweep.designs),
        Err(faults) => {
            assert!(!faults.is_empty() && faults.len() <= MAX_FAULTS + 1);
            for fault in faults {
                assert!(!fault.to_string().contains(char::is_control), "{fault:?}");
                let placed = fault.pointer.starts_with("/grid");
                assert!(
                    placed
                        || fault.detail.starts_with("--grid")
                        || fault.detail.contains("more than"),
                    "{fault:?}"
                );
            }
        }
    }
}

/// The study that further designs and typed grids are of.
pub fn base() -> &'static Study {
    static BASE: OnceLock<Study> = OnceLock::new();
    BASE.get_or_init(|| {
        Study::from_document(presets()[0].1, Format::Toml, &shipped).expect("the study ships")
    })
}

/// Each design is a study of its own that has what the design sets, reads back as itself, and is the same when it is told alone.
fn hold(base: &Study, designs: &[Design]) {
    assert!((1..=MOST_SUBMITTED).contains(&designs.len()));
    // The others of a large grid are made in the same way.
    let some = &designs[..designs.len().min(MOST_HELD)];
    for design in some {
        let Design { name, set, study } = design;
        assert!(
            !name.trim().is_empty() && !name.contains(char::is_control),
            "{name:?}"
        );
        let canonical = study.canonical();
        let again = Study::from_document(&canonical, Format::Json, &shipped);
        assert_eq!(again.as_ref(), Ok(study), "{canonical}");
        assert_eq!(study.scene.model.level, study.level);
        if let (1, Some((path, value))) = (set.len(), set.iter().next())
            && let (Some(wanted), Ok(found)) = (value.as_f64(), study.scene.number_at(path))
        {
            assert_eq!(found, wanted, "{path}");
        }
    }
    let alone = some
        .iter()
        .map(|Design { name, set, .. }| json!({"name": name, "set": set}));
    let alone = json!({"designs": alone.collect::<Vec<_>>()});
    assert_eq!(
        designs_of(base, &alone, MOST_SUBMITTED).as_deref(),
        Ok(some),
        "{alone}"
    );
}

/// Designs of which more is asked than that they are there.
const MOST_HELD: usize = 8;

/// Checks places as of any other document, but that a sweep may lack both grid and designs, or have both.
fn say_where_of_sweep(faults: &[Fault], text: &str) {
    let either =
        |fault: &Fault| fault.pointer.is_empty() && fault.detail.contains("exactly one of grid");
    let placed: Vec<Fault> = faults
        .iter()
        .filter(|fault| !either(fault))
        .cloned()
        .collect();
    if !placed.is_empty() || faults.is_empty() {
        say_where(&placed, text, &OF_SWEEP);
    }
}

/// Inputs and method are refused with their faults, or there is a reason why they have no plan, or a plan of finite points.
pub fn inputs(text: &str) {
    let inputs = match Inputs::from_document(text, format_of(text)) {
        Ok(inputs) => inputs,
        Err(faults) => return say_where(&faults, text, &OF_INPUTS),
    };
    assert_eq!(inputs.names.len(), inputs.laws.len());
    let points = inputs.method.first_points(inputs.laws.len());
    if points.saturating_mul(inputs.laws.len()) > MOST_PLANNED {
        return;
    }
    match Campaign::new(&inputs.laws, inputs.method) {
        Ok(campaign) => {
            for point in campaign.points() {
                assert_eq!(point.len(), inputs.laws.len());
                assert!(point.iter().all(|x| x.is_finite()), "{point:?}");
            }
        }
        Err(error) => assert!(!error.to_string().is_empty()),
    }
}

/// Values are refused with the lines of their faults, or every method makes finite numbers of them, or none.
pub fn values(text: &str) {
    let table = match ValueTable::from_csv(text) {
        Ok(table) => table,
        Err(faults) => {
            assert!(!faults.is_empty() && faults.len() <= MAX_FAULTS + 1);
            let more = |fault: &Fault| fault.detail.contains("more than");
            let said = |fault: &Fault| fault.detail.starts_with("line ") || more(fault);
            assert!(faults.iter().all(said), "{faults:?}");
            return;
        }
    };
    let rows = table.leading_rows();
    let laws = [
        Distribution::uniform(-1.0, 1.0).expect("a law"),
        Distribution::normal(2.0, 0.5).expect("a law"),
    ];
    for kind in Kind::ALL {
        let method = Method {
            nodes: 3,
            check_points: 2,
            samples: 8,
            most_runs: 30,
            ..Method::of(kind)
        };
        let (_, found) = Campaign::replay(&laws, method, &rows.view()).expect("such a design");
        for (analysis, half_unit) in found.into_iter().flatten().zip(table.half_units()) {
            assert!(is_finite(&analysis), "{}: {analysis:?}", kind.as_str());
            let analysis = analysis.of_printed(half_unit);
            assert!(is_finite(&analysis), "{}: {analysis:?}", kind.as_str());
        }
    }
}

/// JSON begins with a brace; TOML can't.
pub fn format_of(text: &str) -> Format {
    if text.trim_start().starts_with('{') {
        Format::Json
    } else {
        Format::Toml
    }
}

/// The one scene file that there is.
pub fn shipped(path: &str) -> Result<String, String> {
    match path {
        "scenes/foot-tire.toml" => Ok(include_str!("../../scenes/foot-tire.toml").to_owned()),
        _ => Err(format!("there is no file {path:?}")),
    }
}

/// Every fault has a sentence without control characters, which could forge lines of a log, and points into a table that was read: to
/// something in it, or to a field that it lacks.
fn say_where(faults: &[Fault], text: &str, known: &[&str]) {
    assert!(!faults.is_empty() && faults.len() <= MAX_FAULTS + 1);
    let document = parse(text, format_of(text));
    for fault in faults {
        let (detail, said) = (&fault.detail, fault.to_string());
        assert!(!detail.trim().is_empty(), "{fault:?}");
        assert!(!said.contains(char::is_control), "{fault:?}");
        let closing = detail.contains("more than 100 faults");
        let table = match &document {
            Ok(Value::Object(table)) if !closing => table,
            // What can't be read as a document has no faults but its own.
            Err(refused) => {
                assert!(refused.contains(fault), "{fault:?}");
                continue;
            }
            Ok(_) => {
                assert_eq!(fault.pointer, "", "{fault:?}");
                continue;
            }
        };
        let member = fault.pointer.strip_prefix('/').map(|rest| {
            let first = rest.split('/').next().unwrap_or_default();
            first.replace("~1", "/").replace("~0", "~")
        });
        let member = member.unwrap_or_else(|| panic!("{fault:?} points nowhere"));
        assert!(
            table.contains_key(&member) || known.contains(&member.as_str()),
            "{fault:?}"
        );
    }
}

fn is_finite(analysis: &Analysis) -> bool {
    let lists = [
        &analysis.first_order,
        &analysis.total,
        &analysis.second_order,
        &analysis.mdrm_first_order,
        &analysis.mdrm_total,
        &analysis.error.by_input,
    ];
    let numbers = [
        analysis.mean,
        analysis.variance,
        analysis.error.quadrature,
        analysis.error.decomposition,
        analysis.error.sampling,
        analysis.error.total,
        Some(analysis.error.floor),
    ];
    let in_lists = lists.into_iter().flatten().flatten();
    numbers
        .iter()
        .flatten()
        .chain(in_lists)
        .all(|x| x.is_finite())
}
