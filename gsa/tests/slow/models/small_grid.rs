//! Smooth non-separable models of three uniform inputs, integrated on a grid of 24^3 Gauss nodes.

use gsa::law::distribution::Distribution;

use crate::known::Known;

/// The model with its indices, exact to rounding for analytic models without near singularities.
pub fn known(
    family: &'static str,
    inputs: [Distribution; 3],
    model: impl Fn(&[f64]) -> f64 + 'static,
) -> Known {
    const NODES: usize = 24;
    let rules = inputs.map(|law| law.gauss_rule(NODES).expect("a rule"));
    let mut sections = vec![vec![0.0; NODES]; 3];
    let (mut mean, mut square) = (0.0, 0.0);
    for i in 0..NODES {
        for j in 0..NODES {
            for k in 0..NODES {
                let w = [
                    rules[0].weights[i],
                    rules[1].weights[j],
                    rules[2].weights[k],
                ];
                let y = model(&[rules[0].nodes[i], rules[1].nodes[j], rules[2].nodes[k]]);
                mean += w[0] * w[1] * w[2] * y;
                square += w[0] * w[1] * w[2] * y * y;
                sections[0][i] += w[1] * w[2] * y;
                sections[1][j] += w[0] * w[2] * y;
                sections[2][k] += w[0] * w[1] * y;
            }
        }
    }
    let variance = square - mean * mean;
    let share = |(section, rule): (&Vec<f64>, &gsa::law::rule::GaussRule)| {
        let terms = section.iter().zip(&rule.weights);
        terms.map(|(s, w)| w * (s - mean).powi(2)).sum::<f64>() / variance
    };
    Known {
        family,
        first_order: sections.iter().zip(&rules).map(share).collect(),
        inputs: inputs.to_vec(),
        model: Box::new(model),
    }
}
