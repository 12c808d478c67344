//! Layouts of glued films: what a tire of known transfer gives, and what documents say.

use documents::study::Study;
use documents::study::plan::PlannedStudy;
use fem_client::closed_form::ClosedFormSolver;
use fem_client::solver::direction::PerDirection;
use fem_client::solver::{RingLine, SolveError, SolveRequest, Solved, Solver};
use placement::estimate::Workload;
use results::{StrainRing, StudyResult};
use serde_json::{Value, json};

use crate::glued::known_films::{MoreBeside, beyond_v, depth_of_load_mm, glued, tension};
use crate::support::{MemoryArchive, observed};

/// A tire whose meridional strain grows faster than the other, so that two loads tell the directions apart; unless it is `proportional` to that.
struct KnownTransfer {
    proportional: bool,
}

impl Solver for KnownTransfer {
    fn version(&self) -> String {
        format!("known transfer, {}", self.proportional)
    }

    fn solve(&self, request: &SolveRequest<'_>) -> Result<Solved, SolveError> {
        let (mut scene, mut readout) = (request.scene.clone(), request.readout.clone());
        let film = scene.film.take();
        readout
            .rings
            .extend(film.iter().map(|film| RingLine::at(film.phi_deg)));
        let mut solved = ClosedFormSolver::new().solve(&SolveRequest {
            scene: &scene,
            readout: &readout,
            ..*request
        })?;
        let depth = scene.ground.depths_mm.first().copied().unwrap_or_default();
        for ring in &mut solved.response.rings {
            let PerDirection { x, y } = &mut ring.strain;
            for (x, y) in x.iter().zip(y) {
                *y = if self.proportional {
                    2.0 * x
                } else {
                    *y * (1.0 + depth)
                };
            }
        }
        if let (Some(film), Some(ring)) = (film, solved.response.rings.last()) {
            let (x, y) = (ring.strain.x[180], ring.strain.y[180]);
            let strain = if film.angle_deg == 0.0 {
                [x, y]
            } else {
                [y, x]
            };
            solved.response.film = Some(glued(&film, strain));
        }
        Ok(solved)
    }
}

fn document(layouts: &Value, film: Value) -> Value {
    let mut common =
        json!({"units": [6], "section_deg": [0], "depths_mm": [0.5, 1], "level": "draft"});
    for (name, value) in layouts.as_object().unwrap() {
        common[name] = value.clone();
    }
    json!({
        "name": "films",
        "scene": {"preset": "foot-tire", "film": film},
        "inputs": [{
            "name": "P3",
            "vary": "ground.depths_mm[2]",
            "distribution": {"kind": "uniform", "min": 0.7, "max": 1.3},
        }],
        "layouts": common,
        "method": {"kind": "mdrm", "nodes": 3, "check_points": 0},
        "accuracy": {"preset": "draft"},
    })
}

/// A film so small that its mean is its middle's.
fn tiny() -> Value {
    json!({"length_mm": 1e-3, "width_mm": 1e-3})
}

fn read(document: &Value) -> Study {
    Study::from_value(document, &|path| Err(path.to_owned())).unwrap()
}

fn answered(study: &Study, proportional: bool) -> StudyResult {
    let archive = MemoryArchive::default();
    let solver = KnownTransfer { proportional };
    observed(study, &solver, &archive, 2).0.unwrap()
}

#[test]
fn a_known_transfer_makes_volts_of_strains_around_the_whole_wheel() {
    let bare = answered(&read(&document(&json!({"film": "bare"}), tiny())), false);
    let study = read(&document(&json!({"film": "transfer"}), tiny()));
    let result = answered(&study, false);
    let [bare_findings, findings] = [&bare, &result].map(|r| r.layout_findings.as_ref().unwrap());
    assert_eq!(
        (&bare_findings.unit[..], &findings.unit[..]),
        ("strain", "V")
    );
    assert_eq!(findings.size_mm, Some([1e-3, 1e-3]));
    let [bare_rings, rings] = [bare_findings, findings].map(|f| &f.rings);
    let of = |rings: &[StrainRing], direction: &str| -> Vec<f64> {
        let ring = rings.iter().find(|ring| ring.direction == direction);
        ring.unwrap().strain.clone()
    };
    let (x, y) = (of(bare_rings, "x"), of(bare_rings, "y"));
    let (volts_x, volts_y) = (of(rings, "x"), of(rings, "y"));
    // The manual's constants: V = (d31 N1 + d32 N2) / permittivity.
    let volts = |strain| {
        let [n, m] = tension(strain);
        (23.0 * n + 3.0 * m) / 0.110
    };
    let largest = volts_y
        .iter()
        .fold(0.0, |largest: f64, v| largest.max(v.abs()));
    for degree in 0..360 {
        // Rings are rounded to 1e-9, which is 1e-5 V, and the tiny film covers 1e-3 mm.
        let (x, y) = (x[degree], y[degree]);
        assert!((volts_x[degree] - volts([x, y])).abs() < 1e-5 + 1e-6 * largest);
        assert!((volts_y[degree] - volts([y, x])).abs() < 1e-5 + 1e-6 * largest);
    }
    // The noise is 2 % of the crown's largest signal, in volts; candidates are the two kinds that there are.
    let crown = volts_x.iter().chain(&volts_y);
    let crown = crown.fold(0.0, |largest: f64, v| largest.max(v.abs()));
    let score = &result.layouts[0].score;
    let noise = score.noise_v.expect("of glued films");
    assert_eq!(score.noise_strain, None, "volts are no strains");
    assert!(
        (noise / (0.02 * crown) - 1.0).abs() < 1e-6,
        "{noise} {crown}"
    );
    assert_eq!(findings.candidates.len(), 2);
    // Two coupled solves for each of x and y beside those of the bare tire, as foreseen.
    assert_eq!(result.cost.layout_solves, bare.cost.layout_solves + 4);
    let planned = PlannedStudy::new(study).unwrap();
    let workload = Workload::of(
        &planned,
        &KnownTransfer {
            proportional: false,
        },
    );
    assert_eq!(
        workload.keys().count(),
        result.cost.solves + result.cost.layout_solves
    );
}

/// Signals of both directions around the wheel, at the load in the middle.
fn rings(result: &StudyResult) -> [Vec<f64>; 2] {
    let findings = result.layout_findings.as_ref().unwrap();
    ["x", "y"].map(|direction| {
        let mut rings = findings.rings.iter();
        let ring = rings.find(|ring| ring.direction == direction);
        ring.unwrap().strain.clone()
    })
}

/// A transfer of films above the contact misses what they give beside it; coupled films don't, between the loads that were solved, too.
#[test]
fn what_coupled_films_give_beside_the_contact_is_in_every_signal() {
    let solver = MoreBeside {
        between_degrees: true,
    };
    let ran = |film: &str| {
        let layouts = json!({"film": film, "loads_n": [5, 13, 20]});
        let mut document = document(&layouts, tiny());
        document["layouts"]
            .as_object_mut()
            .unwrap()
            .remove("depths_mm");
        let study = read(&document);
        let archive = MemoryArchive::default();
        let result = observed(&study, &solver, &archive, 2).0.unwrap();
        let points = archive.points.lock().unwrap().len();
        (study, result, points)
    };
    let ((_, transfer, _), (study, coupled, points)) = (ran("transfer"), ran("coupled"));
    let pairs = rings(&transfer).into_iter().zip(rings(&coupled));
    for (degree, (by_transfer, found)) in pairs.flat_map(|(a, b)| a.into_iter().zip(b).enumerate())
    {
        let beyond = beyond_v(depth_of_load_mm(13.0), degree as f64 - 180.0);
        // Rings are rounded to 1e-9 V.
        let missed = found - (by_transfer + beyond);
        assert!(
            missed.abs() < 1e-6 * beyond_v(1.0, 180.0),
            "{degree} {missed}"
        );
    }
    let findings = coupled.layout_findings.as_ref().unwrap();
    let films = findings.films.as_ref().unwrap();
    assert_eq!((films.level.as_str(), films.tested), ("draft", 4));
    let (worst, missed) = (films.signal_worst.unwrap(), films.transfer_worst);
    assert!(missed > 0.1 && worst < 0.01 * missed, "{worst} of {missed}");
    // The noise is a share of what crown films give.
    let crown = rings(&coupled).concat();
    let crown = crown
        .iter()
        .fold(0.0, |largest: f64, v| largest.max(v.abs()));
    let noise = coupled.layouts[0].score.noise_v.unwrap();
    assert!(
        (noise / (0.02 * crown) - 1.0).abs() < 1e-6,
        "{noise} {crown}"
    );
    assert!(transfer.layout_findings.unwrap().films.is_none());
    let planned = PlannedStudy::new(study).unwrap();
    // The bare tire has no friction, so that three of its five loads were solved for the layouts already.
    assert_eq!(Workload::of(&planned, &solver).keys().count(), points);
    let counted = coupled.cost.solves + coupled.cost.layout_solves;
    assert_eq!(counted, points + 3);
}

/// Angle and force of the layout that answers.
fn figures(result: &StudyResult) -> [f64; 2] {
    let layout = &result.layouts[0];
    let angle = layout.score.simulated_p95_angle_error_deg.unwrap();
    [angle, layout.worst_force.unwrap().error_n]
}

#[test]
fn films_of_another_model_have_the_errors_of_a_study_that_has_them() {
    let solver = MoreBeside {
        between_degrees: false,
    };
    let ran = |film: &str, other: Option<&str>| {
        let mut layouts = json!({"film": film, "units": [18], "size_mm": [1e-3, 1e-3]});
        if let Some(other) = other {
            layouts["assumptions"] = json!({"film": other});
        }
        let study = read(&document(&layouts, tiny()));
        let archive = MemoryArchive::default();
        let result = observed(&study, &solver, &archive, 2).0.unwrap();
        let points = archive.points.lock().unwrap().len();
        let planned = PlannedStudy::new(study).unwrap();
        assert_eq!(Workload::of(&planned, &solver).keys().count(), points);
        result
    };
    let own = ["bare", "coupled"].map(|film| figures(&ran(film, None)));
    for (film, other, expected) in [("bare", "coupled", own[1]), ("coupled", "bare", own[0])] {
        let result = ran(film, Some(other));
        let findings = result.layout_findings.unwrap().assumptions.unwrap();
        assert!(!findings.unchanged.contains(&"film".to_owned()));
        let mut changes = findings.changes.iter();
        let change = changes.find(|change| change.of == "film").unwrap();
        let found = [change.angle_error_deg, change.force_error_n];
        for (found, expected) in found.into_iter().zip(expected) {
            assert!(
                (found / expected - 1.0).abs() < 1e-9,
                "{film} {other}: {found} {expected}"
            );
        }
    }
    assert!((own[0][1] / own[1][1] - 1.0).abs() > 0.01, "{own:?}");
}

/// A study that has a film has it glued on, unless its layouts say what only bare films have.
#[test]
fn layouts_of_a_study_with_a_film_have_it_glued_on() {
    let is_coupled = |layouts: Value| {
        let study = read(&document(&layouts, tiny()));
        let glued = study.layouts.glued.as_ref().map(|glued| glued.is_coupled);
        assert_eq!(Study::from_canonical(&study.canonical()), Ok(study));
        glued
    };
    assert_eq!(is_coupled(json!({})), Some(true));
    assert_eq!(is_coupled(json!({"film": "transfer"})), Some(false));
    for bare in [
        json!({"film": "bare"}),
        json!({"noise_strain": 1e-3}),
        json!({"candidate_sizes_mm": [[10, 5]]}),
        json!({"size_mm": [5, 4]}),
    ] {
        assert_eq!(is_coupled(bare), None);
    }
    let mut without = document(&json!({}), tiny());
    without["scene"] = json!({"preset": "foot-tire"});
    assert_eq!(read(&without).layouts.glued, None);
    without["signals"] = json!({"film": {"length_mm": 12, "width_mm": 4}, "positions": ["crown"]});
    assert_eq!(read(&without).layouts.size_mm, Some([12.0, 4.0]));
    without["signals"]["films"] = json!(["bare"]);
    assert_eq!(read(&without).layouts.glued, None);
}

/// Texts that were kept before films were glued on by default.
#[test]
fn a_stored_study_that_says_nothing_of_its_films_has_bare_ones() {
    let bare = read(&document(&json!({"film": "bare"}), tiny()));
    let mut stored: Value = serde_json::from_str(&bare.canonical()).unwrap();
    stored["layouts"].as_object_mut().unwrap().remove("film");
    assert_eq!(Study::from_canonical(&stored.to_string()), Ok(bare));
}

#[test]
fn where_there_is_no_transfer_layouts_have_a_reason_in_place_of_scores() {
    let study = read(&document(&json!({"film": "transfer"}), tiny()));
    let reason = |result: &StudyResult| result.layout_findings.as_ref().unwrap().reasons.join(" ");
    let proportional = answered(&study, true);
    assert!(
        reason(&proportional).contains("proportional"),
        "{}",
        reason(&proportional)
    );
    assert_eq!(
        proportional.layouts[0].score.simulated_p95_angle_error_deg,
        None
    );
    let laminate = json!({"layers": [{"thickness_mm": 0.028, "piezo": true}, {"thickness_mm": 0.125, "piezo": false}]});
    let bending = answered(
        &read(&document(&json!({"film": "transfer"}), laminate)),
        false,
    );
    assert!(reason(&bending).contains("bends"), "{}", reason(&bending));
}

#[test]
fn a_glued_film_is_that_of_the_signals_or_the_scene_and_has_its_own_noise() {
    let study = read(&document(
        &json!({"film": "transfer", "noise_v": 0.5}),
        tiny(),
    ));
    assert_eq!(Study::from_canonical(&study.canonical()), Ok(study));
    let mut of_signals = document(&json!({"film": "transfer", "size_mm": [12, 4]}), tiny());
    of_signals["signals"] =
        json!({"film": {"length_mm": 12, "width_mm": 4}, "positions": ["crown"]});
    assert_eq!(read(&of_signals).layouts.size_mm, Some([12.0, 4.0]));
    let pointers = |layouts: Value, film: Value| -> Vec<String> {
        let read = Study::from_value(&document(&layouts, film), &|path| Err(path.to_owned()));
        let faults = read.expect_err("has faults").into_iter();
        faults.map(|fault| fault.pointer).collect()
    };
    assert_eq!(
        pointers(
            json!({"film": "transfer", "size_mm": [5, 4], "noise_strain": 1e-3, "candidate_sizes_mm": [[10, 5]]}),
            tiny()
        ),
        [
            "/layouts/noise_strain",
            "/layouts/candidate_sizes_mm",
            "/layouts/size_mm"
        ]
    );
    assert_eq!(
        pointers(json!({"film": "glued"}), tiny()),
        ["/layouts/film"]
    );
    assert_eq!(
        pointers(json!({"film": "bare", "noise_v": 0.5}), tiny()),
        ["/layouts/noise_v"]
    );
    assert_eq!(
        pointers(
            json!({"film": "transfer", "noise_v": -1, "noise_share": 0.1}),
            tiny()
        ),
        ["/layouts/noise_v", "/layouts/noise_v"]
    );
    // 33 mm along y cover 100 degrees of the section to each side of the crown, and none beside it.
    assert_eq!(
        pointers(
            json!({"film": "transfer", "section_deg": [0, 10]}),
            json!({"length_mm": 33, "width_mm": 5})
        ),
        ["/layouts/section_deg/1"]
    );
}
