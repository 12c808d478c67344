//! Studies that ask for one strain alone: what they read as, how they rank, and what a tolerance holds for.

use document::Format;
use documents::layouts::layout_settings::Layouts;
use documents::parts::directions::Directions;
use documents::study::{Accuracy, Study};
use fem_client::closed_form::ClosedFormSolver;
use fem_client::scene::{Level, Scene};
use fem_client::solver::direction::Direction;
use fem_client::solver::{Coarser, SolveError, SolveRequest, Solved, Solver};
use gsa::method::{Kind, Method};
use results::location_scores::GSI;
use results::{RankedLocation, StudyResult};
use serde_json::{Value, json};
use tire::mesh_error;

use crate::support::{MemoryArchive, observed, shipped};

/// The closed form, whose y strains are linear, with x strains that bend sharply with P1's depth and err with the mesh.
struct Awkward(ClosedFormSolver);

/// Circumferential strain for each mm of P1's depth beyond a kink.
const KINK: f64 = 0.2;
const KINK_MM: f64 = 1.07;

impl Solver for Awkward {
    fn version(&self) -> String {
        "awkward 1".to_owned()
    }

    fn coarser(&self, scene: &Scene) -> Option<Coarser> {
        mesh_error::coarser(scene)
    }

    fn solve(&self, request: &SolveRequest<'_>) -> Result<Solved, SolveError> {
        let mut solved = self.0.solve(request)?;
        let scene = request.scene;
        // A draft has the whole kink more, the reference a tenth of it.
        let of_mesh = match scene.model.level {
            Level::Draft => 1.0,
            Level::Coarse => 0.5,
            Level::Standard => 0.2,
            Level::Reference => 0.1,
        };
        let beyond = (scene.ground.depths_mm[0] - KINK_MM).max(0.0);
        for location in &mut solved.response.locations {
            location.strain.x += KINK * (1.0 + of_mesh) * beyond;
        }
        Ok(solved)
    }
}

fn asking(directions: Directions) -> Study {
    let mut study = shipped("foot-tire");
    study.grid = None;
    study.directions = directions;
    study.layouts = Layouts {
        films: Vec::new(),
        spacings_deg: vec![30.0, 60.0],
        ..Layouts::default()
    };
    study
}

fn answer(study: &Study) -> StudyResult {
    let solver = Awkward(ClosedFormSolver::new());
    let (result, _) = observed(study, &solver, &MemoryArchive::default(), 2);
    result.unwrap()
}

fn read(directions: Value) -> Result<Study, Vec<document::fault::Fault>> {
    let mut document: Value = serde_json::from_str(&shipped("foot-tire").canonical()).unwrap();
    document["candidates"]["directions"] = directions;
    Study::from_value(&document, &|_| Err(String::new()))
}

#[test]
fn directions_are_read_and_written() {
    for (names, directions) in [
        (json!(["x"]), Directions::X),
        (json!(["y"]), Directions::Y),
        (json!(["y", "x"]), Directions::Both),
    ] {
        let study = read(names).unwrap();
        assert_eq!(study.directions, directions);
        let again = Study::from_document(&study.canonical(), Format::Json, &|_| Err(String::new()));
        assert_eq!(again.unwrap(), study);
    }
    // Who asks for both asks what everyone asked before there was a choice: the same document, with the same hash.
    let both = read(json!(["x", "y"])).unwrap();
    assert_eq!(both.spec_sha256(), shipped("foot-tire").spec_sha256());
    assert_ne!(
        read(json!(["x"])).unwrap().spec_sha256(),
        both.spec_sha256()
    );
    for (wrong, pointer) in [
        (json!([]), "/candidates/directions"),
        (json!("x"), "/candidates/directions"),
        (json!(["x", "y", "x"]), "/candidates/directions"),
        (json!(["z"]), "/candidates/directions/0"),
        (json!(["y", "y"]), "/candidates/directions/1"),
    ] {
        let faults = read(wrong).unwrap_err();
        assert_eq!(faults.len(), 1, "{faults:?}");
        assert_eq!(faults[0].pointer, pointer);
    }
}

#[test]
fn ranks_go_by_what_is_asked_for() {
    type Key = fn(&RankedLocation) -> Option<f64>;
    let keys: [(Directions, Key); 2] = [
        (Directions::X, |l| l.value(GSI, Direction::X)),
        (Directions::Y, |l| l.value(GSI, Direction::Y)),
    ];
    let both = answer(&asking(Directions::Both));
    let mut orders = Vec::new();
    for (directions, key) in keys {
        let result = answer(&asking(directions));
        let figures: Vec<f64> = result.locations.iter().map(|l| key(l).unwrap()).collect();
        // Rounding may tell mirror images apart that share a place.
        assert!(
            figures.windows(2).all(|pair| pair[0] >= pair[1] - 1e-6),
            "{figures:?}"
        );
        // The numbers themselves don't depend on the question.
        assert_eq!(result.outputs, both.outputs);
        let asked = directions.asked()[0];
        let words = format!("Only the {asked} strain is asked for");
        assert!(result.notes[0].starts_with(&words), "{}", result.notes[0]);
        orders.push(result.locations[0].name.clone());
    }
    // The kink gives P1 the x strain at the centre, and leaves y alone.
    assert_eq!(orders, ["P1", "P3"]);
    assert!(both.notes.iter().all(|note| !note.contains("asked for")));
}

#[test]
fn fewer_films_bound_the_errors_of_a_layout_less_tightly() {
    let both = answer(&asking(Directions::Both));
    for directions in [Directions::X, Directions::Y] {
        let result = answer(&asking(directions));
        assert_eq!(result.layouts.len(), both.layouts.len());
        let mut compared = 0;
        for layout in &result.layouts {
            let names = directions
                .asked()
                .iter()
                .map(|direction| direction.as_str());
            assert_eq!(layout.films, names.collect::<Vec<_>>());
            let twin = both.layouts.iter().find(|twin| {
                (twin.spacing_deg, &twin.position) == (layout.spacing_deg, &layout.position)
            });
            let bounds = [
                layout.score.rms_angle_error_deg,
                twin.unwrap().score.rms_angle_error_deg,
            ];
            if let [Some(one), Some(two)] = bounds {
                // Information adds up over films.
                assert!(one >= two, "{layout:?}");
                compared += 1;
            }
        }
        assert!(compared > 0);
    }
}

#[test]
fn a_tolerance_holds_for_what_is_asked_for() {
    let rungs = |directions| {
        let study = Study {
            accuracy: Accuracy::Tolerance(0.005),
            level: Level::Coarse,
            ..asking(directions)
        };
        answer(&study).climb.unwrap().rungs
    };
    let [y, both] = [Directions::Y, Directions::Both].map(rungs);
    // The first rung is the same; what it claims of y is less, because nothing is wrong there.
    assert_eq!(y[0].fidelity, both[0].fidelity);
    assert!(y[0].error_claimed.unwrap() < both[0].error_claimed.unwrap());
    assert!(y.len() < both.len(), "{y:?} {both:?}");
}

#[test]
fn an_adaptive_method_serves_what_is_asked_for() {
    let solves = |directions| {
        let study = Study {
            // Below what the first points claim of the x strain.
            method: Method {
                tolerance: 1e-3,
                ..Method::of(Kind::Auto)
            },
            ..asking(directions)
        };
        let result = answer(&study);
        // The other strain is there too.
        assert_eq!(result.outputs.len(), 10);
        assert!(
            result
                .outputs
                .iter()
                .all(|output| output.first_order.is_some())
        );
        result.cost.solves
    };
    let [x, y, both] = [Directions::X, Directions::Y, Directions::Both].map(solves);
    assert!(y < both && x <= both, "{x} {y} {both}");
}
