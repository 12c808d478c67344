//! A virtual rig on glued films: their angle to the contact as an axis of the table.

use documents::study::Study;
use fem_client::closed_form::ClosedFormSolver;
use fem_client::solver::gauge::Gauge;
use fem_client::solver::{
    NoEquilibrium, Reached, Readout, SolveError, SolveRequest, Solved, Solver,
};
use results::FilmAnglesReport;
use serde_json::json;

use crate::glued_layouts::glued;
use crate::support::{MemoryArchive, observed};

/// Volts that glued films give beyond their transfer, at a depth of 1 mm, opposite the contact.
const BEYOND_V: f64 = 100.0;

/// A tire whose glued films have a known transfer and, beside the contact, something more.
struct MoreBeside {
    /// Whether films between whole degrees, which only test the table, have an equilibrium.
    between_degrees: bool,
}

/// 13 N at 1 mm, with the power of 1.3.
fn depth_of_load_mm(load_n: f64) -> f64 {
    (load_n / 13.0).powf(1.0 / 1.3)
}

/// A parabola in the angle and in the depth: the table's cubics meet it.
fn beyond_v(depth_mm: f64, theta_deg: f64) -> f64 {
    BEYOND_V * depth_mm * (1.0 - 0.1 * depth_mm) * (theta_deg / 180.0).powi(2)
}

/// Meridional strains grow faster than the others, so that two loads tell them apart.
fn faster(strain: f64, depth_mm: f64) -> f64 {
    strain * (1.0 + depth_mm)
}

impl Solver for MoreBeside {
    fn version(&self) -> String {
        "more beside the contact".to_owned()
    }

    fn solve(&self, request: &SolveRequest<'_>) -> Result<Solved, SolveError> {
        let (mut scene, film) = (request.scene.clone(), request.scene.film.clone());
        scene.film = None;
        let between = film
            .as_ref()
            .is_some_and(|film| film.theta_deg.fract() != 0.0);
        if between && !self.between_degrees {
            return Err(SolveError::NoEquilibrium {
                status: NoEquilibrium::NotConverged,
                detail: "between degrees".to_owned(),
                reached: Reached::default(),
            });
        }
        let load_n = scene.ground.load_n.take().unwrap_or_default();
        let depth_mm = depth_of_load_mm(load_n);
        if load_n > 0.0 {
            scene.ground.stations = 1;
            scene.ground.depths_mm = vec![depth_mm];
        }
        let across = |angle_deg| {
            film.iter().map(move |film| Gauge {
                theta_deg: film.theta_deg,
                phi_deg: film.phi_deg,
                angle_deg,
            })
        };
        let readout = Readout {
            gauges: across(0.0).chain(across(90.0)).collect(),
            ..request.readout.clone()
        };
        let mut solved = ClosedFormSolver::new().solve(&SolveRequest {
            scene: &scene,
            readout: &readout,
            ..*request
        })?;
        let response = &mut solved.response;
        for ring in &mut response.rings {
            ring.strain
                .y
                .iter_mut()
                .for_each(|y| *y = faster(*y, depth_mm));
        }
        let gauges = std::mem::take(&mut response.gauges);
        if let (Some(film), [x, y]) = (film, &gauges[..]) {
            let mut strain = [x.strain, faster(y.strain, depth_mm)];
            if film.angle_deg == 90.0 {
                strain.reverse();
            }
            let mut state = glued(&film, strain);
            state.signal.open_circuit_v += beyond_v(depth_mm, film.theta_deg);
            response.film = Some(state);
        }
        Ok(solved)
    }
}

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
