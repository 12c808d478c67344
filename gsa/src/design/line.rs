//! A line of a design.

use crate::law::polynomials::Polynomials;
use crate::law::rule::GaussRule;

/// The runs along one input.
#[derive(Debug, Clone, PartialEq)]
pub struct Line {
    pub(super) rule: GaussRule,
    pub(super) polynomials: Polynomials,
    pub(super) ordinals: Vec<usize>,
}

impl Line {
    /// The input's Gauss rule.
    pub fn rule(&self) -> &GaussRule {
        &self.rule
    }

    /// Returns for each node of the rule its number among the points of the design.
    pub fn ordinals(&self) -> &[usize] {
        &self.ordinals
    }

    /// Orthonormal polynomials of the input's law, as many as the rule has nodes.
    pub(crate) fn polynomials(&self) -> &Polynomials {
        &self.polynomials
    }

    /// The coordinate in which the rule is exact for polynomials.
    pub(crate) fn coordinate(&self, x: f64) -> f64 {
        self.polynomials.coordinate(x)
    }
}
