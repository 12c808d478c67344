//! Anchors of friction from one load step to the next: where each point's spring stands on the ground, in coordinates that go with the ground when it is
//! dragged.

use super::contact_surface::{ContactSurface, interpolate};
use crate::load::obstacle::{GroundAxes, HeightField};
use crate::tensor::Vector;

impl ContactSurface {
    /// Returns the places of friction's anchors on the ground (x, y, mm) once the body rests at these positions: of a point in contact where its law
    /// puts it, of any other below the point itself. Without friction there are none.
    pub(crate) fn settled_anchors(
        &self,
        ground: Option<&HeightField>,
        positions: impl Fn(u32) -> Vector,
        anchors: &[[f64; 2]],
    ) -> Vec<[f64; 2]> {
        let mut settled = Vec::new();
        if self.friction.coefficient == 0.0 {
            return settled;
        }
        let shift = ground.map_or([0.0; 2], |ground| ground.shift);
        let axes = ground.map_or(GroundAxes::LEVEL, |ground| ground.axes);
        let on_ground = |position: [f64; 2]| [0, 1].map(|i| position[i] - shift[i]);
        for (face, nodes) in self.surface.iter().enumerate() {
            let current: Vec<Vector> = nodes.iter().map(|&n| positions(n)).collect();
            let first = settled.len();
            settled.extend(self.rule.iter().map(|point| {
                let [x, y, _] = axes.coordinates(interpolate(point, &current));
                on_ground([x, y])
            }));
            let Some(ground) = ground else { continue };
            self.for_each_touch(ground, face, &current, |index, _, touch| {
                if let Some(anchor) = anchors.get(first + index) {
                    let slip = touch.slip(anchor, &shift);
                    let anchor = self.friction.anchor(touch.position, slip, touch.pressure);
                    settled[first + index] = on_ground(anchor);
                }
            });
        }
        settled
    }
}
