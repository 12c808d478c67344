//! Bodies pressed by a flat rigid plate from below.

use std::sync::atomic::AtomicBool;

use fem::cell::mesh::Surface;
use fem::load::contact::{ContactResultant, ContactSurface, Penalty};
use fem::load::ground_shape::Profile;
use fem::load::obstacle::{GroundAxes, HeightField, StationFunctions};
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
pub(super) const CONTACT_WIDTH: f64 = 0.005;

/// Lets a surface of the problem, whose normals point outwards, touch the plate.
pub(super) fn touch(problem: &mut Problem, surface: Surface) {
    problem.contact = Some(ContactSurface::new(&problem.mesh, surface, PENALTY));
}

/// A body on its way through the depths of a plate.
pub(super) struct Pressing<'p> {
    problem: &'p Problem,
    newton: Newton<'p>,
    /// Present equilibrium.
    pub state: State,
    loads: Loads,
    axes: GroundAxes,
    lowest: f64,
    profile: Profile,
}

impl<'p> Pressing<'p> {
    /// A body whose lowest point is at the height -`radius`, mm.
    pub fn new(problem: &'p Problem, radius: f64) -> Result<Self, Unsolved> {
        Self::leaning(problem, radius, GroundAxes::LEVEL)
    }

    /// A body that touches a plate with these axes at a distance of `radius` from the origin, mm.
    pub fn leaning(problem: &'p Problem, radius: f64, axes: GroundAxes) -> Result<Self, Unsolved> {
        Ok(Self {
            problem,
            newton: Newton::new(problem)?,
            state: State::reference(problem),
            loads: Loads::default(),
            axes,
            lowest: -radius,
            profile: Profile::Plane,
        })
    }

    /// Puts something on the plate.
    pub fn on(self, profile: Profile) -> Self {
        Self { profile, ..self }
    }

    /// Presses by a depth, mm.
    pub fn to(&mut self, depth: f64, stop: &AtomicBool) -> Result<(), Unsolved> {
        let ground = HeightField {
            axes: self.axes,
            base: self.lowest,
            spacing: 1.0,
            functions: StationFunctions::Hat,
            depths: vec![depth],
            shift: [0.0; 2],
            profile: self.profile.clone(),
        };
        let loads = Loads {
            ground: Some(ground),
            ..Loads::default()
        };
        load_on(&mut self.newton, &mut self.state, &self.loads, &loads, stop)?;
        self.loads = loads;
        Ok(())
    }

    /// Force and moment of the plate about the origin.
    pub fn resultant(&self) -> ContactResultant {
        let (Some(contact), Some(ground)) = (&self.problem.contact, &self.loads.ground) else {
            return ContactResultant::default();
        };
        contact.resultant(ground, |node| self.state.position(&self.problem.mesh, node))
    }

    /// Force of the plate along its normal, N, and its second moment about 0 of its coordinate x (`axis` 0) or y (1), N mm^2, by the consistent nodal forces.
    pub fn moments(&self, axis: usize) -> (f64, f64) {
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
            for (x, r) in positions.iter().zip(residual.as_chunks::<3>().0) {
                let [x, r] = [*x, *r].map(|vector| self.axes.coordinates(vector));
                force -= r[2];
                moment -= r[2] * x[axis] * x[axis];
            }
        }
        (force, moment)
    }
}
