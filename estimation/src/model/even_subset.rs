//! Fewer rows, evenly taken.

/// Returns at most `most` of so many rows, at even distances, the first among them.
pub(crate) fn even_subset(rows: usize, most: usize) -> Vec<usize> {
    if rows <= most {
        return (0..rows).collect();
    }
    (0..most).map(|place| place * rows / most).collect()
}

#[cfg(test)]
mod tests {
    use super::even_subset;

    #[test]
    fn a_subset_is_even() {
        assert_eq!(even_subset(3, 5), [0, 1, 2]);
        assert_eq!(even_subset(10, 4), [0, 2, 5, 7]);
        assert_eq!(even_subset(0, 4), [0; 0]);
    }
}
