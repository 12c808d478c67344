//! A table of typed columns: the one list of columns from which every format is written.

/// Columns of the same length.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct TypedTable {
    /// In order.
    pub columns: Vec<Column>,
}

/// One column.
#[derive(Debug, Clone, PartialEq)]
pub struct Column {
    /// Its name, with the unit where that isn't obvious.
    pub name: String,
    /// Its unit: `1` for pure numbers; `None` for texts, ranks, counts and the like, which have none.
    pub unit: Option<&'static str>,
    /// One value a row.
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
}

/// What a table is made of: fills columns from one row after the other of something.
#[derive(Debug)]
pub struct Rows<T> {
    rows: Vec<T>,
    table: TypedTable,
}

impl<T> Rows<T> {
    /// A table with one row for each of these, and no column yet.
    pub fn of(rows: impl IntoIterator<Item = T>) -> Self {
        Self {
            rows: rows.into_iter().collect(),
            table: TypedTable::default(),
        }
    }

    /// A column of numbers.
    #[must_use]
    pub fn float(
        self,
        name: impl Into<String>,
        unit: &'static str,
        value: impl Fn(&T) -> Option<f64>,
    ) -> Self {
        let values = self.rows.iter().map(value).collect();
        self.with(name, Some(unit), Values::Float(values))
    }

    /// A column of whole numbers. One beyond 64 bits, which nothing counts up to, is left out.
    #[must_use]
    pub fn integer<N: TryInto<i64>>(self, name: &str, value: impl Fn(&T) -> Option<N>) -> Self {
        let whole = |row| value(row).and_then(|number| number.try_into().ok());
        let values = self.rows.iter().map(whole).collect();
        self.with(name, None, Values::Integer(values))
    }

    /// A column of truth values.
    #[must_use]
    pub fn bool(self, name: &str, value: impl Fn(&T) -> Option<bool>) -> Self {
        let values = self.rows.iter().map(value).collect();
        self.with(name, None, Values::Bool(values))
    }

    /// A column of texts.
    #[must_use]
    pub fn text(self, name: &str, value: impl Fn(&T) -> Option<&str>) -> Self {
        let owned = |row: &T| value(row).map(str::to_owned);
        self.made_text(name, owned)
    }

    /// A column of texts that are made for it.
    #[must_use]
    pub fn made_text(self, name: &str, value: impl Fn(&T) -> Option<String>) -> Self {
        let values = self.rows.iter().map(value).collect();
        self.with(name, None, Values::Text(values))
    }

    /// A column with the same text in every row.
    #[must_use]
    pub fn constant(self, name: &str, text: &str) -> Self {
        let values = vec![Some(text.to_owned()); self.rows.len()];
        self.with(name, None, Values::Text(values))
    }

    /// The table.
    pub fn table(self) -> TypedTable {
        self.table
    }

    fn with(mut self, name: impl Into<String>, unit: Option<&'static str>, values: Values) -> Self {
        self.table.columns.push(Column {
            name: name.into(),
            unit,
            values,
        });
        self
    }
}
