//! Texts that the fuzzer found worth keeping.

#[path = "../../../tests/fuzz/recorded_checks.rs"]
mod recorded_checks;

/// Every text of a corpus, which is a JSON string on each line.
fn replay(corpus: &str, check: fn(&str)) {
    let texts: Vec<String> = corpus
        .lines()
        .map(|line| serde_json::from_str(line).expect("a JSON string"))
        .collect();
    assert!(texts.len() > 50, "{} texts are no corpus", texts.len());
    texts.iter().for_each(|text| check(text));
}

#[test]
fn recordings_are_read_or_refused() {
    replay(
        include_str!("../../../tests/fuzz/corpus/recording.jsonl"),
        recorded_checks::recording,
    );
}

#[test]
fn models_are_read_or_refused() {
    replay(
        include_str!("../../../tests/fuzz/corpus/model.jsonl"),
        recorded_checks::model,
    );
}
