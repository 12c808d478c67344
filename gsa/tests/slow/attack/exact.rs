//! Exact first-order indices of sums of products of any functions of one input.
//!
//! Moments come from the double-exponential rule in the probability p, between the functions' breaks. Close to p = 1 the
//! input is taken from 1 - p, so that heavy tails keep their digits.

use std::f64::consts::FRAC_PI_2;
use std::rc::Rc;

use gsa::law::distribution::Distribution;

use crate::known::Known;

impl Known {
    /// Returns the model under an offset, which no index feels.
    pub fn raised(self, family: &'static str, by: f64) -> Self {
        let model = self.model;
        Self {
            family,
            model: Box::new(move |x| by + model(x)),
            ..self
        }
    }
}

/// A function of input i.
#[derive(Clone)]
pub struct Factor {
    pub input: usize,
    pub function: Rc<dyn Fn(f64) -> f64>,
}

/// f(x_i)
pub fn of(input: usize, function: impl Fn(f64) -> f64 + 'static) -> Factor {
    Factor {
        input,
        function: Rc::new(function),
    }
}

/// A coefficient and factors of different inputs.
pub type Term = (f64, Vec<Factor>);

/// Inputs of a law with their probability, between breaks in the input's units.
fn points(law: &Distribution, breaks: &[f64]) -> Vec<(f64, f64)> {
    // Below 1e-300 of probability nothing is left of the moments asked for; step 1/16 leaves 1e-14 of smooth panels.
    const REACH: f64 = 6.0;
    const PER_UNIT: i32 = 16;
    let mut ends: Vec<f64> = breaks.iter().map(|x| law.cdf(*x)).collect();
    ends.retain(|p| *p > 0.0 && *p < 1.0);
    ends.extend([0.0, 0.5, 1.0]);
    ends.sort_by(f64::total_cmp);
    ends.dedup();
    let step = 1.0 / f64::from(PER_UNIT);
    let mut points = Vec::new();
    for pair in ends.windows(2) {
        let width = pair[1] - pair[0];
        for k in -(REACH as i32) * PER_UNIT..=REACH as i32 * PER_UNIT {
            let t = f64::from(k) * step;
            // Distances from both ends of the panel, each with its own digits: w and 1 - w with w = 1/(1 + e^-2s).
            let s = FRAC_PI_2 * t.sinh();
            let (from_left, from_right) = (
                1.0 / (1.0 + (-2.0 * s).exp()),
                1.0 / (1.0 + (2.0 * s).exp()),
            );
            let weight = width * step * 2.0 * FRAC_PI_2 * t.cosh() * from_left * from_right;
            let x = if pair[1] == 1.0 {
                law.inverse_survival(width * from_right)
            } else {
                law.inverse_cdf(pair[0] + width * from_left)
            };
            if weight > 0.0 && x.is_finite() {
                points.push((x, weight));
            }
        }
    }
    points
}

/// sum_m a_m prod_i f_mi(x_i): with D_ml = prod_i E\[f_mi f_li\] and M_m = prod_i E\[f_mi\],
/// Var\[h\] = sum_ml a_m a_l (D_ml - M_m M_l), and the main effect of x_i is sum_m a_m f_mi(x_i) M_m/E\[f_mi\].
pub fn sum_of_products(
    family: &'static str,
    inputs: Vec<Distribution>,
    breaks: &[f64],
    terms: Vec<Term>,
) -> Known {
    let n = inputs.len();
    let grids: Vec<Vec<(f64, f64)>> = inputs.iter().map(|law| points(law, breaks)).collect();
    let tables: Vec<Vec<(usize, Vec<f64>)>> = terms
        .iter()
        .map(|(_, factors)| {
            let values = |f: &Factor| {
                grids[f.input]
                    .iter()
                    .map(|(x, _)| (f.function)(*x))
                    .collect()
            };
            factors.iter().map(|f| (f.input, values(f))).collect()
        })
        .collect();
    let expected = |input: usize, integrand: &dyn Fn(usize) -> f64| -> f64 {
        let grid = grids[input].iter().enumerate();
        grid.map(|(k, (_, weight))| weight * integrand(k)).sum()
    };
    let means: Vec<Vec<f64>> = tables
        .iter()
        .map(|factors| {
            factors
                .iter()
                .map(|(i, f)| expected(*i, &|k| f[k]))
                .collect()
        })
        .collect();
    let others = |m: usize, skip: usize| -> f64 {
        let kept = tables[m]
            .iter()
            .zip(&means[m])
            .filter(|((i, _), _)| *i != skip);
        terms[m].0 * kept.map(|(_, mean)| mean).product::<f64>()
    };
    let first_order = (0..n).map(|input| {
        let mut effect = vec![0.0; grids[input].len()];
        for (m, factors) in tables.iter().enumerate() {
            if let Some((_, f)) = factors.iter().find(|(i, _)| *i == input) {
                let scale = others(m, input);
                effect.iter_mut().zip(f).for_each(|(e, f)| *e += scale * f);
            }
        }
        let mean = expected(input, &|k| effect[k]);
        expected(input, &|k| (effect[k] - mean).powi(2))
    });
    let first_order: Vec<f64> = first_order.collect();
    let variance: f64 = covariances(&terms, &tables, &means, &expected).iter().sum();
    let run = terms;
    Known {
        family,
        first_order: first_order.iter().map(|v| v / variance).collect(),
        inputs,
        model: Box::new(move |x| {
            let term = |(a, factors): &Term| {
                a * factors
                    .iter()
                    .map(|f| (f.function)(x[f.input]))
                    .product::<f64>()
            };
            run.iter().map(term).sum()
        }),
    }
}

/// The expectation over an input of what is tabulated at its points.
type Expectation<'a> = dyn Fn(usize, &dyn Fn(usize) -> f64) -> f64 + 'a;

/// a_m a_l Cov of every pair of terms; terms without a common input have none. The covariance of products is summed input by
/// input from covariances of factors, because D - M M would cancel under a large constant factor.
fn covariances(
    terms: &[Term],
    tables: &[Vec<(usize, Vec<f64>)>],
    means: &[Vec<f64>],
    expected: &Expectation<'_>,
) -> Vec<f64> {
    let mut found = Vec::new();
    for m in 0..terms.len() {
        for l in 0..terms.len() {
            // prod (mu_i + c_i) - prod mu_i, one factor after the other.
            let (mut difference, mut apart) = (0.0, 1.0);
            for ((i, f), mean) in tables[m].iter().zip(&means[m]) {
                match tables[l].iter().position(|(j, _)| i == j) {
                    Some(at) => {
                        let (g, other) = (&tables[l][at].1, means[l][at]);
                        let c = expected(*i, &|k| (f[k] - mean) * (g[k] - other));
                        difference = difference * (mean * other + c) + apart * c;
                        apart *= mean * other;
                    }
                    None => {
                        difference *= mean;
                        apart *= mean;
                    }
                }
            }
            let alone = tables[l].iter().zip(&means[l]);
            let alone = alone.filter(|((j, _), _)| tables[m].iter().all(|(i, _)| i != j));
            found.push(
                terms[m].0 * terms[l].0 * difference * alone.map(|(_, mean)| mean).product::<f64>(),
            );
        }
    }
    found
}

/// A model of few inputs, smooth between no breaks at all: its indices from a full grid of Gauss nodes, each as many as given.
pub fn on_grid(
    family: &'static str,
    inputs: Vec<Distribution>,
    nodes: usize,
    model: impl Fn(&[f64]) -> f64 + 'static,
) -> Known {
    let nodes = vec![nodes; inputs.len()];
    on_grid_of(family, inputs, &nodes, model)
}

/// A known model on a grid with as many nodes along each input as given for it.
pub fn on_grid_of(
    family: &'static str,
    inputs: Vec<Distribution>,
    nodes: &[usize],
    model: impl Fn(&[f64]) -> f64 + 'static,
) -> Known {
    let n = inputs.len();
    let rules: Vec<_> = inputs
        .iter()
        .zip(nodes)
        .map(|(law, nodes)| law.gauss_rule(*nodes).expect("a rule"))
        .collect();
    let mut sections: Vec<Vec<f64>> = nodes.iter().map(|nodes| vec![0.0; *nodes]).collect();
    let mut moments = Vec::new();
    for cell in 0..nodes.iter().product() {
        let mut rest = cell;
        let at: Vec<usize> = nodes
            .iter()
            .map(|nodes| {
                let j = rest % nodes;
                rest /= nodes;
                j
            })
            .collect();
        let x: Vec<f64> = (0..n).map(|i| rules[i].nodes[at[i]]).collect();
        let weight: f64 = (0..n).map(|i| rules[i].weights[at[i]]).product();
        let y = model(&x);
        for i in 0..n {
            sections[i][at[i]] += weight / rules[i].weights[at[i]] * y;
        }
        moments.push((weight, y));
    }
    let mean: f64 = moments.iter().map(|(w, y)| w * y).sum();
    let variance: f64 = moments.iter().map(|(w, y)| w * (y - mean).powi(2)).sum();
    let share = |i: usize| {
        let terms = sections[i].iter().zip(&rules[i].weights);
        terms.map(|(s, w)| w * (s - mean).powi(2)).sum::<f64>() / variance
    };
    Known {
        family,
        first_order: (0..n).map(share).collect(),
        inputs,
        model: Box::new(model),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn differ(found: &Known, expected: &[f64]) -> f64 {
        found.error_of(expected)
    }

    /// ln x1 x2 + sqrt(x3), lognormals of widths s: V_1 = s_1^2 e^(s_2^2), V_2 = 0, V_12 = s_1^2 (e^(2 s_2^2) - e^(s_2^2)),
    /// V_3 = e^(s_3^2/2) - e^(s_3^2/4).
    #[test]
    fn tails_are_integrated_to_their_closed_form() {
        let s = [0.7f64, 1.5, 1.1];
        let laws = s.map(|s| Distribution::lognormal(0.0, s).unwrap()).to_vec();
        let terms = vec![
            (1.0, vec![of(0, f64::ln), of(1, |x| x)]),
            (1.0, vec![of(2, f64::sqrt)]),
        ];
        let found = sum_of_products("", laws, &[], terms);
        let q = s.map(|s| s * s);
        let parts = [
            q[0] * q[1].exp(),
            0.0,
            (q[2] / 2.0).exp() - (q[2] / 4.0).exp(),
        ];
        let variance = q[0] * (2.0 * q[1]).exp() + parts[2];
        // The rule's own error, 1e-14 of each moment, and their number.
        assert!(
            differ(&found, &parts.map(|v| v / variance)) < 1e-12,
            "{:?}",
            found.first_order
        );
    }

    /// 3 + min(x, 1/2) + 2 [y > 0.3] z on the unit cube by hand, with breaks inside.
    #[test]
    fn breaks_are_met() {
        let cube = vec![Distribution::uniform(0.0, 1.0).unwrap(); 3];
        let terms = vec![
            (3.0, vec![]),
            (1.0, vec![of(0, |x| x.min(0.5))]),
            (2.0, vec![of(1, |y| f64::from(y > 0.3)), of(2, |z| z)]),
        ];
        let found = sum_of_products("", cube, &[0.3, 0.5], terms);
        // E min = 3/8, E min^2 = 1/24 + 1/8; y: mean 0.7; z: mean 1/2, E z^2 = 1/3.
        let parts = [1.0 / 6.0 - 9.0 / 64.0, 4.0 * 0.21 * 0.25, 4.0 * 0.49 / 12.0];
        let variance = parts[0] + 4.0 * (0.7 / 3.0 - 0.49 / 4.0);
        assert!(
            differ(&found, &parts.map(|v| v / variance)) < 1e-12,
            "{:?}",
            found.first_order
        );
    }

    /// x y on the grid and as a product.
    #[test]
    fn grid_and_products_agree() {
        let laws = vec![
            Distribution::normal(1.0, 0.5).unwrap(),
            Distribution::uniform(0.0, 2.0).unwrap(),
        ];
        let grid = on_grid("", laws.clone(), 8, |x| x[0] * x[1]);
        let product = sum_of_products("", laws, &[], vec![(1.0, vec![of(0, |x| x), of(1, |x| x)])]);
        assert!(grid.error_of(&product.first_order) < 1e-12);
    }
}
