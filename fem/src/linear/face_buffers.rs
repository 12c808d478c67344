//! Buffers of one face on its way into residual and tangent.

use crate::cell::element::Order;
use crate::linear::setup::Setup;
use crate::linear::system::Entries;
use crate::problem::{Problem, State};
use crate::tensor::Vector;

/// Residual, stiffness and nodal positions of one face.
#[derive(Debug)]
pub(super) struct FaceBuffers {
    /// Nodal forces, N.
    pub(super) residual: Vec<f64>,
    /// Stiffness by rows, N/mm.
    pub(super) stiffness: Vec<f64>,
    /// Current positions or displacements of the nodes, mm.
    pub(super) positions: Vec<Vector>,
}

impl FaceBuffers {
    /// Buffers for faces of this order.
    pub(super) fn new(order: Order) -> Self {
        let unknowns = 3 * order.face_nodes();
        Self {
            residual: vec![0.0; unknowns],
            stiffness: vec![0.0; unknowns * unknowns],
            positions: vec![[0.0; 3]; order.face_nodes()],
        }
    }

    pub(super) fn clear(&mut self, tangent: bool) {
        self.residual.fill(0.0);
        if tangent {
            self.stiffness.fill(0.0);
        }
    }

    /// Positions, residual and stiffness.
    pub(super) fn parts(&mut self) -> (&[Vector], &mut [f64], &mut [f64]) {
        (&self.positions, &mut self.residual, &mut self.stiffness)
    }

    /// Takes the current positions of these nodes.
    pub(super) fn move_to(&mut self, problem: &Problem, state: &State, nodes: &[u32]) {
        for (position, &node) in self.positions.iter_mut().zip(nodes) {
            *position = state.position(&problem.mesh, node);
        }
    }

    /// Adds the stiffness of face `index` to the tangent.
    pub(super) fn scatter(
        &self,
        setup: &Setup,
        nodes: &[u32],
        index: usize,
        scatter: &[u32],
        pending: &[Vector],
        entries: &mut Entries,
    ) {
        let packed = self.residual.len() * (self.residual.len() + 1) / 2;
        let scatter = &scatter[index * packed..(index + 1) * packed];
        entries.add(&setup.equations, nodes, &self.stiffness, scatter, pending);
    }
}

/// Copies the values of these nodes.
pub(super) fn gather(values: &[Vector], nodes: &[u32], local: &mut [Vector]) {
    for (target, &node) in local.iter_mut().zip(nodes) {
        *target = values[node as usize];
    }
}

/// The values of these nodes.
pub(super) fn gathered(values: &[Vector], nodes: &[u32]) -> Vec<Vector> {
    nodes.iter().map(|&node| values[node as usize]).collect()
}
