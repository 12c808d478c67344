//! The expansion of an output, fitted to its values, and the indices that follow from the coefficients.

use crate::form::composite::pair;
use crate::form::regression::{self, Basis, Candidates, Fit};
use crate::form::scale::{exponent, times_power_of_two};
use crate::judge::index_error::{self, ByInput, ErrorParts};
use crate::law::distribution::Distribution;
use crate::law::polynomials::Polynomials;
use crate::law::rule::RuleError;
use crate::method::pce::multi_index::{multi_indices, preference};
use crate::method::scattered::Scattered;

/// Highest degree.
const HIGHEST: usize = 12;
/// Fewer values decide nothing.
const LEAST_POINTS: usize = 8;
/// Standard deviations of the coefficients' scatter that count as its error: two for 95 %, and the rest for the terms' choice.
const SCATTER: f64 = 2.7;
/// Ratio of the scatter by each value's own residual to that by all alike from which the former counts: less is the chance in some hundred values.
const UNLIKE: f64 = 1.5;
/// Share of s^2/V: all of it in one main effect would be 1.
const REMAINDER: f64 = 0.5;
/// Standard deviations of a mean over random points by which Sobol's points seldom miss.
const CONTRADICTION: f64 = 1.5;
/// Rounding of the values beyond this share of their spread is all there is.
const NO_SPREAD: f64 = 0.25;
/// Misfit of rounding size is not to be explained.
const NOISE_IN_EPS: f64 = 16.0;

/// Settings and candidates that all outputs share.
#[derive(Debug, Clone)]
pub(super) struct Chaos {
    inputs: usize,
    /// exponents by candidate: (input, degree)
    indices: Vec<Vec<(usize, usize)>>,
    columns: Vec<Vec<f64>>,
}

impl Chaos {
    /// # Errors
    /// A law without the rule its polynomials are taken from, with its input.
    pub(super) fn new(
        inputs: &[Distribution],
        points: &[Vec<f64>],
    ) -> Result<Self, (usize, RuleError)> {
        Self::within(inputs, points, |_| true)
    }

    /// Makes an expansion of no more terms than a quarter of the points.
    ///
    /// # Errors
    /// As for [`Chaos::new`].
    pub(super) fn small(
        inputs: &[Distribution],
        points: &[Vec<f64>],
    ) -> Result<Self, (usize, RuleError)> {
        Self::within(inputs, points, |terms| 4 * terms <= points.len())
    }

    /// Makes an expansion of the highest degree whose number of terms serves, the first where none does.
    fn within(
        inputs: &[Distribution],
        points: &[Vec<f64>],
        serves: impl Fn(usize) -> bool,
    ) -> Result<Self, (usize, RuleError)> {
        let of_degree = |degree| multi_indices(inputs.len(), degree);
        let fits = |degree: &usize| of_degree(*degree).is_some_and(|terms| serves(terms.len()));
        let degree = (1..=HIGHEST).rev().find(fits).unwrap_or(1);
        let indices = of_degree(degree).unwrap_or_default();
        let of_input = |(input, law): (usize, &Distribution)| {
            let rule = law.gauss_rule(degree + 1).map_err(|error| (input, error))?;
            let polynomials = Polynomials::new(law, &rule);
            let at = |x: &Vec<f64>| polynomials.evaluate(x[input], degree);
            Ok(points.iter().map(at).collect::<Vec<_>>())
        };
        let tables: Vec<Vec<Vec<f64>>> = inputs
            .iter()
            .enumerate()
            .map(of_input)
            .collect::<Result<_, _>>()?;
        let column = |index: &Vec<(usize, usize)>| {
            let at = |k: usize| index.iter().map(|&(i, d)| tables[i][k][d - 1]).product();
            (0..points.len()).map(at).collect()
        };
        Ok(Self {
            inputs: inputs.len(),
            columns: indices.iter().map(column).collect(),
            indices,
        })
    }
}

/// The terms at the points that gave a number.
struct Terms {
    rows: Vec<usize>,
    candidates: Candidates,
}

/// All terms fitted together, for outputs by the thousand: which of them an output needs isn't asked.
pub(super) struct Survey<'c> {
    chaos: &'c Chaos,
    terms: Terms,
    basis: Basis,
}

impl Chaos {
    /// Analyses one output; `None` if it doesn't vary or too few runs gave a number.
    pub(super) fn analyse(&self, values: &[f64]) -> Option<Scattered> {
        let terms = self.terms(|k| values[k].is_finite());
        self.found(&terms, values, |candidates, values| {
            regression::fit(candidates, values, NOISE_IN_EPS * f64::EPSILON, &[])
        })
    }

    /// Prepares for outputs that have a number at the points that `gave_one`.
    pub(super) fn survey(&self, gave_one: impl Fn(usize) -> bool) -> Survey<'_> {
        let terms = self.terms(gave_one);
        Survey {
            basis: Basis::of(&terms.candidates),
            chaos: self,
            terms,
        }
    }

    fn terms(&self, gave_one: impl Fn(usize) -> bool) -> Terms {
        let points = self.columns.first().map_or(0, Vec::len);
        let rows: Vec<usize> = (0..points).filter(|k| gave_one(*k)).collect();
        let preference = self.indices.iter().map(|index| preference(index)).collect();
        let value = |term: usize, k: usize| self.columns[term][rows[k]];
        Terms {
            candidates: Candidates::new(preference, rows.len(), value),
            rows,
        }
    }

    /// Returns what follows from a fit and its residuals, in the output's units.
    fn found(
        &self,
        terms: &Terms,
        values: &[f64],
        fit: impl FnOnce(&Candidates, &[f64]) -> (Fit, Vec<f64>),
    ) -> Option<Scattered> {
        let Terms { rows, candidates } = terms;
        if rows.len() < LEAST_POINTS {
            return None;
        }
        let largest = rows.iter().fold(0.0f64, |max, &k| max.max(values[k].abs()));
        let power = exponent(largest);
        let scaled = |k: &usize| times_power_of_two(values[*k], -power);
        let scaled: Vec<f64> = rows.iter().map(scaled).collect();
        let (fit, unseen) = fit(candidates, &scaled);
        let found = self.indices_of(&fit, candidates, &scaled, &unseen)?;
        Some(Scattered {
            mean: times_power_of_two(found.mean, power),
            variance: times_power_of_two(found.variance, 2 * power),
            lost: (0..values.len()).filter(|k| !rows.contains(k)).collect(),
            ..found
        })
    }

    fn indices_of(
        &self,
        fit: &Fit,
        candidates: &Candidates,
        values: &[f64],
        unseen: &[f64],
    ) -> Option<Scattered> {
        let n = self.inputs;
        let (mut mean, mut variance) = (0.0, 0.0);
        let (mut main, mut total) = (vec![0.0; n], vec![0.0; n]);
        let mut pairs = vec![0.0; n * (n - 1) / 2];
        let mut effects = vec![vec![0.0; values.len()]; n];
        for (candidate, c) in &fit.terms {
            let index = &self.indices[*candidate];
            match index[..] {
                [] => mean = *c,
                [(i, _)] => {
                    main[i] += c * c;
                    for (k, effect) in effects[i].iter_mut().enumerate() {
                        *effect += candidates.combined(&[(*candidate, *c)], k);
                    }
                }
                [(i, _), (j, _)] => pairs[pair(n, i, j)] += c * c,
                _ => {}
            }
            if !index.is_empty() {
                variance += c * c;
                index.iter().for_each(|(input, _)| total[*input] += c * c);
            }
        }
        let floor = f64::EPSILON * (1.0 / variance.sqrt() + (n + 4) as f64);
        if floor.is_nan() || floor > NO_SPREAD {
            return None;
        }
        let shares =
            |parts: &[f64]| -> Vec<f64> { parts.iter().map(|v| (v / variance).min(1.0)).collect() };
        let first_order = shares(&main);
        let missed = unseen.iter().map(|r| r * r).sum::<f64>() / unseen.len() as f64;
        let squares: Vec<f64> = values.iter().map(|h| (h - mean).powi(2)).collect();
        let error = |input: usize| {
            let s = first_order[input];
            let gradient = self.gradient(fit, variance, (input, s));
            let scatter = SCATTER * scatter(fit, &gradient, candidates, unseen);
            let contradiction = contradiction(&effects[input], s, &squares);
            index_error::at_most_one(scatter + REMAINDER * missed / variance + contradiction)
        };
        let errors = ByInput {
            decomposition: Some((0..n).map(error).collect()),
            ..ByInput::default()
        };
        Some(Scattered {
            mean,
            variance,
            total: shares(&total),
            second_order: Some(shares(&pairs)),
            error: ErrorParts::new(errors, floor),
            lost: Vec::new(),
            first_order,
        })
    }
}

impl Survey<'_> {
    /// Analyses one output; `None` if it doesn't vary or too few runs gave a number.
    pub(super) fn analyse(&self, values: &[f64]) -> Option<Scattered> {
        let fit = |_: &Candidates, values: &[f64]| self.basis.fit(values);
        self.chaos.found(&self.terms, values, fit)
    }
}

impl Chaos {
    /// Gradient of a first-order index s to the coefficients.
    fn gradient(&self, fit: &Fit, variance: f64, (input, s): (usize, f64)) -> Vec<f64> {
        let slope = |(candidate, c): &(usize, f64)| {
            let own = match self.indices[*candidate][..] {
                [] => return 0.0,
                [(i, _)] if i == input => 1.0,
                _ => 0.0,
            };
            2.0 * c * (own - s) / variance
        };
        fit.terms.iter().map(slope).collect()
    }
}

/// Standard deviation of a number with this gradient to the coefficients, for values that scatter by the residuals' root mean square each, or by their
/// own residual where that makes much more: a singular end has its residuals where the columns are largest.
fn scatter(fit: &Fit, gradient: &[f64], candidates: &Candidates, unseen: &[f64]) -> f64 {
    let squares: f64 = unseen.iter().map(|r| r * r).sum();
    let alike = (squares / unseen.len() as f64).sqrt() * fit.deviation(gradient);
    let weights = fit.weights(gradient);
    let by_value = unseen.iter().enumerate();
    let by_value = by_value.map(|(k, r)| (candidates.combined(&weights, k) * r).powi(2));
    let own = by_value.sum::<f64>().sqrt();
    if own > UNLIKE * alike { own } else { alike }
}

/// Returns by how much the points contradict an index s: its difference from the ratio of mean squares of the main effect and of the output at the
/// points, zero where that is within chance.
fn contradiction(effect: &[f64], s: f64, squares: &[f64]) -> f64 {
    let count = squares.len() as f64;
    let excess: Vec<f64> = effect
        .iter()
        .zip(squares)
        .map(|(g, y)| g * g - s * y)
        .collect();
    let mean = excess.iter().sum::<f64>() / count;
    let scatter = excess.iter().map(|e| (e - mean).powi(2)).sum::<f64>() / count;
    if mean.abs() > CONTRADICTION * (scatter / count).sqrt() {
        mean.abs() / (squares.iter().sum::<f64>() / count)
    } else {
        0.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_that_contradict_an_index_are_an_error() {
        let squares: Vec<f64> = (0..64).map(|k| 1.0 + f64::from(k % 4)).collect();
        // a main effect with half of the output's variance at every point
        let effect: Vec<f64> = squares.iter().map(|y| (0.5 * y).sqrt()).collect();
        assert!(contradiction(&effect, 0.5, &squares) < 1e-15);
        assert!((contradiction(&effect, 0.9, &squares) - 0.4).abs() < 1e-15);
        // within chance: 1 +- 4 of standard deviation have a mean of 0.5 in 64 points
        let noise = |k: u32| 0.5 + 4.0 * if k.is_multiple_of(2) { 1.0 } else { -1.0 };
        let effect: Vec<f64> = (0..64).map(|k| (5.0f64 + noise(k)).sqrt()).collect();
        assert_eq!(contradiction(&effect, 5.0, &[1.0; 64]), 0.0);
        assert!((contradiction(&effect, 4.0, &[1.0; 64]) - 1.5).abs() < 1e-14);
    }
}
