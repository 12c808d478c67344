//! Studies and scenes to start from: the documents that ship.

// What users send is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

use document::{Format, parse};
use fem_client::scene::PRESETS;
use serde_json::Value;

use crate::wire::study_wire::{Preset, Presets};

/// Returns the documents that ship.
pub fn shipped() -> Presets {
    let studies = documents::study::presets().into_iter();
    Presets {
        studies: studies.filter_map(preset).collect(),
        scenes: PRESETS.into_iter().filter_map(preset).collect(),
    }
}

/// A shipped document as JSON, so that a page can show it, change it and submit it.
fn preset((name, text): (&str, &str)) -> Option<Preset> {
    let document = parse(text, Format::Toml).ok()?;
    let title = document.get("name").and_then(Value::as_str).unwrap_or(name);
    Some(Preset {
        name: name.to_owned(),
        title: title.to_owned(),
        comment: comment(text),
        document,
    })
}

/// The comment at the head of a shipped document, without what editors read of it.
fn comment(text: &str) -> String {
    let head = text
        .lines()
        .map_while(|line| line.strip_prefix('#'))
        .filter(|line| !line.starts_with(":schema"))
        .map(str::trim);
    head.collect::<Vec<_>>().join(" ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_shipped_document_is_told_with_its_title() {
        let all = shipped();
        assert_eq!(all.studies.len(), documents::study::presets().len());
        assert_eq!(all.scenes.len(), PRESETS.len());
        assert!(all.studies.iter().all(|study| study.title != study.name));
    }
}
