//! Properties of every output, whatever its shape.

use gsa::design::Design;
use gsa::law::distribution::Distribution;
use gsa::method::analysis::{Analysis, Status};
use gsa::method::lines::analyse;
use ndarray::Array2;
use proptest::prelude::*;
use proptest::test_runner::RngSeed;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;

use crate::random_study::{any_value, model, study};

fn run(design: &Design, coefficients: &[[f64; 3]]) -> Array2<f64> {
    let values = design
        .points()
        .iter()
        .map(|x| model(coefficients, x))
        .collect();
    Array2::from_shape_vec((design.points().len(), 1), values).expect("one value per point")
}

fn make(inputs: &[Distribution], nodes: usize, check_points: usize, seed: u64) -> Design {
    Design::new(
        inputs,
        nodes,
        check_points,
        &mut ChaCha8Rng::seed_from_u64(seed),
    )
    .expect("a valid design")
}

fn largest_difference(a: &Option<Vec<f64>>, b: &Option<Vec<f64>>) -> f64 {
    match (a, b) {
        (Some(a), Some(b)) => a
            .iter()
            .zip(b)
            .map(|(a, b)| (a - b).abs())
            .fold(0.0, f64::max),
        (None, None) => 0.0,
        _ => f64::INFINITY,
    }
}

/// Indices and everything else that does not carry the output's unit.
fn dimensionless(analysis: &Analysis) -> Analysis {
    Analysis {
        mean: None,
        variance: None,
        ..analysis.clone()
    }
}

/// n sums and logarithms of a few eps each.
const ROUNDING: f64 = 1e-14;

proptest! {
    #![proptest_config(ProptestConfig { cases: 400, max_global_rejects: 100_000, failure_persistence: None, rng_seed: RngSeed::Fixed(1), ..ProptestConfig::default() })]

    #[test]
    fn indices_are_shares((inputs, coefficients, nodes, checks, seed) in study()) {
        let design = make(&inputs, nodes, checks, seed);
        let found = analyse(&design, &run(&design, &coefficients).view()).remove(0);
        let pairs = [
            (&found.first_order, &found.total),
            (&found.mdrm_first_order, &found.mdrm_total),
        ];
        for (first_order, total) in pairs {
            let (Some(first_order), Some(total)) = (first_order, total) else {
                prop_assert!(first_order.is_none() && total.is_none());
                continue;
            };
            for (s, t) in first_order.iter().zip(total) {
                prop_assert!((0.0..=1.0).contains(s) && (0.0..=1.0).contains(t), "{found:?}");
                prop_assert!(*s <= t + ROUNDING, "{found:?}");
            }
            prop_assert!(first_order.iter().sum::<f64>() <= 1.0 + ROUNDING, "{found:?}");
            prop_assert!(total.iter().sum::<f64>() >= 1.0 - ROUNDING, "{found:?}");
        }
        let error = &found.error;
        for part in [error.quadrature, error.decomposition, Some(error.floor), error.total].into_iter().flatten() {
            prop_assert!((0.0..=1.0).contains(&part), "{found:?}");
        }
        prop_assert!(found.status == Status::Ok || found.reason.is_some(), "{found:?}");
    }

    #[test]
    fn a_change_of_unit_changes_no_index(
        (inputs, coefficients, nodes, checks, seed) in study(),
        power in -900i32..900,
        factor in prop_oneof![1e-6..1e6f64, -1e6..-1e-6f64],
    ) {
        let design = make(&inputs, nodes, checks, seed);
        let values = run(&design, &coefficients);
        let found = analyse(&design, &values.view()).remove(0);
        // Powers of two cost no digit: the answer is the same to the bit.
        let scaled = values.mapv(|y| y * 2f64.powi(power));
        let exact = analyse(&design, &scaled.view()).remove(0);
        if exact.variance.is_some() && found.variance.is_some() {
            prop_assert_eq!(dimensionless(&exact), dimensionless(&found));
        }
        prop_assert_eq!(&exact.first_order, &found.first_order);
        prop_assert_eq!(exact.mean, found.mean.map(|mean| mean * 2f64.powi(power)));
        // Other factors round each value once, which the spread magnifies by 1/floor.
        let other = analyse(&design, &values.mapv(|y| y * factor).view()).remove(0);
        prop_assume!(found.error.floor < 1e-14 && other.status == found.status);
        prop_assert!(largest_difference(&other.first_order, &found.first_order) < 1e-12);
        prop_assert!(largest_difference(&other.total, &found.total) < 1e-12);
    }

    #[test]
    fn inputs_may_be_listed_in_any_order((inputs, coefficients, nodes, _, seed) in study(), turn in 0usize..5) {
        let design = make(&inputs, nodes, 0, seed);
        let found = analyse(&design, &run(&design, &coefficients).view()).remove(0);
        let (mut inputs, mut coefficients) = (inputs, coefficients);
        let by = turn % inputs.len();
        inputs.rotate_left(by);
        coefficients.rotate_left(by);
        let design = make(&inputs, nodes, 0, seed);
        let mut other = analyse(&design, &run(&design, &coefficients).view()).remove(0);
        for list in [&mut other.first_order, &mut other.total].into_iter().flatten() {
            list.rotate_right(by);
        }
        // The model's own sum and product round differently in another order.
        prop_assume!(found.error.floor < 1e-14 && other.status == found.status);
        prop_assert!(largest_difference(&other.first_order, &found.first_order) < 1e-12);
        prop_assert!(largest_difference(&other.total, &found.total) < 1e-12);
    }

    #[test]
    fn no_values_whatever_bring_out_nan_or_infinity(
        (inputs, _, nodes, checks, seed) in study(),
        pool in prop::collection::vec(any_value(), 1..12),
    ) {
        let design = make(&inputs, nodes, checks, seed);
        let values = Array2::from_shape_fn((design.points().len(), 1), |(k, _)| pool[k * 7 % pool.len()]);
        let found = analyse(&design, &values.view()).remove(0);
        let lists = [&found.first_order, &found.total, &found.mdrm_first_order, &found.mdrm_total];
        for index in lists.into_iter().flatten().flatten() {
            prop_assert!((0.0..=1.0).contains(index), "{found:?}");
        }
        prop_assert!(found.mean.is_none_or(f64::is_finite), "{found:?}");
        prop_assert!(found.variance.is_none_or(|v| v.is_finite() && v >= 0.0), "{found:?}");
        let error = &found.error;
        for part in [error.quadrature, error.decomposition, Some(error.floor), error.total].into_iter().flatten() {
            prop_assert!((0.0..=1.0).contains(&part), "{found:?}");
        }
        let finite = |k: &usize| values[[*k, 0]].is_finite();
        let lost = design.lines().iter().any(|line| {
            let left = line.ordinals().iter().filter(|k| finite(k)).count();
            left < line.ordinals().len() && left < 3
        });
        prop_assert_eq!(found.status == Status::Unusable, lost || !finite(&0) || nodes == 1);
        prop_assert_eq!(found.first_order.is_some(), found.total.is_some());
    }
}
