//! Gauss rules against extended precision: nodes, weights and moments computed from moments with 400 digits.

use gsa::law::distribution::Distribution;
use gsa::law::rule::GaussRule;
use serde_json::Value;

use crate::law_data::{entries, list, named_law, numbers};

struct Case {
    name: String,
    law: Distribution,
    mean: Option<f64>,
    std: Option<f64>,
    rules: Vec<(Vec<f64>, Vec<f64>)>,
}

fn cases() -> Vec<Case> {
    entries(include_str!("../data/rules.json"), |entry| {
        let (name, law) = named_law(entry);
        let rule = |rule: &Value| (numbers(&rule["x"]), numbers(&rule["w"]));
        Case {
            name,
            law,
            mean: entry["mean"].as_f64(),
            std: entry["std"].as_f64(),
            rules: list(&entry["rules"], rule),
        }
    })
}

/// Coefficients of a discretised law are sums of some hundred rounded terms; from the p_k, carried over N steps of a
/// few eps each, come N squares in the weight.
fn tolerance(nodes: usize) -> f64 {
    ((nodes * nodes) as f64 + 64.0) * f64::EPSILON
}

/// Largest errors of nodes, relative to themselves or the law's spread, and of weights, relative.
fn errors(found: &GaussRule, (nodes, weights): &(Vec<f64>, Vec<f64>), std: f64) -> (f64, f64) {
    assert_eq!(found.len(), nodes.len());
    let node = |(x, exact): (&f64, &f64)| (x - exact).abs() / exact.abs().max(std);
    let weight = |(w, exact): (&f64, &f64)| (w / exact - 1.0).abs();
    let largest = |errors: &mut dyn Iterator<Item = f64>| errors.fold(0.0, f64::max);
    (
        largest(&mut found.nodes.iter().zip(nodes).map(node)),
        largest(&mut found.weights.iter().zip(weights).map(weight)),
    )
}

#[test]
fn rules_agree_with_extended_precision() {
    let mut checked = 0;
    for case in cases() {
        for expected in &case.rules {
            let n = expected.0.len();
            let rule = case.law.gauss_rule(n).expect("a rule");
            let (node, weight) = errors(&rule, expected, case.law.std());
            println!(
                "{:46} N = {n:2}  nodes {node:.1e}  weights {weight:.1e}",
                case.name
            );
            assert!(node <= tolerance(n), "{}: {node:e}", case.name);
            assert!(weight <= tolerance(n), "{}: {weight:e}", case.name);
            checked += 1;
        }
    }
    assert!(checked > 100, "{checked} rules checked");
}

#[test]
fn moments_agree_with_extended_precision() {
    // sums of some hundred rounded terms where the moment is integrated
    const TOLERANCE: f64 = 16.0 * f64::EPSILON;
    for case in cases() {
        if let Some(mean) = case.mean {
            let error = (case.law.mean() - mean).abs() / mean.abs().max(case.law.std());
            assert!(error <= TOLERANCE, "{}: mean {error:e}", case.name);
        }
        if let Some(std) = case.std {
            let error = (case.law.std() / std - 1.0).abs();
            assert!(error <= TOLERANCE, "{}: std {error:e}", case.name);
        }
    }
}
