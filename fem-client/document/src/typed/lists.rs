//! Lists.

// What users write is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

use serde_json::{Value, json};

use crate::fault::{Fault, entry};
use crate::fields::{Map, plain, shown};
use crate::json_schema::Schemas;
use crate::typed::field_value::Field;

/// Bounds of a list: its length, and each entry.
#[derive(Debug, Clone, Copy)]
pub struct Entries<W> {
    /// Fewest entries.
    pub least: usize,
    /// Most entries.
    pub most: usize,
    /// Noun for the entries in a fault; none: their number alone is told, and they differ.
    pub what: Option<&'static str>,
    /// Bounds of each entry.
    pub each: W,
}

impl<W> Entries<W> {
    /// Entries that differ, so many at most.
    pub const fn distinct(most: usize, each: W) -> Self {
        Self {
            least: 0,
            most,
            what: None,
            each,
        }
    }

    /// Bounds a list to so many entries, equal ones among them.
    pub const fn of(least: usize, most: usize, what: &'static str, each: W) -> Self {
        Self {
            least,
            most,
            what: Some(what),
            each,
        }
    }
}

impl<T: Field + PartialEq> Field for Vec<T> {
    type Within = Entries<T::Within>;

    fn read(
        value: &Value,
        at: &str,
        within: &Self::Within,
        faults: &mut Vec<Fault>,
    ) -> Option<Self> {
        let read = |value: &Value, at: &str, faults: &mut Vec<Fault>| {
            T::read(value, at, &within.each, faults)
        };
        let Some(what) = within.what else {
            return distinct_list(value, at, within.most, faults, read);
        };
        let lengths = within.least..=within.most;
        let items = value
            .as_array()
            .filter(|items| lengths.contains(&items.len()));
        let Some(items) = items else {
            let detail = format!(
                "must be a list of {} to {} {what}; it is {}",
                within.least,
                within.most,
                shown(value)
            );
            Fault::add(faults, at, detail);
            return None;
        };
        every(items, at, faults, read)
    }

    fn write(&self) -> Option<Value> {
        Some(self.iter().filter_map(Field::write).collect())
    }

    fn schema(within: &Self::Within, schemas: &mut Schemas) -> Value {
        let items = T::schema(&within.each, schemas);
        let mut schema = Map::from_iter([
            ("type".to_owned(), "array".into()),
            ("maxItems".to_owned(), within.most.into()),
            ("items".to_owned(), items),
        ]);
        if within.least > 0 {
            schema.insert("minItems".to_owned(), within.least.into());
        }
        if within.what.is_none() {
            schema.insert("uniqueItems".to_owned(), true.into());
        }
        Value::Object(schema)
    }
}

/// Bounds of a list of a fixed length.
#[derive(Debug, Clone, Copy)]
pub struct Each<W> {
    /// Noun for the list in a fault.
    pub what: &'static str,
    /// Bounds of each entry.
    pub each: W,
    /// Whether no entry is lower than the one before.
    pub ascending: bool,
}

impl<W> Each<W> {
    /// A list that is this.
    pub const fn of(what: &'static str, each: W) -> Self {
        Self {
            what,
            each,
            ascending: false,
        }
    }

    /// A least and a greatest number.
    pub const fn least_and_greatest(each: W) -> Self {
        Self {
            what: "a list of two numbers, the lower first",
            each,
            ascending: true,
        }
    }
}

impl<T: Field + Copy + Into<f64>, const N: usize> Field for [T; N] {
    type Within = Each<T::Within>;

    fn read(
        value: &Value,
        at: &str,
        within: &Self::Within,
        faults: &mut Vec<Fault>,
    ) -> Option<Self> {
        let Some(items) = value.as_array().filter(|items| items.len() == N) else {
            let detail = format!("must be {}; it is {}", within.what, shown(value));
            Fault::add(faults, at, detail);
            return None;
        };
        let read = |value: &Value, at: &str, faults: &mut Vec<Fault>| {
            T::read(value, at, &within.each, faults)
        };
        let entries = every(items, at, faults, read)?;
        if within.ascending && !is_ascending(&entries, at, faults) {
            return None;
        }
        entries.try_into().ok()
    }

    fn write(&self) -> Option<Value> {
        Some(self.iter().filter_map(Field::write).collect())
    }

    fn schema(within: &Self::Within, schemas: &mut Schemas) -> Value {
        let items = T::schema(&within.each, schemas);
        json!({"type": "array", "minItems": N, "maxItems": N, "items": items})
    }
}

/// Whether the lower of two neighbours comes first; a fault where it doesn't.
fn is_ascending<T: Copy + Into<f64>>(entries: &[T], at: &str, faults: &mut Vec<Fault>) -> bool {
    let pairs = entries.iter().zip(entries.iter().skip(1));
    let mut pairs = pairs.map(|(low, high)| ((*low).into(), (*high).into()));
    let Some((low, high)) = pairs.find(|(low, high): &(f64, f64)| low > high) else {
        return true;
    };
    let detail = format!(
        "must have the lower number first; it is {} and {}",
        plain(low),
        plain(high)
    );
    Fault::add(faults, at, detail);
    false
}

/// Reads all entries before the first fault ends it.
fn every<T>(
    items: &[Value],
    at: &str,
    faults: &mut Vec<Fault>,
    read: impl Fn(&Value, &str, &mut Vec<Fault>) -> Option<T>,
) -> Option<Vec<T>> {
    let of = |(i, item)| read(item, &entry(at, i), faults);
    let read: Vec<Option<T>> = items.iter().enumerate().map(of).collect();
    read.into_iter().collect()
}

/// Reads a list whose entries differ; all entries are read before the first fault ends it.
pub fn distinct_list<T: PartialEq>(
    value: &Value,
    at: &str,
    most: usize,
    faults: &mut Vec<Fault>,
    read: impl Fn(&Value, &str, &mut Vec<Fault>) -> Option<T>,
) -> Option<Vec<T>> {
    let Some(items) = value.as_array().filter(|items| items.len() <= most) else {
        let detail = format!(
            "must be a list of at most {most} entries; it is {}",
            shown(value)
        );
        Fault::add(faults, at, detail);
        return None;
    };
    let mut read_items = Vec::new();
    for (i, item) in items.iter().enumerate() {
        let at = entry(at, i);
        let Some(item) = read(item, &at, faults) else {
            continue;
        };
        if read_items.contains(&item) {
            Fault::add(faults, &at, "is in the list already");
        }
        read_items.push(item);
    }
    (read_items.len() == items.len()).then_some(read_items)
}
