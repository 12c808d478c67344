//! Neither the output's unit nor the order of the inputs matters.

use gsa::campaign::Campaign;
use gsa::law::distribution::Distribution;
use gsa::method::analysis::{Analysis, Status};
use gsa::method::{Kind, Method};
use proptest::prelude::*;
use proptest::strategy::ValueTree;
use proptest::test_runner::RngSeed;
use proptest::test_runner::TestRunner;

use super::contract::settings;
use crate::asking::until_enough;
use crate::random_study::{model, study};

fn found(
    inputs: &[Distribution],
    method: Method,
    run: impl Fn(&[f64]) -> f64,
) -> (Analysis, usize) {
    until_enough(Campaign::new(inputs, method).expect("a design"), run)
}

/// Returns all that does not carry the output's unit; where a moment is out of range, the reason says so too.
fn dimensionless(analysis: &Analysis) -> Analysis {
    Analysis {
        mean: None,
        variance: None,
        ..analysis.clone()
    }
}

fn largest_difference(a: &Option<Vec<f64>>, b: &Option<Vec<f64>>) -> f64 {
    match (a, b) {
        (Some(a), Some(b)) => {
            let differences = a.iter().zip(b).map(|(a, b)| (a - b).abs());
            differences.fold(0.0, f64::max)
        }
        (None, None) => 0.0,
        _ => f64::INFINITY,
    }
}

/// Some hundred roundings of values whose floor is below 1e-14.
const LAST_DIGITS: f64 = 1e-11;

fn claim(analysis: &Analysis) -> f64 {
    analysis.error.total.unwrap_or(1.0)
}

/// Sparse fits choose their terms by comparison. Where two terms are equally good the last digit decides, and the fits differ by a
/// part of what both miss, which their errors claim.
fn tie(kind: Kind, analysis: &Analysis) -> f64 {
    match kind {
        Kind::Pce | Kind::Auto => claim(analysis),
        _ => 0.0,
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 60, failure_persistence: None, rng_seed: RngSeed::Fixed(1), ..ProptestConfig::default() })]

    #[test]
    fn powers_of_two_change_no_bit(
        (inputs, coefficients, nodes, checks, seed) in study(),
        power in -900i32..900,
    ) {
        for kind in Kind::ALL {
            let method = settings(kind, inputs.len(), nodes, checks, seed);
            let (one, runs) = found(&inputs, method, |x| model(&coefficients, x));
            let unit = 2f64.powi(power);
            let (other, same_runs) = found(&inputs, method, |x| unit * model(&coefficients, x));
            prop_assert_eq!(runs, same_runs, "{:?}", kind);
            prop_assert_eq!(&one.first_order, &other.first_order, "{:?}", kind);
            prop_assert_eq!(&one.error, &other.error, "{:?}", kind);
            prop_assert_eq!(one.mean.map(|mean| mean * unit), other.mean, "{:?}", kind);
            if one.variance.is_some() == other.variance.is_some() {
                prop_assert_eq!(dimensionless(&one), dimensionless(&other), "{:?}", kind);
            }
        }
    }

    #[test]
    fn other_factors_change_the_last_digits(
        (inputs, coefficients, nodes, checks, seed) in study(),
        factor in prop_oneof![1e-6..1e6f64, -1e6..-1e-6f64],
    ) {
        for kind in Kind::ALL {
            let method = settings(kind, inputs.len(), nodes, checks, seed);
            let (one, runs) = found(&inputs, method, |x| model(&coefficients, x));
            let (other, same_runs) = found(&inputs, method, |x| factor * model(&coefficients, x));
            // Each value is rounded once, which the spread magnifies by 1/floor.
            if one.error.floor > 1e-14 || one.status == Status::Constant {
                continue;
            }
            let first_order = largest_difference(&one.first_order, &other.first_order);
            let total = largest_difference(&one.total, &other.total);
            if runs == same_runs && one.method == other.method {
                let bound = LAST_DIGITS + tie(kind, &one);
                prop_assert!(first_order.max(total) < bound, "{kind:?}: {first_order:e} {total:e} {one:?}");
            } else {
                // Two forms that miss the model equally may change places.
                let claimed = claim(&one) + claim(&other);
                prop_assert!(first_order <= claimed, "{kind:?}: {first_order:e} {one:?} {other:?}");
            }
        }
    }

    #[test]
    fn where_no_point_is_drawn_the_order_of_inputs_is_one_of_rounding(
        (inputs, coefficients, nodes, _, seed) in study(),
        turn in 1usize..5,
    ) {
        for kind in [Kind::Mdrm, Kind::Bivariate, Kind::Tensor] {
            let method = settings(kind, inputs.len(), nodes, 0, seed);
            let (one, other) = in_two_orders(&inputs, &coefficients, method, turn);
            if one.error.floor > 1e-14 || one.status == Status::Constant {
                continue;
            }
            prop_assert_eq!(one.status, other.status, "{:?}", kind);
            let difference = largest_difference(&one.first_order, &other.first_order)
                .max(largest_difference(&one.total, &other.total));
            prop_assert!(difference < LAST_DIGITS, "{kind:?}: {difference:e} {one:?}");
        }
    }
}

/// A study with its inputs as they are, and with its inputs rotated; the second answer is rotated back.
fn in_two_orders(
    inputs: &[Distribution],
    coefficients: &[[f64; 3]],
    method: Method,
    turn: usize,
) -> (Analysis, Analysis) {
    let (one, _) = found(inputs, method, |x| model(coefficients, x));
    let by = turn % inputs.len();
    let (mut inputs, mut coefficients) = (inputs.to_vec(), coefficients.to_vec());
    inputs.rotate_left(by);
    coefficients.rotate_left(by);
    let (mut other, _) = found(&inputs, method, |x| model(&coefficients, x));
    for list in [&mut other.first_order, &mut other.total]
        .into_iter()
        .flatten()
    {
        list.rotate_right(by);
    }
    (one, other)
}

/// Points drawn in another order are other points: two answers then differ by their errors, which cover 95 % each.
#[test]
fn where_points_are_drawn_the_order_of_inputs_is_one_of_the_claimed_errors() {
    const CASES: usize = 120;
    let mut runner = TestRunner::deterministic();
    let studies: Vec<_> = (0..CASES)
        .map(|_| study().new_tree(&mut runner).expect("a study").current())
        .filter(|(inputs, ..)| inputs.len() > 1)
        .collect();
    for kind in [Kind::Mdrm, Kind::Pce, Kind::Saltelli, Kind::Auto] {
        let (mut within, mut all) = (0, 0);
        for (inputs, coefficients, nodes, _, seed) in &studies {
            let method = settings(kind, inputs.len(), (*nodes).max(3), 8, *seed);
            let (one, other) = in_two_orders(inputs, coefficients, method, 1);
            let errors = one.error.total.zip(other.error.total);
            let Some((one_error, other_error)) = errors else {
                continue;
            };
            let difference = largest_difference(&one.first_order, &other.first_order);
            within += usize::from(difference <= one_error + other_error);
            all += 1;
        }
        println!(
            "{}: {within} of {all} within the claimed errors",
            kind.as_str()
        );
        assert!(
            all > CASES / 2 && within as f64 >= 0.95 * all as f64,
            "{kind:?}: {within} of {all}"
        );
    }
}
