//! Slopes of the reference tire's strains and force over the depth, on three levels beside a finer mesh. The table and the picture of `docs/proof/slopes.md`.
//!
//! `cargo run --release -p lab --example slopes -- docs/pictures/slopes.svg`, three minutes on two cores.

mod slope_figure;

use std::error::Error;

use fem::cell::element::Order;
use fem_client::scene::{Level, Scene};
use fem_client::solver::{Readout, StartState};
use lab::all_cores::on_all_cores;
use lab::largest::largest;
use lab::reference_tire::solve;
use slope_figure::{Curve, Panel};
use tire::embedded::EmbeddedSolver;
use tire::mesh::tire_grid::MeshPlan;
use tire::model::mesh_plan_for;

/// Depths, in hundredths of a millimetre.
const DEPTHS: std::ops::RangeInclusive<u32> = 20..=200;
/// Depths that start from the same equilibrium, the first among them.
const FROM_ONE: usize = 10;
/// The station of P3.
const MIDDLE: usize = 2;
/// Depth of the other stations where P3's moves alone, mm.
const OTHERS: f64 = 1.0;
/// Slopes that are printed, in the order of [`Curve::slopes`].
const READ: [&str; 3] = ["dx/dd", "dy/dd", "dF/dd"];

/// Stations whose depths move.
#[derive(Clone, Copy)]
enum Moves {
    All,
    MiddleAlone,
}

impl Moves {
    const BOTH: [Self; 2] = [Self::All, Self::MiddleAlone];

    fn name(self) -> &'static str {
        match self {
            Self::All => "all five depths",
            Self::MiddleAlone => "P3's depth alone",
        }
    }

    fn depths(self, depth: f64, stations: usize) -> Vec<f64> {
        let mut depths = match self {
            Self::All => vec![depth; stations],
            Self::MiddleAlone => vec![OTHERS; stations],
        };
        depths[MIDDLE] = depth;
        depths
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    let scene = Scene::preset("foot-tire").ok_or("the preset ships")?;
    let plans: Vec<(&str, MeshPlan)> = Level::ALL
        .iter()
        .filter(|level| **level != Level::Draft)
        .map(|level| (level.as_str(), plan_of(&scene, *level)))
        .chain([("finer", finer(&scene))])
        .collect();
    let meshes = plans.len();
    // The finest meshes begin first, so that no core waits for one of them.
    let curves = on_all_cores(2 * meshes, |k| {
        let (name, plan) = &plans[meshes - 1 - k / 2];
        curve(name, &scene, plan, Moves::BOTH[k % 2])
    });
    let mut panels = Vec::new();
    println!("| moved | mesh | {} |", READ.join(" | "));
    println!("| --- | --- |{}", " --- |".repeat(READ.len()));
    for (m, moves) in Moves::BOTH.into_iter().enumerate() {
        let of_moves: Vec<&Curve> = curves.iter().skip(m).step_by(2).rev().collect();
        let (truth, levels) = of_moves.split_last().ok_or("there are meshes")?;
        for level in levels {
            println!(
                "| {} | {} |{} |",
                moves.name(),
                level.name,
                row(level, truth)
            );
        }
        panels.push(Panel {
            title: moves.name(),
            curves: of_moves.into_iter().cloned().collect(),
        });
    }
    if let Some(path) = std::env::args().nth(1) {
        std::fs::write(path, slope_figure::svg(&panels)?)?;
    }
    Ok(())
}

fn plan_of(scene: &Scene, level: Level) -> MeshPlan {
    mesh_plan_for(scene, level, &Readout::default())
}

/// A mesh that is finer than all levels where slopes ask for it: across the wheel.
fn finer(scene: &Scene) -> MeshPlan {
    MeshPlan {
        order: Order::Quadratic,
        meridional: 32,
        layers: 3,
        ..plan_of(scene, Level::Reference)
    }
}

/// Central differences over two steps of the depth, on one mesh.
fn curve(name: &str, scene: &Scene, plan: &MeshPlan, moves: Moves) -> Curve {
    let solver = EmbeddedSolver::default();
    let mut scene = scene.clone();
    let mut start: Option<StartState> = None;
    let mut read: Vec<(f64, [f64; 3])> = Vec::new();
    for (k, hundredths) in DEPTHS.enumerate() {
        let depth = f64::from(hundredths) / 100.0;
        scene.ground.depths_mm = moves.depths(depth, scene.ground.stations);
        let solved = solve(&solver, &scene, plan, start.as_ref());
        if k % FROM_ONE == 0 {
            start = Some(solved.state);
        }
        let response = solved.response;
        let strain = &response.locations[MIDDLE].strain;
        read.push((depth, [strain.x, strain.y, response.reaction_n]));
    }
    let slope = |three: &[(f64, [f64; 3])]| {
        let [(before, low), (depth, _), (after, high)] = three else {
            unreachable!("windows of three")
        };
        let slope = |k: usize| (high[k] - low[k]) / (after - before);
        (*depth, [0, 1, 2].map(slope))
    };
    Curve {
        name: name.to_owned(),
        slopes: read.windows(3).map(slope).collect(),
    }
}

/// Largest and root mean square error of each slope, over the largest slope of its kind.
fn row(own: &Curve, truth: &Curve) -> String {
    let cell = |k: usize| {
        let scale = largest(truth.slopes.iter().map(|(_, slopes)| slopes[k]));
        let pairs = own.slopes.iter().zip(&truth.slopes);
        let errors: Vec<f64> = pairs
            .map(|((_, own), (_, truth))| (own[k] - truth[k]) / scale)
            .collect();
        let mean = errors.iter().map(|e| e * e).sum::<f64>() / errors.len() as f64;
        let worst = largest(errors.iter().copied());
        format!(" {:.1} % ({:.1} %)", 100.0 * worst, 100.0 * mean.sqrt())
    };
    [0, 1, 2].map(cell).join(" |")
}
