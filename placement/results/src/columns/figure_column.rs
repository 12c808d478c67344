//! A column: where its value stands in a row, and how people and programs are shown it.

use serde::Serialize;
use serde_json::Value;

use super::unit::{PERCENT, unit_of};

/// Type of a column's values.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Kind {
    /// 64-bit floating point.
    Float,
    /// A share of 1, which people are shown in percent.
    Share,
    /// 64-bit integers.
    Integer,
    /// Truth values.
    Bool,
    /// Texts; those of a list are joined by `+`.
    Text,
}

/// The one description of a figure, from which files, terminal, dashboard and data frames are written.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Column {
    /// Name in files and data frames, with the unit where that isn't obvious.
    pub name: String,
    /// JSON pointer (RFC 6901) of its value in a row.
    pub at: String,
    /// Type of its values.
    pub kind: Kind,
    /// Unit of the values: `1` for pure numbers; `None` for texts, ranks, counts and the like, which have none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub unit: Option<&'static str>,
    /// The `unit` of the rows that have a value, where films read strains in some studies and volts in others.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub of_unit: Option<&'static str>,
    /// Title above it for people, without the unit.
    pub title: String,
    /// Decimals that people are shown.
    pub digits: usize,
    /// JSON pointer of the claimed error, which people are shown beside it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub error_at: Option<&'static str>,
    /// View for people that has it, of those with other columns of its table.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub view: Option<&'static str>,
    /// Meaning of a value that is no field of an answer; that of a field is its own.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub description: Option<&'static str>,
    /// Whether files and data frames have it; the others are for people alone.
    #[serde(skip)]
    pub is_exported: bool,
}

impl Column {
    fn new(name: &str, at: &str, kind: Kind) -> Self {
        Self {
            name: name.to_owned(),
            at: at.to_owned(),
            kind,
            unit: None,
            of_unit: None,
            title: name.replace('_', " "),
            digits: 2,
            error_at: None,
            view: None,
            description: None,
            is_exported: true,
        }
    }

    /// A column of numbers, whose name says the unit.
    pub fn float(name: &str, at: &str) -> Self {
        Self::new(name, at, Kind::Float).in_unit(unit_of(name))
    }

    /// A column of shares.
    pub fn share(name: &str, at: &str) -> Self {
        let column = Self::new(name, at, Kind::Share);
        column.in_unit(super::unit::PURE)
    }

    /// A column of whole numbers.
    pub fn integer(name: &str, at: &str) -> Self {
        Self::new(name, at, Kind::Integer)
    }

    /// A column of truth values.
    pub fn bool(name: &str, at: &str) -> Self {
        Self::new(name, at, Kind::Bool)
    }

    /// A column of texts.
    pub fn text(name: &str, at: &str) -> Self {
        Self::new(name, at, Kind::Text)
    }

    /// Says what a value means that is no field of an answer.
    #[must_use]
    pub fn described(self, description: &'static str) -> Self {
        let description = Some(description);
        Self {
            description,
            ..self
        }
    }

    /// Sets another unit than its name says.
    #[must_use]
    pub fn in_unit(self, unit: &'static str) -> Self {
        Self {
            unit: Some(unit),
            ..self
        }
    }

    /// Gives it a value in rows of this unit alone.
    #[must_use]
    pub(crate) fn of_unit(self, unit: &'static str) -> Self {
        Self {
            of_unit: Some(unit),
            ..self
        }
    }

    /// Sets the title that people are shown above it, and the number of decimals.
    #[must_use]
    pub fn titled(self, title: &str, digits: usize) -> Self {
        let title = title.to_owned();
        Self {
            title,
            digits,
            ..self
        }
    }

    /// Sets the claimed error beside it.
    #[must_use]
    pub fn with_error(self, at: &'static str) -> Self {
        Self {
            error_at: Some(at),
            ..self
        }
    }

    /// Shows people it in a view, beside the columns that are in it, too.
    #[must_use]
    pub(crate) fn in_view(self, view: &'static str) -> Self {
        let view = Some(view);
        Self { view, ..self }
    }

    /// Keeps it out of files: for people alone.
    #[must_use]
    pub(crate) fn unexported(self) -> Self {
        Self {
            is_exported: false,
            ..self
        }
    }

    /// Unit in which people are shown it.
    pub fn shown_unit(&self) -> Option<&'static str> {
        match self.kind {
            Kind::Share => Some(PERCENT),
            _ => self.unit.filter(|unit| *unit != super::unit::PURE),
        }
    }

    /// Finds its value in a row; `None` where that has none.
    pub fn value<'r>(&self, row: &'r Value) -> Option<&'r Value> {
        let is_other = self.of_unit.is_some_and(|unit| row["unit"] != unit);
        let value = row.pointer(&self.at).filter(|value| !value.is_null());
        value.filter(|_| !is_other)
    }

    /// Words of its value as people are shown it: `-` where there is none.
    pub fn shown(&self, row: &Value) -> String {
        let value = self.value(row).map(|value| self.words(value));
        value.unwrap_or_else(|| "-".to_owned())
    }

    /// Title, value and unit, as in `off by 2.92 N`.
    pub fn in_words(&self, row: &Value) -> String {
        let unit = self.shown_unit().unwrap_or_default();
        let words = format!("{} {} {unit}", self.title, self.shown(row));
        words.trim_end().to_owned()
    }

    /// Words of its value with `+-` and the claimed error, where there is one.
    pub fn shown_with_error(&self, row: &Value) -> String {
        let error = self.error_at.and_then(|at| row.pointer(at));
        let error = error.filter(|error| !error.is_null());
        match error.filter(|_| self.value(row).is_some()) {
            Some(error) => format!("{} +-{}", self.shown(row), self.words(error)),
            None => self.shown(row),
        }
    }

    fn words(&self, value: &Value) -> String {
        let digits = self.digits;
        let number = value.as_f64().unwrap_or(f64::NAN);
        match self.kind {
            Kind::Float => format!("{number:.digits$}"),
            Kind::Share => format!("{:.digits$}", 100.0 * number),
            Kind::Bool => if value == true { "yes" } else { "no" }.to_owned(),
            Kind::Integer => value.to_string(),
            Kind::Text => text(value),
        }
    }
}

/// A text as it is; those of a list joined by `+`.
pub fn text(value: &Value) -> String {
    match value {
        Value::String(text) => text.clone(),
        Value::Array(texts) => {
            let texts: Vec<String> = texts.iter().map(text).collect();
            texts.join("+")
        }
        other => other.to_string(),
    }
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    #[test]
    fn a_column_is_shown_in_its_unit_with_its_error() {
        let row = json!({"unit": "V", "score": {"off": 1.2345, "error": 0.3, "lost": 0.0125, "films": ["x", "45"]}});
        let off = Column::float("off_deg", "/score/off").titled("off", 2);
        assert_eq!(
            (off.shown_unit(), off.shown(&row)),
            (Some("deg"), "1.23".to_owned())
        );
        let off = off.with_error("/score/error");
        assert_eq!(off.shown_with_error(&row), "1.23 +-0.30");
        let lost = Column::share("lost_share", "/score/lost").titled("lost", 1);
        assert_eq!(
            (lost.shown_unit(), lost.shown(&row)),
            (Some("%"), "1.2".to_owned())
        );
        assert_eq!(Column::text("films", "/score/films").shown(&row), "x+45");
        assert_eq!(Column::text("films", "/score/none").shown(&row), "-");
        let [strain, volts] =
            ["strain", "V"].map(|unit| Column::float("off", "/score/off").of_unit(unit));
        assert_eq!(
            (strain.value(&row), volts.value(&row)),
            (None, Some(&json!(1.2345)))
        );
    }
}
