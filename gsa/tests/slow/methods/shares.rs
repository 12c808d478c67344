//! Indices are shares of a variance, whatever the values.

use gsa::campaign::Campaign;
use gsa::method::Kind;
use proptest::prelude::*;
use proptest::test_runner::RngSeed;

use super::contract::{fault, settings};
use crate::asking::to_the_end;
use crate::random_study::{any_value, model, study};

/// n sums and logarithms of a few eps each.
const ROUNDING: f64 = 1e-14;

proptest! {
    #![proptest_config(ProptestConfig { cases: 80, failure_persistence: None, rng_seed: RngSeed::Fixed(1), ..ProptestConfig::default() })]

    #[test]
    fn indices_are_shares((inputs, coefficients, nodes, checks, seed) in study()) {
        for kind in Kind::ALL {
            let method = settings(kind, inputs.len(), nodes, checks, seed);
            let campaign = Campaign::new(&inputs, method).expect("a design");
            let (found, _) = to_the_end(campaign, |_, x| model(&coefficients, x));
            prop_assert!(fault(&found).is_none(), "{kind:?}: {:?} {found:?}", fault(&found));
            let (Some(first_order), Some(total)) = (&found.first_order, &found.total) else {
                continue;
            };
            prop_assert!(first_order.iter().sum::<f64>() <= 1.0 + ROUNDING, "{kind:?}: {found:?}");
            // Samples estimate each index by itself, which orders them in the limit only.
            let ordered = first_order.iter().zip(total).all(|(s, t)| *s <= t + ROUNDING);
            prop_assert!(ordered || kind == Kind::Saltelli, "{kind:?}: {found:?}");
        }
    }

    #[test]
    fn no_values_whatever_bring_out_nan_or_infinity(
        (inputs, _, nodes, checks, seed) in study(),
        pool in prop::collection::vec(any_value(), 1..12),
    ) {
        for kind in Kind::ALL {
            let method = settings(kind, inputs.len(), nodes, checks, seed);
            let campaign = Campaign::new(&inputs, method).expect("a design");
            let (found, _) = to_the_end(campaign, |ordinal, _| pool[ordinal * 7 % pool.len()]);
            prop_assert!(fault(&found).is_none(), "{kind:?}: {:?} {found:?}", fault(&found));
        }
    }
}
