//! Sums and comparisons side by side: one alone would wait for the one before.

/// Sums that are made side by side.
pub(super) const LANES: usize = 4;

/// Returns the scalar product of two lists of one length.
pub(super) fn dot(a: &[f64], b: &[f64]) -> f64 {
    let (whole, rest) = a.split_at(a.len() - a.len() % LANES);
    let rest = rest.iter().zip(&b[whole.len()..]);
    in_lanes(whole, b) + rest.map(|(a, b)| a * b).sum::<f64>()
}

/// Returns the scalar product of two lists whose length is a multiple of [`LANES`].
pub(super) fn in_lanes(a: &[f64], b: &[f64]) -> f64 {
    let mut sums = [0.0; LANES];
    for (a, b) in a.chunks_exact(LANES).zip(b.chunks_exact(LANES)) {
        for k in 0..LANES {
            sums[k] += a[k] * b[k];
        }
    }
    (sums[0] + sums[1]) + (sums[2] + sums[3])
}

/// Returns the largest of some values.
pub(super) fn largest(values: &[f64]) -> f64 {
    let mut lanes = [f64::NEG_INFINITY; 8];
    let chunks = values.chunks_exact(lanes.len());
    let rest = chunks.remainder();
    for values in chunks {
        for (lane, value) in lanes.iter_mut().zip(values) {
            *lane = if value > lane { *value } else { *lane };
        }
    }
    lanes
        .iter()
        .chain(rest)
        .copied()
        .fold(f64::NEG_INFINITY, f64::max)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_value_is_left_out() {
        for count in 1..20 {
            let values: Vec<f64> = (1..=count).map(f64::from).collect();
            let squares = f64::from(count * (count + 1) * (2 * count + 1)) / 6.0;
            assert_eq!(dot(&values, &values), squares);
            let negative: Vec<f64> = values.iter().map(|value| -value).collect();
            assert_eq!(
                (largest(&values), largest(&negative)),
                (f64::from(count), -1.0)
            );
        }
    }
}
