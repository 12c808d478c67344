//! Answers without what differs from run to run, short enough to be read.

use jiff::Timestamp;
use serde_json::{Map, Value};

/// Columns of a line.
const COLUMNS: usize = 160;
/// Characters of a line that may go on in the next one.
const WRAPPED: usize = 75;
/// Numbers and texts of a list that are shown, and entries of other kinds; faults are shown all.
const SHOWN: [usize; 2] = [6, 1];
/// Fields that hold what was measured, or what rounding decides.
const MEASURED: [&str; 11] = [
    "wall_s",
    "worked_s",
    "cpu_s",
    "_bytes",
    "expected_s",
    "factorisation_share",
    "substitution_share",
    "assembly_share",
    "other_share",
    "residual_history",
    "time, s",
];
/// Fields of work that goes on while it is asked for.
const PROGRESS: [&str; 7] = [
    "state",
    "counts",
    "started",
    "finished",
    "points_total",
    "points_done",
    "progress",
];
/// Words behind a number that was measured.
const UNITS: [&str; 6] = ["s", "ms", "MB", "bytes", "times", "h"];

/// Identifiers and hashes so far: each is shown by its number among those of its kind, so that equal ones stay equal.
#[derive(Default)]
pub struct Redaction {
    identifiers: Vec<String>,
    hashes: Vec<String>,
    /// Whether the next documents are of work that goes on.
    pub goes_on: bool,
}

impl Redaction {
    /// Replaces times, identifiers, hashes and versions.
    pub fn text(&mut self, text: &str) -> String {
        let text = replaced(text, ":.-+", |word| {
            let is_time = word.parse::<Timestamp>().is_ok();
            is_time.then(|| "TIME".to_owned())
        });
        let text = replaced(&text, "-", |word| {
            let (id, rest) = word.split_at_checked(36)?;
            let is_id =
                id.replace('-', "").len() == 32 && (rest.is_empty() || rest.starts_with('-'));
            is_id.then(|| format!("ID{}{rest}", number(&mut self.identifiers, id)))
        });
        let text = replaced(&text, "", |word| {
            let is_hash = word.bytes().all(|byte| byte.is_ascii_hexdigit());
            match word.len() {
                64 if is_hash => Some(format!("HASH{}", number(&mut self.hashes, word))),
                12 if is_hash => Some("SOURCES".to_owned()),
                _ => None,
            }
        });
        text.replace(env!("CARGO_PKG_VERSION"), "VERSION")
    }

    /// Replaces these in what a command tells people, and numbers that were measured; lines that were wrapped are whole.
    pub fn told(&mut self, text: &str) -> String {
        let (mut whole, mut is_full) = (String::new(), false);
        for line in text.lines() {
            match line.strip_prefix("  ") {
                Some(rest) if is_full && !rest.starts_with(' ') => {
                    whole.pop();
                    whole.push(' ');
                    whole.push_str(rest);
                }
                _ => whole.push_str(line),
            }
            whole.push('\n');
            is_full = line.len() > WRAPPED;
        }
        let whole = self.text(&whole);
        let mut is_timed = false;
        let lines = whole.lines().map(|line| {
            let shown = match (line, line.rsplit_once(' ')) {
                _ if line.starts_with("of the solves' time") => "of the solves' time ..".into(),
                (_, Some((begin, time))) if is_timed && time.parse::<f64>().is_ok() => {
                    format!("{} #", begin.trim_end())
                }
                _ => without_measured(line),
            };
            is_timed = line.ends_with("time, s") || (is_timed && !line.is_empty());
            shown + "\n"
        });
        lines.collect()
    }

    /// Writes a document: numbers to six digits, of long lists the beginning and the length, objects below `depth` by their names alone.
    pub fn json(&mut self, value: &Value, depth: usize) -> String {
        let value = self.reduced("", value, depth);
        written(&value, 0)
    }

    /// Writes a table of comma-separated values: head and the first rows, numbers to six digits.
    pub fn csv(&mut self, text: &str) -> String {
        let names: Vec<&str> = text
            .lines()
            .next()
            .map_or(Vec::new(), |head| head.split(',').collect());
        let mut table = String::new();
        for line in text.lines().take(1 + SHOWN[1]) {
            // A comma between quotes ends no cell.
            let mut is_quoted = false;
            let is_end = |letter: char| {
                is_quoted ^= letter == '"';
                letter == ',' && !is_quoted
            };
            let cells =
                line.split(is_end)
                    .enumerate()
                    .map(|(place, cell)| match cell.parse::<f64>() {
                        Ok(_) if names.get(place).is_some_and(|name| is_measured(name)) => {
                            "MEASURED".into()
                        }
                        Ok(number) => rounded(number),
                        Err(_) => self.text(cell),
                    });
            table += &(cells.collect::<Vec<_>>().join(",") + "\n");
        }
        table + &format!("{} lines\n", text.lines().count())
    }

    fn reduced(&mut self, name: &str, value: &Value, depth: usize) -> Value {
        match value {
            _ if self.goes_on && PROGRESS.contains(&name) => "..".into(),
            Value::Number(_) if is_measured(name) => "MEASURED".into(),
            Value::Number(number) => match number.as_f64() {
                Some(float) if number.is_f64() => Value::String(rounded(float)),
                _ => value.clone(),
            },
            Value::String(text) if name == "sentence" => {
                format!("\"{}\"", without_measured(&self.text(text))).into()
            }
            Value::String(text) => format!("\"{}\"", self.text(text)).into(),
            Value::Array(list) => self.beginning(name, list, depth),
            Value::Object(fields) if depth == 0 => fields.keys().cloned().collect(),
            Value::Object(fields) => {
                let fields = fields.iter().map(|(name, value)| {
                    let shown = self.text(name);
                    (shown, self.reduced(name, value, depth - 1))
                });
                Value::Object(fields.collect::<Map<_, _>>())
            }
            Value::Null | Value::Bool(_) => value.clone(),
        }
    }

    fn beginning(&mut self, name: &str, list: &[Value], depth: usize) -> Value {
        let is_plain = list
            .iter()
            .all(|entry| !entry.is_object() && !entry.is_array());
        let most = match name {
            "errors" => usize::MAX,
            _ => SHOWN[usize::from(!is_plain)],
        };
        let shown = list.iter().take(most);
        let mut shown: Vec<Value> = shown
            .map(|entry| self.reduced(name, entry, depth))
            .collect();
        if list.len() > most {
            shown.push(format!(".. {} in all", list.len()).into());
        }
        shown.into()
    }
}

fn is_measured(name: &str) -> bool {
    MEASURED.iter().any(|measured| name.ends_with(measured))
}

/// The number of a word among those of its kind so far.
fn number(seen: &mut Vec<String>, word: &str) -> usize {
    let place = seen.iter().position(|other| other == word);
    place.unwrap_or_else(|| {
        seen.push(word.to_owned());
        seen.len() - 1
    }) + 1
}

/// Replaces words of letters, digits and these characters.
fn replaced(text: &str, with: &str, mut by: impl FnMut(&str) -> Option<String>) -> String {
    let is_part = |c: char| c.is_ascii_alphanumeric() || with.contains(c);
    let mut result = String::new();
    let mut rest = text;
    while let Some(c) = rest.chars().next() {
        let (end, word) = match rest.find(|c| !is_part(c)) {
            Some(0) => (c.len_utf8(), None),
            end => (end.unwrap_or(rest.len()), Some(())),
        };
        let piece = &rest[..end];
        let new = word.and_then(|()| by(piece));
        result.push_str(new.as_deref().unwrap_or(piece));
        rest = &rest[end..];
    }
    result
}

/// A line without numbers before [`UNITS`].
fn without_measured(line: &str) -> String {
    // A slow machine says minutes where another says seconds.
    let line = &line.replace(" minutes", " s");
    let is_unit = |word: &str| UNITS.contains(&word.trim_end_matches([',', ';', ')', '.']));
    let words: Vec<&str> = line.split(' ').collect();
    let shown = words.iter().enumerate().map(|(place, word)| {
        let number = word.trim_start_matches('(');
        let is_number = number.parse::<f64>().is_ok();
        match words.get(place + 1) {
            // A residual.
            _ if is_number && number.contains("e-") => word.replace(number, "#"),
            Some(unit) if is_number && is_unit(unit) => word.replace(number, "#"),
            _ => (*word).to_owned(),
        }
    });
    shown.collect::<Vec<_>>().join(" ")
}

/// Six digits, as far as libraries of mathematics agree; 0 where rounding alone may be left.
fn rounded(number: f64) -> String {
    if number.abs() < 1e-7 {
        return "0".to_owned();
    }
    let digits = format!("{number:.5e}");
    digits
        .parse()
        .map_or(digits, |short: f64| short.to_string())
}

/// A document whose texts are written as they are: on one line where it fits.
fn written(value: &Value, indent: usize) -> String {
    let flat = flat(value);
    if flat.len() + indent <= COLUMNS {
        return flat;
    }
    let (brackets, parts): (_, Vec<String>) = match value {
        Value::Array(list) => {
            let parts = list.iter().map(|entry| written(entry, indent + 2));
            ("[]", parts.collect())
        }
        Value::Object(fields) => {
            let part = |(name, value)| format!("{name}: {}", written(value, indent + 2));
            ("{}", fields.iter().map(part).collect())
        }
        _ => return flat,
    };
    let (inner, outer) = (" ".repeat(indent + 2), " ".repeat(indent));
    format!(
        "{}\n{}{outer}{}",
        &brackets[..1],
        filled(&parts, &inner),
        &brackets[1..]
    )
}

/// Parts side by side as far as they fit, those of several lines by themselves.
fn filled(parts: &[String], indent: &str) -> String {
    let (mut text, mut line) = (String::new(), String::new());
    for part in parts {
        let fits = !line.is_empty() && !line.contains('\n') && !part.contains('\n');
        if fits && indent.len() + line.len() + part.len() + 2 <= COLUMNS {
            line += &format!(", {part}");
            continue;
        }
        if !line.is_empty() {
            text += &format!("{indent}{line}\n");
        }
        line.clone_from(part);
    }
    text + &format!("{indent}{line}\n")
}

fn flat(value: &Value) -> String {
    let joined = |parts: Vec<String>| parts.join(", ");
    match value {
        Value::String(text) => text.clone(),
        Value::Array(list) => format!("[{}]", joined(list.iter().map(flat).collect())),
        Value::Object(fields) => {
            let fields = fields
                .iter()
                .map(|(name, value)| format!("{name}: {}", flat(value)));
            format!("{{{}}}", joined(fields.collect()))
        }
        other => other.to_string(),
    }
}
