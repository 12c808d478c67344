//! A cube of bricks, for problems with exact answers.

use fem::cell::element::Order;
use fem::cell::mesh::{Mesh, Surface};
use fem::material::MooneyRivlin;
use fem::problem::Problem;
use fem::solid::SolidModel;

/// A cube of n^3 bricks on [0, 1]^3 whose inner nodes are moved about when `distorted`.
fn cube(order: Order, n: usize, distorted: bool) -> (Mesh, Vec<[f64; 3]>) {
    let e = order.edge_nodes() - 1;
    let line = n * e + 1;
    let nodes = (0..line.pow(3))
        .map(|a| {
            let index = [a % line, a / line % line, a / (line * line)];
            let mut x = index.map(|i| i as f64 / (line - 1) as f64);
            if distorted && index.iter().all(|&i| i > 0 && i < line - 1) {
                let size = 0.15 / (line - 1) as f64;
                x = [
                    x[0] + size * (7.0 * x[1]).sin(),
                    x[1] + size * (5.0 * x[2]).cos(),
                    x[2] - size * (9.0 * x[0]).sin(),
                ];
            }
            x
        })
        .collect();
    let (mut bricks, mut layout) = (Vec::new(), Vec::new());
    for b in 0..n.pow(3) {
        let at = [b % n, b / n % n, b / (n * n)];
        layout.push(at.map(|i| i as f64));
        for k in 0..=e {
            for j in 0..=e {
                bricks.extend((0..=e).map(|i| {
                    (((at[2] * e + k) * line + at[1] * e + j) * line + at[0] * e + i) as u32
                }));
            }
        }
    }
    (
        Mesh {
            order,
            nodes,
            bricks,
        },
        layout,
    )
}

/// The cube as a Mooney-Rivlin solid without supports and loads.
pub fn problem(order: Order, n: usize, distorted: bool, compliance: f64) -> Problem {
    let (mesh, layout) = cube(order, n, distorted);
    let supports = vec![[None; 3]; mesh.nodes.len()];
    let solid = SolidModel {
        material: Box::new(MooneyRivlin {
            c10: 0.144,
            c01: 0.036,
        }),
        compliance,
    };
    Problem {
        mesh,
        layout,
        solid,
        membranes: vec![],
        sheet: None,
        supports,
        pressure: None,
        contact: None,
        dead_forces: vec![],
    }
}

/// The face z = 0 of a cube of n^3 bricks, its normal outwards.
pub fn bottom(order: Order, n: usize) -> Surface {
    let e = order.edge_nodes() - 1;
    let line = n * e + 1;
    let mut faces = Vec::new();
    for b in 0..n {
        for a in 0..n {
            for j in 0..=e {
                faces.extend((0..=e).map(|i| ((b * e + j) * line + a * e + i) as u32));
            }
        }
    }
    Surface { order, faces }
}
