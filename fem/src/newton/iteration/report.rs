//! End of Newton's method, and its report.

use std::ops::AddAssign;
use std::time::Duration;

use crate::linear::symbolic::LinearError;
use crate::linear::system::Imbalance;

/// Criteria to stop.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NewtonSettings {
    /// Largest relative residual of an equilibrium.
    pub tolerance: f64,
    /// Iterations after which a load step is given up.
    pub max_iterations: usize,
    /// Relative residual above which the iteration is given up.
    pub divergence: f64,
    /// Smallest volume ratio that a step may reach at an integration point.
    pub min_volume_ratio: f64,
    /// Largest fraction of a path that one load step may take.
    pub largest_load_step: LargestStep,
    /// Smallest fraction of a path that is tried before it is given up.
    pub smallest_load_step: f64,
    /// Steps with a kept tangent that cost as much as a new one and the step with it; 0 makes a new one for every step.
    pub renewal_cost: f64,
    /// Earlier steps with a kept tangent from which the next one is corrected; 0 takes steps as they are.
    pub acceleration_depth: usize,
}

impl Default for NewtonSettings {
    fn default() -> Self {
        Self {
            tolerance: 1e-10,
            max_iterations: 50,
            divergence: 1e6,
            min_volume_ratio: 0.05,
            largest_load_step: LargestStep::Even(1.0),
            smallest_load_step: 1.0 / 256.0,
            renewal_cost: 8.0,
            acceleration_depth: 3,
        }
    }
}

/// Largest load step as a fraction of its path.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum LargestStep {
    /// Fraction that is the same everywhere.
    Even(f64),
    /// Difference of the fractions' roots: pressed on a plane, the contact of a round body grows by equal lengths.
    OfRoot(f64),
}

impl LargestStep {
    /// Returns the largest step from where a path has come to.
    pub(crate) fn at(self, reached: f64) -> f64 {
        match self {
            Self::Even(step) => step,
            Self::OfRoot(step) => step * (step + 2.0 * reached.sqrt()),
        }
    }
}

/// An equilibrium was found.
#[derive(Debug, Clone, PartialEq)]
pub struct Converged {
    /// Relative residual before the first and after each iteration.
    pub history: Vec<Imbalance>,
}

/// No equilibrium was found.
#[derive(Debug, Clone, PartialEq)]
pub struct NotConverged {
    /// Relative residual before the first and after each iteration.
    pub history: Vec<Imbalance>,
    /// Cause of the end.
    pub cause: Cause,
    /// Whether the last tangent on the way had negative pivots: a sign of lost stability.
    pub indefinite: bool,
}

/// Cause of an end without an equilibrium.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Cause {
    /// Too many iterations.
    Iterations,
    /// The residual grew beyond bounds or isn't a number.
    Diverged,
    /// Every fraction of the step turns an element inside out.
    Inverted,
    /// The tangent is singular.
    Singular(LinearError),
    /// An equilibrium was found, but it is unstable.
    Unstable,
    /// The caller asked to stop.
    Stopped,
}

/// Time spent, and iterations made.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Effort {
    /// Newton iterations: linear systems solved.
    pub iterations: usize,
    /// Tangents assembled and factorised.
    pub factorisations: usize,
    /// Time in assembly.
    pub assembly: Duration,
    /// Time in numeric factorisation.
    pub factorisation: Duration,
    /// Time in triangular solves and in the contact between them.
    pub substitution: Duration,
}

impl AddAssign for Effort {
    fn add_assign(&mut self, other: Self) {
        self.iterations += other.iterations;
        self.factorisations += other.factorisations;
        self.assembly += other.assembly;
        self.factorisation += other.factorisation;
        self.substitution += other.substitution;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn steps_grow_with_the_square_or_stay() {
        let ends = |largest: LargestStep| {
            let mut reached = 0.0;
            [1, 2, 3, 4].map(|_| {
                reached += largest.at(reached);
                reached
            })
        };
        assert_eq!(ends(LargestStep::Even(0.25)), [0.25, 0.5, 0.75, 1.0]);
        assert_eq!(
            ends(LargestStep::OfRoot(0.25)),
            [1.0, 4.0, 9.0, 16.0].map(|k| k / 16.0)
        );
    }
}
