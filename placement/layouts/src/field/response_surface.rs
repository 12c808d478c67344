//! Changes of films' signals with what a contact is beside its angle and depth: a response surface from few solves.
//!
//! A signal is that of the usual contact, and its changes with each quantity alone: s(c) = s(0) + sum over q of (s(c_q) - s(0)), the cut expansion of first order
//! (H. Rabitz and O. F. Alis, 1999); where it matters most, with those of second order of some pairs. Each term is the polynomial through contacts that are solved at some steps of what makes it (a camber, a shift of the
//! ground), and cubic over the depth. A law may be of something else than is stepped, as a traction is of the shift: its value is then looked up.

use documents::layouts::contact_laws::ContactLaw;

use crate::field::contact_axis::{Change, ContactAxis, Weights, Wrench};
use crate::field::contact_pair::ContactPair;
use crate::field::hermite::{DEGREES, Nodes, Shares, summed};
use crate::field::told_loads::TOLD_LOADS;

/// Response surface of some kinds of film over contacts.
#[derive(Debug, Clone, PartialEq)]
pub struct ResponseSurface {
    usual: DepthSignals,
    /// Depths at which quantities were stepped, mm.
    depths: Nodes,
    laws: Vec<ContactLaw>,
    axes: Vec<ContactAxis>,
    pairs: Vec<ContactPair>,
}

/// Signals and forces over the depth, of contacts that are the usual ones or of all.
#[derive(Debug, Clone, PartialEq)]
pub struct DepthSignals {
    /// Solved depths, mm.
    pub depths: Nodes,
    /// Vertical force at each, N.
    pub forces_n: Vec<f64>,
    /// Signals by kind and depth: a sample each degree from -180.
    pub signals: Vec<Vec<Vec<f64>>>,
}

/// Quantities of a contact that are drawn by their laws, where there are any; the others are as usual.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Drawn {
    /// Quantities, all of them.
    All,
    /// Quantity of this law alone.
    Only(usize),
    /// No quantity: every contact is the usual one.
    Nothing,
}

impl Drawn {
    /// Whether the quantity of a law is drawn.
    pub(super) fn has(self, law: usize) -> bool {
        match self {
            Self::All => true,
            Self::Only(only) => only == law,
            Self::Nothing => false,
        }
    }
}

/// Place of a quantity.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Given {
    /// Value of it.
    Value(f64),
    /// Step of what makes it, from -1 to 1.
    Step(f64),
}

/// Contact of the surface, as weights of what was solved.
#[derive(Debug, Clone)]
pub struct Contact<'s> {
    /// Shares of the usual contact's depths.
    usual: Shares,
    /// Changes that make it, each with its weight.
    changes: Vec<(f64, &'s Change)>,
}

impl ResponseSurface {
    /// Makes a surface beside the usual contact, of axes that were solved at these depths.
    ///
    /// # Panics
    /// If an axis has no odd number of steps up to five, and a node for each at each depth.
    pub fn new(
        usual: DepthSignals,
        depths: Nodes,
        laws: Vec<ContactLaw>,
        axes: Vec<ContactAxis>,
    ) -> Self {
        let count = depths.places().len();
        let are_whole = axes.iter().all(|axis| axis.is_whole(count));
        assert!(are_whole, "nodes around the usual contact");
        Self {
            usual,
            depths,
            laws,
            axes,
            pairs: Vec::new(),
        }
    }

    /// The surface with what pairs of its axes change at once.
    ///
    /// # Panics
    /// If a pair has no nodes for each depth.
    #[must_use]
    pub fn with_pairs(self, pairs: Vec<ContactPair>) -> Self {
        let count = self.depths.places().len();
        let are_whole = pairs.iter().all(|pair| pair.nodes.len() == count);
        assert!(are_whole, "nodes at each depth");
        Self { pairs, ..self }
    }

    /// Depths at which quantities were stepped, mm.
    pub fn depths(&self) -> &Nodes {
        &self.depths
    }

    /// The laws.
    pub fn laws(&self) -> &[ContactLaw] {
        &self.laws
    }

    /// Numbers of the axes' laws.
    pub fn laws_of_axes(&self) -> impl Iterator<Item = usize> + '_ {
        self.axes.iter().map(|axis| axis.law)
    }

    /// Numbers of the laws of quantities with one axis alone: a contact has one value of each.
    pub fn told(&self) -> Vec<usize> {
        let axes_of = |law: &usize| self.laws_of_axes().filter(|own| own == law).count();
        (0..self.laws.len())
            .filter(|law| axes_of(law) == 1)
            .collect()
    }

    /// Values of these quantities of a contact, where they are given as such, then its loads by [`TOLD_LOADS`].
    pub(crate) fn told_of(&self, given: &[Given], contact: &Contact<'_>) -> Vec<f64> {
        let of_law = |law: usize| {
            let axis = self.laws_of_axes().position(|own| own == law)?;
            match given[axis] {
                Given::Value(value) => Some(value),
                Given::Step(_) => None,
            }
        };
        let wrench = self.changed_wrench(contact);
        let loads = TOLD_LOADS.iter().map(|load| load.of(&wrench));
        let values = self.told().into_iter().filter_map(of_law);
        values.chain(loads).collect()
    }

    /// Number of kinds of film.
    pub(super) fn kinds(&self) -> usize {
        self.usual.signals.len()
    }

    /// Signals and forces of the usual contact.
    pub(super) fn usual(&self) -> &DepthSignals {
        &self.usual
    }

    /// The axes.
    pub(super) fn axes(&self) -> &[ContactAxis] {
        &self.axes
    }

    /// Step of an axis at a depth, mm, that gives a value of its quantity.
    pub fn step(&self, depth_mm: f64, axis: usize, value: f64) -> f64 {
        let [shares, _] = self.depths.shares(depth_mm);
        let axis = &self.axes[axis];
        axis.step_of(&axis.values(&shares), value)
    }

    /// Pairs of axes that change more at once than each alone.
    pub(super) fn pairs(&self) -> &[ContactPair] {
        &self.pairs
    }

    /// Changes of an axis' nodes with these weights, each times its share of a depth, mm.
    pub(super) fn changes_of_axis(
        &self,
        depth_mm: f64,
        axis: usize,
        weights: &Weights,
    ) -> Vec<(f64, &Change)> {
        let [shares, _] = self.depths.shares(depth_mm);
        let nodes = |depth: usize| self.axes[axis].nodes[depth].iter().map(|node| &node.change);
        weighted(&shares, weights, nodes)
    }

    /// Changes of a pair's nodes with these weights.
    pub(super) fn changes_of_pair(
        &self,
        depth_mm: f64,
        pair: usize,
        weights: &[f64; 2],
    ) -> Vec<(f64, &Change)> {
        let [shares, _] = self.depths.shares(depth_mm);
        weighted(&shares, weights, |depth| {
            self.pairs[pair].nodes[depth].iter()
        })
    }

    /// The surface of some kinds alone, in their order.
    pub fn of_kinds(&self, kinds: &[usize]) -> Self {
        let mut some = self.clone();
        let nodes = some.axes.iter_mut().flat_map(|axis| &mut axis.nodes);
        let of_axes = nodes.flatten().map(|node| &mut node.change);
        let of_pairs = some.pairs.iter_mut().flat_map(|pair| &mut pair.nodes);
        for change in of_axes.chain(of_pairs.flatten()) {
            let signal = |&kind: &usize| change.signals[kind].clone();
            change.signals = kinds.iter().map(signal).collect();
        }
        let signals = &mut some.usual.signals;
        *signals = kinds
            .iter()
            .map(|&kind| self.usual.signals[kind].clone())
            .collect();
        some
    }

    /// The contact at a depth, mm, with these places of the axes' quantities, each taken into what was solved.
    pub fn contact(&self, depth_mm: f64, given: &[Given]) -> Contact<'_> {
        let [shares, _] = self.depths.shares(depth_mm);
        let step = |(axis, given): (&ContactAxis, &Given)| match given {
            Given::Value(value) => axis.step_of(&axis.values(&shares), *value),
            Given::Step(step) => *step,
        };
        let steps: Vec<f64> = self.axes.iter().zip(given).map(step).collect();
        let mut changes = Vec::new();
        for (axis, step) in steps.iter().enumerate().filter(|(_, step)| **step != 0.0) {
            let weights = self.axes[axis].polynomials(*step);
            changes.extend(self.changes_of_axis(depth_mm, axis, &weights));
        }
        for (number, pair) in self.pairs.iter().enumerate() {
            let both = pair.axes.map(|axis| steps[axis]);
            if !both.contains(&0.0) {
                changes.extend(self.changes_of_pair(depth_mm, number, &pair.weights(both)));
            }
        }
        let [usual, _] = self.usual.depths.shares(depth_mm);
        Contact { usual, changes }
    }

    /// Change beside the usual contact of what the ground does in the wheel's frame, N and N mm.
    pub fn changed_wrench(&self, contact: &Contact<'_>) -> Wrench {
        summed_wrench(&contact.changes)
    }

    /// Change beside the usual contact of a kind's signal: a sample each degree from -180.
    pub fn changed_signal(&self, contact: &Contact<'_>, kind: usize) -> Vec<f64> {
        summed_signals(&contact.changes, kind)
    }

    /// Vertical force of a contact, N.
    pub fn force_n(&self, contact: &Contact<'_>) -> f64 {
        let usual = summed(&contact.usual, |node| self.usual.forces_n[node]);
        let changes = contact.changes.iter();
        usual
            + changes
                .map(|(weight, change)| weight * change.force_n)
                .sum::<f64>()
    }

    /// Signal of a kind of film with a contact: a sample each degree from -180.
    pub fn signal(&self, contact: &Contact<'_>, kind: usize) -> Vec<f64> {
        let mut signal = self.changed_signal(contact, kind);
        for (node, share) in contact.usual.each() {
            add(&mut signal, &self.usual.signals[kind][node], share);
        }
        signal
    }

    /// Values of an axis' quantity at steps of -1 and 1 at each depth.
    pub fn reached(&self, axis: usize) -> impl Iterator<Item = [f64; 2]> + '_ {
        self.axes[axis].reached()
    }

    /// Values of the axes' quantities at shares of their laws, from 0 to 1, of those laws that are drawn; the others are as usual.
    pub fn drawn(&self, shares: &[f64], drawn: Drawn) -> Vec<Given> {
        let value = |(axis, share): (&ContactAxis, &f64)| {
            let law = &self.laws[axis.law];
            Given::Value(match drawn.has(axis.law) {
                true => law.value_at(*share),
                false => law.quantity.usual(),
            })
        };
        self.axes.iter().zip(shares).map(value).collect()
    }
}

/// Changes with their weights: those of nodes at each depth, times the depth's share.
fn weighted<'c, I: Iterator<Item = &'c Change>>(
    shares: &Shares,
    weights: &[f64],
    nodes: impl Fn(usize) -> I,
) -> Vec<(f64, &'c Change)> {
    let at_depth = |(depth, share)| {
        let nodes = nodes(depth).zip(weights);
        nodes.map(move |(change, weight)| (share * weight, change))
    };
    shares.each().flat_map(at_depth).collect()
}

/// Sum of the changes of one kind's signal.
pub(super) fn summed_signals(changes: &[(f64, &Change)], kind: usize) -> Vec<f64> {
    let mut sums = vec![0.0; DEGREES];
    for (weight, change) in changes {
        add(&mut sums, &change.signals[kind], *weight);
    }
    sums
}

/// Sum of the changes of what the ground does.
pub(super) fn summed_wrench(changes: &[(f64, &Change)]) -> Wrench {
    let mut sums = Wrench::default();
    for (weight, change) in changes {
        add(&mut sums, &change.wrench, *weight);
    }
    sums
}

fn add(sums: &mut [f64], samples: &[f64], weight: f64) {
    for (sum, sample) in sums.iter_mut().zip(samples) {
        *sum += weight * sample;
    }
}

#[cfg(test)]
pub(crate) mod tests {
    use documents::layouts::contact_laws::ContactQuantity;
    use gsa::law::distribution::Distribution;

    use super::*;
    use crate::field::contact_axis::AxisNode;

    /// A share by which signals are larger for each unit of a quantity.
    pub(crate) const BY_PRESSURE: f64 = -0.8;
    /// Millimetres below the axle at which the ground pulls.
    pub(crate) const LEVER_MM: f64 = 49.0;
    /// Newtons for each unit of pressure and mm.
    const STIFFER_N: f64 = 10.0;

    fn law(quantity: ContactQuantity, low: f64, high: f64) -> ContactLaw {
        ContactLaw {
            quantity,
            law: Distribution::uniform(low, high).expect("a law"),
        }
    }

    /// A bell of 14 degrees, and its slope, times the depth.
    pub(crate) fn bells(depth: f64) -> Vec<Vec<f64>> {
        let bell = |u: i32| depth * (-0.5 * (f64::from(u) / 14.0).powi(2)).exp();
        let slope = |u: i32| -f64::from(u) / 14.0 * bell(u);
        vec![
            (-180..180).map(bell).collect(),
            (-180..180).map(slope).collect(),
        ]
    }

    /// Signals that a pressure makes smaller, and a traction adds the square of its shift to, as it does to the pull; it saturates with the shift.
    pub(crate) fn surface() -> ResponseSurface {
        let depths = vec![0.5, 1.0, 1.5];
        let usual = DepthSignals {
            depths: Nodes::new(depths.clone()),
            forces_n: depths.iter().map(|depth| 13.0 * depth).collect(),
            signals: [0, 1]
                .map(|kind| {
                    depths
                        .iter()
                        .map(|depth| bells(*depth).swap_remove(kind))
                        .collect()
                })
                .to_vec(),
        };
        let pressure = |depth: &f64| {
            let node = |value: f64| AxisNode {
                step: 10.0 * (value - 1.0),
                value,
                change: Change {
                    force_n: STIFFER_N * (value - 1.0) * depth,
                    wrench: [0.0; 6],
                    signals: scaled(&bells(*depth), BY_PRESSURE * (value - 1.0)),
                },
            };
            [0.9, 1.0, 1.1].map(node).to_vec()
        };
        let traction = |depth: &f64| {
            let node = |step: f64| AxisNode {
                step,
                value: traction_of(step),
                change: Change {
                    force_n: 0.0,
                    wrench: [
                        step * step * depth,
                        0.0,
                        0.0,
                        0.0,
                        -LEVER_MM * step * step * depth,
                        0.0,
                    ],
                    signals: vec![vec![step * step * depth; DEGREES]; 2],
                },
            };
            [-1.0, -0.5, 0.0, 0.5, 1.0].map(node).to_vec()
        };
        let axis = |law, nodes: Vec<Vec<AxisNode>>| ContactAxis { law, nodes };
        let axes = vec![
            axis(0, depths.iter().map(pressure).collect()),
            axis(1, depths.iter().map(traction).collect()),
        ];
        let laws = vec![
            law(ContactQuantity::Pressure, 0.9, 1.1),
            law(ContactQuantity::Traction, -0.2, 0.2),
        ];
        ResponseSurface::new(usual, Nodes::new(depths), laws, axes)
    }

    fn traction_of(step: f64) -> f64 {
        0.3 * step - 0.05 * step.powi(3)
    }

    fn scaled(signals: &[Vec<f64>], factor: f64) -> Vec<Vec<f64>> {
        let scaled = |samples: &Vec<f64>| samples.iter().map(|sample| factor * sample).collect();
        signals.iter().map(scaled).collect()
    }

    #[test]
    fn quantities_add_up_and_values_are_looked_up() {
        let surface = surface();
        let usual = bells(1.0);
        let given = [Given::Value(1.05), Given::Value(traction_of(0.7))];
        let contact = surface.contact(1.0, &given);
        let expected =
            |kind: usize, degree: usize| usual[kind][degree] * (1.0 + BY_PRESSURE * 0.05) + 0.49;
        for kind in 0..2 {
            for (degree, found) in surface.signal(&contact, kind).iter().enumerate() {
                assert!(
                    (found - expected(kind, degree)).abs() < 1e-9,
                    "{kind} {degree}"
                );
            }
        }
        assert!((surface.force_n(&contact) - 13.0 - 0.05 * STIFFER_N).abs() < 1e-9);
        let usual_one = surface.contact(1.0, &surface.drawn(&[0.3, 0.9], Drawn::Nothing));
        assert_eq!(surface.signal(&usual_one, 0), usual[0]);
        let reached: Vec<[f64; 2]> = surface.reached(1).collect();
        assert_eq!(reached, [[traction_of(-1.0), traction_of(1.0)]; 3]);
        // What lies beyond the nodes is taken to them.
        let beyond = surface.contact(1.0, &[Given::Value(1.3), Given::Value(0.0)]);
        let end = surface.contact(1.0, &[Given::Step(1.0), Given::Step(0.0)]);
        assert!((surface.force_n(&beyond) - surface.force_n(&end)).abs() < 1e-9);
    }
}
