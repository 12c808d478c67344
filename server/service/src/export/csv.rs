//! A table as comma-separated values (RFC 4180): a header and one line per row.

use documents::own_model::csv_cell::cell;

use super::table::{TypedTable, Values};

/// The text of a table. Numbers are the shortest that read back as the same; what doesn't exist is an empty field.
pub fn csv(table: &TypedTable) -> String {
    let columns = &table.columns;
    let mut text = String::new();
    line(&mut text, columns.iter().map(|column| cell(&column.name)));
    let rows = columns.first().map_or(0, |column| column.values.len());
    for row in 0..rows {
        line(
            &mut text,
            columns.iter().map(|column| field(&column.values, row)),
        );
    }
    text
}

fn line(text: &mut String, fields: impl Iterator<Item = String>) {
    let fields: Vec<String> = fields.collect();
    text.push_str(&fields.join(","));
    text.push('\n');
}

fn field(values: &Values, row: usize) -> String {
    fn text<T: ToString>(values: &[Option<T>], row: usize) -> String {
        let value = values.get(row).and_then(Option::as_ref);
        value.map(T::to_string).unwrap_or_default()
    }
    match values {
        Values::Float(values) => text(values, row),
        Values::Integer(values) => text(values, row),
        Values::Bool(values) => text(values, row),
        Values::Text(values) => cell(&text(values, row)),
    }
}

#[cfg(test)]
mod tests {
    use results::columns::Column;
    use serde_json::json;

    use super::*;

    #[test]
    fn what_users_name_can_not_break_a_row() {
        let rows = [
            json!(["plain", 0.1]),
            json!(["a,b", null]),
            json!(["say \"P3\"", -2e-300]),
            json!(["=1+1", null]),
        ];
        let columns = [Column::text("two\nlines", "/0"), Column::float("y", "/1")];
        let table = TypedTable::of(&columns, &rows);
        let tiny = format!("-0.{}2", "0".repeat(299));
        assert_eq!(
            csv(&table),
            format!("\"two\nlines\",y\nplain,0.1\n\"a,b\",\n\"say \"\"P3\"\"\",{tiny}\n'=1+1,\n")
        );
    }
}
