//! Random laws and models for property tests.

use gsa::law::distribution::Distribution;
use proptest::prelude::*;

fn law() -> impl Strategy<Value = Distribution> {
    prop_oneof![
        (-3.0..3.0, 0.1..2.0).prop_map(|(min, width)| Distribution::uniform(min, min + width)),
        (-3.0..3.0, 0.01..1.0).prop_map(|(mean, std)| Distribution::normal(mean, std)),
        (-1.0..1.0, 0.01..0.5).prop_map(|(mu, sigma)| Distribution::lognormal(mu, sigma)),
    ]
    .prop_map(|law| law.expect("parameters in range"))
}

/// Laws, coefficients of a model that is neither a product nor a sum, nodes, check points, a seed.
pub fn study() -> impl Strategy<Value = (Vec<Distribution>, Vec<[f64; 3]>, usize, usize, u64)> {
    (1usize..6).prop_flat_map(|n| {
        (
            prop::collection::vec(law(), n),
            prop::collection::vec(prop::array::uniform3(-1.0..1.0f64), n),
            1usize..8,
            0usize..8,
            any::<u64>(),
        )
    })
}

/// A product of quadratics plus a sum of sines.
pub fn model(coefficients: &[[f64; 3]], x: &[f64]) -> f64 {
    let product: f64 = coefficients
        .iter()
        .zip(x)
        .map(|([a, b, _], x)| 1.5 + a * x + b * x * x)
        .product();
    let sum: f64 = coefficients
        .iter()
        .zip(x)
        .map(|([_, _, c], x)| (c * x).sin())
        .sum();
    product + sum
}

/// Any double, the ordinary ones most often.
pub fn any_value() -> impl Strategy<Value = f64> {
    use prop::num::f64::{INFINITE, NORMAL, QUIET_NAN, SUBNORMAL, ZERO};
    prop_oneof![
        8 => -10.0..10.0f64,
        4 => NORMAL | SUBNORMAL | ZERO,
        1 => NORMAL | INFINITE | QUIET_NAN,
    ]
}
