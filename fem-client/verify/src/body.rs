//! Bodies of one block, and their equilibria.

use std::sync::atomic::AtomicBool;

use fem::cell::block::Block;
use fem::cell::element::Order;
use fem::cell::mesh::Mesh;
use fem::material::MooneyRivlin;
use fem::newton::iteration::Newton;
use fem::newton::path::{Stability, follow};
use fem::newton::volume_control::{Inflated, VolumeControl};
use fem::problem::{Loads, Problem, State};
use fem::solid::SolidModel;
use fem::tensor::{Tensor, Vector};

use crate::family::Unsolved;

/// The rubber of the reference tire, MPa.
pub(crate) const RUBBER: MooneyRivlin = MooneyRivlin {
    c10: 0.144,
    c01: 0.036,
};

/// Shear modulus of the rubber, MPa.
pub(crate) const SHEAR_MODULUS: f64 = 2.0 * (RUBBER.c10 + RUBBER.c01);

/// Rubber of a bulk compliance (1/MPa; 0 is incompressible).
pub(crate) fn rubber(material: MooneyRivlin, compliance: f64) -> SolidModel {
    SolidModel {
        material: Box::new(material),
        compliance,
    }
}

/// A body without load, held only across its plane when it is in plane strain.
pub(crate) fn free(mesh: Mesh, layout: Vec<[f64; 3]>, solid: SolidModel) -> Problem {
    let across = mesh.order.is_plane().then_some(0.0);
    Problem {
        supports: vec![[None, across, None]; mesh.nodes.len()],
        mesh,
        layout,
        solid,
        membranes: vec![],
        sheet: None,
        pressure: None,
        contact: None,
        dead_forces: vec![],
    }
}

/// [`free`], of one block.
pub(crate) fn free_block(block: Block, solid: SolidModel) -> Problem {
    free(block.mesh, block.layout, solid)
}

/// Holds each coordinate plane's nodes in the plane: a symmetry plane, or a sliding wall.
pub(crate) fn hold_coordinate_planes(problem: &mut Problem) {
    for (support, x) in problem.supports.iter_mut().zip(&problem.mesh.nodes) {
        for axis in 0..3 {
            if x[axis] == 0.0 {
                support[axis] = Some(0.0);
            }
        }
    }
}

/// Orders in plane strain with their names, and the rate at which quantities that are stationary at the solution, like
/// forces and pressures, converge: twice the degree.
pub(crate) const PLANE: [(Order, &str, f64); 2] = [
    (Order::PlaneLinear, "4-node", 2.0),
    (Order::PlaneQuadratic, "9-node", 4.0),
];

/// Orders in space with their names.
pub(crate) const SPACE: [(Order, &str); 2] =
    [(Order::Linear, "8-node"), (Order::Quadratic, "27-node")];

/// A quarter of a circle from the plane x = 0 (`s` = 0, below) to the plane z = 0, exact on both planes.
pub(crate) fn quarter_circle(s: f64, radius: f64) -> Vector {
    if s == 0.0 {
        return [0.0, 0.0, -radius];
    }
    if s == 1.0 {
        return [radius, 0.0, 0.0];
    }
    let (sine, cosine) = (std::f64::consts::FRAC_PI_2 * s).sin_cos();
    [radius * sine, 0.0, -radius * cosine]
}

/// Follows the loads from the reference state.
pub(crate) fn load<'p>(
    problem: &'p Problem,
    loads: &Loads,
    stop: &AtomicBool,
) -> Result<(Newton<'p>, State), Unsolved> {
    let mut newton = Newton::new(problem)?;
    let mut state = State::reference(problem);
    let start = Loads::default();
    load_on(&mut newton, &mut state, &start, loads, stop)?;
    Ok((newton, state))
}

/// Follows the loads from one equilibrium to the next.
pub(crate) fn load_on(
    newton: &mut Newton<'_>,
    state: &mut State,
    from: &Loads,
    to: &Loads,
    stop: &AtomicBool,
) -> Result<(), Unsolved> {
    let followed = follow(newton, state, from, to, Stability::Ignored, stop);
    followed.map(|_| ()).map_err(|failure| Unsolved::Load {
        reached: failure.reached,
        cause: failure.cause,
    })
}

/// Steps of the volume by which an inflation goes on, relative.
const VOLUME_STEP: f64 = 0.5;

/// Inflates to a multiple of the reference volume, in steps.
pub(crate) fn inflate(
    control: &mut VolumeControl<'_>,
    from: &Inflated,
    volume: f64,
    stop: &AtomicBool,
) -> Result<Inflated, Unsolved> {
    let mut inflated = from.clone();
    while inflated.volume != volume {
        let next = volume.min(inflated.volume * (1.0 + VOLUME_STEP));
        let solved = control.solve(&inflated, next, stop);
        inflated = solved.map_err(|failure| Unsolved::Volume {
            ratio: next / from.volume,
            cause: failure.cause,
        })?;
        // The volume is met to Newton's tolerance only.
        inflated.volume = next;
    }
    Ok(inflated)
}

/// Mean first Piola-Kirchhoff stress of a body in equilibrium: the sum of forces times reference positions, over the
/// volume (the virial of the supports).
pub(crate) fn mean_stress(
    newton: &mut Newton<'_>,
    mesh: &Mesh,
    volume: f64,
    state: &State,
    loads: &Loads,
) -> Tensor {
    let mut stress = [[0.0; 3]; 3];
    for (force, x) in newton.reactions(state, loads).iter().zip(&mesh.nodes) {
        for i in 0..3 {
            for j in 0..3 {
                stress[i][j] += force[i] * x[j] / volume;
            }
        }
    }
    stress
}
