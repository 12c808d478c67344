//! Several networks, each from weights of its own and stopped early on cycles of its own; their mean is the estimate.

use std::cell::RefCell;

use ndarray::{Array1, ArrayView1, ArrayView2, Axis};
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;
use serde::{Deserialize, Serialize};

use super::network::{Network, Shape, train};
use crate::model::contract::{
    Effort, FitError, Prediction, Training, check_deviation, check_numbers,
};
use crate::model::even_subset::even_subset;
use crate::model::training_mean::mean_and_deviation;
use crate::recipe::{Activation, AnnSettings, Loss};

/// Number of cycles of which one tells when to stop.
const STOPPING_SHARE: usize = 5;
/// Looks without a new least error, after which training stops.
const PATIENCE: usize = 30;
/// Most rows: an even subset of more.
const MOST_ROWS: usize = 6000;
/// Rows of folds at most, and their iterations. Their networks are as many: the deviation holds how much they differ.
const FOLD_ROWS: usize = 1000;
const FOLD_ITERATIONS: usize = 100;
/// Activations with an end reach it at infinity: forces stay within so much of it.
const WITHIN: f64 = 0.9;

/// Networks of one shape, and how a force becomes their output.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Ensemble {
    layers: Vec<usize>,
    activation: Activation,
    output: Activation,
    loss: Loss,
    /// Output = (force - shift) / scale.
    shift: f64,
    scale: f64,
    networks: Vec<Vec<f64>>,
    /// Root of the mean squared error on the cycles that told when to stop.
    noise: f64,
}

/// Sizes of a fit.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Sizes {
    /// Rows that are learnt from, those that tell when to stop among them.
    pub rows: usize,
    /// Count of networks.
    pub networks: usize,
    /// Iterations of each at most.
    pub iterations: usize,
}

impl Sizes {
    /// Sizes of a fit to so many rows.
    pub(crate) fn of(settings: &AnnSettings, effort: Effort, rows: usize) -> Self {
        let networks = settings.networks;
        match effort {
            Effort::Whole => Self {
                rows: rows.min(MOST_ROWS),
                networks,
                iterations: settings.iterations,
            },
            Effort::Fold => Self {
                rows: rows.min(FOLD_ROWS),
                networks,
                iterations: settings.iterations.min(FOLD_ITERATIONS),
            },
        }
    }
}

/// Counts the nodes of a network with so many features, and its weights, thresholds among them.
pub(crate) fn nodes_and_weights(settings: &AnnSettings, features: usize) -> (f64, f64) {
    let sizes = shape(settings, features).sizes;
    let nodes: usize = sizes.iter().skip(1).sum();
    let weights: usize = sizes.windows(2).map(|pair| (pair[0] + 1) * pair[1]).sum();
    (nodes as f64, weights as f64)
}

impl Ensemble {
    /// Trains the networks.
    ///
    /// # Errors
    /// When none has a finite loss; when Poisson's loss meets a negative force.
    pub fn fit(
        settings: &AnnSettings,
        effort: Effort,
        seed: u64,
        training: &Training<'_>,
    ) -> Result<Self, FitError> {
        if settings.loss == Loss::Poisson && training.forces.iter().any(|force| *force < 0.0) {
            return Err(FitError::Negative);
        }
        let Sizes {
            rows,
            networks: count,
            iterations,
        } = Sizes::of(settings, effort, training.forces.len());
        let rows = even_subset(training.forces.len(), rows);
        let (shift, scale) = target_scale(settings, training.forces);
        let shape = shape(settings, training.features.ncols());
        let mut networks = Vec::new();
        let mut squares = Vec::new();
        for number in 0..count.max(1) {
            let (learnt, stopping) = stopping_cycles(training.cycles, &rows, number);
            let of = |rows: &[usize]| {
                let targets: Array1<f64> = rows
                    .iter()
                    .map(|row| (training.forces[*row] - shift) / scale)
                    .collect();
                (training.features.select(Axis(0), rows), targets)
            };
            let ((x, y), (stop_x, stop_y)) = (of(&learnt), of(&stopping));
            let start = shape.drawn(&mut ChaCha8Rng::seed_from_u64(
                seed.wrapping_add(number as u64),
            ));
            let best: RefCell<(f64, usize, Vec<f64>)> =
                RefCell::new((f64::INFINITY, 0, Vec::new()));
            let watch = |weights: &[f64]| {
                let error = Network::new(&shape, weights).error(&stop_x.view(), &stop_y.view());
                let mut best = best.borrow_mut();
                if error < best.0 {
                    *best = (error, 0, weights.to_vec());
                } else {
                    best.1 += 1;
                }
                best.1 < PATIENCE
            };
            // What is kept is what the left-out cycles liked best, not what the training rows did.
            train(&shape, &start, &x.view(), &y.view(), iterations, &watch);
            let (error, _, weights) = best.into_inner();
            if error.is_finite() {
                squares.push(
                    mean_square(&shape, &weights, &stop_x.view(), stop_y.view()) * scale * scale,
                );
                networks.push(weights);
            }
        }
        if networks.is_empty() {
            return Err(FitError::NoLoss);
        }
        let noise = (squares.iter().sum::<f64>() / squares.len() as f64).sqrt();
        Ok(Self {
            layers: shape.sizes.clone(),
            activation: settings.activation,
            output: settings.output,
            loss: settings.loss,
            shift,
            scale,
            networks,
            noise: if noise > 0.0 {
                noise
            } else {
                f64::MIN_POSITIVE.sqrt()
            },
        })
    }

    fn shape(&self) -> Shape {
        Shape {
            sizes: self.layers.clone(),
            hidden: self.activation,
            output: self.output,
            loss: self.loss,
            decay: 0.0,
        }
    }

    /// The networks' mean; its deviation is that of their errors and of their differences.
    pub fn predict(&self, features: &[f64]) -> Prediction {
        let shape = self.shape();
        let outputs: Vec<f64> = self
            .networks
            .iter()
            .map(|weights| self.shift + self.scale * answer(&shape, weights, features))
            .collect();
        let count = outputs.len() as f64;
        let mean = outputs.iter().sum::<f64>() / count;
        let spread = outputs.iter().map(|y| (y - mean) * (y - mean)).sum::<f64>() / count;
        Prediction {
            mean,
            deviation: (self.noise * self.noise + spread).sqrt(),
        }
    }

    pub(crate) fn check(&self, features: usize) -> Result<(), String> {
        let layers = &self.layers;
        let whole = layers.first() == Some(&features)
            && layers.last() == Some(&1)
            && layers.iter().all(|nodes| (1..=4096 * 4).contains(nodes));
        if !whole
            || layers.len() < 2
            || self.networks.is_empty()
            || self.output == Activation::Softmax
        {
            return Err(format!(
                "a network must lead from {features} features to one force; its layers are {layers:?}"
            ));
        }
        check_numbers("a network's shift", &[self.shift], 1)?;
        check_deviation("a network's scale", self.scale)?;
        check_deviation("a network's noise", self.noise)?;
        let count = self.shape().weights();
        self.networks
            .iter()
            .try_for_each(|weights| check_numbers("a network's weights", weights, count))
    }
}

fn shape(settings: &AnnSettings, features: usize) -> Shape {
    let hidden = settings.layers.iter().copied();
    Shape {
        sizes: std::iter::once(features)
            .chain(hidden)
            .chain(std::iter::once(1))
            .collect(),
        hidden: settings.activation,
        output: if settings.loss == Loss::Poisson {
            Activation::Linear
        } else {
            settings.output
        },
        loss: settings.loss,
        decay: settings.decay,
    }
}

/// A network's output as a scaled force: Poisson's is the logarithm of its mean.
fn answer(shape: &Shape, weights: &[f64], features: &[f64]) -> f64 {
    let output = Network::new(shape, weights).output(features);
    match shape.loss {
        Loss::Mse => output,
        Loss::Poisson => output.min(50.0).exp(),
    }
}

fn mean_square(
    shape: &Shape,
    weights: &[f64],
    rows: &ArrayView2<f64>,
    targets: ArrayView1<'_, f64>,
) -> f64 {
    let error = |(row, target): (ArrayView1<'_, f64>, &f64)| {
        (answer(shape, weights, &row.to_vec()) - target).powi(2)
    };
    let squares: f64 = rows.rows().into_iter().zip(targets).map(error).sum();
    squares / targets.len().max(1) as f64
}

/// Shift and scale of forces, so that the output's activation reaches all of them.
fn target_scale(settings: &AnnSettings, forces: &[f64]) -> (f64, f64) {
    let (mean, deviation) = mean_and_deviation(forces);
    if settings.loss == Loss::Poisson {
        return (0.0, deviation);
    }
    let low = forces.iter().copied().fold(f64::INFINITY, f64::min);
    let high = forces.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let range = if high > low { high - low } else { 1.0 };
    match settings.output {
        Activation::Linear | Activation::Softmax => (mean, deviation),
        Activation::Elu | Activation::Relu => (low, deviation),
        Activation::Sigmoid => (low - (1.0 - WITHIN) / 2.0 * range / WITHIN, range / WITHIN),
        Activation::Tanh => ((low + high) / 2.0, range / 2.0 / WITHIN),
    }
}

/// Rows that are learnt from, and those whose cycles tell when to stop: every fifth cycle, another one for each network; every fifth row where cycles are few.
fn stopping_cycles(cycles: &[usize], rows: &[usize], number: usize) -> (Vec<usize>, Vec<usize>) {
    let mut distinct: Vec<usize> = rows.iter().map(|row| cycles[*row]).collect();
    distinct.sort_unstable();
    distinct.dedup();
    let few = distinct.len() < STOPPING_SHARE;
    let stops = |(at, row): (usize, &usize)| {
        let place = if few {
            at
        } else {
            distinct.partition_point(|other| *other < cycles[*row])
        };
        place % STOPPING_SHARE == number % STOPPING_SHARE
    };
    let (stopping, learnt): (Vec<_>, Vec<_>) = rows
        .iter()
        .enumerate()
        .partition(|(at, row)| stops((*at, row)));
    let of = |part: Vec<(usize, &usize)>| part.into_iter().map(|(_, row)| *row).collect();
    (of(learnt), of(stopping))
}
