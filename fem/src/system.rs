//! The linear system of one Newton step, into which elements are summed.

use crate::sparsity::{Equations, NONE};
use crate::tensor::Vector;

/// The linear system of one Newton step, in buffers that are reused.
#[derive(Debug)]
pub struct System {
    /// Out-of-balance forces of the free displacements, N.
    pub residual: Vec<f64>,
    /// The same after elimination of the pressures: minus the right-hand side.
    pub condensed_residual: Vec<f64>,
    /// Entries of the condensed tangent in the pattern's order.
    pub entries: Vec<f64>,
    /// Sum of the absolute forces that meet at each displacement, held ones included.
    pub(crate) force_magnitude: Vec<f64>,
    /// Derivative of each brick's volume residuals by its displacements: brick, mode, unknown.
    pub(crate) coupling: Vec<f64>,
    /// Volume residuals: brick, mode.
    pub(crate) pressure_residual: Vec<f64>,
}

/// Size of the imbalance, relative to the problem's own forces and volumes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Imbalance {
    /// Norm of the out-of-balance forces over the norm of the forces that meet at the nodes; 0 without any force.
    pub force: f64,
    /// Norm of the volume residuals over the norm of the volumes.
    pub volume: f64,
}

impl Imbalance {
    /// The larger of the two relative residuals.
    pub fn worst(&self) -> f64 {
        self.force.max(self.volume)
    }
}

impl System {
    /// Adds nodal forces of an element.
    pub(crate) fn add_forces(&mut self, equations: &Equations, nodes: &[u32], forces: &[f64]) {
        for (&node, force) in nodes.iter().zip(forces.chunks_exact(3)) {
            for axis in 0..3 {
                self.force_magnitude[3 * node as usize + axis] += force[axis].abs();
                let equation = equations.of_node[node as usize][axis];
                if equation != NONE {
                    self.residual[equation as usize] += force[axis];
                }
            }
        }
    }

    /// Adds an element's condensed forces, its stiffness (upper triangle by rows, to the places in `scatter`), and what
    /// pending increments of held displacements cause.
    pub(crate) fn add_tangent(
        &mut self,
        equations: &Equations,
        nodes: &[u32],
        forces: &[f64],
        stiffness: &[f64],
        scatter: &[u32],
        pending: &[Vector],
    ) {
        for (&node, force) in nodes.iter().zip(forces.chunks_exact(3)) {
            for axis in 0..3 {
                let equation = equations.of_node[node as usize][axis];
                if equation != NONE {
                    self.condensed_residual[equation as usize] += force[axis];
                }
            }
        }
        let unknowns = forces.len();
        let mut start = 0;
        for row in 0..unknowns {
            let count = unknowns - row;
            let values = &stiffness[row * unknowns + row..(row + 1) * unknowns];
            for (value, &position) in values.iter().zip(&scatter[start..start + count]) {
                if position != NONE {
                    self.entries[position as usize] += value;
                }
            }
            start += count;
        }
        self.add_pending(equations, nodes, stiffness, pending);
    }

    /// Forces that the pending increments of held displacements cause at the free ones.
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
                let change = pending.get(node as usize).map_or(0.0, |du| du[axis]);
                if change == 0.0 {
                    continue;
                }
                let column = 3 * local + axis;
                for (row, equation) in equations.of(nodes).enumerate().filter(|(_, e)| *e != NONE) {
                    let (a, b) = (row.min(column), row.max(column));
                    self.condensed_residual[equation as usize] +=
                        stiffness[a * unknowns + b] * change;
                }
            }
        }
    }
}
