//! Rows as structs: what a derive macro would write, without the second build of SQLite that the macro needs.

/// Reads the columns named, and after a semicolon the parts that are rows themselves.
macro_rules! from_row {
    ($row:ident { $($column:ident),+ $(; $($part:ident),+)? }) => {
        impl<'r> sqlx::FromRow<'r, sqlx::sqlite::SqliteRow> for $row {
            fn from_row(row: &'r sqlx::sqlite::SqliteRow) -> Result<Self, sqlx::Error> {
                Ok(Self {
                    $($column: sqlx::Row::try_get(row, stringify!($column))?,)+
                    $($($part: sqlx::FromRow::from_row(row)?,)+)?
                })
            }
        }
    };
}

pub(crate) use from_row;
