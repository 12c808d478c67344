//! The installed CalculiX against the embedded solver, on an unreinforced tire that both can model. Without CalculiX these
//! tests say so and pass.

use std::path::Path;
use std::sync::atomic::AtomicBool;
use std::time::Duration;

use calculix::CalculixSolver;
use fem::cell::element::Order;
use fem_client::scene::{Carcass, Geometry, Law, Level, Scene};
use fem_client::solver::{NoEquilibrium, Readout, SolveError, SolveRequest, Solved, Solver};
use tire::embedded::EmbeddedSolver;
use tire::mesh::tire_grid::MeshPlan;

static RUNNING: AtomicBool = AtomicBool::new(false);
static NO_READOUT: Readout = Readout {
    grid: None,
    shape: false,
    positions: false,
    rings: Vec::new(),
    fine_deg: None,
    gauges: Vec::new(),
    films: Vec::new(),
    derivatives: Vec::new(),
};

/// Difference of one integration point from mean dilatation on the same mesh of some 2 000 nodes, in programs of others: 1.2 % of the reaction, 2.2 %
/// of the meridional strain.
const ELEMENTS_DIFFER: f64 = 0.025;
/// Two bricks through the wall instead of four: four times as much.
const ELEMENTS_DIFFER_ON_DRAFT: f64 = 4.0 * ELEMENTS_DIFFER;
/// CalculiX prints seven digits and is iterated to a residual of 1e-6; strains lose a digit as differences of positions.
const PRINTED: f64 = 1e-5;

/// Fails unless two figures are relatively as close as the tolerance says.
fn assert_close(a: f64, b: f64, tolerance: f64) {
    assert!(
        (a - b).abs() <= tolerance * a.abs().max(b.abs()),
        "{a} and {b}"
    );
}

/// Absent, with the reason printed, where CalculiX isn't installed.
fn calculix() -> Option<CalculixSolver> {
    let solver = CalculixSolver::new(Path::new("ccx"), Duration::from_secs(600));
    solver
        .inspect_err(|error| println!("skipped: {error}"))
        .ok()
}

/// A wall of 8 mm without carcass that holds its pressure, kappa / mu = 100.
fn scene() -> Scene {
    let mut scene = Scene {
        geometry: Geometry {
            outer_radius_mm: 70.0,
            section_radius_mm: 20.0,
            wall_mm: 8.0,
            ..Geometry::default()
        },
        ..Scene::default()
    };
    scene.material.d1_per_mpa = 2.0 / 36.0;
    scene.pressure.internal_mpa = 0.04;
    scene.ground.depths_mm = vec![4.0; 5];
    scene.model.level = Level::Draft;
    scene
}

fn request(scene: &Scene) -> SolveRequest<'_> {
    SolveRequest {
        scene,
        readout: &NO_READOUT,
        start: None,
        watch: &RUNNING,
    }
}

fn plan(refinement: usize) -> MeshPlan {
    MeshPlan {
        order: Order::Linear,
        fine_angle: 0.5,
        fine: 6 * refinement,
        middle: None,
        coarse: 4 * refinement,
        meridional: 8 * refinement,
        meridional_growth: 2.0,
        layers: 2 * refinement,
    }
}

/// Reaction, and strains at the centre.
fn figures(solved: &Solved) -> [f64; 3] {
    let centre = &solved.response.locations[2];
    [solved.response.reaction_n, centre.strain.x, centre.strain.y]
}

#[test]
fn both_solvers_approach_each_other_as_the_mesh_is_refined() {
    assert_approach(&scene());
}

#[test]
#[ignore = "takes half a minute"]
fn both_solvers_approach_each_other_on_a_wheel_that_leans() {
    let mut scene = scene();
    scene.ground.camber_deg = 10.0;
    assert_approach(&scene);
}

/// Asserts that halved bricks bring the solvers together.
fn assert_approach(scene: &Scene) {
    let Some(calculix) = calculix() else { return };
    let difference = |refinement| {
        let plan = plan(refinement);
        let ours = EmbeddedSolver::default()
            .solve_on(&request(scene), &plan)
            .expect("an equilibrium");
        let theirs = calculix
            .solve_on(&request(scene), &plan)
            .expect("an equilibrium");
        assert_eq!(ours.response.model.dofs, theirs.response.model.dofs);
        let (ours, theirs) = (figures(&ours), figures(&theirs));
        [0, 1, 2].map(|k| (theirs[k] / ours[k] - 1.0).abs())
    };
    let (coarse, fine) = (difference(1), difference(2));
    println!("relative differences of reaction, x and y: {coarse:?}, then {fine:?}");
    for (coarse, fine) in coarse.into_iter().zip(fine) {
        // Both elements are of second order: a quarter is left where the terms beyond it are small, half is safe.
        assert!(fine < 0.5 * coarse, "{coarse} then {fine}");
        assert!(fine < ELEMENTS_DIFFER, "{fine}");
    }
}

#[test]
fn an_uneven_ground_and_its_mirror_image_give_mirrored_strains() {
    let Some(calculix) = calculix() else { return };
    let uneven = |depths: [f64; 5]| {
        let mut scene = scene();
        scene.ground.depths_mm = depths.to_vec();
        scene
    };
    let (there, back) = (
        uneven([2.0, 3.5, 3.0, 2.5, 3.0]),
        uneven([3.0, 2.5, 3.0, 3.5, 2.0]),
    );
    let solve = |solver: &dyn Solver, scene: &Scene| {
        solver
            .solve(&request(scene))
            .expect("an equilibrium")
            .response
    };
    let (one, other) = (solve(&calculix, &there), solve(&calculix, &back));
    assert_close(one.reaction_n, other.reaction_n, PRINTED);
    for (a, b) in one.locations.iter().zip(other.locations.iter().rev()) {
        assert_close(a.strain.x, b.strain.x, PRINTED);
        assert_close(a.strain.y, b.strain.y, PRINTED);
    }
    let embedded = solve(&EmbeddedSolver::default(), &there);
    assert_close(
        one.reaction_n,
        embedded.reaction_n,
        ELEMENTS_DIFFER_ON_DRAFT,
    );
    for (a, b) in one.locations.iter().zip(&embedded.locations) {
        assert_close(a.strain.y, b.strain.y, ELEMENTS_DIFFER_ON_DRAFT);
    }
}

#[test]
fn equal_laws_in_other_words_give_equal_answers() {
    let Some(calculix) = calculix() else { return };
    let solve = |law: Law| {
        let mut scene = scene();
        scene.material.law = law;
        calculix
            .solve(&request(&scene))
            .expect("an equilibrium")
            .response
    };
    let pairs = [
        (
            Law::of_name("neo-hookean").expect("a law"),
            Law::of_name("yeoh").expect("a law"),
        ),
        (
            Law::of_name("mooney-rivlin").expect("a law"),
            Law::of_name("ogden").expect("a law"),
        ),
    ];
    for (one, other) in pairs {
        let (a, b) = (solve(one), solve(other));
        assert_close(a.reaction_n, b.reaction_n, PRINTED);
        for (a, b) in a.locations.iter().zip(&b.locations) {
            assert_close(a.strain.x, b.strain.x, PRINTED);
            assert_close(a.strain.y, b.strain.y, PRINTED);
        }
    }
}

#[test]
fn what_cannot_be_solved_says_why() {
    let Some(calculix) = calculix() else { return };
    let mut burst = scene();
    burst.pressure.internal_mpa = 0.3;
    match calculix.solve(&request(&burst)) {
        Err(SolveError::NoEquilibrium {
            status: NoEquilibrium::NotConverged,
            reached,
            ..
        }) => assert!(reached.pressure_mpa > 0.04 && reached.pressure_mpa < 0.3),
        other => panic!("{other:?}"),
    }
    let reinforced = Scene {
        carcass: Some(Carcass::default()),
        ..scene()
    };
    let refused = calculix.solve(&request(&reinforced));
    assert!(
        matches!(&refused, Err(SolveError::Refused { faults }) if faults[0].pointer == "/carcass"),
        "{refused:?}"
    );
}

#[test]
fn a_run_ends_on_request_and_in_time() {
    let Some(calculix) = calculix() else { return };
    let scene = scene();
    let stop = AtomicBool::new(true);
    let stopped = calculix.solve(&SolveRequest {
        watch: &stop,
        ..request(&scene)
    });
    assert_eq!(stopped.err(), Some(SolveError::Stopped));
    let hasty = CalculixSolver::new(Path::new("ccx"), Duration::ZERO).expect("is installed");
    match hasty.solve(&request(&scene)) {
        Err(SolveError::Broken { detail }) => assert!(detail.contains("0 s"), "{detail}"),
        other => panic!("{other:?}"),
    }
}
