//! The inner and the outer surface of the whole wheel, for pictures that turn.

use std::f64::consts::PI;

use fem::load::obstacle::HeightField;
use fem::problem::State;
use fem::tensor::Vector;
use tire::mesh::tire_grid::TireGrid;
use tire::model::TireModel;

/// Points of the ground's profile, at least, from one end to the other.
const GROUND_POINTS: usize = 161;
/// Points between two stations, at least.
const BETWEEN_STATIONS: f64 = 8.0;
/// Points of the profile, at most: stations may stand closer than anybody sees.
const MOST_GROUND_POINTS: usize = 2001;

/// Both skins of the whole wheel, what isn't modelled completed by its mirror images.
///
/// Points stand row after row. Rows run along the section from one bead to the other, columns around the wheel. The last column's neighbour is the first.
#[derive(Debug, Clone, PartialEq)]
pub struct WheelSkins {
    /// Section angle of each row from the crown in the undeformed tire, degrees, ascending.
    pub phi_deg: Vec<f64>,
    /// Wheel angle of each column from the contact centre in the undeformed tire, positive in the rolling direction, degrees, ascending in [-180, 180).
    pub theta_deg: Vec<f64>,
    /// The surface that carries the pressure.
    pub inner: Skin,
    /// The tread and the walls' outer sides.
    pub outer: Skin,
    /// The ground's height over x in the equilibrium, mm: x ascending, z from the wheel's centre along the ground's normal.
    pub ground: Vec<[f64; 2]>,
    /// Inclination of the wheel to that normal, degrees, right-handed about x.
    pub camber_deg: f64,
}

/// A surface; x in the rolling direction, y along the axle, z upward, from the wheel's centre.
#[derive(Debug, Clone, PartialEq)]
pub struct Skin {
    /// Positions in the inflated state before contact, mm.
    pub inflated_mm: Vec<Vector>,
    /// Displacements from there to the equilibrium, mm.
    pub displacement_mm: Vec<Vector>,
}

/// A node line of the whole wheel: a line of the mesh, or its mirror image.
#[derive(Debug, Clone, Copy)]
struct Line {
    angle: f64,
    index: usize,
    is_mirrored: bool,
}

impl WheelSkins {
    /// The skins of a model in two states, and the ground below it.
    pub(crate) fn of(
        model: &TireModel,
        [inflated, equilibrium]: [&State; 2],
        ground: &HeightField,
    ) -> Self {
        let grid = &model.grid;
        let (rows, columns) = (rows(grid), columns(grid));
        let skin = |rho: usize| {
            let mut skin = Skin {
                inflated_mm: Vec::with_capacity(rows.len() * columns.len()),
                displacement_mm: Vec::with_capacity(rows.len() * columns.len()),
            };
            for row in &rows {
                for column in &columns {
                    let node = grid.node([row.index, column.index, rho]);
                    let image = |x: Vector| mirrored(x, column.is_mirrored, row.is_mirrored);
                    let [start, end] = [inflated, equilibrium]
                        .map(|state| state.position(&model.problem.mesh, node));
                    let displacement = [0, 1, 2].map(|i| end[i] - start[i]);
                    skin.inflated_mm.push(image(start));
                    skin.displacement_mm.push(image(displacement));
                }
            }
            skin
        };
        let degrees = |lines: &[Line]| lines.iter().map(|line| line.angle.to_degrees()).collect();
        Self {
            phi_deg: degrees(&rows),
            theta_deg: degrees(&columns),
            inner: skin(0),
            outer: skin(grid.rho_nodes() - 1),
            ground: profile(ground),
            camber_deg: ground.axes.angle.to_degrees(),
        }
    }
}

/// Returns the lines from one bead to the other.
fn rows(grid: &TireGrid) -> Vec<Line> {
    let line = |index| Line {
        angle: grid.line(&grid.phi, index),
        index,
        is_mirrored: false,
    };
    let modelled = (0..grid.phi_nodes()).map(line);
    match grid.extent.is_whole_across() {
        true => modelled.collect(),
        false => {
            let images = (1..grid.phi_nodes()).rev().map(line).map(image);
            images.chain(modelled).collect()
        }
    }
}

/// Returns the lines around the wheel, from its far side on.
fn columns(grid: &TireGrid) -> Vec<Line> {
    let line = |index| Line {
        angle: grid.line(&grid.theta, index),
        index,
        is_mirrored: false,
    };
    match grid.extent.is_whole_along() {
        true => (0..grid.theta_nodes()).map(line).collect(),
        false => {
            // The far side stands in the plane of symmetry: it is there once, as the first column.
            let last = grid.theta_nodes() - 1;
            let images = (1..=last).rev().map(line).map(image);
            let mut lines: Vec<Line> = images.chain((0..last).map(line)).collect();
            if let Some(far) = lines.first_mut() {
                far.angle = -PI;
            }
            lines
        }
    }
}

fn image(line: Line) -> Line {
    Line {
        angle: -line.angle,
        is_mirrored: true,
        ..line
    }
}

/// The image of a vector across the planes x = 0 and y = 0. No zero becomes a negative one.
fn mirrored([x, y, z]: Vector, across_x: bool, across_y: bool) -> Vector {
    let signed = |is_mirrored, value: f64| if is_mirrored { 0.0 - value } else { value };
    [signed(across_x, x), signed(across_y, y), z]
}

/// The ground's height as far as the wheel reaches, and beyond its outermost stations.
fn profile(ground: &HeightField) -> Vec<[f64; 2]> {
    let stations = ground.depths.len().max(1) as f64;
    let half = (0.5 * stations + 2.0) * ground.spacing + ground.shift[0].abs();
    let half = half.max(ground.base.abs());
    let step = ground.spacing / BETWEEN_STATIONS;
    // As many as stand in the bounds, whatever the quotient.
    let points = (2.0 * half / step).ceil() as usize + 1;
    let points = points.clamp(GROUND_POINTS, MOST_GROUND_POINTS);
    let x = |k: usize| half * (2.0 * k as f64 / (points - 1) as f64 - 1.0);
    let at = |x: f64| match ground.depths.is_empty() {
        true => [x, ground.base],
        false => [x, ground.height(x, 0.0).value],
    };
    (0..points).map(|k| at(x(k))).collect()
}
