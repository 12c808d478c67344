//! Force of the ground on the body, and its penetration.

use super::contact_surface::ContactSurface;
use crate::load::obstacle::HeightField;
use crate::tensor::Vector;

/// Resultant of the contact.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct ContactResultant {
    /// Force of the ground on the body, N.
    pub force: Vector,
    /// Mean penetration, weighted by the contact pressure, mm.
    pub mean_penetration: f64,
    /// Largest penetration, mm.
    pub max_penetration: f64,
}

impl ContactSurface {
    /// Resultant over all faces at these current positions, without friction's part.
    pub fn resultant(
        &self,
        ground: &HeightField,
        positions: impl Fn(u32) -> Vector,
    ) -> ContactResultant {
        let mut total = ContactResultant::default();
        let mut current = Vec::with_capacity(self.surface.order.face_nodes());
        for (index, face) in self.surface.iter().enumerate() {
            current.clear();
            current.extend(face.iter().map(|&n| positions(n)));
            self.for_each_touch(ground, index, &current, |_, area, touch| {
                let force = area * touch.pressure;
                total.force[0] -= force * touch.slope;
                total.force[2] += force;
                total.mean_penetration += force * touch.penetration;
                total.max_penetration = total.max_penetration.max(touch.penetration);
            });
        }
        if total.force[2] > 0.0 {
            total.mean_penetration /= total.force[2];
        }
        total
    }

    /// Friction's part of the force on the body, along x and y, N: along the way of the ground that drags it.
    pub fn friction_force(
        &self,
        ground: &HeightField,
        anchors: &[[f64; 2]],
        positions: impl Fn(u32) -> Vector,
    ) -> [f64; 2] {
        let mut total = [0.0; 2];
        for (face, nodes) in self.surface.iter().enumerate() {
            let current: Vec<Vector> = nodes.iter().map(|&n| positions(n)).collect();
            self.for_each_touch(ground, face, &current, |index, area, touch| {
                if let Some(traction) = self.traction(ground, anchors, [face, index], touch) {
                    for i in 0..2 {
                        total[i] += area * traction.value[i];
                    }
                }
            });
        }
        total
    }
}
