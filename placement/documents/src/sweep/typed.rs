//! Grids and settings as they are typed on a command line: `geometry.wall_mm=2.5,3,3.5`.

// What users write is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

use document::fault::Fault;
use document::json_or_word;
use serde_json::{Map, Value};

/// Lists of values by path, from texts of the form `KEY=V1,V2,...`. A value is JSON or else a word.
///
/// # Errors
/// A fault for each text that isn't of this form, or whose key stood before.
pub fn typed_grid(texts: &[String]) -> Result<Map<String, Value>, Vec<Fault>> {
    let form = "a grid is KEY=V1,V2,..., as in geometry.wall_mm=2.5,3,3.5";
    typed(("--grid", form), texts, |list| {
        split(list).into_iter().map(json_or_word).collect()
    })
}

/// Values by path, from texts of the form `KEY=VALUE`.
///
/// # Errors
/// As for [`typed_grid`].
pub fn typed_settings(texts: &[String]) -> Result<Map<String, Value>, Vec<Fault>> {
    let form = "a change is KEY=VALUE, as in geometry.wall_mm=2.5";
    typed(("--set", form), texts, json_or_word)
}

fn typed(
    (option, form): (&str, &str),
    texts: &[String],
    read: impl Fn(&str) -> Value,
) -> Result<Map<String, Value>, Vec<Fault>> {
    let (mut fields, mut faults) = (Map::new(), Vec::new());
    for text in texts {
        let why = match text.split_once('=') {
            None => "it has no =",
            Some((path, value)) => match fields.insert(path.trim().to_owned(), read(value)) {
                None => continue,
                Some(_) => "its key stands twice",
            },
        };
        let detail = format!("{option} {text:?}: {why}; {form}");
        Fault::add(&mut faults, "", detail);
    }
    if faults.is_empty() {
        Ok(fields)
    } else {
        Err(faults)
    }
}

/// Splits at commas outside of brackets and quotes.
fn split(list: &str) -> Vec<&str> {
    let (mut depth, mut quoted, mut escaped) = (0_usize, false, false);
    list.split(|c| {
        let plain = !quoted && depth == 0;
        match c {
            '"' if !escaped => quoted = !quoted,
            '[' | '{' if !quoted => depth += 1,
            ']' | '}' if !quoted => depth = depth.saturating_sub(1),
            _ => {}
        }
        escaped = quoted && c == '\\' && !escaped;
        c == ',' && plain
    })
    .collect()
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    fn read(texts: &[&str]) -> Result<Value, Vec<Fault>> {
        let texts: Vec<String> = texts.iter().map(|text| (*text).to_owned()).collect();
        typed_grid(&texts).map(Value::Object)
    }

    #[test]
    fn values_are_json_or_words_and_lists_stay_whole() {
        let texts = [
            "geometry.wall_mm = 2.5, 3",
            "ground.depths_mm=[1,1,1],[1,2,1]",
            "model.level=draft",
            r#"inputs=[{"name":"a \", ] b"}],"c,d""#,
        ];
        assert_eq!(
            read(&texts).unwrap(),
            json!({"geometry.wall_mm": [2.5, 3], "ground.depths_mm": [[1, 1, 1], [1, 2, 1]], "model.level": ["draft"],
                "inputs": [[{"name": "a \", ] b"}], "c,d"]})
        );
    }

    #[test]
    fn every_grid_that_is_none_is_told() {
        let faults = read(&["wall", "a=1", "a=2", "b=1"]).unwrap_err();
        let said: Vec<String> = faults.iter().map(ToString::to_string).collect();
        assert_eq!(said.len(), 2, "{said:?}");
        assert!(said[0].contains("\"wall\": it has no ="), "{said:?}");
        assert!(
            said[1].contains("\"a=2\": its key stands twice"),
            "{said:?}"
        );
    }

    #[test]
    fn a_setting_is_one_value_commas_and_all() {
        let texts = ["model.level = draft", "ground.depths_mm=[1,2]", "a=b,c"].map(str::to_owned);
        let read = typed_settings(&texts).map(Value::Object);
        assert_eq!(
            read.unwrap(),
            json!({"model.level": "draft", "ground.depths_mm": [1, 2], "a": "b,c"})
        );
        let faults = typed_settings(&["wall".to_owned()]).unwrap_err();
        assert!(faults[0].detail.starts_with("--set \"wall\": it has no ="));
    }
}
