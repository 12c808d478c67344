//! A cylinder and a ball on a plane that leans, and a ball on a sphere there, against Hertz: it presses as a level one does, and towards their middle.

use std::f64::consts::{FRAC_PI_2, PI};
use std::sync::atomic::AtomicBool;

use fem::cell::block::Block;
use fem::cell::element::Order;
use fem::cell::mesh::Surface;
use fem::load::ground_shape::{Profile, Round};
use fem::load::obstacle::GroundAxes;
use fem::problem::Problem;

use super::hertz::{BALL_FORCE_SOURCE, BALL_SOURCE, CUT, LINE_SOURCE, MODULUS, RADIUS, SHAFT};
use super::plate::{Pressing, touch};
use crate::body::{RUBBER, free_block, rubber};
use crate::family::Unsolved;
use crate::known_case::Case;
use crate::mesh_refinement::graded;

/// Inclination of the plane, degrees.
const LEAN_DEG: f64 = 20.0;
/// Thickness of the slice of the cylinder, mm.
const SLICE: f64 = 0.25;
const OFFSET_SOURCE: &str = "Hertz: the force points to the middle, for a / R -> 0";

/// All cases.
pub(crate) fn cases(stop: &AtomicBool) -> Result<Vec<Case>, Unsolved> {
    let mut cases = line(stop)?;
    cases.extend(ball(None, stop)?);
    cases.extend(ball(Some(RADIUS), stop)?);
    Ok(cases)
}

/// A coordinate from -1 to 1 with its finest bricks at `middle`, for s from 0 to 1.
fn about(middle: f64, s: f64, bricks: usize, growth: f64) -> f64 {
    let half = bricks / 2;
    match s < 0.5 {
        true => middle - (middle + 1.0) * graded(1.0 - 2.0 * s, half, growth),
        false => middle + (1.0 - middle) * graded(2.0 * s - 1.0, half, growth),
    }
}

/// The lower half of a slice of the cylinder on its shaft, its axis along x, its bricks finest where the plane touches.
fn slice(lean: f64) -> Problem {
    let (around, through) = (64, 12);
    let block = Block::new(Order::Quadratic, [1, around, through], |s| {
        let radius = RADIUS + graded(s[2], through, 2.0) * (SHAFT - RADIUS);
        let angle = FRAC_PI_2 * about(-lean / FRAC_PI_2, s[1], around, 4.0);
        [SLICE * s[0], radius * angle.sin(), -radius * angle.cos()]
    });
    let outside = block.side(2, false).flipped();
    let shaft = block.side(2, true);
    let mut problem = free_block(block, rubber(RUBBER, 0.0));
    for support in &mut problem.supports {
        support[0] = Some(0.0);
    }
    held(problem, &shaft.faces, outside)
}

/// Half of the ball's lower half, x >= 0, cut out as a square, its bricks finest where the plane touches.
fn half_ball(lean: f64) -> Problem {
    let (along, across, up) = (9, 16, 7);
    let block = Block::new(Order::Quadratic, [along, across, up], |s| {
        let x = CUT * graded(s[0], along, 2.0);
        let y = CUT * about(-RADIUS * lean.sin() / CUT, s[1], across, 2.0);
        let bottom = -(RADIUS * RADIUS - x * x - y * y).sqrt();
        [x, y, bottom * (1.0 - graded(s[2], up, 2.0))]
    });
    let bottom = block.side(2, false).flipped();
    let middle = block.side(2, true);
    let mut problem = free_block(block, rubber(RUBBER, 0.0));
    for (support, x) in problem.supports.iter_mut().zip(&problem.mesh.nodes) {
        if x[0] == 0.0 {
            support[0] = Some(0.0);
        }
    }
    held(problem, &middle.faces, bottom)
}

/// Holds these nodes, and lets a surface touch ground that may lean.
fn held(mut problem: Problem, nodes: &[u32], surface: Surface) -> Problem {
    for &node in nodes {
        problem.supports[node as usize] = [Some(0.0); 3];
    }
    touch(&mut problem, surface);
    if let Some(contact) = &mut problem.contact {
        contact.may_push_across = true;
    }
    problem
}

/// The cylinder: half width of the contact at a force, and how far that passes the middle.
fn line(stop: &AtomicBool) -> Result<Vec<Case>, Unsolved> {
    let lean = LEAN_DEG.to_radians();
    let problem = slice(lean);
    let mut pressing = Pressing::leaning(&problem, RADIUS, GroundAxes::below(lean))?;
    let mut cases = Vec::new();
    for depth in [0.03, 0.06, 0.12, 0.24] {
        pressing.to(depth, stop)?;
        let (force, moment) = pressing.moments(1);
        // Second moment of the pressure p0 (1 - y^2/a^2)^(1/2): F a^2 / 4.
        let width = 2.0 * (moment / force).sqrt();
        let hertz = (4.0 * force / SLICE * RADIUS / (PI * MODULUS)).sqrt();
        let name = format!("leaning line, depth {depth} mm: half width, mm");
        cases.push(Case::relative(name, width, hertz).within(hertz / RADIUS, LINE_SOURCE));
        let name = format!("leaning line, depth {depth} mm: offset, mm");
        cases.push(offset(name, &pressing, hertz));
    }
    Ok(cases)
}

/// The ball on the plane, or on a rigid sphere of this radius there: force at a depth, half widths of the contact, and how far the force passes the middle.
fn ball(sphere: Option<f64>, stop: &AtomicBool) -> Result<Vec<Case>, Unsolved> {
    let lean = LEAN_DEG.to_radians();
    let problem = half_ball(lean);
    let round = |radius| {
        Profile::Sphere(Round {
            centre: [0.0; 2],
            radius,
        })
    };
    let mut pressing = Pressing::leaning(&problem, RADIUS, GroundAxes::below(lean))?
        .on(sphere.map_or(Profile::Plane, round));
    // Two rounds touch as one of this radius does a plane.
    let together = sphere.map_or(RADIUS, |other| RADIUS * other / (RADIUS + other));
    let what = match sphere {
        None => "leaning ball",
        Some(_) => "leaning ball on a sphere",
    };
    let mut cases = Vec::new();
    for depth in [0.05, 0.1, 0.2] {
        pressing.to(depth, stop)?;
        let force = 2.0 * pressing.resultant().load;
        let radius = (together * depth).sqrt();
        let hertz = 4.0 / 3.0 * MODULUS * together.sqrt() * depth.powf(1.5);
        let name = format!("{what}, depth {depth} mm: force, N");
        cases.push(Case::relative(name, force, hertz).within(radius / together, BALL_FORCE_SOURCE));
        let hertz = (3.0 * force * together / (4.0 * MODULUS)).cbrt();
        for (axis, along) in [(0, "along"), (1, "across")] {
            // Second moment about one axis of the pressure p0 (1 - r^2/a^2)^(1/2): F a^2 / 5.
            let (half, moment) = pressing.moments(axis);
            let contact = (5.0 * moment / half).sqrt();
            let name = format!("{what}, depth {depth} mm: radius {along}, mm");
            let case = Case::relative(name, contact, hertz);
            cases.push(case.within(radius / together, BALL_SOURCE));
        }
        let name = format!("{what}, depth {depth} mm: offset, mm");
        cases.push(offset(name, &pressing, radius));
    }
    Ok(cases)
}

/// Judges how far the force passes the body's middle by what Hertz neglects, for a contact of this radius, mm.
fn offset(name: String, pressing: &Pressing<'_>, radius: f64) -> Case {
    let found = pressing.resultant();
    let case = Case::absolute(name, found.wrench.moment[0] / found.load, 0.0);
    case.within(radius * radius / RADIUS, OFFSET_SOURCE)
}
