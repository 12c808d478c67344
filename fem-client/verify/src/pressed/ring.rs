//! A ring in plane strain between two plates, against an independent code.

use std::sync::atomic::AtomicBool;

use fem::cell::block::Block;
use fem::cell::element::Order;
use fem::problem::Problem;

use super::plate::{CONTACT_WIDTH, Pressing, touch};
use crate::body::{
    RUBBER, SHEAR_MODULUS, free_block, hold_coordinate_planes, quarter_circle, rubber,
};
use crate::family::Unsolved;
use crate::known_case::Case;

const INNER: f64 = 9.5;
const OUTER: f64 = 12.5;
/// Bulk over shear modulus, as in the other code.
const BULK_RATIO: f64 = 1000.0;
const SOURCE: &str = "independent code; tolerance: difference of its two finest meshes, and the reach of its contact";

/// Force of a plate per length, height of the lowest inner point, and half width, at a depth of each plate.
type PlateReading = [f64; 3];

/// The other code's answers on 3 x 32 and 4 x 64 elements of the same order.
const PUBLISHED: [(f64, PlateReading, PlateReading); 5] = [
    (
        1.0,
        [0.02656982796423571, -8.515683236418598, 13.293739465708596],
        [0.02656523695070887, -8.515752810396165, 13.293682699086544],
    ),
    (
        2.0,
        [0.048956933414469155, -7.523660779857234, 13.985012020955201],
        [0.04894654819941435, -7.523757956823012, 13.984903164456504],
    ),
    (
        4.0,
        [0.09046535111129188, -5.515533407982975, 15.136454183390814],
        [0.09044914388758646, -5.515539333097918, 15.136428067585213],
    ),
    (
        6.0,
        [0.1683475971198898, -3.5058980219020395, 16.23207634312679],
        [0.1683019565664534, -3.50589829205383, 16.23216342015628],
    ),
    (
        8.0,
        [0.3837955973421074, -1.5036386706757376, 17.375965587239058],
        [0.3832578673789361, -1.5036487780090448, 17.375859874938605],
    ),
];

fn quarter() -> Problem {
    let block = Block::new(Order::PlaneQuadratic, [64, 1, 4], |s| {
        quarter_circle(s[0], OUTER + s[2] * (INNER - OUTER))
    });
    let outside = block.side(2, false).flipped();
    let compliance = 1.0 / (BULK_RATIO * SHEAR_MODULUS);
    let mut problem = free_block(block, rubber(RUBBER, compliance));
    touch(&mut problem, outside);
    hold_coordinate_planes(&mut problem);
    problem
}

/// Reads the ring's answers. A plate touches both halves, so its force is twice the quarter's.
fn answer(problem: &Problem, pressing: &Pressing<'_>) -> PlateReading {
    let place = |x: [f64; 3]| {
        let node = problem.mesh.nodes.iter().position(|node| *node == x);
        let position = |node| pressing.state.position(&problem.mesh, node as u32);
        node.map_or([f64::NAN; 3], position)
    };
    let force = 2.0 * pressing.moments(0).0;
    [
        force,
        place([0.0, 0.0, -INNER])[2],
        place([OUTER, 0.0, 0.0])[0],
    ]
}

/// Force and shape at several depths.
pub(crate) fn cases(stop: &AtomicBool) -> Result<Vec<Case>, Unsolved> {
    let problem = quarter();
    let mut pressing = Pressing::new(&problem, OUTER)?;
    let names = ["force, N/mm", "lowest inner point, mm", "half width, mm"];
    let mut cases = Vec::new();
    for (depth, coarse, fine) in PUBLISHED {
        pressing.to(depth, stop)?;
        let computed = answer(&problem, &pressing);
        pressing.to(depth + CONTACT_WIDTH, stop)?;
        let deeper = answer(&problem, &pressing);
        for (k, quantity) in names.into_iter().enumerate() {
            let reach = (deeper[k] / computed[k] - 1.0).abs();
            let tolerance = (coarse[k] / fine[k] - 1.0).abs() + reach;
            let name = format!("ring pressed by {depth} mm: {quantity}");
            cases.push(Case::relative(name, computed[k], fine[k]).within(tolerance, SOURCE));
        }
    }
    Ok(cases)
}
