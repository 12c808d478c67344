//! Ways in which simulators print numbers.

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
