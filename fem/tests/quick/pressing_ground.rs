//! A cube held at its top, on ground that presses with a force instead of standing at a height.

use std::sync::atomic::AtomicBool;

use crate::pressed_cube::{flat, pressed};
use fem::cell::element::Order;
use fem::load::friction::Friction;
use fem::newton::iteration::Newton;
use fem::newton::path::{PathFailure, Stability, follow};
use fem::problem::{Loads, Problem, State};

static RUNNING: AtomicBool = AtomicBool::new(false);
const TOLERANCE: f64 = 1e-10;
/// A hundredth of a force's relative error is below the tolerance.
const OF_FORCE: f64 = 100.0 * TOLERANCE;

fn loads(rise: f64, ground_force: Option<f64>) -> Loads {
    Loads {
        ground: Some(flat(rise)),
        ground_force,
        ..Loads::default()
    }
}

/// The equilibrium under these loads, from the undeformed cube with the ground raised by so much, and the iterations to it.
fn solve(problem: &Problem, target: &Loads, rise: f64) -> Result<(State, usize), Box<PathFailure>> {
    let mut newton = Newton::new(problem).expect("a valid mesh");
    newton.settings.tolerance = TOLERANCE;
    let mut state = State::reference(problem);
    state.rise = rise;
    let start = loads(0.0, None);
    follow(
        &mut newton,
        &mut state,
        &start,
        target,
        Stability::Ignored,
        &RUNNING,
    )?;
    Ok((state, newton.effort.iterations))
}

fn reaction(problem: &Problem, state: &State, target: &Loads) -> f64 {
    let contact = problem.contact.as_ref().expect("a bottom");
    let ground = target.ground_in(state).expect("a ground");
    contact
        .resultant(&ground, |n| state.position(&problem.mesh, n))
        .load
}

/// The force is met, and where the ground stands then it presses with that force: over six decades, up to a third of the cube's height, from ground that
/// touches nothing, little or much, with and without friction.
#[test]
fn a_force_and_the_height_at_which_it_presses_give_the_same_equilibrium() {
    let rough = Friction {
        coefficient: 0.3,
        stiffness: 50.0,
    };
    for (order, friction) in [
        (Order::Linear, Friction::NONE),
        (Order::Quadratic, Friction::NONE),
        (Order::Quadratic, rough),
    ] {
        let problem = pressed(order, friction, None);
        for force in [1e-7, 1e-5, 1e-3, 0.02, 0.1] {
            let target = loads(0.0, Some(force));
            let (state, by_force) = solve(&problem, &target, 0.01).expect("an equilibrium");
            let found = reaction(&problem, &state, &target);
            assert!(
                (found / force - 1.0).abs() < OF_FORCE,
                "{found} for {force} N"
            );
            assert!(state.rise > 0.0 && state.rise < 0.5, "{}", state.rise);
            let height = loads(state.rise, None);
            let (same, by_height) = solve(&problem, &height, 0.0).expect("an equilibrium");
            println!(
                "{order:?} {force} N: rise {}, {by_force} and {by_height} iterations",
                state.rise
            );

            let differences = state
                .displacement
                .iter()
                .flatten()
                .zip(same.displacement.iter().flatten());
            let largest = differences.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
            // The cube gives 10 to 100 mm/N where it hardly touches, and its force is met to 1e-8 of it.
            assert!(largest < 1e-8, "{largest} mm at {force} N");
        }
    }
}

#[test]
fn ground_that_touches_nothing_rises_until_it_does() {
    let problem = pressed(Order::Quadratic, Friction::NONE, None);
    let target = loads(0.0, Some(0.02));
    let (near, _) = solve(&problem, &target, 0.01).expect("an equilibrium");
    for rise in [1e-9, 0.1, 0.2] {
        let (state, _) = solve(&problem, &target, rise).expect("an equilibrium");
        assert!(
            (state.rise - near.rise).abs() < 1e-8,
            "{rise}: {}",
            state.rise
        );
    }
}
