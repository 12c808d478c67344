//! The unreinforced tire of the peers' benchmark.
//!
//! `deck SIZE` prints it as a CalculiX deck, which is the mesh file of all programs. `solve SIZE` solves it from nothing,
//! then a neighbouring point of a study, and prints figures and times as JSON. `read SIZE FILE` reads the same strains off
//! another program's displacements: 3 numbers a node, first of the inflated tire, then of the pressed one.

use std::process::ExitCode;
use std::sync::atomic::AtomicBool;
use std::time::Instant;

use calculix::deck::Deck;
use calculix::rigid_ground::RigidGround;
use fem::cell::element::Order;
use fem::cell::mesh::SurfacePoint;
use fem::newton::iteration::Newton;
use fem::newton::path::{Stability, follow};
use fem::problem::{Loads, State};
use fem::surface::chart::Recovery;
use fem_client::scene::{Geometry, Material, Scene};
use serde_json::{Value, json};
use tire::mesh::tire_grid::{Extent, MeshPlan};
use tire::model::{TireModel, ground};

/// Radius of the uninflated crown: 50 mm to the section's centre and 20 mm to its outer surface.
const CROWN_RADIUS: f64 = 70.0;
/// Section angle at which the wall is clamped, degrees from the crown.
const BEAD_ANGLE: f64 = 125.0;
/// Depth of the ground below the undeformed crown, mm.
const DEPTH: f64 = 4.0;
/// Height at which the ground waits for the tire to be inflated, mm: the crown comes down to -71.
const PARKED: f64 = -72.0;

/// Depth of a neighbouring point of a study, over this one's.
const NEIGHBOUR: f64 = 1.1;
/// Largest relative residual of an equilibrium; the other programs' too.
const TOLERANCE: f64 = 1e-6;

/// Bricks: fine and coarse along the wheel, from crown to bead, through the wall.
const SIZES: [(&str, [usize; 4]); 3] = [
    ("small", [14, 10, 16, 4]),
    ("middle", [24, 16, 28, 6]),
    ("large", [36, 24, 45, 8]),
];

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let words: Vec<&str> = arguments.iter().map(String::as_str).collect();
    match run(&words) {
        Ok(text) => {
            println!("{text}");
            ExitCode::SUCCESS
        }
        Err(error) => {
            eprintln!("{error}");
            ExitCode::FAILURE
        }
    }
}

fn run(words: &[&str]) -> Result<String, String> {
    match words {
        ["deck", size] => Ok(deck(&model(size)?)),
        ["solve", size] => solve(size).map(|answer| answer.to_string()),
        ["read", size, file] => read(size, file).map(|answer| answer.to_string()),
        _ => Err(
            "usage: deck SIZE | solve SIZE | read SIZE FILE; SIZE is small, middle or large".into(),
        ),
    }
}

fn scene() -> Scene {
    let mut scene = Scene {
        geometry: Geometry {
            outer_radius_mm: CROWN_RADIUS,
            section_radius_mm: 20.0,
            wall_mm: 8.0,
            bead_angle_deg: BEAD_ANGLE,
            ..Geometry::default()
        },
        // kappa / mu = 100 with mu = 0.36 MPa.
        material: Material {
            d1_per_mpa: 2.0 / 36.0,
            ..Material::default()
        },
        ..Scene::default()
    };
    scene.pressure.internal_mpa = 0.04;
    scene.contact.penalty_n_per_mm3 = Some(100.0);
    scene.ground.depths_mm = vec![DEPTH; 5];
    scene
}

fn model(size: &str) -> Result<TireModel, String> {
    let found = SIZES.iter().find(|(name, _)| *name == size);
    let (_, [fine, coarse, meridional, layers]) =
        *found.ok_or_else(|| format!("no size {size:?}"))?;
    let plan = MeshPlan {
        order: Order::Linear,
        fine_angle: 0.6,
        fine,
        middle: None,
        coarse,
        meridional,
        meridional_growth: 3.0,
        layers,
    };
    Ok(TireModel::new(&scene(), &plan, Extent::Quarter))
}

fn deck(model: &TireModel) -> String {
    let scene = scene();
    let field = ground(&scene.ground, CROWN_RADIUS);
    let rigid = RigidGround::new(&field, 1.5 * CROWN_RADIUS, PARKED);
    Deck {
        problem: &model.problem,
        rubber: &scene.material,
        pressure: scene.pressure.internal_mpa,
        ground: Some(&rigid),
    }
    .text()
}

/// The tire inflated, then pressed by a depth in mm.
fn loads(depth: f64) -> [Loads; 2] {
    let mut scene = scene();
    scene.ground.depths_mm = vec![depth; scene.ground.stations];
    let inflated = Loads {
        pressure: scene.pressure.internal_mpa,
        ..Loads::default()
    };
    let pressed = Loads {
        ground: Some(ground(&scene.ground, CROWN_RADIUS)),
        ..inflated.clone()
    };
    [inflated, pressed]
}

fn solve(size: &str) -> Result<Value, String> {
    let begin = Instant::now();
    let model = model(size)?;
    let [inflation, pressing] = loads(DEPTH);
    let reference = State::reference(&model.problem);
    let mut newton = Newton::for_contact(&model.problem, &reference, &pressing)
        .map_err(|error| error.to_string())?;
    newton.settings.tolerance = TOLERANCE;
    let unloaded = Loads::default();
    let inflated = walk(&mut newton, &reference, &unloaded, &inflation)?;
    let pressed = walk(&mut newton, &inflated, &inflation, &pressing)?;
    let wall = begin.elapsed().as_secs_f64();
    let effort = newton.effort;

    let mut answer = strains(&model, &inflated, &pressed);
    answer["wall_s"] = json!(wall);
    answer["iterations"] = json!(effort.iterations);
    answer["factorisations"] = json!(effort.factorisations);
    answer["factorisation_s"] = json!(effort.factorisation.as_secs_f64());
    answer["substitution_s"] = json!(effort.substitution.as_secs_f64());
    answer["assembly_s"] = json!(effort.assembly.as_secs_f64());
    answer["reaction_n"] = json!(reaction(&model, &pressed, &pressing)?);
    answer["warm_wall_s"] = json!(warm(&model, &mut newton, &pressed, &pressing)?);
    Ok(answer)
}

/// Time of a neighbour that starts from an equilibrium and its tangent, s.
fn warm(
    model: &TireModel,
    newton: &mut Newton<'_>,
    pressed: &State,
    pressing: &Loads,
) -> Result<f64, String> {
    let tangent = newton
        .tangent_at(pressed, pressing)
        .map_err(|cause| format!("{cause:?}"))?;
    let begin = Instant::now();
    let mut near =
        Newton::with_tangent(&model.problem, tangent).map_err(|error| error.to_string())?;
    near.settings.tolerance = TOLERANCE;
    let [_, deeper] = loads(NEIGHBOUR * DEPTH);
    walk(&mut near, pressed, pressing, &deeper)?;
    Ok(begin.elapsed().as_secs_f64())
}

fn walk(
    newton: &mut Newton<'_>,
    from: &State,
    start: &Loads,
    target: &Loads,
) -> Result<State, String> {
    let mut state = from.clone();
    let stop = AtomicBool::new(false);
    follow(newton, &mut state, start, target, Stability::Ignored, &stop)
        .map_err(|failure| format!("{failure:?}"))?;
    Ok(state)
}

/// Force of the ground on the quarter, N.
fn reaction(model: &TireModel, pressed: &State, loads: &Loads) -> Result<f64, String> {
    let (Some(contact), Some(field)) = (&model.problem.contact, &loads.ground) else {
        return Err("no contact".into());
    };
    let mesh = &model.problem.mesh;
    let resultant = contact.resultant(field, |node| pressed.position(mesh, node));
    Ok(resultant.load)
}

/// Total stretches minus one at the centre of the inner surface, and those since inflation.
fn strains(model: &TireModel, inflated: &State, pressed: &State) -> Value {
    let mesh = &model.problem.mesh;
    let centre: SurfacePoint = model.grid.inner_point(0.0, 0.0);
    let [before, after] = [inflated, pressed].map(|state| {
        Recovery::new(&model.chart, mesh, |node| state.position(mesh, node)).at(centre)
    });
    let radius = -inflated.position(mesh, model.grid.lowest_node())[2];
    json!({
        "nodes": mesh.nodes.len(),
        "inflated_radius_mm": radius,
        "x": after.s1 - 1.0,
        "y": after.s2 - 1.0,
        "x_since_inflation": after.s1 / before.s1 - 1.0,
        "y_since_inflation": after.s2 / before.s2 - 1.0,
    })
}

fn read(size: &str, file: &str) -> Result<Value, String> {
    let model = model(size)?;
    let text = std::fs::read_to_string(file).map_err(|error| format!("{file}: {error}"))?;
    let numbers = text
        .split_ascii_whitespace()
        .map(|word| {
            word.parse::<f64>()
                .map_err(|error| format!("{word:?}: {error}"))
        })
        .collect::<Result<Vec<_>, _>>()?;
    let nodes = model.problem.mesh.nodes.len();
    if numbers.len() != 6 * nodes {
        return Err(format!(
            "{file} has {} numbers, not {}",
            numbers.len(),
            6 * nodes
        ));
    }
    let state = |values: &[f64]| {
        let mut state = State::reference(&model.problem);
        for (u, v) in state.displacement.iter_mut().zip(values.chunks_exact(3)) {
            u.copy_from_slice(v);
        }
        state
    };
    let (first, second) = numbers.split_at(3 * nodes);
    Ok(strains(&model, &state(first), &state(second)))
}
