//! Places of the points of a map and of the whole mesh.

use std::sync::atomic::AtomicBool;

use fem_client::closed_form::ClosedFormSolver;
use fem_client::scene::{Level, Scene};
use fem_client::solver::{Grid, MapShape, Readout, SolveRequest, Solved, Solver};
use tire::embedded::EmbeddedSolver;
use vtu::solved_body::Body;
use vtu::{CellShape, DataArray, Values};

const COLUMNS: usize = 7;
const ROWS: usize = 5;
/// Middle of the map: the crown above the contact's centre.
const CENTRE: usize = (COLUMNS * ROWS) / 2;
/// Positions are rounded to a picometre, their differences to two.
const ROUNDING_MM: f64 = 2e-9;
/// Noise that the solver's tolerance leaves of a displacement; half and quarter are solved apart.
const SOLVED_MM: f64 = 1e-6;

fn scene(depths: [f64; 5]) -> Scene {
    let mut scene = Scene::preset("foot-tire").expect("ships");
    scene.model.level = Level::Draft;
    scene.ground.depths_mm = depths.to_vec();
    scene
}

fn solve(solver: &dyn Solver, scene: &Scene, shape: bool) -> Solved {
    let grid = Grid {
        circumferential: COLUMNS,
        meridional: ROWS,
        half_width_deg: 30.0,
    };
    let readout = Readout {
        grid: Some(grid),
        shape,
        ..Readout::default()
    };
    let request = SolveRequest {
        scene,
        readout: &readout,
        start: None,
        watch: &AtomicBool::new(false),
    };
    solver.solve(&request).expect("an equilibrium")
}

fn shape(depths: [f64; 5]) -> MapShape {
    let solved = solve(&EmbeddedSolver::default(), &scene(depths), true);
    solved.response.map.expect("a map").shape.expect("a shape")
}

/// Whether a field is the other's mirror image at the plane across this axis.
fn mirrored(field: &[[f64; 3]], other: &[[f64; 3]], axis: usize, tolerance: f64) {
    for (k, value) in field.iter().enumerate() {
        let (row, column) = (k / COLUMNS, k % COLUMNS);
        let mut image = match axis {
            0 => other[row * COLUMNS + COLUMNS - 1 - column],
            _ => other[(ROWS - 1 - row) * COLUMNS + column],
        };
        image[axis] = -image[axis];
        for i in 0..3 {
            let difference = (value[i] - image[i]).abs();
            assert!(difference < tolerance, "{k}: {value:?} {image:?}");
        }
    }
}

#[test]
fn beyond_the_symmetry_planes_points_are_mirror_images() {
    let (left, right) = (
        shape([0.6, 0.9, 1.0, 1.1, 1.2]),
        shape([1.2, 1.1, 1.0, 0.9, 0.6]),
    );
    for (field, other) in [
        (&left.inflated_mm, &right.inflated_mm),
        (&left.displacement_mm, &right.displacement_mm),
    ] {
        mirrored(field, other, 0, SOLVED_MM);
        mirrored(field, field, 1, ROUNDING_MM);
    }
    let even = shape([0.8, 0.9, 1.0, 0.9, 0.8]);
    mirrored(&even.inflated_mm, &even.inflated_mm, 0, ROUNDING_MM);
    mirrored(&even.displacement_mm, &even.displacement_mm, 0, ROUNDING_MM);
    // Columns run along x, rows along y, and the contact lies below.
    let first = even.inflated_mm[0];
    assert!(first[0] < -15.0 && first[1] < -5.0 && first[2] < 0.0);
}

fn vectors<'a>(data: &'a [DataArray], name: &str) -> &'a [[f64; 3]] {
    let array = data.iter().find(|array| array.name == name);
    match &array.expect("the array").values {
        Values::Float(values) => values.as_chunks().0,
        Values::Byte(_) => panic!("{name} has flags"),
    }
}

#[test]
fn the_map_lies_on_the_mesh() {
    let scene = scene([0.8, 0.9, 1.0, 0.9, 0.8]);
    let solved = solve(&EmbeddedSolver::default(), &scene, true);
    let grid = Body::of(&scene, &solved.state).expect("a mesh").grid("");
    assert_eq!(grid.shape, CellShape::Hexahedron);
    assert_eq!(grid.cells.len(), 8 * solved.response.model.elements);
    let inner_crown = [0.0, 0.0, -47.0];
    let near = |x: &[f64; 3]| (0..3).all(|i| (x[i] - inner_crown[i]).abs() < 1e-12);
    let node = grid.points.iter().position(near).expect("the node");
    let inflation = vectors(&grid.point_data, "displacement_inflated")[node];
    let whole = vectors(&grid.point_data, "displacement")[node];
    let map = solved.response.map.expect("a map").shape.expect("a shape");
    for i in 0..3 {
        let inflated = inner_crown[i] + inflation[i];
        assert!((map.inflated_mm[CENTRE][i] - inflated).abs() < ROUNDING_MM);
        let pressed = whole[i] - inflation[i];
        assert!((map.displacement_mm[CENTRE][i] - pressed).abs() < ROUNDING_MM);
    }
    assert!(grid.to_xml().is_ok());
}

#[test]
fn no_one_else_grows_by_it() {
    let scene = scene([1.0; 5]);
    let solved = solve(&EmbeddedSolver::default(), &scene, false);
    assert_eq!(solved.response.map.expect("a map").shape, None);
    let solved = solve(&ClosedFormSolver::new(), &scene, true);
    assert!(Body::of(&scene, &solved.state).is_none());
}
