//! Layouts on the foot tire's own meshes, against figures of independent scripts on the same tire.

use std::sync::atomic::AtomicBool;

use fem_client::scene::{Level, Scene};
use fem_client::solver::{SolveRequest, Solver};
use placement::layout::arrangement::{Arrangement, FilmKind};
use placement::layout::field::film_field::Noise;
use placement::layout::fisher::bounds::bounds;
use placement::layout::layout_settings::{LayoutLoads, Layouts};
use placement::layout::solving::layout_fields::{MeshFields, mesh_fields};
use placement::layout::solving::layout_scenes::{LayoutScenes, readout};
use tire::embedded::EmbeddedSolver;

const CROWN: [FilmKind; 2] = [
    FilmKind {
        phi_deg: 0.0,
        angle_deg: 0.0,
    },
    FilmKind {
        phi_deg: 0.0,
        angle_deg: 90.0,
    },
];

/// The crown's fields at 1 mm, on a mesh that is fine to 60 degrees.
fn fields(level: Level) -> MeshFields {
    let settings = Layouts {
        loads: LayoutLoads::Depths(vec![1.0]),
        ..Layouts::default()
    };
    let scene = Scene::preset("foot-tire").expect("ships");
    let scenes = LayoutScenes::of(&settings, &scene).expect("a load");
    let (solver, stop, readout) = (
        EmbeddedSolver::default(),
        AtomicBool::new(false),
        readout(&CROWN),
    );
    let (mut start, mut outcomes) = (None, Vec::new());
    for scene in &scenes.scenes(level) {
        let request = SolveRequest {
            scene,
            readout: &readout,
            start: start.as_ref(),
            stop: &stop,
        };
        let solved = solver.solve(&request).expect("an equilibrium");
        outcomes.push(Ok(solved.response));
        start.get_or_insert(solved.state);
    }
    mesh_fields(&scenes, &CROWN, &outcomes).expect("fields")
}

/// Worst bounds of the angle of x and y films at the crown, 1 mm, noise 2 % of the largest strain: found beforehand by scripts of NumPy on this tire's strains
/// on a mesh of 19 stations, within 1 % on the standard and the reference mesh.
#[test]
fn worst_bounds_are_those_found_beforehand() {
    let found = fields(Level::Standard);
    let field = found.fields.at(1.0);
    let noise = Noise {
        floor: 0.02 * found.crown,
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
