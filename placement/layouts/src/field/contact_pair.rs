//! Changes that two quantities make at once, beside those that each makes alone.
//!
//! Of the second quantity it is linear. Of the first it is the parabola through the usual contact and a step to either side: a camber moves the contact to one side,
//! whichever way the wheel leans. Where one side alone is solved, the other has the opposite change, and the parabola is a line.

use crate::field::contact_axis::Change;

/// Two quantities at once, at every depth where they were stepped.
#[derive(Debug, Clone, PartialEq)]
pub struct ContactPair {
    /// Numbers of their axes.
    pub axes: [usize; 2],
    /// Steps that were solved: of the first to either side, each with this one of the second.
    pub steps: [f64; 2],
    /// Changes by depth, the first quantity below and above the usual one.
    pub nodes: Vec<[Change; 2]>,
}

impl ContactPair {
    /// Shares of its nodes at a step of the first quantity.
    pub(super) fn of_first(&self, step: f64) -> [f64; 2] {
        let [end, _] = self.steps;
        [step - end, step + end].map(|other| step * other / (2.0 * end * end))
    }

    /// Share of its nodes at a step of the second quantity.
    pub(super) fn of_second(&self, step: f64) -> f64 {
        let [_, end] = self.steps;
        step / end
    }

    /// Weights of its nodes at both steps.
    pub(super) fn weights(&self, [first, second]: [f64; 2]) -> [f64; 2] {
        let of_second = self.of_second(second);
        self.of_first(first).map(|share| of_second * share)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_product_is_met_and_nothing_where_one_is_as_usual() {
        let pair = ContactPair {
            axes: [0, 1],
            steps: [0.7, 0.8],
            nodes: Vec::new(),
        };
        // Odd in the first, and even.
        for of_first in [|x: f64| x, |x: f64| x * x] {
            let change = |[x, y]: [f64; 2]| of_first(x) * y;
            let nodes = [change([-0.7, 0.8]), change([0.7, 0.8])];
            for steps in [[0.3, -0.9], [-1.0, 0.5], [0.0, 1.0], [1.0, 0.0]] {
                let weights = pair.weights(steps);
                let found: f64 = weights.iter().zip(nodes).map(|(w, node)| w * node).sum();
                assert!((found - change(steps)).abs() < 1e-15, "{steps:?} {found}");
            }
        }
    }
}
