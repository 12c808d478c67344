//! A tire pressed so deep that its wall folds onto itself, end to end: the solve ends with that status, and the depth it names is the one at
//! which the gap between parts of the deformed inner surface closes.
//!
//! The wall folds beside the clamped bead, over two or three bricks, so the depth belongs to this mesh.

use std::sync::atomic::AtomicBool;

use fem::problem::State;
use fem_client::scene::{Level, Scene};
use fem_client::solver::{NoEquilibrium, Readout, SolveError, SolveRequest, Solved, Solver};
use tire::embedded::EmbeddedSolver;
use tire::mesh::tire_grid::Extent;
use tire::model::{TireModel, mesh_plan};

static RUNNING: AtomicBool = AtomicBool::new(false);

const TOO_DEEP: f64 = 12.5;
/// The search of the first contact halves the way to the depths seven times.
const BRACKET: f64 = TOO_DEEP / 128.0;
/// Step of the depths at which the gap is measured, mm.
const STEP: f64 = 0.2;

fn pressed(depth: f64) -> Scene {
    let mut scene = Scene::preset("foot-tire").expect("the preset ships");
    scene.model.level = Level::Draft;
    scene.ground.depths_mm = vec![depth; scene.ground.stations];
    scene
}

fn solve(scene: &Scene) -> Result<Solved, SolveError> {
    EmbeddedSolver::default().solve(&SolveRequest {
        scene,
        readout: &Readout::default(),
        start: None,
        watch: &RUNNING,
    })
}

/// Smallest distance, mm, of a node of the inner surface from an edge of another node in its own meridional section.
fn gap(depth: f64) -> f64 {
    let scene = pressed(depth);
    let solved = solve(&scene).expect("an equilibrium");
    let plan = mesh_plan(&scene, Level::Draft);
    let model = TireModel::new(&scene, &plan, Extent::Quarter);
    let state = model
        .fit(&solved.state.equilibrium)
        .expect("it was solved on this mesh");
    let rows = model.grid.inner_surface().face_count() / plan.meridional;
    let sections = (0..rows).map(|row| section(&model, &state, row, plan.meridional));
    sections
        .map(|line| smallest_distance(&line))
        .fold(f64::INFINITY, f64::min)
}

/// A section at the beginning of a row of bricks, from crown to bead: radial and lateral coordinates.
fn section(model: &TireModel, state: &State, row: usize, bricks: usize) -> Vec<[f64; 2]> {
    let surface = model.grid.inner_surface();
    let faces: Vec<&[u32]> = surface.iter().skip(row * bricks).take(bricks).collect();
    let ends = faces.iter().map(|face| face[0]);
    let bead = faces[bricks - 1][1];
    let mesh = &model.problem.mesh;
    let nodes = ends.chain([bead]);
    nodes
        .map(|node| {
            let [x0, _, z0] = mesh.nodes[node as usize];
            let [x, y, z] = state.position(mesh, node);
            [(x * x0 + z * z0) / x0.hypot(z0), y]
        })
        .collect()
}

fn smallest_distance(line: &[[f64; 2]]) -> f64 {
    let pairs = (0..line.len()).flat_map(|k| {
        let others = (0..line.len() - 1).filter(move |&edge| edge != k && edge + 1 != k);
        others.map(move |edge| (k, edge))
    });
    pairs
        .map(|(k, edge)| distance(line[k], [line[edge], line[edge + 1]]))
        .fold(f64::INFINITY, f64::min)
}

fn distance(point: [f64; 2], [a, b]: [[f64; 2]; 2]) -> f64 {
    let along = [b[0] - a[0], b[1] - a[1]];
    let from = [point[0] - a[0], point[1] - a[1]];
    let length = along[0].hypot(along[1]);
    let share = (from[0] * along[0] + from[1] * along[1]) / (length * length);
    let share = share.clamp(0.0, 1.0);
    (from[0] - share * along[0]).hypot(from[1] - share * along[1])
}

#[test]
fn a_tire_that_folds_onto_itself_is_named() {
    let error = solve(&pressed(TOO_DEEP)).expect_err("the wall folds");
    let SolveError::NoEquilibrium {
        status,
        detail,
        reached,
    } = error
    else {
        panic!("{error}");
    };
    println!("{detail}");
    assert_eq!(status, NoEquilibrium::SelfContact);
    let last = reached.depths_mm[0];
    assert!(reached.depths_mm.iter().all(|depth| *depth == last));

    // A step short of the contact: just before it the fold has more than one equilibrium, and a solve of its own may find another.
    let depths = [3.0, 2.0, 1.0].map(|steps| last - steps * STEP);
    let gaps = depths.map(gap);
    println!("gaps of {gaps:?} mm at depths of {depths:?} mm");
    assert!(gaps[0] > gaps[1] && gaps[1] > gaps[2] && gaps[2] > 0.0);
    // The gap closes ever faster: between the depth where the parabola through the three ends and the line through the last two.
    let (slower, faster) = (gaps[0] - gaps[1], gaps[1] - gaps[2]);
    assert!(faster > slower);
    let line = depths[2] + gaps[2] * STEP / faster;
    let curvature = faster - slower;
    let slope = faster + 0.5 * curvature;
    let root = (slope * slope + 2.0 * curvature * gaps[2]).sqrt();
    let parabola = depths[2] + STEP * (root - slope) / curvature;
    println!("closed between {parabola} and {line} mm");
    assert!(
        parabola < last + BRACKET && line > last,
        "{parabola} {line}"
    );
}

/// The depth ends on a branch that touches itself in one step; in small ones it doesn't.
#[test]
fn a_touch_after_a_large_step_is_tried_again_in_small_ones() {
    for depth in [12.204, 12.26] {
        let solved = solve(&pressed(depth)).expect("an equilibrium");
        assert!(solved.response.reaction_n > 400.0, "{depth}");
    }
}
