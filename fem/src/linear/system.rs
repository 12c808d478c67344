//! The residuals and the tangent entries into which elements are summed.

use crate::linear::setup::Setup;
use crate::linear::sparsity::{Equations, NONE};
use crate::tensor::Vector;

/// Residuals at one state, in buffers that are reused.
#[derive(Debug)]
pub struct Residuals {
    /// Out-of-balance forces of the free displacements, N.
    pub forces: Vec<f64>,
    /// The part of them that contact causes, N.
    pub contact: Vec<f64>,
    /// Volume residuals, mm^3: brick, mode.
    pub volumes: Vec<f64>,
    /// Smallest J of an integration point; minus infinity when one isn't a number.
    pub min_volume_ratio: f64,
    /// Whether a face that the solver isn't ready for touches the ground.
    pub touches_outside: bool,
    /// Force of the ground along its z axis, N.
    pub ground_force: f64,
    /// Forces that meet at held displacements, N: node, axis; 0 at free ones.
    held: Vec<Vector>,
    /// Sum of the absolute forces that meet at each displacement, held ones included, N.
    pub(crate) magnitudes: Vec<f64>,
}

/// Size of the imbalance, relative to the problem's own forces and volumes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Imbalance {
    /// Norm of the out-of-balance forces over the norm of the forces that meet at the nodes; 0 without any force.
    pub force: f64,
    /// Norm of the volume residuals over the norm of the volumes.
    pub volume: f64,
    /// Difference between the ground's force and the one it is to press with, relative to that, times a hundredth: an equilibrium to 1e-8 is pressed with its
    /// force to 1e-6.
    pub ground: f64,
}

impl Imbalance {
    /// The largest of the relative residuals.
    pub fn worst(&self) -> f64 {
        self.force.max(self.volume).max(self.ground)
    }
}

impl Residuals {
    /// Buffers for a problem of this many bricks, pressure modes and nodes.
    pub(crate) fn new(setup: &Setup, pressures: usize, nodes: usize) -> Self {
        Self {
            forces: vec![0.0; setup.equations.count],
            contact: vec![0.0; setup.equations.count],
            volumes: vec![0.0; pressures],
            min_volume_ratio: 1.0,
            touches_outside: false,
            ground_force: 0.0,
            held: vec![[0.0; 3]; nodes],
            magnitudes: vec![0.0; 3 * nodes],
        }
    }

    pub(crate) fn clear(&mut self) {
        self.forces.fill(0.0);
        self.contact.fill(0.0);
        self.held.fill([0.0; 3]);
        self.magnitudes.fill(0.0);
        self.min_volume_ratio = f64::INFINITY;
        self.touches_outside = false;
        self.ground_force = 0.0;
    }

    /// Adds nodal forces of an element.
    pub(crate) fn add(&mut self, equations: &Equations, nodes: &[u32], forces: &[f64]) {
        for (&node, force) in nodes.iter().zip(forces.chunks_exact(3)) {
            for axis in 0..3 {
                self.magnitudes[3 * node as usize + axis] += force[axis].abs();
                let equation = equations.of_node[node as usize][axis];
                if equation == NONE {
                    self.held[node as usize][axis] += force[axis];
                } else {
                    self.forces[equation as usize] += force[axis];
                }
            }
        }
    }

    /// Returns the forces that the supports must bear: the internal forces at held displacements.
    pub(crate) fn held_forces(&self) -> Vec<Vector> {
        self.held.clone()
    }

    /// Adds nodal forces of a face that touches ground whose z axis points along `up`.
    pub(crate) fn add_contact(
        &mut self,
        equations: &Equations,
        nodes: &[u32],
        forces: &[f64],
        up: &Vector,
    ) {
        self.add(equations, nodes, forces);
        for (axis, component) in up.iter().enumerate() {
            let force: f64 = forces.iter().skip(axis).step_by(3).sum();
            self.ground_force -= component * force;
        }
        for (equation, force) in equations.of(nodes).zip(forces) {
            if equation != NONE {
                self.contact[equation as usize] += force;
            }
        }
    }
}

/// Entries of the condensed tangent of all but contact, and what held displacements on the move cause.
#[derive(Debug)]
pub struct Entries {
    /// Upper triangle in the pattern's order.
    pub values: Vec<f64>,
    /// Forces that the pending increments of held displacements cause at the free ones, N.
    pub pending_forces: Vec<f64>,
}

impl Entries {
    pub(crate) fn new(setup: &Setup) -> Self {
        Self {
            values: vec![0.0; setup.symbolic.pattern().entries()],
            pending_forces: vec![0.0; setup.equations.count],
        }
    }

    pub(crate) fn clear(&mut self) {
        self.values.fill(0.0);
        self.pending_forces.fill(0.0);
    }

    /// Adds an element's stiffness (upper triangle by rows, to the places in `scatter`).
    pub(crate) fn add(
        &mut self,
        equations: &Equations,
        nodes: &[u32],
        stiffness: &[f64],
        scatter: &[u32],
        pending: &[Vector],
    ) {
        let unknowns = 3 * nodes.len();
        let mut start = 0;
        for row in 0..unknowns {
            let count = unknowns - row;
            let values = &stiffness[row * unknowns + row..(row + 1) * unknowns];
            for (value, &position) in values.iter().zip(&scatter[start..start + count]) {
                if position != NONE {
                    self.values[position as usize] += value;
                }
            }
            start += count;
        }
        self.add_pending(equations, nodes, stiffness, pending);
    }

    fn add_pending(
        &mut self,
        equations: &Equations,
        nodes: &[u32],
        stiffness: &[f64],
        pending: &[Vector],
    ) {
        let unknowns = 3 * nodes.len();
        for (local, &node) in nodes.iter().enumerate() {
            for axis in 0..3 {
                let change = pending[node as usize][axis];
                if change == 0.0 {
                    continue;
                }
                let column = 3 * local + axis;
                for (row, equation) in equations.of(nodes).enumerate().filter(|(_, e)| *e != NONE) {
                    let (a, b) = (row.min(column), row.max(column));
                    self.pending_forces[equation as usize] += stiffness[a * unknowns + b] * change;
                }
            }
        }
    }
}
