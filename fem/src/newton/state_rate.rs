//! Derivative of an equilibrium by a parameter of its problem.
//!
//! Of r(u; p) = 0 follows K u' = -dr/dp with the tangent K at u. Instead of dr/dp the residual is differenced as a whole:
//! u' is where
//!
//! > g(v) = [r(u + h v; p + h) - r(u - h v; p - h)] / 2h
//!
//! vanishes, up to terms of second order in h. K is g's own derivative, so that Newton's method on g ends in a few steps, each a substitution. Contact
//! enters with the points that touch at u, so that where one is about to open or close the derivative is that of its side.

use std::sync::Arc;

use crate::linear::assembly::Assembler;
use crate::linear::setup::SetupError;
use crate::linear::system::Residuals;
use crate::newton::iteration::{Cause, Newton};
use crate::problem::{Loads, Problem, State};
use crate::tensor::Vector;

/// Last step, relative to the derivative, up to which it is found. On tires a step leaves 1e-5 of what it corrects, and the rounding of the difference 1e-8 at most of
/// the derivative where the half step is a millionth of the number.
const ACCURACY: f64 = 1e-7;
/// Last step that moves the sides by no more than rounding does, relative to their displacements: all that is known where a parameter hardly matters.
const ROUND_OFF: f64 = 1e-14;
/// Steps within which it has to be: three do where no contact point opens or closes between the two sides.
const MOST_STEPS: usize = 8;

/// Problem and loads with the parameter changed.
#[derive(Debug, Clone, Copy)]
pub struct Beside<'p> {
    /// Problem on a mesh with the same elements and supports.
    pub problem: &'p Problem,
    /// Loads there.
    pub loads: &'p Loads,
}

/// Derivative of a state by a parameter: unknowns per unit of it.
#[derive(Debug, Clone, PartialEq)]
pub struct StateRate {
    /// Derivatives of the displacements, mm.
    pub displacement: Vec<Vector>,
    /// Derivatives of the pressures, MPa.
    pub pressure: Vec<f64>,
    /// Derivative of the ground's height, mm, where it presses with a force.
    pub rise: f64,
}

/// No derivative was found.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum NoRate {
    /// The two sides aren't the same mesh.
    #[error("its mesh has other elements on the two sides of the value")]
    OtherMesh,
    /// Setting a side up failed.
    #[error(transparent)]
    Setup(#[from] SetupError),
    /// The tangent at the state is singular.
    #[error("the tangent of the equilibrium is singular")]
    Singular,
    /// The iteration went on changing.
    #[error("contact opens or closes right at the value")]
    Kink,
}

impl StateRate {
    /// Rate of a state that doesn't change.
    pub fn zero(state: &State) -> Self {
        Self {
            displacement: vec![[0.0; 3]; state.displacement.len()],
            pressure: vec![0.0; state.pressure.len()],
            rise: 0.0,
        }
    }

    /// The state where the parameter has changed by `change`, to first order.
    #[must_use]
    pub fn moved(&self, state: &State, change: f64) -> State {
        let mut moved = state.clone();
        moved.add(change, &self.displacement, &self.pressure);
        moved.rise += change * self.rise;
        moved
    }
}

impl Newton<'_> {
    /// Derivative of an equilibrium by a parameter, from the problem with the parameter a half step less and more. Without friction: with it the
    /// equilibrium depends on its path.
    ///
    /// # Errors
    /// [`NoRate`].
    pub fn state_rate(
        &mut self,
        state: &State,
        loads: &Loads,
        beside: [Beside<'_>; 2],
        half_step: f64,
    ) -> Result<StateRate, NoRate> {
        if !self.has_tangent() {
            let tangent = self.inertia_at(state, loads);
            tangent.map_err(|_: Cause| NoRate::Singular)?;
        }
        let mut sides = Vec::new();
        for beside in beside {
            sides.push(Side::new(self, beside)?);
        }
        let mut rate = StateRate::zero(state);
        let round_off = ROUND_OFF * norm(state.displacement.as_flattened());
        for _ in 0..MOST_STEPS {
            let lack = self.difference(state, &rate, &mut sides, half_step);
            let change = self.linear_step(state, loads, lack);
            let change = change.map_err(|_: Cause| NoRate::Singular)?;
            let size = norm(change.displacement.as_flattened());
            rate.add(&change);
            let found = ACCURACY * norm(rate.displacement.as_flattened());
            if size <= found || half_step * size <= round_off {
                return Ok(rate);
            }
        }
        Err(NoRate::Kink)
    }

    /// Sets the residuals to g at a rate; returns by how much the ground's force grows too little.
    fn difference(
        &mut self,
        state: &State,
        rate: &StateRate,
        sides: &mut [Side<'_>],
        half_step: f64,
    ) -> f64 {
        let target = self.residuals_mut();
        target.clear();
        target.volumes.fill(0.0);
        let mut lack = 0.0;
        for (side, sign) in sides.iter_mut().zip([-1.0, 1.0]) {
            let asked = side.loads.ground_force.unwrap_or(0.0);
            let found = side.residuals(&rate.moved(state, sign * half_step));
            let weight = sign / (2.0 * half_step);
            add(&mut target.forces, weight, &found.forces);
            add(&mut target.volumes, weight, &found.volumes);
            lack += weight * (asked - found.ground_force);
        }
        lack
    }
}

impl StateRate {
    fn add(&mut self, other: &Self) {
        add(
            self.displacement.as_flattened_mut(),
            1.0,
            other.displacement.as_flattened(),
        );
        add(&mut self.pressure, 1.0, &other.pressure);
        self.rise += other.rise;
    }
}

/// Side of the difference.
struct Side<'p> {
    loads: &'p Loads,
    assembler: Assembler<'p>,
    residuals: Residuals,
    served: Vec<bool>,
}

impl<'p> Side<'p> {
    fn new(newton: &Newton<'_>, beside: Beside<'p>) -> Result<Self, NoRate> {
        let own = newton.setup();
        let (problem, middle) = (beside.problem, newton.problem());
        if !problem.has_elements_of(middle) {
            return Err(NoRate::OtherMesh);
        }
        let setup = match problem.mesh.nodes == middle.mesh.nodes {
            true => own.clone(),
            false => Arc::new(own.reshaped(problem)?),
        };
        let assembler = Assembler::new(problem, setup);
        Ok(Self {
            loads: beside.loads,
            residuals: assembler.residuals(),
            assembler,
            served: own.border_faces.clone(),
        })
    }

    fn residuals(&mut self, state: &State) -> &Residuals {
        self.assembler
            .residual(state, self.loads, &self.served, &mut self.residuals);
        &self.residuals
    }
}

fn add(target: &mut [f64], weight: f64, values: &[f64]) {
    for (target, value) in target.iter_mut().zip(values) {
        *target += weight * value;
    }
}

fn norm(values: &[f64]) -> f64 {
    values.iter().map(|value| value * value).sum::<f64>().sqrt()
}
