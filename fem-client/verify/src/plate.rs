//! Bodies pressed by a flat rigid plate from below.

use std::sync::atomic::AtomicBool;

use fem::cell::mesh::Surface;
use fem::load::contact::{ContactSurface, Penalty};
use fem::load::obstacle::{HeightField, StationFunctions};
use fem::newton::iteration::Newton;
use fem::problem::{Loads, Problem, State};
use fem::tensor::Vector;

use crate::body::load_on;
use crate::family::Unsolved;

/// Contact pressures of 0.01 to 0.1 MPa then penetrate by less than a thousandth of the smallest depth.
const PENALTY: Penalty = Penalty {
    stiffness: 2000.0,
    ramp: 1e-6,
};

/// Width within which the plate may be for the other code's contact, beyond where it is, mm: that contact is smoothed, over 0.004 mm in a problem
/// whose settings are known, and seen to reach 0.0024 to 0.0043 mm here before the bound was set.
pub(crate) const CONTACT_WIDTH: f64 = 0.005;

/// Lets a surface of the problem, whose normals point outwards, touch the plate.
pub(crate) fn touch(problem: &mut Problem, surface: Surface) {
    problem.contact = Some(ContactSurface::new(&problem.mesh, surface, PENALTY));
}

/// A body on its way through the depths of a plate.
pub(crate) struct Pressing<'p> {
    problem: &'p Problem,
    newton: Newton<'p>,
    /// Present equilibrium.
    pub state: State,
    loads: Loads,
    lowest: f64,
}

impl<'p> Pressing<'p> {
    /// A body whose lowest point is at the height -`radius`, mm.
    pub fn new(problem: &'p Problem, radius: f64) -> Result<Self, Unsolved> {
        Ok(Self {
            problem,
            newton: Newton::new(problem)?,
            state: State::reference(problem),
            loads: Loads::default(),
            lowest: -radius,
        })
    }

    /// Presses by a depth, mm.
    pub fn to(&mut self, depth: f64, stop: &AtomicBool) -> Result<(), Unsolved> {
        let ground = HeightField {
            base: self.lowest,
            spacing: 1.0,
            functions: StationFunctions::Hat,
            depths: vec![depth],
            shift: [0.0; 2],
        };
        let loads = Loads {
            ground: Some(ground),
            ..Loads::default()
        };
        load_on(&mut self.newton, &mut self.state, &self.loads, &loads, stop)?;
        self.loads = loads;
        Ok(())
    }

    /// Force of the plate, N, and its second moment about x = 0, N mm^2, by the consistent nodal forces.
    pub fn moments(&self) -> (f64, f64) {
        let (mut force, mut moment) = (0.0, 0.0);
        let (Some(contact), Some(ground)) = (&self.problem.contact, &self.loads.ground) else {
            return (force, moment);
        };
        for (index, face) in contact.surface.iter().enumerate() {
            let mesh = &self.problem.mesh;
            let positions = face.iter().map(|&node| self.state.position(mesh, node));
            let positions: Vec<Vector> = positions.collect();
            let mut residual = vec![0.0; 3 * face.len()];
            contact.integrate(ground, index, &positions, &[], &mut residual, None);
            for (x, r) in positions.iter().zip(residual.chunks_exact(3)) {
                force -= r[2];
                moment -= r[2] * x[0] * x[0];
            }
        }
        (force, moment)
    }
}
