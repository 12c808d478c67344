//! Largest error among several.

/// Returns the largest absolute value, 0 of none.
pub fn largest(values: impl Iterator<Item = f64>) -> f64 {
    values.fold(0.0, |largest: f64, value| largest.max(value.abs()))
}
