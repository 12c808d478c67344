//! Gauss rules of a probability law: nodes x_j and probabilities w_j with E\[f(X)\] ~ sum_j w_j f(x_j).
//!
//! Exact for polynomials of degree 2N - 1 in the rule's own coordinate: ln x for lognormal inputs, x for all others. The weights are the Christoffel numbers w_j = 1 / sum_{k<N} p_k(t_j)^2, which keep full
//! relative accuracy where the squared eigenvector component does not (weights of 1e-48 at N = 64).

use thiserror::Error;

use crate::law::basis::Basis;

/// Largest rule built: beyond it the outer Hermite nodes sit 15 standard deviations out and add nothing.
pub const MAX_NODES: usize = 64;

/// Reason why a rule cannot be built.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum RuleError {
    /// The size is outside 1..=[`MAX_NODES`].
    #[error("a Gauss rule has 1 to {MAX_NODES} nodes, not {nodes}")]
    Size {
        /// nodes asked for
        nodes: usize,
    },
    /// A node leaves the range of double precision: the law is too wide for this many nodes.
    #[error(
        "node {index} of {nodes} is beyond the range of double precision: use fewer nodes or a narrower law"
    )]
    OutOfRange {
        /// position of the node, counted from 0
        index: usize,
        /// nodes asked for
        nodes: usize,
    },
    /// Two nodes round to the same number: the law is too narrow for its distance from zero.
    #[error("nodes {index} and {} of {nodes} round to the same number: the law is too narrow for its mean", index + 1)]
    Coincident {
        /// position of the lower of the two, counted from 0
        index: usize,
        /// nodes asked for
        nodes: usize,
    },
    /// A weight falls below the range of double precision: the tail is too heavy for this many nodes.
    #[error(
        "the weight of node {index} of {nodes} is below the range of double precision: use fewer nodes"
    )]
    Vanishing {
        /// position of the node, counted from 0
        index: usize,
        /// nodes asked for
        nodes: usize,
    },
    /// The polynomials or their zeros cannot be resolved: the law is too heavy in a tail or too uneven.
    #[error(
        "the {nodes}-point rule of this law does not converge: use fewer nodes or cut the law's tails"
    )]
    NotConverged {
        /// nodes asked for
        nodes: usize,
    },
}

/// Nodes in ascending order, in the units of the input, and their probabilities.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct GaussRule {
    /// x_1 < .. < x_N
    pub nodes: Vec<f64>,
    /// w_j > 0, sum 1
    pub weights: Vec<f64>,
    /// Row k - 1 holds w_j p_k(t_j), k = 1 .. N-1: a section's k-th coefficient is the row times its values.
    modes: Vec<f64>,
}

impl GaussRule {
    /// The rule of the law with this basis, `None` if it has none; `place` carries the law's coordinate to the input's.
    pub(crate) fn new(
        nodes: usize,
        basis: impl Fn(usize) -> Option<Basis>,
        place: impl Fn(f64) -> f64,
    ) -> Result<Self, RuleError> {
        if !(1..=MAX_NODES).contains(&nodes) {
            return Err(RuleError::Size { nodes });
        }
        let basis = basis(nodes).ok_or(RuleError::NotConverged { nodes })?;
        let t = basis.zeros().ok_or(RuleError::NotConverged { nodes })?;
        let x: Vec<f64> = t.iter().map(|&t| place(basis.place(t))).collect();
        check(&x)?;
        let p: Vec<Vec<f64>> = t.iter().map(|&t| basis.orthonormal(t)).collect();
        let weights = christoffel(&p);
        if let Some(index) = weights.iter().position(|w| !w.is_normal()) {
            return Err(RuleError::Vanishing { index, nodes });
        }
        let modes = (1..nodes)
            .flat_map(|k| p.iter().zip(&weights).map(move |(p, w)| w * p[k]))
            .collect();
        Ok(Self {
            nodes: x,
            weights,
            modes,
        })
    }

    /// N.
    pub fn len(&self) -> usize {
        self.nodes.len()
    }

    /// Never: a rule has at least one node.
    pub fn is_empty(&self) -> bool {
        self.nodes.is_empty()
    }

    /// Coefficient c_k = E\[f p_k\] of a function given at the nodes, 1 <= k < N. By the rule's discrete
    /// orthogonality the variance it sees is sum_k c_k^2.
    pub(crate) fn coefficient(&self, k: usize, values: &[f64]) -> f64 {
        let row = &self.modes[(k - 1) * self.len()..k * self.len()];
        row.iter().zip(values).map(|(m, f)| m * f).sum()
    }
}

/// w_j = 1 / sum_k p_k(t_j)^2, scaled so that they sum to one after rounding too.
fn christoffel(p: &[Vec<f64>]) -> Vec<f64> {
    let mut weights: Vec<f64> = p
        .iter()
        .map(|p| 1.0 / p.iter().map(|p| p * p).sum::<f64>())
        .collect();
    let sum: f64 = weights.iter().sum();
    weights.iter_mut().for_each(|w| *w /= sum);
    weights
}

fn check(x: &[f64]) -> Result<(), RuleError> {
    let nodes = x.len();
    if let Some(index) = x.iter().position(|x| !x.is_finite()) {
        return Err(RuleError::OutOfRange { index, nodes });
    }
    match x.windows(2).position(|pair| pair[0] >= pair[1]) {
        Some(index) => Err(RuleError::Coincident { index, nodes }),
        None => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::law::recurrence::Recurrence;

    fn hermite_basis(n: usize) -> Option<Basis> {
        Some(Basis::plain(Recurrence::hermite(n), 0.0, 1.0))
    }

    fn legendre(n: usize) -> GaussRule {
        GaussRule::new(
            n,
            |n| Some(Basis::plain(Recurrence::legendre(n), 0.0, 1.0)),
            |t| t,
        )
        .unwrap()
    }

    fn hermite(n: usize) -> GaussRule {
        GaussRule::new(n, hermite_basis, |t| t).unwrap()
    }

    fn assert_close(found: f64, expected: f64, relative: f64) {
        assert!(
            (found - expected).abs() <= relative * expected.abs(),
            "{found:e} {expected:e}"
        );
    }

    #[test]
    fn five_points_match_the_closed_forms() {
        let rule = legendre(5);
        let inner = (5.0 - 2.0 * (10.0f64 / 7.0).sqrt()).sqrt() / 3.0;
        let outer = (5.0 + 2.0 * (10.0f64 / 7.0).sqrt()).sqrt() / 3.0;
        for (found, expected) in rule.nodes.iter().zip([-outer, -inner, 0.0, inner, outer]) {
            assert!((found - expected).abs() <= 2.0 * f64::EPSILON);
        }
        assert_close(rule.weights[2], 64.0 / 225.0, 4.0 * f64::EPSILON);
        assert_close(
            rule.weights[1],
            (322.0 + 13.0 * 70f64.sqrt()) / 1800.0,
            4.0 * f64::EPSILON,
        );

        let rule = hermite(5);
        let inner = (5.0 - 10f64.sqrt()).sqrt();
        let outer = (5.0 + 10f64.sqrt()).sqrt();
        for (found, expected) in rule.nodes.iter().zip([-outer, -inner, 0.0, inner, outer]) {
            assert!((found - expected).abs() <= 4.0 * f64::EPSILON);
        }
        assert_close(rule.weights[2], 8.0 / 15.0, 4.0 * f64::EPSILON);
        assert_close(
            rule.weights[0],
            (7.0 - 2.0 * 10f64.sqrt()) / 60.0,
            16.0 * f64::EPSILON,
        );
    }

    /// Outermost and innermost node and weight at N = 64, computed with 50 digits.
    #[test]
    fn sixty_four_points_match_extended_precision() {
        let table = [
            (legendre(64), 32, 0.024350292663424433, 0.024345478504569862),
            (legendre(64), 63, 0.9993050417357722, 0.0008916403608482165),
            (hermite(64), 32, 0.19558891056727554, 0.15310831636189678),
            (hermite(64), 63, 14.886186143339453, 3.123187965107721e-49),
        ];
        for (rule, j, x, w) in table {
            assert_close(rule.nodes[j], x, 8.0 * f64::EPSILON);
            // the Christoffel sum runs over 64 polynomials, each off by its own recurrence
            assert_close(rule.weights[j], w, 1e-13);
        }
    }

    #[test]
    fn weights_are_probabilities() {
        for n in 1..=MAX_NODES {
            for rule in [legendre(n), hermite(n)] {
                assert!(rule.weights.iter().all(|&w| w > 0.0));
                // n roundings of a sum of positive terms
                assert!((rule.weights.iter().sum::<f64>() - 1.0).abs() <= n as f64 * f64::EPSILON);
            }
        }
    }

    #[test]
    fn moments_are_exact_to_degree_two_n_minus_one() {
        let mut checked = 0;
        for n in 1..=MAX_NODES {
            let (uniform, normal) = (legendre(n), hermite(n));
            let mut double_factorial = 1.0;
            for degree in (0..2 * n).step_by(2) {
                if degree > 0 {
                    double_factorial *= (degree - 1) as f64;
                }
                let moment = |rule: &GaussRule| -> f64 {
                    rule.nodes
                        .iter()
                        .zip(&rule.weights)
                        .map(|(x, w)| w * x.powi(degree as i32))
                        .sum()
                };
                // A node wrong by eps is raised to the degree, a weight adds as much again.
                let tolerance = (2 * degree + 8) as f64 * f64::EPSILON;
                assert_close(moment(&uniform), 1.0 / (degree + 1) as f64, tolerance);
                assert_close(moment(&normal), double_factorial, tolerance);
                checked += 2;
            }
        }
        println!("{checked} moments checked up to N = {MAX_NODES}");
    }

    #[test]
    fn modes_are_orthonormal_on_the_nodes() {
        for rule in [legendre(9), hermite(9)] {
            for k in 1..9 {
                for j in 1..9 {
                    // the j-th polynomial itself, recovered from its row
                    let p_j: Vec<f64> = (0..9)
                        .map(|i| rule.modes[(j - 1) * 9 + i] / rule.weights[i])
                        .collect();
                    let expected = if j == k { 1.0 } else { 0.0 };
                    assert!((rule.coefficient(k, &p_j) - expected).abs() < 1e-13);
                }
            }
        }
    }

    #[test]
    fn bad_rules_are_refused_by_name() {
        let build = |n, place: fn(f64) -> f64| GaussRule::new(n, hermite_basis, place);
        assert_eq!(build(0, |t| t), Err(RuleError::Size { nodes: 0 }));
        assert_eq!(build(65, |t| t), Err(RuleError::Size { nodes: 65 }));
        assert_eq!(
            build(3, |t| 1e308 * t * 9.0),
            Err(RuleError::OutOfRange { index: 0, nodes: 3 })
        );
        assert_eq!(
            build(3, |t| 1.0 + 1e-20 * t),
            Err(RuleError::Coincident { index: 0, nodes: 3 })
        );
    }
}
