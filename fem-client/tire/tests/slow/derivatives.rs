//! Derivatives of responses, against central differences of solved scenes.

use std::collections::BTreeMap;
use std::sync::atomic::AtomicBool;

use fem::newton::iteration::NewtonSettings;
use fem_client::scene::{Level, Scene};
use fem_client::solver::derivative::Derivative;
use fem_client::solver::sides::Sides;
use fem_client::solver::{Grid, Readout, Response, RingLine, SolveError, SolveRequest, Solver};
use serde_json::{Value, json};
use tire::embedded::EmbeddedSolver;

static RUNNING: AtomicBool = AtomicBool::new(false);

/// Step of the central differences, relative to the number: its square is far below the bound, and few contact points open or close in it.
const STEP: f64 = 3e-5;
/// Relative residual of their equilibria. It leaves a hundred times as much in a force; over the step, 1e-6 of the force over the number.
const TOLERANCE: f64 = 3e-13;
/// Largest error of a derivative: relative to the largest of its kind, or to the largest value over the number where that is more.
const BOUND: f64 = 1e-6;

fn scene(level: Level, changes: &[(&str, Value)]) -> Scene {
    let mut scene = Scene::preset("foot-tire").expect("ships");
    scene.model.level = level;
    let changes: Vec<_> = changes.iter().map(|(path, value)| (*path, value)).collect();
    if !changes.is_empty() {
        scene.set_all(&changes).expect("a scene");
    }
    scene
}

fn readout(derivatives: &[&str]) -> Readout {
    Readout {
        grid: Some(Grid {
            circumferential: 5,
            meridional: 3,
            half_width_deg: 30.0,
        }),
        rings: vec![RingLine::at(30.0)],
        gauges: vec!["3,20,30".parse().expect("a gauge")],
        derivatives: derivatives.iter().map(|by| (*by).to_owned()).collect(),
        ..Readout::default()
    }
}

fn solved(scene: &Scene, readout: &Readout) -> Result<Response, SolveError> {
    let settings = NewtonSettings {
        tolerance: TOLERANCE,
        ..EmbeddedSolver::settings()
    };
    let request = SolveRequest {
        scene,
        readout,
        start: None,
        watch: &RUNNING,
    };
    let solved = EmbeddedSolver::with_settings(settings).solve(&request);
    solved.map(|solved| solved.response)
}

/// The derivative by differences of two solves.
fn differenced(scene: &Scene, by: &str) -> Derivative {
    let value = scene.number_at(by).expect("a number");
    let half_step = match value == 0.0 {
        true => STEP,
        false => STEP * value.abs(),
    };
    let scenes = [-half_step, half_step].map(|step| {
        let mut side = scene.clone();
        side.set(by, &json!(value + step)).expect("a scene");
        side
    });
    let [low, high] = scenes
        .each_ref()
        .map(|scene| solved(scene, &readout(&[])).expect("an equilibrium"));
    let sides = Sides {
        by: by.to_owned(),
        scenes,
        half_step,
    };
    sides.derivative([&low, &high])
}

fn numbers(name: &str, value: &Value, found: &mut BTreeMap<String, Vec<f64>>) {
    match value {
        Value::Number(number) => {
            let number = number.as_f64().expect("a double");
            found.entry(name.to_owned()).or_default().push(number);
        }
        Value::Array(values) => values.iter().for_each(|value| numbers(name, value, found)),
        Value::Object(fields) => {
            for (name, value) in fields {
                numbers(name, value, found);
            }
        }
        _ => {}
    }
}

/// All numbers of a document by the name of their field.
fn kinds(value: Value) -> BTreeMap<String, Vec<f64>> {
    let mut found = BTreeMap::new();
    numbers("", &value, &mut found);
    found
}

/// Compares the solver's derivatives with differences.
fn check(scene: &Scene, paths: &[&str]) {
    let found = solved(scene, &readout(paths)).expect("an equilibrium");
    assert_eq!(found.derivatives.len(), paths.len());
    let values = kinds(json!(found));
    for derivative in &found.derivatives {
        let number = scene.number_at(&derivative.by).expect("a number").abs();
        let expected = differenced(scene, &derivative.by);
        let both = [derivative, &expected];
        let [found, expected] = both.map(|derivative| kinds(json!(derivative.of)));
        assert!(found.keys().eq(expected.keys()) && found.contains_key("reaction_n"));
        for (kind, expected) in &expected {
            let largest = |values: &[f64]| values.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
            // A moment is what forces before and behind the centre leave of each other: it is as sure as they are, at their arm.
            let value = match kind.as_str() {
                "moment_nmm" => scene.geometry.outer_radius_mm * largest(&values["reaction_n"]),
                _ => largest(&values[kind]),
            };
            let of_value = value / if number == 0.0 { 1.0 } else { number };
            let scale = largest(expected).max(of_value);
            let errors: Vec<f64> = found[kind]
                .iter()
                .zip(expected)
                .map(|(a, b)| a - b)
                .collect();
            let error = largest(&errors) / scale;
            println!("{} {kind}: off by {error:.1e} of {scale:e}", derivative.by);
            assert!(
                error <= BOUND,
                "{kind} by {}: off by {error:e}",
                derivative.by
            );
        }
    }
}

/// Derivatives by numbers of ground, pressure, laws and shape; where one breaks the symmetry of a quarter, too.
#[test]
fn derivatives_are_those_of_differences() {
    check(
        &scene(
            Level::Draft,
            &[
                ("ground.depths_mm", json!([0.8, 0.95, 1.03, 1.1, 0.9])),
                ("contact.penalty_n_per_mm3", json!(120.0)),
            ],
        ),
        &[
            "ground.depths_mm[1]",
            "ground.station_spacing_mm",
            "contact.penalty_n_per_mm3",
            "pressure.internal_mpa",
            "material.c10_mpa",
            "carcass.stiffness_n_per_mm",
            "carcass.angle_deg",
            "geometry.wall_mm",
            "geometry.outer_radius_mm",
        ],
    );
    check(
        &scene(Level::Draft, &[]),
        &["ground.depths_mm[0]", "geometry.bead_angle_deg"],
    );
}

/// Derivatives on quadratic bricks.
#[test]
fn derivatives_on_a_study_s_mesh_are_those_of_differences() {
    check(
        &scene(Level::Coarse, &[]),
        &["ground.depths_mm[2]", "material.c01_mpa"],
    );
}

/// Derivatives by numbers of a glued film, also where it leaves the middle plane, which takes the whole tire. Not by its size: that moves the mesh's lines, contact points open and close
/// between the two solves, and the differences change with their step.
#[test]
fn derivatives_of_a_glued_film_are_those_of_differences() {
    check(
        &scene(Level::Draft, &[("film", json!({}))]),
        &["film.modulus_mpa", "film.phi_deg"],
    );
}

/// The force is met on both sides, and the ground rises.
#[test]
fn derivatives_on_ground_that_presses_with_a_force_are_those_of_differences() {
    check(
        &scene(Level::Draft, &[("ground.load_n", json!(13.0))]),
        &[
            "ground.load_n",
            "pressure.internal_mpa",
            "geometry.section_radius_mm",
        ],
    );
}
