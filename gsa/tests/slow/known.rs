//! A model whose first-order indices are known.

use gsa::law::distribution::Distribution;

/// Inputs to output.
pub type Model = Box<dyn Fn(&[f64]) -> f64>;

/// A model whose indices are known: where its inputs come from, how it answers, and which indices are right.
pub struct Known {
    pub family: &'static str,
    pub inputs: Vec<Distribution>,
    pub model: Model,
    pub first_order: Vec<f64>,
}

impl Known {
    /// Largest difference of first-order indices from the exact ones.
    pub fn error_of(&self, first_order: &[f64]) -> f64 {
        let pairs = first_order.iter().zip(&self.first_order);
        pairs
            .map(|(s, exact)| (s - exact).abs())
            .fold(0.0, f64::max)
    }
}

/// The value below which this share of them lies.
pub fn quantile(mut values: Vec<f64>, share: f64) -> f64 {
    values.sort_by(f64::total_cmp);
    values[((values.len() - 1) as f64 * share) as usize]
}
