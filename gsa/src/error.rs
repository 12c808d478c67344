//! How far an index may be from the truth: the parts of the error that the runs themselves reveal.
//!
//! Every part is an absolute error of a first-order index, the largest over the inputs, and at most 1, as an index is.
//!
//! | part | what it sees | what it is blind to |
//! |---|---|---|
//! | quadrature | sections too rough for the rule (kinks) | interactions |
//! | decomposition | interactions the form has no place for | quadrature |
//! | floor | the model's rounding | everything else |
//!
//! The sum is an estimate, not a bound: few check points may all miss an interaction. Indicators that cost nothing
//! (1 - sum S_i, the difference between two forms) were found to carry no information and are not used.

use crate::evidence::Evidence;
use crate::section::Sections;

/// Parts of the error of an output's first-order indices.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ErrorParts {
    /// Change of the indices when the highest modes the rule resolves are taken out; `None` for rules of one or two
    /// nodes, which cannot tell.
    pub quadrature: Option<f64>,
    /// Misfit of the chosen form at the check points, over the output's standard deviation; `None` without them.
    pub decomposition: Option<f64>,
    /// What rounding leaves: eps max|h| over the standard deviation.
    pub floor: f64,
    /// Sum of the parts that are known, and `None` if none but the floor is. Where one is `None` the total leaves it
    /// out, and says less than it seems to.
    pub total: Option<f64>,
}

impl ErrorParts {
    pub(crate) fn new(quadrature: Option<f64>, decomposition: Option<f64>, floor: f64) -> Self {
        let known = quadrature.is_some() || decomposition.is_some();
        let sum = quadrature.unwrap_or(0.0) + decomposition.unwrap_or(0.0) + floor;
        Self {
            quadrature,
            decomposition,
            floor,
            total: known.then(|| at_most_one(sum)),
        }
    }

    /// Of an output that has no indices.
    pub(crate) fn without_indices(floor: f64) -> Self {
        Self::new(None, None, floor)
    }
}

/// Change of the indices when each section in turn loses the modes at its unreliable end, summed over the sections so
/// that losses which cancel in a ratio of variances still count. `first_order` maps variances to indices.
pub(crate) fn quadrature(
    sections: &Sections,
    first_order: impl Fn(&[f64]) -> Vec<f64>,
) -> Option<f64> {
    let tails = sections.tails.as_ref()?;
    if sections.inputs() == 1 {
        // One input has all of the variance, however large.
        return Some(0.0);
    }
    let full = first_order(&sections.variances);
    let mut change = vec![0.0; full.len()];
    let mut variances = sections.variances.clone();
    for (input, tail) in tails.iter().enumerate().filter(|(_, tail)| **tail > 0.0) {
        variances[input] -= tail;
        for (change, (less, full)) in change
            .iter_mut()
            .zip(first_order(&variances).iter().zip(&full))
        {
            *change += (less - full).abs();
        }
        variances[input] = sections.variances[input];
    }
    Some(at_most_one(change.into_iter().fold(0.0, f64::max)))
}

/// sqrt(E), E = mean squared misfit over the smaller of the two forms' variances.
pub(crate) fn decomposition(
    sections: &Sections,
    evidence: Option<&Evidence>,
    misfit: impl Fn(&Evidence) -> f64,
    product_variance: Option<f64>,
) -> Option<f64> {
    if sections.inputs() == 1 {
        // A single section is the output itself.
        return Some(0.0);
    }
    let additive = sections.spread();
    let scale = product_variance.map_or(additive, |variance| variance.sqrt().min(additive));
    evidence.map(|evidence| at_most_one(misfit(evidence) / scale))
}

/// An index lies in \[0, 1\], so an error above 1 says nothing more; nor does one that overflowed.
fn at_most_one(error: f64) -> f64 {
    if error < 1.0 { error } else { 1.0 }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_total_is_the_sum_of_what_is_known() {
        assert_eq!(
            ErrorParts::new(Some(0.25), Some(0.5), 0.125).total,
            Some(0.875)
        );
        assert_eq!(ErrorParts::new(Some(0.25), None, 0.0).total, Some(0.25));
        assert_eq!(ErrorParts::new(None, None, 0.1).total, None);
        assert_eq!(
            ErrorParts::new(Some(0.75), Some(0.75), 0.0).total,
            Some(1.0)
        );
    }

    #[test]
    fn what_overflowed_is_the_largest_error() {
        assert_eq!([f64::NAN, f64::INFINITY, 3.0].map(at_most_one), [1.0; 3]);
    }
}
