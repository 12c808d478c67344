//! The first touch of a tire at rest: Hertz's contact of a body with two radii of curvature.
//!
//! With the radii R1 > R2 of the crown, the semi-axes a > b of the patch and its eccentricity e, e^2 = 1 - b^2 / a^2 (K. L.
//! Johnson, Contact Mechanics, 1985, section 4.2):
//!
//! > 1 / (2 R1) = p0 b (K - E) / (E* e^2 a^2),   1 / (2 R2) = p0 b (a^2 E / b^2 - K) / (E* e^2 a^2),   d = p0 b K / E*,   F = 2 pi a b p0 / 3
//!
//! with the complete elliptic integrals K(e), E(e) and E* = 4 mu of an incompressible body. They hold for patches much
//! smaller than the wall; beyond that the wall bends by F times its compliance, so that F falls short of Hertz's by a share
//! like d^(1/2). The mesh is graded to the patch from all sides, and the contact stiff enough to leave the rubber all of the
//! depth.

use std::f64::consts::PI;
use std::sync::atomic::AtomicBool;

use fem::cell::element::Order;
use fem::load::contact::Penalty;
use fem::newton::iteration::Newton;
use fem::problem::{Loads, State};

use super::draft::reference;
use super::trend::{Limit, Point};
use crate::body::{SHEAR_MODULUS, load_on};
use crate::family::Unsolved;
use crate::known_case::Case;
use crate::mesh_refinement::Refinement;
use fem_client::scene::Scene;
use tire::mesh::grid_lines::graded;
use tire::mesh::tire_grid::{Extent, TireGrid};
use tire::model::{TireModel, ground, shape};

/// Depths, mm, deepest last.
const DEPTHS: [f64; 3] = [1e-6, 1e-5, 1e-4];
/// Contact stiffness: the pressure at a depth penetrates by 0.2 % of it at the smallest depth, less at larger ones.
const PENALTY: Penalty = Penalty {
    stiffness: 3e5,
    ramp: 1e-10,
};
/// Largest relative residual: the rounding of a tire at rest is that much of forces of 1e-8 N.
const TOLERANCE: f64 = 1e-6;
/// Size of the bricks at the contact centre over the patch's semi-axes, on the coarse mesh.
const FIRST: f64 = 0.12;
/// Bricks along wheel, section and wall, coarse and fine.
const MESHES: [[usize; 3]; 2] = [[10, 10, 7], [14, 14, 9]];
/// Element size of the first mesh over that of the second.
const MESH_RATIO: f64 = 1.4;

/// Complete elliptic integrals K and E of an eccentricity, by the arithmetic-geometric mean.
fn elliptic(eccentricity: f64) -> [f64; 2] {
    let (mut a, mut b) = (1.0, (1.0 - eccentricity * eccentricity).sqrt());
    let (mut sum, mut weight) = (0.5 * eccentricity * eccentricity, 0.5);
    // Digits double in each step.
    for _ in 0..8 {
        let c = 0.5 * (a - b);
        (a, b) = (0.5 * (a + b), (a * b).sqrt());
        weight *= 2.0;
        sum += weight * c * c;
    }
    let k = PI / (2.0 * a);
    [k, k * (1.0 - sum)]
}

/// An elliptic patch.
struct Patch {
    /// Semi-axes along the larger and the smaller radius, mm.
    axes: [f64; 2],
    /// Force, N.
    force: f64,
}

/// The patch at a depth below a body with these radii, the first the larger.
fn patch(depth: f64, [large, small]: [f64; 2], modulus: f64) -> Patch {
    let curvatures = |e: f64| {
        let [k, integral] = elliptic(e);
        (integral / (1.0 - e * e) - k) / (k - integral)
    };
    let (mut low, mut high) = (0.0, 1.0);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if curvatures(middle) < large / small {
            low = middle;
        } else {
            high = middle;
        }
    }
    let e = 0.5 * (low + high);
    let [k, integral] = elliptic(e);
    let a = (2.0 * large * depth * (k - integral) / (k * e * e)).sqrt();
    let b = a * (1.0 - e * e).sqrt();
    let pressure = depth * modulus / (b * k);
    Patch {
        axes: [a, b],
        force: 2.0 * PI * a * b * pressure / 3.0,
    }
}

/// Hertz's force, N.
pub(super) fn hertz_force(depth: f64, radii: [f64; 2], modulus: f64) -> f64 {
    patch(depth, radii, modulus).force
}

/// The tire at rest, without carcass.
fn scene() -> Scene {
    let mut scene = reference();
    scene.carcass = None;
    scene.pressure.internal_mpa = 0.0;
    scene
}

fn radii(scene: &Scene) -> [f64; 2] {
    [
        scene.geometry.outer_radius_mm,
        scene.geometry.section_radius_mm,
    ]
}

/// Grid lines from `start` to `end` in geometric series, the first brick about of this size.
fn lines(start: f64, end: f64, n: usize, first: f64) -> Vec<f64> {
    let length = (end - start).abs() / first;
    let (mut low, mut high) = (0.0, 60.0);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        let ratio = f64::exp(middle / (n as f64 - 1.0));
        let sum: f64 = (0..n).map(|k| ratio.powi(k as i32)).sum();
        if sum < length {
            low = middle;
        } else {
            high = middle;
        }
    }
    graded(start, end, n, low.exp())
}

/// Meshes a tire graded to the first touch from all sides.
fn model(
    scene: &Scene,
    depth: f64,
    [around, across, through]: [usize; 3],
    first: f64,
) -> TireModel {
    let [large, small] = radii(scene);
    let patch = patch(depth, radii(scene), 4.0 * SHEAR_MODULUS);
    let [a, b] = patch.axes.map(|axis| first * axis);
    let shape = shape(scene);
    let mut rho = lines(shape.outer, shape.inner, through, b);
    rho.reverse();
    let grid = TireGrid {
        order: Order::Quadratic,
        extent: Extent::Quarter,
        shape,
        is_closed: false,
        theta: lines(0.0, PI, around, a / large),
        phi: lines(0.0, shape.bead_angle, across, b / small),
        rho,
    };
    let mut model = TireModel::on_grid(scene, grid);
    if let Some(contact) = &mut model.problem.contact {
        contact.penalty = PENALTY;
    }
    model
}

/// Force at a depth over Hertz's.
fn force(depth: f64, mesh: [usize; 3], first: f64, stop: &AtomicBool) -> Result<f64, Unsolved> {
    let mut scene = scene();
    scene.ground.depths_mm.fill(depth);
    let model = model(&scene, depth, mesh, first);
    let field = ground(&scene.ground, scene.geometry.outer_radius_mm);
    let loads = Loads {
        ground: Some(field.clone()),
        ..Loads::default()
    };
    let mut state = State::reference(&model.problem);
    let mut newton = Newton::for_contact(&model.problem, &state, &loads)?;
    newton.settings.tolerance = TOLERANCE;
    load_on(&mut newton, &mut state, &Loads::default(), &loads, stop)?;
    let contact = model.problem.contact.as_ref();
    let position = |node| state.position(&model.problem.mesh, node);
    let force = contact.map_or(f64::NAN, |c| c.resultant(&field, position).load);
    Ok(model.multiplicity() * force / hertz_force(depth, radii(&scene), 4.0 * SHEAR_MODULUS))
}

/// Force over Hertz's, on its way to 1, and the power of the depth.
pub(super) fn cases(stop: &AtomicBool) -> Result<Vec<Case>, Unsolved> {
    let (mut coarse, mut fine) = (Vec::new(), Vec::new());
    for depth in DEPTHS {
        coarse.push(force(depth, MESHES[0], FIRST, stop)?);
        fine.push(force(depth, MESHES[1], FIRST / MESH_RATIO, stop)?);
    }
    let mesh = Refinement::new(coarse, fine.clone(), MESH_RATIO).bound(2.0);
    let law = Limit {
        value: 1.0,
        noise: mesh,
        order: 0.5,
        source: "Hertz, for patches much smaller than the wall; tolerance: two meshes, and the share like d^(1/2) that the wall bends",
    };
    let point = |(depth, value): (&f64, &f64)| Point {
        label: format!("first touch, depth {depth:e} mm"),
        parameter: 1.0 / depth,
        value: *value,
    };
    let points: Vec<Point> = DEPTHS.iter().zip(&fine).rev().map(point).collect();
    let mut cases = law.cases("force over Hertz's", &points);
    cases.reverse();
    let exponent = 1.5 + (fine[1] / fine[0]).log10();
    let case = Case::absolute(
        "first touch, 1e-6 to 1e-5 mm: power of the depth in the force",
        exponent,
        1.5,
    );
    let bending = ((1.0 - fine[1]).abs() + 2.0 * mesh) * std::f64::consts::LOG10_E;
    cases.push(case.within(
        bending,
        "Hertz: 3/2; tolerance: what both forces may be off",
    ));
    Ok(cases)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_patch_of_equal_radii_is_round_and_its_force_is_a_ball_s() {
        // Nearly equal radii: a round patch has no direction.
        let [radius, depth, modulus] = [10.0, 1e-3, 1.44f64];
        let found = patch(depth, [radius * (1.0 + 1e-6), radius], modulus);
        let ball = 4.0 / 3.0 * modulus * radius.sqrt() * depth.powf(1.5);
        // The difference of the radii, and of K - E near e = 0, which loses half of the digits.
        assert!(
            (found.force / ball - 1.0).abs() < 1e-5,
            "{} for {ball}",
            found.force
        );
        assert!((found.axes[0] / (radius * depth).sqrt() - 1.0).abs() < 1e-5);
    }

    #[test]
    fn the_elliptic_integrals_have_their_known_values() {
        // K and E at e^2 = 1/2: Gauss's lemniscate, to 16 digits (Abramowitz and Stegun, table 17.1).
        let [k, e] = elliptic(0.5f64.sqrt());
        assert!((k - 1.854_074_677_301_372).abs() < 4e-15, "{k}");
        assert!((e - 1.350_643_881_047_676).abs() < 4e-15, "{e}");
    }
}
