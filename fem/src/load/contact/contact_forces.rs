//! Nodal forces and stiffness of the contact.

use super::contact_surface::{ContactSurface, Touch};
use crate::load::friction::Traction;
use crate::load::obstacle::{GroundAxes, HeightField};
use crate::tensor::Vector;

impl ContactSurface {
    /// Adds a face's nodal forces (N) and, when asked for, its stiffness (N/mm, by rows; symmetric without friction). Returns
    /// whether any point touches; without touch the buffers are left alone. `anchors` are those of all faces' points;
    /// none: no friction yet.
    pub fn integrate(
        &self,
        ground: &HeightField,
        face: usize,
        current: &[Vector],
        anchors: &[[f64; 2]],
        residual: &mut [f64],
        stiffness: Option<&mut [f64]>,
    ) -> bool {
        let mut stiffness = stiffness;
        let mut touches = false;
        self.for_each_touch(ground, face, current, |index, area, touch| {
            touches = true;
            let point = &self.rule[index];
            let gradient = touch.gradient(&ground.axes);
            let traction = self.traction(ground, anchors, [face, index], touch);
            let [tx, ty] = traction.map_or([0.0; 2], |traction| traction.value);
            let friction = ground.axes.to_body([tx, ty, 0.0]);
            let force_on_body = [0, 1, 2].map(|i| touch.pressure * gradient[i] + friction[i]);
            for (force, n) in residual.chunks_exact_mut(3).zip(&point.values) {
                for i in 0..3 {
                    force[i] -= area * n * force_on_body[i];
                }
            }
            if let Some(stiffness) = stiffness.as_deref_mut() {
                let mut block =
                    gradient.map(|gi| gradient.map(|gj| area * touch.pressure_slope * gi * gj));
                // Second derivatives of the gap are those of the ground's height but for the sign, times phi' = -pressure.
                add_curvature(&mut block, area * touch.pressure, touch, &ground.axes);
                if let Some(traction) = traction {
                    let by_pressure = (touch.pressure_slope, &gradient);
                    add_friction(&mut block, &traction, &ground.axes, area, by_pressure);
                }
                add_outer(&point.values, &block, stiffness);
            }
        });
        touches
    }
}

/// Adds a load (N) times the second derivatives of the ground's height to a point's stiffness.
fn add_curvature(block: &mut [[f64; 3]; 3], load: f64, touch: &Touch, axes: &GroundAxes) {
    let [along, across, _] = axes.vectors();
    let [xx, xy, yy] = touch.height.curvature;
    for i in 0..3 {
        for j in 0..3 {
            let mixed = along[i] * across[j] + across[i] * along[j];
            let curvature = xx * along[i] * along[j] + xy * mixed + yy * across[i] * across[j];
            block[i][j] += load * curvature;
        }
    }
}

/// Takes the derivative of friction's traction by the position off a point's stiffness. The pressure grows with the
/// penetration: by minus the gradient of the gap.
fn add_friction(
    block: &mut [[f64; 3]; 3],
    traction: &Traction,
    axes: &GroundAxes,
    area: f64,
    (pressure_slope, gradient): (f64, &Vector),
) {
    let [along, across, _] = axes.vectors();
    let tangents = [along, across];
    let [tx, ty] = traction.by_pressure;
    let by_pressure = axes.to_body([tx, ty, 0.0]);
    for i in 0..3 {
        for j in 0..3 {
            for (a, b) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
                let by_slip = traction.by_slip[a][b];
                block[i][j] -= area * by_slip * tangents[a][i] * tangents[b][j];
            }
            block[i][j] += area * by_pressure[i] * pressure_slope * gradient[j];
        }
    }
}

/// Adds b_a b_b `block` to a whole matrix stored by rows.
fn add_outer(b: &[f64], block: &[[f64; 3]; 3], stiffness: &mut [f64]) {
    let unknowns = 3 * b.len();
    for (row, target) in stiffness.chunks_exact_mut(unknowns).enumerate() {
        let (ba, block) = (b[row / 3], &block[row % 3]);
        for (values, bb) in target.chunks_exact_mut(3).zip(b) {
            for j in 0..3 {
                values[j] += ba * bb * block[j];
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cell::element::Order;
    use crate::cell::mesh::{Mesh, Surface};
    use crate::central_differences::{assert_upper_agrees, derivative};
    use crate::load::contact::{Penalty, Wrench};
    use crate::load::friction::Friction;
    use crate::load::ground_shape::{Profile, Round, Wave, Waves};
    use crate::load::obstacle::StationFunctions;

    fn patch() -> (Vec<Vector>, ContactSurface) {
        let order = Order::Quadratic;
        let nodes: Vec<Vector> = (0..9)
            .map(|a| [2.0 * f64::from(a % 3), 1.5 * f64::from(a / 3), 0.0])
            .collect();
        let mesh = Mesh {
            order,
            nodes: nodes.clone(),
            bricks: vec![],
        };
        let surface = Surface {
            order,
            faces: (0..9).collect(),
        };
        (
            nodes,
            ContactSurface::new(
                &mesh,
                surface,
                Penalty {
                    stiffness: 100.0,
                    ramp: 1e-3,
                },
            ),
        )
    }

    #[test]
    fn a_surface_that_just_touches_feels_nothing() {
        let (nodes, contact) = patch();
        let ground = HeightField {
            axes: GroundAxes::LEVEL,
            base: 0.0,
            spacing: 1.0,
            functions: StationFunctions::BSpline,
            depths: vec![0.0],
            shift: [0.0; 2],
            profile: Profile::Plane,
        };
        assert!(!contact.integrate(&ground, 0, &nodes, &[], &mut [0.0; 27], None));
    }

    #[test]
    fn a_flat_patch_transmits_a_constant_pressure() {
        let (nodes, contact) = patch();
        let ground = HeightField {
            axes: GroundAxes::LEVEL,
            base: 0.0,
            spacing: 1.0,
            functions: StationFunctions::BSpline,
            depths: vec![0.02; 3],
            shift: [0.0; 2],
            profile: Profile::Plane,
        };
        let resultant = contact.resultant(&ground, |n| nodes[n as usize]);
        let expected = 100.0 * (0.02 - 0.0005) * 12.0;
        let Wrench { force, moment } = resultant.wrench;
        assert!((force[2] - expected).abs() < 1e-13 * expected);
        assert!((resultant.load - expected).abs() < 1e-13 * expected);
        assert!(force[0].abs() < 1e-13);
        // About the origin, from which the patch's middle lies at (2, 1.5) mm.
        assert!((moment[0] - 1.5 * expected).abs() < 1e-12 * expected);
        assert!((moment[1] + 2.0 * expected).abs() < 1e-12 * expected);
        // Consistent nodal forces of a constant pressure on a 9-node face: corner 1/36, edge 1/9, middle 4/9.
        let mut residual = [0.0; 27];
        contact.integrate(&ground, 0, &nodes, &[], &mut residual, None);
        for (node, share) in [(0, 1.0 / 36.0), (1, 1.0 / 9.0), (4, 4.0 / 9.0)] {
            assert!((residual[3 * node + 2] + share * expected).abs() < 1e-13 * expected);
        }
    }

    #[test]
    fn a_peak_between_the_nodes_is_near() {
        let (nodes, contact) = patch();
        // of the nodes at 0, 2 and 4 mm none is below; the points of the rule next to 0 are at 0.45 mm or before
        let peak = |height: f64| HeightField {
            axes: GroundAxes::LEVEL,
            base: -0.01,
            spacing: 0.4,
            functions: StationFunctions::Hat,
            depths: vec![0.0, 0.0, height, 0.0, 0.0],
            shift: [0.0; 2],
            profile: Profile::Plane,
        };
        for (ground, near) in [(peak(1.0), true), (peak(0.0), false)] {
            // the peak itself lies at 0.4 mm
            let moved = nodes.iter().map(|[x, y, z]| [x - 0.4, *y, *z]);
            let moved: Vec<Vector> = moved.collect();
            let touches = contact.integrate(&ground, 0, &moved, &[], &mut [0.0; 27], None);
            let found = contact.faces_near(&ground, |n| moved[n as usize]);
            assert_eq!((touches, found), (near, vec![near]));
        }
    }

    /// Stiffness of the patch on a ground, and the derivative of its forces by steps of h.
    fn stiffness_and_differences(
        contact: &ContactSurface,
        ground: &HeightField,
        anchors: &[[f64; 2]],
        h: f64,
    ) -> (Vec<f64>, Vec<f64>) {
        let (nodes, _) = patch();
        let mut stiffness = vec![0.0; 27 * 27];
        let mut unused = [0.0; 27];
        contact.integrate(
            ground,
            0,
            &nodes,
            anchors,
            &mut unused,
            Some(&mut stiffness),
        );
        let differences = derivative(&nodes, h, |moved| {
            let mut residual = vec![0.0; 27];
            contact.integrate(ground, 0, moved, anchors, &mut residual, None);
            residual
        });
        (stiffness, differences)
    }

    #[test]
    fn stiffness_is_the_derivative_of_the_forces() {
        let round = Round {
            centre: [1.0, 0.5],
            radius: 6.0,
        };
        let profiles = [
            Profile::Plane,
            Profile::Sphere(round),
            Profile::Cylinder(round, [0.6, 0.8]),
            Profile::Edge(round, [-0.6, 0.8]),
            Profile::Waves(Waves::new(vec![Wave {
                amplitude: 0.2,
                vector: [0.7, -0.4],
                phase: 0.3,
            }])),
        ];
        for axes in [GroundAxes::LEVEL, GroundAxes::below(0.1)] {
            for profile in &profiles {
                assert_stiffness_without_friction(axes, profile.clone());
            }
        }
    }

    fn assert_stiffness_without_friction(axes: GroundAxes, profile: Profile) {
        let (_, contact) = patch();
        let ground = HeightField {
            axes,
            base: 0.1,
            spacing: 1.3,
            functions: StationFunctions::BSpline,
            depths: vec![0.3, 0.6, 0.4, 0.5, 0.7],
            shift: [0.0; 2],
            profile,
        };
        // Forces of order 100 N: round-off eps 100 / h = 2e-9, truncation h^2 100.
        let (stiffness, differences) = stiffness_and_differences(&contact, &ground, &[], 1e-5);
        assert_upper_agrees(&stiffness, &differences, 1e-7);
    }

    #[test]
    fn a_patch_that_goes_with_dragged_ground_feels_what_it_felt() {
        for axes in [GroundAxes::LEVEL, GroundAxes::below(0.1)] {
            assert_carried_alike(axes);
        }
    }

    fn assert_carried_alike(axes: GroundAxes) {
        let (nodes, mut contact) = patch();
        contact.friction = Friction {
            coefficient: 0.3,
            stiffness: 80.0,
        };
        let resting = HeightField {
            axes,
            base: 0.1,
            spacing: 1.3,
            functions: StationFunctions::BSpline,
            depths: vec![0.3, 0.6, 0.4, 0.5, 0.7],
            shift: [0.0; 2],
            profile: Profile::Plane,
        };
        let settled = contact.settled_anchors(Some(&resting), |n| nodes[n as usize], &[]);
        let anchors: Vec<[f64; 2]> = settled.iter().map(|[x, y]| [0.8 * x, *y]).collect();
        let at = |shift: [f64; 2]| {
            let ground = HeightField {
                shift,
                ..resting.clone()
            };
            let way = axes.to_body([shift[0], shift[1], 0.0]);
            let moved = nodes.iter().map(|node| [0, 1, 2].map(|i| node[i] + way[i]));
            let moved: Vec<Vector> = moved.collect();
            let (mut residual, mut stiffness) = (vec![0.0; 27], vec![0.0; 27 * 27]);
            let tangent = Some(stiffness.as_mut_slice());
            contact.integrate(&ground, 0, &moved, &anchors, &mut residual, tangent);
            let followed = contact.settled_anchors(Some(&ground), |n| moved[n as usize], &anchors);
            let friction = contact.friction_wrench(&ground, &anchors, |n| moved[n as usize]);
            let [x, y, _] = axes.coordinates(friction.force);
            let force = [x, y];
            let all = [residual, stiffness, followed.concat(), force.to_vec()];
            (all.concat(), force)
        };
        let ((still, force), (carried, _)) = (at([0.0; 2]), at([0.5, -0.25]));
        // Every point stands ahead of its anchor or on it: friction pulls back.
        assert!(force[0] < 0.0 && force[1].abs() < 1e-12, "{force:?}");
        for (a, b) in still.iter().zip(&carried) {
            // Positions of some mm, rounded, times stiffnesses of 100 N/mm^3 on 12 mm^2.
            assert!((a - b).abs() < 1e-11, "{a} {b}");
        }
    }

    #[test]
    fn the_stiffness_with_friction_is_the_derivative_of_the_forces() {
        for axes in [GroundAxes::LEVEL, GroundAxes::below(0.1)] {
            assert_stiffness_with_friction(axes);
        }
    }

    fn assert_stiffness_with_friction(axes: GroundAxes) {
        let (nodes, mut contact) = patch();
        contact.friction = Friction {
            coefficient: 0.3,
            stiffness: 80.0,
        };
        let ground = HeightField {
            axes,
            base: 0.1,
            spacing: 1.3,
            functions: StationFunctions::BSpline,
            depths: vec![0.3, 0.6, 0.4, 0.5, 0.7],
            shift: [0.0; 2],
            profile: Profile::Plane,
        };
        // Slips from 0 to 0.75 mm under pressures of 40 to 60 MPa: some points stick, some slip.
        let anchors: Vec<[f64; 2]> = contact
            .settled_anchors(Some(&ground), |n| nodes[n as usize], &[])
            .iter()
            .map(|[x, y]| [x - 0.2 * x, *y])
            .collect();
        let (stiffness, differences) = stiffness_and_differences(&contact, &ground, &anchors, 1e-6);
        let mut largest = 0.0f64;
        for row in 0..27 {
            for column in 0..27 {
                let (difference, value) =
                    (differences[row * 27 + column], stiffness[row * 27 + column]);
                // Forces of order 100 N: round-off eps 100 / h = 2e-8.
                assert!((difference - value).abs() < 1e-6, "{row} {column}");
                largest = largest.max((value - stiffness[column * 27 + row]).abs());
            }
        }
        assert!(largest > 1.0, "slipping makes the stiffness unsymmetric");
    }
}
