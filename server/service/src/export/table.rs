//! A table of typed columns: what every format is written from.

use results::columns::{Column, Kind, text};
use serde_json::Value;

/// Columns of the same length.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct TypedTable {
    /// Columns in order.
    pub columns: Vec<TypedColumn>,
}

/// Column of one type.
#[derive(Debug, Clone, PartialEq)]
pub struct TypedColumn {
    /// Name, with the unit where that isn't obvious.
    pub name: String,
    /// Unit: `1` for pure numbers; `None` for texts, ranks, counts and the like, which have none.
    pub unit: Option<&'static str>,
    /// Values, one a row.
    pub values: Values,
}

/// Values of a column; what doesn't exist is `None`.
#[derive(Debug, Clone, PartialEq)]
pub enum Values {
    /// 64-bit floating point.
    Float(Vec<Option<f64>>),
    /// 64-bit integers.
    Integer(Vec<Option<i64>>),
    /// Truth values.
    Bool(Vec<Option<bool>>),
    /// UTF-8 texts.
    Text(Vec<Option<String>>),
}

impl Values {
    /// Number of rows.
    pub fn len(&self) -> usize {
        match self {
            Self::Float(values) => values.len(),
            Self::Integer(values) => values.len(),
            Self::Bool(values) => values.len(),
            Self::Text(values) => values.len(),
        }
    }

    /// A column's values. A whole number beyond 64 bits, which nothing counts up to, is left out.
    fn of(column: &Column, rows: &[Value]) -> Self {
        let values = rows.iter().map(|row| column.value(row));
        match column.kind {
            Kind::Float | Kind::Share => Self::Float(values.map(|value| value?.as_f64()).collect()),
            Kind::Integer => Self::Integer(values.map(|value| value?.as_i64()).collect()),
            Kind::Bool => Self::Bool(values.map(|value| value?.as_bool()).collect()),
            Kind::Text => Self::Text(values.map(|value| value.map(text)).collect()),
        }
    }
}

impl TypedTable {
    /// Makes a table of these columns of rows.
    pub fn of<'c>(columns: impl IntoIterator<Item = &'c Column>, rows: &[Value]) -> Self {
        let typed = |column: &Column| TypedColumn {
            name: column.name.clone(),
            unit: column.unit,
            values: Values::of(column, rows),
        };
        Self {
            columns: columns.into_iter().map(typed).collect(),
        }
    }

    /// Adds a column that has the same text in every row.
    #[must_use]
    pub fn constant(mut self, name: &str, text: &str) -> Self {
        let rows = self.columns.first().map_or(0, |column| column.values.len());
        self.columns.push(TypedColumn {
            name: name.to_owned(),
            unit: None,
            values: Values::Text(vec![Some(text.to_owned()); rows]),
        });
        self
    }
}
