//! Stretches of one state, by polynomials around the corners.

use super::coordinates::{Chart, chart_gradients};
use super::corners::Corners;
use super::patch::{Patch, Sample};
use crate::cell::element::{Order, face_rule, face_shape};
use crate::cell::mesh::{Mesh, SurfacePoint};
use crate::cell::quadrature;
use crate::surface::stretch::Stretch;
use crate::tensor::{Vector, dot, norm};

/// Recovered stretches of one state.
#[derive(Debug)]
pub struct Recovery<'c> {
    chart: &'c Chart,
    /// Corner k of the surface has patch k.
    corners: Corners,
    patches: Vec<Patch>,
    positions: Vec<Vector>,
    reference: Vec<Vector>,
}

impl<'c> Recovery<'c> {
    /// Recovers the stretches of the state whose current nodal positions are given.
    ///
    /// # Panics
    /// When the surface belongs to a body in plane strain: its faces are lines and have no second coordinate.
    pub fn new(chart: &'c Chart, mesh: &Mesh, position: impl Fn(u32) -> Vector) -> Self {
        assert!(
            !mesh.order.is_plane(),
            "recovery needs faces with two coordinates"
        );
        let positions: Vec<Vector> = chart.surface.faces.iter().map(|&n| position(n)).collect();
        let reference: Vec<Vector> = chart
            .surface
            .faces
            .iter()
            .map(|&n| mesh.nodes[n as usize])
            .collect();
        let mut recovery = Self {
            chart,
            corners: Corners::new(&chart.surface),
            patches: Vec::new(),
            positions,
            reference,
        };
        recovery.fit();
        recovery
    }

    /// Recovered stretch at a point of the surface.
    pub fn at(&self, point: SurfacePoint) -> Stretch {
        let (weights, _) = face_shape(Order::Linear, point.local);
        let here = self.chart.position(point);
        let mut value = [0.0; 3];
        for (corner, weight) in weights.iter().enumerate() {
            let patch = &self.patches[self.corners.of_face[point.face][corner]];
            let origin = self.chart.corner(point.face, corner);
            let fitted = patch.at([here[0] - origin[0], here[1] - origin[1]]);
            for k in 0..3 {
                value[k] += weight * fitted[k];
            }
        }
        Stretch {
            s1: value[0],
            s2: value[1],
            shear: value[2],
        }
    }

    /// Current position of a point of the surface, mm, as its face's nodes have it.
    pub fn position(&self, point: SurfacePoint) -> Vector {
        let n = self.chart.surface.order.face_nodes();
        let (values, _) = face_shape(self.chart.surface.order, point.local);
        let nodes = &self.positions[point.face * n..(point.face + 1) * n];
        [0, 1, 2].map(|i| nodes.iter().zip(&values).map(|(x, v)| x[i] * v).sum())
    }

    /// Stretch at a point as the face itself has it, without recovery.
    pub fn raw_at(&self, point: SurfacePoint) -> Stretch {
        let n = self.chart.surface.order.face_nodes();
        let range = point.face * n..(point.face + 1) * n;
        let (_, gradients) = face_shape(self.chart.surface.order, point.local);
        let along = chart_gradients(&self.chart.coordinates[range.clone()], &gradients);
        let lines = |nodes: &[Vector]| {
            [0, 1].map(|k| {
                [0, 1, 2].map(|i| {
                    nodes
                        .iter()
                        .zip(&along)
                        .map(|(x, g)| x[i] * g[k])
                        .sum::<f64>()
                })
            })
        };
        let current = lines(&self.positions[range.clone()]);
        let reference = lines(&self.reference[range]).map(|line| norm(&line));
        Stretch {
            s1: norm(&current[0]) / reference[0],
            s2: norm(&current[1]) / reference[1],
            shear: dot(&current[0], &current[1]) / (reference[0] * reference[1]),
        }
    }

    /// Gauss points of the point's face and of all that share a corner with it, with their chart areas: where recovered
    /// and raw values are compared. Their difference at a single point may vanish by chance.
    pub fn surroundings(&self, point: SurfacePoint) -> Vec<(SurfacePoint, f64)> {
        let order = self.chart.surface.order;
        let rule = face_rule(order, order.edge_nodes());
        let faces = self.corners.ring(&[point.face]);
        let points = faces.into_iter().flat_map(|face| {
            rule.iter().map(move |&(local, weight)| {
                let point = SurfacePoint { face, local };
                (point, weight * self.chart.area_ratio(point))
            })
        });
        points.collect()
    }

    fn fit(&mut self) {
        let samples: Vec<Vec<Sample>> = (0..self.chart.surface.face_count())
            .map(|f| self.face_samples(f))
            .collect();
        self.patches = self
            .corners
            .uses
            .iter()
            .map(|uses| self.patch(uses, &samples))
            .collect();
    }

    /// Samples of one face in the chart's coordinates.
    fn face_samples(&self, face: usize) -> Vec<Sample> {
        quadrature::rectangle([self.chart.surface.order.edge_nodes() - 1; 2])
            .into_iter()
            .map(|(local, _)| {
                let point = SurfacePoint { face, local };
                let stretch = self.raw_at(point);
                (
                    self.chart.position(point),
                    [stretch.s1, stretch.s2, stretch.shear],
                )
            })
            .collect()
    }

    fn patch(&self, uses: &[(usize, usize)], samples: &[Vec<Sample>]) -> Patch {
        let (face, corner) = uses[0];
        let origin = self.chart.corner(face, corner);
        let mut faces: Vec<usize> = uses.iter().map(|u| u.0).collect();
        let mirrors: Vec<(usize, f64)> = self.chart.mirrors_through(origin);
        if faces.len() << mirrors.len() < 4 {
            faces = self.corners.ring(&faces);
        }
        let mut points: Vec<Sample> = Vec::new();
        for &face in &faces {
            points.extend(
                samples[face]
                    .iter()
                    .map(|(s, v)| (self.chart.difference(*s, origin), *v)),
            );
        }
        for (axis, _) in mirrors {
            for index in 0..points.len() {
                let (mut s, mut v) = points[index];
                s[axis] = -s[axis];
                v[2] = -v[2];
                points.push((s, v));
            }
        }
        Patch::fit(self.chart.surface.order, &points)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cell::mesh::Surface;

    /// A flat sheet of n x n faces on [0, 1]^2 with a stretch that varies along s1.
    fn sheet(order: Order, n: usize) -> (Mesh, Chart) {
        let e = order.edge_nodes() - 1;
        let line = n * e + 1;
        let nodes: Vec<Vector> = (0..line * line)
            .map(|a| {
                [
                    (a % line) as f64 / (line - 1) as f64,
                    (a / line) as f64 / (line - 1) as f64,
                    0.0,
                ]
            })
            .collect();
        let mut faces = Vec::new();
        for f in 0..n * n {
            let first = (f / n) * e * line + (f % n) * e;
            faces.extend((0..=e).flat_map(|j| (0..=e).map(move |i| (first + j * line + i) as u32)));
        }
        let coordinates = faces
            .iter()
            .map(|&a: &u32| [nodes[a as usize][0], nodes[a as usize][1]])
            .collect();
        let surface = Surface { order, faces };
        let chart = Chart {
            surface,
            coordinates,
            mirrors: vec![(0, 0.0)],
            period: None,
        };
        (
            Mesh {
                order,
                nodes,
                bricks: vec![],
            },
            chart,
        )
    }

    /// x = s1 + 0.1 s1^3 / 3: even about s1 = 0, stretch 1 + 0.1 s1^2.
    fn error_at_origin(order: Order, n: usize) -> f64 {
        let (mesh, chart) = sheet(order, n);
        let recovery = Recovery::new(&chart, &mesh, |node| {
            let x = mesh.nodes[node as usize];
            [
                x[0] + 0.1 * x[0].powi(3) / 3.0 + 0.01 * x[0].powi(5),
                1.2 * x[1],
                0.0,
            ]
        });
        let stretch = recovery.at(SurfacePoint {
            face: 0,
            local: [-1.0, -0.3],
        });
        assert!((stretch.s2 - 1.2).abs() < 1e-12);
        assert!(stretch.shear.abs() < 1e-12);
        (stretch.s1 - 1.0).abs()
    }

    #[test]
    fn surroundings_cover_the_faces_around() {
        let (mesh, chart) = sheet(Order::Quadratic, 4);
        let recovery = Recovery::new(&chart, &mesh, |node| mesh.nodes[node as usize]);
        let area = |face| {
            let local = [0.3, -0.2];
            let points = recovery.surroundings(SurfacePoint { face, local });
            points.iter().map(|(_, weight)| weight).sum::<f64>()
        };
        // Of 16 faces with an area of 1/16 each, 4 lie around a corner face and 9 around an inner one.
        assert!((area(0) - 4.0 / 16.0).abs() < 1e-14);
        assert!((area(5) - 9.0 / 16.0).abs() < 1e-14);
    }

    #[test]
    fn recovery_on_a_symmetry_line_converges_at_least_as_fast_as_at_gauss_points() {
        for (order, slope) in [(Order::Linear, 2.0), (Order::Quadratic, 3.0)] {
            let (coarse, fine) = (error_at_origin(order, 8), error_at_origin(order, 16));
            let observed = (coarse / fine).log2();
            assert!(
                observed > slope - 0.1,
                "{order:?}: slope {observed}, errors {coarse:e} {fine:e}"
            );
        }
    }
}
