//! The reference tire on ground that is dragged along the wheel (x) and across it (y) once it presses.

use std::sync::atomic::AtomicBool;

use fem::newton::iteration::{LargestStep, Newton};
use fem::newton::path::{Stability, follow};
use fem::problem::{Loads, State};
use fem_client::scene::{Film, Level, Scene};
use fem_client::solver::gauge::Gauge;
use fem_client::solver::{
    NoEquilibrium, Readout, Response, SolveError, SolveRequest, Solved, Solver, StartState,
};
use tire::embedded::EmbeddedSolver;
use tire::mesh::tire_grid::Extent;
use tire::model::{TireModel, drag_steps, extent, mesh_plan, press_steps};

static RUNNING: AtomicBool = AtomicBool::new(false);
const FRICTION: f64 = 0.5;
/// Newton stops at 1e-8 of the forces, which leaves 1e-8 in a strain at a time; friction adds up what is left in each of the two dozen steps.
const STRAIN: f64 = 1e-6;
/// Tolerance of the forces, relative to the reaction, for the same reason.
const FORCE: f64 = 1e-5;

fn dragged(depths: [f64; 5], shift: [f64; 2]) -> Scene {
    let mut scene = Scene::preset("foot-tire").expect("the preset ships");
    scene.model.level = Level::Draft;
    scene.contact.friction = FRICTION;
    scene.ground.depths_mm = depths.to_vec();
    scene.ground.shift_mm = shift;
    scene
}

/// Strain along the circumference, along the section and between, on both sides of the middle plane.
fn readout() -> Readout {
    let sides = [-50.0, 50.0].into_iter();
    let gauges = sides.flat_map(|phi_deg| {
        [0.0, 90.0].map(|angle_deg| Gauge {
            theta_deg: 4.0,
            phi_deg,
            angle_deg,
        })
    });
    Readout {
        gauges: gauges.collect(),
        ..Readout::default()
    }
}

fn answer(
    solver: &EmbeddedSolver,
    scene: &Scene,
    start: Option<&StartState>,
) -> Result<Solved, SolveError> {
    solver.solve(&SolveRequest {
        scene,
        readout: &readout(),
        start,
        watch: &RUNNING,
    })
}

fn solve(scene: &Scene) -> Response {
    let solved = answer(&EmbeddedSolver::default(), scene, None);
    solved.expect("an equilibrium").response
}

fn force(response: &Response) -> [f64; 3] {
    response.force_n.expect("the embedded solver tells")
}

/// Strains at P1, P2, ..., x and y of each.
fn strains(response: &Response) -> Vec<[f64; 2]> {
    let locations = response.locations.iter();
    locations.map(|at| [at.strain.x, at.strain.y]).collect()
}

fn assert_close(a: &[[f64; 2]], b: &[[f64; 2]]) {
    assert_eq!(a.len(), b.len());
    for (a, b) in a.as_flattened().iter().zip(b.as_flattened()) {
        assert!((a - b).abs() < STRAIN, "{a} {b}");
    }
}

fn assert_forces(found: [f64; 3], expected: [f64; 3]) {
    for (a, b) in found.iter().zip(&expected) {
        assert!(
            (a - b).abs() < FORCE * expected[2],
            "{found:?} {expected:?}"
        );
    }
}

#[test]
fn ground_that_is_not_dragged_pulls_nothing() {
    let still = solve(&dragged([1.0; 5], [0.0; 2]));
    assert_eq!(force(&still), [0.0, 0.0, still.reaction_n]);
    assert_eq!(still.residual_history.len(), press_steps(Level::Draft));
    assert!(
        still
            .model
            .modelled
            .iter()
            .all(|choice| choice.what != "shear")
    );
}

/// Mirrored shifts, solved from nothing each, on the half tire.
#[test]
fn a_mirrored_shift_gives_mirrored_strains_and_the_opposite_pull() {
    let ahead = solve(&dragged([1.2, 1.0, 0.9, 1.1, 0.8], [0.3, 0.0]));
    let back = solve(&dragged([0.8, 1.1, 0.9, 1.0, 1.2], [-0.3, 0.0]));
    assert_eq!(ahead.model.dimension, "3d-half");
    let steps = press_steps(Level::Draft) + drag_steps(Level::Draft);
    assert_eq!(ahead.residual_history.len(), steps);
    assert!(
        ahead
            .model
            .modelled
            .iter()
            .any(|choice| choice.what == "shear")
    );
    let [x, y, load] = force(&ahead);
    assert!(
        x > 0.1 * load && y == 0.0 && load == ahead.reaction_n,
        "{x} {y} {load}"
    );
    assert_forces(force(&back), [-x, y, load]);
    let mut mirrored = strains(&back);
    mirrored.reverse();
    assert_close(&strains(&ahead), &mirrored);
    assert!(
        (mirrored[1][0] - mirrored[3][0]).abs() > 0.001,
        "{mirrored:?}"
    );
}

#[test]
fn the_half_answers_for_the_whole_tire_on_ground_dragged_along() {
    let half = solve(&dragged([1.0; 5], [0.3, 0.0]));
    // A picometre across asks for the whole tire and changes nothing else.
    let whole = solve(&dragged([1.0; 5], [0.3, 1e-9]));
    let extents = [&half, &whole].map(|response| response.model.dimension.as_str());
    assert_eq!(extents, ["3d-half", "3d"]);
    assert_close(&strains(&half), &strains(&whole));
    assert_forces(force(&whole), force(&half));
}

#[test]
fn the_front_answers_for_the_whole_tire_on_ground_dragged_across() {
    let front = solve(&dragged([1.0; 5], [0.0, 0.3]));
    let whole = solve(&dragged([1.0; 5], [1e-9, 0.3]));
    let extents = [&front, &whole].map(|response| response.model.dimension.as_str());
    assert_eq!(extents, ["3d-half", "3d"]);
    assert_close(&strains(&front), &strains(&whole));
    assert_forces(force(&whole), force(&front));
}

#[test]
fn a_shift_across_swaps_the_sides_of_the_section() {
    let [left, right] = [-0.3, 0.3].map(|y| solve(&dragged([1.0; 5], [0.0, y])));
    assert_eq!(left.model.dimension, "3d-half");
    let [x, y, load] = force(&right);
    assert!(y > 0.1 * load && x == 0.0, "{x} {y} {load}");
    assert_forces(force(&left), [x, -y, load]);
    assert_close(&strains(&left), &strains(&right));
    let sides = |response: &Response| -> [[f64; 2]; 2] {
        let gauges = &response.gauges;
        [
            [gauges[0].strain, gauges[1].strain],
            [gauges[2].strain, gauges[3].strain],
        ]
    };
    let ([near, far], [others_near, others_far]) = (sides(&left), sides(&right));
    assert_close(&[near, far], &[others_far, others_near]);
    assert!((near[1] - far[1]).abs() > 0.001, "{near:?} {far:?}");
}

/// Mirrored grounds are solved once from one start, and no ground answers for one that is dragged elsewhere.
#[test]
fn only_the_mirror_image_is_taken_for_a_dragged_ground() {
    let solver = EmbeddedSolver::default();
    let from_nothing = |scene: &Scene| answer(&solver, scene, None).expect("an equilibrium");
    let centre = from_nothing(&dragged([1.0; 5], [0.0; 2])).state;
    let near = |depths, shift| {
        let solved = answer(&solver, &dragged(depths, shift), Some(&centre));
        solved.expect("an equilibrium")
    };
    let (uneven, image) = ([1.2, 1.0, 0.9, 1.1, 0.8], [0.8, 1.1, 0.9, 1.0, 1.2]);
    let ahead = near(uneven, [0.3, 0.0]);
    assert!(ahead.cost.newton_iterations > 0);
    for other in [(image, [0.3, 0.0]), (uneven, [0.0; 2])] {
        assert!(
            near(other.0, other.1).cost.newton_iterations > 0,
            "{other:?}"
        );
    }
    let back = near(image, [-0.3, 0.0]);
    assert_eq!(back.cost.newton_iterations, 0);
    let afresh = from_nothing(&dragged(image, [-0.3, 0.0])).response;
    assert_close(&strains(&back.response), &strains(&afresh));
    assert_forces(force(&back.response), force(&afresh));
    // A dragged start is as good as one that isn't: its tangent serves, and its path is gone again.
    let start = ahead.state;
    let elsewhere = dragged(uneven, [0.1, 0.0]);
    let warm = answer(&solver, &elsewhere, Some(&start)).expect("an equilibrium");
    let cold = from_nothing(&elsewhere).response;
    assert_close(&strains(&warm.response), &strains(&cold));
    assert_forces(force(&warm.response), force(&cold));
}

#[test]
fn dragged_far_the_ground_pulls_with_mu_times_the_reaction() {
    for shift in [[2.0, 0.0], [-2.0, 0.0]] {
        let [x, _, load] = force(&solve(&dragged([1.0; 5], shift)));
        let ratio = x.signum() * shift[0].signum() * x.abs() / (FRICTION * load);
        // Points that slipped across while the tire was pressed still do, a little.
        assert!(ratio > 0.999 && ratio < 1.0 + FORCE, "{ratio}");
    }
}

#[test]
fn ground_that_presses_with_a_force_keeps_it() {
    let mut scene = dragged([1.0; 5], [0.3, 0.0]);
    scene.ground.depths_mm.clear();
    scene.ground.load_n = Some(13.0);
    let by_force = solve(&scene);
    assert!((by_force.reaction_n / 13.0 - 1.0).abs() < 1e-6);
    scene.ground.shift_mm = [0.0; 2];
    let still = solve(&scene);
    // A sheared wall gives way: at the same force the ground stands higher.
    assert!(by_force.depth_mm > still.depth_mm);
    let [x, _, _] = force(&by_force);
    assert!(x > 1.0 && x < 13.0 * FRICTION, "{x} N");
}

/// The bead holds what the ground pulls: its reactions come from all of the body's stresses, the pull from the springs of friction.
#[test]
fn the_bead_holds_what_the_ground_pulls() {
    for (shift, axis) in [([0.3, 0.0], 0), ([0.0, 0.3], 1)] {
        let scene = dragged([1.0; 5], shift);
        let model = TireModel::new(&scene, &mesh_plan(&scene, Level::Draft), extent(&scene));
        let mut newton = Newton::new(&model.problem).expect("a valid mesh");
        newton.settings = EmbeddedSolver::settings();
        let mut state = State::reference(&model.problem);
        let inflated = Loads {
            pressure: scene.pressure.internal_mpa,
            ..Loads::default()
        };
        let mut reach = |newton: &mut Newton<'_>, start: &Loads, target: &Loads, step| {
            newton.settings.largest_load_step = step;
            let ignored = Stability::Ignored;
            follow(newton, &mut state, start, target, ignored, &RUNNING).expect("an equilibrium");
            state.clone()
        };
        let once = LargestStep::Even(1.0);
        let state = reach(&mut newton, &Loads::default(), &inflated, once);
        let on_ground = Loads {
            ground: Some(model.ground_below(&scene.ground, &state)),
            ..inflated.clone()
        };
        let undragged = on_ground.with_shift([0.0; 2]);
        let steps = [press_steps(Level::Draft), drag_steps(Level::Draft)];
        let [press, drag] = steps.map(|steps| 1.0 / steps as f64);
        reach(
            &mut newton,
            &inflated,
            &undragged,
            LargestStep::OfRoot(press),
        );
        let state = reach(&mut newton, &undragged, &on_ground, LargestStep::Even(drag));
        let held = newton.reactions(&state, &on_ground);
        let held: f64 = held.iter().map(|reaction| reaction[axis]).sum();
        let pull = force(&solve(&scene));
        println!(
            "pulled {:?} N, held {} N",
            pull,
            model.multiplicity() * held
        );
        let sum = pull[axis] + model.multiplicity() * held;
        assert!(sum.abs() < FORCE * pull[2], "{pull:?} {held}");
    }
}

/// No rubber grips like this: the tread digs in, and the wall buckles.
#[test]
fn a_tire_that_cannot_be_dragged_so_far_says_how_far_it_was() {
    let mut scene = dragged([1.0; 5], [12.5, 0.0]);
    scene.contact.friction = 2.0;
    let solved = answer(&EmbeddedSolver::default(), &scene, None);
    match solved.map(|solved| solved.response.force_n) {
        Err(SolveError::NoEquilibrium {
            status,
            detail,
            reached,
        }) => {
            assert_eq!(status, NoEquilibrium::LimitPoint);
            assert!(detail.starts_with("dragging stopped at "), "{detail}");
            assert!(
                detail.contains("% of the way to the shift [12.5, 0.0] mm"),
                "{detail}"
            );
            assert_eq!(reached.depths_mm, [1.0; 5]);
        }
        other => panic!("{other:?}"),
    }
}

/// The half tire has a film's mirror image, which a ground dragged across doesn't leave one.
#[test]
fn both_sides_have_a_film_without_its_twin() {
    let mut scene = dragged([1.0; 5], [0.3, 0.0]);
    let film = Film {
        phi_deg: 45.0,
        ..Film::default()
    };
    scene.film = Some(film);
    let film_of = |scene: &Scene| {
        let model = TireModel::new(scene, &mesh_plan(scene, Level::Draft), extent(scene));
        let summary = model.summary(scene, 0);
        let film = summary
            .modelled
            .into_iter()
            .find(|choice| choice.what == "film");
        (model.grid.extent, film.expect("it is modelled").why)
    };
    let (half, with_twin) = film_of(&scene);
    assert!(
        half == Extent::Half && with_twin.contains("its mirror image"),
        "{with_twin}"
    );
    scene.ground.shift_mm = [0.0, 0.3];
    let (front, alone) = film_of(&scene);
    assert!(
        front == Extent::Front && !alone.contains("its mirror image"),
        "{alone}"
    );
}
