//! Orthonormal polynomials of an input's law at any point, not only at the nodes of a rule.
//!
//! The recurrence of the polynomials is taken back from the nodes and weights of a Gauss rule (the Stieltjes procedure:
//! W. Gautschi, *Orthogonal Polynomials: Computation and Approximation*, Oxford 2004, section 2.2.3): the inner products
//! it needs are polynomials of degree 2N - 1 at most, which the rule integrates exactly.
//!
//! | symbol | meaning |
//! |---|---|
//! | xi | the rule's own coordinate, standardised: ln x for lognormal laws, else x |
//! | p_k | polynomial of degree k with E\[p_j p_k\] = 1 if j = k, else 0 |

use crate::law::distribution::Distribution;
use crate::law::rule::GaussRule;

/// The polynomials p_0 .. p_{N-1} of one input.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Polynomials {
    logarithmic: bool,
    centre: f64,
    scale: f64,
    /// a_0 .. a_{N-2}
    diagonal: Vec<f64>,
    /// sqrt(b_1) .. sqrt(b_{N-1})
    off_diagonal: Vec<f64>,
}

impl Polynomials {
    /// Computes as many polynomials of a law as its rule has nodes.
    pub(crate) fn new(law: &Distribution, rule: &GaussRule) -> Self {
        let logarithmic = law.kind() == "lognormal";
        let plain = Self {
            logarithmic,
            centre: 0.0,
            scale: 1.0,
            diagonal: Vec::new(),
            off_diagonal: Vec::new(),
        };
        let raw: Vec<f64> = rule.nodes.iter().map(|&x| plain.coordinate(x)).collect();
        let mean = |values: &[f64]| -> f64 {
            let terms = rule.weights.iter().zip(values);
            terms.map(|(w, f)| w * f).sum()
        };
        let centre = mean(&raw);
        let squares: Vec<f64> = raw.iter().map(|x| (x - centre).powi(2)).collect();
        let deviation = mean(&squares).sqrt();
        let mut polynomials = Self {
            centre,
            scale: if deviation > 0.0 { deviation } else { 1.0 },
            ..plain
        };
        let xi: Vec<f64> = rule
            .nodes
            .iter()
            .map(|&x| polynomials.coordinate(x))
            .collect();
        let mut before = vec![0.0; xi.len()];
        let mut present = vec![1.0; xi.len()];
        for _ in 1..xi.len() {
            let weighted: Vec<f64> = xi.iter().zip(&present).map(|(x, p)| x * p * p).collect();
            let a = mean(&weighted);
            let b = polynomials.off_diagonal.last().copied().unwrap_or(0.0);
            let next: Vec<f64> = (0..xi.len())
                .map(|j| (xi[j] - a) * present[j] - b * before[j])
                .collect();
            let squares: Vec<f64> = next.iter().map(|p| p * p).collect();
            let norm = mean(&squares).sqrt();
            polynomials.diagonal.push(a);
            polynomials.off_diagonal.push(norm);
            before = present;
            present = next.iter().map(|p| p / norm).collect();
        }
        polynomials
    }

    /// xi, in which the polynomials are polynomials.
    pub(crate) fn coordinate(&self, x: f64) -> f64 {
        let raw = if self.logarithmic { x.ln() } else { x };
        (raw - self.centre) / self.scale
    }

    /// p_1(x) .. p_degree(x), degree < N.
    pub(crate) fn evaluate(&self, x: f64, degree: usize) -> Vec<f64> {
        let xi = self.coordinate(x);
        let (mut before, mut present, mut b) = (0.0, 1.0, 0.0);
        (0..degree)
            .map(|k| {
                let next = ((xi - self.diagonal[k]) * present - b * before) / self.off_diagonal[k];
                (before, present, b) = (present, next, self.off_diagonal[k]);
                next
            })
            .collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_polynomials_are_those_of_the_law() {
        let law = Distribution::uniform(1.0, 5.0).unwrap();
        let polynomials = Polynomials::new(&law, &law.gauss_rule(8).unwrap());
        let t: f64 = 0.3; // x = 3 + 2 t
        let legendre = [
            3f64.sqrt() * t,
            5f64.sqrt() * 0.5 * (3.0 * t * t - 1.0),
            7f64.sqrt() * 0.5 * (5.0 * t.powi(3) - 3.0 * t),
        ];
        for (p, expected) in polynomials.evaluate(3.6, 3).iter().zip(legendre) {
            assert!((p - expected).abs() < 1e-14, "{p} {expected}");
        }
        let law = Distribution::lognormal(0.5, 0.4).unwrap();
        let polynomials = Polynomials::new(&law, &law.gauss_rule(9).unwrap());
        let z: f64 = -1.7;
        let hermite = [
            z,
            (z * z - 1.0) / 2f64.sqrt(),
            (z.powi(3) - 3.0 * z) / 6f64.sqrt(),
        ];
        for (p, expected) in polynomials
            .evaluate((0.5 + 0.4 * z).exp(), 3)
            .iter()
            .zip(hermite)
        {
            assert!((p - expected).abs() < 1e-13, "{p} {expected}");
        }
    }

    #[test]
    fn at_the_nodes_they_are_orthonormal() {
        let law = Distribution::normal(2.0, 0.1).unwrap();
        let rule = law.gauss_rule(17).unwrap();
        let polynomials = Polynomials::new(&law, &rule);
        let p: Vec<Vec<f64>> = rule
            .nodes
            .iter()
            .map(|&x| polynomials.evaluate(x, 16))
            .collect();
        for j in 0..16 {
            for k in 0..16 {
                let product: f64 = (0..17).map(|i| rule.weights[i] * p[i][j] * p[i][k]).sum();
                let expected = if j == k { 1.0 } else { 0.0 };
                assert!((product - expected).abs() < 1e-11, "{j} {k} {product}");
            }
        }
    }
}
