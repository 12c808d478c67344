//! Whether the claimed errors of models with a symmetry cover the true ones, index by index, and how much less they are than without it.

use gsa::campaign::Campaign;
use gsa::method::analysis::Analysis;
use gsa::method::{Kind, Method};
use ndarray::Array2;

use crate::known::{Known, quantile};
use crate::models::families;

/// An index: what is claimed with and without the symmetry, and its true error.
struct Outcome {
    claimed: f64,
    alone: f64,
    truth: f64,
    /// Whether the claim is nearly all of what the form misses.
    of_form: bool,
}

/// Returns the percentage that is covered, with what the panels leave of the models' own indices.
fn covered(outcomes: &[Outcome], claim: fn(&Outcome) -> f64) -> f64 {
    let holds = outcomes.iter().filter(|o| o.truth <= claim(o) + 1e-6);
    100.0 * holds.count() as f64 / outcomes.len() as f64
}

/// Analyses of the place, the centre and the place's mirror image, without the symmetry and with it.
fn analyses([place, centre]: &[Known; 2], method: Method) -> [Vec<Analysis>; 2] {
    let n = place.inputs.len();
    let values = |points: &[Vec<f64>]| {
        let row = |x: &Vec<f64>| {
            let back: Vec<f64> = x.iter().rev().copied().collect();
            // The centre's sum in one order from both ends.
            let both = (place.model)(x) + (place.model)(&back);
            assert!((both - (centre.model)(x)).abs() <= 1e-9 * (1.0 + both.abs()));
            [(place.model)(x), both, (place.model)(&back)]
        };
        let rows: Vec<f64> = points.iter().flat_map(row).collect();
        Array2::from_shape_vec((points.len(), 3), rows).expect("three columns")
    };
    let mut campaign = Campaign::new(&place.inputs, method).expect("a valid campaign");
    loop {
        let values = values(campaign.points());
        let alone = campaign.tell(&values.view()).expect("rules exist");
        if campaign.points().len() > values.nrows() {
            continue;
        }
        let exchange: Vec<usize> = (0..n).rev().collect();
        // A line may have been refined alone.
        let symmetric = campaign.symmetric(&exchange);
        let found = symmetric.map(|s| s.analyse(&values.view(), &[2, 1, 0]).expect("rules exist"));
        return [alone.clone(), found.unwrap_or(alone)];
    }
}

fn outcomes(kind: Kind, seeds: std::ops::Range<u64>) -> [Vec<Outcome>; 2] {
    let mut all = [Vec::new(), Vec::new()];
    for seed in seeds {
        let method = Method {
            nodes: 5,
            check_points: 5,
            seed: seed + 1000,
            ..Method::of(kind)
        };
        for models in families::symmetric(seed) {
            let [alone, found] = analyses(&models, method);
            for (output, (known, outcomes)) in models.iter().zip(&mut all).enumerate() {
                outcomes.extend(of_output(known, &alone[output], &found[output]));
            }
        }
    }
    all
}

fn of_output(known: &Known, alone: &Analysis, found: &Analysis) -> Vec<Outcome> {
    let of_input = |input: usize| {
        let claim = |analysis: &Analysis| Some(analysis.error.by_input.as_ref()?[input]);
        let of_form = found.misses.as_ref().map(|misses| misses.errors()[input]);
        let error = found.first_order.as_ref()?[input] - known.first_order[input];
        Some(Outcome {
            claimed: claim(found)?,
            alone: claim(alone)?,
            truth: error.abs().max(found.error.floor),
            of_form: of_form.is_some_and(|e| e > 0.9 * claim(found).unwrap_or(1.0)),
        })
    };
    (0..known.inputs.len()).filter_map(of_input).collect()
}

#[test]
fn claims_of_symmetric_models_cover_the_true_errors_and_are_smaller() {
    println!(
        "method, output   indices   covered (alone)   claimed/true   claimed/alone, of the form"
    );
    for (kind, seeds) in [
        (Kind::Mdrm, 0..80),
        (Kind::Bivariate, 0..6),
        (Kind::Auto, 0..2),
    ] {
        for (place, outcomes) in ["place", "centre"].iter().zip(outcomes(kind, seeds)) {
            let (share, alone) = (
                covered(&outcomes, |o| o.claimed),
                covered(&outcomes, |o| o.alone),
            );
            let ratio = quantile(outcomes.iter().map(|o| o.claimed / o.truth).collect(), 0.5);
            let of_form = outcomes.iter().filter(|o| o.of_form || kind != Kind::Mdrm);
            let gain = quantile(of_form.map(|o| o.claimed / o.alone).collect(), 0.5);
            println!(
                "{:9} {place:6} {:8}   {share:5.1} % ({alone:.1} %)   {ratio:8.1}   {gain:8.2}",
                kind.as_str(),
                outcomes.len()
            );
            assert!(share >= 95.0, "{kind:?} {place}: {share}");
            assert!(gain < 0.9 || kind != Kind::Mdrm, "{kind:?} {place}: {gain}");
        }
    }
}
