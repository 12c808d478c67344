//! The other code's sensitivity studies, on its half meshes.

use fem::cell::element::Order;
use fem_client::scene::{Scene, StationFunctions};
use gsa::design::Design;
use gsa::law::distribution::Distribution;
use ndarray::Array2;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;
use tire::mesh::tire_grid::{Extent, MeshPlan};

use super::pressing::{self, Press};
use super::reading::{self, Reading};

/// Depths, and points P1 to P5.
const STATIONS: usize = 5;
const MEAN_DEPTH: f64 = 1.0;
const NODES: usize = 5;

/// A study of the other code.
#[derive(Debug)]
pub struct Study {
    pub name: String,
    plan: MeshPlan,
    scene: Scene,
    half_range: f64,
    /// Rows that it printed: kind of row, output, and one value for each point or depth.
    pub rows: Vec<Row>,
}

#[derive(Debug)]
pub struct Row {
    pub kind: String,
    pub output: String,
    pub values: Vec<f64>,
}

/// Ours: the outputs at the cut point and their first-order indices, in the order of [`OUTPUTS`].
#[derive(Debug)]
pub struct Answer {
    pub solves: usize,
    pub cut: Outputs,
    pub mdrm: Vec<Vec<f64>>,
    pub additive: Vec<Vec<f64>>,
    /// Whether an output has both signs among the points.
    pub changes_sign: Vec<bool>,
}

/// Outputs of one point.
#[derive(Debug, Clone)]
pub struct Outputs {
    pub x: Vec<f64>,
    pub y: Vec<f64>,
    pub von_mises: Vec<f64>,
    pub reaction: f64,
}

/// Outputs that have indices.
pub const OUTPUTS: [&str; 2 * STATIONS + 1] = [
    "x1", "x2", "x3", "x4", "x5", "y1", "y2", "y3", "y4", "y5", "reaction",
];

/// All studies of the other code.
pub fn studies() -> Vec<Study> {
    let lines = include_str!("studies.csv").lines();
    let rows: Vec<Vec<&str>> = lines
        .filter(|line| !line.starts_with('#'))
        .skip(1)
        .map(|line| line.split(',').collect())
        .collect();
    rows.chunk_by(|a, b| a[..4] == b[..4]).map(study).collect()
}

fn study(rows: &[Vec<&str>]) -> Study {
    let head = &rows[0];
    let number = |text: &str| text.parse::<f64>().expect("the table holds numbers");
    let mut scene = pressing::reference();
    scene.ground.station_spacing_mm = number(head[2]);
    scene.ground.station_functions = match head[1] {
        "hat" => StationFunctions::Hat,
        _ => StationFunctions::Bspline,
    };
    let row = |fields: &Vec<&str>| Row {
        kind: fields[4].into(),
        output: fields[5].into(),
        values: fields[6..]
            .iter()
            .filter(|text| !text.is_empty())
            .map(|text| number(text))
            .collect(),
    };
    Study {
        name: head[..4].join(", "),
        plan: plan(head[0]),
        scene,
        half_range: number(head[3]),
        rows: rows.iter().map(row).collect(),
    }
}

/// Returns the other code's mesh. Its description names the bricks and, for the quadratic mesh, the 25 degrees; that the linear one has them too, and
/// the growth of 2 of the former, were found by trying.
fn plan(mesh: &str) -> MeshPlan {
    let (order, [fine, coarse, meridional, layers], meridional_growth) = match mesh {
        "Q2" => (Order::Quadratic, [10, 5, 8, 2], 2.0),
        _ => (Order::Linear, [24, 6, 16, 4], 3.0),
    };
    MeshPlan {
        order,
        fine_angle: 25f64.to_radians(),
        fine,
        middle: None,
        coarse,
        meridional,
        meridional_growth,
        layers,
    }
}

impl Study {
    /// All its points.
    pub fn solve(&self) -> Answer {
        let law = Distribution::uniform(MEAN_DEPTH - self.half_range, MEAN_DEPTH + self.half_range)
            .expect("a range");
        let inputs = vec![law; STATIONS];
        let mut unused = ChaCha8Rng::seed_from_u64(0);
        let design = Design::new(&inputs, NODES, 0, &mut unused).expect("a design");
        let model = pressing::model(&self.scene, &self.plan, Extent::Half);
        let mut press = Press::new(&self.scene, &model);
        let (centre, cut) = self.outputs(&mut press, &design.points()[0], None);
        let mut values = cut.indexed();
        for point in &design.points()[1..] {
            let (_, outputs) = self.outputs(&mut press, point, Some(&centre));
            values.extend(outputs.indexed());
        }
        let shape = (design.points().len(), OUTPUTS.len());
        let values = Array2::from_shape_vec(shape, values).expect("a row for each point");
        let analyses = gsa::method::lines::analyse(&design, &values.view());
        let mdrm = analyses
            .into_iter()
            .map(|analysis| analysis.mdrm_first_order.expect("a product"));
        let columns = || values.columns().into_iter();
        Answer {
            solves: design.points().len(),
            cut,
            mdrm: mdrm.collect(),
            additive: columns()
                .map(|column| additive(&design, &column.to_vec()))
                .collect(),
            changes_sign: columns()
                .map(|column| column.iter().any(|v| *v < 0.0) && column.iter().any(|v| *v > 0.0))
                .collect(),
        }
    }

    fn outputs(
        &self,
        press: &mut Press<'_>,
        depths: &[f64],
        near: Option<&pressing::Pressed>,
    ) -> (pressing::Pressed, Outputs) {
        let pressed = press.press(depths, near);
        let reading = Reading::new(press, &self.plan, &pressed);
        let spacing =
            self.scene.ground.station_spacing_mm / press.model.crown_radius(&press.inflated);
        let angles = [-2.0, -1.0, 0.0, 1.0, 2.0].map(|k| k * spacing);
        let strains = angles.map(|theta| reading.at(theta));
        let outputs = Outputs {
            x: strains.map(|strain| strain[0]).into(),
            y: strains.map(|strain| strain[1]).into(),
            von_mises: angles.map(|theta| reading.von_mises_at(theta)).into(),
            reaction: reading::reaction(press.model, &pressed),
        };
        (pressed, outputs)
    }
}

impl Outputs {
    fn indexed(&self) -> Vec<f64> {
        let strains = self.x.iter().chain(&self.y);
        strains.chain([&self.reaction]).copied().collect()
    }
}

/// Each section's share of the sum of their variances.
fn additive(design: &Design, values: &[f64]) -> Vec<f64> {
    let variances = design.lines().iter().map(|line| {
        let pairs = || {
            let values = line.ordinals().iter().map(|&ordinal| values[ordinal]);
            values.zip(&line.rule().weights)
        };
        let mean: f64 = pairs().map(|(value, weight)| weight * value).sum();
        pairs()
            .map(|(value, weight)| weight * (value - mean).powi(2))
            .sum::<f64>()
    });
    let variances: Vec<f64> = variances.collect();
    let whole: f64 = variances.iter().sum();
    variances.iter().map(|variance| variance / whole).collect()
}
