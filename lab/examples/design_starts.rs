//! Does it pay to start a design's cut point from the equilibrium of a neighbouring design instead of from nothing? Iterations, factorisations and
//! times of both, medians of five. The table of `docs/develop/decisions/placement/designs.md`.
//!
//! `cargo run --release -p lab --example design_starts`, a minute on one core.

use std::sync::atomic::AtomicBool;

use fem_client::scene::Scene;
use fem_client::solver::{Readout, SolveError, SolveRequest, Solved, Solver, StartState};
use serde_json::{Value, json};
use tire::embedded::EmbeddedSolver;

/// Runs of each.
const RUNS: usize = 5;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let (_, base) = design("material.c10_mpa", json!(0.144))?;
    let neighbour = solved(&base, None)?.state;
    println!(
        "| design | from nothing: iterations, factorisations, s | from the shipped tire: the same | time saved | strains differ by |"
    );
    println!("| --- | --- | --- | --- | --- |");
    for (path, value) in [
        ("geometry.wall_mm", json!(2.9)),
        ("geometry.wall_mm", json!(2.5)),
        ("carcass.angle_deg", json!(50)),
        ("pressure.internal_mpa", json!(0.19)),
        ("pressure.internal_mpa", json!(0.15)),
        ("ground.station_spacing_mm", json!(6)),
    ] {
        let (name, scene) = design(path, value)?;
        let (afresh, near) = (median(&scene, None)?, median(&scene, Some(&neighbour))?);
        let saved = 1.0 - near.cost.wall_s / afresh.cost.wall_s;
        let text = |solved: &Solved| {
            let cost = &solved.cost;
            let (iterations, factorisations) = (cost.newton_iterations, cost.factorisations);
            format!("{iterations}, {factorisations}, {:.2}", cost.wall_s)
        };
        println!(
            "| {name} | {} | {} | {:.0} % | {:.0e} |",
            text(&afresh),
            text(&near),
            100.0 * saved,
            difference(&afresh, &near)
        );
    }
    Ok(())
}

fn design(path: &str, value: Value) -> Result<(String, Scene), Box<dyn std::error::Error>> {
    let mut scene = Scene::preset("foot-tire").ok_or("the preset ships")?;
    scene.set(path, &value).map_err(|fault| fault.to_string())?;
    Ok((format!("{path} = {value}"), scene))
}

fn solved(scene: &Scene, start: Option<&StartState>) -> Result<Solved, SolveError> {
    // Each with a solver of its own, so that none profits from what another one left in memory.
    EmbeddedSolver::default().solve(&SolveRequest {
        scene,
        readout: &Readout::default(),
        start,
        watch: &AtomicBool::new(false),
    })
}

/// The run of median time.
fn median(scene: &Scene, start: Option<&StartState>) -> Result<Solved, SolveError> {
    let mut runs = Vec::new();
    for _ in 0..RUNS {
        runs.push(solved(scene, start)?);
    }
    runs.sort_by(|a, b| a.cost.wall_s.total_cmp(&b.cost.wall_s));
    Ok(runs.swap_remove(RUNS / 2))
}

/// Largest difference of a strain at P1 to P5, over the largest of them.
fn difference(a: &Solved, b: &Solved) -> f64 {
    let strains = |solved: &Solved| -> Vec<f64> {
        let locations = solved.response.locations.iter();
        locations.flat_map(|l| l.strain).collect()
    };
    let (a, b) = (strains(a), strains(b));
    let largest = a
        .iter()
        .fold(0.0, |largest: f64, strain| largest.max(strain.abs()));
    let differences = a.iter().zip(&b).map(|(a, b)| (a - b).abs());
    differences.fold(0.0, f64::max) / largest
}
