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

/// Share of an energy that is rounding.
const ROUNDING: f64 = 1e-24;

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
    /// part of these that effects beside the section's shape lack
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

/// Runs that a composite was made from, beside the lines.
#[derive(Debug, Clone)]
pub(crate) enum Known {
    /// Runs at all nodes, of all inputs or of pairs.
    Nodes,
    /// Runs at check points, which have so many coordinates by input.
    Coordinates(Vec<usize>),
}

/// Energies of an input's effects, each with the share of it that is missed.
struct Missed {
    /// Part with the shape of the section.
    line: (f64, f64),
    /// Part of the main effect beside that.
    effect: (f64, f64),
    /// Interactions, or all that check points show beside the section's shape.
    rest: (f64, f64),
}

impl Missed {
    /// Shares of the whole energy that are missed: of what the lines or the grid show of the main effect, and of the rest.
    fn shares(&self) -> (f64, f64) {
        let parts = [self.line, self.effect, self.rest];
        let all: f64 = parts.iter().map(|(energy, _)| energy).sum();
        let [line, effect, rest] = parts.map(|(energy, missed)| match energy > 0.0 {
            true => energy * missed / all,
            false => 0.0,
        });
        (line + effect, rest)
    }
}

/// Energies of an input's effects: with the shape of its section, and beside it by degree.
struct Shape {
    along: f64,
    across: Vec<f64>,
}

impl Shape {
    /// Splits coefficients by a direction of unit length, or of none.
    fn of(coefficients: &[f64], direction: &[f64]) -> Self {
        let pairs = || coefficients.iter().zip(direction);
        let size: f64 = pairs().map(|(c, d)| c * d).sum();
        let whole: f64 = coefficients.iter().map(|c| c * c).sum();
        let left = |(c, d): (&f64, &f64)| {
            let energy = (c - size * d).powi(2);
            if energy > ROUNDING * whole {
                energy
            } else {
                0.0
            }
        };
        Self {
            along: size * size,
            across: pairs().map(left).collect(),
        }
    }

    /// Energy of a main effect beside the section's shape, and the share of it that is missed. A rule is wrong by products of low and high modes.
    /// Where the high ones don't have the section's shape, what is beside it counts with all of the effect's low modes, not with its own alone.
    fn beside(&self, effect: &[f64], of_line: f64, beyond: Option<f64>) -> Option<(f64, f64)> {
        let squares: Vec<f64> = effect.iter().map(|c| c * c).collect();
        let whole = tail_with(&squares, true, beyond)?;
        let energies: [f64; 2] = [&squares, &self.across].map(|squares| squares.iter().sum());
        let [all, beside] = energies;
        if beside <= 0.0 {
            return Some((0.0, 0.0));
        }
        let end = tail_with(&self.across, true, None)?.amplitude * beside.sqrt();
        let part = (end / (whole.amplitude * all.sqrt())).min(1.0);
        let more = (all * whole.missing * part - self.along * of_line) / beside;
        Some((beside, whole.missing.max(more)))
    }

    fn add(&mut self, other: Self) {
        self.along += other.along;
        for (energy, more) in self.across.iter_mut().zip(other.across) {
            *energy += more;
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

    /// Returns the shares of each input's variance that the rules miss. `beyond`: what is missed off the nodes, over the part of the standard
    /// deviation that the input has.
    pub(crate) fn missing(&self, known: &Known, beyond: Option<&[f64]>) -> Option<Missing> {
        let of_lines = self.sections.missing.as_ref()?;
        let interactions = self.interactions();
        let of_input = |input: usize| {
            let beyond = beyond.map(|beyond| beyond[input]);
            let of_line = self.of_line(input, beyond).min(of_lines[input]);
            let own = interactions.iter().filter(|((i, _), _)| *i == input);
            let own: Vec<&Vec<f64>> = own.map(|(_, c)| c).collect();
            let missed = match known {
                Known::Nodes => self.missed_of_grid(input, &own, of_line, beyond),
                Known::Coordinates(counts) => {
                    self.missed_of_points(input, &own, of_line, (counts[input], beyond))
                }
            };
            missed.map(|missed| missed.shares())
        };
        let shares = (0..self.modes.len()).map(of_input);
        let shares: Vec<(f64, f64)> = shares.collect::<Option<_>>()?;
        Some(Missing {
            all: shares.iter().map(|(line, rest)| line + rest).collect(),
            of_interactions: shares.iter().map(|(_, rest)| *rest).collect(),
        })
    }

    /// Judges what has the section's shape by its line, the rest of the main effect by the whole effect's modes, and interactions by theirs.
    fn missed_of_grid(
        &self,
        input: usize,
        interactions: &[&Vec<f64>],
        of_line: f64,
        beyond: Option<f64>,
    ) -> Option<Missed> {
        let effect = self.main_effect(input);
        let main = Shape::of(&effect, &self.direction(input));
        let mut energies = vec![0.0; effect.len()];
        for coefficients in interactions {
            add_squares(&mut energies, coefficients);
        }
        Some(Missed {
            line: (main.along, of_line),
            effect: main.beside(&effect, of_line, beyond)?,
            rest: (
                energies.iter().sum(),
                tail_with(&energies, true, beyond)?.missing,
            ),
        })
    }

    /// Judges what has the section's shape by its line, and the rest by its own modes, of which so many coordinates of an input tell one less
    /// apart: where a line is flat at the cut, little of what check points show beside it has its shape.
    fn missed_of_points(
        &self,
        input: usize,
        interactions: &[&Vec<f64>],
        of_line: f64,
        (coordinates, beyond): (usize, Option<f64>),
    ) -> Option<Missed> {
        let direction = self.direction(input);
        let mut shape = Shape::of(&self.main_effect(input), &direction);
        for coefficients in interactions {
            shape.add(Shape::of(coefficients, &direction));
        }
        let Shape { along, across } = shape;
        // A refined line resolves more than the check points do.
        let resolved = across.iter().rposition(|e| *e > 0.0).map_or(0, |k| k + 1);
        let resolved = resolved.max(across.len().min(coordinates.max(LEAST) - 1));
        let of_points = tail_with(&across[..resolved], true, beyond)?.missing;
        Some(Missed {
            line: (along, of_line),
            effect: (0.0, 0.0),
            rest: (across.iter().sum(), of_points),
        })
    }

    /// Coefficients of the corrections' interactions by degree of each input, given the factors of the others.
    fn interactions(&self) -> BTreeMap<(usize, MultiIndex), Vec<f64>> {
        let mut found: BTreeMap<(usize, MultiIndex), Vec<f64>> = BTreeMap::new();
        let several = self.corrections.iter().filter(|(index, _)| index.len() > 1);
        for (index, c) in several {
            for &(input, degree) in index {
                let others = index.iter().filter(|(i, _)| *i != input).copied();
                found
                    .entry((input, others.collect()))
                    .or_insert_with(|| vec![0.0; self.modes[input].len()])[degree - 1] = *c;
            }
        }
        found
    }

    /// Modes of a section over its standard deviation; zeros where it is rounding.
    fn direction(&self, input: usize) -> Vec<f64> {
        let size = self.modes[input].iter().map(|m| m * m).sum::<f64>().sqrt();
        let is_noise = self.sections.variances[input].sqrt() <= self.sections.noise();
        let over = |m: &f64| if is_noise { 0.0 } else { m / size };
        self.modes[input].iter().map(over).collect()
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

fn add_squares(energies: &mut [f64], coefficients: &[f64]) {
    for (energy, c) in energies.iter_mut().zip(coefficients) {
        *energy += c * c;
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
    fn high_modes_beside_the_sections_shape_count_with_all_low_ones() {
        // a line of first degree, and a main effect whose high modes are all beside it
        let effect = [1.0, 0.0, 0.0, 0.0, 0.0, 0.1];
        let main = Shape::of(&effect, &[1.0, 0.0, 0.0, 0.0, 0.0, 0.0]);
        let squares = effect.map(|c| c * c);
        let whole = tail_with(&squares, true, None).unwrap().missing;
        let (energy, missed) = main.beside(&effect, 0.0, None).unwrap();
        assert!((energy - 0.01).abs() < 1e-15);
        assert!((energy * missed - 1.01 * whole).abs() < 1e-12);
        // nothing beside it: the line judges all
        let shape = [0.8, 0.6];
        let main = Shape::of(&[1.6, 1.2], &shape);
        assert_eq!(main.beside(&[1.6, 1.2], 0.0, None), Some((0.0, 0.0)));
    }

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
