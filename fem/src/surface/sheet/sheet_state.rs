//! Strains and curvatures of a sheet in a state.

use super::glued_sheet::{Point, Sheet, weighted};
use crate::surface::surface_law::InPlane;
use crate::tensor::{Vector, cross, dot, norm};

/// State of a sheet at an integration point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SheetPoint {
    /// Reference area, mm^2.
    pub area: f64,
    /// Green-Lagrange strain along the sheet's axes.
    pub strain: InPlane,
    /// Change of curvature since the reference state, 1/mm: 11, 22, twice 12; positive where the surface becomes more hollow on the side of its normal.
    pub curvature: InPlane,
}

impl Sheet {
    /// Strains at all integration points, of all nodes' displacements, mm.
    pub fn points(&self, displacement: &[Vector]) -> Vec<SheetPoint> {
        let first = self.first_node as usize;
        self.points_of(&displacement[first..first + self.positions.len()])
    }

    /// Strains at all integration points, of the displacements of the control points, mm.
    pub fn points_of(&self, controls: &[Vector]) -> Vec<SheetPoint> {
        let mut points = Vec::new();
        for element in &self.elements {
            let own = element.nodes[..element.controls].iter();
            let own = own.map(|&node| controls[(node - self.first_node) as usize]);
            let own: Vec<Vector> = own.collect();
            points.extend(element.points.iter().map(|point| {
                let kinematics = point.kinematics(&own);
                SheetPoint {
                    area: point.area,
                    strain: kinematics.strain,
                    curvature: kinematics.curvature,
                }
            }));
        }
        points
    }
}

/// A point of a deformed sheet.
pub(super) struct Kinematics {
    /// Derivatives of the position along the reference axes.
    pub(super) tangents: [Vector; 2],
    /// Unit normal.
    pub(super) normal: Vector,
    /// Second derivatives along the tangents: component 11, 22, 12, tangent.
    pub(super) christoffel: [[f64; 2]; 3],
    pub(super) strain: InPlane,
    pub(super) curvature: InPlane,
}

impl Point {
    /// Returns the kinematics of the displacements of the element's control points.
    pub(super) fn kinematics(&self, controls: &[Vector]) -> Kinematics {
        let change = [0, 1].map(|a| weighted(controls, |k| &self.first[k][a]));
        let tangents = [0, 1].map(|a| [0, 1, 2].map(|i| self.axes[a][i] + change[a][i]));
        let doubled = |a: usize, b: usize| {
            dot(&self.axes[a], &change[b])
                + dot(&self.axes[b], &change[a])
                + dot(&change[a], &change[b])
        };
        let normal = cross(&tangents[0], &tangents[1]);
        let area = norm(&normal);
        let normal = normal.map(|n| n / area);
        let duals = [cross(&tangents[1], &normal), cross(&normal, &tangents[0])]
            .map(|t| t.map(|c| c / area));
        let before = cross(&self.axes[0], &self.axes[1]);
        let bend = [0, 1, 2].map(|c| {
            let change = weighted(controls, |k| &self.second[k][c]);
            [0, 1, 2].map(|i| self.bend[c][i] + change[i])
        });
        let curved = |c: usize| dot(&bend[c], &normal) - dot(&self.bend[c], &before);
        Kinematics {
            christoffel: bend.map(|b| [dot(&b, &duals[0]), dot(&b, &duals[1])]),
            strain: [0.5 * doubled(0, 0), 0.5 * doubled(1, 1), doubled(0, 1)],
            curvature: [curved(0), curved(1), 2.0 * curved(2)],
            tangents,
            normal,
        }
    }
}
