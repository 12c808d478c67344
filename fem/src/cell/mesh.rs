//! Nodes, bricks and surfaces.

use crate::cell::element::Order;
use crate::tensor::Vector;

/// A mesh of bricks of one order.
#[derive(Debug, Clone, PartialEq)]
pub struct Mesh {
    /// Order of all bricks.
    pub order: Order,
    /// Reference positions, mm.
    pub nodes: Vec<Vector>,
    /// Node numbers of the bricks, one after the other, lexicographic within a brick, right-handed.
    pub bricks: Vec<u32>,
}

impl Mesh {
    /// Number of bricks.
    pub fn brick_count(&self) -> usize {
        self.bricks.len() / self.order.brick_nodes()
    }

    /// Node numbers of one brick.
    pub fn brick(&self, element: usize) -> &[u32] {
        let n = self.order.brick_nodes();
        &self.bricks[element * n..(element + 1) * n]
    }
}

/// Faces of one order, taken from the bricks of a mesh.
#[derive(Debug, Clone, PartialEq)]
pub struct Surface {
    /// Order of all faces.
    pub order: Order,
    /// Node numbers of the faces, one after the other, lexicographic within a face.
    pub faces: Vec<u32>,
}

impl Surface {
    /// Number of faces.
    pub fn face_count(&self) -> usize {
        self.faces.len() / self.order.face_nodes()
    }

    /// Node numbers of one face.
    pub fn face(&self, index: usize) -> &[u32] {
        let n = self.order.face_nodes();
        &self.faces[index * n..(index + 1) * n]
    }

    /// Returns these faces with opposite normals.
    pub fn flipped(&self) -> Self {
        let along = self.order.edge_nodes();
        let across = self.order.face_nodes() / along;
        let mut faces = Vec::with_capacity(self.faces.len());
        for face in self.iter() {
            if across == 1 {
                faces.extend(face.iter().rev());
            } else {
                faces.extend((0..face.len()).map(|a| face[a % across * along + a / across]));
            }
        }
        Self {
            order: self.order,
            faces,
        }
    }

    /// All faces in order.
    pub fn iter(&self) -> impl Iterator<Item = &[u32]> {
        self.faces.chunks_exact(self.order.face_nodes())
    }
}

/// A point of a surface: a face and its reference coordinates.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SurfacePoint {
    /// Index of the face.
    pub face: usize,
    /// Coordinates on the reference square.
    pub local: [f64; 2],
}
