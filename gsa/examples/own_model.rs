//! Sensitivity of a model of your own, by the method that chooses for itself.
//!
//! Run it with `cargo run --release -p gsa --example own_model`.

use gsa::campaign::Campaign;
use gsa::law::distribution::Distribution;
use gsa::method::{Kind, Method};
use ndarray::Array2;

/// Two outputs of one run: a deflection F L^3 / (3 E I) and a stress F L / W of a cantilever of square section.
fn model(x: &[f64]) -> [f64; 2] {
    let [force_n, length_mm, modulus_mpa, side_mm] = x else {
        panic!("four inputs");
    };
    let (inertia, section) = (side_mm.powi(4) / 12.0, side_mm.powi(3) / 6.0);
    [
        force_n * length_mm.powi(3) / (3.0 * modulus_mpa * inertia),
        force_n * length_mm / section,
    ]
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    // 1. What is uncertain.
    let inputs = [
        Distribution::gumbel(100.0, 15.0)?,
        Distribution::normal(500.0, 5.0)?,
        Distribution::lognormal(12.2, 0.06)?,
        Distribution::uniform(19.0, 21.0)?,
    ];

    // 2. The method: ask until every first-order index is known to 0.01.
    let method = Method {
        tolerance: 0.01,
        ..Method::of(Kind::Auto)
    };

    // 3. Ask and tell. The library never calls the model: these runs could be jobs on another machine.
    let mut campaign = Campaign::new(&inputs, method)?;
    let found = loop {
        let rows: Vec<f64> = campaign.points().iter().flat_map(|x| model(x)).collect();
        let values = Array2::from_shape_vec((campaign.points().len(), 2), rows)?;
        let found = campaign.tell(&values.view())?;
        println!("{} runs", values.nrows());
        if campaign.points().len() == values.nrows() {
            break found;
        }
    };

    // 4. The indices, each with its error.
    for (name, output) in ["deflection", "stress"].into_iter().zip(&found) {
        println!(
            "{name}: {} ({})",
            output.method.as_str(),
            output.status.as_str()
        );
        let first_order = output.first_order.iter().flatten();
        let total = output.total.iter().flatten();
        let errors = output.error.by_input.iter().flatten();
        for (input, ((s, t), e)) in ["force", "length", "modulus", "side"]
            .into_iter()
            .zip(first_order.zip(total).zip(errors))
        {
            println!("  {input:8} first order {s:.4}  total {t:.4}  +- {e:.1e}");
        }
    }
    Ok(())
}
