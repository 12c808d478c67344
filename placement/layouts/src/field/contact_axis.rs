//! A quantity alone that differs, at some steps of what makes it.

use crate::field::hermite::{Shares, summed};

/// Most contacts that a quantity's polynomial goes through, the usual one among them.
pub(super) const MOST_NODES: usize = 5;
/// Halvings by which a value is looked up: 1e-12 of the reach.
const HALVINGS: usize = 40;

/// Weights of an axis' nodes in a contact.
pub(super) type Weights = [f64; MOST_NODES];

/// Force along three axes, N, and moments about them, N mm.
pub type Wrench = [f64; 6];

/// Change of a contact beside the usual one.
#[derive(Debug, Clone, PartialEq)]
pub struct Change {
    /// Change of the force along the ground's normal, N.
    pub force_n: f64,
    /// Changes of what the ground does in the wheel's frame: of the force along the wheel, along the axle and upwards, N, and of the moments about these axes, N mm.
    pub wrench: Wrench,
    /// Changes of the signals by kind of film: a sample each degree from -180.
    pub signals: Vec<Vec<f64>>,
}

impl Change {
    /// The opposite change.
    #[must_use]
    pub fn opposite(&self) -> Self {
        let negative = |samples: &Vec<f64>| samples.iter().map(|sample| -sample).collect();
        Self {
            force_n: -self.force_n,
            wrench: self.wrench.map(|load| -load),
            signals: self.signals.iter().map(negative).collect(),
        }
    }
}

/// Contact at which one quantity differs from the usual one.
#[derive(Debug, Clone, PartialEq)]
pub struct AxisNode {
    /// Step of what makes the quantity, from -1 to 1; 0 of the usual contact.
    pub step: f64,
    /// Value of the quantity.
    pub value: f64,
    /// Change that it makes.
    pub change: Change,
}

/// Quantity alone that differs, at every depth where it was stepped.
#[derive(Debug, Clone, PartialEq)]
pub struct ContactAxis {
    /// Number of its law: several axes have one where a quantity is several independent ones.
    pub law: usize,
    /// Contacts by depth, at the same steps of each, increasing, the usual one in the middle.
    pub nodes: Vec<Vec<AxisNode>>,
}

impl ContactAxis {
    /// Whether it has an odd number of steps up to five, and a node for each at so many depths.
    pub(super) fn is_whole(&self, depths: usize) -> bool {
        let steps = |nodes: &[AxisNode]| nodes.iter().map(|node| node.step).collect::<Vec<_>>();
        let Some(first) = self.nodes.first().map(|nodes| steps(nodes)) else {
            return false;
        };
        let are_known = first.len() % 2 == 1 && first.len() <= MOST_NODES;
        let has_all = |nodes: &Vec<AxisNode>| steps(nodes) == first;
        are_known && self.nodes.len() == depths && self.nodes.iter().all(has_all)
    }

    /// Count of its steps.
    pub(super) fn count(&self) -> usize {
        self.nodes[0].len()
    }

    /// Values of its quantity at its nodes, between depths by these shares.
    pub(super) fn values(&self, shares: &Shares) -> Weights {
        let mut values = [0.0; MOST_NODES];
        for (node, value) in values.iter_mut().enumerate().take(self.count()) {
            *value = summed(shares, |depth| self.nodes[depth][node].value);
        }
        values
    }

    /// Values of its quantity at steps of -1 and 1 at each depth.
    pub(super) fn reached(&self) -> impl Iterator<Item = [f64; 2]> + '_ {
        let ends = [-1.0, 1.0].map(|step| self.polynomials(step));
        let at = |nodes: &[AxisNode], weights: &Weights| -> f64 {
            let nodes = nodes.iter().zip(weights);
            nodes.map(|(node, weight)| node.value * weight).sum()
        };
        let depths = self.nodes.iter();
        depths.map(move |nodes| ends.each_ref().map(|weights| at(nodes, weights)))
    }

    /// Lagrange's polynomials through its steps, at a step.
    pub(super) fn polynomials(&self, step: f64) -> Weights {
        let mut weights = [0.0; MOST_NODES];
        let nodes = &self.nodes[0];
        for (k, (weight, own)) in weights.iter_mut().zip(nodes).enumerate() {
            let others = nodes.iter().enumerate().filter(|(other, _)| *other != k);
            let factors = others.map(|(_, other)| (step - other.step) / (own.step - other.step));
            *weight = factors.product();
        }
        weights
    }

    /// Step from -1 to 1 at which the polynomial through values at its nodes, which increase or decrease, has a value; 0 at the usual one.
    pub(super) fn step_of(&self, values: &Weights, value: f64) -> f64 {
        let count = self.count();
        if value == values[count / 2] {
            return 0.0;
        }
        let rises = values[count - 1] > values[0];
        let (mut low, mut high) = (-1.0, 1.0);
        for _ in 0..HALVINGS {
            let middle = 0.5 * (low + high);
            if (dot(values, &self.polynomials(middle)) < value) == rises {
                low = middle;
            } else {
                high = middle;
            }
        }
        0.5 * (low + high)
    }
}

fn dot(a: &Weights, b: &Weights) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}
