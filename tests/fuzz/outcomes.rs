//! Outcomes of each reader for a text, word for word: its faults, or the canonical form of what was read.
//!
//! `fuzzed` of `placement` compares it, by a digest a text, with what was recorded.

use document::fault::Fault;
use document::parse;
use documents::own_model::inputs_document::Inputs;
use documents::own_model::value_table::ValueTable;
use documents::study::Study;
use documents::sweep::{Design, MOST_SUBMITTED, Sweep, designs_of, sweep_of, typed_grid};
use fem_client::scene::Scene;

use super::checks::{base, format_of, shipped};

/// Outcome of a reader for a text.
pub struct Outcome {
    /// Whether it was read.
    pub is_read: bool,
    /// The faults, or the canonical form.
    pub words: String,
}

/// The outcome of a scene.
pub fn scene(text: &str) -> Outcome {
    told(Scene::from_text(text, format_of(text)), |scene| {
        scene.canonical_json()
    })
}

/// The outcome of a study.
pub fn study(text: &str) -> Outcome {
    told(
        Study::from_document(text, format_of(text), &shipped),
        |study| study.canonical(),
    )
}

/// The outcome of a sweep, of further designs, or of typed grids.
pub fn sweep(text: &str) -> Outcome {
    if text.starts_with("--grid ") {
        let lines = text.lines();
        let typed: Vec<String> = lines
            .filter_map(|line| line.strip_prefix("--grid "))
            .map(str::to_owned)
            .collect();
        let swept = typed_grid(&typed).and_then(|grid| sweep_of(base().clone(), None, &grid));
        return told(swept, |sweep| designs(&sweep.designs));
    }
    let document = match parse(text, format_of(text)) {
        Ok(document) => document,
        Err(faults) => return told(Err(faults), |()| String::new()),
    };
    if document.get("study").is_none() {
        return told(designs_of(base(), &document, MOST_SUBMITTED), |found| {
            designs(&found)
        });
    }
    told(
        Sweep::from_value(&document, MOST_SUBMITTED, &shipped),
        |sweep| designs(&sweep.designs),
    )
}

/// The outcome of an inputs file for models of others.
pub fn inputs(text: &str) -> Outcome {
    told(Inputs::from_document(text, format_of(text)), |inputs| {
        format!("{:?} {:?} {:?}", inputs.names, inputs.laws, inputs.method)
    })
}

/// The outcome of a table of values.
pub fn values(text: &str) -> Outcome {
    told(ValueTable::from_csv(text), |table| {
        format!("{:?}", table.leading_rows())
    })
}

fn designs(designs: &[Design]) -> String {
    let lines = designs
        .iter()
        .map(|design| format!("{} {}", design.name, design.study.canonical()));
    lines.collect::<Vec<_>>().join("\n")
}

fn told<T>(read: Result<T, Vec<Fault>>, shown: impl Fn(T) -> String) -> Outcome {
    match read {
        Ok(read) => Outcome {
            is_read: true,
            words: shown(read),
        },
        Err(faults) => {
            // Their order isn't promised.
            let mut lines: Vec<String> = faults.iter().map(Fault::to_string).collect();
            lines.sort();
            Outcome {
                is_read: false,
                words: lines.join("\n"),
            }
        }
    }
}
