//! A tire without carcass close to the pressure that it can't bear, and beyond it.
//!
//! A tire gives way in one of three ways: its pressure has a maximum, it buckles before that, or its rubber stiffens
//! first and the pressure only levels off. All pressures beyond must name the same one, and pressures below it must hold.

use std::sync::atomic::AtomicBool;

use fem::cell::element::Order;

use super::draft::{Bench, Refusal, reference};
use crate::family::Unsolved;
use crate::known_case::Case;
use crate::mesh_refinement::Refinement;
use fem_client::scene::{Law, Scene};
use fem_client::solver::NoEquilibrium;
use tire::mesh::tire_grid::MeshPlan;
use tire::model::mesh_plan;

/// Wall, mm.
const WALL: f64 = 5.0;
/// Second constants of the rubber, MPa: one buckles, one stiffens (the shipped one).
const RUBBERS: [f64; 2] = [0.024, 0.036];
/// Pressures beyond the one named, over it.
const BEYOND: [f64; 3] = [1.03, 1.1, 1000.0];
/// Share of the pressure named that must hold: the bracket of a buckling pressure is 2 % wide.
const BELOW: f64 = 0.979;
/// Width of that bracket.
const BRACKET: f64 = 0.02;
/// Pressures that an independent code reached with the shipped rubber (wall in mm, MPa).
const INDEPENDENT: [(f64, f64); 3] = [(3.0, 0.112), (5.0, 0.2094), (7.0, 0.339)];
/// Half of the last digit of them, over the smallest.
const QUOTED: f64 = 0.0005 / 0.112;
/// Bricks along a quarter of the wheel.
const FINE: usize = 4;

fn scene(wall: f64, second_constant: f64, pressure: f64) -> Scene {
    let mut scene = reference();
    scene.carcass = None;
    if let Law::MooneyRivlin { c01_mpa, .. } = &mut scene.material.law {
        *c01_mpa = second_constant;
    }
    scene.geometry.wall_mm = wall;
    scene.pressure.internal_mpa = pressure;
    scene.ground.depths_mm.fill(0.0);
    scene
}

/// Quadratic elements of even size; `n` along a quarter of the wheel's circumference.
fn even_plan(n: usize) -> MeshPlan {
    MeshPlan {
        order: Order::Quadratic,
        fine_angle: std::f64::consts::FRAC_PI_2,
        fine: n,
        middle: None,
        coarse: n,
        meridional: 2 * n,
        meridional_growth: 1.0,
        layers: n / 2,
    }
}

/// Returns the cases below the pressure named, beyond it, and against another code.
pub(super) fn cases(stop: &AtomicBool) -> Result<Vec<Case>, Unsolved> {
    let mut cases = Vec::new();
    for second_constant in RUBBERS {
        cases.extend(around(second_constant, stop)?);
    }
    cases.extend(independent(stop)?);
    Ok(cases)
}

/// The reason why a pressure doesn't hold, which must be a physical one.
fn end(bench: &Bench<'_>, scene: &Scene, plan: &MeshPlan) -> Result<Refusal, Unsolved> {
    let refusal = bench.refusal_on(scene, plan)?;
    match refusal.status {
        NoEquilibrium::LimitPoint | NoEquilibrium::Overstretched => Ok(refusal),
        _ => Err(Unsolved::Other(refusal.text())),
    }
}

/// Returns the cases of one rubber.
fn around(second_constant: f64, stop: &AtomicBool) -> Result<Vec<Case>, Unsolved> {
    let bench = Bench::usual(stop);
    let asked = scene(WALL, second_constant, 1.0);
    let draft = mesh_plan(&asked, asked.model.level);
    let named = end(&bench, &asked, &draft)?;
    let limit = named.reached.pressure_mpa;
    let rubber = format!("wall {WALL} mm, C01 = {second_constant} MPa");
    let mut cases = Vec::new();
    for share in BEYOND {
        let refusal = end(&bench, &scene(WALL, second_constant, share * limit), &draft)?;
        let name = format!("{rubber}, {share} times what ends inflation: pressure named, MPa");
        let case = Case::relative(name, refusal.reached.pressure_mpa, limit).within(
            BRACKET,
            "the same, asked for 1 MPa; tolerance: the bracket of a buckling pressure",
        );
        cases.push(case.ended(refusal.text()));
    }
    let held = scene(WALL, second_constant, BELOW * limit);
    let inflated = bench.solve(&held)?.response.inflated;
    let more = scene(WALL, second_constant, 0.99 * BELOW * limit);
    let before = bench.solve(&more)?.response.inflated;
    let grows = inflated.outer_radius_mm > before.outer_radius_mm;
    let name = format!("{rubber}, {BELOW} of what ends inflation: holds, and has grown");
    let case = Case::absolute(name, f64::from(u8::from(grows)), 1.0);
    cases.push(case.within(
        0.0,
        "a stable equilibrium, larger than that of 1 % less pressure",
    ));
    Ok(cases)
}

/// The pressure at which three walls of the shipped rubber give way, which has no maximum but levels off.
fn independent(stop: &AtomicBool) -> Result<Vec<Case>, Unsolved> {
    let bench = Bench::usual(stop);
    let mut cases = Vec::new();
    for (wall, theirs) in INDEPENDENT {
        let asked = scene(wall, RUBBERS[1], 1.0);
        let [coarse, fine] = [FINE / 2, FINE].map(|n| end(&bench, &asked, &even_plan(n)));
        let (coarse, fine) = (coarse?, fine?);
        let [rough, pressure] = [&coarse, &fine].map(|end| end.reached.pressure_mpa);
        // The clamped corners are singular: the order is below that of the elements, but at least 1.
        let bound = Refinement::new(vec![rough], vec![pressure], 2.0).bound(1.0);
        let name = format!("shipped rubber, wall {wall} mm: pressure that ends inflation, MPa");
        let case = Case::relative(name, pressure, theirs).within(
            bound + QUOTED,
            "independent code; tolerance: two meshes, and the digits quoted",
        );
        cases.push(case.ended(fine.text()));
    }
    Ok(cases)
}
