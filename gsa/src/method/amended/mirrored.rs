//! Analysis of two outputs that are mirror images of each other.

use crate::exchange::{exchanged, mean, means};
use crate::form::composite::pair;
use crate::method::analysis::Analysis;

impl Analysis {
    /// Returns the analysis of the output's mirror image; `inputs` are exchanged. The reason keeps the words.
    pub(crate) fn mirrored(&self, inputs: &[usize]) -> Self {
        let of_inputs = |values: &Option<Vec<f64>>| Some(exchanged(values.as_ref()?, inputs));
        Self {
            first_order: of_inputs(&self.first_order),
            total: of_inputs(&self.total),
            second_order: self.second_order.as_deref().map(|s| of_pairs(s, inputs)),
            mdrm_first_order: of_inputs(&self.mdrm_first_order),
            mdrm_total: of_inputs(&self.mdrm_total),
            error: self.error.mirrored(inputs),
            misses: self.misses.as_ref().map(|misses| misses.mirrored(inputs)),
            ..self.clone()
        }
    }

    /// The mean with what the same method said of the output's mirror image: the same to the bit for either. Sums that are taken in another
    /// order round otherwise; where that leads to another form, or checks to be lost, each keeps its own.
    pub(crate) fn mean_with(&self, other: &Self) -> Self {
        if self.method != other.method || self.status != other.status {
            return self.clone();
        }
        let misses = self.misses.as_ref().zip(other.misses.as_ref());
        let misses = misses.map(|(own, other)| own.mean_with(other));
        if misses == Some(None) {
            return self.clone();
        }
        let both = |a: Option<f64>, b: Option<f64>| a.zip(b).map(|(a, b)| mean(a, b));
        let each =
            |a: &Option<Vec<f64>>, b: &Option<Vec<f64>>| Some(means(a.as_ref()?, b.as_ref()?));
        Self {
            mean: both(self.mean, other.mean),
            variance: both(self.variance, other.variance),
            first_order: each(&self.first_order, &other.first_order),
            total: each(&self.total, &other.total),
            second_order: each(&self.second_order, &other.second_order),
            mdrm_first_order: each(&self.mdrm_first_order, &other.mdrm_first_order),
            mdrm_total: each(&self.mdrm_total, &other.mdrm_total),
            error: self.error.mean_with(&other.error),
            misses: misses.flatten(),
            ..self.clone()
        }
    }
}

/// Shares of pairs of inputs, in the order 12, 13, .., 23, ..
fn of_pairs(shares: &[f64], inputs: &[usize]) -> Vec<f64> {
    let n = inputs.len();
    let pairs = (0..n).flat_map(|i| (i + 1..n).map(move |j| (i, j)));
    let image = |(i, j): (usize, usize)| {
        let (k, l) = (inputs[i], inputs[j]);
        shares[pair(n, k.min(l), k.max(l))]
    };
    pairs.map(image).collect()
}
