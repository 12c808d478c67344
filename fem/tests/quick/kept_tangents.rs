//! A cube pressed near a kept tangent, against the same pressed with tangents of its own.

use std::sync::Arc;
use std::sync::atomic::AtomicBool;

use crate::cube::{bottom, problem};
use fem::cell::element::Order;
use fem::load::contact::{ContactSurface, Penalty};
use fem::load::friction::Friction;
use fem::load::ground_shape::Profile;
use fem::load::obstacle::{GroundAxes, HeightField, StationFunctions};
use fem::newton::iteration::Newton;
use fem::newton::path::{Stability, follow};
use fem::newton::tangent::Tangent;
use fem::problem::{Loads, Problem, State};

static RUNNING: AtomicBool = AtomicBool::new(false);
/// Newton's tolerance; displacements are compared to a thousand times that, the condition of a slab in bending.
const TOLERANCE: f64 = 1e-11;
/// Depths of the stations where the tangent is made, mm: the ground falls off to one side, so that part of the face is free.
const KEPT: [f64; 5] = [0.10, 0.09, 0.06, -0.02, -0.06];

fn over(depths: [f64; 5]) -> Loads {
    Loads {
        ground: Some(HeightField {
            axes: GroundAxes::LEVEL,
            base: 0.0,
            spacing: 0.5,
            functions: StationFunctions::BSpline,
            depths: depths.to_vec(),
            shift: [0.0; 2],
            profile: Profile::Plane,
        }),
        ..Loads::default()
    }
}

/// A cube of 27 bricks hung from its top, over a ground that may touch its bottom.
fn hung(order: Order, friction: Friction) -> Problem {
    let mut problem = problem(order, 3, true, 0.1);
    for (support, x) in problem.supports.iter_mut().zip(&problem.mesh.nodes) {
        if x[2] == 1.0 {
            *support = [Some(0.0); 3];
        }
    }
    let penalty = Penalty {
        stiffness: 50.0,
        ramp: 1e-3,
    };
    let mut contact = ContactSurface::new(&problem.mesh, bottom(order, 3), penalty);
    contact.friction = friction;
    problem.contact = Some(contact);
    problem
}

/// Follows a path; returns its end and the factorisations it took.
fn press(newton: &mut Newton<'_>, from: &State, start: &Loads, target: &Loads) -> (State, usize) {
    newton.settings.tolerance = TOLERANCE;
    let (mut state, before) = (from.clone(), newton.effort.factorisations);
    follow(
        newton,
        &mut state,
        start,
        target,
        Stability::Ignored,
        &RUNNING,
    )
    .expect("an equilibrium");
    (state, newton.effort.factorisations - before)
}

/// The equilibrium over [`KEPT`] from the reference, and the tangent there.
fn kept(problem: &Problem) -> (State, Arc<Tangent>) {
    let mut newton = Newton::new(problem).expect("a valid mesh");
    let (state, _) = press(
        &mut newton,
        &State::reference(problem),
        &over([0.0; 5]),
        &over(KEPT),
    );
    let tangent = newton
        .tangent_at(&state, &over(KEPT))
        .expect("a stable state");
    (state, tangent)
}

fn difference(a: &State, b: &State) -> f64 {
    let both = a
        .displacement
        .as_flattened()
        .iter()
        .zip(b.displacement.as_flattened());
    both.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}

/// Grounds that open and close contact against the kept one: deeper, shallower, turned over, and away from the cube.
const OTHERS: [[f64; 5]; 4] = [
    [0.12, 0.11, 0.08, 0.0, -0.05],
    [0.03, 0.02, 0.01, -0.03, -0.06],
    [-0.06, -0.02, 0.06, 0.09, 0.10],
    [-0.06, -0.05, -0.05, -0.05, -0.06],
];

#[test]
fn a_kept_tangent_leads_to_the_same_equilibria() {
    for order in [Order::Linear, Order::Quadratic] {
        let problem = hung(order, Friction::NONE);
        let (state, tangent) = kept(&problem);
        for depths in OTHERS {
            let target = over(KEPT).with_depths(&depths);
            let mut own = Newton::new(&problem).expect("a valid mesh");
            let reference = State::reference(&problem);
            let (expected, _) = press(&mut own, &reference, &over([0.0; 5]), &target);
            let mut newton =
                Newton::with_tangent(&problem, tangent.clone()).expect("its own set-up");
            let (pressed, _) = press(&mut newton, &state, &over(KEPT), &target);
            let difference = difference(&pressed, &expected);
            assert!(
                difference < 1e3 * TOLERANCE,
                "{order:?} {depths:?}: {difference:e}"
            );
        }
    }
}

/// Contact opens and closes on the border alone, where nothing is factorised: what a tangent is kept for.
#[test]
fn near_its_state_a_kept_tangent_needs_no_other() {
    let problem = hung(Order::Quadratic, Friction::NONE);
    let (state, tangent) = kept(&problem);
    let near = KEPT.map(|depth| depth + 0.005);
    let mut newton = Newton::with_tangent(&problem, tangent).expect("its own set-up");
    let (_, factorisations) = press(&mut newton, &state, &over(KEPT), &over(near));
    assert_eq!(factorisations, 0);
}

/// The kept tangent is solved free of contact where there is no ground.
#[test]
fn a_kept_tangent_lets_the_ground_be_taken_away() {
    let problem = hung(Order::Linear, Friction::NONE);
    let (state, tangent) = kept(&problem);
    let mut newton = Newton::with_tangent(&problem, tangent).expect("its own set-up");
    let (free, _) = press(&mut newton, &state, &over(KEPT), &Loads::default());
    // Nothing else loads the cube.
    assert!(difference(&free, &State::reference(&problem)) < 1e3 * TOLERANCE);
}
