//! The reference tire: limit cases, symmetries, and what an answer may not depend on.

use std::sync::atomic::AtomicBool;

use fem::newton::iteration::Newton;
use fem::newton::path::{Stability, follow};
use fem::problem::{Loads, State};
use fem_client::scene::{Law, Level, Scene};
use fem_client::solver::{
    NoEquilibrium, Readout, SolveError, SolveRequest, Solved, Solver, StartState,
};
use tire::embedded::EmbeddedSolver;
use tire::mesh::tire_grid::Extent;
use tire::model::{TireModel, mesh_plan};

static RUNNING: AtomicBool = AtomicBool::new(false);

fn scene(level: Level, depths: [f64; 5]) -> Scene {
    let mut scene = Scene::preset("foot-tire").expect("the preset ships");
    scene.model.level = level;
    scene.ground.depths_mm = depths.to_vec();
    scene
}

/// The reference scene of the independent solution: kappa / mu = 1000 and a penalty of 100 N/mm^3.
fn reference(level: Level, depth: f64) -> Scene {
    let mut scene = scene(level, [depth; 5]);
    scene.material.d1_per_mpa = 2.0 / 360.0;
    scene.contact.penalty_n_per_mm3 = Some(100.0);
    scene
}

fn solve(scene: &Scene, start: Option<&StartState>) -> Result<Solved, SolveError> {
    let readout = Readout::default();
    EmbeddedSolver::default().solve(&SolveRequest {
        scene,
        readout: &readout,
        start,
        watch: &RUNNING,
    })
}

/// Contact is solved in full inside each iteration, so that with a new tangent every time the pressed tire converges as
/// quadratically as any smooth problem, however many contact points open and close.
#[test]
fn newton_is_quadratic_on_the_pressed_tire() {
    let scene = reference(Level::Draft, 1.0);
    let model = TireModel::new(&scene, &mesh_plan(&scene, Level::Draft), Extent::Quarter);
    let mut newton = Newton::new(&model.problem).expect("a valid mesh");
    newton.settings.tolerance = 1e-12;
    newton.settings.renewal_cost = 0.0;
    let mut state = State::reference(&model.problem);
    let inflated = Loads {
        pressure: scene.pressure.internal_mpa,
        ..Loads::default()
    };
    let unloaded = Loads::default();
    let required = Stability::Required;
    follow(
        &mut newton,
        &mut state,
        &unloaded,
        &inflated,
        required,
        &RUNNING,
    )
    .expect("it holds");
    let pressed = Loads {
        ground: Some(model.ground_below(&scene.ground, &state)),
        ..inflated
    };
    let solved = newton
        .solve(&mut state, &pressed, &RUNNING)
        .expect("an equilibrium");
    let history: Vec<f64> = solved.history.iter().map(|r| r.worst()).collect();
    println!("relative residuals: {history:?}");
    let tail: Vec<f64> = history
        .into_iter()
        .filter(|r| (1e-13..1e-3).contains(r))
        .collect();
    assert!(tail.len() >= 2, "{tail:?}");
    for pair in tail.windows(2) {
        println!(
            "residual over squared residual before it: {:.0}",
            pair[1] / pair[0].powi(2)
        );
        // The constant is the problem's own; the bound of 1e4 was set after seeing 419 and 5. Penalty contact left in
        // the iteration gave 1e5 and more.
        assert!(pair[1] < 1e4 * pair[0].powi(2) + 1e-13, "{tail:?}");
    }
}

#[test]
fn an_incompressible_tire_keeps_its_volume() {
    let solved = solve(&scene(Level::Standard, [1.0; 5]), None).expect("an equilibrium");
    assert!(
        solved.response.max_volume_change < 1e-8,
        "{}",
        solved.response.max_volume_change
    );
}

#[test]
fn without_depth_there_is_no_reaction_and_no_strain() {
    let response = solve(&scene(Level::Draft, [0.0; 5]), None)
        .expect("an equilibrium")
        .response;
    assert_eq!(response.reaction_n, 0.0);
    for location in &response.locations {
        assert!(location.strain.x.abs() < 1e-9 && location.strain.y.abs() < 1e-9);
    }
}

#[test]
fn a_tire_without_pressure_stands_on_its_wall() {
    let mut flat = scene(Level::Draft, [1.0; 5]);
    flat.pressure.internal_mpa = 0.0;
    let response = solve(&flat, None).expect("an equilibrium").response;
    let inflated = solve(&scene(Level::Draft, [1.0; 5]), None)
        .expect("an equilibrium")
        .response;
    assert_eq!(response.inflated.crown_stretch.x, 1.0);
    assert!(response.reaction_n > 0.0 && response.reaction_n < inflated.reaction_n);
}

/// The paper's rubber in all the forms that contain it, and two others with the same shear modulus.
#[test]
fn laws_that_are_the_same_rubber_give_the_same_tire() {
    let with = |law| {
        let mut scene = scene(Level::Draft, [1.0; 5]);
        scene.material.law = law;
        solve(&scene, None).expect("an equilibrium")
    };
    assert_same(
        &with(Law::of_name("mooney-rivlin").expect("a law")),
        &with(Law::of_name("ogden").expect("a law")),
    );
    let neo_hookean = with(Law::of_name("neo-hookean").expect("a law"));
    assert_same(&neo_hookean, &with(Law::of_name("yeoh").expect("a law")));
    // Strains of 5 to 10 % hardly tell laws of one shear modulus apart.
    let reaction = with(Law::of_name("mooney-rivlin").expect("a law"))
        .response
        .reaction_n;
    let ratio = neo_hookean.response.reaction_n / reaction;
    println!("neo-Hookean over Mooney-Rivlin reaction: {ratio:.5}");
    assert!((ratio - 1.0).abs() < 0.01 && ratio != 1.0, "{ratio}");
}

#[test]
fn twice_the_stiffness_gives_twice_the_reaction() {
    let base = reference(Level::Draft, 1.0);
    let mut stiff = base.clone();
    stiff.material.law = Law::MooneyRivlin {
        c10_mpa: 0.288,
        c01_mpa: 0.072,
    };
    stiff.material.d1_per_mpa /= 2.0;
    stiff.pressure.internal_mpa *= 2.0;
    stiff.contact.penalty_n_per_mm3 = Some(200.0);
    stiff
        .carcass
        .as_mut()
        .expect("the preset has a carcass")
        .stiffness_n_per_mm *= 2.0;
    let (base, stiff) = (
        solve(&base, None).unwrap().response,
        solve(&stiff, None).unwrap().response,
    );
    assert!((stiff.reaction_n / base.reaction_n - 2.0).abs() < 1e-6);
    assert!((stiff.locations[2].strain.y - base.locations[2].strain.y).abs() < 1e-9);
}

/// Newton stops at a relative residual of 1e-8; the strains follow the forces with a factor of order 10 at most.
const SOLVER_TOLERANCE: f64 = 1e-7;

fn assert_same(a: &Solved, b: &Solved) {
    let (a, b) = (&a.response, &b.response);
    assert!(
        (a.reaction_n / b.reaction_n - 1.0).abs() < SOLVER_TOLERANCE,
        "{} {}",
        a.reaction_n,
        b.reaction_n
    );
    for (p, q) in a.locations.iter().zip(&b.locations) {
        assert!(
            (p.strain.x - q.strain.x).abs() < SOLVER_TOLERANCE,
            "x at {}: {} {}",
            p.name,
            p.strain.x,
            q.strain.x
        );
        assert!(
            (p.strain.y - q.strain.y).abs() < SOLVER_TOLERANCE,
            "y at {}: {} {}",
            p.name,
            p.strain.y,
            q.strain.y
        );
    }
}

#[test]
fn the_result_does_not_depend_on_the_start() {
    let centre = solve(&scene(Level::Draft, [1.0; 5]), None).unwrap().state;
    for depths in [
        [1.0, 1.2, 0.8, 1.0, 1.3],
        [0.0, 1.0, 2.0, 0.5, 1.0],
        [1.0, 1.0, 1.3, 1.0, 1.0],
    ] {
        let scene = scene(Level::Draft, depths);
        let (cold, warm) = (
            solve(&scene, None).unwrap(),
            solve(&scene, Some(&centre)).unwrap(),
        );
        assert_same(&cold, &warm);
        assert!(warm.cost.newton_iterations < cold.cost.newton_iterations);
    }
    // Another pressure: the start's inflated state is no longer this scene's.
    let mut scene = scene(Level::Draft, [1.0; 5]);
    scene.pressure.internal_mpa = 0.15;
    assert_same(
        &solve(&scene, None).unwrap(),
        &solve(&scene, Some(&centre)).unwrap(),
    );
}

/// Mirrored grounds are solved once from the cut point; from nothing each is solved on its own mesh, as it stands.
#[test]
fn mirrored_ground_gives_mirrored_strains() {
    let centre = solve(&scene(Level::Draft, [1.0; 5]), None).unwrap().state;
    let solver = EmbeddedSolver::default();
    let near = |depths| {
        let scene = scene(Level::Draft, depths);
        let request = SolveRequest {
            scene: &scene,
            readout: &Readout::default(),
            start: Some(&centre),
            watch: &RUNNING,
        };
        solver.solve(&request).unwrap()
    };
    let left = near([1.3, 0.8, 1.0, 1.1, 0.6]);
    let right = near([0.6, 1.1, 1.0, 0.8, 1.3]);
    assert!(left.cost.newton_iterations > 0);
    assert_eq!(right.cost.newton_iterations, 0);
    let afresh = solve(&scene(Level::Draft, [0.6, 1.1, 1.0, 0.8, 1.3]), None).unwrap();
    assert_same(&right, &afresh);
    let pairs = left
        .response
        .locations
        .iter()
        .zip(right.response.locations.iter().rev());
    for (l, r) in pairs {
        assert!((l.strain.x - r.strain.x).abs() < SOLVER_TOLERANCE);
        assert!((l.strain.y - r.strain.y).abs() < SOLVER_TOLERANCE);
    }
}

#[test]
fn a_quarter_model_is_the_half_model_of_a_symmetric_scene() {
    let quarter = solve(&scene(Level::Draft, [1.0; 5]), None).unwrap();
    assert_eq!(quarter.response.model.dimension, "3d-quarter");
    // A difference of 1e-12 mm left to right asks for the half model and changes nothing else.
    let half = solve(
        &scene(Level::Draft, [1.0, 1.0, 1.0, 1.0, 1.0 + 1e-12]),
        None,
    )
    .unwrap();
    assert_eq!(half.response.model.dimension, "3d-half");
    assert_same(&quarter, &half);
}

#[test]
fn a_wall_that_cannot_hold_its_pressure_is_named() {
    let mut scene = scene(Level::Draft, [1.0; 5]);
    scene.carcass = None;
    match solve(&scene, None) {
        Err(SolveError::NoEquilibrium {
            status,
            detail,
            reached,
        }) => {
            println!("{status:?} at {} MPa: {detail}", reached.pressure_mpa);
            assert_eq!(status, NoEquilibrium::LimitPoint);
            // An independent code's limit pressure; the draft mesh holds some percent more, as coarse meshes do.
            let limit = reached.pressure_mpa / 0.112;
            assert!(limit > 1.0 && limit < 1.2, "{}", reached.pressure_mpa);
        }
        other => panic!("an unreinforced wall of 3 mm cannot hold 0.2 MPa: {other:?}"),
    }
}
