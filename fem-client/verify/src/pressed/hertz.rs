//! Contact of a cylinder and of a ball with a rigid plane against Hertz, whose formulas hold in the limit of small contacts:
//! they neglect terms of the order of contact radius over body radius. (K. L. Johnson, Contact Mechanics, 1985, chapter 4.)

use std::f64::consts::PI;
use std::sync::atomic::AtomicBool;

use fem::cell::block::Block;
use fem::cell::element::Order;
use fem::problem::Problem;

use super::plate::{CONTACT_WIDTH, Pressing, touch};
use crate::body::{
    RUBBER, SHEAR_MODULUS, free_block, hold_coordinate_planes, quarter_circle, rubber,
};
use crate::family::Unsolved;
use crate::known_case::Case;
use crate::mesh_refinement::graded;

/// Radius of the cylinder and of the ball, mm.
pub(super) const RADIUS: f64 = 10.0;
/// Radius of the cylinder's clamped shaft, mm.
pub(super) const SHAFT: f64 = 4.0;
/// Half the width of the square that is cut out of the ball, mm.
pub(super) const CUT: f64 = 6.0;
/// E / (1 - nu^2) of an incompressible body, MPa.
pub(super) const MODULUS: f64 = 4.0 * SHEAR_MODULUS;

pub(super) const LINE_SOURCE: &str = "Hertz: a^2 = 4 F R / (pi E*), for a / R -> 0";
const LINE_FORCE_SOURCE: &str =
    "independent code; tolerance: difference of its two meshes, and the reach of its contact";
pub(super) const BALL_FORCE_SOURCE: &str = "Hertz: F = 4/3 E* R^(1/2) d^(3/2), for a / R -> 0";
pub(super) const BALL_SOURCE: &str = "Hertz: a^3 = 3 F R / (4 E*), for a / R -> 0";

/// A quarter of a cylinder on its shaft, between two plates, graded towards the contact.
fn cylinder() -> Problem {
    let (around, through) = (48, 16);
    let block = Block::new(Order::PlaneQuadratic, [around, 1, through], |s| {
        let radius = RADIUS + graded(s[2], through, 2.0) * (SHAFT - RADIUS);
        quarter_circle(graded(s[0], around, 3.0), radius)
    });
    let outside = block.side(2, false).flipped();
    let shaft = block.side(2, true);
    let mut problem = free_block(block, rubber(RUBBER, 0.0));
    hold_coordinate_planes(&mut problem);
    for &node in &shaft.faces {
        problem.supports[node as usize] = [Some(0.0); 3];
    }
    touch(&mut problem, outside);
    problem
}

/// The cylinder: force at a depth, and half width at a force.
pub(crate) fn line(stop: &AtomicBool) -> Result<Vec<Case>, Unsolved> {
    // Depth, and force per length from an independent code on two meshes: 12 x 30 and 16 x 48 elements.
    let published = [
        (0.03, [0.02363038666319081, 0.02385210644060156]),
        (0.06, [0.05073292772651462, 0.05106064444572043]),
        (0.12, [0.11550968454354144, 0.1158886708189272]),
        (0.24, [0.2776720203967622, 0.2784179122880809]),
    ];
    let problem = cylinder();
    let mut pressing = Pressing::new(&problem, RADIUS)?;
    let (mut forces, mut widths) = (Vec::new(), Vec::new());
    for (depth, [coarse, fine]) in published {
        pressing.to(depth, stop)?;
        let (half, moment) = pressing.moments(0);
        let force = 2.0 * half;
        // Second moment of the pressure p0 (1 - x^2/a^2)^(1/2): F a^2 / 4.
        let width = 2.0 * (moment / half).sqrt();
        let hertz = (4.0 * force * RADIUS / (PI * MODULUS)).sqrt();
        let name = format!("Hertz line, depth {depth} mm: half width, mm");
        widths.push((Case::relative(name, width, hertz), hertz));
        pressing.to(depth + CONTACT_WIDTH, stop)?;
        let reach = 2.0 * pressing.moments(0).0 / force - 1.0;
        let name = format!("Hertz line, depth {depth} mm: force, N/mm");
        let tolerance = f64::abs(fine / coarse - 1.0) + reach;
        forces.push(Case::relative(name, force, fine).within(tolerance, LINE_FORCE_SOURCE));
    }
    forces.extend(trend(widths, LINE_SOURCE));
    Ok(forces)
}

/// Judges cases of growing radius by what Hertz neglects, and the fall of each error from that of the next larger contact:
/// at least in proportion to the radius.
fn trend(cases: Vec<(Case, f64)>, source: &'static str) -> Vec<Case> {
    let errors: Vec<f64> = cases
        .iter()
        .map(|(case, _)| case.error.unwrap_or(f64::NAN))
        .collect();
    let radii: Vec<f64> = cases.iter().map(|(_, radius)| *radius).collect();
    let judge = |(k, (case, radius)): (usize, (Case, f64))| {
        let case = match radii.get(k + 1) {
            Some(larger) => {
                let slope = (errors[k + 1] / errors[k]).ln() / (larger / radius).ln();
                case.slope(slope, 1.0)
            }
            None => case,
        };
        case.within(radius / RADIUS, source)
    };
    cases.into_iter().enumerate().map(judge).collect()
}

/// A quarter of a ball's lower half, cut out as a square, held at the middle plane and graded to the contact.
fn ball_quarter() -> Problem {
    let (across, up) = (9, 7);
    let block = Block::new(Order::Quadratic, [across, across, up], |s| {
        let [x, y] = [s[0], s[1]].map(|t| CUT * graded(t, across, 2.0));
        let bottom = -(RADIUS * RADIUS - x * x - y * y).sqrt();
        [x, y, bottom * (1.0 - graded(s[2], up, 2.0))]
    });
    let bottom = block.side(2, false).flipped();
    let middle = block.side(2, true);
    let mut problem = free_block(block, rubber(RUBBER, 0.0));
    hold_coordinate_planes(&mut problem);
    for &node in &middle.faces {
        problem.supports[node as usize] = [Some(0.0); 3];
    }
    touch(&mut problem, bottom);
    problem
}

/// The ball: force at a depth, and radius of the contact at a force.
pub(crate) fn ball(stop: &AtomicBool) -> Result<Vec<Case>, Unsolved> {
    let problem = ball_quarter();
    let mut pressing = Pressing::new(&problem, RADIUS)?;
    let (mut forces, mut radii) = (Vec::new(), Vec::new());
    for depth in [0.05, 0.1, 0.2] {
        pressing.to(depth, stop)?;
        let (quarter, moment) = pressing.moments(0);
        let force = 4.0 * quarter;
        let radius = (RADIUS * depth).sqrt();
        let hertz = 4.0 / 3.0 * MODULUS * RADIUS.sqrt() * depth.powf(1.5);
        let name = format!("Hertz ball, depth {depth} mm: force, N");
        forces.push((Case::relative(name, force, hertz), radius));
        // Second moment about one axis of the pressure p0 (1 - r^2/a^2)^(1/2): F a^2 / 5.
        let contact = (5.0 * moment / quarter).sqrt();
        let hertz = (3.0 * force * RADIUS / (4.0 * MODULUS)).cbrt();
        let name = format!("Hertz ball, depth {depth} mm: radius of the contact, mm");
        let case = Case::relative(name, contact, hertz);
        radii.push(case.within(radius / RADIUS, BALL_SOURCE));
    }
    let mut cases = trend(forces, BALL_FORCE_SOURCE);
    cases.extend(radii);
    Ok(cases)
}
