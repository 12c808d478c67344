//! A table of an answer.

use super::figure_column::Column;

/// A table: the types that its rows are made of, and its columns.
#[derive(Debug, Clone)]
pub struct Table {
    /// Name of the table.
    pub name: &'static str,
    /// Parts of a row: the name there, and the type in the description of the service.
    pub parts: &'static [(&'static str, &'static str)],
    /// Columns in the order of files.
    pub columns: Vec<Column>,
}

impl Table {
    /// Columns that people are shown together.
    pub fn view(&self, name: &str) -> Vec<&Column> {
        let columns = self.columns.iter();
        columns.filter(|column| column.view == Some(name)).collect()
    }

    /// Columns of files and data frames.
    pub fn exported(&self) -> impl Iterator<Item = &Column> {
        self.columns.iter().filter(|column| column.is_exported)
    }
}
