//! Layouts of glued films: what a tire of known transfer gives, and what documents say.

use documents::study::Study;
use documents::study::plan::PlannedStudy;
use fem_client::closed_form::ClosedFormSolver;
use fem_client::scene::Film;
use fem_client::solver::direction::PerDirection;
use fem_client::solver::{
    Extremes, FilmMeans, FilmSignal, FilmState, RingLine, SolveError, SolveRequest, Solved, Solver,
};
use placement::estimate::Workload;
use results::{StrainRing, StudyResult};
use serde_json::{Value, json};

use crate::support::{MemoryArchive, observed};

/// Tensions along and across, N/mm, by strains along and across.
const TRANSFER: [[f64; 2]; 2] = [[40.0, 3.0], [2.0, 30.0]];

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

fn tension(strain: [f64; 2]) -> [f64; 2] {
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
    let bare = answered(&read(&document(&json!({}), tiny())), false);
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
        pointers(json!({"film": "coupled"}), tiny()),
        ["/layouts/film"]
    );
    assert_eq!(
        pointers(json!({"noise_v": 0.5}), tiny()),
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
