//! Enums of the analysis stand in documents as their names: `#[serde(with = "named")]`.

use gsa::method::analysis::{Form, Status};
use serde::de::Error;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

/// Values that have a name in documents.
pub trait Named: Copy + 'static {
    /// All of its kind.
    const ALL: &'static [Self];

    /// The name.
    fn name(self) -> &'static str;
}

impl Named for Form {
    const ALL: &'static [Self] = &Self::ALL;

    fn name(self) -> &'static str {
        self.as_str()
    }
}

impl Named for Status {
    const ALL: &'static [Self] = &Self::ALL;

    fn name(self) -> &'static str {
        self.as_str()
    }
}

/// Writes the name.
pub fn serialize<T: Named, S: Serializer>(value: &T, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.serialize_str(value.name())
}

/// Reads the name.
pub fn deserialize<'de, T: Named, D: Deserializer<'de>>(deserializer: D) -> Result<T, D::Error> {
    let name = String::deserialize(deserializer)?;
    of_name(&name)
}

fn of_name<T: Named, E: Error>(name: &str) -> Result<T, E> {
    let found = T::ALL.iter().find(|value| value.name() == name);
    let unknown = || E::custom(format_args!("{name:?} is unknown"));
    found.copied().ok_or_else(unknown)
}

/// Lists of names.
pub mod list {
    use super::*;

    /// Writes the names.
    pub fn serialize<T: Named, S: Serializer>(
        values: &[T],
        serializer: S,
    ) -> Result<S::Ok, S::Error> {
        let names: Vec<&str> = values.iter().map(|value| value.name()).collect();
        names.serialize(serializer)
    }

    /// Reads the names.
    pub fn deserialize<'de, T: Named, D: Deserializer<'de>>(
        deserializer: D,
    ) -> Result<Vec<T>, D::Error> {
        let names = Vec::<String>::deserialize(deserializer)?;
        names.iter().map(|name| of_name(name)).collect()
    }
}
