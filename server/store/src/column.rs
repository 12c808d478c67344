//! Counts and ordinals as columns hold them.

/// Converts to a whole number as SQLite has them.
pub fn whole(number: usize) -> i64 {
    i64::try_from(number).unwrap_or(i64::MAX)
}

/// Converts to a count; `None` of a negative number, which isn't one that was written.
pub fn counted(column: i64) -> Option<usize> {
    usize::try_from(column).ok()
}
