//! Meshes of ever other bricks on several tires: errors of strains, their changes, slopes and the reaction for the time, on several tires. The tables of `docs/proof/meshes.md`.
//!
//! `cargo run --release -p lab --example mesh_choice [TIRE...]`, twenty minutes on one core for all tires.

use fem::cell::element::Order;
use fem_client::scene::{Level, Scene};
use fem_client::solver::{Readout, Solved, StartState};
use tire::embedded::EmbeddedSolver;
use tire::mesh::tire_grid::MeshPlan;
use tire::model::mesh_plan_for;

use lab::cpu::cpu_seconds;
use lab::largest::largest;
use lab::reference_tire::solve;

/// Deviations of the five depths from their mean, relative: the points that are compared.
const POINTS: [[f64; 5]; 6] = [
    [0.0, 0.0, 0.0, 0.0, 0.0],
    [0.25, -0.1, 0.2, -0.25, 0.05],
    [-0.2, 0.25, -0.15, 0.1, -0.25],
    [0.1, -0.25, -0.25, 0.2, 0.15],
    [0.25, 0.25, 0.25, 0.25, 0.25],
    [-0.2, -0.2, -0.2, -0.2, -0.2],
];
/// Deviations of the depth at P3 about which slopes are taken, relative, and half of their step.
const SLOPES_AT: [f64; 3] = [-0.12, 0.0, 0.12];
const STEP: f64 = 0.01;
/// The station of P3.
const MIDDLE: usize = 2;

/// Bricks along the fine sector and from there to the far side, from crown to bead, growth from crown to bead, layers.
type Bricks = (usize, usize, usize, f64, usize);

/// The mesh that the others are compared with.
const FINEST: Bricks = (18, 8, 24, 6.0, 4);
/// The first three were the coarse, standard and reference levels once.
const CANDIDATES: [Bricks; 12] = [
    (5, 3, 8, 4.0, 2),
    (8, 5, 12, 4.0, 3),
    (10, 6, 18, 5.0, 4),
    (8, 4, 8, 8.0, 2),
    (10, 4, 10, 10.0, 2),
    (10, 4, 12, 8.0, 2),
    (10, 4, 12, 8.0, 3),
    (8, 4, 16, 8.0, 2),
    (8, 4, 16, 8.0, 3),
    (10, 5, 16, 8.0, 3),
    (14, 5, 14, 8.0, 3),
    (12, 5, 20, 8.0, 3),
];

fn main() {
    let asked: Vec<String> = std::env::args().skip(1).collect();
    for (name, scene) in tires() {
        if !asked.is_empty() && !asked.iter().any(|asked| name.contains(asked.as_str())) {
            continue;
        }
        println!("### {name}\n");
        println!(
            "| mesh | unknowns | CPU s | strain, worst | rms | change, worst | reaction | dx/dd | dy/dd | dF/dd |"
        );
        println!("| --- |{}", " --- |".repeat(9));
        let truth = answers(&scene, &on_bricks(&scene, FINEST));
        let levels = Level::ALL.map(|level| {
            let plan = mesh_plan_for(&scene, level, &Readout::default());
            (level.as_str().to_owned(), plan)
        });
        let bricks = CANDIDATES.map(|bricks| (format!("{bricks:?}"), on_bricks(&scene, bricks)));
        for (name, plan) in levels.into_iter().chain(bricks) {
            println!("| {name} | {} |", row(&answers(&scene, &plan), &truth));
        }
        println!(
            "| {FINEST:?} | {} | {:.1} | | | | | | | |\n",
            truth.unknowns, truth.cpu_s
        );
    }
}

/// Tires that differ by what decides about a mesh.
fn tires() -> Vec<(&'static str, Scene)> {
    let shipped = pressed("foot-tire", 1.0);
    let with = |change: &dyn Fn(&mut Scene)| {
        let mut scene = shipped.clone();
        change(&mut scene);
        scene
    };
    vec![
        ("shipped, 1 mm", shipped.clone()),
        (
            "soft, wall 5 mm, no cords, 1 mm",
            pressed("foot-tire-soft", 1.0),
        ),
        ("wall 1.5 mm", with(&|scene| scene.geometry.wall_mm = 1.5)),
        (
            "wall 5 mm, with cords",
            with(&|scene| scene.geometry.wall_mm = 5.0),
        ),
        (
            "wheel of twice the radius",
            with(&|scene| scene.geometry.outer_radius_mm = 100.0),
        ),
    ]
}

fn pressed(preset: &str, depth: f64) -> Scene {
    let mut scene = Scene::preset(preset).expect("the preset ships");
    scene.ground.depths_mm = vec![depth; scene.ground.stations];
    scene
}

/// A mesh whose fine sector is the standard level's, and its bricks along as many as on a sector of 18 degrees.
fn on_bricks(scene: &Scene, (fine, coarse, meridional, growth, layers): Bricks) -> MeshPlan {
    let standard = mesh_plan_for(scene, Level::Standard, &Readout::default());
    let share = standard.fine_angle / 18f64.to_radians();
    MeshPlan {
        order: Order::Quadratic,
        fine: (fine as f64 * share).ceil() as usize,
        coarse,
        meridional,
        meridional_growth: growth,
        layers,
        ..standard
    }
}

/// Answers on one mesh.
struct Answers {
    unknowns: usize,
    /// Processor time of the points alone.
    cpu_s: f64,
    /// Strains at P1 to P5 along x, then y, by point.
    strains: Vec<Vec<f64>>,
    reactions: Vec<f64>,
    /// Derivatives of x and y at P3 and of the reaction by the depth at P3.
    slopes: Vec<[f64; 3]>,
}

fn answers(scene: &Scene, plan: &MeshPlan) -> Answers {
    let begun = cpu_seconds();
    let solver = EmbeddedSolver::default();
    let at = |deviations: [f64; 5], start: Option<&StartState>| {
        let mut scene = scene.clone();
        let depths = scene.ground.depths_mm.iter_mut();
        depths
            .zip(deviations)
            .for_each(|(depth, deviation)| *depth *= 1.0 + deviation);
        solve(&solver, &scene, plan, start)
    };
    let cut = at(POINTS[0], None);
    let start = Some(&cut.state);
    let points: Vec<Solved> = POINTS[1..].iter().map(|point| at(*point, start)).collect();
    let cpu_s = cpu_seconds() - begun;
    let all = || {
        std::iter::once(&cut)
            .chain(&points)
            .map(|solved| &solved.response)
    };
    let slopes = SLOPES_AT.map(|about| {
        let [low, high] = [-STEP, STEP].map(|step| {
            let mut deviations = [0.0; 5];
            deviations[MIDDLE] = about + step;
            let response = at(deviations, start).response;
            let strain = &response.locations[MIDDLE].strain;
            [strain.x, strain.y, response.reaction_n]
        });
        let step_mm = 2.0 * STEP * scene.ground.depths_mm[MIDDLE];
        [0, 1, 2].map(|k| (high[k] - low[k]) / step_mm)
    });
    Answers {
        unknowns: all().map(|response| response.model.dofs).max().unwrap_or(0),
        cpu_s,
        strains: all()
            .map(|response| {
                let x = response.locations.iter().map(|location| location.strain.x);
                let y = response.locations.iter().map(|location| location.strain.y);
                x.chain(y).collect()
            })
            .collect(),
        reactions: all().map(|response| response.reaction_n).collect(),
        slopes: slopes.to_vec(),
    }
}

fn row(own: &Answers, truth: &Answers) -> String {
    let pairs = own.strains.iter().zip(&truth.strains);
    let errors: Vec<Vec<f64>> = pairs
        .map(|(own, truth)| own.iter().zip(truth).map(|(a, b)| a - b).collect())
        .collect();
    let all: Vec<f64> = errors.concat();
    let at_cut = &errors[0];
    let change = |errors: &Vec<f64>| largest(errors.iter().zip(at_cut).map(|(a, b)| a - b));
    let changes = errors.iter().map(change);
    let rms = (all.iter().map(|error| error * error).sum::<f64>() / all.len() as f64).sqrt();
    let reactions = own.reactions.iter().zip(&truth.reactions);
    let slopes = [0, 1, 2].map(|k| {
        // Of the largest: a slope that passes through zero has no relative error.
        let scale = largest(truth.slopes.iter().map(|slopes| slopes[k]));
        let pairs = own.slopes.iter().zip(&truth.slopes);
        largest(pairs.map(|(own, truth)| own[k] - truth[k])) / scale
    });
    format!(
        "{} | {:.1} | {:.1e} | {:.1e} | {:.1e} | {:.1e} | {:.1} % | {:.1} % | {:.1} %",
        own.unknowns,
        own.cpu_s,
        largest(all.iter().copied()),
        rms,
        largest(changes),
        largest(reactions.map(|(own, truth)| own / truth - 1.0)),
        100.0 * slopes[0],
        100.0 * slopes[1],
        100.0 * slopes[2],
    )
}
