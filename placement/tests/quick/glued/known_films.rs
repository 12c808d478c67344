//! Tires whose films have a known transfer, and more beside the contact.

use fem_client::closed_form::ClosedFormSolver;
use fem_client::scene::Film;
use fem_client::solver::direction::PerDirection;
use fem_client::solver::gauge::Gauge;
use fem_client::solver::{
    Extremes, FilmMeans, FilmSignal, FilmState, NoEquilibrium, Reached, Readout, SolveError,
    SolveRequest, Solved, Solver,
};

/// Tensions along and across, N/mm, by strains along and across.
const TRANSFER: [[f64; 2]; 2] = [[40.0, 3.0], [2.0, 30.0]];

pub fn tension(strain: [f64; 2]) -> [f64; 2] {
    TRANSFER.map(|row| row[0] * strain[0] + row[1] * strain[1])
}

/// Returns what a film gives where the bare wall has these strains along and across.
pub fn glued(film: &Film, strain: [f64; 2]) -> FilmState {
    let [[a, b, _], ..] = film.laminate().membrane;
    let ([n, m], determinant) = (tension(strain), a * a - b * b);
    let means = FilmMeans {
        area: film.length_mm * film.width_mm,
        added: [
            (a * n - b * m) / determinant,
            (a * m - b * n) / determinant,
            0.0,
        ],
        ..FilmMeans::default()
    };
    let any = || PerDirection::of(|_| Extremes { min: 1.0, max: 1.0 });
    FilmState {
        stretch: any(),
        tension_n_per_mm: any(),
        signal: FilmSignal::of(film, &means),
        bare: None,
        error: None,
    }
}

/// Volts that glued films give beyond their transfer, at a depth of 1 mm, opposite the contact.
const BEYOND_V: f64 = 100.0;

/// A tire whose glued films have a known transfer and, beside the contact, something more.
pub struct MoreBeside {
    /// Whether films between whole degrees, which only test the table, have an equilibrium.
    pub between_degrees: bool,
}

/// 13 N at 1 mm, with the power of 1.3.
pub fn depth_of_load_mm(load_n: f64) -> f64 {
    (load_n / 13.0).powf(1.0 / 1.3)
}

/// A parabola in the angle and in the depth: the table's cubics meet it.
pub fn beyond_v(depth_mm: f64, theta_deg: f64) -> f64 {
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
