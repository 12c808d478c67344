//! Errors of an index: the parts that the runs themselves reveal.
//!
//! Every part is an absolute error of a first-order index, the largest over the inputs, and at most 1, as an index is.
//!
//! | part | what it sees | what it is blind to |
//! |---|---|---|
//! | quadrature | sections too rough for the rule (kinks) | interactions |
//! | decomposition | interactions the form has no place for | quadrature |
//! | sampling | chance in which points were drawn | everything else |
//! | floor | the model's rounding | everything else |
//! | lost | what may be where runs failed (`failed_share`) | everything else |
//! | rounding | digits that values were printed with (`printed_digits`) | everything else |
//!
//! **Quadrature.** A share m_i of section i's variance is missing (`spectrum`). With S_i and S_Ti the indices,
//!
//! ```text
//! dS_i = S_i (1 - S_i) m_i + S_i sum_{j != i} S_Tj m_j
//! ```
//!
//! **Decomposition.** What the form misses at the check points, weighed by what it does to an index: [`crate::judge::misses`].
//!
//! Where a whole grid or all pairs are known, points off all nodes show what the nodes don't resolve: it lowers or confirms what the
//! modes make suspect (`spectrum`), and a share of its mean square is part of the decomposition error.
//!
//! The sum is an estimate, not a bound: few check points may all miss an interaction. Indicators that cost nothing
//! (1 - sum S_i, the difference between two forms) were found to carry no information and are not used.

use crate::exchange::{exchanged, mean, means};

/// Parts of the error of an output's first-order indices.
#[derive(Debug, Clone, PartialEq)]
pub struct ErrorParts {
    /// Error by what the rules miss of the sections, from the decay of the modes they resolve; `None` for rules of one or two nodes, which cannot tell.
    pub quadrature: Option<f64>,
    /// Error by what the chosen form misses of the output, from its residuals at the check points; `None` without them.
    pub decomposition: Option<f64>,
    /// Half width of the 95 % confidence interval of indices taken from random points; `None` for other methods.
    pub sampling: Option<f64>,
    /// Error by rounding: eps max|h| over the standard deviation, and the rounding of the sums.
    pub floor: f64,
    /// Error by what the output may do where runs failed; 1 where so many did that nothing is known, `None` where none did.
    pub lost: Option<f64>,
    /// Error by the digits that the values were printed with; `None` where nobody said that they were.
    pub rounding: Option<f64>,
    /// The largest sum, over the inputs, of the parts that are known, and `None` if none but the floor is. Where one is
    /// `None` the total leaves it out, and says less than it seems to.
    pub total: Option<f64>,
    /// The sum of the parts that are known, for each input by itself.
    pub by_input: Option<Vec<f64>>,
    /// S_Ti m_i: which input's rule the quadrature error comes from; empty if it isn't known.
    pub(crate) missing: Vec<f64>,
    /// The share of it that comes from interactions.
    pub(crate) missing_of_interactions: Vec<f64>,
}

/// Parts of the error by input, before they are summed.
#[derive(Debug, Clone, Default)]
pub(crate) struct ByInput {
    pub(crate) quadrature: Option<Vec<f64>>,
    pub(crate) decomposition: Option<Vec<f64>>,
    pub(crate) sampling: Option<Vec<f64>>,
    /// S_Ti m_i
    pub(crate) missing: Vec<f64>,
    pub(crate) missing_of_interactions: Vec<f64>,
}

impl ErrorParts {
    pub(crate) fn new(parts: ByInput, floor: f64) -> Self {
        let known = [&parts.quadrature, &parts.decomposition, &parts.sampling];
        let inputs = known.iter().find_map(|part| part.as_ref().map(Vec::len));
        let by_input = inputs.map(|inputs| {
            let sum = |input: usize| {
                let parts = known.iter().filter_map(|part| part.as_ref());
                at_most_one(parts.map(|part| part[input]).sum::<f64>() + floor)
            };
            (0..inputs).map(sum).collect::<Vec<f64>>()
        });
        Self {
            quadrature: parts.quadrature.as_deref().map(largest),
            decomposition: parts.decomposition.as_deref().map(largest),
            sampling: parts.sampling.as_deref().map(largest),
            floor,
            lost: None,
            rounding: None,
            total: by_input.as_deref().map(largest),
            by_input,
            missing: parts.missing,
            missing_of_interactions: parts.missing_of_interactions,
        }
    }

    /// Returns the errors of the output's mirror image; `inputs` are exchanged.
    pub(crate) fn mirrored(&self, inputs: &[usize]) -> Self {
        let of_known = |parts: &[f64]| match parts.len() {
            0 => Vec::new(),
            _ => exchanged(parts, inputs),
        };
        Self {
            by_input: self.by_input.as_deref().map(of_known),
            missing: of_known(&self.missing),
            missing_of_interactions: of_known(&self.missing_of_interactions),
            ..self.clone()
        }
    }

    /// The mean with what the same analysis said of the output's mirror image.
    pub(crate) fn mean_with(&self, other: &Self) -> Self {
        let both = |a: Option<f64>, b: Option<f64>| a.zip(b).map(|(a, b)| mean(a, b));
        let by_input = self.by_input.as_ref().zip(other.by_input.as_ref());
        let by_input = by_input.map(|(a, b)| means(a, b));
        Self {
            quadrature: both(self.quadrature, other.quadrature),
            decomposition: both(self.decomposition, other.decomposition),
            sampling: both(self.sampling, other.sampling),
            floor: mean(self.floor, other.floor),
            lost: both(self.lost, other.lost),
            rounding: both(self.rounding, other.rounding),
            total: by_input.as_deref().map(largest),
            by_input,
            missing: means(&self.missing, &other.missing),
            missing_of_interactions: means(
                &self.missing_of_interactions,
                &other.missing_of_interactions,
            ),
        }
    }

    /// Adds a part to what is known of each input, and returns its largest; what isn't known stays unknown.
    pub(crate) fn add(&mut self, part: &[f64]) -> f64 {
        for (error, part) in self.by_input.iter_mut().flatten().zip(part) {
            *error = at_most_one(*error + part);
        }
        self.total = self.by_input.as_deref().map(largest);
        largest(part)
    }

    /// Makes the errors of an output that has no indices.
    pub(crate) fn without_indices(floor: f64) -> Self {
        Self::new(ByInput::default(), floor)
    }
}

fn largest(errors: &[f64]) -> f64 {
    errors.iter().copied().fold(0.0, f64::max)
}

/// S_Ti m_i.
pub(crate) fn missing(missing: Option<&[f64]>, total: &[f64]) -> Vec<f64> {
    let shares = missing.unwrap_or_default().iter();
    shares.zip(total).map(|(m, t)| m * t).collect()
}

/// Error of each first-order index from the missing shares m_i of the sections' variances.
pub(crate) fn quadrature(
    missing: Option<&[f64]>,
    first_order: &[f64],
    total: &[f64],
) -> Option<Vec<f64>> {
    let missing = missing?;
    if first_order.len() == 1 {
        // One input has all of the variance, however large.
        return Some(vec![0.0]);
    }
    let whole: f64 = total.iter().zip(missing).map(|(t, m)| t * m).sum();
    let error = |i: usize| {
        let (s, others) = (first_order[i], whole - total[i] * missing[i]);
        at_most_one(s * ((1.0 - s) * missing[i] + others.max(0.0)))
    };
    Some((0..first_order.len()).map(error).collect())
}

/// An index lies in \[0, 1\], so an error above 1 says nothing more; nor does one that overflowed.
pub(crate) fn at_most_one(error: f64) -> f64 {
    if error < 1.0 { error } else { 1.0 }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn total(quadrature: Option<Vec<f64>>, decomposition: Option<Vec<f64>>) -> Option<f64> {
        let parts = ByInput {
            quadrature,
            decomposition,
            ..ByInput::default()
        };
        ErrorParts::new(parts, 0.125).total
    }

    #[test]
    fn the_total_is_the_largest_sum_of_what_is_known() {
        assert_eq!(
            total(Some(vec![0.25, 0.0]), Some(vec![0.0, 0.5])),
            Some(0.625)
        );
        assert_eq!(total(Some(vec![0.25]), None), Some(0.375));
        assert_eq!(total(None, None), None);
        assert_eq!(total(Some(vec![0.75]), Some(vec![0.75])), Some(1.0));
    }

    #[test]
    fn what_overflowed_is_the_largest_error() {
        assert_eq!([f64::NAN, f64::INFINITY, 3.0].map(at_most_one), [1.0; 3]);
    }
}
