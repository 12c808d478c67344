//! Distribution functions and quantiles of every law against values computed with 60 to 400 digits, far into both tails.

use gsa::law::distribution::Distribution;
use serde_json::Value;

use crate::law_data::{entries, list, named_law, numbers};

struct Case {
    name: String,
    law: Distribution,
    /// x, P(X <= x), P(X > x)
    rows: Vec<[f64; 3]>,
}

fn cases() -> Vec<Case> {
    entries(include_str!("../data/probabilities.json"), |entry| {
        let (name, law) = named_law(entry);
        let row = |row: &Value| <[f64; 3]>::try_from(numbers(row)).expect("three numbers");
        let rows = list(&entry["rows"], row);
        Case { name, law, rows }
    })
}

/// Relative error allowed to a probability: two digits lost where it is the rest of a whole (200 eps), its exponents, up
/// to |ln p| and several of them, off by an eps each, and what x itself says by its neighbours four eps away.
fn tolerance(probability: impl Fn(f64) -> f64, x: f64, exact: f64) -> f64 {
    let near = 4.0 * f64::EPSILON;
    let conditioning = probability(x * (1.0 + near)) / probability(x * (1.0 - near));
    f64::EPSILON * (200.0 + 8.0 * exact.ln().abs()) + conditioning.ln().abs()
}

#[test]
fn probabilities_agree_in_both_tails() {
    let (mut checked, mut worst) = (0, 0.0f64);
    for Case { name, law, rows } in cases() {
        for [x, p, q] in rows {
            for (found, exact, tolerance) in [
                (law.cdf(x), p, tolerance(|x| law.cdf(x), x, p)),
                (law.survival(x), q, tolerance(|x| law.survival(x), x, q)),
            ] {
                let error = (found / exact - 1.0).abs();
                assert!(
                    error <= tolerance,
                    "{name} at {x}: {error:e} of {exact:e}, allowed {tolerance:e}"
                );
                worst = worst.max(error / tolerance);
                checked += 1;
            }
        }
    }
    println!("{checked} probabilities, the worst at {worst:.2} of its tolerance");
}

#[test]
fn quantiles_invert_probabilities_in_both_tails() {
    for Case { name, law, rows } in cases() {
        for [x, p, q] in rows {
            let (exact, found, tolerance) = if p < q {
                (
                    p,
                    law.cdf(law.inverse_cdf(p)),
                    tolerance(|x| law.cdf(x), x, p),
                )
            } else {
                (
                    q,
                    law.survival(law.inverse_survival(q)),
                    tolerance(|x| law.survival(x), x, q),
                )
            };
            let error = (found / exact - 1.0).abs();
            assert!(
                error <= tolerance,
                "{name} at {x}: {error:e} of {exact:e}, allowed {tolerance:e}"
            );
        }
    }
}
