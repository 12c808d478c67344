//! Whether the claimed error of the first-order indices covers the true one, and is not vacuous, on random models.

mod differences;
mod symmetric;

use std::collections::BTreeMap;

use gsa::campaign::Campaign;
use gsa::method::analysis::Analysis;
use gsa::method::{Kind, Method};
use ndarray::Array2;

use crate::asking::until_enough;
use crate::known::{Known, quantile};
use crate::models::families;

/// Claimed and true error, the latter no less than the rounding floor.
type Outcome = (f64, f64);

/// Error that the panels leave of the models' own indices: 6e-7 for eighth powers of lognormals, by another rule.
const REFERENCE_ERROR: f64 = 1e-6;

fn covered(outcomes: &[Outcome]) -> f64 {
    let holds = |(claimed, truth): &&Outcome| *truth <= claimed + REFERENCE_ERROR;
    let count = outcomes.iter().filter(holds);
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

/// Share covered in percent and median of claimed over true, over all families and these seeds.
fn coverage(
    title: &str,
    seeds: std::ops::Range<u64>,
    method: impl FnMut(&Known, u64) -> Option<Method>,
) -> (f64, f64) {
    coverage_of(title, seeds, method, run)
}

/// Measures as [`coverage`] does, of what `run` says.
fn coverage_of(
    title: &str,
    seeds: std::ops::Range<u64>,
    mut method: impl FnMut(&Known, u64) -> Option<Method>,
    run: impl Fn(&Known, Method) -> (Analysis, usize),
) -> (f64, f64) {
    let mut table: BTreeMap<&str, Vec<Outcome>> = BTreeMap::new();
    let mut runs = Vec::new();
    for seed in seeds {
        for known in families::all(seed) {
            let Some(method) = method(&known, seed) else {
                continue;
            };
            let (found, count) = run(&known, method);
            let Some(first_order) = &found.first_order else {
                continue;
            };
            let truth = known.error_of(first_order).max(found.error.floor);
            let claimed = found.error.total.expect("an error beside indices");
            table
                .entry(known.family)
                .or_default()
                .push((claimed, truth));
            runs.push(count as f64);
        }
    }
    println!("{title}");
    let all = print(&table);
    let (share, median) = (covered(&all), quantile(ratios(&all), 0.5));
    let runs = quantile(runs, 0.5);
    println!(
        "all {share:.1} % of {}, median claimed/true {median:.1}, median runs {runs}\n",
        all.len()
    );
    (share, median)
}

/// Asks and tells until the method has enough.
fn run(known: &Known, method: Method) -> (Analysis, usize) {
    let campaign = Campaign::new(&known.inputs, method).expect("a valid campaign");
    until_enough(campaign, &known.model)
}

/// Returns what a method says of an output among thousands.
fn surveyed(known: &Known, method: Method) -> (Analysis, usize) {
    let campaign = Campaign::new(&known.inputs, method).expect("a valid campaign");
    let values: Vec<f64> = campaign.points().iter().map(|x| (known.model)(x)).collect();
    let values = Array2::from_shape_vec((values.len(), 1), values).expect("a column");
    let found = campaign.survey(&values.view()).expect("rules exist");
    (found.into_iter().next().expect("an output"), values.len())
}

fn seeded(kind: Kind, seed: u64) -> Method {
    Method {
        seed: seed + 1000,
        ..Method::of(kind)
    }
}

/// The three forms on lines and check points. The seeds are fixed; the constants of the estimates were set on these
/// families, so that other models are the test proper (`error_bar` in `closed_models`).
#[test]
fn claimed_errors_of_the_forms_cover_the_true_ones() {
    for (nodes, check_points) in [(5, 5), (7, 10), (9, 10)] {
        let title = format!("mdrm: {nodes} nodes, {check_points} check points");
        let (share, median) = coverage(&title, 0..60, |_, seed| {
            Some(Method {
                nodes,
                check_points,
                ..seeded(Kind::Mdrm, seed)
            })
        });
        assert!(share >= 95.0 && median <= 10.0, "{title}");
    }
}

#[test]
fn claimed_errors_of_the_other_methods() {
    let seeds = 20..28;
    let kinds = [
        Kind::Bivariate,
        Kind::Tensor,
        Kind::Pce,
        Kind::Saltelli,
        Kind::Auto,
    ];
    for kind in kinds {
        let (share, median) = coverage(kind.as_str(), seeds.clone(), |known, seed| {
            let inputs = known.inputs.len();
            let affordable = match kind {
                Kind::Tensor => inputs <= 4,
                Kind::Bivariate => inputs <= 12,
                _ => true,
            };
            let method = Method {
                samples: if kind == Kind::Saltelli { 256 } else { 100 },
                most_runs: 200,
                ..seeded(kind, seed)
            };
            affordable.then_some(method)
        });
        // `auto` doubles the claims of lines that it didn't refine: 11.7 here, 10.6 over twice as many seeds.
        let most = if kind == Kind::Auto { 12.0 } else { 10.0 };
        assert!(
            share >= 95.0 && median <= most,
            "{kind:?}: {share} {median}"
        );
    }
}

#[test]
fn claimed_errors_of_a_survey_by_polynomials() {
    let method = |_: &Known, seed| {
        Some(Method {
            samples: 200,
            ..seeded(Kind::Pce, seed)
        })
    };
    let (share, median) = coverage_of("pce, survey", 20..28, method, surveyed);
    assert!(share >= 95.0 && median <= 10.0, "{share} {median}");
}
