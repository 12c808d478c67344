//! Walls from 1/100 to 1/2 of the section's radius.
//!
//! - An inflated cylinder has an exact pressure at any wall.
//! - A tire without carcass whose wall is thin carries its pressure as a membrane. On a torus with the section's radius r, its centre
//!   at R from the axle, the tensions at the crown are statically determined (W. Flugge, Stresses in Shells, 1973, section 2.2):
//!
//!   > N_y = p r (2 R + r) / (2 (R + r)),   N_x = p r / 2,
//!
//!   and an incompressible wall of thickness t strains by (N_x - N_y / 2) / (3 mu t) along x, (N_y - N_x / 2) / (3 mu t) along y, for small
//!   strains, up to terms like t / r.
//! - The forces of ground, pressure and beads are in balance.
//! - The pressure that such a tire can't carry falls with its wall.

use std::sync::atomic::AtomicBool;

use fem::cell::element::Order;
use fem::newton::iteration::Newton;
use fem::problem::{Loads, State};
use fem::tensor::norm;

use super::draft::{Bench, TOLERANCE, reference};
use super::trend::{Limit, Point};
use crate::body::SHEAR_MODULUS;
use crate::cylinder;
use crate::family::Unsolved;
use crate::known_case::Case;
use crate::mesh_refinement::Refinement;
use fem_client::scene::{Level, Scene};
use fem_client::solver::direction::Direction;
use fem_client::solver::{NoEquilibrium, Solved};
use tire::mesh::tire_grid::{Extent, MeshPlan};
use tire::model::{TireModel, mesh_plan};

/// Wall over section radius.
const WALLS: [f64; 7] = [0.5, 1.0 / 3.0, 0.2, 0.1, 0.05, 0.02, 0.01];
/// The first of them that is thin.
const THIN: usize = 3;
/// Strain p r / (3 mu t) of the tires that are compared with a membrane: the formula is linear.
const SMALL: f64 = 1e-4;
/// Strain p r / (3 mu t) of the tires that are pressed.
const MODERATE: f64 = 0.05;
/// Depth of the pressed tires over the section's radius.
const DEPTH: f64 = 0.02;
/// Relative tolerance of the cylinders' equilibria: errors below it have no slope.
const NEWTON: f64 = 1e-10;
/// Walls that are pressed on two levels.
const TWO_LEVELS: [f64; 3] = [0.5, 0.1, 0.02];

/// A tire without carcass of this wall (over the section's radius) that strains by about so much.
fn scene(wall: f64, strain: f64) -> Scene {
    let mut scene = reference();
    scene.carcass = None;
    let section = scene.geometry.section_radius_mm;
    scene.geometry.wall_mm = wall * section;
    scene.pressure.internal_mpa = strain * 3.0 * SHEAR_MODULUS * wall;
    scene.ground.depths_mm = vec![DEPTH * section; scene.ground.stations];
    scene
}

/// All walls.
pub(super) fn cases(stop: &AtomicBool) -> Result<Vec<Case>, Unsolved> {
    let mut cases = cylinders(stop)?;
    cases.extend(membranes(stop)?);
    for wall in WALLS {
        cases.push(pressed(wall, stop)?);
    }
    for wall in TWO_LEVELS {
        cases.extend(two_levels(wall, stop)?);
    }
    cases.extend(overloaded(stop)?);
    Ok(cases)
}

/// Cylinders of the section's radius, inflated by a fifth.
fn cylinders(stop: &AtomicBool) -> Result<Vec<Case>, Unsolved> {
    const OUTER: f64 = 12.5;
    let fifth = cylinder::STRETCHES
        .iter()
        .position(|s| *s == 1.2)
        .unwrap_or_default();
    let mut cases = Vec::new();
    for wall in WALLS {
        let radii = [OUTER * (1.0 - wall), OUTER];
        let quarter = |n| cylinder::quarter(Order::PlaneQuadratic, n, radii, |place| place);
        let pressures = |n| cylinder::pressures(&quarter(n), stop);
        let (coarse, fine) = (pressures(4)?, pressures(8)?);
        let expected = cylinder::STRETCHES.map(|stretch| cylinder::exact(radii, stretch));
        let computed = fine[fifth];
        let meshes = Refinement::new(coarse, fine, 2.0);
        let name = format!("cylinder, wall {wall:.3} of the radius, stretch 1.2: pressure, MPa");
        let case = Case::relative(name, computed, expected[fifth]);
        let clear = case.error.is_some_and(|error| error > NEWTON);
        let slope = if clear {
            meshes.slope(&expected)
        } else {
            f64::NAN
        };
        let tolerance = meshes.bound(4.0) + NEWTON;
        cases.push(case.slope(slope, 4.0).within(tolerance, cylinder::SOURCE));
    }
    Ok(cases)
}

/// Mesh that is even along the wheel, around which inflation is constant; fine enough across it for the bending at the bead.
const EVEN: MeshPlan = MeshPlan {
    order: Order::Quadratic,
    fine_angle: std::f64::consts::FRAC_PI_2,
    fine: 4,
    middle: None,
    coarse: 4,
    meridional: 48,
    meridional_growth: 1.0,
    layers: 1,
};

/// Strains of thin walls against those of a membrane.
fn membranes(stop: &AtomicBool) -> Result<Vec<Case>, Unsolved> {
    let bench = Bench::tight(stop);
    let (mut along, mut across) = (Vec::new(), Vec::new());
    for &wall in &WALLS[THIN..] {
        let mut scene = scene(wall, SMALL);
        scene.ground.depths_mm = vec![0.0; scene.ground.stations];
        let inflated = bench.solve_on(&scene, &EVEN)?.response.inflated;
        let [x, y] = membrane_strains(&scene);
        let point = |stretch: f64, strain: f64| Point {
            label: format!("tire, wall {wall:.3} of the section"),
            parameter: 1.0 / wall,
            value: (stretch - 1.0) / strain,
        };
        along.push(point(inflated.crown_stretch.x, x));
        across.push(point(inflated.crown_stretch.y, y));
    }
    let law = Limit {
        value: 1.0,
        // Strains have terms of second order.
        noise: 3.0 * SMALL,
        order: 1.0,
        source: "membrane of a torus; the difference falls like wall over section",
    };
    let mut cases = law.cases("inflated x strain at the crown over a membrane's", &along);
    cases.extend(law.cases("inflated y strain at the crown over a membrane's", &across));
    Ok(cases)
}

/// Strains x and y of a membrane in the middle of the wall.
fn membrane_strains(scene: &Scene) -> [f64; 2] {
    let geometry = &scene.geometry;
    let axis = geometry.outer_radius_mm - geometry.section_radius_mm;
    let radius = geometry.section_radius_mm - 0.5 * geometry.wall_mm;
    let load = scene.pressure.internal_mpa * radius;
    let (x, y) = (
        0.5 * load,
        load * (2.0 * axis + radius) / (2.0 * (axis + radius)),
    );
    let stiffness = 3.0 * SHEAR_MODULUS * geometry.wall_mm;
    [(x - 0.5 * y) / stiffness, (y - 0.5 * x) / stiffness]
}

/// The balance of forces of a tire pressed on the draft mesh.
fn pressed(wall: f64, stop: &AtomicBool) -> Result<Case, Unsolved> {
    let scene = scene(wall, MODERATE);
    let plan = mesh_plan(&scene, Level::Draft);
    let solved = Bench::tight(stop).solve_on(&scene, &plan)?;
    let name = format!("pressed tire, wall {wall:.3} of the section");
    balance(&name, &scene, &plan, &solved)
}

/// Strains of a pressed tire on the standard mesh against those on a finer one.
fn two_levels(wall: f64, stop: &AtomicBool) -> Result<Vec<Case>, Unsolved> {
    let bench = Bench::usual(stop);
    let scene = scene(wall, MODERATE);
    let [rough, fine] = [Level::Standard, Level::Reference]
        .map(|level| bench.solve_on(&scene, &mesh_plan(&scene, level)));
    let (rough, fine) = (rough?.response, fine?.response);
    let (rough, fine) = (&rough.locations[2], &fine.locations[2]);
    let errors = rough.error.zip(fine.error);
    let (rough_error, fine_error) =
        errors.ok_or_else(|| Unsolved::Other("strains without errors".to_owned()))?;
    let case = |direction| {
        let name = format!(
            "pressed tire, wall {wall:.3} of the section, standard mesh: {direction} strain at P3"
        );
        Case::absolute(name, rough.strain[direction], fine.strain[direction]).within(
            rough_error.strain[direction] + fine_error.strain[direction],
            "reference mesh; tolerance: the errors that both state",
        )
    };
    Ok(Direction::ALL.map(case).to_vec())
}

/// Vertical forces of beads and pressure on the tire against the ground's.
fn balance(name: &str, scene: &Scene, plan: &MeshPlan, solved: &Solved) -> Result<Case, Unsolved> {
    let model = TireModel::new(scene, plan, Extent::Quarter);
    let unfit = || Unsolved::Other("a state that doesn't fit its mesh".to_owned());
    let inflated = model.fit(&solved.state.inflated).ok_or_else(unfit)?;
    let state = model.fit(&solved.state.equilibrium).ok_or_else(unfit)?;
    let loads = Loads {
        pressure: scene.pressure.internal_mpa,
        ground: Some(model.ground_below(&scene.ground, &inflated)),
        ..Loads::default()
    };
    let mut newton = Newton::for_contact(&model.problem, &state, &loads)?;
    newton
        .start_from(&state, &loads)
        .map_err(|cause| Unsolved::Load {
            reached: 1.0,
            cause,
        })?;
    let held: f64 = newton
        .reactions(&state, &loads)
        .iter()
        .map(|force| force[2])
        .sum();
    // The residual holds minus the loads.
    let (pressed, carried) = pressure_force(&model, &state, loads.pressure);
    let others = held - pressed;
    let case = Case::relative(
        format!("{name}: force of the ground, N"),
        solved.response.reaction_n,
        model.multiplicity() * -others,
    );
    let share = solved.response.reaction_n / model.multiplicity() / carried;
    Ok(case.within(
        TOLERANCE / share,
        "balance with beads and pressure; tolerance: Newton's, over the ground's share of all loads",
    ))
}

/// Vertical force of the pressure on the model, and the sum of its nodal forces' sizes, N.
fn pressure_force(model: &TireModel, state: &State, pressure: f64) -> (f64, f64) {
    let Some(surface) = &model.problem.pressure else {
        return (0.0, 0.0);
    };
    let (mut force, mut size) = (0.0, 0.0);
    for nodes in surface.surface.iter() {
        let positions: Vec<_> = nodes
            .iter()
            .map(|&n| state.position(&model.problem.mesh, n))
            .collect();
        let mut residual = vec![0.0; 3 * nodes.len()];
        surface.integrate(pressure, &positions, &mut residual, None);
        for nodal in residual.chunks_exact(3) {
            force -= nodal[2];
            size += norm(&[nodal[0], nodal[1], nodal[2]]);
        }
    }
    (force, size)
}

/// Thin walls under the shipped pressure: the reason is named, and what they could carry falls with the wall.
fn overloaded(stop: &AtomicBool) -> Result<Vec<Case>, Unsolved> {
    let bench = Bench::usual(stop);
    let mut cases = Vec::new();
    let mut carried: Vec<f64> = Vec::new();
    // Each half of the one before.
    for wall in [0.08, 0.04, 0.02, 0.01] {
        let mut scene = scene(wall, SMALL);
        scene.pressure.internal_mpa = reference().pressure.internal_mpa;
        let refusal = bench.refusal(&scene)?;
        let true_reason = matches!(
            refusal.status,
            NoEquilibrium::LimitPoint | NoEquilibrium::Overstretched
        );
        if !true_reason {
            return Err(Unsolved::Other(refusal.text()));
        }
        carried.push(refusal.reached.pressure_mpa / (SHEAR_MODULUS * wall));
        if let [.., before, rough, now] = carried[..] {
            let name = format!(
                "tire, wall {wall} of the section at 0.2 MPa: limit pressure / (mu wall / section)"
            );
            let expected = 1.5 * rough - 0.5 * before;
            let case = Case::relative(name, now, expected);
            let tolerance = 0.5 * (rough / before - 1.0).abs();
            let case = case.within(tolerance, "linear in the wall, from walls twice and four times as thick; tolerance: the step it makes");
            cases.push(case.ended(refusal.text()));
        }
    }
    Ok(cases)
}
