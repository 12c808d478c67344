//! Studies with a virtual rig: what is said of each layout's forces.

use documents::layouts::layout_settings::Layouts;
use documents::rig::gait_settings::RunLength;
use documents::rig::rig_settings::RigSettings;
use documents::study::Study;
use fem_client::closed_form::ClosedFormSolver;
use fem_client::solver::{SolveError, SolveRequest, Solved, Solver};
use results::StudyResult;

use crate::support::{MemoryArchive, observed, shipped, text};

/// The closed form, which presses to depths, with the depths of its own loads: 13 N at 1 mm, with the power of 1.3.
struct PressedByLoad;

impl Solver for PressedByLoad {
    fn version(&self) -> String {
        "pressed by load".to_owned()
    }

    fn solve(&self, request: &SolveRequest<'_>) -> Result<Solved, SolveError> {
        let mut scene = request.scene.clone();
        if let Some(load_n) = scene.ground.load_n.take() {
            scene.ground.stations = 1;
            scene.ground.depths_mm = vec![(load_n / 13.0).powf(1.0 / 1.3)];
        }
        ClosedFormSolver::new().solve(&SolveRequest {
            scene: &scene,
            ..*request
        })
    }
}

/// Two regular layouts at the crown on a tire whose ground has no friction; two short runs.
fn rigged() -> Study {
    let mut rig = RigSettings::default();
    rig.gait.length = RunLength::Stances(8);
    rig.runs = 2;
    let layouts = Layouts {
        films: Vec::new(),
        spacings_deg: Vec::new(),
        units: vec![2, 12],
        positions: Vec::new(),
        section_deg: vec![0.0],
        ..Layouts::default()
    };
    let mut study = Study {
        layouts,
        rig: Some(rig),
        ..shipped("foot-tire")
    };
    study.scene.contact.friction = 0.0;
    study
}

fn answered_on(threads: usize) -> StudyResult {
    let archive = MemoryArchive::default();
    observed(&rigged(), &PressedByLoad, &archive, threads)
        .0
        .unwrap()
}

#[test]
fn each_layout_says_how_well_it_tells_the_forces() {
    let result = answered_on(1);
    let forces = result.forces.as_ref().unwrap();
    assert!(forces.table.is_some(), "{:?}", forces.reasons);
    assert!(
        forces
            .assumed
            .iter()
            .any(|text| text.contains("2 runs of 8 stances"))
    );
    assert_eq!(result.layouts.len(), 2);
    for layout in &result.layouts {
        let errors = layout.force_error.as_ref().unwrap();
        let axes: Vec<&str> = errors.iter().map(|error| error.axis.as_str()).collect();
        assert_eq!(axes, ["fx", "fy", "fz"]);
        for error in errors {
            assert!(
                error.fresh.rmse_n.is_some() || error.reason.is_some(),
                "{error:?}"
            );
        }
    }
    // Each has its own: of two units one is near the contacts, of twelve a second one is amid them.
    let vertical_n = |units: usize| {
        let layout = result.layouts.iter().find(|layout| layout.units == units);
        layout.unwrap().force_error.as_ref().unwrap()[2]
            .fresh
            .rmse_n
            .unwrap()
    };
    assert!(
        vertical_n(12) < vertical_n(2),
        "{} {}",
        vertical_n(12),
        vertical_n(2)
    );
    let read: StudyResult = serde_json::from_str(&serde_json::to_string(&result).unwrap()).unwrap();
    assert_eq!(read.layouts, result.layouts);
    assert_eq!(text(&answered_on(2)), text(&result));
}
