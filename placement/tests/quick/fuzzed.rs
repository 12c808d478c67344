//! The texts that fuzzing kept, read again: each found a way through a reader that no other had, or a fault that is mended since.

#[path = "../../../tests/fuzz/checks.rs"]
mod checks;

/// Every text of a corpus, which is a JSON string on each line.
fn replay(corpus: &str, check: fn(&str)) {
    let texts: Vec<String> = corpus
        .lines()
        .map(|line| serde_json::from_str(line).expect("a string on each line"))
        .collect();
    assert!(texts.len() > 50, "{} texts are no corpus", texts.len());
    texts.iter().for_each(|text| check(text));
}

#[test]
fn scenes() {
    replay(
        include_str!("../../../tests/fuzz/corpus/scene.jsonl"),
        checks::scene,
    );
}

#[test]
fn studies() {
    replay(
        include_str!("../../../tests/fuzz/corpus/study.jsonl"),
        checks::study,
    );
}

#[test]
fn sweeps() {
    replay(
        include_str!("../../../tests/fuzz/corpus/sweep.jsonl"),
        checks::sweep,
    );
}

#[test]
fn inputs_of_other_models() {
    replay(
        include_str!("../../../tests/fuzz/corpus/inputs.jsonl"),
        checks::inputs,
    );
}

#[test]
fn values_of_other_models() {
    replay(
        include_str!("../../../tests/fuzz/corpus/values.jsonl"),
        checks::values,
    );
}
