//! Solves in a process of their own, by the real program: the same to the bit as in this one.

use std::process::Command;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;
use std::time::Duration;

use fem_client::scene::{Film, Scene};
use fem_client::solver::gauge::Gauge;
use fem_client::solver::{
    Grid, Readout, RingLine, SolveError, SolveRequest, Solved, Solver, StartState,
};
use serde_json::{Value, json};
use service::solving::isolated::child::ARGUMENT;
use service::solving::isolated::parent::Isolated;
use service::solving::solver_choice::{SolverName, solver};

/// Time far beyond what a draft takes.
const LIMIT: Duration = Duration::from_secs(600);

fn program() -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_strainsite"));
    command.arg(ARGUMENT);
    command
}

fn scene(changes: &[(&str, Value)]) -> Scene {
    let mut scene = Scene::preset("foot-tire").expect("ships");
    let draft = json!("draft");
    let mut changes: Vec<_> = changes.iter().map(|(path, value)| (*path, value)).collect();
    changes.push(("model.level", &draft));
    scene.set_all(&changes).expect("a scene");
    scene
}

/// All that can be read of a scene: derivatives without friction alone.
fn readout(scene: &Scene) -> Readout {
    let derivatives = ["pressure.internal_mpa".to_owned()];
    let is_rough = scene.contact.friction > 0.0;
    Readout {
        grid: Some(Grid {
            circumferential: 7,
            meridional: 5,
            half_width_deg: 40.0,
        }),
        shape: true,
        positions: true,
        rings: vec![RingLine::at(45.0)],
        fine_deg: None,
        gauges: vec![Gauge {
            theta_deg: 3.1,
            phi_deg: -7.7,
            angle_deg: 1.0 / 3.0,
        }],
        films: vec![Film {
            phi_deg: 45.0,
            ..Film::default()
        }],
        derivatives: derivatives.into_iter().filter(|_| !is_rough).collect(),
    }
}

/// Answers both ways.
fn both(scene: &Scene, start: Option<&StartState>) -> [Result<Solved, SolveError>; 2] {
    let here = solver(SolverName::Embedded, LIMIT).expect("a solver");
    let isolated = Isolated::new(Arc::clone(&here), program);
    let request = SolveRequest {
        scene,
        readout: &readout(scene),
        start,
        watch: &AtomicBool::new(false),
    };
    [here.solve(&request), isolated.solve_isolated(&request)]
}

/// The response as stored, in which every float has the digits of its bits, and the state's bytes.
fn bits(solved: &Solved) -> (String, Vec<u8>) {
    let text = serde_json::to_string(&solved.response).expect("JSON");
    (text, solved.state.to_bytes())
}

#[test]
fn an_answer_from_a_process_of_its_own_is_the_same_to_the_bit() {
    let cut = scene(&[]);
    let [here, isolated] = both(&cut, None).map(|solved| solved.expect("an equilibrium"));
    assert_eq!(bits(&isolated), bits(&here));
    let neighbours = [
        scene(&[("ground.depths_mm", json!([1.1, 1.0, 1.2, 0.9, 0.7]))]),
        scene(&[("contact.friction", json!(0.3))]),
        scene(&[("geometry.wall_mm", json!(2.9))]),
    ];
    for neighbour in &neighbours {
        let start = Some(&here.state);
        let solved = both(neighbour, start).map(|solved| bits(&solved.expect("an equilibrium")));
        assert_eq!(solved[1], solved[0]);
    }
}

#[test]
fn so_is_the_reason_why_there_is_none() {
    let bare = scene(&[("carcass.stiffness_n_per_mm", json!(0.001))]);
    let [here, isolated] = both(&bare, None).map(|solved| solved.map(|_| ()));
    assert!(
        matches!(here, Err(SolveError::NoEquilibrium { .. })),
        "{here:?}"
    );
    assert_eq!(isolated, here);
}

#[test]
fn what_is_no_order_gets_no_answer() {
    let child = program().stdin(std::process::Stdio::null()).output();
    let child = child.expect("the program runs");
    assert_eq!(child.status.code(), Some(1));
    assert!(child.stdout.is_empty());
}
