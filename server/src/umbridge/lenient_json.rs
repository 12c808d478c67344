//! Answers of UM-Bridge's servers: JSON, with the numbers that JSON doesn't have as Python prints them.

// What others send is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

use document::visible::push_visible;
use serde_json::{Map, Value};

/// Numbers that aren't finite, in small letters.
const NOT_FINITE: [&str; 3] = ["nan", "inf", "infinity"];
/// Characters of a server's words that are repeated.
const MOST_WORDS: usize = 200;

/// Reads an object; NaN and infinities become null, however they are written.
pub(super) fn object(text: &[u8]) -> Option<Map<String, Value>> {
    let strict = serde_json::from_slice(text).ok();
    strict.or_else(|| serde_json::from_str(&without_not_finite(str::from_utf8(text).ok()?)).ok())
}

/// The text with null for each bare word, sign and all, that stands for a number that isn't finite.
fn without_not_finite(text: &str) -> String {
    let (mut written, mut rest) = (String::with_capacity(text.len()), text);
    let (mut is_quoted, mut is_escaped) = (false, false);
    while let Some(c) = rest.chars().next() {
        let (word, after) = first_word(rest);
        if !is_quoted && !word.is_empty() {
            let name = word.trim_start_matches('-').to_ascii_lowercase();
            written.push_str(if NOT_FINITE.contains(&name.as_str()) {
                "null"
            } else {
                word
            });
            rest = after;
            continue;
        }
        is_quoted ^= c == '"' && !is_escaped;
        is_escaped = is_quoted && c == '\\' && !is_escaped;
        written.push(c);
        rest = rest.get(c.len_utf8()..).unwrap_or_default();
    }
    written
}

/// A word of letters, with a sign before it, that a text begins with; empty where it begins with something else.
fn first_word(text: &str) -> (&str, &str) {
    let letters = text.strip_prefix('-').unwrap_or(text);
    let after = letters.trim_start_matches(|c: char| c.is_ascii_alphabetic());
    if after.len() == letters.len() {
        return ("", text);
    }
    text.split_at_checked(text.len() - after.len())
        .unwrap_or(("", text))
}

/// Words of the protocol's refusal, where an object is one: its type and message.
pub(super) fn refusal(answer: &Map<String, Value>) -> Option<String> {
    let error = answer.get("error")?;
    let part = |name: &str| error.get(name).and_then(Value::as_str);
    let words: Vec<&str> = ["type", "message"].into_iter().filter_map(part).collect();
    Some(match words.is_empty() {
        true => shown(&error.to_string()),
        false => shown(&words.join(": ")),
    })
}

/// A server's words on one line, safe to show, the first of them.
pub(super) fn shown(words: &str) -> String {
    let on_one_line = words.split_whitespace().collect::<Vec<_>>().join(" ");
    let mut shown = String::new();
    for c in on_one_line.chars().take(MOST_WORDS) {
        push_visible(&mut shown, c);
    }
    if on_one_line.chars().nth(MOST_WORDS).is_some() {
        shown.push_str("...");
    }
    shown
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    #[test]
    fn numbers_that_are_not_finite_are_null_and_texts_stay() {
        for (text, expected) in [
            (r#"{"output": [[1, -2.5e-3]]}"#, json!([[1, -2.5e-3]])),
            (
                r#"{"output": [[nan, -inf], [NaN, Infinity, -Infinity, 1e5]] }"#,
                json!([[null, null], [null, null, null, 1e5]]),
            ),
            (
                r#"{"output": ["nan \" NaN\\", nan, true, null]}"#,
                json!(["nan \" NaN\\", null, true, null]),
            ),
        ] {
            let read = object(text.as_bytes()).expect(text);
            assert_eq!(read.get("output"), Some(&expected), "{text}");
        }
        for text in [
            "",
            "[1]",
            "<html>nan</html>",
            "{\"a\": banana}",
            "{\"a\": -}",
        ] {
            assert_eq!(object(text.as_bytes()), None, "{text}");
        }
        assert_eq!(object(b"{\"a\": \xff}"), None);
    }

    #[test]
    fn words_are_shown_on_one_line_and_not_all_of_them() {
        let said = |value: Value| refusal(value.as_object().expect("an object"));
        assert_eq!(said(json!({"output": []})), None);
        assert_eq!(
            said(json!({"error": {"type": "Bad", "message": "a\n b\u{1b}[31m"}})),
            Some("Bad: a b\\u{1b}[31m".to_owned())
        );
        assert_eq!(said(json!({"error": 7})), Some("7".to_owned()));
        assert_eq!(shown(&"x".repeat(1000)).len(), MOST_WORDS + 3);
    }
}
