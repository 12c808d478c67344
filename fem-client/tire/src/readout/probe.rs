//! Stretches around a point of the inner surface, and the error of what is read off them.
//!
//! The error of a quantity is the root mean square, over the faces around the point, of the difference between its recovered
//! and its raw value (O. C. Zienkiewicz and J. Z. Zhu, Int. J. Numer. Meth. Engng 33 (1992) 1331). It estimates the raw value's error; the
//! recovered one is more accurate, so that it is on the safe side on quadratic elements. An error that comes from far away,
//! such as the stiffness of coarse linear elements, changes both alike and isn't seen: `tests/strain_error.rs` measures it.

use fem::cell::mesh::SurfacePoint;
use fem::surface::chart::Recovery;
use fem::surface::stretch::Stretch;
use fem_client::solver::direction::Direction;

/// Stretches of the equilibrium and of the inflated state.
#[derive(Debug, Clone, Copy)]
pub struct States {
    /// Equilibrium.
    pub current: Stretch,
    /// Inflated state.
    pub inflated: Stretch,
}

impl States {
    /// Returns the signal of a film glued on in the inflated state along a material line at this angle (rad) to s1.
    pub fn signal(&self, angle: f64) -> f64 {
        self.current.along(angle) / self.inflated.along(angle) - 1.0
    }

    /// The signal in a direction of the surface: x is along s1, y along s2.
    pub(crate) fn signal_in(&self, direction: Direction) -> f64 {
        match direction {
            Direction::X => self.current.s1 / self.inflated.s1 - 1.0,
            Direction::Y => self.current.s2 / self.inflated.s2 - 1.0,
        }
    }
}

/// A value with its estimated discretisation error.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Estimate {
    /// Recovered value.
    pub value: f64,
    /// Error of the value, absolute.
    pub error: f64,
}

/// Stretches at a point and around it.
#[derive(Debug)]
pub(crate) struct Probe {
    here: States,
    /// Recovered states, raw states and weight of each point around.
    around: Vec<(States, States, f64)>,
}

impl Probe {
    /// Reads the stretches.
    pub fn new(current: &Recovery<'_>, inflated: &Recovery<'_>, point: SurfacePoint) -> Self {
        let recovered = |point| States {
            current: current.at(point),
            inflated: inflated.at(point),
        };
        let raw = |point| States {
            current: current.raw_at(point),
            inflated: inflated.raw_at(point),
        };
        let surroundings = current.surroundings(point).into_iter();
        Self {
            here: recovered(point),
            around: surroundings
                .map(|(point, weight)| (recovered(point), raw(point), weight))
                .collect(),
        }
    }

    /// A quantity at the point.
    pub fn estimate(&self, quantity: impl Fn(&States) -> f64) -> Estimate {
        let (mut squares, mut weights) = (0.0, 0.0);
        for (recovered, raw, weight) in &self.around {
            squares += weight * (quantity(recovered) - quantity(raw)).powi(2);
            weights += weight;
        }
        Estimate {
            value: quantity(&self.here),
            error: (squares / weights).sqrt(),
        }
    }
}
