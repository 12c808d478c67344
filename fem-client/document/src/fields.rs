//! Reads checked fields from a document's value, collecting every fault.
//!
//! Each function names a faulty value by its JSON pointer, says what would be right, and goes on, so that a user sees
//! all faults at once.

// What users write is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

use serde_json::Value;

use crate::fault::{Fault, member};
use crate::non_finite::as_non_finite;
use crate::visible::visible;

/// The members of a table.
pub type Map = serde_json::Map<String, Value>;

/// Numbers that a field takes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Range {
    /// Least number, included.
    pub low: f64,
    /// Greatest number, included.
    pub high: f64,
    /// Unit, for people; empty for pure numbers.
    pub unit: &'static str,
}

impl Range {
    /// A range with both ends included.
    pub const fn new(low: f64, high: f64, unit: &'static str) -> Self {
        Self { low, high, unit }
    }
}

impl std::fmt::Display for Range {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "from {} to {}", plain(self.low), plain(self.high))?;
        if self.unit.is_empty() {
            Ok(())
        } else {
            write!(f, " {}", self.unit)
        }
    }
}

/// A number as people write it: without an exponent where that is short.
pub fn plain(number: f64) -> String {
    let size = number.abs();
    if size != 0.0 && !(1e-4..1e7).contains(&size) {
        format!("{number:e}")
    } else {
        format!("{number}")
    }
}

/// Shows a value to people, cut short when it is long.
pub fn shown(value: &Value) -> String {
    if let Some(number) = as_non_finite(value) {
        return number.to_owned();
    }
    match value {
        Value::Object(_) => "a table".to_owned(),
        Value::Array(items) => format!("a list of {} entries", items.len()),
        other => shortened(&visible(&other.to_string())),
    }
}

fn shortened(text: &str) -> String {
    const LONGEST: usize = 60;
    if text.chars().count() <= LONGEST {
        return text.to_owned();
    }
    text.chars().take(LONGEST).chain("...".chars()).collect()
}

/// Reads one number in a range. Minus zero becomes zero, so that equal scenes have equal texts.
pub fn number(value: &Value, pointer: &str, range: Range, faults: &mut Vec<Fault>) -> Option<f64> {
    match value.as_f64() {
        Some(x) if (range.low..=range.high).contains(&x) => Some(x + 0.0),
        _ => {
            Fault::add(
                faults,
                pointer,
                format!("must be a number {range}; it is {}", shown(value)),
            );
            None
        }
    }
}

/// Reads a whole number in a range; `5.0` is the same as `5`.
pub fn integer(
    value: &Value,
    pointer: &str,
    low: u64,
    high: u64,
    faults: &mut Vec<Fault>,
) -> Option<u64> {
    // Beyond 2^53 a float no longer names one integer.
    const EXACT: f64 = 9_007_199_254_740_992.0;
    let whole = |x: f64| (x.fract() == 0.0 && (0.0..=EXACT).contains(&x)).then_some(x as u64);
    match value.as_u64().or_else(|| value.as_f64().and_then(whole)) {
        Some(n) if (low..=high).contains(&n) => Some(n),
        _ => {
            let detail = format!(
                "must be a whole number from {low} to {high}; it is {}",
                shown(value)
            );
            Fault::add(faults, pointer, detail);
            None
        }
    }
}

/// Reads one of the named values.
pub fn choice<T: Copy>(
    value: &Value,
    pointer: &str,
    options: &[(&str, T)],
    faults: &mut Vec<Fault>,
) -> Option<T> {
    let found = value
        .as_str()
        .and_then(|text| options.iter().find(|(name, _)| *name == text));
    if found.is_none() {
        let detail = format!(
            "must be {}; it is {}",
            alternatives(options.iter().map(|o| o.0)),
            shown(value)
        );
        Fault::add(faults, pointer, detail);
    }
    found.map(|(_, option)| *option)
}

/// `"a", "b" or "c"`.
pub fn alternatives<'a>(names: impl IntoIterator<Item = &'a str>) -> String {
    let mut quoted: Vec<String> = names
        .into_iter()
        .map(|name| format!("\"{name}\""))
        .collect();
    match quoted.pop() {
        Some(last) if quoted.is_empty() => last,
        Some(last) => format!("{} or {last}", quoted.join(", ")),
        None => String::new(),
    }
}

/// A number of a table: its name, its range, and its place, which holds the default until it is read.
pub type Number<'n> = (&'static str, Range, &'n mut f64);

/// The fields of a table, with the pointer under which they are reported.
#[derive(Debug, Clone)]
pub struct Fields<'v> {
    object: &'v Map,
    pointer: String,
}

impl<'v> Fields<'v> {
    /// Opens a table. A fault for anything but a table, and one for each field that isn't known.
    pub fn open(
        value: &'v Value,
        pointer: &str,
        known: &[&str],
        faults: &mut Vec<Fault>,
    ) -> Option<Self> {
        let table = value.as_object().filter(|_| as_non_finite(value).is_none());
        let Some(object) = table else {
            let detail = format!(
                "must be a table with the fields {}; it is {}",
                known.join(", "),
                shown(value)
            );
            Fault::add(faults, pointer, detail);
            return None;
        };
        for name in object.keys().filter(|name| !known.contains(&name.as_str())) {
            Fault::add(faults, &member(pointer, name), unknown(name, known));
        }
        Some(Self {
            object,
            pointer: pointer.to_owned(),
        })
    }

    /// The value of a field, with its pointer.
    pub fn get(&self, name: &str) -> Option<(&'v Value, String)> {
        self.object.get(name).map(|value| (value, self.at(name)))
    }

    /// The pointer of the table.
    pub fn pointer(&self) -> &str {
        &self.pointer
    }

    /// Some of the fields, as a table of their own at the same place.
    pub fn some(&self, names: &[&str]) -> (Value, String) {
        let some = self.object.iter();
        let some = some.filter(|(name, _)| names.contains(&name.as_str()));
        let table = some.map(|(name, value)| (name.clone(), value.clone()));
        (Value::Object(table.collect()), self.pointer.clone())
    }

    /// The pointer of a field, present or not.
    pub fn at(&self, name: &str) -> String {
        member(&self.pointer, name)
    }

    /// The value of a field that can't be left out; a fault when it is.
    pub fn required(
        &self,
        name: &str,
        what: &str,
        faults: &mut Vec<Fault>,
    ) -> Option<(&'v Value, String)> {
        let found = self.get(name);
        if found.is_none() {
            Fault::add(faults, &self.at(name), format!("is missing; it is {what}"));
        }
        found
    }

    /// A number in a range, or its default when absent. None after a fault.
    pub fn number(
        &self,
        name: &str,
        range: Range,
        default: f64,
        faults: &mut Vec<Fault>,
    ) -> Option<f64> {
        self.get(name).map_or(Some(default), |(value, pointer)| {
            number(value, &pointer, range, faults)
        })
    }

    /// Reads numbers into their places, which keep what they hold where a field is absent. None after a fault.
    pub fn numbers<'n>(
        &self,
        numbers: impl IntoIterator<Item = Number<'n>>,
        faults: &mut Vec<Fault>,
    ) -> Option<()> {
        let mut read = Some(());
        for (name, range, place) in numbers {
            match self.number(name, range, *place, faults) {
                Some(number) => *place = number,
                None => read = None,
            }
        }
        read
    }

    /// A whole number in a range, or its default when absent. None after a fault.
    pub fn integer(
        &self,
        name: &str,
        (low, high): (u64, u64),
        default: u64,
        faults: &mut Vec<Fault>,
    ) -> Option<u64> {
        self.get(name).map_or(Some(default), |(value, pointer)| {
            integer(value, &pointer, low, high, faults)
        })
    }

    /// Reads one of the named values, or its default when absent. None after a fault.
    pub fn choice<T: Copy>(
        &self,
        name: &str,
        options: &[(&str, T)],
        default: T,
        faults: &mut Vec<Fault>,
    ) -> Option<T> {
        self.get(name).map_or(Some(default), |(value, pointer)| {
            choice(value, &pointer, options, faults)
        })
    }
}

fn unknown(name: &str, known: &[&str]) -> String {
    let shown = shortened(name);
    let nearest = nearest(&shown, known.iter().copied());
    let hint = nearest.map_or_else(String::new, |near| format!(" Did you mean \"{near}\"?"));
    format!(
        "unknown field \"{}\"; the fields here are {}.{hint}",
        shown.escape_debug(),
        known.join(", ")
    )
}

/// The known name that is most like a mistyped one, when there is one like it.
pub fn nearest<'k>(name: &str, known: impl IntoIterator<Item = &'k str>) -> Option<&'k str> {
    let distances = known
        .into_iter()
        .map(|known| (distance(name, known), known));
    let (least, nearest) = distances.min()?;
    (least <= nearest.len() / 3 + 1).then_some(nearest)
}

/// Insertions, deletions and replacements between two words (Levenshtein's distance).
#[expect(
    clippy::indexing_slicing,
    reason = "a row has a place for each character and one more"
)]
fn distance(a: &str, b: &str) -> usize {
    let b: Vec<char> = b.chars().collect();
    let mut row: Vec<usize> = (0..=b.len()).collect();
    for (i, x) in a.chars().enumerate() {
        let mut diagonal = row[0];
        row[0] = i + 1;
        for (j, y) in b.iter().enumerate() {
            let replaced = diagonal + usize::from(x != *y);
            diagonal = row[j + 1];
            row[j + 1] = replaced.min(row[j] + 1).min(diagonal + 1);
        }
    }
    row[b.len()]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn control_characters_are_written_out() {
        // JSON's own escapes leave those from 7f to 9f as they are; 9b begins a terminal's commands.
        let value = Value::from("a\u{7f}b\u{9b}2Jc\n");
        assert_eq!(shown(&value), "\"a\\u{7f}b\\u{9b}2Jc\\n\"");
    }

    #[test]
    fn integral_floats_are_integers() {
        let mut faults = Vec::new();
        assert_eq!(integer(&Value::from(5.0), "", 0, 9, &mut faults), Some(5));
        assert_eq!(
            integer(&Value::from(0.0), "", 0, u64::MAX, &mut faults),
            Some(0)
        );
        assert!(faults.is_empty());
        for bad in [
            Value::from(5.5),
            Value::from(-1),
            Value::from(1e300),
            Value::from("5"),
            Value::Null,
        ] {
            assert_eq!(integer(&bad, "/n", 0, 9, &mut faults), None);
        }
        assert_eq!(faults.len(), 5);
    }

    #[test]
    fn faults_say_the_range_and_the_unit() {
        let mut faults = Vec::new();
        number(
            &Value::from(12),
            "/wall_mm",
            Range::new(0.1, 5.0, "mm"),
            &mut faults,
        );
        assert_eq!(
            faults[0].detail,
            "must be a number from 0.1 to 5 mm; it is 12"
        );
    }

    #[test]
    fn minus_zero_is_zero() {
        let zero = number(
            &Value::from(-0.0),
            "",
            Range::new(-1.0, 1.0, ""),
            &mut Vec::new(),
        )
        .unwrap();
        assert!(zero.is_sign_positive());
    }

    #[test]
    fn unknown_fields_get_the_nearest_name() {
        let mut faults = Vec::new();
        let value = serde_json::json!({"wal_mm": 1, "colour": 2});
        Fields::open(&value, "/geometry", &["kind", "wall_mm"], &mut faults).unwrap();
        assert_eq!(faults[0].pointer, "/geometry/wal_mm");
        assert!(
            faults[0].detail.ends_with("Did you mean \"wall_mm\"?"),
            "{}",
            faults[0].detail
        );
        assert!(
            !faults[1].detail.contains("Did you mean"),
            "{}",
            faults[1].detail
        );
    }
}
