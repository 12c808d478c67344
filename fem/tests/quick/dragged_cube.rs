//! A cube held at its top, pressed on flat ground that is dragged sideways afterwards.

use std::sync::atomic::AtomicBool;

use crate::cube::{bottom, problem};
use crate::pressed_cube::{flat, hold_bottom, pressed};
use fem::cell::element::Order;
use fem::load::contact::{ContactSurface, Penalty};
use fem::load::friction::Friction;
use fem::load::obstacle::HeightField;
use fem::newton::iteration::{LargestStep, Newton};
use fem::newton::path::{Stability, follow};
use fem::problem::{Loads, Problem, State};
use fem::tensor::Vector;

static RUNNING: AtomicBool = AtomicBool::new(false);
/// Newton's tolerance here; forces are compared to a hundred times that.
const TOLERANCE: f64 = 1e-11;
const OF_FORCE: f64 = 100.0 * TOLERANCE;
/// Spring stiffness of friction, N/mm^3, where it doesn't matter.
const STIFFNESS: f64 = 50.0;

fn rough(coefficient: f64, stiffness: f64) -> Friction {
    Friction {
        coefficient,
        stiffness,
    }
}

/// Loads of a cube whose top is down, on ground dragged by `shift`.
fn loads(support_factor: f64, ground_force: Option<f64>, shift: [f64; 2]) -> Loads {
    let ground = HeightField { shift, ..flat(0.0) };
    Loads {
        ground: Some(ground),
        ground_force,
        support_factor,
        ..Loads::default()
    }
}

/// Forces on the cube, N: of the ground, and of its supports.
struct Forces {
    ground: Vector,
    top: Vector,
}

fn forces(newton: &mut Newton<'_>, state: &State, loads: &Loads) -> Forces {
    let problem = newton.problem();
    let contact = problem.contact.as_ref().expect("a bottom");
    let ground = loads.ground_in(state).expect("a ground");
    let position = |n| state.position(&problem.mesh, n);
    let friction = contact.friction_wrench(&ground, &state.anchors, position);
    let [x, y, _] = friction.force;
    let normal = contact.resultant(&ground, position).wrench.force;
    let mut top = [0.0; 3];
    for force in newton.reactions(state, loads) {
        for axis in 0..3 {
            top[axis] += force[axis];
        }
    }
    Forces {
        ground: [normal[0] + x, normal[1] + y, normal[2]],
        top,
    }
}

/// Presses in 8 steps, then drags in so many.
fn drag(problem: &Problem, pressed: &Loads, dragged: &Loads, steps: f64) -> (State, Forces) {
    let mut newton = Newton::new(problem).expect("a valid mesh");
    newton.settings.tolerance = TOLERANCE;
    let mut state = State::reference(problem);
    state.rise = pressed.ground_force.map_or(0.0, |_| 0.01);
    let start = loads(0.0, None, [0.0; 2]);
    for (from, to, steps) in [(&start, pressed, 8.0), (pressed, dragged, steps)] {
        newton.settings.largest_load_step = LargestStep::Even(1.0 / steps);
        let ignored = Stability::Ignored;
        follow(&mut newton, &mut state, from, to, ignored, &RUNNING).expect("an equilibrium");
    }
    let forces = forces(&mut newton, &state, dragged);
    (state, forces)
}

/// The cube of `pressed_cube`, its top held sideways, dragged at its depth.
fn dragged(friction: Friction, shift: [f64; 2], steps: f64) -> Forces {
    let cube = pressed(Order::Quadratic, friction, Some(0.0));
    let ends = [[0.0; 2], shift].map(|shift| loads(1.0, None, shift));
    drag(&cube, &ends[0], &ends[1], steps).1
}

fn assert_balanced(forces: &Forces) {
    for axis in 0..3 {
        let sum = forces.ground[axis] + forces.top[axis];
        assert!(
            sum.abs() < OF_FORCE * forces.ground[2],
            "{:?} {:?}",
            forces.ground,
            forces.top
        );
    }
}

/// A bottom whose friction is never reached goes with the ground: as one that is held and displaced, but for the springs' give.
#[test]
fn sticking_ground_shears_the_cube_as_a_held_bottom_does() {
    let way = 0.02;
    let mut held = pressed(Order::Quadratic, Friction::NONE, Some(0.0));
    hold_bottom(&mut held, way);
    let mut newton = Newton::new(&held).expect("a valid mesh");
    newton.settings.tolerance = TOLERANCE;
    let mut state = State::reference(&held);
    let ends = [0.0, 1.0].map(|factor| loads(factor, None, [0.0; 2]));
    let ignored = Stability::Ignored;
    follow(
        &mut newton,
        &mut state,
        &ends[0],
        &ends[1],
        ignored,
        &RUNNING,
    )
    .expect("it holds");
    let reactions = newton.reactions(&state, &ends[1]);
    let of_bottom = reactions.iter().zip(&held.mesh.nodes);
    let exact: f64 = of_bottom
        .filter(|(_, x)| x[2] == 0.0)
        .map(|(force, _)| force[0])
        .sum();
    let short = [100.0, 1000.0, 10000.0].map(|stiffness| {
        let forces = dragged(rough(1e6, stiffness), [way, 0.0], 2.0);
        assert_balanced(&forces);
        1.0 - forces.ground[0] / exact
    });
    println!("held bottom: {} N/mm; short by {short:?}", exact / way);
    // Springs in series with the cube: the shortfall falls with their stiffness.
    assert!(exact > 0.0 && short[0] > 0.0 && short[0] < 0.05);
    for pair in short.windows(2) {
        assert!((pair[0] / pair[1] / 10.0 - 1.0).abs() < 0.1, "{short:?}");
    }
}

/// Points of a cube that is dragged far enough all slip, and the ground pulls it along with mu times the load, never more.
#[test]
fn sliding_ground_pulls_with_mu_times_the_load_along_its_way() {
    let far = [0.5, 1.0, 2.0];
    let short = far.map(|way| {
        let forces = dragged(rough(0.3, STIFFNESS), [way, 0.0], 20.0 * way);
        assert_balanced(&forces);
        let [x, y, load] = forces.ground;
        assert!(y.abs() < 0.01 * x, "{:?}", forces.ground);
        1.0 - x / (0.3 * load)
    });
    println!("short of mu times the load by {short:?}");
    // What is missing is the slip across from pressing, which dies out as the cube slides.
    assert!(short.iter().all(|s| *s > -1e-10), "{short:?}");
    assert!(
        short[2] < 0.5 * short[1] && short[1] < 0.5 * short[0],
        "{short:?}"
    );
    assert!(short[2] < 1e-3, "{short:?}");
}

/// A cube whose mesh has the symmetries of its shape.
fn even_cube() -> Problem {
    let mut cube = problem(Order::Quadratic, 2, false, 0.1);
    let penalty = Penalty {
        stiffness: STIFFNESS,
        ramp: 1e-3,
    };
    let mut contact = ContactSurface::new(&cube.mesh, bottom(Order::Quadratic, 2), penalty);
    contact.friction = rough(0.3, STIFFNESS);
    cube.contact = Some(contact);
    for (support, x) in cube.supports.iter_mut().zip(&cube.mesh.nodes) {
        if x[2] == 1.0 {
            *support = [Some(0.0), Some(0.0), Some(-0.1)];
        }
    }
    cube
}

#[test]
fn dragged_back_or_across_the_force_turns_with_the_ground() {
    let cube = even_cube();
    let pull = |shift| {
        let ends = [[0.0; 2], shift].map(|shift| loads(1.0, None, shift));
        drag(&cube, &ends[0], &ends[1], 4.0).1.ground
    };
    // Some of the points slip here.
    let [along, across, load] = pull([0.15, 0.0]);
    assert!(
        along > 0.5 * 0.3 * load && along < 0.99 * 0.3 * load,
        "{along} of {load} N"
    );
    for (shift, expected) in [
        ([-0.15, 0.0], [-along, -across, load]),
        ([0.0, 0.15], [across, along, load]),
        ([0.0, -0.15], [-across, -along, load]),
    ] {
        let found = pull(shift);
        for axis in 0..3 {
            let off = (found[axis] - expected[axis]).abs();
            assert!(off < OF_FORCE * load, "{shift:?}: {found:?} {expected:?}");
        }
    }
}

#[test]
fn ground_that_presses_with_a_force_keeps_it_while_it_is_dragged() {
    let cube = even_cube();
    let force = 0.05;
    // The top stays where it is, and the ground rises.
    let ends = [[0.0; 2], [0.05, 0.0]].map(|shift| loads(0.0, Some(force), shift));
    let (state, found) = drag(&cube, &ends[0], &ends[1], 8.0);
    assert!((found.ground[2] / force - 1.0).abs() < OF_FORCE);
    assert!(found.ground[0] > 0.0 && found.ground[0] <= 0.3 * force * (1.0 + OF_FORCE));
    assert!(state.rise > 0.0);
}

/// The cube dragged there and back over sticking ground is where it was: nothing slipped.
#[test]
fn sticking_ground_takes_the_cube_back() {
    let cube = pressed(Order::Quadratic, rough(1e6, STIFFNESS), Some(0.0));
    let ends = [[0.0; 2], [0.02, -0.01]].map(|shift| loads(1.0, None, shift));
    let (still, _) = drag(&cube, &ends[0], &ends[0], 1.0);
    let (mut there, _) = drag(&cube, &ends[0], &ends[1], 2.0);
    let mut newton = Newton::new(&cube).expect("a valid mesh");
    newton.settings.tolerance = TOLERANCE;
    let ignored = Stability::Ignored;
    follow(
        &mut newton,
        &mut there,
        &ends[1],
        &ends[0],
        ignored,
        &RUNNING,
    )
    .expect("it holds");
    let pairs = there
        .displacement
        .iter()
        .flatten()
        .zip(still.displacement.iter().flatten());
    for (a, b) in pairs {
        // The residual times the compliance of a cube of 1 mm.
        assert!((a - b).abs() < 1e-9, "{a} {b}");
    }
}
