//! A slab under live pressure whose far half is condensed, against the whole slab.

use std::collections::HashMap;
use std::sync::atomic::AtomicBool;

use fem::block::Block;
use fem::element::Order;
use fem::material::MooneyRivlin;
use fem::newton::Newton;
use fem::path::{Stability, follow};
use fem::pressure::PressureSurface;
use fem::problem::{Loads, Problem, State};
use fem::solid::SolidModel;
use fem::substructure::Substructure;
use fem::tensor::Vector;

static RUNNING: AtomicBool = AtomicBool::new(false);

const LENGTH: f64 = 2.0;
const THICKNESS: f64 = 0.25;
const PRESSURE: f64 = 0.05;
/// Pushes the near half down, N, on one edge.
const FORCE: f64 = 4e-3;

/// The slab from one x to another: clamped at both ends of the whole, guided at its long edges, under pressure from below.
fn slab(order: Order, from: f64, to: f64) -> Problem {
    let cells = (4.0 * (to - from)) as usize;
    let map = |s: [f64; 3]| [from + (to - from) * s[0], s[1], THICKNESS * s[2]];
    let block = Block::new(order, [cells, 2, 1], map);
    let surface = block.side(2, false);
    let held = |x: &Vector| {
        let clamped = x[0] == 0.0 || x[0] == LENGTH;
        let guided = x[1] == 0.0 || x[1] == 1.0;
        [clamped, clamped || guided, clamped].map(|is_held| is_held.then_some(0.0))
    };
    let Block { mesh, layout, .. } = block;
    let supports = mesh.nodes.iter().map(held).collect();
    let pushed = (0..).zip(&mesh.nodes);
    let pushed = pushed.filter(|(_, x)| x[0] == 0.5 && x[1] == 0.0);
    let dead_forces = pushed.map(|(n, _)| (n, [0.0, 0.0, -FORCE])).collect();
    Problem {
        layout,
        solid: SolidModel {
            material: Box::new(MooneyRivlin {
                c10: 0.144,
                c01: 0.036,
            }),
            compliance: 1e-3,
        },
        membranes: vec![],
        supports,
        pressure: Some(PressureSurface::new(surface)),
        contact: None,
        dead_forces,
        superelement: None,
        mesh,
    }
}

fn loads(traction_factor: f64) -> Loads {
    Loads {
        pressure: PRESSURE,
        traction_factor,
        ..Loads::default()
    }
}

fn solve(problem: &Problem, state: &mut State, start: &Loads, target: &Loads) {
    let mut newton = Newton::new(problem).expect("a valid mesh");
    follow(
        &mut newton,
        state,
        start,
        target,
        Stability::Ignored,
        &RUNNING,
    )
    .expect("an equilibrium");
}

fn whole(order: Order, traction_factor: f64) -> (Problem, State) {
    let problem = slab(order, 0.0, LENGTH);
    let mut state = State::reference(&problem);
    solve(&problem, &mut state, &Loads::default(), &loads(0.0));
    solve(&problem, &mut state, &loads(0.0), &loads(traction_factor));
    (problem, state)
}

/// The place of a point, to the bit.
fn key(x: &Vector) -> [u64; 3] {
    x.map(|c| (c + 0.0).to_bits())
}

fn centroid(problem: &Problem, brick: usize) -> [u64; 3] {
    let mesh = &problem.mesh;
    let ends = mesh.brick(brick);
    let [a, b] = [ends[0], ends[ends.len() - 1]].map(|n| mesh.nodes[n as usize]);
    key(&[0, 1, 2].map(|i| a[i] + b[i]))
}

/// A part's share of the whole's state.
fn cut((whole, state): &(Problem, State), part: &Problem) -> State {
    let nodes = whole.mesh.nodes.iter().map(key).zip(&state.displacement);
    let nodes: HashMap<_, _> = nodes.collect();
    let modes = whole.mesh.order.pressure_modes();
    let bricks = (0..whole.mesh.brick_count()).map(|brick| centroid(whole, brick));
    let bricks: HashMap<_, _> = bricks.zip(state.pressure.chunks_exact(modes)).collect();
    let own = 0..part.mesh.brick_count();
    State {
        displacement: part.mesh.nodes.iter().map(|x| *nodes[&key(x)]).collect(),
        pressure: own
            .flat_map(|brick| bricks[&centroid(part, brick)].to_vec())
            .collect(),
        anchors: vec![],
    }
}

fn shared(problem: &Problem) -> Vec<u32> {
    let nodes = (0..).zip(&problem.mesh.nodes);
    nodes
        .filter(|(_, x)| x[0] == 0.5 * LENGTH)
        .map(|(n, _)| n)
        .collect()
}

/// Both halves' states under this factor of the force, the far one linear about the state without it.
fn condensed(order: Order, traction_factor: f64) -> [(Problem, State); 2] {
    let still = whole(order, 0.0);
    let far = slab(order, 0.5 * LENGTH, LENGTH);
    let substructure = Substructure::new(&far, cut(&still, &far), &loads(0.0), shared(&far));
    let substructure = substructure.expect("a stable half");
    let mut near = slab(order, 0.0, 0.5 * LENGTH);
    let nodes = shared(&near);
    near.superelement = Some(substructure.superelement(nodes.clone()));
    let mut state = cut(&still, &near);
    solve(&near, &mut state, &loads(0.0), &loads(traction_factor));
    let displacement: Vec<Vector> = nodes
        .iter()
        .map(|&n| state.displacement[n as usize])
        .collect();
    let far_state = substructure.recover(&far, &displacement);
    [(near, state), (far, far_state)]
}

/// Largest difference of a displacement, mm, and of an element pressure, MPa, to the whole slab.
fn differences(order: Order, traction_factor: f64) -> [f64; 2] {
    let exact = whole(order, traction_factor);
    let mut largest = [0.0; 2];
    for (problem, state) in condensed(order, traction_factor) {
        let expected = cut(&exact, &problem);
        let displacements = state.displacement.as_flattened().iter();
        let displacements = displacements.zip(expected.displacement.as_flattened());
        let pressures = state.pressure.iter().zip(&expected.pressure);
        let difference = |(a, b): (&f64, &f64)| (a - b).abs();
        largest[0] = displacements.map(difference).fold(largest[0], f64::max);
        largest[1] = pressures.map(difference).fold(largest[1], f64::max);
    }
    largest
}

#[test]
fn a_condensed_half_is_exact_where_it_was_linearised() {
    for order in [Order::Linear, Order::Quadratic] {
        // Newton's tolerance of 1e-10, times the displacement of 0.1 mm and the pressure of 0.1 MPa, with room for condition.
        for difference in differences(order, 0.0) {
            assert!(difference < 1e-9, "{order:?}: {difference:e}");
        }
    }
}

#[test]
fn the_error_of_a_condensed_half_is_quadratic_in_the_load() {
    for order in [Order::Linear, Order::Quadratic] {
        let errors = [0.25, 0.125, 0.0625].map(|factor| differences(order, factor));
        for kind in 0..2 {
            // Second order with terms of the third: 4 in the limit, and closer to it for the smaller forces. A missing part of
            // the tangent, such as the pressure's skew part at the cut, makes it 2.
            let ratios = [
                errors[0][kind] / errors[1][kind],
                errors[1][kind] / errors[2][kind],
            ];
            assert!((ratios[1] - 4.0).abs() < 0.4, "{order:?}: {errors:?}");
            assert!(
                (ratios[1] - 4.0).abs() < (ratios[0] - 4.0).abs(),
                "{order:?}: {errors:?}"
            );
        }
    }
}
