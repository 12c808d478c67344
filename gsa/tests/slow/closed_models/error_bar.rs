//! Whether the claimed error of the first-order indices covers the true one, on models whose indices are known.

use std::collections::BTreeSet;

use gsa::method::analysis::Status;
use gsa::method::lines::analyse;

use super::closed_model;

const SEEDS: u64 = 100;

/// Claimed and true error of one analysis, and whether the product form answered.
struct Outcome {
    claimed: f64,
    truth: f64,
    product: bool,
}

fn outcomes(
    model: &closed_model::Model,
    cut: &str,
    nodes: usize,
    check_points: usize,
) -> Vec<Outcome> {
    (0..SEEDS)
        .filter_map(|seed| {
            let design = model.design(cut, nodes, check_points, seed);
            let analysis = analyse(&design, &model.run(&design).view()).remove(0);
            let first_order = analysis.first_order?;
            let differences = first_order
                .iter()
                .zip(&model.exact.first_order)
                .map(|(f, e)| (f - e).abs());
            Some(Outcome {
                claimed: analysis.error.total.expect("check points give an error"),
                truth: differences.fold(0.0, f64::max),
                product: analysis.status == Status::Ok,
            })
        })
        .collect()
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}

/// Reference indices are exact to 2e-10 at worst, and rounding leaves as much in the steepest models.
const REFERENCE_ERROR: f64 = 1e-9;

/// Prints a line per model and cut point; returns the number of analyses covered and made.
fn coverage(nodes: usize, check_points: usize) -> (usize, usize) {
    let (mut covered, mut all) = (0, 0);
    for model in closed_model::all() {
        let cuts: BTreeSet<&str> = model.references.iter().map(|r| r.cut.as_str()).collect();
        for cut in cuts {
            let outcomes = outcomes(&model, cut, nodes, check_points);
            if outcomes.is_empty() {
                continue;
            }
            let holds = outcomes
                .iter()
                .filter(|o| o.truth <= o.claimed + REFERENCE_ERROR)
                .count();
            println!(
                "{:26} {cut:8} product {:3}  covered {holds:3} of {:3}  median true {:.1e} claimed {:.1e}",
                model.name,
                outcomes.iter().filter(|o| o.product).count(),
                outcomes.len(),
                median(outcomes.iter().map(|o| o.truth).collect()),
                median(outcomes.iter().map(|o| o.claimed).collect()),
            );
            covered += holds;
            all += outcomes.len();
        }
    }
    (covered, all)
}

/// Shares seen over 2000 analyses a row: 95.7 to 98.4 % (5 check points), 98.6 to 99.9 % (10), 99.7 to 100 % (20).
/// The seeds are fixed, so the asserted shares need no slack for chance: they are the worst seen, rounded down.
#[test]
fn the_claimed_error_covers_the_true_one() {
    for (check_points, least) in [(5, 0.95), (10, 0.98), (20, 0.99)] {
        for nodes in [3, 5, 7] {
            println!("{nodes} nodes, {check_points} check points:");
            let (covered, all) = coverage(nodes, check_points);
            let share = covered as f64 / all as f64;
            println!("covered {covered} of {all}: {:.1} %\n", 100.0 * share);
            assert!(
                share >= least,
                "{nodes} nodes, {check_points} check points: only {share} covered"
            );
        }
    }
}
