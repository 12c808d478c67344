//! Symmetry against what it leaves out: the whole tire gives what its half and its quarter give.

use std::sync::atomic::AtomicBool;

use fem::newton::iteration::Newton;
use fem::newton::path::{Stability, follow};
use fem::problem::{Loads, State};
use fem_client::scene::{Level, Scene};
use tire::embedded::EmbeddedSolver;
use tire::mesh::tire_grid::Extent;
use tire::model::{TireModel, mesh_plan};

static RUNNING: AtomicBool = AtomicBool::new(false);
/// Newton stops at 1e-8 of the forces, which leaves 1e-8 in a strain: over a radius of 50 mm 5e-7 mm, and 1e-7 of the reaction.
const DISPLACEMENT_TOLERANCE_MM: f64 = 1e-6;
const REACTION_TOLERANCE: f64 = 1e-7;

/// Places of the nodes before and after, mm, and the force of the ground on the whole tire, N.
struct Pressed {
    nodes: Vec<([f64; 3], [f64; 3])>,
    reaction: f64,
}

fn pressed(scene: &Scene, extent: Extent) -> Pressed {
    let model = TireModel::new(scene, &mesh_plan(scene, Level::Draft), extent);
    let mut newton = Newton::new(&model.problem).expect("a valid mesh");
    newton.settings = EmbeddedSolver::settings();
    let mut state = State::reference(&model.problem);
    let unloaded = Loads::default();
    let inflated = Loads {
        pressure: scene.pressure.internal_mpa,
        ..Loads::default()
    };
    let required = Stability::Required;
    let held = follow(
        &mut newton,
        &mut state,
        &unloaded,
        &inflated,
        required,
        &RUNNING,
    );
    held.expect("it holds");
    let on_ground = Loads {
        ground: Some(model.ground_below(&scene.ground, &state)),
        ..inflated
    };
    let solved = newton.solve(&mut state, &on_ground, &RUNNING);
    solved.expect("an equilibrium");
    let contact = model.problem.contact.as_ref().expect("a tread");
    let field = on_ground.ground.as_ref().expect("a ground");
    let mesh = &model.problem.mesh;
    let resultant = contact.resultant(field, |node| state.position(mesh, node));
    let nodes = mesh.nodes.iter().enumerate();
    Pressed {
        nodes: nodes
            .map(|(k, place)| (*place, state.position(mesh, k as u32)))
            .collect(),
        reaction: model.multiplicity() * resultant.load,
    }
}

/// The part's nodes are among the whole's, and go where these go.
fn agree(part: &Pressed, whole: &Pressed) {
    for (place, moved) in &part.nodes {
        let distance =
            |other: &[f64; 3]| (0..3).map(|i| (place[i] - other[i]).powi(2)).sum::<f64>();
        let twin = whole
            .nodes
            .iter()
            .find(|(other, _)| distance(other) < 1e-20);
        let (_, other) = twin.expect("the same grid lines");
        for (a, b) in moved.iter().zip(other) {
            assert!(
                (a - b).abs() < DISPLACEMENT_TOLERANCE_MM,
                "{place:?}: {a} {b}"
            );
        }
    }
    let off = (part.reaction / whole.reaction - 1.0).abs();
    assert!(
        off < REACTION_TOLERANCE,
        "{} {}",
        part.reaction,
        whole.reaction
    );
}

#[test]
fn the_half_answers_for_the_whole_on_any_ground() {
    let mut scene = Scene::preset("foot-tire").expect("ships");
    scene.ground.depths_mm = vec![0.7, 1.3, 1.0, 0.8, 1.2];
    agree(
        &pressed(&scene, Extent::Half),
        &pressed(&scene, Extent::Full),
    );
}

#[test]
fn the_quarter_answers_for_the_whole_on_a_symmetric_ground() {
    let mut scene = Scene::preset("foot-tire").expect("ships");
    scene.ground.depths_mm = vec![0.7, 1.3, 1.0, 1.3, 0.7];
    agree(
        &pressed(&scene, Extent::Quarter),
        &pressed(&scene, Extent::Full),
    );
}
