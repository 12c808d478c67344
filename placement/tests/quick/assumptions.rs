//! Assumptions that the figures of the layout that answers rest on, by closed formulas.

use documents::layouts::assumptions::Assumptions;
use documents::layouts::layout_settings::{LayoutLoads, Layouts, NoiseFloor};
use documents::study::Study;
use fem_client::solver::{NoEquilibrium, Position, Reached, SolveError, SolveRequest};
use results::{AssumptionChange, AssumptionFindings, StudyResult};

use crate::support::{MemoryArchive, Twisted, answered, observed, shipped};

/// Rings of y-films at the crown at one depth, mm.
fn rings(depths_mm: &[f64], change: impl FnOnce(&mut Layouts)) -> Study {
    let mut study = shipped("foot-tire");
    study.layouts = Layouts {
        films: Vec::new(),
        units: vec![18, 24],
        positions: vec![Position::Crown],
        directions: vec![vec![90.0]],
        loads: LayoutLoads::Depths(depths_mm.to_vec()),
        ..Layouts::default()
    };
    change(&mut study.layouts);
    study
}

fn findings(result: &StudyResult) -> &AssumptionFindings {
    let layouts = result.layout_findings.as_ref().unwrap();
    layouts.assumptions.as_ref().unwrap()
}

fn change<'r>(result: &'r StudyResult, of: &str) -> &'r AssumptionChange {
    let mut changes = findings(result).changes.iter();
    changes.find(|change| change.of == of).unwrap()
}

/// Angle and force of the layout that answers.
fn figures(result: &StudyResult) -> [f64; 2] {
    let layout = result.layout_of_rank(findings(result).rank).unwrap();
    let angle = layout.score.simulated_p95_angle_error_deg.unwrap();
    [angle, layout.worst_force.unwrap().error_n]
}

#[test]
fn a_changed_error_of_readings_is_that_of_a_study_that_assumes_it() {
    let depths_mm = [0.8, 1.2];
    let result = answered(&rings(&depths_mm, |_| {}));
    let found = findings(&result);
    assert_eq!(
        [found.angle_error_deg, found.force_error_n],
        figures(&result)
    );
    assert_eq!(found.unchanged, ["pressure", "camber", "friction", "film"]);
    let names: Vec<&str> = found
        .changes
        .iter()
        .map(|change| change.of.as_str())
        .collect();
    assert_eq!(names.len(), 4, "{names:?}");
    assert!(found.changes.is_sorted_by(|a, b| a.times >= b.times));
    let Assumptions {
        gain_std,
        place_std_deg,
        ..
    } = Assumptions::default();
    type Assume = Box<dyn FnOnce(&mut Layouts)>;
    let assumed: [(&str, Assume); 4] = [
        (
            "noise",
            Box::new(|own| own.noise.floor = NoiseFloor::Share(0.04)),
        ),
        (
            "drift",
            Box::new(|own| own.noise.floor = NoiseFloor::Share(0.02 * 2f64.sqrt())),
        ),
        ("gain", Box::new(move |own| own.noise.gain_std = gain_std)),
        (
            "place",
            Box::new(move |own| own.noise.place_std_deg = place_std_deg),
        ),
    ];
    for (name, assume) in assumed {
        let other = answered(&rings(&depths_mm, assume));
        let told = change(&result, name);
        let same = other.layouts.iter().find(|layout| {
            let own = result.layout_of_rank(found.rank).unwrap();
            layout.is_same(own)
        });
        let score = same.unwrap();
        let expected = [
            score.score.simulated_p95_angle_error_deg.unwrap(),
            score.worst_force.unwrap().error_n,
        ];
        for (told, expected) in [told.angle_error_deg, told.force_error_n]
            .into_iter()
            .zip(expected)
        {
            assert!(
                (told / expected - 1.0).abs() < 1e-9,
                "{name}: {told} {expected}"
            );
        }
    }
}

/// Strains at a tenth less of 0.2 MPa are 20/19 times as large, and the force 19/20: a reading that is without noise is believed to be of a depth, and so of a
/// force of 13 N d^1.3, that isn't there.
#[test]
fn a_pressure_that_nobody_knows_makes_the_force_that_the_formula_says() {
    let result = answered(&rings(&[1.0], |own| {
        own.noise.floor = NoiseFloor::Share(1e-4);
        own.assumptions = Assumptions {
            noise_factor: 1.0,
            drift_share: 0.0,
            gain_std: 0.0,
            place_std_deg: 0.0,
            pressure_factor: Some(0.9),
            camber_deg: None,
            friction: Some(0.5),
            film: None,
        };
    }));
    let softer: f64 = 20.0 / 19.0;
    let expected = 13.0 * (softer.powf(1.3) - 1.0 / softer);
    let found = change(&result, "pressure");
    // Fields between depths are cubics: within a thousandth of the force.
    assert!(
        (found.force_error_n - expected).abs() < 0.013,
        "{found:?} {expected}"
    );
    // The formula knows no friction.
    let found = change(&result, "friction");
    let assumed = findings(&result);
    assert_eq!(found.angle_error_deg, assumed.angle_error_deg);
    assert_eq!(assumed.unchanged, ["camber", "film"]);
    // Five depths, and the load as assumed with two changes: on the draft and without a coarser mesh.
    assert_eq!(result.cost.layout_solves, 5 + 3);
    let told = result.answer.unwrap().rests_on.unwrap();
    assert!(
        told.sentence.starts_with("As assumed "),
        "{}",
        told.sentence
    );
    assert_eq!(told.brief, "pressure: 1.55 N");
}

#[test]
fn a_limit_that_is_kept_no_more_is_told() {
    let mut study = rings(&[1.0], |_| {});
    let own = figures(&answered(&study));
    // Noise twice as large is an error twice as large.
    study.question.angle_deg = Some(1.5 * own[0]);
    let answer = answered(&study).answer.unwrap();
    assert!(
        answer.sentence.contains("twice the noise"),
        "{}",
        answer.sentence
    );
    assert!(
        answer.sentence.ends_with("they keep to that no more."),
        "{}",
        answer.sentence
    );
}

#[test]
fn a_changed_scene_without_an_equilibrium_costs_that_change_alone() {
    let leans = |request: &SolveRequest<'_>| {
        let tips = || SolveError::NoEquilibrium {
            status: NoEquilibrium::NotConverged,
            detail: "it tips over".to_owned(),
            reached: Reached::default(),
        };
        (request.scene.ground.camber_deg != 0.0).then(tips)
    };
    let study = rings(&[1.0], |own| {
        own.assumptions.camber_deg = Some(5.0);
        own.assumptions.pressure_factor = Some(0.9);
    });
    let solver = Twisted::new(leans);
    let (result, _) = observed(&study, &solver, &MemoryArchive::default(), 1);
    let result = result.unwrap();
    let found = findings(&result);
    assert_eq!(
        found.unchanged,
        ["camber: not-converged: it tips over", "friction", "film"]
    );
    assert_eq!(change(&result, "pressure").of, "pressure");
    assert_eq!(result.layouts.len(), 2);
}
