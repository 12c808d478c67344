//! A cube stretched along z, whose equilibrium is uniaxial tension: by held ends with fibres along it, and by dead forces.

use std::sync::atomic::AtomicBool;
use std::time::Duration;

use crate::cube::problem;
use fem::cell::element::Order;
use fem::cell::mesh::Surface;
use fem::linear::setup::SetupError;
use fem::newton::iteration::{Cause, Effort, Newton};
use fem::newton::path::{PathFailure, PathReport, Stability, follow};
use fem::problem::{Loads, Problem, State};
use fem::surface::membrane::Membrane;
use fem::surface::surface_law::FibreFamily;

/// Newton's tolerance, relative to the forces at hand; results are compared to a hundred times that, because a cube's
/// displacements answer its forces with a condition of that order at most.
const TOLERANCE: f64 = 1e-11;
const BOUND: f64 = 100.0 * TOLERANCE;
const STRETCH: f64 = 1.5;
/// N/mm; the cube's own tension is of the same size.
const FIBRE_STIFFNESS: f64 = 0.5;

/// Nominal stress of the cube's rubber, MPa.
fn uniaxial(stretch: f64) -> f64 {
    2.0 * (0.144 + 0.036 / stretch) * (stretch - stretch.powi(-2))
}

/// An incompressible cube of 8 bricks on three planes of symmetry.
fn on_symmetry_planes(order: Order) -> Problem {
    let mut problem = problem(order, 2, true, 0.0);
    for (support, x) in problem.supports.iter_mut().zip(&problem.mesh.nodes) {
        for axis in 0..3 {
            support[axis] = (x[axis] == 0.0).then_some(0.0);
        }
    }
    problem
}

/// The cube with fibres along z on the face x = 1, its top moved to the stretch `1 + lift` at support factor 1.
fn with_fibres(order: Order, lift: f64) -> Problem {
    let mut problem = on_symmetry_planes(order);
    for (support, x) in problem.supports.iter_mut().zip(&problem.mesh.nodes) {
        if x[2] == 1.0 {
            support[2] = Some(lift);
        }
    }
    let e = order.edge_nodes() - 1;
    let line = 2 * e + 1;
    let mut faces = Vec::new();
    for (b, c) in [(0, 0), (1, 0), (0, 1), (1, 1)] {
        for k in 0..=e {
            let row = |j: usize| ((c * e + k) * line + b * e + j) * line + line - 1;
            faces.extend((0..=e).map(|j| row(j) as u32));
        }
    }
    let fibres = FibreFamily {
        angle: 0.0,
        stiffness: FIBRE_STIFFNESS,
        compression_ratio: 0.1,
    };
    let along_z = |_: &[f64; 3], _: &[f64; 3]| [0.0, 0.0, 1.0];
    let surface = Surface { order, faces };
    let membrane = Membrane::new(&problem.mesh, surface, &along_z, vec![Box::new(fibres)]);
    problem.membranes.push(membrane);
    problem
}

/// The cube without fibres, its top pulled at traction factor 1 by a uniform nominal stress (MPa): for linear bricks a quarter of each face's force
/// goes to each of its corners.
fn pulled(stress: f64) -> Problem {
    let mut problem = on_symmetry_planes(Order::Linear);
    let nodes = (0..).zip(&problem.mesh.nodes);
    let top = nodes.filter(|(_, x)| x[2] == 1.0).map(|(node, x)| {
        let half = |c: f64| if c == 0.5 { 0.5 } else { 0.25 };
        (node, [0.0, 0.0, stress * half(x[0]) * half(x[1])])
    });
    problem.dead_forces = top.collect();
    problem
}

/// All of the dead forces.
fn full_pull() -> Loads {
    Loads {
        traction_factor: 1.0,
        ..Loads::default()
    }
}

fn run(
    newton: &mut Newton<'_>,
    state: &mut State,
    target: &Loads,
    is_stopped: bool,
) -> Result<PathReport, Box<PathFailure>> {
    newton.settings.tolerance = TOLERANCE;
    let (start, stop) = (Loads::default(), AtomicBool::new(is_stopped));
    follow(newton, state, &start, target, Stability::Ignored, &stop)
}

fn check_uniaxial(problem: &Problem, state: &State, stretch: f64) {
    let across = stretch.powf(-0.5);
    for (u, x) in state.displacement.iter().zip(&problem.mesh.nodes) {
        for (axis, l) in [across, across, stretch].into_iter().enumerate() {
            let expected = (l - 1.0) * x[axis];
            assert!((u[axis] - expected).abs() < BOUND, "{u:?} at {x:?}");
        }
    }
}

#[test]
fn fibres_bear_their_part_of_a_held_stretch() {
    for order in [Order::Linear, Order::Quadratic] {
        for (stretch, slope) in [(STRETCH, 1.0), (1.0 / STRETCH, 0.1)] {
            let problem = with_fibres(order, stretch - 1.0);
            let mut newton = Newton::new(&problem).expect("a valid mesh");
            let mut state = State::reference(&problem);
            let target = Loads {
                support_factor: 1.0,
                ..Loads::default()
            };
            run(&mut newton, &mut state, &target, false).expect("an equilibrium");
            check_uniaxial(&problem, &state, stretch);
            let forces = newton.reactions(&state, &target);
            let on_top = forces.iter().zip(&problem.mesh.nodes);
            let pull: f64 = on_top.filter(|(_, x)| x[2] == 1.0).map(|(f, _)| f[2]).sum();
            let exact = uniaxial(stretch) + slope * FIBRE_STIFFNESS * (stretch - 1.0);
            assert!((pull / exact - 1.0).abs() < BOUND, "{pull} for {exact}");
        }
    }
}

#[test]
fn dead_forces_stretch_a_cube_as_its_law_says() {
    let problem = pulled(uniaxial(STRETCH));
    let mut newton = Newton::new(&problem).expect("a valid mesh");
    let mut state = State::reference(&problem);
    run(&mut newton, &mut state, &full_pull(), false).expect("an equilibrium");
    check_uniaxial(&problem, &state, STRETCH);
    let range = newton.stretch_range(&state);
    assert!(
        (range.smallest - STRETCH.powf(-0.5)).abs() < BOUND,
        "{range:?}"
    );
    assert!((range.largest - STRETCH).abs() < BOUND, "{range:?}");
    assert!(newton.max_volume_change(&state) < BOUND);

    let flat = state.to_flat();
    assert_eq!(State::from_flat(&problem, &flat), Some(state));
    assert_eq!(State::from_flat(&problem, &flat[1..]), None);
}

/// Newton's method needs some eight steps of it for the whole pull, and fewer for parts of it.
#[test]
fn a_path_that_fails_says_how_far_it_came_and_leaves_an_equilibrium() {
    let stress = uniaxial(3.0);
    let problem = pulled(stress);
    let mut newton = Newton::new(&problem).expect("a valid mesh");
    newton.settings.max_iterations = 5;
    newton.settings.smallest_load_step = 0.125;
    let mut state = State::reference(&problem);
    let failure = run(&mut newton, &mut state, &full_pull(), false).expect_err("too few steps");
    assert_eq!(failure.cause, Cause::Iterations);
    assert!(failure.reached < 1.0, "{failure:?}");
    assert_eq!(failure.loads.traction_factor, failure.reached);
    let lifts = state.displacement.iter().map(|u| u[2]);
    let stretch = 1.0 + lifts.fold(0.0, f64::max);
    let pull = failure.reached * stress;
    assert!(
        (uniaxial(stretch) - pull).abs() <= BOUND * stress,
        "{stretch}"
    );
}

#[test]
fn a_stopped_path_leaves_the_state_as_it_was() {
    let problem = pulled(uniaxial(STRETCH));
    let mut newton = Newton::new(&problem).expect("a valid mesh");
    let mut state = State::reference(&problem);
    let failure = run(&mut newton, &mut state, &full_pull(), true).expect_err("told to stop");
    assert_eq!((failure.reached, failure.cause), (0.0, Cause::Stopped));
    assert_eq!(state, State::reference(&problem));
}

#[test]
fn a_set_up_counts_free_displacements_and_the_entries_of_their_factor() {
    let problem = on_symmetry_planes(Order::Linear);
    let newton = Newton::new(&problem).expect("a valid mesh");
    // 27 nodes, of which each plane holds 9 in one direction.
    let unknowns = 3 * 27 - 3 * 9;
    assert_eq!(newton.unknowns(), unknowns);
    // At least its diagonal, at most a full matrix: it is stored in dense blocks.
    let entries = newton.factor_entries();
    assert!(
        (unknowns..=unknowns * unknowns).contains(&entries),
        "{entries}"
    );
}

#[test]
fn a_mesh_that_is_inside_out_is_refused_by_its_first_brick() {
    let mut problem = on_symmetry_planes(Order::Quadratic);
    for x in &mut problem.mesh.nodes {
        x[0] = -x[0];
    }
    let Err(SetupError::Mesh(refused)) = Newton::new(&problem) else {
        panic!("every brick is inverted");
    };
    assert!(refused.element == 0 && refused.jacobian < 0.0, "{refused}");
}

#[test]
fn efforts_add_up() {
    let problem = pulled(uniaxial(STRETCH));
    let mut sum = Effort::default();
    let mut all = Newton::new(&problem).expect("a valid mesh");
    for _ in 0..2 {
        let mut one = Newton::new(&problem).expect("a valid mesh");
        for newton in [&mut one, &mut all] {
            let mut state = State::reference(&problem);
            run(newton, &mut state, &full_pull(), false).expect("an equilibrium");
        }
        sum += one.effort;
    }
    assert_eq!(sum.iterations, all.effort.iterations);
    assert!(sum.factorisations >= 2 && sum.assembly + sum.factorisation > Duration::ZERO);
}
