//! Columns that a recording is read without, and the lines of its rows.

use crate::recording::csv_line::{cells, number};
use crate::recording::csv_recording::{MOST_COLUMNS, lines};

/// Numbers in a column that nothing is read from.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct UnreadColumn {
    /// Value of each row; NaN where the cell is empty or no number.
    pub values: Vec<f64>,
    /// Cells with text.
    pub texts: usize,
}

/// The columns at these places of a header, of a file that was read without a fault.
pub fn unread_columns(text: &str, places: &[usize]) -> Vec<UnreadColumn> {
    let mut columns = vec![UnreadColumn::default(); places.len()];
    if places.is_empty() {
        return columns;
    }
    for (_, line) in lines(text).skip(1) {
        let cells = cells(line, MOST_COLUMNS).unwrap_or_default();
        for (column, place) in columns.iter_mut().zip(places) {
            let value = number(cells.get(*place).map_or("", |cell| cell));
            column.texts += usize::from(value.is_err());
            column.values.push(value.ok().flatten().unwrap_or(f64::NAN));
        }
    }
    columns
}

/// The lines of these rows, which rise, counted from 0.
pub fn lines_of_rows(text: &str, rows: &[usize]) -> Vec<usize> {
    let mut asked = rows.iter().copied().peekable();
    let mut found = Vec::new();
    for (row, (line, _)) in lines(text).skip(1).enumerate() {
        while asked.next_if_eq(&row).is_some() {
            found.push(line);
        }
        if asked.peek().is_none() {
            break;
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = "\n t,note,a\n0,x,1\n\n1,,2\n2,3,\n";

    #[test]
    fn numbers_are_read_where_there_are_any() {
        let found = unread_columns(TEXT, &[1, 2]);
        let [note, a] = found.as_slice() else {
            panic!("{found:?}");
        };
        assert_eq!((note.texts, a.texts), (1, 0));
        assert!(
            note.values
                .iter()
                .zip([f64::NAN, f64::NAN, 3.0])
                .all(|(a, b)| a.total_cmp(&b).is_eq())
        );
        assert_eq!(a.values.get(..2), Some([1.0, 2.0].as_slice()));
        assert!(unread_columns(TEXT, &[]).is_empty());
    }

    #[test]
    fn rows_have_their_lines() {
        assert_eq!(lines_of_rows(TEXT, &[0, 1, 2]), [3, 5, 6]);
        assert_eq!(lines_of_rows(TEXT, &[1, 1, 7]), [5, 5]);
    }
}
