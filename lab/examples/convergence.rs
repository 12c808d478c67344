//! The reference tire on ever finer meshes; prints Markdown.
//!
//! `cargo run --release -p lab --example convergence`, three minutes and 4 GB.

use fem::cell::element::Order;
use fem::surface::chart::Recovery;
use fem_client::solver::Solved;
use tire::embedded::EmbeddedSolver;
use tire::mesh::tire_grid::{Extent, MeshPlan};
use tire::model::TireModel;

use lab::limit::limit;
use lab::mesh_families::{ORDERS, REFINEMENTS, plan};
use lab::reference_tire::{reference, solve};

const DEPTHS: [f64; 3] = [0.5, 1.0, 2.0];
/// Columns of values.
const QUANTITIES: [&str; 5] = ["reaction N", "x", "y", "x, raw", "y, raw"];

/// Values at the centre on one mesh, one set a depth.
struct Mesh {
    unknowns: usize,
    values: Vec<[f64; QUANTITIES.len()]>,
}

fn main() {
    for (name, order) in ORDERS {
        let meshes: Vec<Mesh> = REFINEMENTS.map(|r| measure(order, r)).into();
        for (k, depth) in DEPTHS.into_iter().enumerate() {
            println!("### {name}, {depth} mm\n");
            table(&meshes, k);
        }
    }
}

fn measure(order: Order, refinement: usize) -> Mesh {
    let plan = plan(order, refinement);
    let solver = EmbeddedSolver::default();
    let middle = solve(&solver, &reference(1.0), &plan, None);
    let unknowns = middle.response.model.dofs;
    let solved = DEPTHS.map(|depth| match depth {
        1.0 => values(&middle, &plan),
        _ => {
            let start = Some(&middle.state);
            values(&solve(&solver, &reference(depth), &plan, start), &plan)
        }
    });
    Mesh {
        unknowns,
        values: solved.into(),
    }
}

/// Reaction, recovered strains and the elements' own at the centre.
fn values(solved: &Solved, plan: &MeshPlan) -> [f64; QUANTITIES.len()] {
    let model = TireModel::new(&reference(1.0), plan, Extent::Quarter);
    let mesh = &model.problem.mesh;
    let centre = model.grid.inner_point(0.0, 0.0);
    let [before, after] = [&solved.state.inflated, &solved.state.equilibrium].map(|flat| {
        let state = model.fit(flat).expect("it was solved on this mesh");
        Recovery::new(&model.chart, mesh, |node| state.position(mesh, node)).raw_at(centre)
    });
    let response = &solved.response;
    let recovered = &response.locations[response.locations.len() / 2];
    [
        response.reaction_n,
        recovered.strain.x,
        recovered.strain.y,
        after.s1 / before.s1 - 1.0,
        after.s2 / before.s2 - 1.0,
    ]
}

fn table(meshes: &[Mesh], depth: usize) {
    let columns = QUANTITIES.map(|name| format!("{name} | to the finest"));
    println!("| refinement | unknowns | {} |", columns.join(" | "));
    println!("| ---{} |", " | ---".repeat(1 + 2 * QUANTITIES.len()));
    let finest = &meshes[meshes.len() - 1].values[depth];
    for (refinement, mesh) in REFINEMENTS.iter().zip(meshes) {
        let cells: Vec<String> = (0..QUANTITIES.len())
            .map(|k| {
                let (value, end) = (mesh.values[depth][k], finest[k]);
                let share = 100.0 * (value / end - 1.0);
                format!("{} | {share:+.2} %", number(k, value))
            })
            .collect();
        println!(
            "| {refinement} | {} | {} |",
            mesh.unknowns,
            cells.join(" | ")
        );
    }
    let sizes = REFINEMENTS.map(|r| 1.0 / r as f64);
    let limits: Vec<String> = (0..QUANTITIES.len())
        .map(|k| {
            let values: Vec<f64> = meshes.iter().map(|mesh| mesh.values[depth][k]).collect();
            let limit = limit(&sizes, &values);
            let order = limit
                .order
                .map_or("no order".into(), |p| format!("order {p:.1}"));
            let (value, error) = (number(k, limit.value), number(k, limit.error));
            format!("**{value} +-{error}** | {order}")
        })
        .collect();
    println!("| limit | | {} |\n", limits.join(" | "));
}

/// Newtons to 0.1 mN, strains to 1e-6.
fn number(quantity: usize, value: f64) -> String {
    match quantity {
        0 => format!("{value:.4}"),
        _ => format!("{value:.6}"),
    }
}
