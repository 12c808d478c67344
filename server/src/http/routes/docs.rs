//! The description of the service as a page: plain HTML, made here, without scripts.

use std::fmt::Write;

use serde_json::Value;

/// Methods that operations have here.
pub const METHODS: [&str; 3] = ["get", "post", "delete"];

/// The page of an OpenAPI document.
pub fn page(document: &Value) -> String {
    let info = &document["info"];
    let mut page = format!(
        "<!doctype html><html lang=\"en\"><head><meta charset=\"utf-8\"><title>{title}</title>\
         <meta name=\"viewport\" content=\"width=device-width\"></head><body><main><h1>{title} {version}</h1>\
         <p>{about}</p><p><a href=\"/openapi.json\">As OpenAPI {openapi}</a></p>",
        title = escaped(text(&info["title"])),
        version = escaped(text(&info["version"])),
        about = escaped(text(&info["description"])),
        openapi = escaped(text(&document["openapi"])),
    );
    contents(&mut page, document);
    for (path, item) in entries(&document["paths"]) {
        for method in METHODS {
            if let Some(operation) = item.get(method) {
                section(&mut page, method, path, operation);
            }
        }
    }
    page.push_str("<h2>Documents</h2>");
    for (name, schema) in entries(&document["components"]["schemas"]) {
        let _ = write!(
            page,
            "<h3 id=\"{0}\">{0}</h3><pre>{1}</pre>",
            escaped(name),
            pretty(schema)
        );
    }
    page.push_str("</main></body></html>\n");
    page
}

fn contents(page: &mut String, document: &Value) {
    page.push_str("<ul>");
    for (path, item) in entries(&document["paths"]) {
        for method in METHODS {
            if let Some(operation) = item.get(method) {
                let _ = write!(
                    page,
                    "<li><a href=\"#{}\"><code>{} {}</code></a> {}</li>",
                    escaped(text(&operation["operationId"])),
                    method.to_uppercase(),
                    escaped(path),
                    escaped(text(&operation["summary"]))
                );
            }
        }
    }
    page.push_str("</ul>");
}

fn section(page: &mut String, method: &str, path: &str, operation: &Value) {
    let _ = write!(
        page,
        "<h2 id=\"{}\">{}</h2><p><code>{} {}</code></p><p>{}</p>",
        escaped(text(&operation["operationId"])),
        escaped(text(&operation["summary"])),
        method.to_uppercase(),
        escaped(path),
        escaped(text(&operation["description"]))
    );
    let parameters = operation["parameters"].as_array();
    for parameter in parameters.into_iter().flatten() {
        let _ = write!(
            page,
            "<p><code>{}</code> ({}): {}</p>",
            escaped(text(&parameter["name"])),
            escaped(text(&parameter["in"])),
            escaped(text(&parameter["description"]))
        );
    }
    for (kind, content) in entries(&operation["requestBody"]["content"]) {
        body(page, &format!("Send {kind}"), content);
    }
    for (status, response) in entries(&operation["responses"]) {
        let _ = write!(
            page,
            "<p><b>{}</b> {}</p>",
            escaped(status),
            escaped(text(&response["description"]))
        );
        for (kind, content) in entries(&response["content"]) {
            body(page, kind, content);
        }
    }
}

fn body(page: &mut String, kind: &str, content: &Value) {
    let schema = text(&content["schema"]["$ref"]);
    let name = schema.rsplit('/').next().unwrap_or_default();
    let _ = write!(
        page,
        "<p>{} <a href=\"#{1}\">{1}</a></p><pre>{2}</pre>",
        escaped(kind),
        escaped(name),
        pretty(&content["example"])
    );
}

fn pretty(value: &Value) -> String {
    match value {
        Value::Null => String::new(),
        Value::String(text) => escaped(text),
        other => escaped(&serde_json::to_string_pretty(other).unwrap_or_default()),
    }
}

fn entries(value: &Value) -> impl Iterator<Item = (&String, &Value)> {
    value.as_object().into_iter().flatten()
}

fn text(value: &Value) -> &str {
    value.as_str().unwrap_or_default()
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
        .replace('"', "&quot;")
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    #[test]
    fn what_a_document_says_can_not_become_markup() {
        let page = page(
            &json!({"info": {"title": "<script>"}, "paths": {"/a\"b": {"get": {"summary": "x & y"}}}}),
        );
        assert!(
            !page.contains("<script>") && page.contains("&lt;script&gt;"),
            "{page}"
        );
        assert!(
            page.contains("/a&quot;b") && page.contains("x &amp; y"),
            "{page}"
        );
    }
}
