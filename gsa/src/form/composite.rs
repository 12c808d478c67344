//! A form on the sections, and corrections to it: one surrogate behind all methods that use Gauss nodes.
//!
//! ```text
//! y(x) = h0 + (prod_i (1 + t d_i(x_i)) - 1)/t + sum_a c_a psi_a(x),   psi_a = prod_(i,k in a) p_ik(x_i)
//! ```
//!
//! p_ik are the orthonormal polynomials of input i, so that Sobol's decomposition is read off the coefficients (B. Sudret,
//! "Global sensitivity analysis using polynomial chaos expansions", Reliability Engineering and System Safety 93 (2008)
//! 964-979). The form has the coefficients
//!
//! ```text
//! f_a = t^(|a| - 1) prod_(i,k in a) m_ik prod_(i not in a) P_i,   P_i = 1 + t dbar_i
//! ```
//!
//! of which there are too many to list; but their squares sum to closed expressions, and each correction changes the sum by
//! (f_a + c_a)^2 - f_a^2.
//!
//! | symbol | meaning |
//! |---|---|
//! | t | 0: additive; 1/h0: M-DRM; else a shifted product |
//! | m_ik | coefficient of section i on p_ik |
//! | a | set of (input, degree > 0), at most one for each input |

use std::collections::BTreeMap;

use crate::form::mdrm::departure;
use crate::form::section::Sections;
use crate::form::spectrum::tail_with;
use crate::judge::index_error::{self, ByInput};

/// Most inputs whose pairs are listed.
pub(crate) const MOST_FOR_PAIRS: usize = 50;

/// Fewer coordinates can't tell how modes end.
const LEAST: usize = 3;

/// Inputs and degrees, ascending by input.
pub(crate) type MultiIndex = Vec<(usize, usize)>;

/// The surrogate of one output, in the units of its sections.
pub(crate) struct Composite<'a> {
    sections: &'a Sections,
    t: f64,
    /// m_ik
    modes: Vec<Vec<f64>>,
    /// P_i
    means: Vec<f64>,
    corrections: BTreeMap<MultiIndex, f64>,
}

/// Shares of each input's variance that the rules miss.
#[derive(Debug, Clone)]
pub(crate) struct Missing {
    pub(crate) all: Vec<f64>,
    /// part of these that the interactions lack
    pub(crate) of_interactions: Vec<f64>,
}

/// Indices and moments, in the units of the sections.
#[derive(Debug, Clone)]
pub(crate) struct Decomposed {
    pub(crate) mean: f64,
    pub(crate) variance: f64,
    pub(crate) first_order: Vec<f64>,
    pub(crate) total: Vec<f64>,
    pub(crate) second_order: Option<Vec<f64>>,
}

impl Decomposed {
    /// Errors of the first-order indices from what the rules miss, beside those of the form.
    pub(crate) fn errors(
        &self,
        missing: Option<&Missing>,
        decomposition: Option<Vec<f64>>,
    ) -> ByInput {
        let all = missing.map(|missing| &missing.all[..]);
        let of_interactions = missing.map(|missing| &missing.of_interactions[..]);
        ByInput {
            quadrature: index_error::quadrature(all, &self.first_order, &self.total),
            decomposition,
            sampling: None,
            missing: index_error::missing(all, &self.total),
            missing_of_interactions: index_error::missing(of_interactions, &self.total),
        }
    }
}

impl<'a> Composite<'a> {
    pub(crate) fn new(sections: &'a Sections, modes: Vec<Vec<f64>>, t: f64) -> Self {
        Self {
            sections,
            t,
            modes,
            means: sections.shifts.iter().map(|d| 1.0 + t * d).collect(),
            corrections: BTreeMap::new(),
        }
    }

    /// Adds to c_a; an empty index is the mean.
    pub(crate) fn add(&mut self, index: MultiIndex, coefficient: f64) {
        *self.corrections.entry(index).or_insert(0.0) += coefficient;
    }

    /// f_a
    fn of_form(&self, index: &MultiIndex) -> f64 {
        let mode = |&(input, degree): &(usize, usize)| self.modes[input][degree - 1];
        let inside: f64 = index.iter().map(mode).product();
        let outside: f64 = (0..self.means.len())
            .filter(|input| index.iter().all(|(i, _)| i != input))
            .map(|input| self.means[input])
            .product();
        self.t.powi(index.len() as i32 - 1) * inside * outside
    }

    /// Coefficients of the main effect of an input on p_1, p_2, ..
    pub(crate) fn main_effect(&self, input: usize) -> Vec<f64> {
        let coefficient = |k: usize| {
            let index = vec![(input, k)];
            self.of_form(&index) + self.corrections.get(&index).unwrap_or(&0.0)
        };
        (1..=self.modes[input].len()).map(coefficient).collect()
    }

    /// Predicts at a point, given p_1, p_2, .. of each input there.
    pub(crate) fn predict(&self, polynomials: &[Vec<f64>]) -> f64 {
        let section = |(input, p): (usize, &Vec<f64>)| {
            let terms = self.modes[input].iter().zip(p);
            self.sections.shifts[input] + terms.map(|(m, p)| m * p).sum::<f64>()
        };
        let form = departure(self.t, polynomials.iter().enumerate().map(section));
        let term = |(index, c): (&MultiIndex, &f64)| {
            let factors = index.iter().map(|&(input, k)| polynomials[input][k - 1]);
            c * factors.product::<f64>()
        };
        let corrections = self.corrections.iter().map(term);
        self.sections.centre + form + corrections.sum::<f64>()
    }

    /// Returns the shares of each input's variance that the rules miss. The section's part is judged on its line, that of the corrections'
    /// interactions by their own modes, of which `coordinates` points of an input tell one less apart. `beyond`: what is missed off the nodes, over
    /// the part of the standard deviation that the input has.
    pub(crate) fn missing(&self, coordinates: &[usize], beyond: Option<&[f64]>) -> Option<Missing> {
        let of_lines = self.sections.missing.as_ref()?;
        let mut energies: Vec<Vec<f64>> = self.modes.iter().map(|m| vec![0.0; m.len()]).collect();
        let interactions = self.corrections.iter().filter(|(index, _)| index.len() > 1);
        for (index, c) in interactions {
            for &(input, degree) in index {
                energies[input][degree - 1] += c * c;
            }
        }
        let share = |(input, energies): (usize, &Vec<f64>)| {
            // A refined line resolves more than the interactions' points do.
            let resolved = energies.iter().rposition(|e| *e > 0.0).map_or(0, |k| k + 1);
            let resolved = resolved.max(energies.len().min(coordinates[input].max(LEAST) - 1));
            let beyond = beyond.map(|beyond| beyond[input]);
            let of_grid = tail_with(&energies[..resolved], true, beyond)?.missing;
            let main: f64 = self.main_effect(input).iter().map(|c| c * c).sum();
            let rest: f64 = energies.iter().sum();
            let all = main + rest;
            Some(if all > 0.0 {
                let of_line = self.of_line(input, beyond).min(of_lines[input]);
                (main * of_line / all, rest * of_grid / all)
            } else {
                (0.0, 0.0)
            })
        };
        let shares = energies.iter().enumerate().map(share);
        let shares: Vec<(f64, f64)> = shares.collect::<Option<_>>()?;
        Some(Missing {
            all: shares.iter().map(|(main, rest)| main + rest).collect(),
            of_interactions: shares.iter().map(|(_, rest)| *rest).collect(),
        })
    }

    /// Returns what a line's own modes and those beyond say; infinite if these are unknown.
    fn of_line(&self, input: usize, beyond: Option<f64>) -> f64 {
        if beyond.is_none() || !self.sections.lost.is_empty() {
            return f64::INFINITY;
        }
        let energies: Vec<f64> = self.modes[input].iter().map(|m| m * m).collect();
        tail_with(&energies, true, beyond).map_or(f64::INFINITY, |tail| tail.missing)
    }

    /// Decomposes the form; `None` if it overflows or nothing varies.
    pub(crate) fn decompose(&self) -> Option<Decomposed> {
        let n = self.means.len();
        let (t, v) = (self.t, &self.sections.variances);
        let squares: Vec<f64> = self.means.iter().map(|p| p * p).collect();
        let but = |i: usize, factor: &dyn Fn(usize) -> f64| -> f64 {
            (0..n).filter(|k| *k != i).map(factor).product()
        };
        let mut main: Vec<f64> = (0..n).map(|i| v[i] * but(i, &|k| squares[k])).collect();
        let mut total: Vec<f64> = (0..n)
            .map(|i| v[i] * but(i, &|k| squares[k] + t * t * v[k]))
            .collect();
        let mut pairs = (n <= MOST_FOR_PAIRS).then(|| self.pairs_of_form(&squares));
        let mut variance = self.variance_of_form(&squares);
        for (index, c) in self
            .corrections
            .iter()
            .filter(|(index, _)| !index.is_empty())
        {
            let f = self.of_form(index);
            let change = c * (c + 2.0 * f);
            variance += change;
            index.iter().for_each(|(input, _)| total[*input] += change);
            match index[..] {
                [(i, _)] => main[i] += change,
                [(i, _), (j, _)] => {
                    if let Some(pairs) = &mut pairs {
                        pairs[pair(n, i, j)] += change;
                    }
                }
                _ => {}
            }
        }
        let shares = |parts: &[f64]| -> Vec<f64> {
            let share = |v: &f64| (v / variance).clamp(0.0, 1.0);
            parts.iter().map(share).collect()
        };
        let of_form = departure(t, self.sections.shifts.iter().copied());
        let found = Decomposed {
            mean: self.sections.centre + of_form + self.corrections.get(&vec![]).unwrap_or(&0.0),
            first_order: shares(&main),
            total: shares(&total),
            second_order: pairs.map(|pairs| shares(&pairs)),
            variance,
        };
        let all = found.first_order.iter().chain(&found.total);
        let sound = variance > 0.0
            && variance.is_finite()
            && found.mean.is_finite()
            && all.into_iter().all(|s| s.is_finite());
        sound.then_some(found)
    }

    fn variance_of_form(&self, squares: &[f64]) -> f64 {
        let (t, v) = (self.t, &self.sections.variances);
        if t == 0.0 {
            return v.iter().sum();
        }
        // (prod (P^2 + t^2 v) - prod P^2)/t^2, one factor appended after the other so that nothing cancels
        let append = |(whole, means): (f64, f64), (p, v): (&f64, &f64)| {
            (whole * (p + t * t * v) + means * v, means * p)
        };
        let (whole, _) = squares.iter().zip(v).fold((0.0, 1.0), append);
        whole
    }

    fn pairs_of_form(&self, squares: &[f64]) -> Vec<f64> {
        let (n, t, v) = (squares.len(), self.t, &self.sections.variances);
        let mut pairs = Vec::with_capacity(n * n.saturating_sub(1) / 2);
        for i in 0..n {
            for j in i + 1..n {
                let others = (0..n).filter(|k| *k != i && *k != j);
                let means: f64 = others.map(|k| squares[k]).product();
                pairs.push(t * t * v[i] * v[j] * means);
            }
        }
        pairs
    }
}

/// Position of the pair i < j in the order 12, 13, .., 23, ..
pub(crate) fn pair(n: usize, i: usize, j: usize) -> usize {
    i * (2 * n - i - 1) / 2 + j - i - 1
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pairs_are_counted_row_by_row() {
        let mut at = 0;
        for i in 0..7 {
            for j in i + 1..7 {
                assert_eq!(pair(7, i, j), at);
                at += 1;
            }
        }
    }
}
