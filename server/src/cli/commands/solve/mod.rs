//! `strainsite solve`: one equilibrium of a scene.
//!
//! - `derivative_text`: its derivatives as text
//! - [`umbridge`]: equilibria that other programs ask for

mod derivative_text;
pub mod umbridge;

use std::fmt::Write;
use std::path::PathBuf;

use clap::Args;
use documents::sweep::typed_settings;
use fem_client::scene::Scene;
use fem_client::scene::slips::noting;
use fem_client::solver::direction::Direction;
use fem_client::solver::film_comparison::compare_film;
use fem_client::solver::gauge::{Gauge, GaugeReading};
use fem_client::solver::{
    FilmCondition, FilmSignal, FilmState, LocationStrain, Readout, SolveError, SolveRequest, Solved,
};
use serde_json::{Value, json};
use vtu::solved_body::Body;

use self::derivative_text::{MICROSTRAIN, derivative_text};
use crate::cli::solver_option::SolverOption;
use crate::cli::terminal::exit::Failure;
use crate::cli::terminal::files::Files;
use crate::cli::terminal::output::{JsonTarget, tell};
use crate::cli::terminal::output_place::write;
use crate::cli::terminal::paint::{HEADER, painted};
use crate::cli::terminal::progress::clock;
use crate::cli::terminal::signals::stop_flag;
use crate::cli::terminal::slip_text::slip_lines;
use service::study_document::{format_of, read_scene_file};
use service::wire::scene_wire::SolvedScene;

/// Solve one equilibrium of a scene
#[derive(Debug, Args)]
pub struct Solve {
    /// Scene file, TOML or JSON, or the name of a shipped scene
    scene: PathBuf,
    /// Change one field of the scene, as in ground.depths_mm=[1,1,1,1,1] or pressure.internal_mpa=0.15
    #[arg(long, value_name = "KEY=VALUE")]
    set: Vec<String>,
    #[command(flatten)]
    solver: SolverOption,
    /// Read the strain at a point of the inner surface, along a direction: wheel angle from the contact centre, section angle
    /// from the crown, and angle to the circumferential direction (0 when left out), all in degrees
    #[arg(long, value_name = "THETA,PHI[,ANGLE]", allow_hyphen_values = true)]
    at: Vec<Gauge>,
    /// Differentiate the answer by numbers of the scene, as in ground.depths_mm[2],pressure.internal_mpa
    #[arg(long, value_name = "KEY,...", value_delimiter = ',')]
    derivatives: Vec<String>,
    /// Write the whole solved mesh for ParaView: displacements and stresses
    #[arg(long, value_name = "FILE")]
    vtu: Option<PathBuf>,
    /// Write the answer as JSON to a file, or to standard output with -
    #[arg(long, value_name = "FILE|-")]
    pub json: Option<JsonTarget>,
}

impl Solve {
    /// Returns the files that it reads and writes.
    pub fn files(&self) -> Files {
        Files::default()
            .reading([&self.scene])
            .writing(self.vtu.as_deref())
            .telling(self.json.as_ref())
    }

    /// Solves and prints.
    pub fn execute(&self) -> Result<(), Failure> {
        let scene = self.scene()?;
        if self.vtu.is_some() && !self.solver.keeps_equilibria() {
            return Err(Failure::input(
                "--vtu needs the equilibrium on its mesh, which CalculiX doesn't hand over: leave out --solver",
            ));
        }
        let solver = self.solver.solver().map_err(Failure::other)?;
        let runtime = tokio::runtime::Runtime::new().map_err(Failure::other)?;
        let stop = stop_flag(&runtime)?;
        let readout = Readout {
            gauges: self.at.clone(),
            derivatives: self.derivatives.clone(),
            ..Readout::default()
        };
        let request = SolveRequest {
            scene: &scene,
            readout: &readout,
            start: None,
            watch: &*stop,
        };
        let waiting = clock("solving");
        let solved = solver.solve(&request).and_then(|mut solved| {
            compare_film(&*solver, &request, &mut solved)?;
            Ok(solved)
        });
        waiting.finish_and_clear();
        let solved = solved.map_err(|error| failure(&scene, error))?;
        if let Some(path) = &self.vtu {
            let version = format!(
                "strainsite {}, solver {}",
                env!("CARGO_PKG_VERSION"),
                solver.version()
            );
            write(path, picture(&scene, &solved, &version)?.as_bytes())?;
        }
        let answer = SolvedScene::of(&scene, &solved).map_err(Failure::other)?;
        if let Some(target) = &self.json {
            target.write(&json!(answer))?;
        }
        let text = report(&solved, scene.ground.is_dragged() || scene.ground.leans());
        tell(&(slip_lines(answer.unlikely) + &text), self.json.as_ref())
    }

    fn scene(&self) -> Result<Scene, Failure> {
        let text = read_scene_file(&self.scene).map_err(Failure::Input)?;
        let mut scene = Scene::from_text(&text, format_of(&self.scene)).map_err(Failure::Input)?;
        let changes = typed_settings(&self.set).map_err(Failure::Input)?;
        let changes: Vec<(&str, &Value)> = changes
            .iter()
            .map(|(path, value)| (path.as_str(), value))
            .collect();
        if !changes.is_empty() {
            scene.set_all(&changes).map_err(Failure::Input)?;
        }
        Ok(scene)
    }
}

fn failure(scene: &Scene, error: SolveError) -> Failure {
    match error {
        SolveError::Refused { faults } => Failure::Input(faults),
        SolveError::NoEquilibrium {
            status,
            detail,
            reached,
        } => Failure::Physics {
            status: status.as_str().to_owned(),
            detail: noting(detail, &scene.slips()),
            known: json!({"reached": reached}),
        },
        SolveError::Stopped => Failure::Other("stopped on request; nothing was solved".to_owned()),
        SolveError::Broken { .. } | SolveError::Crashed { .. } | SolveError::OverTime { .. } => {
            Failure::other(error)
        }
    }
}

/// The solved mesh as a VTU file.
fn picture(scene: &Scene, solved: &Solved, version: &str) -> Result<String, Failure> {
    let body = Body::of(scene, &solved.state);
    let body =
        body.ok_or_else(|| Failure::other("the solver handed over no equilibrium on a mesh"))?;
    body.grid(version).to_xml().map_err(Failure::other)
}

fn film_signal(film: &FilmState, signal: &FilmSignal) -> String {
    let beyond = match signal.state {
        FilmCondition::Ok => "",
        FilmCondition::BeyondYield => {
            "; beyond yield: an elastic film's signal, which this one won't give"
        }
        FilmCondition::Saturated => "; beyond the amplifier's supply, which is all that it shows",
        FilmCondition::Wrinkled => "; compressed beyond the strain at which it folds",
    };
    let volts = film.error.map_or(String::new(), |error| {
        format!(" +- {:.2}", error.open_circuit_v)
    });
    let bare = film.bare.map_or(String::new(), |bare| {
        format!(
            "film without stiffness: strain along {:.0}, across {:.0} microstrain, {:.2} V open circuit\n",
            1e6 * bare.mean_strain_1,
            1e6 * bare.mean_strain_2,
            bare.open_circuit_v
        )
    });
    format!(
        "film, since inflation: strain along {:.0}, across {:.0} microstrain; tension {:.4}, {:.4} N/mm; curvature {:.4}, {:.4} /mm\n\
         film: {:.3} nC on {:.1} pF, {:.2}{volts} V open circuit, {:.4} +- {:.4} V at the amplifier{beyond}\n{bare}",
        1e6 * signal.mean_strain_1,
        1e6 * signal.mean_strain_2,
        signal.mean_tension_1_n_per_mm,
        signal.mean_tension_2_n_per_mm,
        signal.curvature_change_1_per_mm,
        signal.curvature_change_2_per_mm,
        signal.charge_nc,
        signal.capacitance_pf,
        signal.open_circuit_v,
        signal.output_v,
        signal.output_std_v
    )
}

/// `is_askew`: the ground does more than push along the wheel's vertical.
fn report(solved: &Solved, is_askew: bool) -> String {
    let response = &solved.response;
    let mut text = String::new();
    // Writing to a string cannot fail.
    let _ = writeln!(text, "reaction            {:12.4} N", response.reaction_n);
    let parts = [
        ("force x, y, z", response.force_n, "N"),
        ("moment x, y, z", response.moment_nmm, "N mm"),
    ];
    for (what, vector, unit) in parts.into_iter().filter(|_| is_askew) {
        let Some([x, y, z]) = vector else { continue };
        let _ = writeln!(
            text,
            "{what:<20}{x:12.4} {y:12.4} {z:12.4} {unit}, in the wheel's frame"
        );
    }
    let _ = writeln!(text, "depth               {:12.4} mm", response.depth_mm);
    let _ = writeln!(
        text,
        "inflated radius     {:12.4} mm",
        response.inflated.outer_radius_mm
    );
    heading(
        &mut text,
        "strain since inflation, microstrain      x circumferential           y meridional      von Mises MPa",
    );
    for location in &response.locations {
        let _ = writeln!(text, "{}", location_row(location));
    }
    if !response.gauges.is_empty() {
        heading(
            &mut text,
            "theta, phi, angle deg       strain since inflation, microstrain    stretch and Green-Lagrange, undeformed",
        );
    }
    for reading in &response.gauges {
        let _ = writeln!(text, "{}", gauge_row(reading));
    }
    text.push_str(&derivative_text(&response.derivatives));
    if let Some(film) = &response.film {
        let (x, y) = (film.stretch.x, film.stretch.y);
        let _ = writeln!(
            text,
            "\nfilm: stretch x {:.4} to {:.4}, y {:.4} to {:.4}",
            x.min, x.max, y.min, y.max
        );
    }
    if let Some(film) = &response.film {
        text.push_str(&film_signal(film, &film.signal));
    }
    if let Some(carcass) = &response.carcass {
        let (stretch, tension) = (carcass.fibre_stretch, carcass.tension_n_per_mm);
        let _ = writeln!(
            text,
            "\ncarcass: fibre stretch {:.4} to {:.4}, tension {:.3} to {:.3} N/mm",
            stretch.min, stretch.max, tension.min, tension.max
        );
    }
    heading(
        &mut text,
        "load step   relative residuals of Newton's iterations",
    );
    for (step, residuals) in response.residual_history.iter().enumerate() {
        let residuals: Vec<String> = residuals
            .iter()
            .map(|residual| format!("{residual:.1e}"))
            .collect();
        let _ = writeln!(text, "{:9}   {}", step + 1, residuals.join("  "));
    }
    let model = &response.model;
    let _ = writeln!(
        text,
        "\n{} model, level {}: {} elements, {} unknowns; {} Newton iterations in {:.2} s",
        model.dimension,
        model.level,
        model.elements,
        model.dofs,
        response.newton_iterations,
        solved.cost.wall_s
    );
    text
}

/// The head of a table, below an empty line.
fn heading(text: &mut String, line: &str) {
    let _ = writeln!(text, "\n{}", painted(HEADER, line));
}

/// A value with its error, both in units of `unit`; the error is left out where there is no estimate.
fn with_error(value: f64, error: Option<f64>, unit: f64, decimals: usize) -> String {
    let error = error.map_or_else(String::new, |error| {
        format!(" +-{:.decimals$}", error / unit)
    });
    format!("{:.decimals$}{error}", value / unit)
}

fn location_row(location: &LocationStrain) -> String {
    let error = location.error;
    let strain = |direction| {
        let error = error.map(|e| e.strain[direction]);
        with_error(location.strain[direction], error, MICROSTRAIN, 1)
    };
    format!(
        "{:4} at {:8.3} deg {:>35} {:>22} {:>18}",
        location.name,
        location.theta_deg,
        strain(Direction::X),
        strain(Direction::Y),
        with_error(
            location.von_mises_mpa,
            error.map(|e| e.von_mises_mpa),
            1.0,
            5
        ),
    )
}

fn gauge_row(reading: &GaugeReading) -> String {
    let (gauge, error) = (reading.gauge, reading.error);
    format!(
        "{:8.3} {:8.3} {:8.3} {:>36} {:>21} {:>21}",
        gauge.theta_deg,
        gauge.phi_deg,
        gauge.angle_deg,
        with_error(reading.strain, error.map(|e| e.strain), MICROSTRAIN, 1),
        with_error(reading.stretch, error.map(|e| e.stretch), 1.0, 5),
        with_error(
            reading.green_lagrange,
            error.map(|e| e.green_lagrange),
            1.0,
            5
        ),
    )
}

#[cfg(test)]
mod tests {
    use std::sync::atomic::AtomicBool;

    use super::*;
    use document::fault::Fault;
    use fem_client::closed_form::ClosedFormSolver;
    use fem_client::solver::{NoEquilibrium, Reached, Solver};

    #[test]
    fn the_document_has_the_fields_that_scripts_read() {
        let (scene, stop) = (Scene::default(), AtomicBool::new(false));
        let request = SolveRequest {
            scene: &scene,
            readout: &Readout::default(),
            start: None,
            watch: &stop,
        };
        let mut solved = ClosedFormSolver::new().solve(&request).expect("solves");
        let document = json!(SolvedScene::of(&scene, &solved).expect("finite"));
        assert_eq!(document["status"], "converged");
        for field in [
            "reaction_n",
            "max_volume_change",
            "newton_iterations",
            "wall_s",
        ] {
            assert!(document[field].is_number(), "{field}");
        }
        for pointer in [
            "/locations/2/strain_x",
            "/section/sidewall/strain_y",
            "/inflated/crown_stretch_x",
            "/error/strain_x",
        ] {
            assert!(
                document.pointer(pointer).is_some_and(Value::is_number),
                "{pointer}"
            );
        }
        assert!(document["model"].is_object() && document.get("map").is_none());
        assert!(report(&solved, false).contains("P3"));
        solved.response.force_n = Some([1.25, -0.5, 13.0]);
        solved.response.moment_nmm = Some([86.5, 0.0, -2.0]);
        assert!(!report(&solved, false).contains("force"));
        let askew = report(&solved, true);
        assert!(askew.contains("1.2500      -0.5000      13.0000 N, in the wheel's frame"));
        assert!(askew.contains("86.5000       0.0000      -2.0000 N mm"));
    }

    #[test]
    fn a_missing_equilibrium_says_how_far_it_got() {
        let reached = Reached {
            pressure_mpa: 0.11,
            ..Reached::default()
        };
        let status = NoEquilibrium::LimitPoint;
        let error = SolveError::NoEquilibrium {
            status,
            detail: "at 0.12 MPa".to_owned(),
            reached,
        };
        let mut scene = Scene::default();
        let failure = failure(&scene, error.clone());
        assert_eq!(failure.code(), 3);
        let expected = json!({"status": "limit-point", "detail": "at 0.12 MPa", "reached": {"pressure_mpa": 0.11}});
        assert_eq!(failure.document(), expected);
        let refused = vec![Fault {
            pointer: "/contact/friction".to_owned(),
            detail: "must be 0".to_owned(),
        }];
        assert_eq!(
            super::failure(&scene, SolveError::Refused { faults: refused }).to_string(),
            "/contact/friction: must be 0\n"
        );
        scene.pressure.internal_mpa = 2.0;
        let told = super::failure(&scene, error).to_string();
        assert!(
            told.contains("at 0.12 MPa; unlikely value in pressure.internal_mpa"),
            "{told}"
        );
    }
}
