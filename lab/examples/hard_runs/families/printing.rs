//! Ways in which simulators print numbers.

use crate::families::draw::Draw;

/// A format, of so many digits.
#[derive(Debug, Clone, Copy)]
pub enum Printing {
    /// All digits of a double.
    Whole,
    /// `%.6g`, zeros at the end left out.
    Significant(usize),
    /// `%.5e`
    Scientific(usize),
    /// `%.2f`
    Decimals(usize),
}

impl Printing {
    /// Draws three to eight digits, in any of the usual formats.
    pub fn any(d: &mut Draw) -> Self {
        let digits = d.count(3, 8);
        match d.count(0, 2) {
            0 => Self::Significant(digits),
            1 => Self::Scientific(digits),
            _ => Self::Decimals(digits - 2),
        }
    }

    pub fn text(self, y: f64) -> String {
        match self {
            Self::Whole => format!("{y:?}"),
            Self::Significant(digits) => {
                let rounded = format!("{y:.*e}", digits - 1).parse::<f64>();
                rounded.map_or("nan".to_owned(), |y| y.to_string())
            }
            Self::Scientific(digits) => format!("{y:.*e}", digits - 1),
            Self::Decimals(decimals) => format!("{y:.decimals$}"),
        }
    }
}
