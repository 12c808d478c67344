//! Films' signals: documents that ask for them, and what a tire of known response gives.

use documents::parts::film_model::FilmModel;
use documents::study::Study;
use documents::study::plan::PlannedStudy;
use fem_client::closed_form::ClosedFormSolver;
use fem_client::film::laminate::product;
use fem_client::scene::{Film, Level, Scene};
use fem_client::solver::direction::PerDirection;
use fem_client::solver::gauge::GaugeReading;
use fem_client::solver::{
    Coarser, Extremes, FilmMeans, FilmSignal, FilmState, NoEquilibrium, Reached, SolveError,
    SolveRequest, Solved, Solver,
};
use placement::estimate::{Machine, Workload, estimate};
use results::Claim;
use results::Holds;
use results::SignalAxis;
use results::SignalRow;
use results::Signals;
use results::StudyResult;
use results::Trend;
use serde_json::{Value, json};

use crate::support::{MemoryArchive, observed};

/// The coarser mesh reads a tenth more.
const COARSE: f64 = 1.1;
const FACTOR: f64 = 1.5;
const TRANSFER: [[f64; 2]; 2] = [[40.0, 3.0], [2.0, 30.0]];

/// A tire whose films read strains of a formula, and tensions of a matrix when they are glued.
struct KnownTire {
    /// Load beyond which there is no equilibrium, N.
    most_n: f64,
}

impl KnownTire {
    /// Strains along and across a film: they rise with the load, fall with the pressure and with the angle from the contact.
    fn strain(&self, scene: &Scene, film: &Film) -> [f64; 2] {
        let load = scene.ground.load_n.expect("pressed by force");
        let mesh = match scene.model.level {
            Level::Draft => COARSE,
            _ => 1.0,
        };
        let near = 1.0 - film.theta_deg.abs() / 100.0;
        let stiff = 0.2 / scene.pressure.internal_mpa;
        let across = if film.angle_deg == 0.0 { 0.3 } else { 0.7 };
        let along = 1e-4 * load * stiff * near * mesh;
        [along, across * along * (1.0 + load / 50.0)]
    }

    fn bare(&self, scene: &Scene, film: &Film) -> FilmSignal {
        signal(film, self.strain(scene, film))
    }

    fn glued(&self, scene: &Scene, film: &Film) -> FilmSignal {
        let [e1, e2] = self.strain(scene, film);
        let tension = TRANSFER.map(|row| row[0] * e1 + row[1] * e2);
        // The strain that gives this tension: nu couples the two.
        let [[a, b, _], ..] = film.laminate().membrane;
        let determinant = a * a - b * b;
        signal(
            film,
            [
                (a * tension[0] - b * tension[1]) / determinant,
                (a * tension[1] - b * tension[0]) / determinant,
            ],
        )
    }
}

fn signal(film: &Film, strain: [f64; 2]) -> FilmSignal {
    let means = FilmMeans {
        area: film.length_mm * film.width_mm,
        strain,
        added: [strain[0], strain[1], 0.0],
        ..FilmMeans::default()
    };
    FilmSignal::of(film, &means)
}

impl Solver for KnownTire {
    fn version(&self) -> String {
        format!("known tire up to {} N", self.most_n)
    }

    fn coarser(&self, scene: &Scene) -> Option<Coarser> {
        (scene.model.level != Level::Draft).then_some(Coarser {
            level: Level::Draft,
            factor: FACTOR,
            of_largest: FACTOR,
        })
    }

    fn solve(&self, request: &SolveRequest<'_>) -> Result<Solved, SolveError> {
        let Some(load) = request.scene.ground.load_n else {
            return ClosedFormSolver::new().solve(request);
        };
        if load > self.most_n {
            return Err(SolveError::NoEquilibrium {
                status: NoEquilibrium::SelfContact,
                detail: "the tire touches itself".to_owned(),
                reached: Reached::default(),
            });
        }
        let mut scene = request.scene.clone();
        scene.ground = scene.ground.at_depths(vec![0.05 * load; 5]);
        scene.film = None;
        let mut solved = ClosedFormSolver::new().solve(&SolveRequest {
            scene: &scene,
            ..*request
        })?;
        let response = &mut solved.response;
        response.depth_mm = 0.05 * load;
        let films = request.readout.films.iter();
        response.films = films.map(|film| self.bare(request.scene, film)).collect();
        for reading in &mut response.gauges {
            let GaugeReading {
                gauge,
                von_mises_mpa,
                ..
            } = reading;
            let width = 2.0 + load / 2.0;
            *von_mises_mpa = 0.1 + 0.01 * load * (-0.5 * (gauge.theta_deg / width).powi(2)).exp();
        }
        response.film = request.scene.film.as_ref().map(|film| {
            let any = || PerDirection::of(|_| Extremes { min: 1.0, max: 1.0 });
            FilmState {
                stretch: any(),
                tension_n_per_mm: any(),
                signal: self.glued(request.scene, film),
                bare: None,
                error: None,
            }
        });
        Ok(solved)
    }
}

fn document(signals: Value) -> Value {
    json!({
        "name": "films",
        "scene": {"preset": "foot-tire"},
        "inputs": [{
            "name": "P3",
            "vary": "ground.depths_mm[2]",
            "distribution": {"kind": "uniform", "min": 0.7, "max": 1.3},
        }],
        "layouts": {"spacings_deg": []},
        "method": {"kind": "mdrm", "nodes": 3, "check_points": 0},
        "accuracy": {"preset": "coarse"},
        "signals": signals,
    })
}

fn read(signals: Value) -> Study {
    Study::from_value(&document(signals), &|path| Err(format!("no file {path}"))).unwrap()
}

fn solved(study: &Study, most_n: f64) -> StudyResult {
    let archive = MemoryArchive::default();
    let (result, _) = observed(study, &KnownTire { most_n }, &archive, 2);
    let result = result.unwrap();
    let (again, _) = observed(study, &KnownTire { most_n }, &archive, 1);
    assert_eq!(
        again.unwrap().signals,
        result.signals,
        "a resumed study is the same"
    );
    result
}

fn signals(study: &Study, most_n: f64) -> Signals {
    solved(study, most_n).signals.expect("asked for")
}

fn close(a: Option<f64>, b: f64) {
    let a = a.expect("a number");
    assert!((a - b).abs() <= 1e-9 * b.abs().max(1e-9), "{a} {b}");
}

#[test]
fn a_study_without_signals_is_written_as_before() {
    let mut plain = document(json!({}));
    plain.as_object_mut().unwrap().shift_remove("signals");
    let study = Study::from_value(&plain, &|path| Err(path.to_owned())).unwrap();
    assert!(!study.canonical().contains("signals"));
    assert_eq!(solved(&study, 100.0).signals, None);
}

#[test]
fn an_empty_table_has_every_default_and_reads_back() {
    let study = read(json!({"tires": [{"name": "other", "scene": {"geometry": {"wall_mm": 5}}}]}));
    let text = study.canonical();
    let value: Value = serde_json::from_str(&text).unwrap();
    let signals = &value["signals"];
    assert_eq!(
        signals["loads_n"],
        json!([1.0, 2.0, 5.0, 10.0, 15.0, 20.0, 30.0])
    );
    assert_eq!(signals["contact_deg"].as_array().map(Vec::len), Some(7));
    assert_eq!(signals["films"], json!(["bare", "transfer", "coupled"]));
    assert_eq!(signals["film"]["thickness_mm"], 0.028);
    assert_eq!(signals["film"].get("phi_deg"), None);
    assert_eq!(signals["tires"][0]["scene"]["model"]["level"], "coarse");
    let back = Study::from_canonical(&text).unwrap();
    assert_eq!((back.canonical(), back), (text, study));
}

#[test]
fn a_further_tire_may_have_loads_and_pressures_of_its_own() {
    let study = read(
        json!({"positions": ["crown"], "directions": ["x"], "films": ["bare"], "tires": [
        {"name": "weak", "scene": {}, "loads_n": [1, 3], "pressures_mpa": [0.05], "at_load_n": 2, "contact_load_n": 3}]}),
    );
    assert_eq!(Study::from_canonical(&study.canonical()), Ok(study.clone()));
    let signals = solved(&study, 100.0).signals.expect("asked for");
    let asked = |tire: &str, over| -> Vec<[f64; 2]> {
        let rows = signals.rows.iter();
        let rows = rows.filter(|row| row.tire == tire && row.over == over);
        rows.map(|row| [row.load_n, row.pressure_mpa]).collect()
    };
    assert_eq!(asked("weak", SignalAxis::Load), [[1.0, 0.2], [3.0, 0.2]]);
    assert_eq!(asked("weak", SignalAxis::Pressure), [[2.0, 0.05]]);
    assert!(
        asked("weak", SignalAxis::Contact)
            .iter()
            .all(|at| at[0] == 3.0)
    );
    assert_eq!(asked("own", SignalAxis::Load).len(), 7);
}

#[test]
fn the_scene_s_film_is_that_of_its_signals() {
    let mut document = document(json!({}));
    document["scene"]["film"] = json!({"thickness_mm": 0.11, "phi_deg": 45});
    let study = Study::from_value(&document, &|path| Err(path.to_owned())).unwrap();
    let film = study.signals.unwrap().film;
    assert_eq!((film.thickness_mm(), film.phi_deg), (0.11, 0.0));
}

#[test]
fn every_fault_of_signals_has_its_place() {
    let pointers = |signals: Value| -> Vec<String> {
        let faults = Study::from_value(&document(signals), &|path| Err(format!("no {path}")));
        let faults = faults.expect_err("has faults").into_iter();
        faults.map(|fault| fault.pointer).collect()
    };
    let faulty = json!({
        "loads_n": [1, -2, "x", 1], "pressures_mpa": [], "at_load_n": -1, "contact_load_n": null,
        "contact_deg": [0, 181], "positions": ["crown", "bead"], "directions": ["z"], "films": ["bare", "bare"],
        "film": {"thickness_mm": 0, "theta_deg": 3, "angle_deg": 1},
        "tires": [{"name": "own", "scene": {}}, {"name": "a", "scene": "gone.toml"}, {"scene": {"tyre": 1}, "at": 2, "loads_n": [], "at_load_n": -1}],
        "load": 3,
    });
    assert_eq!(
        pointers(faulty),
        [
            "/signals/load",
            "/signals/loads_n/1",
            "/signals/loads_n/2",
            "/signals/loads_n/3",
            "/signals/pressures_mpa",
            "/signals/at_load_n",
            "/signals/contact_load_n",
            "/signals/contact_deg/1",
            "/signals/positions/1",
            "/signals/directions/0",
            "/signals/films/1",
            "/signals/tires/1/scene",
            "/signals/tires/2/at",
            "/signals/tires/2/name",
            "/signals/tires/2/scene/tyre",
            "/signals/tires/2/loads_n",
            "/signals/tires/2/at_load_n",
            "/signals/film/theta_deg",
            "/signals/film/angle_deg",
            "/signals/film/thickness_mm",
        ]
    );
    assert_eq!(pointers(json!(3)), ["/signals"]);
    assert_eq!(pointers(json!({"film": 3})), ["/signals/film"]);
    assert_eq!(
        pointers(json!({"loads_n": vec![1; 65]})),
        ["/signals/loads_n"]
    );
    let tire = |name: &str, scene: Value| json!({"name": name, "scene": scene});
    let named = json!({"tires": [tire("own", json!({})), tire("a", json!({})), tire("a", json!({"geometry": {"wall_mm": 4}}))]});
    assert_eq!(
        pointers(named),
        ["/signals/tires/0/name", "/signals/tires/2/name"]
    );
    // The film is thicker than a tenth of that tire's wall, and runs onto a bead that is nearer.
    let thin = tire("thin", json!({"geometry": {"wall_mm": 0.2}}));
    assert_eq!(
        pointers(json!({"tires": [thin]})),
        ["/signals/tires/0/scene"]
    );
    let mut short = document(json!({}));
    short["scene"]["geometry"] = json!({"bead_angle_deg": 80});
    let faults = Study::from_value(&short, &|path| Err(path.to_owned())).expect_err("no sidewall");
    let pointers: Vec<&str> = faults.iter().map(|fault| fault.pointer.as_str()).collect();
    assert_eq!(pointers, ["/signals/positions/2"]);
}

fn row(signals: &Signals, film: FilmModel, over: SignalAxis, at: [f64; 3]) -> &SignalRow {
    let rows = signals.rows.iter();
    let mut found = rows.filter(|row| {
        row.film == film
            && row.over == over
            && [row.load_n, row.pressure_mpa, row.contact_deg] == at
    });
    found.next().expect("a row")
}

#[test]
fn a_known_tire_gives_its_signals_with_their_errors() {
    let study = read(json!({"positions": ["crown"], "directions": ["x"]}));
    let result = solved(&study, 100.0);
    let signals = result.signals.as_ref().expect("asked for");
    assert_eq!(signals.rows.len(), 3 * (7 + 3 + 7));
    let film = study.signals.as_ref().unwrap().film.clone();
    let at = [15.0, 0.2, 0.0];
    let bare = row(signals, FilmModel::Bare, SignalAxis::Load, at);
    close(bare.strain, 1.5e-3);
    close(bare.depth_mm, 0.75);
    let error = bare.error.expect("two meshes");
    close(Some(error.strain), FACTOR * (COARSE - 1.0) * 1.5e-3);
    close(
        Some(error.open_circuit_v),
        FACTOR * (COARSE - 1.0) * bare.open_circuit_v.unwrap(),
    );
    let tension = product(
        &film.laminate().membrane,
        &[1.5e-3, 0.3 * 1.3 * 1.5e-3, 0.0],
    );
    close(bare.tension_1_n_per_mm, tension[0]);
    // The coupled tire is linear in the bare one's strains: the transfer that two loads give holds at all points.
    for (over, at) in [
        (SignalAxis::Load, at),
        (SignalAxis::Load, [30.0, 0.2, 0.0]),
        (SignalAxis::Pressure, [10.0, 0.1, 0.0]),
        (SignalAxis::Contact, [20.0, 0.2, 25.0]),
    ] {
        let coupled = row(signals, FilmModel::Coupled, over, at);
        let transfer = row(signals, FilmModel::Transfer, over, at);
        for part in [
            |r: &SignalRow| r.tension_1_n_per_mm,
            |r: &SignalRow| r.charge_nc,
            |r: &SignalRow| r.strain,
        ] {
            close(part(transfer), part(coupled).unwrap());
        }
        assert!(transfer.state.is_none() && coupled.state.is_some());
    }
    assert_eq!(signals.curves.len(), 9);
    for curve in &signals.curves {
        let expected = match curve.over {
            SignalAxis::Load => Trend::Up,
            SignalAxis::Pressure | SignalAxis::Contact => Trend::Down,
        };
        assert_eq!(curve.monotone, Some(expected), "{curve:?}");
    }
    let holds = |claim: Claim| {
        let claims = signals.claims.iter().filter(|row| row.claim == claim);
        claims.map(|row| row.holds).collect::<Vec<_>>()
    };
    // From 15 to 20 N the voltage rises by a third, and both ends may be off by 15 % of themselves.
    assert_eq!(holds(Claim::RisesWithLoad), [Holds::Uncertain; 3]);
    assert_eq!(holds(Claim::FallsWithPressure), [Holds::Yes; 3]);
    assert_eq!(holds(Claim::Linear), [Holds::Yes; 3]);
    // 1 - |c - 30| / 100 minus 1 - |c + 30| / 100 is 2 c / 100: a line.
    let pairs: Vec<_> = signals.pairs.iter().map(|pair| pair.film).collect();
    assert_eq!(pairs, [FilmModel::Bare, FilmModel::Coupled]);
    for pair in &signals.pairs {
        assert_eq!(
            (pair.monotone, pair.values[0]),
            (Some(Trend::Up), Some(0.0))
        );
        close(pair.linear_r2, 1.0);
    }
    let widths: Vec<f64> = signals
        .widths
        .iter()
        .map(|w| w.width_deg.unwrap())
        .collect();
    for (width, load) in widths.iter().zip([1.0, 2.0, 5.0, 10.0, 15.0, 20.0, 30.0]) {
        assert!(
            (width - (2.0 + load / 2.0)).abs() < 1e-6,
            "{width} at {load} N"
        );
    }
    // 9 of the bare tire, 21 glued, on two meshes.
    assert_eq!(result.cost.signal_solves, 60);
    let planned = PlannedStudy::new(study.clone()).unwrap();
    let work = Workload::of(&planned, &KnownTire { most_n: 100.0 });
    let expected = estimate(&work, &|_| false, &Machine::new(2));
    assert_eq!(expected.solves.signals, 60);
}

#[test]
fn what_has_no_equilibrium_is_a_row_with_its_reason() {
    let study = read(json!({"positions": ["crown"], "directions": ["y"]}));
    let signals = signals(&study, 25.0);
    let gone: Vec<_> = signals
        .rows
        .iter()
        .filter(|row| row.reason.is_some())
        .collect();
    assert_eq!(gone.len(), 3, "30 N of each film");
    for row in gone {
        assert_eq!(
            (row.load_n, row.open_circuit_v, row.error),
            (30.0, None, None)
        );
        assert!(
            row.reason.as_ref().unwrap().contains("touches itself"),
            "{row:?}"
        );
    }
    let width = signals.widths.last().unwrap();
    assert_eq!((width.load_n, width.width_deg), (30.0, None));
}

#[test]
fn where_the_middle_has_no_equilibrium_all_begin_at_the_least_load() {
    let study = read(json!({"positions": ["crown"], "directions": ["y"], "films": ["bare"]}));
    let signals = signals(&study, 7.0);
    let solved: Vec<f64> = signals
        .rows
        .iter()
        .filter(|row| row.open_circuit_v.is_some())
        .map(|row| row.load_n)
        .collect();
    assert_eq!(solved, [1.0, 2.0, 5.0]);
}

#[test]
fn a_solver_that_presses_by_depth_alone_costs_the_signals_not_the_study() {
    let study = read(json!({"films": ["bare", "transfer"]}));
    let result = crate::support::answered(&study);
    let signals = result.signals.expect("asked for");
    assert_eq!(signals.rows.len(), 2 * 6 * 17);
    assert!(signals.rows.iter().all(|row| row.reason.is_some()));
    assert!(
        signals
            .claims
            .iter()
            .all(|row| row.holds == Holds::Uncertain)
    );
}
