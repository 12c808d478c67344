//! The texts that fuzzing kept, read again: each found a way through a reader that no other had, or a fault that is mended since.
//!
//! What a reader makes of each is recorded in `tests/fuzz/outcomes`: whether it was read, and a digest of the words. After a change that is meant, `STRAINSITE_RECORD=1` records anew.

use std::path::Path;

use sha2::{Digest, Sha256};

#[path = "../../../tests/fuzz/checks.rs"]
mod checks;
#[path = "../../../tests/fuzz/outcomes.rs"]
mod outcomes;

use outcomes::Outcome;

/// Hexadecimal digits of a digest: by chance two of 10 000 texts share theirs once in five million corpora.
const DIGITS: usize = 12;

/// Every text of a corpus, which is a JSON string on each line: what must hold of it, and the outcome that is recorded.
fn replay(reader: &str, corpus: &str, check: fn(&str), outcome: fn(&str) -> Outcome) {
    let texts: Vec<String> = corpus
        .lines()
        .map(|line| serde_json::from_str(line).expect("a string on each line"))
        .collect();
    assert!(texts.len() > 50, "{} texts are no corpus", texts.len());
    texts.iter().for_each(|text| check(text));
    let outcomes: Vec<Outcome> = texts.iter().map(|text| outcome(text)).collect();
    let digests: Vec<String> = outcomes.iter().map(line).collect();
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests/fuzz/outcomes");
    let file = folder.join(format!("{reader}.txt"));
    if std::env::var_os("STRAINSITE_RECORD").is_some() {
        std::fs::write(&file, digests.join("\n") + "\n").expect("the record is written");
    }
    let recorded = std::fs::read_to_string(&file).expect("a record");
    let recorded: Vec<&str> = recorded.lines().collect();
    assert_eq!(
        recorded.len(),
        texts.len(),
        "{reader}: texts and recorded outcomes"
    );
    for (k, digest) in digests.iter().enumerate() {
        assert_eq!(
            digest, recorded[k],
            "{reader} {k}: another outcome of {:?}, now\n{}",
            texts[k], outcomes[k].words
        );
    }
}

fn line(outcome: &Outcome) -> String {
    let bytes = Sha256::digest(&outcome.words);
    let digits: String = bytes.iter().map(|byte| format!("{byte:02x}")).collect();
    let ending = if outcome.is_read { " read" } else { "" };
    digits[..DIGITS].to_owned() + ending
}

#[test]
fn scenes() {
    replay(
        "scene",
        include_str!("../../../tests/fuzz/corpus/scene.jsonl"),
        checks::scene,
        outcomes::scene,
    );
}

#[test]
fn studies() {
    replay(
        "study",
        include_str!("../../../tests/fuzz/corpus/study.jsonl"),
        checks::study,
        outcomes::study,
    );
}

#[test]
fn sweeps() {
    replay(
        "sweep",
        include_str!("../../../tests/fuzz/corpus/sweep.jsonl"),
        checks::sweep,
        outcomes::sweep,
    );
}

#[test]
fn inputs_of_other_models() {
    replay(
        "inputs",
        include_str!("../../../tests/fuzz/corpus/inputs.jsonl"),
        checks::inputs,
        outcomes::inputs,
    );
}

#[test]
fn values_of_other_models() {
    replay(
        "values",
        include_str!("../../../tests/fuzz/corpus/values.jsonl"),
        checks::values,
        outcomes::values,
    );
}
