//! A surface that may touch the ground: its gap, and the points that touch.

use std::collections::HashSet;

use super::penalty::Penalty;
use crate::cell::element::{FacePoint, face_points};
use crate::cell::mesh::{Mesh, Surface};
use crate::load::friction::{Friction, Traction};
use crate::load::ground_shape::Height;
use crate::load::obstacle::{GroundAxes, HeightField};
use crate::tensor::{Vector, cross, norm};

/// A surface that may touch the ground.
#[derive(Debug)]
pub struct ContactSurface {
    /// Faces that can touch the ground.
    pub surface: Surface,
    /// Pressure that a penetration costs.
    pub penalty: Penalty,
    /// Friction on the ground.
    pub friction: Friction,
    /// Whether the ground may push along the y axis: it leans about the x axis, or its height varies across.
    pub may_push_across: bool,
    pub(super) rule: Vec<FacePoint>,
    /// Reference area of each point, mm^2: face, point.
    areas: Vec<f64>,
}

impl ContactSurface {
    /// Prepares a surface. Two points more than the order needs on each edge follow the patch's edge inside a face.
    pub fn new(mesh: &Mesh, surface: Surface, penalty: Penalty) -> Self {
        let rule = face_points(mesh.order, mesh.order.edge_nodes() + 1);
        let mut areas = Vec::with_capacity(surface.face_count() * rule.len());
        for face in surface.iter() {
            let nodes: Vec<Vector> = face.iter().map(|&n| mesh.nodes[n as usize]).collect();
            for point in &rule {
                let [t1, t2] = point.tangents(&nodes);
                areas.push(point.weight * norm(&cross(&t1, &t2)));
            }
        }
        Self {
            surface,
            penalty,
            friction: Friction::NONE,
            may_push_across: false,
            rule,
            areas,
        }
    }

    /// Whether the ground's forces may have a part along y.
    pub(crate) fn acts_across(&self) -> bool {
        self.may_push_across || self.friction.coefficient > 0.0
    }

    /// Faces with a node or a contact point on or below the ground, and their neighbours. A peak of the ground may touch a
    /// face between its nodes.
    pub(crate) fn faces_near(
        &self,
        ground: &HeightField,
        positions: impl Fn(u32) -> Vector,
    ) -> Vec<bool> {
        let is_below = |position: Vector| {
            let place = ground.axes.coordinates(position);
            ground
                .near(place)
                .is_some_and(|height| place[2] <= height.value)
        };
        let below = |face: &[u32]| {
            let nodes: Vec<Vector> = face.iter().map(|&n| positions(n)).collect();
            let mut points = self.rule.iter().map(|point| interpolate(point, &nodes));
            nodes.iter().copied().any(is_below) || points.any(is_below)
        };
        let near: HashSet<u32> = self
            .surface
            .iter()
            .filter(|face| below(face))
            .flatten()
            .copied()
            .collect();
        self.surface
            .iter()
            .map(|face| face.iter().any(|n| near.contains(n)))
            .collect()
    }

    /// Returns the position of a point of the rule on a face with these current nodes, mm.
    pub(super) fn position(&self, point: usize, current: &[Vector]) -> Vector {
        interpolate(&self.rule[point], current)
    }

    /// Friction's traction at a touching point of a face; `None` while it has no anchor.
    pub(super) fn traction(
        &self,
        ground: &HeightField,
        anchors: &[[f64; 2]],
        [face, point]: [usize; 2],
        touch: &Touch,
    ) -> Option<Traction> {
        let anchor = anchors.get(face * self.rule.len() + point)?;
        let slip = touch.slip(anchor, &ground.shift);
        Some(self.friction.traction(slip, touch.pressure))
    }

    /// Visits the points of a face that penetrate: number of the point, its reference area (mm^2) and its state.
    pub(super) fn for_each_touch(
        &self,
        ground: &HeightField,
        face: usize,
        current: &[Vector],
        mut visit: impl FnMut(usize, f64, &Touch),
    ) {
        for (index, point) in self.rule.iter().enumerate() {
            let place = ground.axes.coordinates(interpolate(point, current));
            let Some(height) = ground.near(place) else {
                continue;
            };
            let [x, y, z] = place;
            let penetration = height.value - z;
            if penetration > 0.0 {
                let (pressure, pressure_slope) = self.penalty.pressure(penetration);
                let touch = Touch {
                    penetration,
                    pressure,
                    pressure_slope,
                    height,
                    position: [x, y],
                };
                visit(index, self.areas[face * self.rule.len() + index], &touch);
            }
        }
    }
}

/// State of one touching point.
pub(super) struct Touch {
    /// Depth below the ground, mm.
    pub(super) penetration: f64,
    /// Contact pressure, MPa.
    pub(super) pressure: f64,
    /// Derivative of the pressure by the penetration, N/mm^3.
    pub(super) pressure_slope: f64,
    /// The ground's height there.
    pub(super) height: Height,
    /// Position along the ground's x and y axis, mm.
    pub(super) position: [f64; 2],
}

impl Touch {
    /// Returns the gradient of the gap in the body's axes: along the ground's normal, and one along its z axis.
    pub(super) fn gradient(&self, axes: &GroundAxes) -> Vector {
        let [x, y] = self.height.slope;
        axes.to_body([-x, 0.0 - y, 1.0])
    }

    /// Way from the anchor along the ground's x and y axis, mm; the anchor is given on the ground, which is dragged by `shift`.
    pub(super) fn slip(&self, anchor: &[f64; 2], shift: &[f64; 2]) -> [f64; 2] {
        [0, 1].map(|i| self.position[i] - (anchor[i] + shift[i]))
    }
}

/// Position of a point of a face with these current nodes, mm.
pub(super) fn interpolate(point: &FacePoint, current: &[Vector]) -> Vector {
    let mut at = [0.0; 3];
    for (position, n) in current.iter().zip(&point.values) {
        for i in 0..3 {
            at[i] += n * position[i];
        }
    }
    at
}
