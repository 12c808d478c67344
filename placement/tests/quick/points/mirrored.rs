//! Studies that look the same from both ends of the contact, and those that only seem to; strains that a solver can't tell from nothing.

use documents::study::Study;
use fem_client::closed_form::ClosedFormSolver;
use fem_client::solver::direction::Direction;
use fem_client::solver::{Response, SolveError, SolveRequest, Solved, Solver};
use gsa::law::distribution::Distribution;
use gsa::method::analysis::Status;
use placement::compare::{Comparable, ComparedLocation, Entry, compare};
use results::{IndexMap, Output, RankedLocation, StudyResult};

use crate::support::{MemoryArchive, answered, observed, shipped};

/// The closed form with something done to each response.
struct Changed<F>(F);

impl<F: Fn(&mut Response) + Send + Sync> Solver for Changed<F> {
    fn version(&self) -> String {
        "changed".to_owned()
    }

    fn solve(&self, request: &SolveRequest<'_>) -> Result<Solved, SolveError> {
        let mut solved = ClosedFormSolver::new().solve(request)?;
        (self.0)(&mut solved.response);
        Ok(solved)
    }
}

fn answered_by(study: &Study, change: impl Fn(&mut Response) + Send + Sync) -> StudyResult {
    let archive = MemoryArchive::default();
    observed(study, &Changed(change), &archive, 2).0.unwrap()
}

/// Interactions that no form has a place for, alike from both ends.
fn entangle(response: &mut Response) {
    let strains: Vec<f64> = response.locations.iter().map(|l| l.strain.y).collect();
    let whole: f64 = strains
        .iter()
        .zip(strains.iter().rev())
        .map(|(a, b)| a + b)
        .sum();
    for location in &mut response.locations {
        location.strain.x += (40.0 * (location.strain.y + whole)).sin() * 1e-2;
        location.strain.y *= 1.0 + 3.0 * whole * whole;
    }
}

fn pair<'r>(result: &'r StudyResult, names: [&str; 2]) -> [&'r RankedLocation; 2] {
    names.map(|name| result.locations.iter().find(|l| l.name == name).unwrap())
}

fn output<'r>(result: &'r StudyResult, name: &str, direction: Direction) -> &'r Output {
    let mut outputs = result.outputs.iter();
    outputs
        .find(|o| o.location == name && o.direction == direction)
        .unwrap()
}

fn reversed(values: &Option<Vec<f64>>) -> Option<Vec<f64>> {
    Some(values.as_ref()?.iter().rev().copied().collect())
}

#[test]
fn mirror_places_have_the_same_figures_to_the_bit_in_every_table() {
    let result = answered_by(&shipped("foot-tire"), entangle);
    for names in [["P1", "P5"], ["P2", "P4"]] {
        let [left, right] = pair(&result, names);
        assert_eq!(left.scores, right.scores, "{names:?}");
        assert_eq!(left.ranks, right.ranks, "{names:?}");
        for direction in Direction::ALL {
            let [left, right] = names.map(|name| output(&result, name, direction));
            assert_eq!(left.first_order, reversed(&right.first_order));
            assert_eq!(left.total, reversed(&right.total));
            assert_eq!(left.error, right.error);
            assert_eq!((left.mean, left.std), (right.mean, right.std));
            assert!(left.error.decomposition.unwrap() > 1e-3, "{left:?}");
            assert_eq!(left.misses.as_ref().unwrap().residuals.len(), 10);
        }
    }
    mirrored(result.map.as_ref().unwrap());
}

fn mirrored(map: &IndexMap) {
    let columns = map.theta_deg.len();
    for layer in &map.layers {
        let other_end = |values: &[Option<f64>]| -> Vec<Option<f64>> {
            let rows = values.chunks(columns);
            rows.flat_map(|row| row.iter().rev().copied()).collect()
        };
        assert_eq!(layer.error, other_end(&layer.error));
        assert_eq!(layer.std, other_end(&layer.std));
        for input in 0..5 {
            let (index, error) = (&layer.first_order[input], &layer.first_order_error[input]);
            assert_eq!(*index, other_end(&layer.first_order[4 - input]));
            assert_eq!(*error, other_end(&layer.first_order_error[4 - input]));
        }
    }
}

#[test]
fn differences_between_designs_are_the_same_for_mirror_places() {
    let entry = |id: &str, strength: f64| Entry {
        id: id.to_owned(),
        name: id.to_owned(),
        set: None,
        state: "done".to_owned(),
        result: Ok(Comparable::of(&answered_by(
            &shipped("foot-tire"),
            |response| {
                for location in &mut response.locations {
                    location.strain.x *= 1.0 + strength * location.strain.y;
                }
                entangle(response);
            },
        ))),
    };
    let found = compare(&[entry("a", 0.0), entry("b", 1.0)], None);
    let row = |name: &str| -> &ComparedLocation {
        let mut rows = found.rows.iter().filter(|row| row.study == "b");
        rows.find(|row| row.location == name).unwrap()
    };
    for [left, right] in [["P1", "P5"], ["P2", "P4"]] {
        let (left, right) = (row(left), row(right));
        assert_eq!((&left.x, &left.y), (&right.x, &right.y));
        assert!(left.x.difference_error_percent.unwrap() > 0.0);
        assert_eq!((left.rank_change, right.rank_change), (Some(0), Some(0)));
    }
}

#[test]
fn a_solver_that_isn_t_symmetric_tells_nothing_of_mirror_images() {
    let images = |result: &StudyResult| {
        let centre = output(result, "P3", Direction::X).misses.as_ref().unwrap();
        centre.images.len()
    };
    let study = shipped("foot-tire");
    assert_eq!(images(&answered_by(&study, entangle)), 10);
    let leaning = |response: &mut Response| {
        entangle(response);
        response.locations[4].strain.x *= 1.01;
    };
    assert_eq!(images(&answered_by(&study, leaning)), 0);
    let mut uneven = shipped("foot-tire");
    uneven.inputs.pop();
    uneven.scene.ground.depths_mm[4] = 1.1;
    assert_eq!(images(&answered_by(&uneven, entangle)), 0);
    let mut dragged = shipped("foot-tire");
    dragged.scene.contact.friction = 0.5;
    dragged.scene.ground.shift_mm = [0.0, 0.5];
    assert_eq!(images(&answered_by(&dragged, entangle)), 10);
    dragged.scene.ground.shift_mm = [0.5, 0.0];
    assert_eq!(images(&answered_by(&dragged, entangle)), 0);
}

/// Five depths that vary by so much to either side, mm.
fn narrow(half_width: f64) -> Study {
    let mut study = shipped("foot-tire");
    for input in &mut study.inputs {
        input.distribution = Distribution::uniform(1.0 - half_width, 1.0 + half_width).unwrap();
    }
    study
}

#[test]
fn what_a_solver_leaves_open_is_constant_and_not_ranked() {
    // A mesh whose strains are the formula's to 1e-9, as Newton's tolerance leaves them.
    let on_mesh = |response: &mut Response| {
        response.model.elements = 1;
        for location in &mut response.locations {
            location.strain.x = (location.strain.x * 1e9).round() * 1e-9;
            location.strain.y = (location.strain.y * 1e9).round() * 1e-9;
        }
    };
    let result = answered_by(&narrow(1e-9), on_mesh);
    for output in &result.outputs {
        assert_eq!(
            (output.status, &output.first_order),
            (Status::Constant, &None)
        );
        let reason = output.reason.as_ref().unwrap();
        assert!(
            reason.contains("solver's tolerance") && reason.contains("1e-8"),
            "{reason}"
        );
    }
    let said = |words: &str| result.notes.iter().any(|note| note.contains(words));
    assert!(
        said("constant within the solver's tolerance"),
        "{:#?}",
        result.notes
    );
    assert!(!said("mesh"), "{:#?}", result.notes);
    assert!(result.locations.iter().all(|l| !l.rank_certain));
    // A thousand times as much is far above it, and the formula itself leaves nothing open.
    for result in [answered_by(&narrow(1e-4), on_mesh), answered(&narrow(1e-9))] {
        assert!(result.outputs.iter().all(|o| o.first_order.is_some()));
    }
}
