//! Contact and friction of a cube on flat ground.

use std::sync::atomic::AtomicBool;

use crate::cube::{bottom, problem};
use fem::cell::element::Order;
use fem::load::contact::{ContactSurface, Penalty};
use fem::load::friction::Friction;
use fem::load::ground_shape::Profile;
use fem::load::obstacle::{GroundAxes, HeightField, StationFunctions};
use fem::newton::iteration::{LargestStep, Newton};
use fem::newton::path::{Stability, follow};
use fem::problem::{Loads, Problem, State};
use fem::tensor::Vector;

static RUNNING: AtomicBool = AtomicBool::new(false);
const PENALTY: Penalty = Penalty {
    stiffness: 50.0,
    ramp: 1e-3,
};
/// Compression of the cube, mm.
const PRESSED: f64 = 0.1;
/// Newton's tolerance here; forces are compared to ten times that.
const TOLERANCE: f64 = 1e-11;

pub fn flat(depth: f64) -> HeightField {
    HeightField {
        axes: GroundAxes::LEVEL,
        base: 0.0,
        spacing: 1.0,
        functions: StationFunctions::Hat,
        depths: vec![depth],
        shift: [0.0; 2],
        profile: Profile::Plane,
    }
}

/// A distorted cube of 8 bricks whose face z = 0 may touch the ground; the top moves down by [`PRESSED`] and along x by
/// `slide`, both at support factor 1.
pub fn pressed(order: Order, friction: Friction, slide: Option<f64>) -> Problem {
    let mut problem = problem(order, 2, true, 0.1);
    let mut contact = ContactSurface::new(&problem.mesh, bottom(order, 2), PENALTY);
    contact.friction = friction;
    problem.contact = Some(contact);
    for (support, x) in problem.supports.iter_mut().zip(&problem.mesh.nodes) {
        if x[2] == 1.0 {
            support[2] = Some(-PRESSED);
            support[0] = slide;
            support[1] = slide.map(|_| 0.0);
        }
        // Without a slide the cube may widen, held on two planes of symmetry.
        for axis in 0..2 {
            if slide.is_none() && x[axis] == 0.0 {
                support[axis] = Some(0.0);
            }
        }
    }
    problem
}

/// Holds the bottom of a cube sideways, moved by `way` along x at support factor 1.
pub fn hold_bottom(problem: &mut Problem, way: f64) {
    for (support, x) in problem.supports.iter_mut().zip(&problem.mesh.nodes) {
        if x[2] == 0.0 {
            support[0] = Some(way);
            support[1] = Some(0.0);
        }
    }
}

fn solve(problem: &Problem, steps: f64) -> (State, Vector, Vector) {
    let mut newton = Newton::new(problem).expect("a valid mesh");
    newton.settings.tolerance = TOLERANCE;
    newton.settings.largest_load_step = LargestStep::Even(1.0 / steps);
    let mut state = State::reference(problem);
    let at = |support_factor| Loads {
        ground: Some(flat(0.0)),
        support_factor,
        ..Loads::default()
    };
    let (start, target) = (at(0.0), at(1.0));
    follow(
        &mut newton,
        &mut state,
        &start,
        &target,
        Stability::Ignored,
        &RUNNING,
    )
    .expect("an equilibrium");
    let mut top = [0.0; 3];
    for force in newton.reactions(&state, &target) {
        for axis in 0..3 {
            top[axis] += force[axis];
        }
    }
    let contact = problem.contact.as_ref().expect("set above");
    let resultant = contact.resultant(&flat(0.0), |n| state.position(&problem.mesh, n));
    (state, top, resultant.wrench.force)
}

/// Uniform pressure and a homogeneous deformation, whatever the mesh inside; the ground bears what the supports do.
#[test]
fn the_contact_patch_test_is_passed() {
    for order in [Order::Linear, Order::Quadratic] {
        let problem = pressed(order, Friction::NONE, None);
        let (state, top, contact) = solve(&problem, 1.0);
        assert!(contact[2] > 0.0);
        assert!(
            (contact[2] + top[2]).abs() < 10.0 * TOLERANCE * contact[2],
            "{contact:?} {top:?}"
        );
        // All of the bottom sinks in alike: the pressure is the same everywhere.
        let corner = state.displacement[0][2];
        let stretch = 1.0 - PRESSED - corner;
        let side = state
            .displacement
            .iter()
            .zip(&problem.mesh.nodes)
            .find(|(_, x)| x[0] == 1.0);
        let widening = side.expect("a node at x = 1").0[0];
        for (u, x) in state.displacement.iter().zip(&problem.mesh.nodes) {
            let expected = [
                widening * x[0],
                widening * x[1],
                corner + (stretch - 1.0) * x[2],
            ];
            for axis in 0..3 {
                // Round-off and residual times the compliance of a cube, both below 1e-9 of its edge.
                assert!(
                    (u[axis] - expected[axis]).abs() < 1e-9,
                    "{u:?} {expected:?}"
                );
            }
        }
    }
}

/// Points of a cube that is dragged far enough all slip: the drag comes up to mu times the load, opposite to the motion, and never beyond. What is
/// missing is the part of the slip across, which dies out as the cube slides.
#[test]
fn a_sliding_cube_is_dragged_with_mu_times_its_load() {
    let friction = Friction {
        coefficient: 0.3,
        stiffness: 50.0,
    };
    let mut shortfalls = Vec::new();
    for (slide, steps) in [(0.5, 10.0), (1.0, 20.0), (2.0, 40.0)] {
        let problem = pressed(Order::Quadratic, friction, Some(slide));
        let (_, top, contact) = solve(&problem, steps);
        assert!((contact[2] + top[2]).abs() < 10.0 * TOLERANCE * contact[2]);
        shortfalls.push(1.0 - top[0] / (0.3 * contact[2]));
    }
    println!("shortfalls {shortfalls:?}");
    assert!(shortfalls.iter().all(|s| *s > -1e-10), "{shortfalls:?}");
    assert!(
        shortfalls[2] < 0.5 * shortfalls[1] && shortfalls[1] < 0.5 * shortfalls[0],
        "{shortfalls:?}"
    );
}

/// Points whose friction is never reached stick as if the bottom were held, but for the springs' give.
#[test]
fn a_sticking_cube_is_a_held_one_in_the_limit_of_stiff_springs() {
    let slide = 0.02;
    let mut held = pressed(Order::Quadratic, Friction::NONE, Some(slide));
    hold_bottom(&mut held, 0.0);
    let drag = |stiffness: f64| {
        let friction = Friction {
            coefficient: 1e6,
            stiffness,
        };
        solve(&pressed(Order::Quadratic, friction, Some(slide)), 8.0).1[0]
    };
    let mut newton = Newton::new(&held).expect("a valid mesh");
    let mut state = State::reference(&held);
    let loads = |support_factor| Loads {
        ground: Some(flat(0.0)),
        support_factor,
        ..Loads::default()
    };
    follow(
        &mut newton,
        &mut state,
        &loads(0.0),
        &loads(1.0),
        Stability::Ignored,
        &RUNNING,
    )
    .expect("an equilibrium");
    let forces = newton.reactions(&state, &loads(1.0));
    let top = forces
        .iter()
        .zip(&held.mesh.nodes)
        .filter(|(_, x)| x[2] == 1.0);
    let exact: f64 = top.map(|(force, _)| force[0]).sum();
    let (soft, stiff) = (
        (drag(100.0) / exact - 1.0).abs(),
        (drag(1000.0) / exact - 1.0).abs(),
    );
    println!("drag short of the held cube's by {soft:.4} and {stiff:.5}");
    // The springs give in series with the cube: the shortfall falls with their stiffness.
    assert!(soft < 0.05 && stiff < 0.2 * soft);
}
