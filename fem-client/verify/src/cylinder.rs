//! A thick incompressible cylinder inflated in plane strain: exact at any stretch, without a limit point.

use std::sync::atomic::AtomicBool;

use fem::cell::block::Block;
use fem::cell::element::Order;
use fem::load::pressure::PressureSurface;
use fem::newton::volume_control::VolumeControl;
use fem::problem::Problem;

use crate::body::{
    PLANE, RUBBER, SHEAR_MODULUS, free_block, hold_coordinate_planes, inflate, quarter_circle,
    rubber,
};
use crate::family::Unsolved;
use crate::known_case::Case;
use crate::mesh_refinement::Refinement;

/// Source of the pressures.
pub(crate) const SOURCE: &str =
    "exact: mu (ln(B/b) - ln(A/a) + k (a^-2 - b^-2) / 2 with A, B for a, b), k = a^2 - A^2";
/// Stretches of the inner radius.
pub(crate) const STRETCHES: [f64; 5] = [1.05, 1.1, 1.2, 1.5, 2.0];
/// Radii A and B, mm.
const RADII: [[f64; 2]; 3] = [[9.5, 12.5], [7.5, 12.5], [10.0, 20.0]];

/// A quarter, with `n` elements through the wall and twice as many around, whose grid (around, through) is bent by a map of the
/// unit square to itself.
pub(crate) fn quarter(
    order: Order,
    n: usize,
    [inner, outer]: [f64; 2],
    bend: impl Fn([f64; 2]) -> [f64; 2],
) -> Problem {
    let block = Block::new(order, [2 * n, 1, n], |s| {
        let [around, through] = bend([s[0], s[2]]);
        // From the outside inwards: right-handed with the angle running from below to the side.
        quarter_circle(around, outer + through * (inner - outer))
    });
    let inside = block.side(2, true).flipped();
    let mut problem = free_block(block, rubber(RUBBER, 0.0));
    problem.pressure = Some(PressureSurface::new(inside));
    hold_coordinate_planes(&mut problem);
    problem
}

/// Pressure at which the inner radius `a` is its stretch times A. In plane strain Mooney-Rivlin is neo-Hookean.
pub(crate) fn exact([inner, outer]: [f64; 2], stretch: f64) -> f64 {
    let a = stretch * inner;
    let k = a * a - inner * inner;
    let b = (outer * outer + k).sqrt();
    let logarithms = (outer / b).ln() - (inner / a).ln();
    SHEAR_MODULUS * (logarithms + 0.5 * k * (1.0 / (a * a) - 1.0 / (b * b)))
}

/// Pressures at all stretches on one mesh.
pub(crate) fn pressures(problem: &Problem, stop: &AtomicBool) -> Result<Vec<f64>, Unsolved> {
    let mut control = VolumeControl::new(problem)?;
    let start = control
        .reference(stop)
        .map_err(|failure| Unsolved::Volume {
            ratio: 1.0,
            cause: failure.cause,
        })?;
    let mut last = start.clone();
    let mut pressures = Vec::new();
    for stretch in STRETCHES {
        last = inflate(&mut control, &last, stretch * stretch * start.volume, stop)?;
        pressures.push(last.pressure);
    }
    Ok(pressures)
}

/// Pressure against the stretch of the inner radius, for both orders.
pub(super) fn cases(stop: &AtomicBool) -> Result<Vec<Case>, Unsolved> {
    let mut cases = Vec::new();
    for radii in RADII {
        for (order, element, theory) in PLANE {
            let n = if order == Order::PlaneLinear { 16 } else { 4 };
            let even = |place| place;
            let coarse = pressures(&quarter(order, n, radii, even), stop)?;
            let fine = pressures(&quarter(order, 2 * n, radii, even), stop)?;
            let expected = STRETCHES.map(|stretch| exact(radii, stretch));
            let meshes = Refinement::new(coarse, fine.clone(), 2.0);
            let slope = meshes.slope(&expected);
            for ((stretch, fine), expected) in STRETCHES.into_iter().zip(fine).zip(expected) {
                let name = format!(
                    "cylinder {}/{}, stretch {stretch}, {element}: pressure, MPa",
                    radii[0], radii[1]
                );
                let case = Case::relative(name, fine, expected).slope(slope, theory);
                cases.push(case.within(meshes.bound(theory), SOURCE));
            }
        }
    }
    Ok(cases)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_closed_form_gives_the_published_values() {
        for (radii, stretch, published) in [
            ([9.5, 12.5], 1.05, 0.013_884_905_381_336_876),
            ([7.5, 12.5], 1.5, 0.123_223_929_795_574_99),
            ([10.0, 20.0], 2.0, 0.206_659_286_030_347_1),
        ] {
            // Differences of logarithms of order one.
            assert!((exact(radii, stretch) - published).abs() < 1e-15);
        }
    }
}
