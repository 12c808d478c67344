//! Convergence of each method to exact indices: the error of the first-order indices against the number of runs.
//!
//! Run it with `cargo run --release -p lab --example convergence_of_indices`. The order is that of error ~ runs^-order between the rows.

use std::f64::consts::PI;

use gsa::campaign::Campaign;
use gsa::law::distribution::Distribution;
use gsa::method::{Kind, Method};
use ndarray::Array2;

/// A model, its inputs, and its exact first-order indices.
struct Model {
    name: &'static str,
    inputs: Vec<Distribution>,
    value: fn(&[f64]) -> f64,
    exact: Vec<f64>,
}

fn ishigami(x: &[f64]) -> f64 {
    x[0].sin() * (1.0 + 0.1 * x[2].powi(4)) + 7.0 * x[1].sin().powi(2)
}

/// Sobol's g function: a product of kinks.
fn sobol_g(x: &[f64]) -> f64 {
    let factors = x.iter().zip([0.5, 1.0, 5.0]);
    factors
        .map(|(x, a)| ((4.0 * x - 2.0).abs() + a) / (1.0 + a))
        .product()
}

fn models() -> Result<Vec<Model>, Box<dyn std::error::Error>> {
    // Var[f_i] = 1/(3 (1 + a_i)^2), means of one
    let parts = [0.5, 1.0, 5.0f64].map(|a| 1.0 / (3.0 * (1.0 + a).powi(2)));
    let whole: f64 = parts.iter().map(|v| 1.0 + v).product::<f64>() - 1.0;
    Ok(vec![
        Model {
            name: "Ishigami",
            inputs: vec![Distribution::uniform(-PI, PI)?; 3],
            value: ishigami,
            exact: vec![0.31390519114781146, 0.4424111447900408, 0.0],
        },
        Model {
            name: "Sobol g",
            inputs: vec![Distribution::uniform(0.0, 1.0)?; 3],
            value: sobol_g,
            exact: parts.iter().map(|v| v / whole).collect(),
        },
    ])
}

/// Runs, claimed and true error.
fn outcome(model: &Model, method: Method) -> Result<(usize, f64, f64), Box<dyn std::error::Error>> {
    let mut campaign = Campaign::new(&model.inputs, method)?;
    loop {
        let values: Vec<f64> = campaign.points().iter().map(|x| (model.value)(x)).collect();
        let values = Array2::from_shape_vec((values.len(), 1), values)?;
        let found = campaign.tell(&values.view())?.remove(0);
        if campaign.points().len() > values.nrows() {
            continue;
        }
        let first_order = found.first_order.ok_or("no indices")?;
        let differences = first_order
            .iter()
            .zip(&model.exact)
            .map(|(s, e)| (s - e).abs());
        let claimed = found.error.total.unwrap_or(1.0);
        return Ok((values.nrows(), claimed, differences.fold(0.0, f64::max)));
    }
}

/// The settings of a method from cheap to dear.
fn rungs(kind: Kind) -> Vec<Method> {
    let of = Method::of(kind);
    let nodes = |n: &[usize]| n.iter().map(|&nodes| Method { nodes, ..of }).collect();
    let samples = |n: &[usize]| n.iter().map(|&samples| Method { samples, ..of }).collect();
    match kind {
        Kind::Tensor | Kind::Bivariate => nodes(&[3, 5, 7, 9, 13, 17, 25]),
        Kind::Pce => samples(&[25, 50, 100, 200, 400, 800]),
        Kind::Saltelli => samples(&[64, 256, 1024, 4096, 16384]),
        _ => [0.1, 0.03, 0.01, 0.003, 0.001]
            .map(|tolerance| Method { tolerance, ..of })
            .to_vec(),
    }
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let kinds = [
        Kind::Tensor,
        Kind::Bivariate,
        Kind::Pce,
        Kind::Saltelli,
        Kind::Auto,
    ];
    for model in models()? {
        for kind in kinds {
            println!("{}, {}", model.name, kind.as_str());
            println!("    runs   claimed      true   order");
            let mut before: Option<(f64, f64)> = None;
            for method in rungs(kind) {
                let (runs, claimed, truth) = outcome(&model, method)?;
                let here = (runs as f64, truth);
                let order = before
                    .filter(|b| b.0 != here.0)
                    .map(|b| (b.1 / here.1).ln() / (here.0 / b.0).ln());
                let order = order.map_or(String::new(), |order| format!("{order:6.1}"));
                println!("{runs:8}  {claimed:8.1e}  {truth:8.1e}  {order}");
                before = Some(here);
            }
            println!();
        }
    }
    Ok(())
}
