//! The reference tire on a flat ground that presses with a force, beside the same tire pressed to the depth where it does.

use std::sync::atomic::AtomicBool;

use fem_client::scene::{Level, Scene};
use fem_client::solver::{Readout, Response, SolveError, SolveRequest, Solved, Solver, StartState};
use tire::embedded::EmbeddedSolver;

static RUNNING: AtomicBool = AtomicBool::new(false);

/// Tolerance of the force, relative.
const FORCE: f64 = 1e-6;
/// Residual of an equilibrium to 1e-8 of the forces that meet at the nodes, some hundreds of N: what it may lack of a force that nobody asked for, N.
const RESIDUAL: f64 = 1e-5;
/// Change of a strain that a force off by that may make: strains are below 0.3, and grow at most as fast as the force.
const STRAIN: f64 = 1e-6;

fn foot_tire(level: Level) -> Scene {
    let mut scene = Scene::preset("foot-tire").expect("the preset ships");
    scene.model.level = level;
    scene
}

fn loaded(level: Level, load_n: f64) -> Scene {
    let mut scene = foot_tire(level);
    scene.ground.depths_mm.clear();
    scene.ground.load_n = Some(load_n);
    scene
}

fn solve(scene: &Scene, start: Option<&StartState>) -> Result<Solved, SolveError> {
    EmbeddedSolver::default().solve(&SolveRequest {
        scene,
        readout: &Readout::default(),
        start,
        watch: &RUNNING,
    })
}

/// Solves at the depth of an answer.
fn to_its_depth(scene: &Scene, response: &Response) -> Solved {
    let mut scene = scene.clone();
    let depth = response.depth_mm;
    scene.ground = scene.ground.at_depths(vec![depth; scene.ground.stations]);
    solve(&scene, None).expect("the equilibrium that was found by force")
}

fn largest_difference(a: &Response, b: &Response) -> f64 {
    let pairs = a.locations.iter().zip(&b.locations);
    let strains = pairs.flat_map(|(a, b)| [a.strain.x - b.strain.x, a.strain.y - b.strain.y]);
    strains.fold(0.0, |largest, difference| largest.max(difference.abs()))
}

#[test]
fn a_force_gives_the_equilibrium_of_its_depth_in_as_many_iterations() {
    for (level, loads) in [
        (Level::Draft, vec![0.01, 0.1, 1.0, 5.0, 30.0]),
        (Level::Coarse, vec![0.1, 13.0, 60.0]),
    ] {
        let start = solve(&loaded(level, 13.0), None).expect("an equilibrium");
        for load in loads {
            assert_force_is_its_depth(&loaded(level, load), load, &start.state);
        }
    }
}

fn assert_force_is_its_depth(scene: &Scene, load: f64, start: &StartState) {
    let by_force = solve(scene, None).expect("an equilibrium");
    let response = &by_force.response;
    assert!((response.reaction_n / load - 1.0).abs() < FORCE, "{load} N");
    let by_depth = to_its_depth(scene, response);
    let lacking = (by_depth.response.reaction_n - load).abs();
    assert!(lacking < FORCE * load + RESIDUAL, "{lacking} of {load} N");
    let difference = largest_difference(response, &by_depth.response);
    assert!(difference < STRAIN, "{difference} at {load} N");
    let iterations = [&by_force, &by_depth].map(|solved| solved.cost.newton_iterations);
    assert!(
        iterations[0] <= 2 * iterations[1],
        "{iterations:?} at {load} N"
    );
    let near = solve(scene, Some(start)).expect("an equilibrium");
    let difference = largest_difference(response, &near.response);
    assert!(difference < STRAIN, "{difference} from nearby at {load} N");
    assert!(
        near.cost.newton_iterations <= 2 * iterations[0],
        "from nearby at {load} N"
    );
}

#[test]
fn no_force_is_the_inflated_tire_on_ground_that_touches() {
    let solved = solve(&loaded(Level::Draft, 0.0), None).expect("an equilibrium");
    assert_eq!(solved.response.depth_mm, 0.0);
    assert!(solved.response.reaction_n.abs() < 1e-9);
    assert!(
        solved
            .response
            .locations
            .iter()
            .all(|l| l.strain.x.abs() < STRAIN && l.strain.y.abs() < STRAIN)
    );
}

#[test]
fn friction_is_met_by_the_same_force() {
    let mut scene = loaded(Level::Draft, 13.0);
    scene.contact.friction = 0.5;
    let rough = solve(&scene, None).expect("an equilibrium").response;
    assert!((rough.reaction_n / 13.0 - 1.0).abs() < FORCE);
    let smooth = solve(&loaded(Level::Draft, 13.0), None)
        .expect("an equilibrium")
        .response;
    // Held points bear a little more.
    assert!(rough.depth_mm < smooth.depth_mm);
}

/// The tire touches itself near 10 mm, at some 270 N on the coarse mesh; the draft mesh, too coarse for that fold, is crushed at some 400 N.
#[test]
fn a_load_that_no_tire_bears_ends_with_the_load_that_it_did() {
    let load = 500.0;
    let error = solve(&loaded(Level::Draft, load), None)
        .map(|_| ())
        .expect_err("too much");
    let SolveError::NoEquilibrium {
        detail, reached, ..
    } = error
    else {
        panic!("{error}");
    };
    assert!(
        detail.contains(&format!("the load of {load} N")),
        "{detail}"
    );
    let borne = reached.load_n.expect("a load");
    assert!((150.0..500.0).contains(&borne), "{borne} N: {detail}");
    assert!(
        reached
            .depths_mm
            .iter()
            .all(|depth| (5.0..12.5).contains(depth)),
        "{reached:?}"
    );
}
