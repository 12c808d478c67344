//! Counts and ordinals as columns hold them.

/// As SQLite's whole numbers are.
pub fn whole(number: usize) -> i64 {
    i64::try_from(number).unwrap_or(i64::MAX)
}

/// `None` of a negative number, which isn't one that was written.
pub fn counted(column: i64) -> Option<usize> {
    usize::try_from(column).ok()
}
