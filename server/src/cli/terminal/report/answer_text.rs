//! The answer, how sure it is, and what could overturn it, for people.

use anstyle::Style;
use document::visible::visible;
use results::{Answer, Certainty, StudyResult};

use crate::cli::terminal::paint::{GOOD, STRONG, WARNING, painted};
use crate::cli::terminal::wrapping::{labelled, wrapped};

/// The answer of a result, ended by an empty line; nothing where it has none.
pub fn answer(result: &StudyResult) -> String {
    let Some(answer) = &result.answer else {
        return String::new();
    };
    let sentence = wrapped(&visible(&answer.sentence), 0);
    let lines = sentence.lines().map(|line| painted(STRONG, line) + "\n");
    let mut text: String = lines.collect();
    text.push('\n');
    let reason = visible(&answer.reason);
    text += &labelled(style(answer.verdict), answer.verdict.as_str(), &reason);
    let more = answer.inputs.iter().filter(|inputs| {
        inputs.sentence != answer.sentence && inputs.shares.len() > result.locations.len()
    });
    for inputs in more {
        text += &labelled(STRONG, "inputs", &visible(&inputs.sentence));
    }
    for beside in answer.inputs.iter().flat_map(|inputs| &inputs.beside) {
        text += &labelled(STRONG, "inputs", &visible(&beside.sentence));
    }
    if let Some(rests_on) = &answer.rests_on {
        text += &labelled(STRONG, "rests on", &visible(&rests_on.sentence));
    }
    text += &labelled(STRONG, "left out", &left_out(answer));
    if let Some(surer) = &answer.surer {
        text += &labelled(STRONG, "surer", &surer.sentence);
    }
    text + "\n"
}

fn left_out(answer: &Answer) -> String {
    match &answer.left_out {
        Some(left_out) => visible(&left_out.sentence),
        None => {
            "no effect of what the model leaves out is known; the draft measures none.".to_owned()
        }
    }
}

fn style(verdict: Certainty) -> Style {
    match verdict {
        Certainty::Certain | Certainty::Likely => GOOD,
        Certainty::Tied | Certainty::Unknown => WARNING,
    }
}
