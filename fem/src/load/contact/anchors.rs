//! What friction remembers from one load step to the next: where each point's spring stands on the ground.

use super::contact_surface::{ContactSurface, interpolate};
use crate::load::obstacle::HeightField;
use crate::tensor::Vector;

impl ContactSurface {
    /// Where the anchors of friction stand (x, y, mm) once the body rests at these positions: of a point in contact where its law
    /// puts it, of any other below the point itself. Without friction there are none.
    pub fn settled_anchors(
        &self,
        ground: Option<&HeightField>,
        positions: impl Fn(u32) -> Vector,
        anchors: &[[f64; 2]],
    ) -> Vec<[f64; 2]> {
        let mut settled = Vec::new();
        if self.friction.coefficient == 0.0 {
            return settled;
        }
        for (face, nodes) in self.surface.iter().enumerate() {
            let current: Vec<Vector> = nodes.iter().map(|&n| positions(n)).collect();
            let first = settled.len();
            settled.extend(self.rule.iter().map(|point| {
                let [x, y, _] = interpolate(point, &current);
                [x, y]
            }));
            let Some(ground) = ground else { continue };
            self.for_each_touch(ground, face, &current, |index, _, touch| {
                if let Some(anchor) = anchors.get(first + index) {
                    let slip = touch.slip(anchor);
                    settled[first + index] =
                        self.friction.anchor(touch.position, slip, touch.pressure);
                }
            });
        }
        settled
    }
}
