//! What the crown does where a tire is pressed: deflection, sliding along the wheel, strains through the wall along and across the
//! wheel; prints Markdown. `docs/ring.md` reads it: it is what a two-dimensional ring would have to do.
//!
//! `cargo run --release -p fem-client --example crown_line`, a few seconds.

use std::sync::atomic::AtomicBool;

use fem::problem::State;
use fem::tensor::{Vector, norm};
use fem_client::embedded::EmbeddedSolver;
use fem_client::scene::Scene;
use fem_client::solver::{Readout, SolveRequest, Solved, Solver};
use fem_client::tire::{TireModel, mesh_plan};
use fem_client::tire_mesh::Extent;

/// Where the table ends, mm from the contact centre.
const END: f64 = 16.0;
/// Angles and radii of the mesh that differ by less are the same but for rounding, rad and mm.
const SAME: f64 = 1e-9;

/// A quadratic brick of the crown along the wheel, relative to the inflated tire. Of three values the first is of the inner surface, the
/// second of the wall's middle, the third of the outer surface.
#[derive(Debug, Clone, Copy)]
struct Row {
    /// Middle of the brick on the inflated outer surface, mm from the contact centre.
    distance: f64,
    /// Inward displacement of the wall's middle, mm.
    deflection: f64,
    /// Its displacement along the wheel, away from the contact centre, mm.
    sliding: f64,
    /// Strain along the wheel.
    along: [f64; 3],
    /// Strain across the wheel.
    across: [f64; 3],
}

fn main() {
    for (name, scene) in [
        ("The shipped tire", shipped()),
        ("Without cords", without_cords()),
    ] {
        println!("### {name}, 1 mm\n");
        println!(
            "| mm from the centre | deflection mm | sliding outward mm | along: inside | mid-wall | outside | across: inside | mid-wall | outside |"
        );
        println!("|{}", " --- |".repeat(9));
        for row in crown(&scene) {
            let strains = row.along.iter().chain(&row.across);
            let strains: Vec<String> = strains.map(|strain| format!("{strain:+.4}")).collect();
            let [x, w, u] = [row.distance, row.deflection, row.sliding];
            println!("| {x:.1} | {w:.3} | {u:+.3} | {} |", strains.join(" | "));
        }
        println!();
    }
}

fn shipped() -> Scene {
    Scene::preset("foot-tire").expect("the preset ships")
}

/// A tire whose rubber alone holds its pressure.
fn without_cords() -> Scene {
    let mut scene = Scene::default();
    scene.geometry.wall_mm = 5.0;
    scene.pressure.internal_mpa = 0.05;
    scene
}

/// The crown from the contact centre to [`END`].
fn crown(scene: &Scene) -> Vec<Row> {
    let request = SolveRequest {
        scene,
        readout: &Readout::default(),
        start: None,
        stop: &AtomicBool::new(false),
    };
    let solved = EmbeddedSolver::default().solve(&request);
    let solved = solved.expect("both tires have an equilibrium at 1 mm");
    let rows = Crown::new(scene, &solved).rows().into_iter();
    rows.take_while(|row| row.distance < END).collect()
}

/// Nodes of the wheel's middle plane, and those next to them across, on three surfaces.
struct Crown {
    model: TireModel,
    inflated: State,
    pressed: State,
    /// Along the wheel from the contact centre.
    lines: [Vec<u32>; 3],
    /// Their neighbours across.
    beside: [Vec<u32>; 3],
}

impl Crown {
    fn new(scene: &Scene, solved: &Solved) -> Self {
        let plan = mesh_plan(scene, scene.model.level);
        let model = TireModel::new(scene, &plan, Extent::Quarter);
        let [inflated, pressed] = [&solved.state.inflated, &solved.state.equilibrium]
            .map(|flat| model.fit(flat).expect("it was solved on this mesh"));
        let (shape, nodes) = (model.grid.shape, &model.problem.mesh.nodes);
        // Section angle and section radius.
        let section = |x: &Vector| {
            let height = x[0].hypot(x[2]) - shape.centre_radius;
            (x[1].atan2(height), x[1].hypot(height))
        };
        let angles = nodes.iter().map(|x| section(x).0);
        let first = angles.filter(|a| *a > SAME).fold(f64::INFINITY, f64::min);
        let line = |angle: f64, radius: f64| -> Vec<u32> {
            let is_here = |node: &u32| {
                let (a, r) = section(&nodes[*node as usize]);
                (a - angle).abs() < SAME && (r - radius).abs() < SAME
            };
            let mut line: Vec<u32> = (0..nodes.len() as u32).filter(is_here).collect();
            let theta = |node: &u32| wheel_angle(&nodes[*node as usize]);
            line.sort_by(|a, b| theta(a).total_cmp(&theta(b)));
            line
        };
        let radii = [shape.inner, 0.5 * (shape.inner + shape.outer), shape.outer];
        Self {
            lines: radii.map(|radius| line(0.0, radius)),
            beside: radii.map(|radius| line(first, radius)),
            inflated,
            pressed,
            model,
        }
    }

    fn position(&self, state: &State, node: u32) -> Vector {
        state.position(&self.model.problem.mesh, node)
    }

    /// Length of a path through nodes over its inflated length, minus one.
    fn strain(&self, path: &[u32]) -> f64 {
        let length = |state: &State| -> f64 {
            let points: Vec<Vector> = path.iter().map(|&n| self.position(state, n)).collect();
            let steps = points.windows(2);
            steps
                .map(|p| norm(&[0, 1, 2].map(|i| p[1][i] - p[0][i])))
                .sum()
        };
        length(&self.pressed) / length(&self.inflated) - 1.0
    }

    /// One row for each brick: nodes 2k to 2k + 2 of a line.
    fn rows(&self) -> Vec<Row> {
        let radius = self.model.crown_radius(&self.inflated);
        let middles = (1..self.lines[1].len()).step_by(2);
        let row = |k: usize| {
            let node = self.lines[1][k];
            let [before, after] =
                [&self.inflated, &self.pressed].map(|state| self.position(state, node));
            let [r, deflected] = [before, after].map(|x| x[0].hypot(x[2]));
            Row {
                distance: radius * wheel_angle(&before),
                deflection: r - deflected,
                sliding: r * (wheel_angle(&after) - wheel_angle(&before)),
                along: [0, 1, 2].map(|s| self.strain(&self.lines[s][k - 1..=k + 1])),
                across: [0, 1, 2].map(|s| self.strain(&[self.lines[s][k], self.beside[s][k]])),
            }
        };
        middles.map(row).collect()
    }
}

/// Angle from the contact centre, rad.
fn wheel_angle(x: &Vector) -> f64 {
    x[0].atan2(-x[2])
}

/// Plane strain across the wheel would have the strains across vanish.
#[test]
fn the_crown_bends_more_across_the_wheel_than_along_it() {
    let bending = |strains: [f64; 3]| strains[0] - strains[2];
    for scene in [shipped(), without_cords()] {
        let centre = crown(&scene)[0];
        let (along, across) = (bending(centre.along), bending(centre.across));
        assert!(along > 0.0 && across > along, "{centre:?}");
    }
}
