//! Time of one cold solve against the number of unknowns, with the fitted exponent, and what an iteration with a new tangent
//! is made of; prints Markdown.
//!
//! `cargo run --release -p lab --example growth`, seven minutes and 4 GB.

use fem::cell::element::Order;
use fem::newton::iteration::NewtonSettings;
use fem_client::solver::Cost;
use tire::embedded::EmbeddedSolver;
use tire::mesh::tire_grid::MeshPlan;

use lab::cpu::cpu_seconds;
use lab::mesh_families::{ORDERS, REFINEMENTS, plan};
use lab::reference_tire::{reference, solve};

/// Layers of the standard mesh, in the family that isn't refined through the wall.
const LAYERS: usize = 3;
/// A mesh is solved this often, and the median taken, unless that lasts too long.
const RUNS: usize = 3;
const LONGEST_S: f64 = 20.0;
/// Unknowns from which on the exponent is fitted: below, fixed costs count.
const ASYMPTOTIC: usize = 2000;

/// A cold solve.
#[derive(Debug, Clone, Copy)]
struct Run {
    unknowns: usize,
    cost: Cost,
    cpu_s: f64,
}

fn main() {
    for (name, order) in ORDERS {
        table(
            &format!("{name}, refined in all directions"),
            |refinement| plan(order, refinement),
        );
        table(&format!("{name}, {LAYERS} layers"), |refinement| {
            in_plane(order, refinement)
        });
    }
    for (name, order) in ORDERS {
        iterations(&format!("An iteration with a new tangent, {name}"), order);
    }
}

fn in_plane(order: Order, refinement: usize) -> MeshPlan {
    MeshPlan {
        layers: LAYERS,
        ..plan(order, refinement)
    }
}

/// Parts of an iteration of pure Newton. Ordering and symbolic factorisation, made once, belong to none.
fn iterations(title: &str, order: Order) {
    println!("### {title}\n");
    println!(
        "| unknowns | iterations | ms an iteration | factorisation % | assembly % | substitution and contact % |"
    );
    println!("| ---{} |", " | ---".repeat(5));
    let pure = NewtonSettings {
        renewal_cost: 0.0,
        ..EmbeddedSolver::settings()
    };
    for refinement in REFINEMENTS {
        let run = median(&plan(order, refinement), pure);
        let cost = &run.cost;
        let parts = [cost.factorisation_s, cost.assembly_s, cost.substitution_s];
        let whole: f64 = parts.iter().sum();
        let [factorisation, assembly, substitution] = parts.map(|part| 100.0 * part / whole);
        println!(
            "| {} | {} | {:.1} | {factorisation:.0} | {assembly:.0} | {substitution:.0} |",
            run.unknowns,
            cost.newton_iterations,
            1e3 * whole / cost.newton_iterations as f64,
        );
    }
    println!();
}

fn table(title: &str, plan: impl Fn(usize) -> MeshPlan) {
    println!("### {title}\n");
    println!(
        "| unknowns | iterations | factorisations | wall s | CPU s | factorisation % | assembly % | substitution and contact % | the rest % |"
    );
    println!("| ---{} |", " | ---".repeat(8));
    let runs: Vec<Run> = REFINEMENTS
        .iter()
        .map(|&r| median(&plan(r), EmbeddedSolver::settings()))
        .collect();
    for run in &runs {
        let cost = &run.cost;
        let share = |seconds: f64| 100.0 * seconds / cost.wall_s;
        let parts = [cost.factorisation_s, cost.assembly_s, cost.substitution_s];
        let rest = cost.wall_s - parts.iter().sum::<f64>();
        println!(
            "| {} | {} | {} | {:.3} | {:.3} | {:.0} | {:.0} | {:.0} | {:.0} |",
            run.unknowns,
            cost.newton_iterations,
            cost.factorisations,
            cost.wall_s,
            run.cpu_s,
            share(parts[0]),
            share(parts[1]),
            share(parts[2]),
            share(rest),
        );
    }
    let exponent = |time: fn(&Run) -> f64| {
        let large = runs.iter().filter(|run| run.unknowns >= ASYMPTOTIC);
        slope(large.map(|run| (run.unknowns as f64, time(run))))
    };
    println!(
        "| exponent | | | {:.2} | {:.2} | | | | |\n",
        exponent(|run| run.cost.wall_s),
        exponent(|run| run.cpu_s)
    );
}

fn median(plan: &MeshPlan, settings: NewtonSettings) -> Run {
    let mut runs: Vec<Run> = Vec::new();
    while runs.len() < RUNS && runs.iter().map(|run| run.cpu_s).sum::<f64>() < LONGEST_S {
        let begin = cpu_seconds();
        let solver = EmbeddedSolver::with_settings(settings);
        let solved = solve(&solver, &reference(1.0), plan, None);
        runs.push(Run {
            unknowns: solved.response.model.dofs,
            cost: solved.cost,
            cpu_s: cpu_seconds() - begin,
        });
    }
    runs.sort_by(|a, b| a.cpu_s.total_cmp(&b.cpu_s));
    runs[runs.len() / 2]
}

/// Exponent of the power law through these points: least squares of the logarithms.
fn slope(points: impl Iterator<Item = (f64, f64)>) -> f64 {
    let points: Vec<(f64, f64)> = points.map(|(x, y)| (x.ln(), y.ln())).collect();
    let n = points.len() as f64;
    let mean_x = points.iter().map(|p| p.0).sum::<f64>() / n;
    let mean_y = points.iter().map(|p| p.1).sum::<f64>() / n;
    let covariance: f64 = points.iter().map(|p| (p.0 - mean_x) * (p.1 - mean_y)).sum();
    let variance: f64 = points.iter().map(|p| (p.0 - mean_x).powi(2)).sum();
    covariance / variance
}
