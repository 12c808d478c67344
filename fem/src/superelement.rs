//! A part of a body as its neighbours feel it: forces on shared nodes, linear in their displacements.
//!
//! The part itself isn't in the mesh. About a state u0 of the shared nodes it answers with
//!
//! > f = f0 + K (u - u0).
//!
//! A part under live pressure that ends at the shared nodes has a tangent K with a skew part there, which cancels against
//! that of the rest of the body. The forces have it, the tangent of the whole doesn't need it.

use faer::{Col, Mat};

use crate::tensor::Vector;

/// A linear part of a body, condensed on the nodes that it shares with the mesh.
#[derive(Debug, Clone)]
pub struct Superelement {
    /// Nodes of the mesh that it is attached to.
    pub nodes: Vec<u32>,
    /// Their displacements about which it is linear, mm.
    displacement: Vec<Vector>,
    /// Out-of-balance forces there, N: node, axis.
    forces: Vec<f64>,
    /// Derivative of the forces, N/mm: node and axis by node and axis; 0 where a displacement is held.
    stiffness: Mat<f64>,
}

impl Superelement {
    /// A part with these forces and this stiffness about these displacements.
    ///
    /// # Panics
    /// When the sizes don't fit.
    pub(crate) fn new(
        nodes: Vec<u32>,
        displacement: Vec<Vector>,
        forces: Vec<f64>,
        stiffness: Mat<f64>,
    ) -> Self {
        assert_eq!(nodes.len(), displacement.len());
        assert_eq!(3 * nodes.len(), forces.len());
        assert_eq!(3 * nodes.len(), stiffness.nrows());
        Self {
            nodes,
            displacement,
            forces,
            stiffness,
        }
    }

    /// Forces at the displacements of all nodes of the mesh, N: node, axis.
    pub(crate) fn forces(&self, displacement: &[Vector]) -> Vec<f64> {
        let change = Col::from_fn(self.forces.len(), |k| {
            displacement[self.nodes[k / 3] as usize][k % 3] - self.displacement[k / 3][k % 3]
        });
        let answer = &self.stiffness * change;
        let sums = self.forces.iter().zip(answer.iter());
        sums.map(|(force, change)| force + change).collect()
    }

    /// Upper triangle, by rows of a full matrix, of the stiffness's symmetric part.
    pub(crate) fn symmetric_stiffness(&self) -> Vec<f64> {
        let n = self.forces.len();
        let mut packed = vec![0.0; n * n];
        for row in 0..n {
            for column in row..n {
                packed[row * n + column] =
                    0.5 * (self.stiffness[(row, column)] + self.stiffness[(column, row)]);
            }
        }
        packed
    }
}
