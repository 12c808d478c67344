//! Gauss rules of all laws, with what shows that they are right: `cargo run --release -p lab --example gauss_rules`.
//!
//! A rule of N nodes integrates its law's own mean and variance exactly, whatever the law; the columns say how far it
//! misses them. The mean and the variance come from closed forms or from a separate integration, never from the rule.

use std::error::Error;
use std::time::Instant;

use gsa::law::distribution::Distribution;

fn main() -> Result<(), Box<dyn Error>> {
    // 1. A law of each kind, and some extremes.
    let laws = [
        Distribution::uniform(0.7, 1.3)?,
        Distribution::normal(1.0, 0.1)?,
        Distribution::exponential(2.0)?,
        Distribution::gamma(3.0, 2.0)?,
        Distribution::gamma(0.01, 1.0)?,
        Distribution::gamma(1e6, 1.0)?,
        Distribution::weibull(2.0, 3.0)?,
        Distribution::weibull(0.3, 1.0)?,
        Distribution::weibull(50.0, 1.0)?,
        Distribution::beta(2.0, 3.0, 0.0, 1.0)?,
        Distribution::beta(0.1, 0.1, 0.0, 1.0)?,
        Distribution::beta(500.0, 2.0, 0.0, 1.0)?,
        Distribution::gumbel(4.0, 1.5)?,
        Distribution::triangular(0.0, 1.0, 4.0)?,
        Distribution::normal(0.0, 1.0)?.truncated(6.0, 8.0)?,
        Distribution::normal(0.0, 1.0)?.truncated(40.0, 45.0)?,
        Distribution::normal(0.0, 1.0)?.truncated(1.0, 1.000001)?,
        Distribution::gumbel(1013.0, 558.0)?.truncated(500.0, 3000.0)?,
    ];
    println!(
        "N = 64         first node      last node  last weight  mean off by  variance off by  built in"
    );
    for law in laws {
        // 2. The rule, and how long it takes.
        let start = Instant::now();
        let rule = law.gauss_rule(64)?;
        let time = start.elapsed();
        // 3. Its mean and variance, in units of the law's standard deviation.
        let expected = |f: &dyn Fn(f64) -> f64| -> f64 {
            let terms = rule.nodes.iter().zip(&rule.weights);
            terms
                .map(|(&x, w)| w * f((x - law.mean()) / law.std()))
                .sum()
        };
        let cut = if law.truncation().is_some() {
            ", cut"
        } else {
            ""
        };
        println!(
            "{:16} {:11.5e} {:12.5e} {:12.1e} {:12.1e} {:16.1e} {:>9.2?}",
            format!("{}{cut}", law.kind()),
            rule.nodes[0],
            rule.nodes[63],
            rule.weights[63],
            expected(&|z| z).abs(),
            (expected(&|z| z * z) - 1.0).abs(),
            time,
        );
    }
    Ok(())
}
