//! Do the claimed errors of the mesh cover the true ones? First-order indices on every level against those of a mesh with twice
//! the cells of the finest level. The table of `docs/proof/claims.md`.
//!
//! `cargo run --release -p lab --example mesh_claims`, ten minutes on two cores.

use std::sync::atomic::AtomicBool;

use document::Format;
use documents::study::Study;
use documents::study::plan::Plan;
use fem_client::scene::{Level, Scene};
use fem_client::solver::{SolveError, SolveRequest, Solved, Solver};
use placement::points::RunContext;
use placement::points::RunError;
use placement::points::memory::MemoryArchive;
use placement::run::run;
use results::StudyResult;
use serde_json::{Value, json};
use tire::embedded::EmbeddedSolver;
use tire::mesh::tire_grid::MeshPlan;
use tire::mesh_error::coarser;
use tire::model::mesh_plan;

/// Solves every scene on one mesh, whatever level it asks for.
struct OnMesh {
    solver: EmbeddedSolver,
    plan: fn(&Scene) -> MeshPlan,
}

impl Solver for OnMesh {
    fn version(&self) -> String {
        self.solver.version()
    }

    fn solve(&self, request: &SolveRequest<'_>) -> Result<Solved, SolveError> {
        self.solver.solve_on(request, &(self.plan)(request.scene))
    }
}

fn finest(scene: &Scene) -> MeshPlan {
    MeshPlan {
        fine: 14,
        coarse: 8,
        meridional: 24,
        layers: 5,
        ..mesh_plan(scene, Level::Reference)
    }
}

/// Depths that vary.
const INPUTS: usize = 5;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let thick = json!({"preset": "foot-tire", "carcass": null, "geometry": {"wall_mm": 5.0}});
    let studies = [
        (
            "shipped, 0.7 to 1.3 mm",
            json!({"preset": "foot-tire"}),
            1.0,
        ),
        ("5 mm wall without cords, 1.2 to 1.8 mm", thick, 1.5),
    ];
    println!(
        "| study | level | largest true error | largest claimed | hold by index | hold by strain |"
    );
    println!("| --- | --- | --- | --- | --- | --- |");
    for (name, scene, depth) in studies {
        let study = study(scene, depth)?;
        let truth = indices(&answered(&study, finest)?);
        let on_level = |level| -> Result<Vec<f64>, RunError> {
            let plan = match level {
                Level::Draft => |scene: &Scene| mesh_plan(scene, Level::Draft),
                Level::Coarse => |scene: &Scene| mesh_plan(scene, Level::Coarse),
                Level::Standard => |scene: &Scene| mesh_plan(scene, Level::Standard),
                Level::Reference => |scene: &Scene| mesh_plan(scene, Level::Reference),
            };
            Ok(indices(&answered(&study, plan)?))
        };
        let mut before = on_level(Level::Draft)?;
        for level in [Level::Coarse, Level::Standard, Level::Reference] {
            let own = on_level(level)?;
            println!(
                "| {name} | {} | {} |",
                level.as_str(),
                row(&study, level, &own, &before, &truth)
            );
            before = own;
        }
    }
    Ok(())
}

/// Five depths that vary by 0.3 mm about a mean.
fn study(scene: Value, depth: f64) -> Result<Study, String> {
    let law = json!({"kind": "uniform", "min": depth - 0.3, "max": depth + 0.3});
    let input = |k: usize| json!({"name": format!("P{}", k + 1), "vary": format!("ground.depths_mm[{k}]"), "distribution": law});
    let document = json!({
        "name": "mesh", "scene": scene, "inputs": (0..INPUTS).map(input).collect::<Vec<_>>(), "layouts": {"spacings_deg": []},
        "method": {"kind": "mdrm", "nodes": 5, "check_points": 5},
    });
    let read = |path: &str| Err(format!("{path}: not needed"));
    Study::from_document(&document.to_string(), Format::Json, &read)
        .map_err(|faults| format!("{faults:?}"))
}

fn answered(study: &Study, plan: fn(&Scene) -> MeshPlan) -> Result<StudyResult, RunError> {
    let solver = OnMesh {
        solver: EmbeddedSolver::default(),
        plan,
    };
    let stop = AtomicBool::new(false);
    let context = RunContext {
        solver: &solver,
        archive: &MemoryArchive::default(),
        threads: std::thread::available_parallelism().map_or(1, usize::from),
        stop: &stop,
        pause: None,
        observer: &|_| (),
    };
    run(study, &Plan::new(study)?, context)
}

/// First-order indices of all outputs, one after the other.
fn indices(result: &StudyResult) -> Vec<f64> {
    let outputs = result.outputs.iter();
    outputs
        .flat_map(|output| output.first_order.iter().flatten())
        .copied()
        .collect()
}

fn row(study: &Study, level: Level, own: &[f64], before: &[f64], truth: &[f64]) -> String {
    let mut scene = study.scene.clone();
    scene.model.level = level;
    let factor = coarser(&scene).map_or(f64::NAN, |coarser| coarser.factor);
    let difference = |a: &[f64], b: &[f64]| -> Vec<f64> {
        a.iter().zip(b).map(|(a, b)| (a - b).abs()).collect()
    };
    let errors = difference(own, truth);
    let claims: Vec<f64> = difference(own, before).iter().map(|d| factor * d).collect();
    let largest = |values: &[f64]| values.iter().copied().fold(0.0, f64::max);
    let of_strain = |k: usize| largest(&claims[k / INPUTS * INPUTS..][..INPUTS]);
    let held = |claim: &dyn Fn(usize) -> f64| {
        (0..errors.len())
            .filter(|k| errors[*k] <= claim(*k))
            .count()
    };
    format!(
        "{:.4} | {:.4} | {} of {} | {}",
        largest(&errors),
        largest(&claims),
        held(&|k| claims[k]),
        errors.len(),
        held(&of_strain),
    )
}
