//! Studies with a virtual rig: what is said of each layout's forces.

use fem_client::closed_form::ClosedFormSolver;
use placement::layout::layout_settings::Layouts;
use placement::result::StudyResult;
use placement::rig::gait::gait_settings::RunLength;
use placement::rig::rig_settings::RigSettings;
use placement::study::Study;

use crate::support::{MemoryArchive, observed, shipped, text};

/// Two regular layouts at the crown on a tire whose ground has no friction; two short runs.
fn rigged() -> Study {
    let mut rig = RigSettings::default();
    rig.gait.length = RunLength::Stances(6);
    rig.runs = 2;
    let layouts = Layouts {
        spacings_deg: Vec::new(),
        units: vec![2, 6],
        positions: Vec::new(),
        section_deg: vec![0.0],
        ..Layouts::default()
    };
    let mut study = Study {
        layouts,
        rig: Some(rig),
        ..shipped("paper")
    };
    study.scene.contact.friction = 0.0;
    study
}

fn answered_on(threads: usize) -> StudyResult {
    let (solver, archive) = (ClosedFormSolver::new(), MemoryArchive::default());
    observed(&rigged(), &solver, &archive, threads).0.unwrap()
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
            .any(|text| text.contains("2 runs of 6 stances"))
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
    // Each has its own: more films, other signals.
    assert_ne!(result.layouts[0].force_error, result.layouts[1].force_error);
    let read: StudyResult = serde_json::from_str(&serde_json::to_string(&result).unwrap()).unwrap();
    assert_eq!(read.layouts, result.layouts);
    assert_eq!(text(&answered_on(2)), text(&result));
}
