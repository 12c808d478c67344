//! `saltelli`, Sobol's indices from pairs of samples: no assumption on the model, and thousands of runs.
//!
//! With two samples A and B and A_Bi, which is A with the column of input i from B,
//!
//! ```text
//! V_i  = 1/N sum_k f(B)_k (f(A_Bi)_k - f(A)_k)             first order
//! V_Ti = 1/(2N) sum_k (f(A)_k - f(A_Bi)_k)^2                total
//! ```
//!
//! A. Saltelli, P. Annoni, I. Azzini, F. Campolongo, M. Ratto, S. Tarantola, "Variance based sensitivity analysis of model
//! output", Computer Physics Communications 181 (2010) 259-270, table 2 (b) and (f), the latter from M. J. W. Jansen (1999). f
//! is centred first, which lowers the scatter of V_i. A and B are scrambled Sobol points, [`REPLICATES`] independent scrambles;
//! the jackknife over these gives the confidence interval, which holds whatever the order of convergence is.
//!
//! Cost: N (n + 2) runs. A base point with a failed run is left out where that run enters. Limits: small indices drown in
//! the interval of large ones; indices are cut to \[0, 1\] and, summing to more than one by chance, scaled back.

use ndarray::ArrayView2;

use crate::design::sobol::Sobol;
use crate::design::{DesignError, MAX_CHECK_POINTS};
use crate::form::scale::{exponent, times_power_of_two};
use crate::judge::index_error::{ByInput, ErrorParts};
use crate::law::distribution::Distribution;
use crate::method::Method;
use crate::method::analysis::{Analysis, Form, each_output};
use crate::method::procedure::{Procedure, Runs};
use crate::method::scattered::{self, Scattered};

/// Independent scrambles.
pub(crate) const REPLICATES: usize = 8;
/// Rounding of the values beyond this share of their spread is all there is.
const NO_SPREAD: f64 = 0.25;
/// Student's t, two-sided 95 %, with REPLICATES - 1 degrees of freedom.
const STUDENT: f64 = 2.365;

/// The samples, behind the cut point.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Saltelli {
    inputs: usize,
    points: Vec<Vec<f64>>,
}

impl Procedure for Saltelli {
    fn begin(inputs: &[Distribution], settings: &Method) -> Result<Self, DesignError> {
        let asked = settings.samples.saturating_mul(inputs.len() + 2);
        if asked > 10 * MAX_CHECK_POINTS {
            return Err(DesignError::TooManyCheckPoints { asked });
        }
        Ok(Self {
            inputs: inputs.len(),
            points: points(inputs, settings.samples, settings.seed),
        })
    }

    /// The base points are as many in each replicate.
    fn most_first_points(inputs: usize, settings: &Method) -> usize {
        let base = settings.samples.saturating_add(REPLICATES);
        base.saturating_mul(inputs.saturating_add(2))
    }

    fn default_samples() -> usize {
        1024
    }

    fn runs(&self) -> Runs<'_> {
        Runs::Scattered(&self.points)
    }

    fn analyse(&self, values: &ArrayView2<f64>) -> Result<Vec<Analysis>, DesignError> {
        Ok(each_output(values, |values| {
            let found = sampled(self.inputs, values);
            scattered::answer(found, values, Form::Saltelli).of_one_input()
        }))
    }
}

/// The points, after the cut point: replicate by replicate, base point by base point, A, B, A_B1, ..
fn points(inputs: &[Distribution], samples: usize, seed: u64) -> Vec<Vec<f64>> {
    let n = inputs.len();
    let sobol = Sobol::new(2 * n);
    let mut points = vec![inputs.iter().map(Distribution::mean).collect()];
    for replicate in 0..REPLICATES {
        let stream = seed
            .wrapping_mul(REPLICATES as u64)
            .wrapping_add(replicate as u64);
        for k in 0..per_replicate(samples) {
            let u = sobol.point(k as u32, stream);
            let place = |u: &[f64]| -> Vec<f64> {
                inputs
                    .iter()
                    .zip(u)
                    .map(|(law, u)| law.inverse_cdf(*u))
                    .collect()
            };
            let (a, b) = (place(&u[..n]), place(&u[n..]));
            points.push(a.clone());
            points.push(b.clone());
            points.extend((0..n).map(|i| {
                let mut mixed = a.clone();
                mixed[i] = b[i];
                mixed
            }));
        }
    }
    points
}

fn per_replicate(samples: usize) -> usize {
    samples.div_ceil(REPLICATES).max(2)
}

/// Sums over some base points, from which indices follow.
#[derive(Debug, Clone)]
struct Sums {
    variance: f64,
    /// V_i and V_Ti, each already a mean
    parts: Vec<(f64, f64)>,
}

/// Analyses one output; `None` if it doesn't vary or too few runs gave a number.
fn sampled(inputs: usize, values: &[f64]) -> Option<Scattered> {
    let lost: Vec<usize> = (0..values.len())
        .filter(|&k| !values[k].is_finite())
        .collect();
    let finite = values[1..].iter().filter(|y| y.is_finite());
    let largest = finite.clone().fold(0.0f64, |max, y| max.max(y.abs()));
    let power = exponent(largest);
    let count = finite.clone().count();
    let scaled = |y: f64| times_power_of_two(y, -power);
    // From one of the values on, so that a constant leaves nothing, not the rounding of a sum.
    let origin = finite.clone().next().map_or(0.0, |&y| scaled(y));
    let shift = finite.map(|&y| scaled(y) - origin).sum::<f64>() / count as f64;
    let mean = origin + shift;
    let centred: Vec<f64> = values[1..]
        .iter()
        .map(|&y| scaled(y) - origin - shift)
        .collect();
    let block = (values.len() - 1) / REPLICATES;
    let replicates: Option<Vec<Sums>> = centred
        .chunks(block)
        .map(|values| sums(inputs, values))
        .collect();
    let replicates = replicates?;
    let all = indices(&replicates);
    let spread = replicates.iter().map(|r| r.variance).sum::<f64>() / REPLICATES as f64;
    let floor = f64::EPSILON * (scaled(largest) / spread.sqrt() + (inputs + 4) as f64);
    if floor.is_nan() || floor > NO_SPREAD {
        return None;
    }
    let errors = ByInput {
        sampling: Some(intervals(&replicates, &all.0)),
        ..ByInput::default()
    };
    // Zero is added for its sign: the clamp lets -0 pass.
    let cut = |s: &f64| s.clamp(0.0, 1.0) + 0.0;
    let mut first_order: Vec<f64> = all.0.iter().map(cut).collect();
    let sum: f64 = first_order.iter().sum();
    if sum > 1.0 {
        first_order.iter_mut().for_each(|s| *s /= sum);
    }
    Some(Scattered {
        mean: times_power_of_two(mean, power),
        variance: times_power_of_two(spread, 2 * power),
        first_order,
        total: all.1.iter().map(cut).collect(),
        second_order: None,
        error: ErrorParts::new(errors, floor),
        lost,
    })
}

/// Half widths of the first-order indices' confidence intervals, by the jackknife.
fn intervals(replicates: &[Sums], first_order: &[f64]) -> Vec<f64> {
    let interval = |input: usize| {
        let left_out = (0..REPLICATES).map(|skip| {
            let others: Vec<Sums> = (0..REPLICATES)
                .filter(|r| *r != skip)
                .map(|r| replicates[r].clone())
                .collect();
            (indices(&others).0[input] - first_order[input]).powi(2)
        });
        let r = REPLICATES as f64;
        (STUDENT * ((r - 1.0) / r * left_out.sum::<f64>()).sqrt()).min(1.0)
    };
    (0..first_order.len()).map(interval).collect()
}

/// Sums up the blocks; `None` if some input has no base point left.
fn sums(inputs: usize, values: &[f64]) -> Option<Sums> {
    let blocks = || values.chunks(inputs + 2);
    let mean = |terms: Vec<f64>| -> Option<f64> {
        let finite: Vec<f64> = terms.into_iter().filter(|x| x.is_finite()).collect();
        (!finite.is_empty()).then(|| finite.iter().sum::<f64>() / finite.len() as f64)
    };
    let part = |input: usize| {
        let first = blocks().map(|b| b[1] * (b[2 + input] - b[0])).collect();
        let total = blocks()
            .map(|b| 0.5 * (b[0] - b[2 + input]).powi(2))
            .collect();
        Some((mean(first)?, mean(total)?))
    };
    let squares = blocks().flat_map(|b| [b[0] * b[0], b[1] * b[1]]).collect();
    Some(Sums {
        variance: mean(squares)?,
        parts: (0..inputs).map(part).collect::<Option<_>>()?,
    })
}

/// First-order and total indices from some replicates together.
fn indices(replicates: &[Sums]) -> (Vec<f64>, Vec<f64>) {
    let variance: f64 = replicates.iter().map(|r| r.variance).sum();
    let inputs = replicates[0].parts.len();
    let share = |part: fn(&(f64, f64)) -> f64, input: usize| {
        replicates
            .iter()
            .map(|r| part(&r.parts[input]))
            .sum::<f64>()
            / variance
    };
    (
        (0..inputs).map(|i| share(|p| p.0, i)).collect(),
        (0..inputs).map(|i| share(|p| p.1, i)).collect(),
    )
}
