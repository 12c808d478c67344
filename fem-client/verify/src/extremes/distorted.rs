//! Elements squeezed and sheared 20:1: homogeneous deformations stay exact, and an inflated cylinder converges.

use std::sync::atomic::AtomicBool;

use fem::cell::block::Block;
use fem::cell::element::Order;
use fem::tensor::{Tensor, Vector, norm};

use crate::body::{PLANE, RUBBER, SPACE, free_block, load, rubber};
use crate::cylinder;
use crate::family::Unsolved;
use crate::homogeneous::{HELD, moved};
use crate::known_case::Case;
use crate::mesh_refinement::Refinement;

/// Longest over shortest edge, and shift over height.
const RATIO: f64 = 20.0;
/// Newton's tolerance of 1e-10, and ten times what a face carries, on a body of size 1: as for elements that aren't spoilt.
const TOLERANCE: f64 = 1e-9;

/// A way to spoil elements: a map of the unit cube to itself or, for the sheared one, to a parallelepiped.
type Spoil = (&'static str, fn([f64; 3]) -> Vector);

const SPOILS: [Spoil; 3] = [
    ("squeezed 20:1", |s| s.map(squeezed)),
    ("flattened 20:1", |s| [s[0], s[1], s[2] / RATIO]),
    ("sheared 20:1", |s| [s[0] + RATIO * s[2], s[1], s[2]]),
];

/// Two cells, one 20 times as long as the other; uniform within each.
fn squeezed(s: f64) -> f64 {
    let kink = RATIO / (1.0 + RATIO);
    if s <= 0.5 {
        2.0 * s * kink
    } else {
        kink + (2.0 * s - 1.0) * (1.0 - kink)
    }
}

/// Volume-preserving, in the plane (x, z) too.
const STRETCH: Tensor = [[1.2, 0.0, 0.1], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0 / 1.2]];

/// Largest error of a displacement over the body's size, under x = F X on the whole boundary.
fn patch_error(
    order: Order,
    map: fn([f64; 3]) -> Vector,
    stop: &AtomicBool,
) -> Result<f64, Unsolved> {
    let cells = [4, 4, 4];
    let cube = Block::new(order, cells, |s| s);
    let block = Block::new(order, cells, map);
    let mut problem = free_block(block, rubber(RUBBER, 0.0));
    let across = if order.is_plane() { Some(1) } else { None };
    for (node, place) in cube.mesh.nodes.iter().enumerate() {
        let on_side =
            |axis: usize| Some(axis) != across && (place[axis] == 0.0 || place[axis] == 1.0);
        if (0..3).any(on_side) {
            problem.supports[node] = moved(&STRETCH, &problem.mesh.nodes[node]).map(Some);
        }
    }
    let (_, state) = load(&problem, &HELD, stop)?;
    let size = problem.mesh.nodes.iter().map(norm).fold(0.0, f64::max);
    let nodes = problem.mesh.nodes.iter().zip(&state.displacement);
    let errors = nodes.map(|(x, u)| {
        let exact = moved(&STRETCH, x);
        norm(&[0, 1, 2].map(|i| u[i] - exact[i]))
    });
    Ok(errors.fold(0.0, f64::max) / size)
}

/// Radii A and B of a cylinder whose wall is thin enough for its elements to be sheared 20:1, mm.
const THIN: [f64; 2] = [12.25, 12.5];

/// Turns the grid lines through the wall by up to 0.4 rad, against a wall of 0.02 radii: 20:1. The ends stay.
fn sheared([around, through]: [f64; 2]) -> [f64; 2] {
    let angle = 4.0 * around * (1.0 - around) * RATIO * (THIN[1] - THIN[0]) / THIN[1];
    [
        around + angle * (through - 0.5) / std::f64::consts::FRAC_PI_2,
        through,
    ]
}

/// Patch tests and cylinders.
pub(super) fn cases(stop: &AtomicBool) -> Result<Vec<Case>, Unsolved> {
    let mut cases = Vec::new();
    let planes = PLANE.map(|(order, element, _)| (order, element));
    for (spoil, map) in SPOILS {
        for (order, element) in SPACE.into_iter().chain(planes) {
            let name =
                format!("patch test, {spoil}, {element}: largest error of a displacement / size");
            let case = Case::absolute(name, patch_error(order, map, stop)?, 0.0);
            cases.push(case.within(TOLERANCE, "exact: x = F X"));
        }
    }
    for cylinder in CYLINDERS {
        cases.extend(cylinder.cases(stop)?);
    }
    Ok(cases)
}

/// A cylinder whose grid (around, through the wall) is spoilt.
struct Spoilt {
    name: &'static str,
    radii: [f64; 2],
    bend: fn([f64; 2]) -> [f64; 2],
    /// Elements through the wall on the coarser mesh: 4-node, 9-node.
    elements: [usize; 2],
}

/// A sheared 4-node cell is too stiff until it is much smaller: with half as many the rate is 1.3 instead of 2.
const CYLINDERS: [Spoilt; 2] = [
    Spoilt {
        name: "squeezed 20:1",
        radii: [7.5, 12.5],
        bend: |place| place.map(squeezed),
        elements: [16, 4],
    },
    Spoilt {
        name: "sheared 20:1",
        radii: THIN,
        bend: sheared,
        elements: [64, 4],
    },
];

impl Spoilt {
    /// Pressures against the exact ones, for both orders.
    fn cases(&self, stop: &AtomicBool) -> Result<Vec<Case>, Unsolved> {
        let mut cases = Vec::new();
        for ((order, element, theory), n) in PLANE.into_iter().zip(self.elements) {
            let pressures = |n| {
                let quarter = cylinder::quarter(order, n, self.radii, self.bend);
                cylinder::pressures(&quarter, stop)
            };
            let (coarse, fine) = (pressures(n)?, pressures(2 * n)?);
            let exact = |stretch| cylinder::exact(self.radii, stretch);
            let expected = cylinder::STRETCHES.map(exact);
            let meshes = Refinement::new(coarse, fine.clone(), 2.0);
            let slope = meshes.slope(&expected);
            let places = cylinder::STRETCHES.into_iter().zip(fine).zip(expected);
            for ((stretch, fine), expected) in places {
                let (name, [inner, outer]) = (self.name, self.radii);
                let name = format!(
                    "cylinder {inner}/{outer}, {name}, stretch {stretch}, {element}: pressure, MPa"
                );
                let case = Case::relative(name, fine, expected).slope(slope, theory);
                cases.push(case.within(meshes.bound(theory), cylinder::SOURCE));
            }
        }
        Ok(cases)
    }
}
