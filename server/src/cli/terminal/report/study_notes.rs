//! Notes to know before believing the numbers, by what they do to the answer, for people.

use std::collections::BTreeMap;

use results::{Grade, GradedNote, StudyResult, Topic};

use crate::cli::terminal::paint::header;
use crate::cli::terminal::wrapping::wrapped;

/// The notes of a result under what they do.
pub fn notes(result: &StudyResult) -> String {
    let without = without_index(result);
    let said = result
        .answer
        .as_ref()
        .and_then(|answer| answer.left_out.as_ref());
    let is_new = |note: &&GradedNote| said.is_none_or(|said| said.sentence != note.text);
    let all: Vec<&GradedNote> = without
        .iter()
        .chain(&result.graded_notes)
        .filter(is_new)
        .collect();
    let mut text = String::new();
    for grade in Grade::ALL {
        let mut of_grade = all.iter().filter(|note| note.grade == grade).peekable();
        if of_grade.peek().is_some() {
            text += &header(&format!("\n{}\n", grade.words()));
        }
        text = of_grade.fold(text, |text, note| with_line(text, &note.text));
    }
    text
}

fn with_line(text: String, note: &String) -> String {
    text + &wrapped(&format!("- {note}"), 2)
}

/// Says why dashes stand in the table: each reason why outputs have no index, with how many they are.
fn without_index(result: &StudyResult) -> Vec<GradedNote> {
    let mut counts: BTreeMap<&str, usize> = BTreeMap::new();
    let outputs = result.outputs.iter();
    let without = outputs.filter(|output| output.first_order.is_none());
    for reason in without.filter_map(|output| output.reason.as_deref()) {
        *counts.entry(reason).or_default() += 1;
    }
    let all = result.outputs.len();
    let note = |(reason, count)| {
        let text = format!("{count} of {all} outputs have no index: {reason}.");
        GradedNote::bearing(Topic::Indices, text)
    };
    counts.into_iter().map(note).collect()
}
