//! Omissions, modelled: the effects that a study states are those of the finer mesh within a factor of two.

use std::sync::atomic::AtomicBool;

use document::Format;
use documents::study::Study;
use documents::study::plan::Plan;
use fem_client::scene::{Level, Scene};
use fem_client::solver::{Readout, Response, SolveRequest, Solver};
use placement::ladder::climb;
use placement::ladder::effects::effect;
use placement::points::RunContext;
use placement::points::memory::MemoryArchive;
use tire::embedded::EmbeddedSolver;

/// Two inputs and the cheapest method; `changes` are laid over the shipped tire.
fn study(changes: &str) -> Study {
    let document = format!(
        r#"{{"name": "left out", "scene": {{"preset": "foot-tire"{changes}}},
            "inputs": [{{"name": "middle", "vary": "ground.depths_mm[2]",
                        "distribution": {{"kind": "uniform", "min": 0.8, "max": 1.2}}}}],
            "layouts": {{"spacings_deg": []}}, "method": {{"kind": "mdrm", "nodes": 3, "check_points": 0}},
            "accuracy": {{"preset": "coarse"}}}}"#
    );
    let read = |path: &str| Err(format!("{path}: not needed"));
    Study::from_document(&document, Format::Json, &read).expect("a study")
}

fn solved(scene: &Scene) -> Response {
    let stop = AtomicBool::new(false);
    let request = SolveRequest {
        scene,
        readout: &Readout::default(),
        start: None,
        watch: &stop,
    };
    let solved = EmbeddedSolver::default().solve(&request);
    solved.expect("an equilibrium").response
}

/// The effects that a study of the tire states beside the same of the standard mesh.
fn stated_and_true(study: &Study) -> Vec<(String, f64, f64)> {
    let solver = EmbeddedSolver::default();
    let stop = AtomicBool::new(false);
    let plan = Plan::new(study).expect("a plan");
    let context = RunContext {
        solver: &solver,
        archive: &MemoryArchive::default(),
        threads: 2,
        stop: &stop,
        pause: None,
        observer: &|_| (),
    };
    let result = climb::answer(study, &plan, context).expect("an answer");
    let mut cut = plan.points[0].clone();
    cut.model.level = Level::Standard;
    let plain = solved(&cut);
    let compared = solver.omissions(&cut).into_iter().map(|omission| {
        let choices = &result.model.left_out;
        let choice = choices.iter().find(|choice| choice.what == omission.what);
        let stated = choice.and_then(|choice| choice.effect);
        let richer = solved(&omission.richer.expect("fits the reference tire"));
        let truth = effect(&plain, &richer).expect("strains");
        (omission.what.to_owned(), stated.expect("measured"), truth)
    });
    compared.collect()
}

#[test]
#[ignore = "takes half a minute"]
fn effects_of_what_is_left_out_hold_within_a_factor_of_two() {
    let with_cords = stated_and_true(&study(""));
    let names: Vec<&str> = with_cords.iter().map(|(what, ..)| what.as_str()).collect();
    assert_eq!(names, ["friction", "film stiffness", "compressibility"]);
    let bare = stated_and_true(&study(
        r#", "carcass": null, "pressure": {"internal_mpa": 0.06}"#,
    ));
    assert!(bare.iter().any(|(what, ..)| what == "carcass"));
    let mut off = Vec::new();
    for (what, stated, truth) in with_cords.into_iter().chain(bare) {
        println!("{what}: stated {stated:.5}, on the standard mesh {truth:.5}");
        if !(0.5..2.0).contains(&(stated / truth)) {
            off.push(what);
        }
    }
    assert!(off.is_empty(), "{off:?}");
}
