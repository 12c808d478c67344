//! Homogeneous deformations, which any element must reproduce exactly: on a distorted mesh only Newton's tolerance is left.

use std::sync::atomic::AtomicBool;

use fem::cell::block::Block;
use fem::cell::element::Order;
use fem::cell::mesh::Surface;
use fem::load::pressure::PressureSurface;
use fem::newton::iteration::Newton;
use fem::problem::{Loads, Problem, State};
use fem::tensor::{Tensor, Vector, multiply, norm, transpose};

use crate::body::{
    RUBBER, SHEAR_MODULUS, SPACE, free_block, hold_coordinate_planes, load, mean_stress, rubber,
};
use crate::family::Unsolved;
use crate::known_case::Case;

/// Tolerance of stresses: Newton ends at 1e-10 of the forces that meet at the nodes, some ten times what a face carries here.
const STRESS_TOLERANCE: f64 = 1e-8;
/// Tolerance of displacements of a body of size 1, at that end of Newton.
const DISPLACEMENT_TOLERANCE: f64 = 1e-9;
/// Forces of a body at rest, over shear modulus times area: sums of some hundred terms of order one, rounded.
const ROUND_OFF: f64 = 1e-13;

/// Held displacements alone.
pub(crate) const HELD: Loads = Loads {
    pressure: 0.0,
    ground: None,
    ground_force: None,
    support_factor: 1.0,
    traction_factor: 0.0,
};

/// Bricks on [0, 1]^3 whose inner nodes are moved about.
fn distorted(order: Order) -> Block {
    Block::new(order, [2, 2, 2], |s| {
        let bubble: f64 = s.iter().map(|c| 4.0 * c * (1.0 - c)).product();
        [
            s[0] + 0.12 * bubble * (1.0 + s[1]),
            s[1] - 0.10 * bubble * (2.0 - s[2]),
            s[2] + 0.15 * bubble * s[0],
        ]
    })
}

/// Mean first Piola-Kirchhoff stress of the distorted cube with these supports.
fn stress(
    order: Order,
    hold: impl Fn(&mut Problem),
    stop: &AtomicBool,
) -> Result<Tensor, Unsolved> {
    let mut problem = free_block(distorted(order), rubber(RUBBER, 0.0));
    hold(&mut problem);
    let (mut newton, state) = load(&problem, &HELD, stop)?;
    Ok(mean_stress(&mut newton, &problem.mesh, 1.0, &state, &HELD))
}

/// Sliding walls on the coordinate planes, and prescribed stretches of some axes.
fn hold_stretches(problem: &mut Problem, stretches: [Option<f64>; 3]) {
    hold_coordinate_planes(problem);
    for (support, x) in problem.supports.iter_mut().zip(&problem.mesh.nodes) {
        for (axis, stretch) in stretches.iter().enumerate() {
            if let (Some(stretch), true) = (stretch, x[axis] == 1.0) {
                support[axis] = Some(stretch - 1.0);
            }
        }
    }
}

/// Prescribes x = F X on the whole boundary.
fn hold_boundary(problem: &mut Problem, f: &Tensor) {
    for (support, x) in problem.supports.iter_mut().zip(&problem.mesh.nodes) {
        if x.iter().any(|&c| c == 0.0 || c == 1.0) {
            *support = moved(f, x).map(Some);
        }
    }
}

/// Displacement of a point by x = F X.
pub(crate) fn moved(f: &Tensor, x: &Vector) -> Vector {
    [0, 1, 2].map(|i| (0..3).map(|j| f[i][j] * x[j]).sum::<f64>() - x[i])
}

/// A homogeneous stretch.
struct Tension {
    name: &'static str,
    /// Smallest published stretch.
    from: f64,
    /// Stretches that are prescribed at a stretch l.
    prescribed: fn(f64) -> [Option<f64>; 3],
    /// Nominal stress, MPa.
    exact: fn(f64) -> f64,
    source: &'static str,
}

const TENSIONS: [Tension; 3] = [
    Tension {
        name: "uniaxial",
        from: 0.5,
        prescribed: |l| [Some(l), None, None],
        exact: |l| 2.0 * (RUBBER.c10 + RUBBER.c01 / l) * (l - l.powi(-2)),
        source: "exact: 2 (C10 + C01 / l) (l - l^-2)",
    },
    Tension {
        name: "equibiaxial",
        from: 0.8,
        prescribed: |l| [Some(l), Some(l), None],
        exact: |l| 2.0 * (RUBBER.c10 + RUBBER.c01 * l * l) * (l - l.powi(-5)),
        source: "exact: 2 (C10 + C01 l^2) (l - l^-5)",
    },
    Tension {
        name: "planar",
        from: 0.8,
        prescribed: |l| [Some(l), Some(1.0), None],
        exact: |l| 2.0 * (RUBBER.c10 + RUBBER.c01) * (l - l.powi(-3)),
        source: "exact: 2 (C10 + C01) (l - l^-3)",
    },
];

/// Uniaxial, equibiaxial and planar tension, and simple shear.
pub(super) fn stretches(stop: &AtomicBool) -> Result<Vec<Case>, Unsolved> {
    let mut cases = Vec::new();
    for test in &TENSIONS {
        let stretches = [0.5, 0.8, 1.1, 1.5, 2.0, 3.0].into_iter();
        for l in stretches.filter(|l| *l >= test.from) {
            for (order, element) in SPACE {
                let stress = stress(order, |p| hold_stretches(p, (test.prescribed)(l)), stop)?;
                let name = format!("{} stretch {l}, {element}: nominal stress, MPa", test.name);
                let case = Case::relative(name, stress[0][0], (test.exact)(l));
                cases.push(case.within(STRESS_TOLERANCE, test.source));
            }
        }
    }
    for shear in [0.1, 0.5, 1.0, 2.0] {
        for (order, element) in SPACE {
            cases.extend(simple_shear(order, element, shear, stop)?);
        }
    }
    Ok(cases)
}

fn simple_shear(
    order: Order,
    element: &str,
    shear: f64,
    stop: &AtomicBool,
) -> Result<[Case; 3], Unsolved> {
    let f = [[1.0, shear, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let stress = stress(order, |problem| hold_boundary(problem, &f), stop)?;
    // Cauchy stress; the differences are free of the pressure, which nothing determines when all of the boundary is held.
    let s = multiply(&stress, &transpose(&f));
    let square = shear * shear;
    Ok([
        ("s12", s[0][1], SHEAR_MODULUS * shear, "exact: mu g"),
        (
            "s11 - s33",
            s[0][0] - s[2][2],
            2.0 * RUBBER.c10 * square,
            "exact: 2 C10 g^2",
        ),
        (
            "s22 - s33",
            s[1][1] - s[2][2],
            -2.0 * RUBBER.c01 * square,
            "exact: -2 C01 g^2",
        ),
    ]
    .map(|(component, computed, expected, source)| {
        let name = format!("simple shear {shear}, {element}: {component}, MPa");
        Case::absolute(name, computed, expected).within(SHEAR_MODULUS * STRESS_TOLERANCE, source)
    }))
}

/// Bulk compression, patch test and rigid rotation.
pub(super) fn others(stop: &AtomicBool) -> Result<Vec<Case>, Unsolved> {
    let mut cases = Vec::new();
    for (order, element) in SPACE {
        for kappa in [360.0, 3.6] {
            let name = format!("free cube, kappa {kappa} MPa, under 0.2 MPa, {element}: stretch");
            let (computed, p) = (pressed_cube(order, kappa, stop)?, 0.2);
            let case = Case::relative(name, computed, (1.0f64 - p / kappa).cbrt());
            cases.push(case.within(DISPLACEMENT_TOLERANCE, "exact: (1 - p / kappa)^(1/3)"));
        }
        for (name, compliance, f) in patches() {
            let name = format!("patch test, {name}, {element}: largest error of a displacement");
            let case = Case::absolute(name, patch_error(order, compliance, &f, stop)?, 0.0);
            cases.push(case.within(DISPLACEMENT_TOLERANCE, "exact: x = F X"));
        }
        let name = format!("rigid rotation by 1 rad, {element}: largest reaction / mu, mm^2");
        let case = Case::absolute(name, rotated_force(order)?, 0.0);
        cases.push(case.within(ROUND_OFF, "exact: objectivity"));
    }
    Ok(cases)
}

/// Stretch of a cube under live pressure on all sides.
fn pressed_cube(order: Order, kappa: f64, stop: &AtomicBool) -> Result<f64, Unsolved> {
    let block = distorted(order);
    // The coordinate planes are symmetry planes: the others carry the pressure.
    let faces = (0..3).flat_map(|axis| block.side(axis, true).flipped().faces);
    let surface = Surface {
        order,
        faces: faces.collect(),
    };
    let mut problem = free_block(block, rubber(RUBBER, 1.0 / kappa));
    problem.pressure = Some(PressureSurface::new(surface));
    hold_coordinate_planes(&mut problem);
    let loads = Loads {
        pressure: 0.2,
        ..Loads::default()
    };
    let (_, state) = load(&problem, &loads, stop)?;
    let corner = problem.mesh.nodes.iter().zip(&state.displacement);
    let far = corner
        .filter(|(x, _)| **x == [1.0; 3])
        .map(|(_, u)| 1.0 + u[0]);
    Ok(far.fold(f64::NAN, f64::min))
}

/// Volume-preserving for the incompressible solid, dilating for the compressible ones.
fn patches() -> [(&'static str, f64, Tensor); 2] {
    let isochoric = [[1.2, 0.1, 0.0], [0.0, 1.0 / 1.2, 0.05], [0.0, 0.0, 1.0]];
    let dilating = [[1.2, 0.1, 0.0], [-0.05, 0.9, 0.05], [0.02, 0.0, 1.1]];
    [
        ("incompressible", 0.0, isochoric),
        ("kappa 360 MPa", 1.0 / 360.0, dilating),
    ]
}

fn patch_error(
    order: Order,
    compliance: f64,
    f: &Tensor,
    stop: &AtomicBool,
) -> Result<f64, Unsolved> {
    let mut problem = free_block(distorted(order), rubber(RUBBER, compliance));
    hold_boundary(&mut problem, f);
    let (_, state) = load(&problem, &HELD, stop)?;
    let nodes = problem.mesh.nodes.iter().zip(&state.displacement);
    let errors = nodes.map(|(x, u)| {
        let exact = moved(f, x);
        norm(&[0, 1, 2].map(|i| u[i] - exact[i]))
    });
    Ok(errors.fold(0.0, f64::max))
}

fn rotated_force(order: Order) -> Result<f64, Unsolved> {
    let mut problem = free_block(distorted(order), rubber(RUBBER, 0.0));
    let (sine, cosine) = 1.0f64.sin_cos();
    let about_z = [[cosine, -sine, 0.0], [sine, cosine, 0.0], [0.0, 0.0, 1.0]];
    let about_x = [[1.0, 0.0, 0.0], [0.0, cosine, -sine], [0.0, sine, cosine]];
    let rotation = multiply(&about_x, &about_z);
    hold_boundary(&mut problem, &rotation);
    let mut state = State::reference(&problem);
    for (u, x) in state.displacement.iter_mut().zip(&problem.mesh.nodes) {
        *u = moved(&rotation, x);
    }
    let mut newton = Newton::new(&problem)?;
    let forces = newton.reactions(&state, &HELD);
    Ok(forces.iter().map(norm).fold(0.0, f64::max) / SHEAR_MODULUS)
}
