//! Misses of a form at the check points, and what they do to its indices: alone, and in the difference of two models.
//!
//! With r = h - form at the check points x_k, g_i the main effect of input i in the form and V its variance, the form's
//! V_i = Var\[g_i\] is short of 2 E\[g_i r\] to first order in r, and V of E\[2 (form - mean) r + r^2\]. Both expectations are
//! means over the check points, so that the error of S_i = V_i/V is a mean over points too, of
//!
//! ```text
//! psi_ik = (2 g_i r - S_i (2 (form - mean) r + r^2)) / V   at x_k
//! dS_i   = |mean_k psi_ik| + T rms_k(psi_ik) / sqrt(K) + R mean_k r^2 / V
//! ```
//!
//! where the second term covers the chance in K points, and the last what is of second order in r. Residuals that no
//! main effect has a share in, as those of pure interactions, cost an index far less than their size.
//!
//! An input whose main effect in the form is nothing beside r, as where its line is flat at the cut, has no share in any residual, yet all of
//! r may be its own effect, of which the cut tells nothing. It may have (sqrt(S_i V) + rms(r))^2 of V, and the claim is all that is more
//! than S_i, with the chance in the mean of r^2.
//!
//! Points that are mirror images of each other were drawn once: chance is in the sums psi over such a pair, and K in T counts pairs. An output
//! that is its own mirror image misses the same at both points, so that an input which is its own image learns nothing new from the second.
//!
//! Two models that were run at check points of the same nodes err alike there: the error of the difference of their indices is
//! a mean of psi_ik - psi'_ik, whose chance is that of the difference, point by point. What is of second order is a quadratic form Q in r, so
//! that Q(r) - Q(r') = Q(r - r', r + r'), of either sign of r':
//!
//! ```text
//! d(S_i - S'_i) = |mean_k (psi_ik - psi'_ik)| + T rms_k(psi_ik - psi'_ik) / sqrt(K)
//!                 + R rms_k(r - r') rms_k(r + r')    with r over the standard deviation
//! ```

use crate::exchange::{exchanged, means};
use crate::judge::index_error::at_most_one;

/// T for many points; K of them have (1 + 4/K) times as much. Student's t has 2.0 and, for five points, 1.4 times as
/// much; the rest is for skew residuals. Set by the coverage over random models.
const CHANCE: f64 = 2.2;
const CHANCE_OF_FEW: f64 = 4.0;
/// R: all of r^2 in one main effect would be 1, as may be where the form was fitted and the main effects with it.
const REMAINDER: f64 = 0.5;
const REMAINDER_OF_FIT: f64 = 1.0;
/// Share of the mean square missed below which a form's main effect is nothing beside it: a tenth of its root.
const HIDDEN: f64 = 0.01;
/// Mean square missed, as a share of the variance, below which nothing is hidden: half of it is claimed of every input.
const NOTHING_MISSED: f64 = 0.02;

/// The error that is claimed of one index of a model, and what its form misses.
#[derive(Debug, Clone, Copy)]
pub struct Claim<'a> {
    /// The error, absolute.
    pub error: f64,
    /// Misses that a part of it comes from, where they are known.
    pub misses: Option<&'a Misses>,
}

/// Error of the difference of two models' indices of this input, absolute. Where both were checked at the same nodes, the part of their errors
/// that comes from the form is taken point by point; other parts, and errors that have nothing in common, are independent.
pub fn error_of_difference(input: usize, a: Claim<'_>, b: Claim<'_>) -> f64 {
    let apart = a.error.hypot(b.error);
    let of_form = |misses: &Misses| misses.errors().get(input).copied();
    let together = a.misses.zip(b.misses).and_then(|(own, other)| {
        let shared = own.errors_of_difference(other)?.get(input).copied()?;
        let left = |error: f64, of_form: f64| (error - of_form).max(0.0);
        Some(shared + left(a.error, of_form(own)?).hypot(left(b.error, of_form(other)?)))
    });
    at_most_one(together.map_or(apart, |together| together.min(apart)))
}

/// Effects of a form: the output and its main effects, in the units of the sections.
pub(crate) struct Effects<'a> {
    pub(crate) first_order: &'a [f64],
    pub(crate) mean: f64,
    pub(crate) variance: f64,
    /// g_i at a check point over the standard deviation of the output
    pub(crate) main: &'a dyn Fn(usize, usize) -> f64,
}

/// Misses of a form at the check points.
#[derive(Debug, Clone, PartialEq)]
pub struct Misses {
    /// Number of the node at each coordinate of each check point, point after point: where the residuals of two models belong together.
    pub nodes: Vec<usize>,
    /// Residual r over the standard deviation, by check point.
    pub residuals: Vec<f64>,
    /// psi_ik at each check point, input after input.
    pub contributions: Vec<f64>,
    /// Probability of the interactions: the axes, where there is no residual, take their share of the means.
    pub weight: f64,
    /// Count of the form's numbers that were fitted to the check points.
    pub fitted: usize,
    /// Number of each check point's mirror image, itself perhaps; empty where the model has no symmetry.
    pub images: Vec<usize>,
}

impl Misses {
    /// Computes the misses from the values at the check points and a form there, of which `fitted` numbers were fitted to them.
    pub(crate) fn new(
        (nodes, images): (Vec<usize>, Vec<usize>),
        (values, predictions): (&[f64], &[f64]),
        effects: &Effects<'_>,
        weight: f64,
        fitted: usize,
    ) -> Self {
        let deviation = effects.variance.sqrt();
        let share = weight / (values.len().saturating_sub(fitted).max(1) as f64);
        let residuals: Vec<f64> = values
            .iter()
            .zip(predictions)
            .map(|(h, form)| (h - form) / deviation)
            .collect();
        let whole: Vec<f64> = residuals
            .iter()
            .zip(predictions)
            .map(|(r, form)| r * (2.0 * (form - effects.mean) / deviation + r))
            .collect();
        // V may turn out larger, never so much smaller that the first order in r says nothing.
        let variance = (1.0 + share * whole.iter().sum::<f64>()).max(0.5);
        let mut contributions = Vec::with_capacity(effects.first_order.len() * values.len());
        for (input, s) in effects.first_order.iter().enumerate() {
            let points = residuals.iter().zip(&whole).enumerate();
            contributions.extend(points.map(|(k, (r, whole))| {
                (2.0 * (effects.main)(input, k) * r - s * whole) / variance
            }));
        }
        Self {
            contributions,
            residuals: residuals.iter().map(|r| r / variance.sqrt()).collect(),
            nodes,
            weight,
            fitted,
            images,
        }
    }

    /// Returns the misses of the output's mirror image; `inputs` are exchanged. A point whose own image is lost takes its place.
    pub(crate) fn mirrored(&self, inputs: &[usize]) -> Self {
        let count = self.residuals.len();
        let image = |k: usize| self.images.get(k).copied().unwrap_or(k);
        let of_points =
            |values: &[f64]| -> Vec<f64> { (0..values.len()).map(|k| values[image(k)]).collect() };
        let by_input: Vec<&[f64]> = self.by_input().collect();
        let contributions = inputs.iter().flat_map(|&input| of_points(by_input[input]));
        let at = |k: usize| &self.nodes[k * inputs.len()..(k + 1) * inputs.len()];
        let nodes = (0..count).flat_map(|k| exchanged(at(image(k)), inputs));
        Self {
            nodes: nodes.collect(),
            residuals: of_points(&self.residuals),
            contributions: contributions.collect(),
            ..self.clone()
        }
    }

    /// The mean with what the same analysis said of the output's mirror image; `None` where they weren't checked at the same points.
    pub(crate) fn mean_with(&self, other: &Self) -> Option<Self> {
        let same = self.nodes == other.nodes && self.fitted == other.fitted;
        same.then(|| Self {
            residuals: means(&self.residuals, &other.residuals),
            contributions: means(&self.contributions, &other.contributions),
            ..self.clone()
        })
    }

    /// Inputs of a form with these first-order indices that are nothing beside what it misses.
    pub(crate) fn hidden(&self, first_order: &[f64]) -> Vec<usize> {
        let missed = self.mean_square();
        let is_hidden = |i: &usize| missed > NOTHING_MISSED && first_order[*i] < HIDDEN * missed;
        (0..first_order.len()).filter(is_hidden).collect()
    }

    /// Error of each of these first-order indices, absolute: [`Misses::errors`], and for hidden inputs all that they may have.
    pub(crate) fn errors_of(&self, first_order: &[f64]) -> Vec<f64> {
        let mut errors = self.errors();
        let squares: Vec<f64> = self.residuals.iter().map(|r| r * r).collect();
        let drawn = self.by_draw(&squares);
        let chance = self.student() * self.chance_weight() * sum_of_squares(&drawn).sqrt();
        let most = self.mean_square() + chance;
        for input in self.hidden(first_order) {
            let gain = most + 2.0 * (first_order[input] * most).sqrt();
            errors[input] = at_most_one(errors[input].max(gain));
        }
        errors
    }

    /// E\[r^2\] over the variance.
    fn mean_square(&self) -> f64 {
        self.share() * sum_of_squares(&self.residuals)
    }

    /// Error of each first-order index, absolute.
    pub fn errors(&self) -> Vec<f64> {
        let square = self.mean_square();
        let error = |psi: &[f64]| {
            let drawn = self.by_draw(psi);
            let sum = self.share() * drawn.iter().sum::<f64>();
            let chance = self.student() * self.chance_weight() * sum_of_squares(&drawn).sqrt();
            at_most_one(sum.abs() + chance + self.remainder() * square)
        };
        self.by_input().map(error).collect()
    }

    /// Error of the difference between each first-order index and another model's, absolute; `None` where the two weren't checked at the
    /// same nodes or have not as many inputs.
    pub(crate) fn errors_of_difference(&self, other: &Self) -> Option<Vec<f64>> {
        let same = self.nodes == other.nodes && self.images == other.images;
        if !same || self.contributions.len() != other.contributions.len() {
            return None;
        }
        let pairs = self.by_input().zip(other.by_input());
        let remainder = self.remainder().max(other.remainder()) * self.remainder_with(other);
        let error = |(psi, others): (&[f64], &[f64])| {
            let [psi, others] = [psi, others].map(|psi| self.by_draw(psi));
            let sums = [(self, &psi), (other, &others)]
                .map(|(misses, psi)| misses.share() * psi.iter().sum::<f64>());
            let apart = psi.iter().zip(&others);
            let (a, b) = (self.chance_weight(), other.chance_weight());
            let chance: f64 = apart.map(|(p, q)| (a * p - b * q).powi(2)).sum();
            at_most_one((sums[0] - sums[1]).abs() + self.student() * chance.sqrt() + remainder)
        };
        Some(pairs.map(error).collect())
    }

    /// rms(r - r') rms(r + r'), which is the same for either sign of r'.
    fn remainder_with(&self, other: &Self) -> f64 {
        let (a, b) = (self.share().sqrt(), other.share().sqrt());
        let pairs = || self.residuals.iter().zip(&other.residuals);
        let apart: f64 = pairs().map(|(r, q)| (a * r - b * q).powi(2)).sum();
        let together: f64 = pairs().map(|(r, q)| (a * r + b * q).powi(2)).sum();
        (apart * together).sqrt()
    }

    fn by_input(&self) -> impl Iterator<Item = &[f64]> {
        self.contributions.chunks_exact(self.residuals.len().max(1))
    }

    /// The sums over points that were drawn together, in an order in which both points of a pair are alike.
    fn by_draw(&self, psi: &[f64]) -> Vec<f64> {
        let of_draw = |(k, psi_k): (usize, &f64)| match self.images.get(k) {
            Some(&image) if image < k => None,
            Some(&image) if image > k => Some(psi_k + psi[image]),
            _ => Some(*psi_k),
        };
        psi.iter().enumerate().filter_map(of_draw).collect()
    }

    /// Counts the draws of points.
    fn draws(&self) -> usize {
        let second = self
            .images
            .iter()
            .enumerate()
            .filter(|(k, image)| *image < k);
        self.residuals.len() - second.count()
    }

    /// Returns the weight of a point in a mean.
    fn share(&self) -> f64 {
        let free = self.residuals.len().saturating_sub(self.fitted).max(1);
        self.weight / free as f64
    }

    /// Returns the weight of a point in a mean's standard deviation.
    fn chance_weight(&self) -> f64 {
        let count = self.residuals.len().max(1) as f64;
        (self.share() / count * self.weight).sqrt()
    }

    fn student(&self) -> f64 {
        CHANCE * (1.0 + CHANCE_OF_FEW / self.draws().max(1) as f64)
    }

    fn remainder(&self) -> f64 {
        if self.fitted > 0 {
            REMAINDER_OF_FIT
        } else {
            REMAINDER
        }
    }
}

fn sum_of_squares(values: &[f64]) -> f64 {
    values.iter().map(|value| value * value).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Makes misses of one input, at two points.
    fn misses(residuals: [f64; 2], contributions: [f64; 2]) -> Misses {
        Misses {
            nodes: vec![0, 1],
            residuals: residuals.to_vec(),
            contributions: contributions.to_vec(),
            weight: 0.5,
            fitted: 0,
            images: Vec::new(),
        }
    }

    #[test]
    fn the_error_is_mean_chance_and_remainder() {
        let error = misses([0.1, -0.1], [0.02, 0.04]).errors()[0];
        let mean = 0.5 * 0.03;
        let chance = 2.2 * 3.0 * 0.5 / 2.0 * (0.0004_f64 + 0.0016).sqrt();
        let remainder = 0.5 * 0.5 * 0.01;
        assert!((error - (mean + chance + remainder)).abs() < 1e-15);
    }

    #[test]
    fn a_main_effect_that_is_nothing_may_be_all_that_is_missed() {
        let missed = misses([0.4, -0.2], [0.0, 0.0]);
        // share 1/4, so that E[r^2] is 0.05: hidden below a hundredth of it
        assert_eq!(missed.hidden(&[4e-4, 6e-4]), [0]);
        assert_eq!(misses([1e-3, 1e-3], [0.0; 2]).hidden(&[0.0]), []);
        let chance = 2.2 * 3.0 * 0.5 / 2.0 * (0.4f64.powi(4) + 0.2f64.powi(4)).sqrt();
        let found = missed.errors_of(&[0.0])[0];
        assert!((found - (0.05 + chance)).abs() < 1e-15, "{found}");
        assert_eq!(missed.errors_of(&[0.5]), missed.errors());
    }

    #[test]
    fn what_two_models_miss_alike_is_no_error_of_their_difference() {
        let own = misses([0.1, -0.1], [0.02, 0.04]);
        assert_eq!(own.errors_of_difference(&own), Some(vec![0.0]));
        // An output that grows where the other one shrinks: residuals of the other sign, the same contributions.
        let mirrored = misses([-0.1, 0.1], [0.02, 0.04]);
        assert_eq!(own.errors_of_difference(&mirrored), Some(vec![0.0]));
        // Beside a model that is its form there is nothing to share.
        let exact = misses([0.0; 2], [0.0; 2]);
        assert_eq!(own.errors_of_difference(&exact), Some(own.errors()));
        assert_eq!(exact.errors_of_difference(&own), Some(own.errors()));
    }

    #[test]
    fn models_checked_elsewhere_have_nothing_in_common() {
        let own = misses([0.1, -0.1], [0.02, 0.04]);
        let mut other = own.clone();
        other.nodes[0] = 2;
        assert_eq!(own.errors_of_difference(&other), None);
        let mut other = own.clone();
        other.contributions.extend([0.0; 2]);
        assert_eq!(own.errors_of_difference(&other), None);
    }
}
