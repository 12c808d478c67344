//! Corners of a surface, and the faces that meet there.

use std::collections::HashMap;

use crate::cell::element::Order;
use crate::cell::mesh::Surface;

/// Corners of the faces of a surface.
#[derive(Debug)]
pub(super) struct Corners {
    /// Corner numbers of each face.
    pub(super) of_face: Vec<[usize; 4]>,
    /// Faces, and their local corner, of each corner.
    pub(super) uses: Vec<Vec<(usize, usize)>>,
}

impl Corners {
    pub(super) fn new(surface: &Surface) -> Self {
        let mut numbers = HashMap::new();
        let (mut of_face, mut uses) = (Vec::new(), Vec::<Vec<_>>::new());
        for (index, face) in surface.iter().enumerate() {
            of_face.push([0, 1, 2, 3].map(|corner| {
                let node = face[corner_node(surface.order, corner)];
                let number = *numbers.entry(node).or_insert_with(|| {
                    uses.push(Vec::new());
                    uses.len() - 1
                });
                uses[number].push((index, corner));
                number
            }));
        }
        Self { of_face, uses }
    }

    /// Returns these faces and all that share a corner with them, ascending.
    pub(super) fn ring(&self, faces: &[usize]) -> Vec<usize> {
        let corners = faces.iter().flat_map(|&face| self.of_face[face]);
        let mut ring: Vec<usize> = corners
            .flat_map(|c| self.uses[c].iter().map(|u| u.0))
            .collect();
        ring.sort_unstable();
        ring.dedup();
        ring
    }
}

/// Number of a corner among the nodes of its face.
pub(super) fn corner_node(order: Order, corner: usize) -> usize {
    let n = order.edge_nodes();
    [0, n - 1, n * (n - 1), n * n - 1][corner]
}
