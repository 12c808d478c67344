//! Plane strain against homogeneous deformations, three-dimensional slabs and Cook's membrane.

use std::sync::atomic::AtomicBool;

use fem::cell::block::Block;
use fem::cell::element::Order;
use fem::cell::mesh::Surface;
use fem::load::contact::{ContactSurface, Penalty};
use fem::load::ground_shape::Profile;
use fem::load::obstacle::{GroundAxes, HeightField, StationFunctions};
use fem::load::pressure::PressureSurface;
use fem::material::MooneyRivlin;
use fem::newton::iteration::Newton;
use fem::newton::path::{Stability, follow};
use fem::problem::{Loads, Problem, State};
use fem::solid::SolidModel;
use fem::tensor::Vector;

static RUNNING: AtomicBool = AtomicBool::new(false);

/// Plane orders with the three-dimensional ones of the same degree.
const PAIRS: [(Order, Order); 2] = [
    (Order::PlaneLinear, Order::Linear),
    (Order::PlaneQuadratic, Order::Quadratic),
];

/// n x n cells, one across in space, on the image of the unit square under `map` in the plane (x, z), y from 0 to 1.
fn block(order: Order, n: usize, map: impl Fn(f64, f64) -> [f64; 2]) -> Block {
    Block::new(order, [n, 1, n], |s| {
        let [x, z] = map(s[0], s[2]);
        [x, s[1], z]
    })
}

/// A body whose lateral displacements are held.
fn problem(block: Block, compliance: f64) -> Problem {
    let Block { mesh, layout, .. } = block;
    let supports = vec![[None, Some(0.0), None]; mesh.nodes.len()];
    let material = Box::new(MooneyRivlin {
        c10: 0.144,
        c01: 0.036,
    });
    Problem {
        mesh,
        layout,
        solid: SolidModel {
            material,
            compliance,
        },
        membranes: vec![],
        sheet: None,
        supports,
        pressure: None,
        contact: None,
        dead_forces: vec![],
    }
}

fn solve(problem: &Problem, target: &Loads) -> State {
    let mut newton = Newton::new(problem).expect("a valid mesh");
    let mut state = State::reference(problem);
    let start = Loads::default();
    follow(
        &mut newton,
        &mut state,
        &start,
        target,
        Stability::Ignored,
        &RUNNING,
    )
    .expect("an equilibrium");
    state
}

fn held() -> Loads {
    Loads {
        support_factor: 1.0,
        ..Loads::default()
    }
}

/// A map that bends the lines of the mesh and leaves the square's boundary where it is.
fn bent(s: f64, t: f64) -> [f64; 2] {
    let bubble = s * (1.0 - s) * t * (1.0 - t);
    [s + 0.4 * bubble * (1.0 + t), t - 0.5 * bubble * (1.0 - s)]
}

#[test]
fn patch_test_reproduces_a_homogeneous_deformation() {
    let isochoric = [[1.2, 0.1], [0.0, 1.0 / 1.2]];
    let dilating = [[1.2, 0.1], [-0.05, 0.9]];
    for (order, _) in PAIRS {
        for (compliance, f) in [(0.0, isochoric), (1.0 / 360.0, dilating), (0.5, dilating)] {
            let mut problem = problem(block(order, 3, bent), compliance);
            let exact = |x: &Vector| {
                let image = f.map(|row| row[0] * x[0] + row[1] * x[2]);
                [image[0] - x[0], 0.0, image[1] - x[2]]
            };
            for (support, x) in problem.supports.iter_mut().zip(&problem.mesh.nodes) {
                // The map keeps the boundary up to a rounding.
                if [x[0], x[2]].iter().any(|c| (c * (1.0 - c)).abs() < 1e-15) {
                    *support = exact(x).map(Some);
                }
            }
            let state = solve(&problem, &held());
            for (u, x) in state.displacement.iter().zip(&problem.mesh.nodes) {
                for (u, exact) in u.iter().zip(exact(x)) {
                    // Newton's relative tolerance of 1e-10.
                    assert!(
                        (u - exact).abs() < 1e-10,
                        "{order:?} {compliance}: {u} for {exact}"
                    );
                }
            }
        }
    }
}

/// A trapezoid hung from its upper side, its lower one sucked on to an uneven ground: all that a plane body can meet.
fn loaded_block(order: Order) -> (Problem, Loads, f64) {
    let block = block(order, 4, |s, t| [2.0 * (s - 0.5) * (1.0 - 0.2 * t), t]);
    let lower = block.side(2, false);
    let mut problem = problem(block, 0.1);
    for (support, x) in problem.supports.iter_mut().zip(&problem.mesh.nodes) {
        if x[2] == 1.0 {
            support[0] = Some(0.05);
            support[2] = Some(0.0);
        }
    }
    let penalty = Penalty {
        stiffness: 20.0,
        ramp: 1e-3,
    };
    problem.contact = Some(ContactSurface::new(&problem.mesh, lower.clone(), penalty));
    problem.pressure = Some(PressureSurface::new(lower));
    let ground = HeightField {
        axes: GroundAxes::LEVEL,
        base: 0.0,
        spacing: 0.5,
        functions: StationFunctions::BSpline,
        depths: vec![0.1, 0.15, 0.05],
        shift: [0.0; 2],
        profile: Profile::Plane,
    };
    let loads = Loads {
        pressure: -0.02,
        ground: Some(ground.clone()),
        ground_force: None,
        support_factor: 1.0,
        traction_factor: 0.0,
    };
    let state = solve(&problem, &loads);
    let contact = problem.contact.as_ref().expect("set above");
    let resultant = contact.resultant(&ground, |node| state.position(&problem.mesh, node));
    let force = resultant.load;
    (problem, loads, force)
}

#[test]
fn a_plane_body_is_a_slab_of_thickness_one_with_held_lateral_displacements() {
    for (plane, space) in PAIRS {
        let (flat, _, force) = loaded_block(plane);
        let (slab, _, expected) = loaded_block(space);
        assert!(flat.mesh.nodes.len() < slab.mesh.nodes.len());
        assert!(expected > 0.1, "the ground pushes with {expected} N");
        // Both are solved to 1e-10 of their forces, which reach a few times the contact force.
        assert!(
            (force - expected).abs() < 1e-9 * expected,
            "{plane:?}: {force} N/mm, slab {expected} N"
        );
    }
}

/// The slab in its plane, node by node.
#[test]
fn a_slab_moves_as_the_plane_body_does() {
    for (plane, space) in PAIRS {
        let displacements = |order: Order| {
            let (problem, loads, _) = loaded_block(order);
            let state = solve(&problem, &loads);
            let across = problem.mesh.order.brick_nodes() / problem.mesh.order.edge_nodes().pow(2);
            let line = 4 * (problem.mesh.order.edge_nodes() - 1) + 1;
            // The nodes at y = 0.
            let front = (0..problem.mesh.nodes.len()).filter(|node| node / line % across == 0);
            front
                .map(|node| state.displacement[node])
                .collect::<Vec<_>>()
        };
        let (flat, slab) = (displacements(plane), displacements(space));
        assert_eq!(flat.len(), slab.len());
        for (a, b) in flat.iter().flatten().zip(slab.iter().flatten()) {
            assert!((a - b).abs() < 1e-9, "{plane:?}: {a} {b}");
        }
    }
}

#[test]
fn a_closed_line_encloses_its_area_times_the_thickness() {
    // A unit square turned counter-clockwise has its normals inside; its reverse has them outside.
    let nodes: [Vector; 4] = [
        [2.0, 0.0, 3.0],
        [3.0, 0.0, 3.0],
        [3.0, 0.0, 4.0],
        [2.0, 0.0, 4.0],
    ];
    let surface = PressureSurface::new(Surface {
        order: Order::PlaneLinear,
        faces: vec![1, 0, 2, 1, 3, 2, 0, 3],
    });
    let volume = surface.enclosed_volume(|node| nodes[node as usize]);
    assert!((volume - 1.0).abs() < 1e-14, "{volume}");
}
