//! Numbers of inputs that are exchanged, and means that don't depend on the order of the two.

/// Returns what belongs to the inputs, once input i has what input `inputs[i]` had.
pub(crate) fn exchanged<T: Clone>(of_inputs: &[T], inputs: &[usize]) -> Vec<T> {
    let taken = inputs.iter().map(|&input| of_inputs[input].clone());
    taken.collect()
}

/// (a + b)/2, the same to the bit for (b, a), and a for (a, a).
pub(crate) fn mean(a: f64, b: f64) -> f64 {
    if a == b { a } else { 0.5 * a + 0.5 * b }
}

/// Returns the mean of each two.
pub(crate) fn means(a: &[f64], b: &[f64]) -> Vec<f64> {
    a.iter().zip(b).map(|(&a, &b)| mean(a, b)).collect()
}
