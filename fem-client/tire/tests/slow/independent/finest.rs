//! The other code's finest mesh, of which it printed more than of the others.

use tire::mesh::tire_grid::Extent;

use super::largest::{cord_stretches, least_volume_ratio, patch};
use super::pressing::{self, Press};
use super::reading::{Reading, reaction};
use super::{Figures, figures};

/// Figures at a depth.
#[derive(Debug)]
pub struct Finest {
    pub figures: Figures,
    /// Angle from the contact centre (rad), strains along x and y, von Mises stress (MPa).
    pub crown_line: Vec<[f64; 4]>,
    pub scalars: Scalars,
}

/// Single values of one depth, in the order of [`SCALARS`].
pub type Scalars = [f64; SCALARS.len()];

pub const SCALARS: [&str; 8] = [
    "shoulder, x",
    "shoulder, y",
    "sidewall, x",
    "sidewall, y",
    "patch along the wheel, mm",
    "patch across, mm",
    "least volume ratio",
    "least cord stretch",
];

/// Ours.
#[derive(Debug)]
pub struct Ours {
    pub reaction_n: f64,
    pub crown_line: Vec<[f64; 4]>,
    pub scalars: Scalars,
}

/// Reads what the other code printed, an entry a depth.
pub fn finest() -> Vec<Finest> {
    let crown_line = numbers(include_str!("crown_line.csv"));
    let scalars = numbers(include_str!("finest_mesh.csv"));
    let figures = figures().into_iter();
    let figures = figures.filter(|figures| figures.case == "Q2-L3n4");
    let at_depth = |rows: &[Vec<f64>], depth: f64| -> Vec<Vec<f64>> {
        let rows = rows.iter().filter(|row| row[0] == depth);
        rows.map(|row| row[1..].to_vec()).collect()
    };
    figures
        .map(|figures| {
            let depth = figures.depth_mm;
            let line = at_depth(&crown_line, depth).into_iter();
            let scalars = at_depth(&scalars, depth).remove(0);
            Finest {
                figures,
                crown_line: line
                    .map(|row| row.try_into().expect("four columns"))
                    .collect(),
                scalars: scalars.try_into().expect("a column for each"),
            }
        })
        .collect()
}

fn numbers(table: &str) -> Vec<Vec<f64>> {
    let lines = table.lines().filter(|line| !line.starts_with('#'));
    let row = |line: &str| {
        let fields = line.split(',');
        fields
            .map(|field| field.parse().expect("the table holds numbers"))
            .collect()
    };
    lines.skip(1).map(row).collect()
}

/// Solves these depths.
pub fn solve(asked: &[Finest]) -> Vec<Ours> {
    let Figures { scene, plan, .. } = &asked[0].figures;
    let model = pressing::model(scene, plan, Extent::Quarter);
    let mut press = Press::new(scene, &model);
    let mut answer = |asked: &Finest| {
        let depths = vec![asked.figures.depth_mm; scene.ground.stations];
        let pressed = press.press(&depths, None);
        let reading = Reading::new(&press, plan, &pressed);
        let line = asked.crown_line.iter().map(|[theta, ..]| {
            let [x, y] = reading.at_node(*theta);
            [*theta, x, y, reading.von_mises_at_node(*theta)]
        });
        let [shoulder, sidewall] = [45f64, 90.0].map(|phi| reading.at_section(phi.to_radians()));
        let [along, across] = patch(&model, &pressed);
        Ours {
            reaction_n: reaction(&model, &pressed),
            crown_line: line.collect(),
            scalars: [
                shoulder[0],
                shoulder[1],
                sidewall[0],
                sidewall[1],
                along,
                across,
                least_volume_ratio(&model, &pressed.state),
                cord_stretches(&model, scene, &pressed.state).min,
            ],
        }
    };
    asked.iter().map(&mut answer).collect()
}
