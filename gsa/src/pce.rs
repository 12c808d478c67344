//! Sparse polynomial chaos: the output as a few products of the laws' own orthonormal polynomials.
//!
//! ```text
//! y(x) = sum_a c_a prod_(i,k in a) p_ik(x_i),   V_i = sum_{a = {(i,k)}} c_a^2,   V_Ti = sum_{a contains i} c_a^2
//! ```
//!
//! B. Sudret, Reliability Engineering and System Safety 93 (2008) 964-979; the sparse choice by orthogonal least squares with
//! leave-one-out residuals (`regression`), among multi-indices with (sum_i k_i^q)^(1/q) <= p, q = 3/4 (G. Blatman, B. Sudret,
//! Journal of Computational Physics 230 (2011) 2345-2367). Points: scrambled Sobol points carried to the laws by their inverse
//! distribution functions. The error is judged as that of the forms, on cross-validated residuals, and by how far residuals of
//! that size scatter the coefficients, whichever is larger: laws with heavy tails put few points where high degrees are decided.
//!
//! Limits: kinks and steps converge slowly. A failed run is left out.

use crate::distribution::Distribution;
use crate::error::{self, ByInput, Effects, ErrorParts};
use crate::polynomials::Polynomials;
use crate::regression::{self, Candidates, Fit};
use crate::rule::RuleError;
use crate::scale::{exponent, times_power_of_two};
use crate::sobol::Sobol;

/// q of the hyperbolic norm.
const NORM: f64 = 0.75;
/// Highest degree.
const HIGHEST: usize = 12;
/// Most multi-indices.
const MOST_CANDIDATES: usize = 1500;
/// Fewer values decide nothing.
const LEAST_POINTS: usize = 8;
/// A degree more is preferred this much less.
const PREFERENCE: f64 = 0.95;
/// Standard deviations of the coefficients' scatter that count as its error.
const SCATTER: f64 = 2.2;
/// Rounding of the values beyond this share of their spread is all there is.
const NO_SPREAD: f64 = 0.25;
/// Misfit of rounding size is not to be explained.
const NOISE_IN_EPS: f64 = 16.0;

/// The cut point and `samples` points.
pub(crate) fn points(inputs: &[Distribution], samples: usize, seed: u64) -> Vec<Vec<f64>> {
    let sobol = Sobol::new(inputs.len());
    let place = |u: Vec<f64>| {
        inputs
            .iter()
            .zip(u)
            .map(|(law, u)| law.inverse_cdf(u))
            .collect()
    };
    let mut points = vec![inputs.iter().map(Distribution::mean).collect()];
    points.extend((0..samples).map(|k| place(sobol.point(k as u32, seed))));
    points
}

/// What all outputs share.
#[derive(Debug, Clone)]
pub(crate) struct Chaos {
    inputs: usize,
    /// exponents by candidate: (input, degree)
    indices: Vec<Vec<(usize, usize)>>,
    columns: Vec<Vec<f64>>,
}

impl Chaos {
    /// # Errors
    /// A law without the rule its polynomials are taken from, with its input.
    pub(crate) fn new(
        inputs: &[Distribution],
        points: &[Vec<f64>],
    ) -> Result<Self, (usize, RuleError)> {
        let degree = (1..=HIGHEST)
            .rev()
            .find(|&degree| multi_indices(inputs.len(), degree).is_some());
        let degree = degree.unwrap_or(1);
        let indices = multi_indices(inputs.len(), degree).unwrap_or_default();
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

/// Indices of one output.
pub(crate) struct Expanded {
    pub(crate) mean: f64,
    pub(crate) variance: f64,
    pub(crate) first_order: Vec<f64>,
    pub(crate) total: Vec<f64>,
    pub(crate) second_order: Vec<f64>,
    pub(crate) error: ErrorParts,
    pub(crate) lost: Vec<usize>,
}

impl Chaos {
    /// Analyses one output; `None` if it doesn't vary or too few runs gave a number.
    pub(crate) fn analyse(&self, values: &[f64]) -> Option<Expanded> {
        let rows: Vec<usize> = (0..values.len())
            .filter(|&k| values[k].is_finite())
            .collect();
        if rows.len() < LEAST_POINTS {
            return None;
        }
        let largest = rows.iter().fold(0.0f64, |max, &k| max.max(values[k].abs()));
        let power = exponent(largest);
        let values: Vec<f64> = rows
            .iter()
            .map(|&k| times_power_of_two(values[k], -power))
            .collect();
        let candidates = Candidates {
            columns: self
                .columns
                .iter()
                .map(|column| rows.iter().map(|&k| column[k]).collect())
                .collect(),
            preference: self.indices.iter().map(|index| preference(index)).collect(),
        };
        let all: Vec<usize> = (0..rows.len()).collect();
        let noise = NOISE_IN_EPS * f64::EPSILON;
        let fit = regression::fit(&candidates, &values, &all, noise);
        let unseen = regression::cross_validate(&candidates, &values, noise);
        self.indices_of(&fit, &candidates, &values, &unseen)
            .map(|mut found| {
                found.mean = times_power_of_two(found.mean, power);
                found.variance = times_power_of_two(found.variance, 2 * power);
                let total = self.columns.first().map_or(0, Vec::len);
                found.lost = (0..total).filter(|k| !rows.contains(k)).collect();
                found
            })
    }

    fn indices_of(
        &self,
        fit: &Fit,
        candidates: &Candidates,
        values: &[f64],
        unseen: &[f64],
    ) -> Option<Expanded> {
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
                    let column = &candidates.columns[*candidate];
                    effects[i]
                        .iter_mut()
                        .zip(column)
                        .for_each(|(g, p)| *g += c * p);
                }
                [(i, _), (j, _)] => pairs[crate::composite::pair(n, i, j)] += c * c,
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
        let deviation = variance.sqrt();
        let predictions: Vec<f64> = values.iter().zip(unseen).map(|(h, r)| h - r).collect();
        let effects = Effects {
            first_order: &first_order,
            mean,
            variance,
            main: &|input, k| effects[input][k] / deviation,
        };
        let by_points = error::decomposition(values, &predictions, &effects, 1.0, fit.terms.len());
        let by_fit = self.scatter(fit, variance, &first_order, unseen);
        let larger = by_points.iter().zip(by_fit).map(|(a, b)| a.max(b));
        let errors = ByInput {
            decomposition: Some(larger.collect()),
            ..ByInput::default()
        };
        Some(Expanded {
            mean,
            variance,
            total: shares(&total),
            second_order: shares(&pairs),
            error: ErrorParts::new(errors, floor),
            lost: Vec::new(),
            first_order,
        })
    }
}

impl Chaos {
    /// Error of each first-order index by what the coefficients scatter if each value does by as much as the fit misses of it
    /// unseen. Where points are few beyond some distance, as under heavy tails, terms of high degree are hardly held.
    fn scatter(&self, fit: &Fit, variance: f64, first_order: &[f64], unseen: &[f64]) -> Vec<f64> {
        let missed = unseen.iter().map(|r| r * r).sum::<f64>() / unseen.len() as f64;
        let error = |input: usize| {
            let slope = |(candidate, c): &(usize, f64)| {
                let own = match self.indices[*candidate][..] {
                    [] => return 0.0,
                    [(i, _)] if i == input => 1.0,
                    _ => 0.0,
                };
                2.0 * c * (own - first_order[input]) / variance
            };
            let gradient: Vec<f64> = fit.terms.iter().map(slope).collect();
            error::at_most_one(SCATTER * missed.sqrt() * fit.deviation(&gradient))
        };
        (0..self.inputs).map(error).collect()
    }
}

/// The constant is never to be missed; of equal columns the simpler one goes first.
fn preference(index: &[(usize, usize)]) -> f64 {
    const FIRST: f64 = 1e6;
    match index.iter().map(|(_, degree)| *degree as i32).sum() {
        0 => FIRST,
        degree => PREFERENCE.powi(degree),
    }
}

/// All multi-indices within the hyperbola, the constant first; `None` if too many.
fn multi_indices(inputs: usize, highest: usize) -> Option<Vec<Vec<(usize, usize)>>> {
    let budget = (highest as f64).powf(NORM) * (1.0 + 1e-12);
    let mut found = vec![Vec::new()];
    let mut from = 0;
    // Each round appends one input behind those that an index has.
    while from < found.len() {
        let round = from..found.len();
        from = found.len();
        for at in round {
            let base: Vec<(usize, usize)> = found[at].clone();
            let spent: f64 = base.iter().map(|(_, k)| (*k as f64).powf(NORM)).sum();
            let next = base.last().map_or(0, |(input, _)| input + 1);
            for input in next..inputs {
                let within = |k: &usize| spent + (*k as f64).powf(NORM) <= budget;
                for k in (1..=highest).take_while(within) {
                    let mut index = base.clone();
                    index.push((input, k));
                    found.push(index);
                }
            }
            if found.len() > MOST_CANDIDATES {
                return None;
            }
        }
    }
    Some(found)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn hyperbolic_sets_hold_every_index_once() {
        // q-norm 3/4 <= 3: 1..3 alone; of pairs (1,1): 2^(4/3) = 2.5; (1,2) is 3.46
        let found = multi_indices(2, 3).unwrap();
        assert_eq!(found.len(), 1 + 6 + 1);
        let mut sorted = multi_indices(4, 6).unwrap();
        let count = sorted.len();
        sorted.sort();
        sorted.dedup();
        assert_eq!(sorted.len(), count);
        assert!(multi_indices(200, 3).is_none());
    }

    #[test]
    fn a_sparse_polynomial_is_found_exactly() {
        let inputs = [
            Distribution::uniform(-1.0, 1.0).unwrap(),
            Distribution::normal(1.0, 2.0).unwrap(),
            Distribution::lognormal(0.0, 0.5).unwrap(),
        ];
        let points = points(&inputs, 60, 1);
        let chaos = Chaos::new(&inputs, &points).unwrap();
        // x1, z2 = (x2 - 1)/2 and ln x3 are standard: 3 + x1 + z2^2 + x1 ln x3 has parts 1/3, 2 and 1/12
        let model = |x: &Vec<f64>| 3.0 + x[0] + ((x[1] - 1.0) / 2.0).powi(2) + x[0] * x[2].ln();
        let values: Vec<f64> = points.iter().map(model).collect();
        let found = chaos.analyse(&values).unwrap();
        let variance = 1.0 / 3.0 + 2.0 + 1.0 / 12.0;
        assert!((found.mean - 4.0).abs() < 1e-12 && (found.variance - variance).abs() < 1e-11);
        for (s, part) in found.first_order.iter().zip([1.0 / 3.0, 2.0, 0.0]) {
            assert!((s - part / variance).abs() < 1e-12);
        }
        assert!((found.second_order[1] - 1.0 / 12.0 / variance).abs() < 1e-12);
        assert!(found.error.total.unwrap() < 1e-11);
    }
}
