//! Answers of a study, with closed formulas in place of finite elements.

use documents::layouts::layout_settings::{LayoutLoads, Layouts};
use fem_client::closed_form::ClosedFormSolver;
use fem_client::solver::direction::Direction;
use fem_client::solver::{Position, SolveError, SolveRequest, Solved, Solver};
use gsa::method::analysis::Status;
use results::location_scores::{GSI, MDRM_GSI, MEAN_GSI, OWN_GSI};
use results::{Output, RankedLayout, RankedLocation, StudyResult};
use serde_json::Value;

use crate::support::{MemoryArchive, answered, observed, shipped, study};

fn location<'r>(result: &'r StudyResult, name: &str) -> &'r RankedLocation {
    result
        .locations
        .iter()
        .find(|location| location.name == name)
        .unwrap()
}

fn has_note(result: &StudyResult, words: &[&str]) -> bool {
    result
        .notes
        .iter()
        .any(|note| words.iter().all(|word| note.contains(word)))
}

#[test]
fn the_meridional_indices_are_those_of_the_formula() {
    // The y strain at the centre is linear in the depths with weights exp(-k^2 / 2), so S_k = w_k^2 / sum w^2.
    let result = answered(&shipped("foot-tire"));
    let weights: Vec<f64> = (-2..=2)
        .map(|k: i32| (-f64::from(k * k) / 2.0).exp())
        .collect();
    let whole: f64 = weights.iter().map(|w| w * w).sum();
    let centre = result
        .outputs
        .iter()
        .find(|o| o.location == "P3" && o.direction == Direction::Y)
        .unwrap();
    for (index, weight) in centre.first_order.as_ref().unwrap().iter().zip(&weights) {
        // A product form would add interactions of the order (sd/h0)^2 = 1e-2; the additive one is exact.
        let expected = weight * weight / whole;
        let tolerance = centre.error.total.unwrap() + 1e-9;
        assert!(
            (index - expected).abs() <= tolerance,
            "{index} for {expected} +- {tolerance}"
        );
    }
}

#[test]
fn locations_are_ranked_by_their_own_depth_at_the_centre() {
    let result = answered(&shipped("foot-tire"));
    let names: Vec<&str> = result.locations.iter().map(|l| l.name.as_str()).collect();
    assert_eq!(names, ["P3", "P2", "P4", "P1", "P5"]);
    assert_eq!(
        result.locations.iter().map(|l| l.rank).collect::<Vec<_>>(),
        [1, 2, 2, 4, 4]
    );
    let p3 = location(&result, "P3");
    assert_eq!(p3.value(GSI, Direction::Y), p3.value(OWN_GSI, Direction::Y));
    assert!(p3.rank_certain);
    // Mirror images tie: they share their rank, which is certain, and neither is before the other.
    let (p2, p4) = (location(&result, "P2"), location(&result, "P4"));
    assert!(p2.rank_certain && p4.rank_certain && p2.ranks == p4.ranks);
    assert_eq!((p2.ranks.x, p2.ranks.y), (Some(2), Some(2)));
    assert_eq!((p3.ranks.x, p3.ranks.y), (Some(1), Some(1)));
    for location in &result.locations {
        for share in [
            location.value(GSI, Direction::X),
            location.value(MEAN_GSI, Direction::X),
            location.value(MDRM_GSI, Direction::X),
        ] {
            assert!((0.0..=100.0).contains(&share.unwrap()));
        }
    }
}

#[test]
fn the_wide_study_says_where_m_drm_breaks_and_what_it_would_have_said() {
    let result = answered(&shipped("foot-tire-paper"));
    let centre = result
        .outputs
        .iter()
        .find(|o| o.location == "P3" && o.direction == Direction::X)
        .unwrap();
    assert_eq!(
        (centre.status.as_str(), centre.method.as_str()),
        ("product-form-broken", "additive")
    );
    assert!(centre.mdrm_first_order.is_some() && centre.reason.is_some());
    assert!(
        has_note(&result, &["product form", "x strain", "additive"]),
        "{:#?}",
        result.notes
    );
    assert!(
        has_note(&result, &["gains or loses contact", "P2 (at 0.30 mm)"]),
        "{:#?}",
        result.notes
    );
}

#[test]
fn notes_tell_of_symmetry_and_of_the_missing_mesh_error() {
    let result = answered(&shipped("foot-tire"));
    assert!(
        has_note(
            &result,
            &[
                "P2 and P4 share rank 2, which is certain",
                "P1 and P5 share rank 4"
            ]
        ),
        "{:#?}",
        result.notes
    );
    assert!(has_note(&result, &["leave out the mesh"]));
    assert!(
        result
            .outputs
            .iter()
            .all(|output| output.error.mesh.is_none() && output.error.reason.is_some())
    );
    let mut lopsided = shipped("foot-tire");
    lopsided.inputs[0].distribution =
        gsa::law::distribution::Distribution::uniform(0.8, 1.2).unwrap();
    let lopsided = answered(&lopsided);
    assert!(!has_note(&lopsided, &["P1 and P5 share"]));
    // Nor does a point tell of its mirror image then.
    let misses = |output: &Output| output.misses.as_ref().unwrap().clone();
    assert!(
        lopsided
            .outputs
            .iter()
            .all(|output| misses(output).images.is_empty())
    );
}

#[test]
fn the_map_agrees_with_the_locations() {
    let result = answered(&shipped("foot-tire"));
    let map = result.map.as_ref().unwrap();
    assert_eq!(
        (map.theta_deg.len(), map.phi_deg.len(), map.layers.len()),
        (61, 21, 2)
    );
    let middle = 10 * 61 + 30;
    let centre = result
        .outputs
        .iter()
        .find(|o| o.location == "P3" && o.direction == Direction::Y)
        .unwrap();
    let layer = &map.layers[1];
    // A map keeps seven digits.
    let is_told = |of_map: f64, exact: f64| (of_map - exact).abs() <= 0.5e-6 * exact.abs();
    let strain = result.cut_point.locations[2].strain.y;
    assert!(is_told(layer.strain[middle], strain), "{strain}");
    assert_eq!(
        (layer.first_order.len(), layer.first_order[0].len()),
        (5, 61 * 21)
    );
    for (input, index) in centre.first_order.as_ref().unwrap().iter().enumerate() {
        let of_map = layer.first_order[input][middle].expect("an index");
        assert!(is_told(of_map, *index), "{of_map} {index}");
        // One error for an index, wherever it is shown.
        let name = &result.inputs[input].name;
        let shown = location(&result, name).error(GSI, Direction::Y).unwrap();
        let error = layer.first_order_error[input][middle].unwrap();
        assert!(is_told(100.0 * error, shown), "{name}");
        assert!(Some(error) <= layer.error[middle]);
    }
}

#[test]
fn layouts_are_ranked_by_what_each_film_contributes() {
    let mut study = shipped("foot-tire");
    study.layouts = Layouts {
        films: Vec::new(),
        spacings_deg: vec![15.0, 30.0, 60.0, 180.0],
        loads: LayoutLoads::Depths(vec![0.8, 1.0]),
        ..Layouts::default()
    };
    let result = answered(&study);
    assert_eq!((result.layouts.len(), result.cost.layout_solves), (12, 7));
    let p95 = |layout: &RankedLayout| layout.score.simulated_p95_angle_error_deg.unwrap();
    // Those that lose one contact in twenty come last, by their error alone.
    let (found, lost): (Vec<_>, Vec<_>) = result
        .layouts
        .iter()
        .partition(|layout| p95(layout) <= 20.0);
    assert!(!found.is_empty() && !lost.is_empty());
    assert!(p95(found[found.len() - 1]) <= p95(lost[0]));
    let weighted = |layout: &&RankedLayout| p95(layout) * (layout.film_count as f64).sqrt();
    assert!(found.iter().map(weighted).collect::<Vec<_>>().is_sorted());
    assert!(
        lost.iter()
            .map(|layout| p95(layout))
            .collect::<Vec<_>>()
            .is_sorted()
    );
    for layout in &result.layouts {
        assert!(layout.score.worst_angle_error_deg.is_some() || layout.score.reason.is_some());
        let of_loads = layout
            .loads
            .iter()
            .map(|load| load.score.simulated_p95_angle_error_deg.unwrap());
        assert_eq!(
            of_loads.fold(0.0, f64::max),
            p95(layout),
            "the score is that of the worst load"
        );
    }
    // The noise is 2 % of the crown's largest strain at the load in the middle, the same for every layout.
    let noise = result.layouts[0].score.noise_strain.expect("of bare films");
    assert!((noise / (0.02 * result.cut_point.locations[2].strain.y) - 1.0).abs() < 1e-9);
    assert!(
        result
            .layouts
            .iter()
            .all(|l| l.score.noise_strain == Some(noise))
    );
    let findings = result.layout_findings.as_ref().unwrap();
    assert_eq!((findings.loads.len(), findings.rings.len()), (2, 6));
    assert_eq!(findings.candidates.len(), 14);
    let front: Vec<f64> = findings
        .front
        .iter()
        .map(|layout| layout.simulated_p95_angle_error_deg)
        .collect();
    assert!(front.is_sorted_by(|a, b| a > b), "{front:?}");
    assert_eq!(answered(&study).layouts, result.layouts);
}

#[test]
fn films_of_a_size_are_scored_beside_points() {
    let mut study = shipped("foot-tire");
    study.layouts = Layouts {
        films: Vec::new(),
        spacings_deg: vec![15.0],
        positions: vec![Position::Crown],
        loads: LayoutLoads::Depths(vec![1.0]),
        candidate_sizes_mm: vec![[10.0, 5.0], [25.0, 10.0]],
        ..Layouts::default()
    };
    let points = answered(&study);
    let found = &points.layout_findings.as_ref().unwrap().candidates;
    // The section ends at 102 degrees. Along y 10 mm fit to 71, 25 mm to 26; across it their widths fit to 86 and 71.
    let count = |length| {
        let sized = found.iter().filter(|film| film.length_mm == length);
        [
            sized.clone().filter(|film| film.direction == "x").count(),
            sized.filter(|film| film.direction == "y").count(),
        ]
    };
    assert_eq!(
        [count(None), count(Some(10.0)), count(Some(25.0))],
        [[7, 7], [6, 5], [5, 2]]
    );
    assert!(
        found
            .iter()
            .all(|film| film.length_mm.is_some() == film.width_mm.is_some())
    );
    // A tiny film is a point, and a large one isn't; the noise is the point's.
    let p95 = |result: &StudyResult| {
        let score = &result.layouts[0].score;
        (
            score.simulated_p95_angle_error_deg.unwrap(),
            score.noise_strain,
        )
    };
    let mut sized = |size_mm| {
        study.layouts.size_mm = Some(size_mm);
        p95(&answered(&study))
    };
    let (point, [tiny, large]) = (p95(&points), [sized([1e-6, 1e-6]), sized([25.0, 10.0])]);
    assert!((tiny.0 / point.0 - 1.0).abs() < 1e-6, "{tiny:?} {point:?}");
    assert!(
        (large.0 / point.0 - 1.0).abs() > 0.05,
        "{large:?} {point:?}"
    );
    assert_eq!([tiny.1, large.1], [point.1; 2]);
}

#[test]
fn an_input_without_a_station_has_indices_but_no_location() {
    let result = answered(&study(
        "name = \"pressure and depth\"\nscene = { preset = \"foot-tire\" }\n\
         [[inputs]]\nname = \"p\"\nvary = \"pressure.internal_mpa\"\n\
         distribution = { kind = \"uniform\", min = 0.15, max = 0.25 }\n\
         [[inputs]]\nname = \"middle\"\nvary = \"ground.depths_mm[2]\"\n\
         distribution = { kind = \"uniform\", min = 0.7, max = 1.3 }\n",
    ));
    assert_eq!(result.locations[0].name, "P3");
    assert!(result.locations[0].value(GSI, Direction::X).is_some());
    assert!(
        result.locations[1..]
            .iter()
            .all(|l| l.value(GSI, Direction::X).is_none() && !l.rank_certain)
    );
    assert_eq!(result.outputs[4].first_order.as_ref().unwrap().len(), 2);
    assert!(has_note(&result, &["No location lies above what p varies"]));
}

#[test]
fn what_never_varies_is_null_with_a_reason() {
    let mut study = shipped("foot-tire");
    // The closed form's strains don't depend on the rubber, only on where a solve starts.
    struct FromScratch;
    impl Solver for FromScratch {
        fn version(&self) -> String {
            "from scratch".to_owned()
        }
        fn solve(&self, request: &SolveRequest<'_>) -> Result<Solved, SolveError> {
            ClosedFormSolver::new().solve(&SolveRequest {
                start: None,
                ..*request
            })
        }
    }
    study.inputs.truncate(1);
    study.inputs[0].vary = "material.c10_mpa".to_owned();
    let law = gsa::law::distribution::Distribution::uniform(0.14, 0.15);
    study.inputs[0].distribution = law.unwrap();
    let result = observed(&study, &FromScratch, &MemoryArchive::default(), 1).0;
    let result = result.unwrap();
    assert!(
        result
            .outputs
            .iter()
            .all(|o| o.status == Status::Constant && o.first_order.is_none() && o.reason.is_some())
    );
    assert!(
        result
            .locations
            .iter()
            .all(|l| l.value(GSI, Direction::X).is_none() && l.ranks.x.is_none())
    );
    assert!(has_note(&result, &["doesn't vary"]));
    // serde_json writes NaN as null, so a null among numbers that must exist would show one.
    let document: Value = serde_json::to_value(&result).unwrap();
    assert!(document["cut_point"]["reaction_n"].is_number());
}

#[test]
fn a_single_node_of_each_input_knows_nothing_of_their_influence() {
    let mut study = shipped("foot-tire");
    study.method.nodes = 1;
    let result = answered(&study);
    for output in &result.outputs {
        assert_eq!(output.status, Status::Unusable);
        let reason = output.reason.as_deref().unwrap();
        assert!(reason.contains("a single node"), "{reason}");
        assert!(output.first_order.is_none() && output.mean.is_none());
    }
    let unranked = |l: &RankedLocation| l.value(GSI, Direction::X).is_none() && l.ranks.x.is_none();
    assert!(result.locations.iter().all(unranked));
}

#[test]
fn the_result_reads_back_from_its_document() {
    let result = answered(&shipped("foot-tire"));
    let text = serde_json::to_string(&result).unwrap();
    assert_eq!(serde_json::from_str::<StudyResult>(&text).unwrap(), result);
    let cost = &result.cost;
    assert_eq!((cost.solves, cost.reused), (26, 0));
    // 12 iterations from scratch, 4 for each of the 25 others.
    assert_eq!(cost.newton_iterations, 112);
    let shares =
        cost.factorisation_share + cost.substitution_share + cost.assembly_share + cost.other_share;
    assert!((shares - 1.0).abs() < 1e-12, "{shares}");
}
