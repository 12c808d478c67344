//! Layers of a membrane: where they lie, and how they strain.

use crate::cell::element::{FacePoint, face_points};
use crate::cell::mesh::{Mesh, Surface};
use crate::surface::surface_law::{InPlane, SurfaceLaw};
use crate::tensor::{Vector, cross, dot, norm};

/// First axis of the layers as a function of reference position and unit normal; its tangential part is taken.
pub type Direction<'d> = &'d dyn Fn(&Vector, &Vector) -> Vector;

/// Layers on a surface of the mesh, ready to be integrated.
#[derive(Debug)]
pub struct Membrane {
    /// The faces that carry the layers.
    pub surface: Surface,
    laws: Vec<Box<dyn SurfaceLaw>>,
    pub(super) points_per_face: usize,
    /// Derivatives of the shape functions along the axes, 1/mm: face, point, node.
    gradients: Vec<[f64; 2]>,
    /// Reference area of each point, mm^2: face, point.
    pub(super) areas: Vec<f64>,
    /// Reference axes: face, point.
    axes: Vec<[Vector; 2]>,
}

impl Membrane {
    /// Puts layers on a surface. The second axis is the normal times the first.
    pub fn new(
        mesh: &Mesh,
        surface: Surface,
        first_axis: Direction<'_>,
        laws: Vec<Box<dyn SurfaceLaw>>,
    ) -> Self {
        let points = face_points(mesh.order, mesh.order.edge_nodes());
        let mut membrane = Self {
            laws,
            points_per_face: points.len(),
            gradients: Vec::new(),
            areas: Vec::new(),
            axes: Vec::new(),
            surface,
        };
        for face in 0..membrane.surface.face_count() {
            let nodes = membrane.surface.face(face).iter();
            let nodes: Vec<Vector> = nodes.map(|&n| mesh.nodes[n as usize]).collect();
            for point in &points {
                membrane.add_point(&nodes, point, first_axis);
            }
        }
        membrane
    }

    fn add_point(&mut self, nodes: &[Vector], point: &FacePoint, first_axis: Direction<'_>) {
        let [t1, t2] = point.tangents(nodes);
        let normal = cross(&t1, &t2);
        let area = norm(&normal);
        let normal = normal.map(|n| n / area);
        let position = [0, 1, 2].map(|i| {
            let terms = nodes.iter().zip(&point.values);
            terms.map(|(x, n)| x[i] * n).sum::<f64>()
        });
        let direction = first_axis(&position, &normal);
        let out_of_plane = dot(&direction, &normal);
        let tangential = [0, 1, 2].map(|i| direction[i] - out_of_plane * normal[i]);
        let length = norm(&tangential);
        let first = tangential.map(|c| c / length);
        let axes = [first, cross(&normal, &first)];
        // Dual tangents: t2 x n / area and n x t1 / area.
        let duals = [cross(&t2, &normal), cross(&normal, &t1)].map(|t| t.map(|c| c / area));
        let along = axes.map(|axis| [dot(&duals[0], &axis), dot(&duals[1], &axis)]);
        let gradient = |g: &[f64; 2]| along.map(|a| g[0] * a[0] + g[1] * a[1]);
        self.gradients.extend(point.gradients.iter().map(gradient));
        self.areas.push(point.weight * area);
        self.axes.push(axes);
    }

    /// Stiffness of all layers times the root of the area: the force at a strain of order one, N.
    pub(crate) fn natural_force(&self) -> f64 {
        let stiffness: f64 = self.laws.iter().map(|law| law.stiffness()).sum();
        stiffness * self.area().sqrt()
    }

    /// Reference area that the layers cover, mm^2.
    pub fn area(&self) -> f64 {
        self.areas.iter().sum()
    }

    /// Reference areas of the integration points of one face, mm^2.
    pub fn point_areas(&self, face: usize) -> &[f64] {
        &self.areas[face * self.points_per_face..(face + 1) * self.points_per_face]
    }

    /// Green-Lagrange strains at the integration points of one face.
    pub fn strains(&self, face: usize, displacement: &[Vector]) -> impl Iterator<Item = InPlane> {
        (0..self.points_per_face).map(move |point| self.kinematics(face, point, displacement).1)
    }

    /// Sum of the layers' tensions and moduli, N/mm.
    pub(super) fn response(&self, strain: &InPlane) -> (InPlane, [InPlane; 3]) {
        let (mut tensions, mut moduli) = ([0.0; 3], [[0.0; 3]; 3]);
        for law in &self.laws {
            let (s, d) = law.tensions(strain);
            for v in 0..3 {
                tensions[v] += s[v];
                for w in 0..3 {
                    moduli[v][w] += d[v][w];
                }
            }
        }
        (tensions, moduli)
    }

    /// Derivatives of the shape functions along the axes at a point of a face, 1/mm.
    pub(super) fn shape_gradients(&self, face: usize, point: usize, nodes: usize) -> &[[f64; 2]] {
        let offset = (face * self.points_per_face + point) * nodes;
        &self.gradients[offset..offset + nodes]
    }

    /// Current axes and Green-Lagrange strain.
    pub(super) fn kinematics(
        &self,
        face: usize,
        point: usize,
        displacement: &[Vector],
    ) -> ([Vector; 2], InPlane) {
        let axes = &self.axes[face * self.points_per_face + point];
        let mut change = [[0.0; 3]; 2];
        let gradients = self.shape_gradients(face, point, displacement.len());
        for (u, n) in displacement.iter().zip(gradients) {
            for i in 0..3 {
                change[0][i] += n[0] * u[i];
                change[1][i] += n[1] * u[i];
            }
        }
        let doubled = |a: usize, b: usize| {
            dot(&axes[a], &change[b]) + dot(&axes[b], &change[a]) + dot(&change[a], &change[b])
        };
        let current = [0, 1].map(|a| [0, 1, 2].map(|i| axes[a][i] + change[a][i]));
        let strain = [0.5 * doubled(0, 0), 0.5 * doubled(1, 1), doubled(0, 1)];
        (current, strain)
    }
}
