//! An unlikely value.

use std::fmt;

use document::fields::plain;

/// An unlikely value.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Slip {
    /// Field or table of the scene, as in `material.d1_per_mpa`.
    pub field: String,
    /// Reason why it is unlikely, and the value that may have been meant.
    pub detail: String,
}

impl fmt::Display for Slip {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(formatter, "{}: {}", self.field, self.detail)
    }
}

impl Slip {
    pub(super) fn of(field: &str, detail: impl Into<String>) -> Self {
        Self {
            field: field.to_owned(),
            detail: detail.into(),
        }
    }
}

/// A reason why a scene has no equilibrium, with its unlikely values behind: they may be why.
pub fn noting(reason: String, slips: &[Slip]) -> String {
    let note = |all: String, slip: &Slip| format!("{all}; unlikely value in {slip}");
    slips.iter().fold(reason, note)
}

/// A number for people: four digits.
pub(super) fn rounded(number: f64) -> String {
    format!("{number:.3e}")
        .parse()
        .map_or_else(|_| plain(number), plain)
}
