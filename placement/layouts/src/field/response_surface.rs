//! Changes of films' signals with what a contact is beside its angle and depth: a response surface from few solves.
//!
//! A signal is that of the usual contact, and its changes with each quantity alone: s(c) = s(0) + sum over q of (s(c_q) - s(0)), the cut expansion of first order
//! (H. Rabitz and O. F. Alis, 1999). Each term is the polynomial through contacts that are solved at even steps of what makes it (a camber, a shift of the
//! ground), and cubic over the depth. A law may be of something else than is stepped, as a traction is of the shift: its value is then looked up.

use documents::layouts::contact_laws::ContactLaw;
use gsa::design::sobol::Sobol;

use crate::field::hermite::{DEGREES, Nodes, Shares, summed};

/// Most contacts that a quantity's polynomial goes through, the usual one among them.
pub(super) const MOST_NODES: usize = 5;
/// Halvings by which a value is looked up: 1e-12 of the reach.
const HALVINGS: usize = 40;
/// Contacts by which means and variances are summed.
const CONTACTS: u32 = 64;

/// Response surface of some kinds of film over contacts.
#[derive(Debug, Clone, PartialEq)]
pub struct ResponseSurface {
    usual: DepthSignals,
    /// Depths at which quantities were stepped, mm.
    depths: Nodes,
    laws: Vec<ContactLaw>,
    axes: Vec<ContactAxis>,
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

/// Quantity alone that differs, at every depth where it was stepped.
#[derive(Debug, Clone, PartialEq)]
pub struct ContactAxis {
    /// Number of its law: several axes have one where a quantity is several independent ones.
    pub law: usize,
    /// Contacts by depth, at even steps of what makes the quantity, the usual one in the middle.
    pub nodes: Vec<Vec<AxisNode>>,
}

/// Contact at which one quantity differs from the usual one.
#[derive(Debug, Clone, PartialEq)]
pub struct AxisNode {
    /// Value of the quantity.
    pub value: f64,
    /// Change of the vertical force, N.
    pub force_n: f64,
    /// Changes of the signals by kind of film: a sample each degree from -180.
    pub signals: Vec<Vec<f64>>,
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

/// Weights of an axis' nodes in a contact.
pub(super) type Weights = [f64; MOST_NODES];

/// Contact of the surface, as weights of what was solved.
#[derive(Debug, Clone)]
pub struct Contact {
    /// Shares of the usual contact's depths.
    usual: Shares,
    /// Shares of the depths at which quantities were stepped.
    shares: Shares,
    /// Numbers of the axes that differ, and weights of their nodes.
    axes: Vec<(usize, Weights)>,
}

impl ResponseSurface {
    /// Makes a surface beside the usual contact, of axes that were solved at these depths.
    ///
    /// # Panics
    /// If an axis has no odd number of nodes up to five at each depth.
    pub fn new(
        usual: DepthSignals,
        depths: Nodes,
        laws: Vec<ContactLaw>,
        axes: Vec<ContactAxis>,
    ) -> Self {
        let count = depths.places().len();
        let is_odd = |nodes: &Vec<AxisNode>| nodes.len() % 2 == 1 && nodes.len() <= MOST_NODES;
        let is_whole =
            |axis: &ContactAxis| axis.nodes.len() == count && axis.nodes.iter().all(is_odd);
        assert!(axes.iter().all(is_whole), "nodes around the usual contact");
        Self {
            usual,
            depths,
            laws,
            axes,
        }
    }

    /// The laws.
    pub fn laws(&self) -> &[ContactLaw] {
        &self.laws
    }

    /// Numbers of the axes' laws.
    pub(crate) fn laws_of_axes(&self) -> impl Iterator<Item = usize> + '_ {
        self.axes.iter().map(|axis| axis.law)
    }

    /// Numbers of the laws of quantities with one axis alone: a contact has one value of each.
    pub fn told(&self) -> Vec<usize> {
        let axes_of = |law: &usize| self.laws_of_axes().filter(|own| own == law).count();
        (0..self.laws.len())
            .filter(|law| axes_of(law) == 1)
            .collect()
    }

    /// Values of these quantities of a contact, where they are given as such.
    pub(crate) fn told_of(&self, given: &[Given]) -> Vec<f64> {
        let of_law = |law: usize| {
            let axis = self.laws_of_axes().position(|own| own == law)?;
            match given[axis] {
                Given::Value(value) => Some(value),
                Given::Step(_) => None,
            }
        };
        self.told().into_iter().filter_map(of_law).collect()
    }

    /// Number of kinds of film.
    pub(super) fn kinds(&self) -> usize {
        self.usual.signals.len()
    }

    /// Number of an axis' nodes.
    pub(super) fn nodes_of(&self, axis: usize) -> usize {
        self.axes[axis].nodes[0].len()
    }

    /// Step of an axis at a depth, mm, that gives a value of its quantity.
    pub(super) fn step(&self, depth_mm: f64, axis: usize, value: f64) -> f64 {
        let [shares, _] = self.depths.shares(depth_mm);
        let axis = &self.axes[axis];
        axis.step_of(&axis.values(&shares), value)
    }

    /// Changes of the signals by kind, and of the force (N), at a depth, mm, of an axis' nodes with these weights.
    pub(super) fn change(
        &self,
        depth_mm: f64,
        axis: usize,
        weights: &Weights,
    ) -> (Vec<Vec<f64>>, f64) {
        let [shares, _] = self.depths.shares(depth_mm);
        let mut signals = vec![vec![0.0; DEGREES]; self.kinds()];
        let mut force_n = 0.0;
        for (depth, share) in shares.each() {
            for (node, weight) in self.axes[axis].nodes[depth].iter().zip(weights) {
                force_n += share * weight * node.force_n;
                for (sums, samples) in signals.iter_mut().zip(&node.signals) {
                    for (sum, sample) in sums.iter_mut().zip(samples) {
                        *sum += share * weight * sample;
                    }
                }
            }
        }
        (signals, force_n)
    }

    /// The surface of some kinds alone, in their order.
    pub(super) fn of_kinds(&self, kinds: &[usize]) -> Self {
        let mut some = self.clone();
        let nodes = some.axes.iter_mut().flat_map(|axis| &mut axis.nodes);
        for node in nodes.flatten() {
            let signal = |&kind: &usize| node.signals[kind].clone();
            node.signals = kinds.iter().map(signal).collect();
        }
        let signals = &mut some.usual.signals;
        *signals = kinds
            .iter()
            .map(|&kind| self.usual.signals[kind].clone())
            .collect();
        some
    }

    /// The contact at a depth, mm, with these places of the axes' quantities, each taken into what was solved.
    pub fn contact(&self, depth_mm: f64, given: &[Given]) -> Contact {
        let [shares, _] = self.depths.shares(depth_mm);
        let weighted = |(number, (axis, given)): (usize, (&ContactAxis, &Given))| {
            let step = match given {
                Given::Value(value) => axis.step_of(&axis.values(&shares), *value),
                Given::Step(step) => *step,
            };
            (step != 0.0).then(|| (number, axis.polynomials(step)))
        };
        let [usual, _] = self.usual.depths.shares(depth_mm);
        let axes = self.axes.iter().zip(given).enumerate();
        Contact {
            usual,
            shares,
            axes: axes.filter_map(weighted).collect(),
        }
    }

    /// Vertical force of a contact, N.
    pub fn force_n(&self, contact: &Contact) -> f64 {
        let usual = summed(&contact.usual, |node| self.usual.forces_n[node]);
        let change = |(axis, weights): &(usize, Weights)| {
            summed(&contact.shares, |depth| {
                let nodes = self.axes[*axis].nodes[depth].iter().zip(weights);
                nodes.map(|(node, weight)| node.force_n * weight).sum()
            })
        };
        usual + contact.axes.iter().map(change).sum::<f64>()
    }

    /// Signal of a kind of film with a contact: a sample each degree from -180.
    pub fn signal(&self, contact: &Contact, kind: usize) -> Vec<f64> {
        let mut signal = vec![0.0; DEGREES];
        let mut add = |samples: &[f64], weight: f64| {
            for (sum, sample) in signal.iter_mut().zip(samples) {
                *sum += weight * sample;
            }
        };
        for (node, share) in contact.usual.each() {
            add(&self.usual.signals[kind][node], share);
        }
        for (axis, weights) in &contact.axes {
            for (depth, share) in contact.shares.each() {
                for (node, weight) in self.axes[*axis].nodes[depth].iter().zip(weights) {
                    add(&node.signals[kind], share * weight);
                }
            }
        }
        signal
    }

    /// Values of an axis' quantity at its outermost steps at each depth.
    pub fn reached(&self, axis: usize) -> impl Iterator<Item = [f64; 2]> + '_ {
        let ends = |nodes: &Vec<AxisNode>| [nodes[0].value, nodes[nodes.len() - 1].value];
        self.axes[axis].nodes.iter().map(ends)
    }

    /// Signals and forces over contacts of which this is drawn: their means, and the variances of the signals by kind and depth.
    pub fn over_contacts(&self, drawn: Drawn) -> (DepthSignals, Vec<Vec<Vec<f64>>>) {
        let mut means = self.usual.clone();
        let mut spread = means.signals.clone();
        let points = Sobol::new(self.axes.len());
        let shares: Vec<Vec<f64>> = (0..CONTACTS).map(|k| points.point(k, 0)).collect();
        for (node, depth) in self.usual.depths.places().iter().enumerate() {
            let contacts: Vec<Contact> = shares
                .iter()
                .map(|shares| self.contact(*depth, &self.drawn(shares, drawn)))
                .collect();
            means.forces_n[node] = moments(contacts.iter().map(|own| self.force_n(own)))[0];
            for (kind, spread) in spread.iter_mut().enumerate() {
                let signals: Vec<Vec<f64>> = contacts
                    .iter()
                    .map(|contact| self.signal(contact, kind))
                    .collect();
                for degree in 0..DEGREES {
                    let [mean, variance] = moments(signals.iter().map(|signal| signal[degree]));
                    means.signals[kind][node][degree] = mean;
                    spread[node][degree] = variance;
                }
            }
        }
        (means, spread)
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

impl ContactAxis {
    /// Values of its quantity at its nodes, between depths by these shares.
    fn values(&self, shares: &Shares) -> Weights {
        let mut values = [0.0; MOST_NODES];
        for (node, value) in values.iter_mut().enumerate().take(self.nodes[0].len()) {
            *value = summed(shares, |depth| self.nodes[depth][node].value);
        }
        values
    }

    /// Lagrange's polynomials through its nodes, at a step.
    fn polynomials(&self, step: f64) -> Weights {
        polynomials(self.nodes[0].len(), step)
    }

    /// Step from -1 to 1 at which the polynomial through values at its nodes, which increase or decrease, has a value; 0 at the usual one.
    fn step_of(&self, values: &Weights, value: f64) -> f64 {
        let count = self.nodes[0].len();
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

/// Mean and variance of some numbers.
fn moments(numbers: impl Iterator<Item = f64> + Clone) -> [f64; 2] {
    let count = f64::from(CONTACTS);
    let mean = numbers.clone().sum::<f64>() / count;
    let squares = numbers.map(|number| (number - mean) * (number - mean));
    [mean, squares.sum::<f64>() / count]
}

/// Lagrange's polynomials through so many even steps from -1 to 1, at a step.
pub(super) fn polynomials(count: usize, step: f64) -> Weights {
    let place = |k: usize| 2.0 * k as f64 / (count - 1).max(1) as f64 - 1.0;
    let mut weights = [0.0; MOST_NODES];
    for (k, weight) in weights.iter_mut().enumerate().take(count) {
        let others = (0..count).filter(|other| *other != k);
        let factors = others.map(|other| (step - place(other)) / (place(k) - place(other)));
        *weight = factors.product();
    }
    weights
}

fn dot(a: &Weights, b: &Weights) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

#[cfg(test)]
pub(crate) mod tests {
    use documents::layouts::contact_laws::ContactQuantity;
    use gsa::law::distribution::Distribution;

    use super::*;

    /// A share by which signals are larger for each unit of a quantity.
    const BY_PRESSURE: f64 = -0.8;
    /// Newtons for each unit of pressure and mm.
    const STIFFER_N: f64 = 10.0;

    fn law(quantity: ContactQuantity, low: f64, high: f64) -> ContactLaw {
        ContactLaw {
            quantity,
            law: Distribution::uniform(low, high).expect("a law"),
        }
    }

    /// A bell of 14 degrees, and its slope, times the depth.
    fn bells(depth: f64) -> Vec<Vec<f64>> {
        let bell = |u: i32| depth * (-0.5 * (f64::from(u) / 14.0).powi(2)).exp();
        let slope = |u: i32| -f64::from(u) / 14.0 * bell(u);
        vec![
            (-180..180).map(bell).collect(),
            (-180..180).map(slope).collect(),
        ]
    }

    /// Signals that a pressure makes smaller, and a traction adds the square of its shift to; it saturates with the shift.
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
                value,
                force_n: STIFFER_N * (value - 1.0) * depth,
                signals: scaled(&bells(*depth), BY_PRESSURE * (value - 1.0)),
            };
            [0.9, 1.0, 1.1].map(node).to_vec()
        };
        let traction = |depth: &f64| {
            let node = |step: f64| AxisNode {
                value: traction_of(step),
                force_n: 0.0,
                signals: vec![vec![step * step * depth; DEGREES]; 2],
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

    #[test]
    fn variances_over_contacts_are_those_of_the_laws() {
        let of = |axis: usize| {
            let mut surface = surface();
            surface.axes = vec![ContactAxis {
                law: 0,
                ..surface.axes[axis].clone()
            }];
            surface.laws = vec![surface.laws[axis].clone()];
            surface
        };
        let (means, spread) = of(0).over_contacts(Drawn::All);
        let [contact, opposite] = [180, 0].map(|degree| spread[0][1][degree]);
        // Of an even law between -r and r the variance is r^2 / 3; 64 points of a net, and what isn't drawn, leave 1 %.
        let expected = (BY_PRESSURE * 0.1).powi(2) / 3.0;
        assert!((means.signals[0][1][180] - 1.0).abs() < 1e-3);
        assert!((contact / expected - 1.0).abs() < 0.02, "{contact}");
        assert!(opposite < 1e-30);
        // A force that is symmetric about the usual one is that one in the mean.
        assert!((means.forces_n[1] - 13.0).abs() < 0.02);
        let (usual, nothing) = of(0).over_contacts(Drawn::Nothing);
        let off = |(found, flat): (&f64, f64)| (found - flat).abs();
        let flat = bells(1.0).swap_remove(0);
        assert!(
            usual.signals[0][1]
                .iter()
                .zip(flat)
                .map(off)
                .all(|off| off < 1e-14)
        );
        // The mean of 64 equal numbers is off by 64 roundings at most.
        let rounding = (64.0 * f64::EPSILON).powi(2);
        assert!(
            nothing
                .iter()
                .flatten()
                .flatten()
                .all(|variance| *variance < rounding)
        );
    }
}
