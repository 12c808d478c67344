//! Listed studies and sweeps: which a list shows, and what of their rows is changed for it.

/// Whether archived ones are listed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Archived {
    /// Entries that aren't archived.
    #[default]
    Without,
    /// Archived entries alone.
    Alone,
    /// Entries, archived or not.
    All,
}

impl Archived {
    /// Whether a listed one is archived; `None` where that doesn't matter.
    pub(crate) fn wanted(self) -> Option<bool> {
        match self {
            Self::Without => Some(false),
            Self::Alone => Some(true),
            Self::All => None,
        }
    }
}

/// Search in a list.
#[derive(Debug, Clone, Copy, Default)]
pub struct Listed<'l> {
    /// A part of the name, whatever the case of ASCII letters, or the beginning of the identifier.
    pub search: Option<&'l str>,
    /// Whether archived ones are listed.
    pub archived: Archived,
}

/// Change of a row; what is `None` stays. The document and its hash stay as they were submitted.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct RowChange {
    /// The name shown in lists.
    pub name: Option<String>,
    /// Whether lists leave it out.
    pub archived: Option<bool>,
}
