//! The least value of a smooth function within bounds, by L-BFGS.
//!
//! A bounded unknown is a logistic function of a free one, x = low + (high - low) / (1 + exp(-z)), so that no step leaves the bounds. Where
//! the least value lies on a bound, the search ends near it.

use std::cell::RefCell;

use argmin::core::{CostFunction, Error, Executor, Gradient};
use argmin::solver::linesearch::MoreThuenteLineSearch;
use argmin::solver::quasinewton::LBFGS;

/// Pairs of steps that L-BFGS remembers.
const MEMORY: usize = 10;
/// Free unknowns stay within so much of 0: beyond, the logistic function no longer tells them apart.
const FARTHEST: f64 = 30.0;

/// Limits at which a search ends.
#[derive(Debug, Clone, Copy)]
pub struct Patience {
    /// Most iterations.
    pub iterations: usize,
    /// A gradient this short, of the free unknowns, is none.
    pub gradient: f64,
    /// A value that changes by less is the least.
    pub change: f64,
}

/// A function's value and gradient; None where there is none, which ends the search.
pub trait Smooth {
    /// Returns value and gradient at a point within the bounds.
    fn at(&self, point: &[f64]) -> Option<(f64, Vec<f64>)>;
}

impl<F: Fn(&[f64]) -> Option<(f64, Vec<f64>)>> Smooth for F {
    fn at(&self, point: &[f64]) -> Option<(f64, Vec<f64>)> {
        self(point)
    }
}

/// The best point that was seen.
#[derive(Debug, Clone, PartialEq)]
pub struct Least {
    /// The point.
    pub point: Vec<f64>,
    /// The value there.
    pub value: f64,
}

/// Searches from a start within bounds; without bounds (None) the unknowns are free. None where the function has no value at the start.
pub fn least(
    function: &dyn Smooth,
    bounds: Option<&[(f64, f64)]>,
    start: &[f64],
    patience: Patience,
) -> Option<Least> {
    let problem = Problem {
        function,
        bounds,
        seen: RefCell::new(None),
        last: RefCell::new(None),
    };
    let free = problem.free(start);
    let line_search = MoreThuenteLineSearch::new();
    let solver = LBFGS::new(line_search, MEMORY)
        .with_tolerance_grad(patience.gradient)
        .and_then(|solver| solver.with_tolerance_cost(patience.change));
    if let Ok(solver) = solver {
        let searched = Executor::new(&problem, solver)
            .configure(|state| state.param(free).max_iters(patience.iterations as u64))
            .run();
        // However it ended, the best point that was seen is the answer.
        drop(searched);
    }
    problem.seen.into_inner()
}

/// A free point, the value there, and its gradient by the free unknowns.
struct Looked {
    free: Vec<f64>,
    value: f64,
    gradient: Vec<f64>,
}

struct Problem<'f> {
    function: &'f dyn Smooth,
    bounds: Option<&'f [(f64, f64)]>,
    seen: RefCell<Option<Least>>,
    /// The free point that was looked at last, with what was found: value and gradient are asked for one after the other.
    last: RefCell<Option<Looked>>,
}

impl Problem<'_> {
    fn free(&self, point: &[f64]) -> Vec<f64> {
        let Some(bounds) = self.bounds else {
            return point.to_vec();
        };
        let logit = |(x, (low, high)): (&f64, &(f64, f64))| {
            let share = ((x - low) / (high - low)).clamp(1e-9, 1.0 - 1e-9);
            (share / (1.0 - share)).ln()
        };
        point.iter().zip(bounds).map(logit).collect()
    }

    /// The point, and how much it moves with each free unknown.
    fn bounded(&self, free: &[f64]) -> (Vec<f64>, Vec<f64>) {
        let Some(bounds) = self.bounds else {
            return (free.to_vec(), vec![1.0; free.len()]);
        };
        let logistic = |(z, (low, high)): (&f64, &(f64, f64))| {
            let share = 1.0 / (1.0 + (-z.clamp(-FARTHEST, FARTHEST)).exp());
            (
                low + (high - low) * share,
                (high - low) * share * (1.0 - share),
            )
        };
        free.iter().zip(bounds).map(logistic).unzip()
    }

    fn look(&self, free: &[f64]) -> Result<(f64, Vec<f64>), Error> {
        if let Some(last) = &*self.last.borrow()
            && last.free == free
        {
            return Ok((last.value, last.gradient.clone()));
        }
        let (point, moves) = self.bounded(free);
        let (value, gradient) = self
            .function
            .at(&point)
            .filter(|(value, gradient)| value.is_finite() && gradient.iter().all(|g| g.is_finite()))
            .ok_or_else(|| Error::msg("no value here"))?;
        let gradient: Vec<f64> = gradient.iter().zip(moves).map(|(g, m)| g * m).collect();
        let mut seen = self.seen.borrow_mut();
        if seen.as_ref().is_none_or(|best| value < best.value) {
            *seen = Some(Least { point, value });
        }
        *self.last.borrow_mut() = Some(Looked {
            free: free.to_vec(),
            value,
            gradient: gradient.clone(),
        });
        Ok((value, gradient))
    }
}

impl CostFunction for &Problem<'_> {
    type Param = Vec<f64>;
    type Output = f64;

    fn cost(&self, free: &Vec<f64>) -> Result<f64, Error> {
        self.look(free).map(|(value, _)| value)
    }
}

impl Gradient for &Problem<'_> {
    type Param = Vec<f64>;
    type Gradient = Vec<f64>;

    fn gradient(&self, free: &Vec<f64>) -> Result<Vec<f64>, Error> {
        self.look(free).map(|(_, gradient)| gradient)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const PATIENCE: Patience = Patience {
        iterations: 500,
        gradient: 1e-10,
        change: 0.0,
    };

    /// Rosenbrock's valley.
    fn valley(x: &[f64]) -> Option<(f64, Vec<f64>)> {
        let (a, b) = (1.0 - x[0], x[1] - x[0] * x[0]);
        Some((
            a * a + 100.0 * b * b,
            vec![-2.0 * a - 400.0 * b * x[0], 200.0 * b],
        ))
    }

    #[test]
    fn the_valley_has_its_least_value_at_one_one() {
        for bounds in [None, Some([(-3.0, 3.0), (-3.0, 3.0)])] {
            let bounds = bounds.as_ref().map(|bounds| &bounds[..]);
            let found = least(&valley, bounds, &[-1.2, 1.0], PATIENCE).expect("a value");
            for x in found.point {
                assert!((x - 1.0).abs() < 1e-7, "{x}");
            }
        }
    }

    #[test]
    fn a_bound_holds() {
        let bounds = [(-3.0, 0.5), (-3.0, 3.0)];
        let found = least(&valley, Some(&bounds), &[-1.2, 1.0], PATIENCE).expect("a value");
        // On x = 0.5 the least value is 0.25, at y = 0.25.
        assert!(found.point[0] < 0.5);
        assert!((found.value - 0.25).abs() < 1e-6, "{}", found.value);
    }

    #[test]
    fn a_function_without_values_has_no_least() {
        assert_eq!(least(&|_: &[f64]| None, None, &[0.0], PATIENCE), None);
        // It ends where values end, with the best of them.
        let half = |x: &[f64]| (x[0] > 1.0).then(|| (x[0] * x[0], vec![2.0 * x[0]]));
        let found = least(&half, None, &[3.0], PATIENCE).expect("a value");
        assert!(found.value <= 9.0);
    }
}
