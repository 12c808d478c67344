//! Activations: what a layer's nodes make of their sums z, and what a change of that means for the sums.

use crate::recipe::Activation;

/// Turns a row of sums into the nodes' values, in place.
pub(crate) fn activate(activation: Activation, z: &mut [f64]) {
    match activation {
        Activation::Linear => {}
        Activation::Sigmoid => z.iter_mut().for_each(|z| *z = 1.0 / (1.0 + (-*z).exp())),
        Activation::Tanh => z.iter_mut().for_each(|z| *z = z.tanh()),
        Activation::Relu => z.iter_mut().for_each(|z| *z = z.max(0.0)),
        Activation::Elu => z
            .iter_mut()
            .for_each(|z| *z = if *z < 0.0 { z.exp_m1() } else { *z }),
        Activation::Softmax => {
            let most = z.iter().copied().fold(f64::NEG_INFINITY, f64::max);
            z.iter_mut().for_each(|z| *z = (*z - most).exp());
            let sum: f64 = z.iter().sum();
            z.iter_mut().for_each(|z| *z /= sum);
        }
    }
}

/// Turns the loss's derivatives by a row's values into those by its sums, in place; `values` are the nodes' values.
pub(crate) fn by_sums(activation: Activation, values: &[f64], derivatives: &mut [f64]) {
    let slope = |value: f64| match activation {
        Activation::Linear | Activation::Softmax => 1.0,
        Activation::Sigmoid => value * (1.0 - value),
        Activation::Tanh => 1.0 - value * value,
        Activation::Relu => f64::from(value > 0.0),
        Activation::Elu => value.min(0.0) + 1.0,
    };
    if activation == Activation::Softmax {
        // dv_i/dz_j = v_i (d_ij - v_j)
        let sum: f64 = values
            .iter()
            .zip(derivatives.iter())
            .map(|(v, d)| v * d)
            .sum();
        derivatives
            .iter_mut()
            .zip(values)
            .for_each(|(d, v)| *d = v * (*d - sum));
    } else {
        derivatives
            .iter_mut()
            .zip(values)
            .for_each(|(d, v)| *d *= slope(*v));
    }
}
