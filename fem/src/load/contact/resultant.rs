//! Force and moment of the ground on the body, and its penetration.

use super::contact_surface::ContactSurface;
use crate::load::obstacle::HeightField;
use crate::tensor::{Vector, cross};

/// Sum of forces at points.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Wrench {
    /// Force, N.
    pub force: Vector,
    /// Moment about the origin, N mm.
    pub moment: Vector,
}

impl Wrench {
    fn add(&mut self, force: &Vector, at: &Vector) {
        let moment = cross(at, force);
        for i in 0..3 {
            self.force[i] += force[i];
            self.moment[i] += moment[i];
        }
    }
}

/// Resultant of the contact.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct ContactResultant {
    /// Force and moment of the ground on the body, in the body's axes.
    pub wrench: Wrench,
    /// Force along the ground's z axis, N.
    pub load: f64,
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
            self.for_each_touch(ground, index, &current, |point, area, touch| {
                let load = area * touch.pressure;
                let force = touch.gradient(&ground.axes).map(|g| load * g);
                total.wrench.add(&force, &self.position(point, &current));
                total.load += load;
                total.mean_penetration += load * touch.penetration;
                total.max_penetration = total.max_penetration.max(touch.penetration);
            });
        }
        if total.load > 0.0 {
            total.mean_penetration /= total.load;
        }
        total
    }

    /// Friction's force and moment on the body, in its axes: along the way of the ground that drags it.
    pub fn friction_wrench(
        &self,
        ground: &HeightField,
        anchors: &[[f64; 2]],
        positions: impl Fn(u32) -> Vector,
    ) -> Wrench {
        let mut total = Wrench::default();
        for (face, nodes) in self.surface.iter().enumerate() {
            let current: Vec<Vector> = nodes.iter().map(|&n| positions(n)).collect();
            self.for_each_touch(ground, face, &current, |index, area, touch| {
                if let Some(traction) = self.traction(ground, anchors, [face, index], touch) {
                    let [x, y] = traction.value.map(|t| area * t);
                    let force = ground.axes.to_body([x, y, 0.0]);
                    total.add(&force, &self.position(index, &current));
                }
            });
        }
        total
    }
}
