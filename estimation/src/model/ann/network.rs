//! A network's layers, its loss, and the loss's gradient by backward propagation.
//!
//! Layer l turns a row a into act(a W_l + b_l). The loss of n rows is its mean over the rows plus decay/(2 n) times the squared weights, as
//! scikit-learn's `MLPRegressor` has it.

use ndarray::{Array1, Array2, ArrayView1, ArrayView2, Axis};
use rand::RngExt;
use rand_chacha::ChaCha8Rng;

use super::activation::{activate, by_sums};
use crate::model::box_search::{Patience, least};
use crate::recipe::{Activation, Loss};

/// Largest exponent of Poisson's mean: beyond, a step has gone astray.
const LARGEST_EXPONENT: f64 = 50.0;

/// Sizes and activations.
#[derive(Debug, Clone, PartialEq)]
pub struct Shape {
    /// Nodes of each layer, the features first, one node last.
    pub sizes: Vec<usize>,
    /// Activation of hidden layers.
    pub hidden: Activation,
    /// Activation of the last layer.
    pub output: Activation,
    /// Loss that training makes small.
    pub loss: Loss,
    /// Weight of the squared weights.
    pub decay: f64,
}

/// Weights of all layers in a row: W_1 (by features), b_1, W_2, ..
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Network<'s> {
    shape: &'s Shape,
    weights: &'s [f64],
}

impl Shape {
    /// Counts the weights.
    pub fn weights(&self) -> usize {
        self.sizes
            .windows(2)
            .map(|pair| pair[0] * pair[1] + pair[1])
            .sum()
    }

    /// Weights to begin with, evenly drawn within the root of 6/(nodes before + nodes after) (Glorot and Bengio 2010, eq. 16); biases, too, as scikit-learn does.
    pub fn drawn(&self, generator: &mut ChaCha8Rng) -> Vec<f64> {
        let mut weights = Vec::with_capacity(self.weights());
        for pair in self.sizes.windows(2) {
            let sum = (pair[0] + pair[1]) as f64;
            let bound = (if self.hidden == Activation::Sigmoid {
                2.0
            } else {
                6.0
            } / sum)
                .sqrt();
            let count = pair[0] * pair[1] + pair[1];
            weights.extend((0..count).map(|_| generator.random_range(-bound..bound)));
        }
        weights
    }

    /// Returns the places where each layer's weights and biases begin.
    fn layers(&self) -> Vec<(usize, usize, usize)> {
        let mut begin = 0;
        let layer = |pair: &[usize]| {
            let layer = (begin, pair[0], pair[1]);
            begin += pair[0] * pair[1] + pair[1];
            layer
        };
        self.sizes.windows(2).map(layer).collect()
    }
}

impl<'s> Network<'s> {
    /// A network of this shape, which must have so many weights.
    ///
    /// # Panics
    /// When it has others.
    pub fn new(shape: &'s Shape, weights: &'s [f64]) -> Self {
        assert_eq!(weights.len(), shape.weights(), "weights of the network");
        Self { shape, weights }
    }

    fn matrix(&self, (begin, from, to): (usize, usize, usize)) -> ArrayView2<'s, f64> {
        ArrayView2::from_shape((from, to), &self.weights[begin..begin + from * to])
            .expect("as many as its shape says")
    }

    fn biases(&self, (begin, from, to): (usize, usize, usize)) -> ArrayView1<'s, f64> {
        ArrayView1::from(&self.weights[begin + from * to..begin + from * to + to])
    }

    fn activation(&self, layer: usize) -> Activation {
        if layer + 2 == self.shape.sizes.len() {
            self.shape.output
        } else {
            self.shape.hidden
        }
    }

    /// Values of all layers for rows x features, the features first.
    fn forward(&self, rows: &ArrayView2<f64>) -> Vec<Array2<f64>> {
        let mut values = vec![rows.to_owned()];
        for (number, layer) in self.shape.layers().into_iter().enumerate() {
            let mut z = values[number].dot(&self.matrix(layer)) + self.biases(layer);
            for mut row in z.rows_mut() {
                activate(
                    self.activation(number),
                    row.as_slice_mut().expect("rows lie in a row"),
                );
            }
            values.push(z);
        }
        values
    }

    /// The output of one row of features.
    pub fn output(&self, features: &[f64]) -> f64 {
        let mut values = features.to_vec();
        for (number, layer) in self.shape.layers().into_iter().enumerate() {
            let (begin, from, to) = layer;
            let mut z = self.biases(layer).to_vec();
            for (x, row) in values
                .iter()
                .zip(self.weights[begin..begin + from * to].chunks_exact(to))
            {
                for (z, w) in z.iter_mut().zip(row) {
                    *z += x * w;
                }
            }
            activate(self.activation(number), &mut z);
            values = z;
        }
        values[0]
    }

    /// The loss without decay.
    pub fn error(&self, rows: &ArrayView2<f64>, targets: &ArrayView1<f64>) -> f64 {
        let values = self.forward(rows);
        self.mean_error(values[values.len() - 1].column(0), targets)
    }

    fn mean_error(&self, outputs: ArrayView1<'_, f64>, targets: &ArrayView1<f64>) -> f64 {
        let pairs = outputs.iter().zip(targets);
        let sum: f64 = match self.shape.loss {
            Loss::Mse => pairs.map(|(o, t)| 0.5 * (o - t) * (o - t)).sum(),
            Loss::Poisson => pairs
                .map(|(o, t)| o.min(LARGEST_EXPONENT).exp() - t * o)
                .sum(),
        };
        sum / targets.len().max(1) as f64
    }

    /// The loss and its gradient by the weights.
    pub fn loss(&self, rows: &ArrayView2<f64>, targets: &ArrayView1<f64>) -> (f64, Vec<f64>) {
        let count = targets.len().max(1) as f64;
        let values = self.forward(rows);
        let outputs = values[values.len() - 1].column(0);
        let decay = self.shape.decay / count;
        let mut loss = self.mean_error(outputs, targets);
        let mut gradient = vec![0.0; self.weights.len()];
        let by_output = |(o, t): (&f64, &f64)| match self.shape.loss {
            Loss::Mse => (o - t) / count,
            Loss::Poisson => (o.min(LARGEST_EXPONENT).exp() - t) / count,
        };
        let derivatives: Array1<f64> = outputs.iter().zip(targets).map(by_output).collect();
        let mut derivatives = derivatives.insert_axis(Axis(1));
        for (number, layer) in self.shape.layers().into_iter().enumerate().rev() {
            let (begin, from, to) = layer;
            for (value, mut row) in values[number + 1]
                .rows()
                .into_iter()
                .zip(derivatives.rows_mut())
            {
                let value = value.as_slice().expect("rows lie in a row");
                by_sums(
                    self.activation(number),
                    value,
                    row.as_slice_mut().expect("rows lie in a row"),
                );
            }
            let matrix = self.matrix(layer);
            loss += 0.5 * decay * matrix.iter().map(|w| w * w).sum::<f64>();
            let by_matrix = values[number].t().dot(&derivatives) + &matrix * decay;
            let place = &mut gradient[begin..begin + from * to + to];
            let found = by_matrix
                .iter()
                .copied()
                .chain(derivatives.sum_axis(Axis(0)));
            place
                .iter_mut()
                .zip(found)
                .for_each(|(place, g)| *place = g);
            derivatives = derivatives
                .dot(&matrix.t())
                .as_standard_layout()
                .into_owned();
        }
        (loss, gradient)
    }
}

/// Trains weights from a start; `watch` is told of the weights of each look and ends the training by saying no. None where the start has no finite loss.
pub fn train(
    shape: &Shape,
    start: &[f64],
    rows: &ArrayView2<f64>,
    targets: &ArrayView1<f64>,
    iterations: usize,
    watch: &dyn Fn(&[f64]) -> bool,
) -> Option<(Vec<f64>, f64)> {
    let look =
        |weights: &[f64]| watch(weights).then(|| Network::new(shape, weights).loss(rows, targets));
    let patience = Patience {
        iterations,
        gradient: 1e-6,
        change: 1e-10,
    };
    least(&look, None, start, patience).map(|found| (found.point, found.value))
}

#[cfg(test)]
mod tests {
    use super::*;
    use rand_chacha::rand_core::SeedableRng;

    const ACTIVATIONS: [Activation; 6] = [
        Activation::Linear,
        Activation::Sigmoid,
        Activation::Tanh,
        Activation::Relu,
        Activation::Elu,
        Activation::Softmax,
    ];

    /// Central differences of step h are off by h^2 times a third derivative of order 1, and by rounding over h: 1e-10 at h = 1e-5.
    #[test]
    fn gradients_are_those_of_differences() {
        let rows = Array2::from_shape_fn((7, 3), |(i, j)| ((1 + i * 5 + j * 3) as f64 * 0.7).sin());
        let targets: Array1<f64> = (0..7).map(|i| 1.0 + (i as f64).cos()).collect();
        for hidden in ACTIVATIONS {
            for (output, loss) in [
                (Activation::Linear, Loss::Mse),
                (Activation::Sigmoid, Loss::Mse),
                (Activation::Elu, Loss::Mse),
                (Activation::Linear, Loss::Poisson),
            ] {
                let shape = Shape {
                    sizes: vec![3, 5, 4, 1],
                    hidden,
                    output,
                    loss,
                    decay: 0.1,
                };
                let weights = shape.drawn(&mut ChaCha8Rng::seed_from_u64(3));
                let at = |weights: &[f64]| {
                    Network::new(&shape, weights).loss(&rows.view(), &targets.view())
                };
                let (_, gradient) = at(&weights);
                for (place, g) in gradient.iter().enumerate() {
                    let moved = |h: f64| {
                        let mut moved = weights.clone();
                        moved[place] += h;
                        at(&moved).0
                    };
                    let difference = (moved(1e-5) - moved(-1e-5)) / 2e-5;
                    assert!(
                        (g - difference).abs() < 1e-7,
                        "{hidden:?} {output:?} {place}: {g} {difference}"
                    );
                }
            }
        }
    }

    #[test]
    fn one_row_is_all_rows() {
        let shape = Shape {
            sizes: vec![2, 4, 1],
            hidden: Activation::Softmax,
            output: Activation::Linear,
            loss: Loss::Mse,
            decay: 0.0,
        };
        let weights = shape.drawn(&mut ChaCha8Rng::seed_from_u64(1));
        let network = Network::new(&shape, &weights);
        let target = network.output(&[0.3, -0.8]);
        let row = ndarray::array![[0.3, -0.8]];
        assert!(network.error(&row.view(), &ndarray::array![target].view()) < 1e-30);
    }
}
