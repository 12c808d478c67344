//! h = sum_m a_m prod_i f_mi(x_i): every index follows from one-dimensional moments.
//!
//! Var\[h\] = sum_ml a_m a_l (prod_i E\[f_mi f_li\] - prod_i E\[f_mi\] E\[f_li\]) and
//! Var\[E\[h|x_i\]\] = sum_ml a_m a_l Cov(f_mi, f_li) prod_{k != i} E\[f_mk\] E\[f_lk\].

use gsa::law::distribution::Distribution;

use crate::known::Known;

/// A function of one input.
#[derive(Debug, Clone)]
pub enum Factor {
    One,
    /// c_0 + c_1 x + c_2 x^2 + ..
    Polynomial(Vec<f64>),
    /// offset + sin(frequency x + phase)
    Sine {
        offset: f64,
        frequency: f64,
        phase: f64,
    },
    Exponential(f64),
    /// offset + |x - at|
    Kink {
        offset: f64,
        at: f64,
    },
    /// low below, high above
    Step {
        at: f64,
        low: f64,
        high: f64,
    },
}

impl Factor {
    fn at(&self, x: f64) -> f64 {
        match self {
            Self::One => 1.0,
            Self::Polynomial(c) => c.iter().rev().fold(0.0, |sum, c| sum * x + c),
            Self::Sine {
                offset,
                frequency,
                phase,
            } => offset + (frequency * x + phase).sin(),
            Self::Exponential(a) => (a * x).exp(),
            Self::Kink { offset, at } => offset + (x - at).abs(),
            Self::Step { at, low, high } => {
                if x < *at {
                    *low
                } else {
                    *high
                }
            }
        }
    }

    fn kink(&self) -> Option<f64> {
        match self {
            Self::Kink { at, .. } | Self::Step { at, .. } => Some(*at),
            _ => None,
        }
    }
}

/// A product: its coefficient and one factor per input.
pub type Term = (f64, Vec<Factor>);

/// Five-point Gauss-Legendre rule on \[0, 1\]; on panels that shrink towards both ends by half each.
fn panels(mut breaks: Vec<f64>) -> Vec<(f64, f64)> {
    let rule = Distribution::uniform(0.0, 1.0).map(|law| law.gauss_rule(12));
    let rule = rule.expect("a valid law").expect("a valid rule");
    for power in 1..=36 {
        let u = 0.5f64.powi(power);
        breaks.extend([u, 1.0 - u]);
    }
    breaks.extend([0.0, 0.25, 0.375, 0.625, 0.75, 1.0]);
    breaks.sort_by(f64::total_cmp);
    breaks.dedup();
    let mut points = Vec::new();
    for pair in breaks.windows(2) {
        let width = pair[1] - pair[0];
        for (x, w) in rule.nodes.iter().zip(&rule.weights) {
            points.push((pair[0] + width * x, w * width));
        }
    }
    points
}

/// The model with its exact indices.
pub fn known(family: &'static str, inputs: Vec<Distribution>, terms: Vec<Term>) -> Known {
    let (n, m) = (inputs.len(), terms.len());
    // mean[i][a] and product[i][a][b]: E[f_ai] and Cov(f_ai, f_bi)
    let mut mean = vec![vec![0.0; m]; n];
    let mut covariance = vec![vec![vec![0.0; m]; m]; n];
    for (i, law) in inputs.iter().enumerate() {
        let breaks = terms.iter().filter_map(|(_, factors)| factors[i].kink());
        let breaks = breaks
            .map(|x| law.cdf(x))
            .filter(|u| *u > 0.0 && *u < 1.0)
            .collect();
        let points: Vec<(Vec<f64>, f64)> = panels(breaks)
            .into_iter()
            .map(|(u, w)| {
                let x = law.inverse_cdf(u);
                (
                    terms.iter().map(|(_, factors)| factors[i].at(x)).collect(),
                    w,
                )
            })
            .collect();
        for a in 0..m {
            mean[i][a] = points.iter().map(|(f, w)| w * f[a]).sum();
        }
        // A constant has none.
        let varying = |a: &usize| !matches!(terms[*a].1[i], Factor::One);
        for a in (0..m).filter(varying) {
            for b in (0..=a).filter(varying) {
                let centred =
                    |(f, w): &(Vec<f64>, f64)| w * (f[a] - mean[i][a]) * (f[b] - mean[i][b]);
                covariance[i][a][b] = points.iter().map(centred).sum();
                covariance[i][b][a] = covariance[i][a][b];
            }
        }
    }
    let mut variance = 0.0;
    let mut main = vec![0.0; n];
    for a in 0..m {
        for b in 0..m {
            let coefficient = terms[a].0 * terms[b].0;
            let means: Vec<f64> = (0..n).map(|i| mean[i][a] * mean[i][b]).collect();
            let (mut whole, mut apart) = (1.0, 1.0);
            for i in 0..n {
                whole *= means[i] + covariance[i][a][b];
                apart *= means[i];
                let others: f64 = (0..n).filter(|k| *k != i).map(|k| means[k]).product();
                main[i] += coefficient * covariance[i][a][b] * others;
            }
            variance += coefficient * (whole - apart);
        }
    }
    Known {
        family,
        inputs,
        first_order: main.iter().map(|v| v / variance).collect(),
        model: Box::new(move |x| {
            let product = |(a, factors): &Term| {
                a * factors
                    .iter()
                    .zip(x)
                    .map(|(f, x)| f.at(*x))
                    .product::<f64>()
            };
            terms.iter().map(product).sum()
        }),
    }
}
