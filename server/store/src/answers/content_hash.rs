//! Hash of what a result says, whoever solved it and whatever that cost.

use results::{Answer, Estimate, StudyCost, StudyIdentity, StudyResult};
use serde::Serialize;

use crate::content::{Digested, sha256};
use crate::store_error::StoreError;

/// Fields that a result's text begins with.
#[derive(Serialize)]
struct Head<'r> {
    study: &'r StudyIdentity,
    #[serde(skip_serializing_if = "Option::is_none")]
    answer: Option<&'r Answer>,
}

/// Fields that it ends with.
#[derive(Serialize)]
struct Tail<'r> {
    cost: &'r StudyCost,
    #[serde(skip_serializing_if = "Option::is_none")]
    estimate: Option<&'r Estimate>,
}

/// SHA-256 of what a result says: without what it cost, what it was expected to cost, what a surer answer costs, and without the identifier of its study, so that equal
/// documents give equal hashes in any database, on any number of threads, with any history of interruptions.
///
/// # Errors
/// [`StoreError::NotFinite`] when a number isn't finite.
pub(super) fn of(result: &StudyResult) -> Result<String, StoreError> {
    let mut content = result.clone();
    content.cost = StudyCost::default();
    content.estimate = None;
    if let Some(answer) = &mut content.answer {
        answer.surer = None;
    }
    content.study.id.clear();
    Ok(sha256(&[written(&content)?.as_bytes()]))
}

/// Hash of what a result's own text says, the same without writing its map anew. None of a text that this version writes otherwise.
///
/// # Errors
/// As [`of`].
pub(super) fn of_text(text: &str, result: &StudyResult) -> Result<Option<String>, StoreError> {
    let head = Head {
        study: &result.study,
        answer: result.answer.as_ref(),
    };
    let tail = Tail {
        cost: &result.cost,
        estimate: result.estimate.as_ref(),
    };
    let (head, tail) = (written(&head)?, written(&tail)?);
    // Without the brace behind the head, and that before the tail.
    let (head, tail) = (&head[..head.len() - 1], &tail[1..]);
    let between = text
        .strip_prefix(head)
        .and_then(|rest| rest.strip_suffix(tail));
    let Some(between) = between else {
        return Ok(None);
    };
    let study = StudyIdentity {
        id: String::new(),
        ..result.study.clone()
    };
    let answer = result.answer.clone().map(|answer| Answer {
        surer: None,
        ..answer
    });
    let head = written(&Head {
        study: &study,
        answer: answer.as_ref(),
    })?;
    let tail = written(&Tail {
        cost: &StudyCost::default(),
        estimate: None,
    })?;
    let parts = [&head[..head.len() - 1], between, &tail[1..]];
    let mut digest = Digested::default();
    digest.begin(parts.iter().map(|part| part.len()).sum());
    for part in parts {
        digest.update(part.as_bytes());
    }
    Ok(Some(digest.end()))
}

fn written(part: &impl Serialize) -> Result<String, StoreError> {
    serde_json::to_string(part).map_err(|_| StoreError::NotFinite {
        what: "the result of a study",
    })
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    #[test]
    fn a_text_has_the_hash_of_its_result() {
        let answer = json!({"sentence": "", "verdict": "certain", "reason": "", "place": null, "layout": null, "left_out": null, "surer": null});
        let mut result = StudyResult::default();
        for (id, answer) in [("a", None), ("b", Some(answer))] {
            result.study.id = id.to_owned();
            result.cost.solves = 7;
            result.answer = answer.map(|answer| serde_json::from_value(answer).expect("reads"));
            let text = serde_json::to_string(&result).expect("writes");
            let found = of_text(&text, &result).expect("finite");
            assert_eq!(found, Some(of(&result).expect("finite")));
            // Another text of the same result is none that this version writes.
            for other in [
                text.replace("{\"study\"", "{ \"study\""),
                text.replace("\"solves\":7", "\"solves\":7.0"),
            ] {
                assert_ne!(other, text);
                assert_eq!(of_text(&other, &result).expect("finite"), None);
            }
            // What lies between counts.
            let other = text.replace("\"notes\":[]", "\"notes\":[\"a\"]");
            assert_ne!(of_text(&other, &result).expect("finite"), found);
        }
    }
}
