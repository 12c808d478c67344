//! A bar on glue that shears, on a body that is stretched: what soft glue leaves of a film's tension.
//!
//! On a body strained by e, a bar of half length a and stiffness A (N/mm) on springs K (N/mm^3) has the mean tension A e (1 - tanh(x) / x), x = a (K / A)^(1/2) (shear
//! lag: E. F. Crawley and J. de Luis, AIAA J. 25 (1987) 1373).

use std::sync::atomic::AtomicBool;

use fem::cell::block::Block;
use fem::cell::element::Order;
use fem::cell::mesh::SurfacePoint;
use fem::problem::{Loads, Problem};
use fem::surface::sheet::{Elasticity, Outline, Sheet, Underlay};

use crate::body::{RUBBER, free_block, load, rubber};
use crate::family::Unsolved;
use crate::known_case::Case;

/// Half length of the bar, mm; the body is as long.
const HALF: f64 = 1.0;
/// Strain of the body. The formula is linear in it.
const STRAIN: f64 = 1e-6;
/// Stiffness of the bar, N/mm.
const STIFFNESS: f64 = 50.0;
/// Half length over the length in which glue passes the tension on.
const LENGTHS: [f64; 3] = [0.5, 2.0, 8.0];
/// Spans of the three nets.
const SPANS: [usize; 3] = [8, 16, 32];
/// The mean tension is as stationary as the energy: twice the degree of the splines.
const RATE: f64 = 4.0;
/// Relative: the strain, and the last net's error where the tension changes over four spans: (1/4)^4 / 30 of it.
const TOLERANCE: f64 = 2e-4;
const SOURCE: &str = "1 - tanh(x) / x, x = a (K / A)^(1/2), by shear lag";

/// A body held at its strain, with a bar on it.
fn glued(length: f64, spans: usize) -> Problem {
    let block = Block::new(Order::Quadratic, [1, 1, 1], |s| {
        [HALF * (2.0 * s[0] - 1.0), HALF * (2.0 * s[1] - 1.0), s[2]]
    });
    let top = block.side(2, true);
    let mut problem = free_block(block, rubber(RUBBER, 1.0));
    let place = |s: [f64; 2]| {
        let local = s.map(|s| s / HALF);
        (SurfacePoint { face: 0, local }, [1.0; 3])
    };
    let underlay = Underlay {
        mesh: &problem.mesh,
        surface: &top,
        place: &place,
    };
    let elasticity = Elasticity {
        membrane: [
            [STIFFNESS, 0.0, 0.0],
            [0.0, STIFFNESS, 0.0],
            [0.0, 0.0, 0.5 * STIFFNESS],
        ],
        bending: [[0.0; 3]; 3],
        glue: STIFFNESS * (length / HALF).powi(2),
    };
    let outline = Outline {
        half: [HALF, 0.25 * HALF],
        spans: [spans, 1],
        mirrors: [None; 2],
    };
    let first = problem.mesh.nodes.len();
    let sheet = Sheet::new(outline, elasticity, underlay, first as u32);
    for (support, x) in problem.supports.iter_mut().zip(&problem.mesh.nodes) {
        *support = [Some(STRAIN * x[0]), Some(0.0), Some(0.0)];
    }
    problem.mesh.nodes.extend(&sheet.positions);
    problem.supports.resize(problem.mesh.nodes.len(), [None; 3]);
    problem.sheet = Some(sheet);
    problem
}

/// Mean tension of the bar over that of one without end.
fn share(length: f64, spans: usize, stop: &AtomicBool) -> Result<f64, Unsolved> {
    let problem = glued(length, spans);
    let loads = Loads {
        support_factor: 1.0,
        ..Loads::default()
    };
    let (_, state) = load(&problem, &loads, stop)?;
    let sheet = problem.sheet.as_ref();
    let points = sheet.map_or(Vec::new(), |sheet| sheet.points(&state.displacement));
    let area: f64 = points.iter().map(|point| point.area).sum();
    let strain = points.iter().map(|point| point.area * point.strain[0]);
    Ok(strain.sum::<f64>() / (area * STRAIN))
}

/// Shares of the tension for short, middling and long bars.
pub(super) fn cases(stop: &AtomicBool) -> Result<Vec<Case>, Unsolved> {
    let case = |length: f64| {
        let [coarse, middle, fine] = SPANS.map(|spans| share(length, spans, stop));
        let [coarse, middle, fine] = [coarse?, middle?, fine?];
        let slope = ((coarse - middle) / (middle - fine)).abs().log2();
        let case = Case::relative(
            format!("bar on glue, {length} lengths of shear lag: share of the tension"),
            fine,
            1.0 - length.tanh() / length,
        );
        Ok(case.slope(slope, RATE).within(TOLERANCE, SOURCE))
    };
    LENGTHS.into_iter().map(case).collect()
}
