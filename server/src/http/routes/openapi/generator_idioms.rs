//! The description in the words that generators of clients know: each says the same as what stands there before, and reads by more of them.

use serde_json::{Value, json};

/// Writes a description anew.
pub(crate) fn rewrite(document: &mut Value) {
    tuples(document);
    let paths = document["paths"].as_object_mut().into_iter().flatten();
    for (_, item) in paths {
        for (_, operation) in item.as_object_mut().into_iter().flatten() {
            let responses = operation["responses"].as_object_mut();
            for (_, response) in responses.into_iter().flatten() {
                binary_content(response);
            }
        }
    }
}

/// A tuple of one kind of items is a list of so many: `"items": false` beside `prefixItems` is refused by generators that know schemas of OpenAPI 3.0.
fn tuples(value: &mut Value) {
    if let Some([first, others @ ..]) = value["prefixItems"].as_array().map(Vec::as_slice)
        && others.iter().all(|other| other == first)
    {
        let (item, count) = (first.clone(), others.len() + 1);
        if let Some(schema) = value.as_object_mut() {
            schema.remove("prefixItems");
            schema.insert("items".to_owned(), item);
            schema.insert("minItems".to_owned(), json!(count));
            schema.insert("maxItems".to_owned(), json!(count));
        }
    }
    match value {
        Value::Object(members) => members.values_mut().for_each(tuples),
        Value::Array(items) => items.iter_mut().for_each(tuples),
        _ => {}
    }
}

/// Files are bytes, text or not, where an answer may be a file of bytes: a client has one type for all of them. What is neither JSON nor `text/` is bytes to a client,
/// which has no rule to read it by.
fn binary_content(response: &mut Value) {
    let contents = response.get_mut("content").and_then(Value::as_object_mut);
    let Some(contents) = contents else {
        return;
    };
    let is_json = |kind: &str| kind.ends_with("json");
    if contents
        .keys()
        .all(|kind| is_json(kind) || kind.starts_with("text/"))
    {
        return;
    }
    for (kind, content) in contents {
        if !is_json(kind) {
            content["schema"] = json!({"type": "string", "format": "binary"});
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pairs_are_lists_of_two_and_files_are_bytes() {
        let number = json!({"type": "number"});
        let text = json!({"schema": {"type": "string"}});
        let mut document = json!({
            "schemas": {"Interval": {"type": "array", "prefixItems": [number, number], "items": false}},
            "paths": {"/file": {"get": {"responses": {
                "200": {"content": {"text/csv": text, "application/octet-stream": text}},
                "304": {},
                "404": {"content": {"text/plain": text}},
            }}}},
        });
        rewrite(&mut document);
        assert_eq!(
            document["schemas"]["Interval"],
            json!({"type": "array", "items": number, "minItems": 2, "maxItems": 2})
        );
        let responses = &document["paths"]["/file"]["get"]["responses"];
        for kind in ["text/csv", "application/octet-stream"] {
            assert_eq!(
                responses["200"]["content"][kind]["schema"]["format"],
                "binary"
            );
        }
        assert_eq!(responses["304"], json!({}));
        assert_eq!(responses["404"]["content"]["text/plain"], text);
    }
}
