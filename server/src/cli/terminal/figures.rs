//! Columns of figures for people: titles above, units below them, numbers with their decimals, all as [`results::columns`] describes them.

use results::columns::Column;
use serde_json::Value;

use super::paint::header;

/// Spaces before a column.
const GAP: usize = 2;

/// Figures of some rows, at the right of what each row is of.
pub struct Figures {
    heads: Vec<Vec<String>>,
    widths: Vec<usize>,
    cells: Vec<Vec<String>>,
}

impl Figures {
    /// Lays out these columns of these rows, as wide as their figures ask for.
    pub fn of(columns: &[&Column], rows: &[Value]) -> Self {
        let of_row = |row| {
            columns
                .iter()
                .map(|column| column.shown_with_error(row))
                .collect()
        };
        let cells: Vec<Vec<String>> = rows.iter().map(of_row).collect();
        let figure = |k: usize| cells.iter().map(|row| width(&row[k])).max().unwrap_or(0);
        let widths = (0..columns.len()).map(figure);
        let (heads, widths) = columns
            .iter()
            .zip(widths)
            .map(|(column, figure)| {
                let head = heading(column, figure);
                let own = head.iter().map(|line| width(line)).max().unwrap_or(0);
                (head, own.max(figure) + GAP)
            })
            .unzip();
        Self {
            heads,
            widths,
            cells,
        }
    }

    /// Lines above them. The last one begins with what stands above the rows' names, which are `left` characters wide, and ends with `right`.
    pub fn head(&self, names: &str, left: usize, right: &str) -> String {
        let lines = self.heads.iter().map(Vec::len).max().unwrap_or(0);
        let mut text = String::new();
        for line in 0..lines {
            let words = self.heads.iter().map(|head| {
                let own = (line + head.len()).checked_sub(lines);
                own.map_or("", |own| head[own].as_str())
            });
            let [names, right] = if line + 1 == lines {
                [names, right]
            } else {
                [""; 2]
            };
            let row = format!("{names:<left$}{}{right}", self.padded(words));
            text.push_str(row.trim_end());
            text.push('\n');
        }
        header(&text)
    }

    /// Figures of a row, counted from 0.
    pub fn row(&self, row: usize) -> String {
        self.padded(self.cells[row].iter().map(String::as_str))
    }

    fn padded<'c>(&self, cells: impl Iterator<Item = &'c str>) -> String {
        let widths = self.widths.iter();
        widths
            .zip(cells)
            .map(|(width, cell)| format!("{cell:>width$}"))
            .collect()
    }
}

fn width(text: &str) -> usize {
    text.chars().count()
}

/// A column's title in two lines at most, no wider than that or its figures ask for, and its unit.
fn heading(column: &Column, figure: usize) -> Vec<String> {
    let whole = width(&column.title);
    let mut widths = figure..whole;
    let fits = widths.find_map(|most| {
        Some(lines(&column.title, most))
            .filter(|it| it.len() <= 2 && it.iter().all(|line| width(line) <= most))
    });
    let mut lines = fits.unwrap_or_else(|| vec![column.title.clone()]);
    lines.extend(column.shown_unit().map(str::to_owned));
    lines
}

/// A text in lines of at most so many characters, broken between words.
fn lines(text: &str, most: usize) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in text.split(' ') {
        match lines.last_mut() {
            Some(line) if width(line) + 1 + width(word) <= most => {
                line.push(' ');
                line.push_str(word);
            }
            _ => lines.push(word.to_owned()),
        }
    }
    lines
}

#[cfg(test)]
mod tests {
    use results::columns::Column;
    use serde_json::json;

    use super::*;
    use crate::cli::terminal::shown::plain;

    #[test]
    fn titles_stand_above_units_above_figures() {
        let columns = [
            Column::integer("film_count", "/films").titled("films", 0),
            Column::share("lost_share", "/lost").titled("lost", 1),
            Column::float("bound_deg", "/bound").titled("angle bound", 2),
        ];
        let columns: Vec<&Column> = columns.iter().collect();
        let rows = [
            json!({"films": 12, "lost": 0.03125, "bound": null}),
            json!({"films": 6, "lost": 1, "bound": 12.3456}),
        ];
        let figures = Figures::of(&columns, &rows);
        let head = figures.head("rank", 6, "  rank is");
        let head = plain(&head);
        let expected = "                      angle\n                lost  bound\nrank    films      %    deg  rank is\n";
        assert_eq!(head, expected);
        assert_eq!(figures.row(0), "     12    3.1      -");
        assert_eq!(figures.row(1), "      6  100.0  12.35");
    }
}
