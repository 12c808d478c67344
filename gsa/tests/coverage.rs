//! Whether the claimed error of the first-order indices covers the true one, and is not vacuous, on random models.

mod models;

use std::collections::BTreeMap;

use gsa::analysis::analyse;
use gsa::design::Design;
use models::families;
use ndarray::Array2;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;

/// Claimed and true error, the latter no less than the rounding floor.
type Outcome = (f64, f64);

fn quantile(mut values: Vec<f64>, share: f64) -> f64 {
    values.sort_by(f64::total_cmp);
    values[((values.len() - 1) as f64 * share) as usize]
}

fn covered(outcomes: &[Outcome]) -> f64 {
    let count = outcomes.iter().filter(|(claimed, truth)| truth <= claimed);
    100.0 * count.count() as f64 / outcomes.len() as f64
}

fn ratios(outcomes: &[Outcome]) -> Vec<f64> {
    outcomes
        .iter()
        .map(|(claimed, truth)| claimed / truth)
        .collect()
}

/// Prints a line per family and returns all outcomes.
fn print(table: &BTreeMap<&str, Vec<Outcome>>) -> Vec<Outcome> {
    println!(
        "{:38} covered   claimed/true: 10 %  median     90 %   median true",
        "family"
    );
    for (family, outcomes) in table {
        let ratio = |share| quantile(ratios(outcomes), share);
        println!(
            "{family:38} {:5.1} %               {:6.2}  {:6.2} {:8.1}   {:.1e}",
            covered(outcomes),
            ratio(0.1),
            ratio(0.5),
            ratio(0.9),
            quantile(outcomes.iter().map(|(_, truth)| *truth).collect(), 0.5),
        );
    }
    table.values().flatten().copied().collect()
}

/// The three forms on lines and check points. The seeds are fixed; the constants of the estimates were set on these
/// families, so that other models are the test proper (`error_bar` in `closed_models`).
#[test]
fn claimed_errors_of_the_forms_cover_the_true_ones() {
    for (nodes, checks) in [(5, 5), (7, 10), (9, 10)] {
        let mut table: BTreeMap<&str, Vec<Outcome>> = BTreeMap::new();
        for seed in 0..60 {
            for known in families::all(seed) {
                let mut rng = ChaCha8Rng::seed_from_u64(seed + 1000);
                let design = Design::new(&known.inputs, nodes, checks, &mut rng).unwrap();
                let values = design.points().iter().map(|x| (known.model)(x)).collect();
                let values = Array2::from_shape_vec((design.points().len(), 1), values).unwrap();
                let found = analyse(&design, &values.view()).remove(0);
                let Some(first_order) = &found.first_order else {
                    continue;
                };
                let truth = known.error_of(first_order).max(found.error.floor);
                let outcome = (found.error.total.unwrap(), truth);
                table.entry(known.family).or_default().push(outcome);
            }
        }
        println!("{nodes} nodes, {checks} check points");
        let all = print(&table);
        let median = quantile(ratios(&all), 0.5);
        println!(
            "all {:.1} %, median claimed/true {median:.1}\n",
            covered(&all)
        );
        assert!(covered(&all) >= 95.0 && median <= 10.0);
    }
}
