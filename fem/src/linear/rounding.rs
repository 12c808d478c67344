//! Rounding a factor to single precision.

/// Entries that are rounded before their memory is given back: 8 MB.
const ROUNDED_AT_ONCE: usize = 1 << 20;

/// Rounds to single precision. An entry below its normal numbers is as good as zero, and would slow every substitution down.
pub(super) fn single(value: f64) -> f32 {
    let rounded = value as f32;
    if rounded.is_subnormal() { 0.0 } else { rounded }
}

/// Rounds from the end and gives memory back on the way, so that the two never stand side by side.
pub(super) fn all_single(mut values: Vec<f64>) -> Result<Vec<f32>, Vec<f64>> {
    let mut rounded = Vec::new();
    if rounded.try_reserve_exact(values.len()).is_err() {
        return Err(values);
    }
    while !values.is_empty() {
        let kept = values.len().saturating_sub(ROUNDED_AT_ONCE);
        rounded.extend(values.drain(kept..).rev().map(single));
        values.shrink_to_fit();
    }
    rounded.reverse();
    Ok(rounded)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rounding_in_pieces_keeps_the_order() {
        // Integers up to 2^24 and a number below the normal ones of single precision.
        let mut values: Vec<f64> = (0..ROUNDED_AT_ONCE + 3).map(|k| k as f64).collect();
        values[2] = 1e-40;
        let rounded = all_single(values).expect("little memory");
        assert_eq!(rounded.len(), ROUNDED_AT_ONCE + 3);
        let expected = |k: usize| if k == 2 { 0.0 } else { k as f32 };
        assert!((0..).zip(&rounded).all(|(k, value)| *value == expected(k)));
    }
}
