//! A thick incompressible sphere under internal pressure: exact at any stretch. A neo-Hookean sphere has a limit point.

use std::sync::atomic::AtomicBool;

use fem::cell::block::{Block, join};
use fem::cell::element::Order;
use fem::cell::mesh::Surface;
use fem::load::pressure::PressureSurface;
use fem::material::MooneyRivlin;
use fem::newton::volume_control::{Ending, Inflated, VolumeControl};
use fem::problem::Problem;
use fem::tensor::{Vector, norm};

use crate::body::{RUBBER, free, hold_coordinate_planes, inflate, rubber};
use crate::family::Unsolved;
use crate::known_case::Case;
use crate::mesh_refinement::Refinement;

const LIMIT_SOURCE: &str = "exact: maximum of the pressure below, found to 16 digits";
const SOURCE: &str = "exact: integral of W'(l) / (l^3 - 1) from the outer to the inner stretch";
/// Tolerance of limit pressures.
const LIMIT_TOLERANCE: f64 = 1e-3;
/// Stretch at a limit point: where the slope of the pressure vanishes, an error e of the pressure moves it by its root.
const STRETCH_TOLERANCE: f64 = 0.03;
/// Neo-Hookean with a shear modulus of 1 MPa.
pub(crate) const NEO_HOOKEAN: MooneyRivlin = MooneyRivlin { c10: 0.5, c01: 0.0 };
/// Pressures are stationary: their error falls like h to twice the degree, 2.
pub(crate) const SLOPE: f64 = 4.0;
/// Elements along an edge of a patch and through the wall.
pub(crate) const MESHES: [usize; 2] = [2, 3];
/// Element size of the first mesh over that of the second.
pub(crate) const RATIO: f64 = MESHES[1] as f64 / MESHES[0] as f64;
/// Ratio B/A from which the wall takes twice as many elements.
const THICK: f64 = 3.0;
/// Largest volume over that of the reference state that is searched for a limit point.
const LARGEST_VOLUME: f64 = 30.0;

/// An octant between the radii 1 and `outer`: three patches of a cube, n x n bricks each, and n or 2 n through the wall.
pub(crate) fn octant(n: usize, outer: f64, material: MooneyRivlin) -> Problem {
    let order = Order::Quadratic;
    let radial = if outer >= THICK { 2 * n } else { n };
    let blocks = [0, 1, 2].map(|axis| {
        Block::new(order, [n, n, radial], |s| {
            let mut x: Vector = [0.0; 3];
            x[axis] = 1.0;
            x[(axis + 1) % 3] = edge(s[0]);
            x[(axis + 2) % 3] = edge(s[1]);
            let scale = outer.powf(s[2]) / norm(&x);
            x.map(|c| c * scale)
        })
    });
    let (mesh, layout, numbers) = join(&blocks);
    let inner = blocks.iter().zip(&numbers).flat_map(|(block, numbers)| {
        let faces = block.side(2, false).faces;
        faces.into_iter().map(|node| numbers[node as usize])
    });
    let surface = Surface {
        order,
        faces: inner.collect(),
    };
    let mut problem = free(mesh, layout, rubber(material, 0.0));
    problem.pressure = Some(PressureSurface::new(surface));
    hold_coordinate_planes(&mut problem);
    problem
}

/// Equal angles along a cube's edge, from 0 to exactly 1.
fn edge(t: f64) -> f64 {
    if t == 1.0 {
        1.0
    } else {
        (std::f64::consts::FRAC_PI_4 * t).tan()
    }
}

/// Pressure at which the inner radius 1 is `stretch`. With W = C10 (2 l^2 + l^-4 - 3) + C01 (l^4 + 2 l^-2 - 3) the integrand
/// is 4 C10 (l^-2 + l^-5) + 4 C01 (1 + l^-3).
pub(crate) fn exact(material: &MooneyRivlin, outer: f64, stretch: f64) -> f64 {
    let outer_stretch = (1.0 + (stretch.powi(3) - 1.0) / outer.powi(3)).cbrt();
    let integral = |l: f64| {
        -material.c10 * (4.0 / l + l.powi(-4)) + material.c01 * (4.0 * l - 2.0 * l.powi(-2))
    };
    integral(stretch) - integral(outer_stretch)
}

/// The sphere at rest.
pub(crate) fn reference(
    control: &mut VolumeControl<'_>,
    stop: &AtomicBool,
) -> Result<Inflated, Unsolved> {
    control.reference(stop).map_err(|failure| Unsolved::Volume {
        ratio: 1.0,
        cause: failure.cause,
    })
}

/// A limit point, and a point beyond it.
struct Limit {
    /// Limit pressure, and pressure beyond.
    pressures: [f64; 2],
    /// Stretch of the inner radius at the limit point.
    stretch: f64,
}

fn limit(n: usize, outer: f64, beyond: f64, stop: &AtomicBool) -> Result<Limit, Unsolved> {
    let problem = octant(n, outer, NEO_HOOKEAN);
    let mut control = VolumeControl::new(&problem)?;
    let start = reference(&mut control, stop)?;
    let largest = LARGEST_VOLUME * start.volume;
    let limit = match control.inflate(&start, f64::INFINITY, largest, stop) {
        Ending::LimitPoint(limit) => limit,
        Ending::Lost { failure, .. } => {
            return Err(Unsolved::LimitPoint {
                cause: failure.cause,
            });
        }
        _ => {
            return Err(Unsolved::NoLimitPoint {
                ratio: LARGEST_VOLUME,
            });
        }
    };
    let stretch = (limit.volume / start.volume).cbrt();
    let further = inflate(&mut control, &limit, beyond.powi(3) * start.volume, stop)?;
    Ok(Limit {
        pressures: [limit.pressure, further.pressure],
        stretch,
    })
}

/// The neo-Hookean sphere: limit pressure, its stretch, and a point of the falling path.
pub(super) fn limit_points(stop: &AtomicBool) -> Result<Vec<Case>, Unsolved> {
    // B/A, stretch of the inner radius at the limit point, and limit pressure over shear modulus.
    let published = [
        (1.01, 1.3873921974961585, 0.012332928157264833),
        (1.1, 1.4263846062787593, 0.11801253655936561),
        (1.5, 1.6034343440161167, 0.49351893444152783),
        (2.0, 1.8281473049363495, 0.8164236479554001),
        (3.0, 2.273150376590452, 1.2099608857236537),
    ];
    let mut cases = Vec::new();
    for (outer, stretch, pressure) in published {
        let beyond = 1.25 * stretch;
        let coarse = limit(MESHES[0], outer, beyond, stop)?;
        let fine = limit(MESHES[1], outer, beyond, stop)?;
        let expected = [pressure, exact(&NEO_HOOKEAN, outer, beyond)];
        let meshes = Refinement::new(coarse.pressures.into(), fine.pressures.into(), RATIO);
        let slope = meshes.slope(&expected);
        let sphere = format!("neo-Hookean sphere B/A = {outer}");
        let name = format!("{sphere}: limit pressure / mu");
        let case = Case::relative(name, fine.pressures[0], pressure).slope(slope, SLOPE);
        cases.push(case.within(LIMIT_TOLERANCE, LIMIT_SOURCE));
        let case = Case::relative(
            format!("{sphere}: stretch at the limit"),
            fine.stretch,
            stretch,
        );
        cases.push(case.within(STRETCH_TOLERANCE, LIMIT_SOURCE));
        let name = format!("{sphere}, stretch {beyond:.3}, beyond the limit: pressure / mu");
        let case = Case::relative(name, fine.pressures[1], expected[1]).slope(slope, SLOPE);
        cases.push(case.within(meshes.bound(SLOPE), SOURCE));
    }
    Ok(cases)
}

const STRETCHES: [f64; 5] = [1.1, 1.2, 1.5, 2.0, 3.0];

fn pressures(n: usize, outer: f64, stop: &AtomicBool) -> Result<Vec<f64>, Unsolved> {
    let problem = octant(n, outer, RUBBER);
    let mut control = VolumeControl::new(&problem)?;
    let start = reference(&mut control, stop)?;
    let mut last = start.clone();
    let mut pressures = Vec::new();
    for stretch in STRETCHES {
        last = inflate(&mut control, &last, stretch.powi(3) * start.volume, stop)?;
        pressures.push(last.pressure);
    }
    Ok(pressures)
}

/// The Mooney-Rivlin sphere, whose pressure always rises.
pub(super) fn mooney_rivlin(stop: &AtomicBool) -> Result<Vec<Case>, Unsolved> {
    let mut cases = Vec::new();
    for outer in [1.1, 1.5, 2.0] {
        let coarse = pressures(MESHES[0], outer, stop)?;
        let fine = pressures(MESHES[1], outer, stop)?;
        let expected = STRETCHES.map(|stretch| exact(&RUBBER, outer, stretch));
        let meshes = Refinement::new(coarse, fine.clone(), RATIO);
        let slope = meshes.slope(&expected);
        for ((stretch, fine), expected) in STRETCHES.into_iter().zip(fine).zip(expected) {
            let name =
                format!("Mooney-Rivlin sphere B/A = {outer}, stretch {stretch}: pressure, MPa");
            let case = Case::relative(name, fine, expected).slope(slope, SLOPE);
            cases.push(case.within(meshes.bound(SLOPE), SOURCE));
        }
    }
    Ok(cases)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_closed_form_gives_the_published_values() {
        for (outer, stretch, published) in [
            (1.1, 1.1, 0.025_922_956_378_498_78),
            (1.5, 2.0, 0.226_034_808_270_979_5),
            (2.0, 3.0, 0.400_927_290_386_803_8),
        ] {
            // The published integrals are quadratures, to ten digits at least.
            assert!((exact(&RUBBER, outer, stretch) / published - 1.0).abs() < 1e-10);
        }
        let limit = exact(&NEO_HOOKEAN, 2.0, 1.828_147_304_936_349_5);
        assert!((limit - 0.816_423_647_955_400_1).abs() < 1e-15);
    }
}
