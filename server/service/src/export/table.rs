//! A table of typed columns: what every format is written from.

use std::borrow::Borrow;

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

    /// No values of a kind.
    fn none(kind: Kind) -> Self {
        match kind {
            Kind::Float | Kind::Share => Self::Float(Vec::new()),
            Kind::Integer => Self::Integer(Vec::new()),
            Kind::Bool => Self::Bool(Vec::new()),
            Kind::Text => Self::Text(Vec::new()),
        }
    }

    /// Adds a row's value. A whole number beyond 64 bits, which nothing counts up to, is left out.
    fn push(&mut self, value: Option<&Value>) {
        match self {
            Self::Float(values) => values.push(value.and_then(Value::as_f64)),
            Self::Integer(values) => values.push(value.and_then(Value::as_i64)),
            Self::Bool(values) => values.push(value.and_then(Value::as_bool)),
            Self::Text(values) => values.push(value.map(text)),
        }
    }
}

impl TypedTable {
    /// Makes a table of these columns of rows, of which one is there at a time.
    pub fn of<'c>(
        columns: impl IntoIterator<Item = &'c Column>,
        rows: impl IntoIterator<Item = impl Borrow<Value>>,
    ) -> Self {
        let described: Vec<&Column> = columns.into_iter().collect();
        let typed = |column: &&Column| TypedColumn {
            name: column.name.clone(),
            unit: column.unit,
            values: Values::none(column.kind),
        };
        let mut columns: Vec<TypedColumn> = described.iter().map(typed).collect();
        for row in rows {
            for (described, column) in described.iter().zip(&mut columns) {
                column.values.push(described.value(row.borrow()));
            }
        }
        Self { columns }
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
