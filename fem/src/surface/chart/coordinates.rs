//! A surface in a chart of orthogonal coordinate lines.

use super::corners::corner_node;
use crate::cell::element::face_shape;
use crate::cell::mesh::{Surface, SurfacePoint};

/// A surface with coordinates on it.
#[derive(Debug, Clone)]
pub struct Chart {
    /// Faces of the surface.
    pub surface: Surface,
    /// Chart coordinates of the faces' nodes, face by face, as lengths, mm; lines s1 and s2 cross at right angles.
    pub coordinates: Vec<[f64; 2]>,
    /// Symmetry lines: axis and value (mm) of the coordinate that is constant on the line.
    pub mirrors: Vec<(usize, f64)>,
    /// Length, mm, after which s1 comes back to where it began.
    pub period: Option<f64>,
}

impl Chart {
    /// Chart coordinates of a point, mm.
    pub fn position(&self, point: SurfacePoint) -> [f64; 2] {
        let n = self.surface.order.face_nodes();
        let (values, _) = face_shape(self.surface.order, point.local);
        let nodes = &self.coordinates[point.face * n..(point.face + 1) * n];
        [0, 1].map(|k| nodes.iter().zip(&values).map(|(s, v)| s[k] * v).sum())
    }

    /// Area in the chart over area on the reference square.
    pub(super) fn area_ratio(&self, point: SurfacePoint) -> f64 {
        let n = self.surface.order.face_nodes();
        let (_, gradients) = face_shape(self.surface.order, point.local);
        let nodes = &self.coordinates[point.face * n..(point.face + 1) * n];
        let j = chart_jacobian(nodes, &gradients);
        (j[0][0] * j[1][1] - j[0][1] * j[1][0]).abs()
    }

    /// Chart coordinates of a corner of a face.
    pub(super) fn corner(&self, face: usize, corner: usize) -> [f64; 2] {
        self.coordinates
            [face * self.surface.order.face_nodes() + corner_node(self.surface.order, corner)]
    }

    /// The way from `origin` to `s`, the short way round.
    pub(super) fn difference(&self, s: [f64; 2], origin: [f64; 2]) -> [f64; 2] {
        let mut d = [s[0] - origin[0], s[1] - origin[1]];
        if let Some(period) = self.period {
            d[0] -= period * (d[0] / period).round();
        }
        d
    }

    /// Symmetry lines through a corner.
    pub(super) fn mirrors_through(&self, corner: [f64; 2]) -> Vec<(usize, f64)> {
        let on = |&(axis, value): &(usize, f64)| {
            (corner[axis] - value).abs() <= 1e-9 * (1.0 + value.abs())
        };
        self.mirrors.iter().copied().filter(on).collect()
    }
}

/// Derivatives of the chart's coordinates by the face's.
fn chart_jacobian(coordinates: &[[f64; 2]], gradients: &[[f64; 2]]) -> [[f64; 2]; 2] {
    let mut j = [[0.0; 2]; 2];
    for (s, g) in coordinates.iter().zip(gradients) {
        for (k, row) in j.iter_mut().enumerate() {
            for l in 0..2 {
                row[l] += s[k] * g[l];
            }
        }
    }
    j
}

/// Derivatives of the shape functions by the chart's coordinates.
pub(super) fn chart_gradients(coordinates: &[[f64; 2]], gradients: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let j = chart_jacobian(coordinates, gradients);
    let determinant = j[0][0] * j[1][1] - j[0][1] * j[1][0];
    gradients
        .iter()
        .map(|g| {
            [
                (g[0] * j[1][1] - g[1] * j[1][0]) / determinant,
                (g[1] * j[0][0] - g[0] * j[0][1]) / determinant,
            ]
        })
        .collect()
}
