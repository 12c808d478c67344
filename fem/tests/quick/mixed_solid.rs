//! The mixed solid in small problems with exact answers.

use std::sync::atomic::AtomicBool;

use crate::cube::problem;
use fem::cell::element::Order;
use fem::cell::mesh::Surface;
use fem::load::pressure::PressureSurface;
use fem::material::MooneyRivlin;
use fem::newton::iteration::Newton;
use fem::newton::path::{Stability, follow};
use fem::problem::{Loads, Problem, State};
use fem::tensor::Vector;

const ORDERS: [Order; 2] = [Order::Linear, Order::Quadratic];
static RUNNING: AtomicBool = AtomicBool::new(false);

/// Solves with a new tangent in every iteration: Newton's method in its pure form.
fn solve(problem: &Problem, target: &Loads) -> (State, Vec<Vec<f64>>) {
    let mut newton = Newton::new(problem).expect("a valid mesh");
    newton.settings.renewal_cost = 0.0;
    solve_with(&mut newton, problem, target)
}

fn solve_with(
    newton: &mut Newton<'_>,
    problem: &Problem,
    target: &Loads,
) -> (State, Vec<Vec<f64>>) {
    let mut state = State::reference(problem);
    let report = follow(
        newton,
        &mut state,
        &Loads::default(),
        target,
        Stability::Ignored,
        &RUNNING,
    )
    .expect("an equilibrium");
    (
        state,
        report
            .steps
            .iter()
            .map(|step| step.iter().map(|r| r.worst()).collect())
            .collect(),
    )
}

fn held() -> Loads {
    Loads {
        support_factor: 1.0,
        ..Loads::default()
    }
}

#[test]
fn patch_test_reproduces_a_homogeneous_deformation() {
    // Volume-preserving for the incompressible solid, dilating for the compressible one.
    let isochoric = [[1.2, 0.1, 0.0], [0.0, 1.0 / 1.2, 0.05], [0.0, 0.0, 1.0]];
    let dilating = [[1.2, 0.1, 0.0], [-0.05, 0.9, 0.05], [0.02, 0.0, 1.1]];
    for order in ORDERS {
        for (compliance, f) in [(0.0, isochoric), (1.0 / 360.0, dilating), (0.5, dilating)] {
            let mut problem = problem(order, 3, true, compliance);
            let exact =
                |x: &Vector| [0, 1, 2].map(|i| (0..3).map(|j| f[i][j] * x[j]).sum::<f64>() - x[i]);
            for (support, x) in problem.supports.iter_mut().zip(&problem.mesh.nodes) {
                if x.iter().any(|&c| c == 0.0 || c == 1.0) {
                    *support = exact(x).map(Some);
                }
            }
            let (state, _) = solve(&problem, &held());
            for (u, x) in state.displacement.iter().zip(&problem.mesh.nodes) {
                for (u, exact) in u.iter().zip(exact(x)) {
                    assert!(
                        (u - exact).abs() < 1e-10,
                        "{order:?} compliance {compliance}: {u} for {exact}"
                    );
                }
            }
        }
    }
}

/// Cube held by symmetry planes and stretched by `l` along z with free sides: the sides and the pressure are exact.
#[test]
fn uniaxial_stretch_of_an_incompressible_cube_is_exact() {
    for order in ORDERS {
        for l in [0.5f64, 1.5, 3.0] {
            let mut problem = problem(order, 2, true, 0.0);
            for (support, x) in problem.supports.iter_mut().zip(&problem.mesh.nodes) {
                for axis in 0..3 {
                    if x[axis] == 0.0 {
                        support[axis] = Some(0.0);
                    }
                }
                if x[2] == 1.0 {
                    support[2] = Some(l - 1.0);
                }
            }
            let (state, _) = solve(&problem, &held());
            for (u, x) in state.displacement.iter().zip(&problem.mesh.nodes) {
                assert!(
                    (u[0] - (l.powf(-0.5) - 1.0) * x[0]).abs() < 1e-8,
                    "{order:?} {l}: {} at {}",
                    u[0],
                    x[0]
                );
                assert!((u[2] - (l - 1.0) * x[2]).abs() < 1e-8);
            }
            // Free sides: p = -P_iso_xx / G_xx everywhere, one constant mode per brick.
            let material = MooneyRivlin {
                c10: 0.144,
                c01: 0.036,
            };
            let side = l.powf(-0.5);
            let f = [[side, 0.0, 0.0], [0.0, side, 0.0], [0.0, 0.0, l]];
            let p = -fem::material::Isochoric::stress(&material, &f)[0][0] / (side * l);
            for brick in state.pressure.chunks_exact(order.pressure_modes()) {
                assert!(
                    (brick[0] - p).abs() < 1e-8,
                    "{order:?} {l}: pressure {} for {p}",
                    brick[0]
                );
                assert!(brick[1..].iter().all(|mode| mode.abs() < 1e-8));
            }
        }
    }
}

/// A free cube under live pressure on all faces shrinks uniformly: J = 1 - p / kappa for U = kappa (J - 1)^2 / 2.
#[test]
fn a_cube_under_live_pressure_shrinks_by_the_bulk_modulus() {
    for (kappa, p) in [(360.0f64, 0.2f64), (3.6, 0.2)] {
        let mut problem = problem(Order::Linear, 2, false, 1.0 / kappa);
        let n = 3;
        let node = |i: usize, j: usize, k: usize| ((k * n + j) * n + i) as u32;
        let mut faces = Vec::new();
        for b in 0..2 {
            for a in 0..2 {
                for (u, v) in [(0, 0), (1, 0), (0, 1), (1, 1)] {
                    faces.push(node(2, a + u, b + v)); // x = 1, normal +x
                }
                for (u, v) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
                    faces.push(node(a + u, 2, b + v)); // y = 1, normal +y
                }
                for (u, v) in [(0, 0), (1, 0), (0, 1), (1, 1)] {
                    faces.push(node(a + u, b + v, 2)); // z = 1, normal +z
                }
            }
        }
        problem.pressure = Some(PressureSurface::new(Surface {
            order: Order::Linear,
            faces,
        }));
        for (support, x) in problem.supports.iter_mut().zip(&problem.mesh.nodes) {
            for axis in 0..3 {
                if x[axis] == 0.0 {
                    support[axis] = Some(0.0);
                }
            }
        }
        let (state, _) = solve(
            &problem,
            &Loads {
                pressure: -p,
                ..Loads::default()
            },
        );
        let stretch = (1.0 - p / kappa).cbrt();
        for (u, x) in state.displacement.iter().zip(&problem.mesh.nodes) {
            for axis in 0..3 {
                assert!((u[axis] - (stretch - 1.0) * x[axis]).abs() < 1e-10);
            }
        }
    }
}

/// Newton is quadratic: each of the last residuals is bounded by a constant times the square of the one before. With
/// tangents kept it needs fewer of them and ends at the same state.
#[test]
fn newton_converges_quadratically_on_a_twisted_cube() {
    let mut problem = problem(Order::Quadratic, 2, false, 1.0 / 360.0);
    for (support, x) in problem.supports.iter_mut().zip(&problem.mesh.nodes) {
        if x[2] == 0.0 {
            *support = [Some(0.0); 3];
        } else if x[2] == 1.0 {
            let (s, c) = 0.4f64.sin_cos();
            let (dx, dy) = (x[0] - 0.5, x[1] - 0.5);
            *support = [
                Some(c * dx - s * dy - dx),
                Some(s * dx + c * dy - dy),
                Some(0.1),
            ];
        }
    }
    let (state, steps) = solve(&problem, &held());
    let history = &steps[0];
    println!("residuals {history:?}");
    let mut newton = Newton::new(&problem).expect("a valid mesh");
    let (kept, slower) = solve_with(&mut newton, &problem, &held());
    println!("with kept tangents {:?}, {:?}", slower[0], newton.effort);
    assert!(newton.effort.factorisations < history.len() - 1);
    let scale = 0.4f64.sin();
    for (a, b) in state.displacement.iter().zip(&kept.displacement) {
        for axis in 0..3 {
            // Both residuals are below 1e-10 of the forces; the stiffness turns that into as much of the displacement,
            // times the condition of a cube of two elements an edge, about 100.
            assert!((a[axis] - b[axis]).abs() < 1e-8 * scale);
        }
    }
    let tail: Vec<f64> = history
        .iter()
        .copied()
        .filter(|r| (1e-13..1e-1).contains(r))
        .collect();
    assert!(tail.len() >= 3, "{history:?}");
    for pair in tail.windows(2) {
        assert!(pair[1] < 20.0 * pair[0] * pair[0] + 1e-12, "{history:?}");
    }
}
