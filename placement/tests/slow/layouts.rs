//! Layouts on the foot tire's own meshes, against figures of independent scripts on the same tire.

use std::sync::atomic::AtomicBool;

use documents::layouts::layout_settings::{LayoutLoads, Layouts};
use documents::study::Study;
use documents::study::plan::Plan;
use fem_client::scene::{Film, Level, Scene};
use fem_client::solver::{Readout, Response, SolveRequest, Solver};
use layouts::arrangement::{Arrangement, FilmKind};
use layouts::field::film_field::Noise;
use layouts::fisher::bounds::bounds;
use placement::ladder::climb;
use placement::layout::solving::layout_fields::{MeshFields, mesh_fields, samples};
use placement::layout::solving::layout_scenes::{LayoutScenes, readout};
use placement::layout::solving::mirror_parts::mirrored;
use placement::layout::solving::shear_fields::shear_field;
use placement::points::RunContext;
use placement::points::memory::MemoryArchive;
use results::{SignalAxis, StudyResult};
use serde_json::json;
use tire::embedded::EmbeddedSolver;

/// The crown's two kinds of film.
fn crown() -> [FilmKind; 2] {
    [0.0, 90.0].map(|angle_deg| FilmKind::point(0.0, angle_deg))
}

/// See the test that uses it.
const THIRD_ORDER: f64 = 0.06 / 5.0;

/// The crown's fields at 1 mm, on a mesh that is fine to 60 degrees.
fn fields(level: Level) -> MeshFields {
    let settings = Layouts {
        films: Vec::new(),
        spacings_deg: vec![30.0, 45.0, 60.0, 72.0, 90.0, 120.0, 180.0],
        loads: LayoutLoads::Depths(vec![1.0]),
        ..Layouts::default()
    };
    let scene = Scene::preset("foot-tire").expect("ships");
    let scenes = LayoutScenes::of(&settings, &scene).expect("a load");
    let (solver, stop, readout) = (
        EmbeddedSolver::default(),
        AtomicBool::new(false),
        readout(&crown()),
    );
    let (mut start, mut outcomes) = (None, Vec::new());
    for scene in &scenes.scenes(level) {
        let request = SolveRequest {
            scene,
            readout: &readout,
            start: start.as_ref(),
            watch: &stop,
        };
        let solved = solver.solve(&request).expect("an equilibrium");
        outcomes.push(Ok(solved.response));
        start.get_or_insert(solved.state);
    }
    mesh_fields(&scenes, &crown(), &outcomes).expect("fields")
}

/// Strains of both kinds around the wheel with the ground dragged so far, and the force; without the fine mesh, which costs time and tells no sign.
fn dragged(scene: &Scene, kinds: &[FilmKind], shift_mm: [f64; 2]) -> Response {
    let mut scene = scene.clone();
    scene.ground.shift_mm = shift_mm;
    let readout = Readout {
        fine_deg: None,
        ..mirrored(kinds)
    };
    let request = SolveRequest {
        scene: &scene,
        readout: &readout,
        start: None,
        watch: &AtomicBool::new(false),
    };
    let solved = EmbeddedSolver::default().solve(&request);
    solved.expect("an equilibrium").response
}

/// Slopes of one solve with both shifts, taken apart by symmetry, against central differences of solves with one shift each. Both leave out the third order in
/// the shift, not the same one: at 0.1 mm, five times as far, the foot tire's ground pulls 6 % less per millimetre, of which a fifth is left at most.
#[test]
fn slopes_over_the_ground_s_shift_are_those_of_separate_solves() {
    let kinds =
        [(0.0, 0.0), (45.0, 90.0)].map(|(phi_deg, angle_deg)| FilmKind::point(phi_deg, angle_deg));
    let mut scene = Scene::preset("foot-tire").expect("ships");
    scene.contact.friction = 0.5;
    let settings = Layouts {
        films: Vec::new(),
        spacings_deg: vec![30.0, 45.0, 60.0, 72.0, 90.0, 120.0, 180.0],
        loads: LayoutLoads::Depths(vec![1.0]),
        ..Layouts::default()
    };
    let scenes = LayoutScenes::of(&settings, &scene).expect("a load");
    let sheared = &scenes.sheared(Level::Draft)[0];
    let shift = scenes.shift_mm();
    let response = dragged(sheared, &kinds, [shift; 2]);
    let both = shear_field(&scenes, &kinds, &response).expect("all that was asked");
    for axis in 0..2 {
        let [there, back] = [shift, -shift].map(|by| {
            let mut shift = [0.0; 2];
            shift[axis] = by;
            dragged(sheared, &kinds, shift)
        });
        let of = |of: &dyn Fn(&Response) -> Vec<f64>| -> Vec<f64> {
            let values = of(&there).into_iter().zip(of(&back));
            values
                .map(|(there, back)| (there - back) / (2.0 * shift))
                .collect()
        };
        let pull = of(&|response| response.force_n.expect("a force").to_vec())[axis];
        assert!(
            (both.force_slopes[axis] / pull - 1.0).abs() < THIRD_ORDER,
            "{axis}: {pull}"
        );
        let crown = of(&|response| response.rings[0].strain.x.clone());
        let shoulder = of(&|response| response.rings[1].strain.y.clone());
        for (kind, expected) in [crown, shoulder].iter().enumerate() {
            let length =
                |slopes: &[f64]| slopes.iter().map(|slope| slope * slope).sum::<f64>().sqrt();
            let slopes = both.slopes[kind][axis].iter().zip(expected);
            let apart = length(&slopes.map(|(a, b)| a - b).collect::<Vec<_>>());
            // What symmetry makes nothing of is rounding.
            let limit = THIRD_ORDER * length(expected) + 1e-6;
            assert!(
                apart <= limit,
                "{axis} {kind}: {apart} of {}",
                length(expected)
            );
        }
    }
}

/// Worst bounds of the angle of x and y films at the crown, 1 mm, noise 2 % of the largest strain: found beforehand by scripts of NumPy on this tire's strains
/// on a mesh of 19 stations, within 1 % on the standard and the reference mesh.
#[test]
fn worst_bounds_are_those_found_beforehand() {
    let found = fields(Level::Standard);
    let field = found.fields.at(1.0);
    let noise = Noise {
        floor: 0.02 * found.crown,
        in_volts: false,
        gain_std: 0.0,
        place_std_deg: 0.0,
    };
    for (units, expected) in [(6, 22.1), (8, 22.7), (12, 3.06), (24, 0.28)] {
        let arrangement = Arrangement::regular(units, &[0, 1], false);
        let worst = bounds(&field, &arrangement, &noise)
            .expect("regular")
            .worst_angle_deg;
        assert!(
            (worst / expected - 1.0).abs() < 0.05,
            "{units} units: {worst} for {expected}"
        );
    }
    assert!(
        (field.force_n / 13.09 - 1.0).abs() < 0.005,
        "{}",
        field.force_n
    );
}

/// A film's mean over its points is what a film without stiffness gives that is laid on the mesh, which is integrated over its own spans. Both are the mean of
/// strains that are recovered at points, or derivatives of a surface that is fitted to displacements: seen apart by 1.2 % of the largest strain on the draft mesh,
/// 0.2 % on the standard one.
#[test]
fn a_film_of_a_size_reads_what_a_following_film_reads() {
    let scene = Scene::preset("foot-tire").expect("ships");
    for (level, size, most) in [
        (Level::Draft, [10.0, 5.0], 0.02),
        (Level::Standard, [10.0, 5.0], 0.005),
        (Level::Standard, [25.0, 10.0], 0.005),
    ] {
        let mut scene = scene.clone();
        scene.model.level = level;
        let kinds: Vec<FilmKind> = [0.0, 90.0]
            .map(|angle| FilmKind::sized(&scene.geometry, Some(size), 0.0, angle))
            .to_vec();
        let films = [0.0, 90.0].map(|angle_deg| Film {
            length_mm: size[0],
            width_mm: size[1],
            angle_deg,
            ..Film::default()
        });
        let readout = Readout {
            films: films.to_vec(),
            ..readout(&kinds)
        };
        let request = SolveRequest {
            scene: &scene,
            readout: &readout,
            start: None,
            watch: &AtomicBool::new(false),
        };
        let solved = EmbeddedSolver::default()
            .solve(&request)
            .expect("an equilibrium");
        let largest = solved.response.section.crown.y;
        for (kind, film) in kinds.iter().zip(&solved.response.films) {
            let mean = samples(&solved.response.rings, kind, &kinds).expect("lines")[180];
            assert!(
                (mean - film.mean_strain_1).abs() < most * largest,
                "{size:?}: {mean} {}",
                film.mean_strain_1
            );
        }
    }
}

fn answered(study: &Study) -> StudyResult {
    let context = RunContext {
        solver: &EmbeddedSolver::default(),
        archive: &MemoryArchive::default(),
        threads: 2,
        stop: &AtomicBool::new(false),
        pause: None,
        observer: &|_| (),
    };
    let plan = Plan::new(study).expect("a plan");
    climb::answer(study, &plan, context).expect("an answer")
}

/// Volts of layouts of glued films at the contact's centre are those of the signals' transfer: the same coupled equilibria, and bare strains that differ by how
/// they are averaged, 0.15 % on this mesh. At the loads that give the transfer both are the coupled film's volts, to what Newton's iterations leave open (2e-7).
#[test]
fn layouts_of_glued_films_have_the_volts_of_the_signals() {
    for (loads, most) in [
        (json!([5, 10, 20]), 1e-6),
        (json!([3, 6, 7, 12, 30]), 0.005),
    ] {
        let document = json!({
            "name": "films",
            "scene": {"preset": "foot-tire"},
            "inputs": [{"name": "P3", "vary": "ground.depths_mm[2]", "distribution": {"kind": "uniform", "min": 0.7, "max": 1.3}}],
            "layouts": {"units": [6], "section_deg": [0], "loads_n": loads, "film": "transfer", "directions": [["x"], ["y"]]},
            "signals": {"loads_n": loads, "positions": ["crown"], "films": ["transfer"], "pressures_mpa": [0.2], "contact_deg": [0]},
            "method": {"kind": "mdrm", "nodes": 3, "check_points": 0},
            "accuracy": {"preset": "draft"},
        });
        let study = Study::from_value(&document, &|path| Err(path.to_owned())).expect("reads");
        let result = answered(&study);
        let findings = result.layout_findings.expect("layouts");
        assert!(findings.reasons.is_empty(), "{:?}", findings.reasons);
        let signals = result.signals.expect("signals");
        let load = loads[loads.as_array().map_or(0, Vec::len) / 2]
            .as_f64()
            .expect("a load");
        let largest = findings
            .rings
            .iter()
            .flat_map(|ring| &ring.strain)
            .fold(0.0, |largest: f64, v| largest.max(v.abs()));
        for ring in &findings.rings {
            let row = signals.rows.iter().find(|row| {
                row.over == SignalAxis::Load
                    && row.load_n == load
                    && row.direction.as_str() == ring.direction
            });
            let volts = row.and_then(|row| row.open_circuit_v).expect("volts");
            assert!(
                (ring.strain[180] - volts).abs() < most * largest,
                "{}: {} {volts}",
                ring.direction,
                ring.strain[180]
            );
        }
    }
}
