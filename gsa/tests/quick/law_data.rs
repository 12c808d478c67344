//! Laws in files of reference values.

use gsa::law::catalogue::Kind;
use gsa::law::distribution::Distribution;
use serde_json::Value;

/// The entries of a file, each made a case.
pub fn entries<T>(text: &str, case: impl Fn(&Value) -> T) -> Vec<T> {
    let document: Value = serde_json::from_str(text).expect("valid JSON");
    list(&document, case)
}

/// The items of a list.
pub fn list<T>(list: &Value, item: impl Fn(&Value) -> T) -> Vec<T> {
    list.as_array().expect("a list").iter().map(item).collect()
}

/// A list of numbers.
pub fn numbers(value: &Value) -> Vec<f64> {
    list(value, |number| number.as_f64().expect("a number"))
}

/// An entry's name and law.
pub fn named_law(entry: &Value) -> (String, Distribution) {
    let kind = Kind::named(entry["kind"].as_str().expect("a kind")).expect("a known kind");
    let law = kind
        .distribution(&numbers(&entry["parameters"]))
        .expect("a valid law");
    let law = match entry.get("truncate").map(numbers).as_deref() {
        Some(&[low, high]) => law.truncated(low, high).expect("a valid truncation"),
        _ => law,
    };
    (entry["name"].as_str().expect("a name").to_owned(), law)
}
