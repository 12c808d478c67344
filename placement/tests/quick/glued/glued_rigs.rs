//! A virtual rig on glued films: their angle to the contact as an axis of the table.

use documents::study::Study;
use results::FilmAnglesReport;
use serde_json::json;

use crate::glued::known_films::MoreBeside;
use crate::support::{MemoryArchive, observed};

fn films(solver: &MoreBeside) -> FilmAnglesReport {
    let document = json!({
        "name": "glued films on a rig",
        "scene": {"preset": "foot-tire", "film": {"length_mm": 1e-3, "width_mm": 1e-3}},
        "inputs": [{
            "name": "P3",
            "vary": "ground.depths_mm[2]",
            "distribution": {"kind": "uniform", "min": 0.7, "max": 1.3},
        }],
        "layouts": {"units": [6], "section_deg": [0], "depths_mm": [0.5, 1], "level": "draft", "film": "transfer"},
        "method": {"kind": "mdrm", "nodes": 3, "check_points": 0},
        "accuracy": {"preset": "draft"},
        "rig": {"runs": 2, "gait": {"stances": 8}},
    });
    let study = Study::from_value(&document, &|path| Err(path.to_owned())).unwrap();
    let archive = MemoryArchive::default();
    let result = observed(&study, solver, &archive, 2).0.unwrap();
    let forces = result.forces.unwrap();
    let table = forces
        .table
        .unwrap_or_else(|| panic!("{:?}", forces.reasons));
    table.films.unwrap()
}

/// A transfer of films above the contact misses what they give beside it; the table doesn't.
#[test]
fn what_films_give_beside_the_contact_is_in_the_table() {
    let films = films(&MoreBeside {
        between_degrees: true,
    });
    assert_eq!((films.level.as_str(), films.tested), ("draft", 10));
    let (worst, missed) = (films.signal_worst.unwrap(), films.transfer_worst);
    assert!(missed > 0.1, "{missed}");
    // What is left is the bare strains between loads and degrees.
    assert!(worst < 0.01 * missed, "{worst} of {missed}");
}

#[test]
fn a_film_that_only_tests_the_table_does_not_cost_it() {
    let films = films(&MoreBeside {
        between_degrees: false,
    });
    assert_eq!((films.tested, films.signal_worst), (0, None));
    assert!(films.transfer_worst > 0.1, "{}", films.transfer_worst);
}
