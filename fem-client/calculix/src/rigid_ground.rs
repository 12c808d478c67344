//! The rigid ground as a strip of bricks whose nodes are all held.

use fem::load::obstacle::HeightField;
use fem::tensor::Vector;

/// Facets between neighbouring stations of an uneven ground.
const FACETS_PER_STATION: f64 = 8.0;

/// A strip of bricks below the tire, parked where nothing touches it.
#[derive(Debug, Clone, PartialEq)]
pub struct RigidGround {
    /// Parked positions of the nodes, mm.
    pub nodes: Vec<[f64; 3]>,
    /// Corners of the bricks, lexicographic.
    pub bricks: Vec<[u32; 8]>,
    /// Distance from where it is parked, along its normal, mm.
    pub rise: f64,
    /// Way from there, mm.
    pub way: Vector,
}

impl RigidGround {
    /// The ground of a height field under a tire: it reaches `half_width` to all sides of the origin and is parked so that its
    /// highest point is at `parked` along its normal, mm.
    pub fn new(field: &HeightField, half_width: f64, parked: f64) -> Self {
        let lines = lines(field, half_width);
        let heights: Vec<f64> = lines.iter().map(|&x| field.height(x, 0.0).value).collect();
        let highest = heights.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let rise = highest - parked;
        let mut nodes = Vec::new();
        for (x, height) in lines.iter().zip(&heights) {
            for y in [-half_width, half_width] {
                for z in [height - half_width, *height] {
                    nodes.push(field.axes.to_body([*x, y, z - rise]));
                }
            }
        }
        let bricks = (0..lines.len() as u32 - 1)
            .map(|k| {
                // Along x, y, z: node 4 k + 2 j + i has the j-th y and the i-th z.
                [0, 4, 2, 6, 1, 5, 3, 7].map(|corner| 4 * k + corner)
            })
            .collect();
        Self {
            nodes,
            bricks,
            rise,
            way: field.axes.to_body([0.0, 0.0, rise]),
        }
    }
}

/// Returns the lines where facets meet: at the ends only when the ground is flat.
fn lines(field: &HeightField, half_width: f64) -> Vec<f64> {
    let flat = field.depths.iter().all(|depth| *depth == field.depths[0]);
    if flat {
        return vec![-half_width, half_width];
    }
    // Beyond two stations outside the last one the ground is constant.
    let reach = (0.5 * (field.depths.len() as f64 - 1.0) + 2.0) * field.spacing;
    let inner = reach.min(half_width);
    let facets = (2.0 * inner * FACETS_PER_STATION / field.spacing).ceil();
    let mut lines: Vec<f64> = (0..=facets as usize)
        .map(|k| inner * (2.0 * k as f64 / facets - 1.0))
        .collect();
    if half_width > inner {
        lines.insert(0, -half_width);
        lines.push(half_width);
    }
    lines
}

#[cfg(test)]
mod tests {
    use fem::load::ground_shape::Profile;

    use super::*;
    use fem::cell::element::Order;
    use fem::cell::mesh::Mesh;
    use fem::load::obstacle::{GroundAxes, StationFunctions};
    use fem::solid::SolidGeometry;

    fn field(depths: &[f64]) -> HeightField {
        HeightField {
            axes: GroundAxes::LEVEL,
            base: -50.0,
            spacing: 5.5,
            functions: StationFunctions::BSpline,
            depths: depths.to_vec(),
            shift: [0.0; 2],
            profile: Profile::Plane,
        }
    }

    fn volumes(ground: &RigidGround) -> Vec<f64> {
        let mesh = Mesh {
            order: Order::Linear,
            nodes: ground.nodes.clone(),
            bricks: ground.bricks.iter().flatten().copied().collect(),
        };
        let geometry = SolidGeometry::new(&mesh).expect("right-handed bricks");
        (0..ground.bricks.len())
            .map(|brick| geometry.volume(brick))
            .collect()
    }

    #[test]
    fn a_flat_ground_is_one_brick_that_rises_to_its_depth() {
        let ground = RigidGround::new(&field(&[1.0; 5]), 75.0, -51.0);
        let [volume] = volumes(&ground)[..] else {
            panic!("{} bricks", ground.bricks.len())
        };
        assert!((volume / (150.0 * 150.0 * 75.0) - 1.0).abs() < 1e-12);
        assert!((ground.rise - 2.0).abs() < 1e-12);
        let top = ground.nodes.iter().map(|node| node[2]).fold(-1e9, f64::max);
        assert!((top + 51.0).abs() < 1e-12);
    }

    #[test]
    fn ground_below_a_wheel_that_leans_rises_along_its_normal() {
        let level = field(&[1.0; 5]);
        let axes = GroundAxes::below(0.2);
        let leaning = HeightField { axes, ..level };
        let ground = RigidGround::new(&leaning, 75.0, -51.0);
        let [_, _, up] = axes.vectors();
        for (way, up) in ground.way.iter().zip(up) {
            assert!((way - 2.0 * up).abs() < 1e-12);
        }
        for node in ground.nodes.iter().skip(1).step_by(2) {
            let arrived = [0, 1, 2].map(|i| node[i] + ground.way[i]);
            assert!(leaning.gap(arrived).abs() < 1e-12);
        }
        assert!(volumes(&ground).iter().all(|volume| *volume > 0.0));
    }

    #[test]
    fn an_uneven_ground_arrives_at_its_heights_and_reaches_as_far() {
        let field = field(&[0.3, 1.9, 0.7, 1.1, 0.2]);
        let ground = RigidGround::new(&field, 75.0, -51.0);
        assert!(volumes(&ground).iter().all(|volume| *volume > 0.0));
        let tops = ground.nodes.iter().skip(1).step_by(2);
        for [x, _, z] in tops {
            assert!((z + ground.rise - field.height(*x, 0.0).value).abs() < 1e-12);
        }
        let ends = [ground.nodes[0][0], ground.nodes[ground.nodes.len() - 1][0]];
        assert_eq!(ends, [-75.0, 75.0]);
    }

    #[test]
    fn facets_stray_from_the_ground_with_the_square_of_their_length() {
        // A chord of length h strays by h^2 z'' / 8 at most; the splines' z'' is at most 4 depth differences over spacing^2.
        let field = field(&[0.3, 1.9, 0.7, 1.1, 0.2]);
        let ground = RigidGround::new(&field, 75.0, -51.0);
        let tops: Vec<[f64; 3]> = ground.nodes.iter().skip(1).step_by(4).copied().collect();
        let h = 1.0 / FACETS_PER_STATION;
        for pair in tops.windows(2) {
            let middle = [0, 2].map(|i| 0.5 * (pair[0][i] + pair[1][i]));
            let stray = middle[1] + ground.rise - field.height(middle[0], 0.0).value;
            assert!(
                stray.abs() <= h * h * 4.0 * 1.7 / 8.0,
                "{stray} at {}",
                middle[0]
            );
        }
    }
}
