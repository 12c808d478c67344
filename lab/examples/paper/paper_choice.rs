//! Is the paper's choice of a method sound? The tables and the figure of `docs/proof/paper-choice/README.md`.
//!
//! `cargo run --release -p lab --example paper_choice [-- FIGURE.svg]`

mod figure;
#[path = "../../../placement/tests/quick/paper_choice/grid.rs"]
mod grid;

use estimation::error_metrics::order_statistics::upper_median;
use gsa::method::analysis::Analysis;
use gsa::method::{Kind, Method};

use figure::Panel;
use grid::{Grid, NODES, difference, mdrm, tensor};

/// P1 x to P3 y: the others are mirror images.
const NAMES: [&str; 6] = ["P1 x", "P1 y", "P2 x", "P2 y", "P3 x", "P3 y"];
/// Draws of the check points.
const SEEDS: u64 = 200;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let grid = Grid::new();
    let (truth, _) = grid.analysed(tensor());
    let (found, _) = grid.analysed(mdrm(5, 1));
    indices(&truth);
    forms(&grid, &truth, &found);
    claims(&grid, &truth);
    if let Some(path) = std::env::args().nth(1) {
        let panels = [2, 4, 5].map(|output| panel(output, &truth, &found));
        std::fs::write(path, figure::svg(&panels)?)?;
    }
    Ok(())
}

fn first_order(analysis: &Analysis) -> &[f64] {
    analysis.first_order.as_deref().unwrap_or_default()
}

fn product(analysis: &Analysis) -> &[f64] {
    analysis.mdrm_first_order.as_deref().unwrap_or_default()
}

fn total(indices: Option<&Vec<f64>>) -> &[f64] {
    indices.map(Vec::as_slice).unwrap_or_default()
}

fn percent(values: &[f64]) -> String {
    let cells: Vec<String> = values.iter().map(|v| format!("{:.2}", 100.0 * v)).collect();
    cells.join(" | ")
}

fn indices(truth: &[Analysis]) {
    println!("| strain | index, % | depth 1 | depth 2 | depth 3 | depth 4 | depth 5 |");
    println!("| --- | --- | --- | --- | --- | --- | --- |");
    for (name, truth) in NAMES.iter().zip(truth) {
        println!("| {name} | first | {} |", percent(first_order(truth)));
        println!("| | total | {} |", percent(total(truth.total.as_ref())));
    }
}

fn forms(grid: &Grid, truth: &[Analysis], found: &[Analysis]) {
    println!(
        "\n| strain | M-DRM's product: first order off by | total off by | its misfit | shipped study: first order off by | total off by | claimed |"
    );
    println!("| --- | --- | --- | --- | --- | --- | --- |");
    for (output, name) in NAMES.iter().enumerate() {
        let (truth, found) = (&truth[output], &found[output]);
        let deviation = truth.variance.unwrap_or(f64::NAN).sqrt();
        println!(
            "| {name} | {:.4} | {:.4} | {:.3} | {:.4} | {:.4} | {:.4} |",
            difference(product(found), first_order(truth)),
            difference(
                total(found.mdrm_total.as_ref()),
                total(truth.total.as_ref())
            ),
            grid.misfit_of_product(output, deviation),
            difference(first_order(found), first_order(truth)),
            difference(total(found.total.as_ref()), total(truth.total.as_ref())),
            found.error.total.unwrap_or(f64::NAN),
        );
    }
}

fn claims(grid: &Grid, truth: &[Analysis]) {
    println!("\n| method | solves | largest error, median | claimed, median | claims that hold |");
    println!("| --- | --- | --- | --- | --- |");
    let methods =
        [3, 5, 10, 20, 40].map(|checks| (format!("mdrm, {checks} check points"), mdrm(checks, 0)));
    let bivariate = Method {
        nodes: NODES,
        ..Method::of(Kind::Bivariate)
    };
    for (name, method) in methods
        .into_iter()
        .chain([("bivariate".to_owned(), bivariate)])
    {
        let (mut errors, mut claims, mut held, mut solves) = (vec![], vec![], 0, 0);
        for seed in 0..SEEDS {
            let (found, runs) = grid.analysed(Method { seed, ..method });
            let pairs = || found.iter().zip(truth);
            let error = |(found, truth): (&Analysis, &Analysis)| {
                difference(first_order(found), first_order(truth))
            };
            let claim = |found: &Analysis| found.error.total.unwrap_or(f64::NAN);
            held += pairs().filter(|(f, t)| claim(f) >= error((f, t))).count();
            errors.push(pairs().map(error).fold(0.0, f64::max));
            claims.push(found.iter().map(claim).fold(0.0, f64::max));
            solves = runs;
        }
        let share = 100.0 * held as f64 / (SEEDS as usize * truth.len()) as f64;
        println!(
            "| {name} | {solves} | {:.4} | {:.4} | {share:.1} % |",
            median(errors),
            median(claims)
        );
    }
}

fn median(values: Vec<f64>) -> f64 {
    upper_median(values).expect("values")
}

fn panel(output: usize, truth: &[Analysis], found: &[Analysis]) -> Panel {
    let (truth, found) = (&truth[output], &found[output]);
    Panel {
        title: format!("strain {}", NAMES[output]),
        truth: first_order(truth).to_vec(),
        product: product(found).to_vec(),
        found: first_order(found).to_vec(),
        claimed: found.error.by_input.clone().unwrap_or_default(),
    }
}
