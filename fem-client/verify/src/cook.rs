//! Cook's membrane: a tapered panel, clamped on one side and sheared on the other. It has no closed form; two independent
//! codes of the same elements agree on the same meshes.

use std::sync::atomic::AtomicBool;

use fem::cell::block::Block;
use fem::cell::element::Order;
use fem::load::traction::nodal_forces;
use fem::material::MooneyRivlin;
use fem::problem::{Loads, Problem};

use crate::body::{free_block, load, rubber};
use crate::family::Unsolved;
use crate::known_case::Case;

/// 80.194 MPa of shear modulus and 400 889.8 MPa of bulk modulus, nearly incompressible.
const MATERIAL: MooneyRivlin = MooneyRivlin {
    c10: 40.097,
    c01: 0.0,
};
const BULK_MODULUS: f64 = 400_889.8;
/// Shear force on the end, per thickness, N/mm.
const FORCE: f64 = 100.0;
/// Height of the end, mm.
const END: f64 = 16.0;

const SAME_MESH: &str = "independent code, same element and mesh";
/// Two independent codes agree among themselves to eight digits.
const SAME_MESH_TOLERANCE: f64 = 1e-8;

/// Elements along a side, and displacement of the tip, mm.
type Tip = (usize, [f64; 2]);

fn panel(order: Order, n: usize) -> Problem {
    let block = Block::new(order, [n, 1, n], |s| {
        let (low, high) = (44.0 * s[0], 44.0 + END * s[0]);
        [48.0 * s[0], 0.0, low + s[2] * (high - low)]
    });
    let end = block.side(0, true);
    let mut problem = free_block(block, rubber(MATERIAL, 1.0 / BULK_MODULUS));
    problem.dead_forces = nodal_forces(&problem.mesh, &end, [0.0, 0.0, FORCE / END]);
    for (support, x) in problem.supports.iter_mut().zip(&problem.mesh.nodes) {
        if x[0] == 0.0 {
            *support = [Some(0.0); 3];
        }
    }
    problem
}

/// Displacement of the end's upper corner, mm: along and across.
fn tip(order: Order, n: usize, stop: &AtomicBool) -> Result<[f64; 2], Unsolved> {
    let problem = panel(order, n);
    let loads = Loads {
        traction_factor: 1.0,
        ..Loads::default()
    };
    let (_, state) = load(&problem, &loads, stop)?;
    // The last node of the block.
    let [x, _, z] = state.displacement[problem.mesh.nodes.len() - 1];
    Ok([x, z])
}

/// Displacements on a sequence of meshes of both orders.
pub(super) fn cases(stop: &AtomicBool) -> Result<Vec<Case>, Unsolved> {
    let published: [(Order, &str, &[Tip]); 2] = [
        (
            Order::PlaneLinear,
            "4-node",
            &[
                (2, [-3.084993617156668, 4.512454440698172]),
                (4, [-4.688594260393028, 6.0198407952547335]),
                (8, [-5.3958947703184394, 6.618577206772982]),
                (16, [-5.655403896776774, 6.814433444393397]),
                (32, [-5.756930774330637, 6.884213843573573]),
            ],
        ),
        (
            Order::PlaneQuadratic,
            "9-node",
            &[
                (2, [-5.693811064922672, 6.933562492852222]),
                (4, [-5.745659410404764, 6.8821191627938445]),
                (8, [-5.789310021580768, 6.904643992263164]),
                (16, [-5.814498735889381, 6.919835686055677]),
            ],
        ),
    ];
    let mut cases = Vec::new();
    for (order, element, meshes) in published {
        for (n, expected) in meshes {
            let computed = tip(order, *n, stop)?;
            for ((axis, computed), expected) in ["x", "y"].into_iter().zip(computed).zip(expected) {
                let name =
                    format!("Cook's membrane {n} x {n}, {element}: tip displacement {axis}, mm");
                let case = Case::relative(name, computed, *expected);
                cases.push(case.within(SAME_MESH_TOLERANCE, SAME_MESH));
            }
        }
    }
    Ok(cases)
}
