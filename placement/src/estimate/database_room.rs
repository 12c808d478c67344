//! Room that a study takes in a database.
//!
//! Fitted to rows of the shipped study on the draft, coarse and standard meshes.

use fem_client::scene::Scene;
use fem_client::solver::{Readout, Solver};

use documents::study::Study;

/// A point without strains of a map or around the wheel: its scene, response, cost, and its event, bytes.
const POINT: f64 = 5.5e3;
/// A number of a map or of a line around the wheel, and its share of pages that aren't full, bytes.
const NUMBER: f64 = 8.7;
/// Strains of a cell of the map, and coordinates of where it has moved to.
const STRAINS: f64 = 2.0;
const MOVED: f64 = 3.0;
/// Places of a line around the wheel.
const LINE: f64 = 361.0;
/// Angle and two strains that each line has, beside those turned.
const OF_LINE: usize = 3;
/// Place of a cell of the map at the cut point, bytes of text.
const PLACE: f64 = 80.0;
/// State from which others start: bytes on a mesh of so many cells, and the exponent by which these count.
const STATE: (f64, f64, f64) = (30e3, 300.0, 0.85);

/// A result without layouts and map, and what a comparison reads of it, bytes of text.
const RESULT: f64 = 50e3;
/// A layout's row and findings, bytes of text.
const LAYOUT: f64 = 5e3;
/// A strain of the map in a result: what is told of it without inputs, and what by each input, bytes of text.
const CELL: (f64, f64) = (90.0, 31.0);

/// Bytes of a point of a series with its cut point, of which this is read; others may start from it.
pub(super) fn point_bytes(
    (cut, scene): (&Scene, &Scene),
    readout: &Readout,
    solver: &dyn Solver,
    is_start: bool,
) -> f64 {
    let cells = map_cells(readout);
    let along = readout.rings.iter();
    let along: usize = along.map(|ring| OF_LINE + ring.turned_deg.len()).sum();
    let of_cell = match is_on_line(cut, scene) {
        true => STRAINS + MOVED,
        false => STRAINS,
    };
    let start = match is_start {
        true => state_bytes(solver.cells_read(scene, readout)) + PLACE * cells,
        false => 0.0,
    };
    POINT + NUMBER * (of_cell * cells + LINE * along as f64) + start
}

fn state_bytes(cells: usize) -> f64 {
    let (bytes, of_cells, exponent) = STATE;
    bytes * (cells as f64 / of_cells).powf(exponent)
}

/// Whether one input alone is another than at the cut point: where the map has moved to is read there.
fn is_on_line(cut: &Scene, scene: &Scene) -> bool {
    let depths = cut.ground.depths_mm.iter().zip(&scene.ground.depths_mm);
    let pressed = depths.filter(|(cut, own)| cut != own).count();
    let mut otherwise = scene.clone();
    otherwise.ground.depths_mm.clone_from(&cut.ground.depths_mm);
    pressed + usize::from(otherwise != *cut) == 1
}

/// Bytes of a study's result, which tells of so many layouts.
pub(super) fn result_bytes(study: &Study, layouts: usize) -> f64 {
    let (cell, of_input) = CELL;
    let cells = STRAINS * map_cells(&study.readout());
    RESULT + LAYOUT * layouts as f64 + cells * (cell + of_input * study.inputs.len() as f64)
}

fn map_cells(readout: &Readout) -> f64 {
    let grid = readout.grid.as_ref();
    grid.map_or(0, |grid| grid.circumferential * grid.meridional) as f64
}
