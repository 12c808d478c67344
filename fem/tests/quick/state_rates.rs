//! Derivatives of equilibria by a parameter, against an exact one and against differences of equilibria.

use std::sync::atomic::AtomicBool;

use crate::cube;
use crate::pressed_cube::{flat, pressed};
use fem::cell::element::Order;
use fem::load::friction::Friction;
use fem::material::NeoHookean;
use fem::newton::iteration::Newton;
use fem::newton::path::{Stability, follow};
use fem::newton::state_rate::{Beside, NoRate, StateRate};
use fem::problem::{Loads, Problem, State};

static RUNNING: AtomicBool = AtomicBool::new(false);
const TOLERANCE: f64 = 1e-12;
/// Largest error of a derivative, relative to the largest: the rounding of the difference, 1e-8 with this half step relative to the parameter.
const BOUND: f64 = 1e-7;
const HALF_STEP: f64 = 1e-6;

fn equilibrium(problem: &Problem, start: &Loads, target: &Loads, rise: f64) -> State {
    let mut newton = Newton::new(problem).expect("a valid mesh");
    newton.settings.tolerance = TOLERANCE;
    let mut state = State::reference(problem);
    state.rise = rise;
    let stability = Stability::Ignored;
    let path = follow(&mut newton, &mut state, start, target, stability, &RUNNING);
    path.expect("an equilibrium");
    state
}

fn rate(
    (problem, state, loads): (&Problem, &State, &Loads),
    sides: [(&Problem, &Loads); 2],
    half_step: f64,
) -> Result<StateRate, NoRate> {
    let mut newton = Newton::for_contact(problem, state, loads).expect("a valid mesh");
    let beside = sides.map(|(problem, loads)| Beside { problem, loads });
    newton.state_rate(state, loads, beside, half_step)
}

/// An incompressible neo-Hookean cube under uniaxial tension: P = 2 C (s - s^-2), so that ds/dC = -(s - s^-2) / (C (1 + 2 s^-3)).
#[test]
fn the_stretch_of_a_pulled_cube_changes_with_its_modulus_as_it_must() {
    const MODULUS: f64 = 0.2;
    const STRETCH: f64 = 1.4;
    let of_modulus = |modulus: f64| {
        let mut problem = cube::problem(Order::Linear, 2, true, 0.0);
        problem.solid.material = Box::new(NeoHookean { c10: modulus });
        for (support, x) in problem.supports.iter_mut().zip(&problem.mesh.nodes) {
            *support = x.map(|x| (x == 0.0).then_some(0.0));
        }
        let nodes = (0..).zip(&problem.mesh.nodes);
        let top = nodes.filter(|(_, x)| x[2] == 1.0).map(|(node, x)| {
            let half = |c: f64| if c == 0.5 { 0.5 } else { 0.25 };
            let stress = 2.0 * MODULUS * (STRETCH - STRETCH.powi(-2));
            (node, [0.0, 0.0, stress * half(x[0]) * half(x[1])])
        });
        problem.dead_forces = top.collect();
        problem
    };
    let loads = Loads {
        traction_factor: 1.0,
        ..Loads::default()
    };
    let problem = of_modulus(MODULUS);
    let state = equilibrium(&problem, &Loads::default(), &loads, 0.0);
    let half_step = HALF_STEP * MODULUS;
    let sides = [-half_step, half_step].map(|step| of_modulus(MODULUS + step));
    let [low, high] = sides.each_ref().map(|side| (side, &loads));
    let found = rate((&problem, &state, &loads), [low, high], half_step).expect("a derivative");
    let exact = -(STRETCH - STRETCH.powi(-2)) / (MODULUS * (1.0 + 2.0 * STRETCH.powi(-3)));
    for (x, rate) in problem.mesh.nodes.iter().zip(&found.displacement) {
        let error = rate[2] - exact * x[2];
        assert!(
            error.abs() < BOUND * exact.abs(),
            "{} for {}",
            rate[2],
            exact * x[2]
        );
    }
}

/// Differences of equilibria pressed by a height or by a force, to the fourth order in their distance, give the same.
#[test]
fn a_pressed_cube_changes_with_its_load_as_differences_say() {
    let problem = pressed(Order::Quadratic, Friction::NONE, None);
    let by_height = |height: f64| Loads {
        ground: Some(flat(height)),
        ..Loads::default()
    };
    let by_force = |force: f64| Loads {
        ground: Some(flat(0.0)),
        ground_force: Some(force),
        ..Loads::default()
    };
    for (loads, value, rise) in [
        (&by_height as &dyn Fn(f64) -> Loads, 0.1, 0.0),
        (&by_force, 0.05, 0.01),
    ] {
        let start = by_height(0.0);
        let solved = |value: f64| equilibrium(&problem, &start, &loads(value), rise);
        let (state, step) = (solved(value), 1e-3 * value);
        let differences = |apart: f64| {
            let [low, high] = [solved(value - apart), solved(value + apart)];
            let mut rate = high.to_flat();
            rate.push(high.rise);
            let low = low.to_flat().into_iter().chain([low.rise]);
            let pairs = rate.into_iter().zip(low);
            let quotients: Vec<f64> = pairs
                .map(|(high, low)| (high - low) / (2.0 * apart))
                .collect();
            quotients
        };
        let [near, far] = [differences(step), differences(2.0 * step)];
        let half_step = HALF_STEP * value;
        let sides = [-half_step, half_step].map(|step| loads(value + step));
        let [low, high] = sides.each_ref().map(|side| (&problem, side));
        let middle = loads(value);
        let found = rate((&problem, &state, &middle), [low, high], half_step);
        let found = found.expect("a derivative");
        let unknowns = found.displacement.iter().flatten().chain(&found.pressure);
        let unknowns: Vec<f64> = unknowns.copied().chain([found.rise]).collect();
        let largest = unknowns
            .iter()
            .fold(0.0_f64, |largest, x| largest.max(x.abs()));
        for ((near, far), found) in near.iter().zip(&far).zip(&unknowns) {
            let expected = (4.0 * near - far) / 3.0;
            assert!(
                (found - expected).abs() < BOUND * largest,
                "{found} for {expected}"
            );
        }
    }
}

#[test]
fn problems_of_other_elements_are_told() {
    let problem = cube::problem(Order::Linear, 2, false, 0.0);
    let finer = cube::problem(Order::Linear, 3, false, 0.0);
    let (state, loads) = (State::reference(&problem), Loads::default());
    let sides = [(&finer, &loads), (&problem, &loads)];
    let held = pressed(Order::Linear, Friction::NONE, None);
    let found = rate((&held, &State::reference(&held), &loads), sides, 1e-6);
    assert_eq!(found, Err(NoRate::OtherMesh));
    assert!(problem.has_elements_of(&problem) && !problem.has_elements_of(&finer));
    assert_eq!(StateRate::zero(&state).moved(&state, 1.0), state);
}
