//! Do the claimed errors of the mesh cover the true ones? First-order indices on every level against those of a mesh that is finer in every direction than
//! the finest level, on eight tires. The tables of `docs/proof/claims.md`.
//!
//! `cargo run --release -p lab --example mesh_claims [TIRE...]`, half an hour on two cores for all tires.

mod eight_tires;
mod held_claims;

use std::sync::atomic::AtomicBool;

use documents::study::Study;
use documents::study::plan::Plan;
use fem_client::scene::{Level, Scene};
use fem_client::solver::{Coarser, SolveError, SolveRequest, Solved, Solver};
use lab::all_cores::cores;
use lab::largest::largest;
use placement::points::RunContext;
use placement::points::RunError;
use placement::points::memory::MemoryArchive;
use placement::run::run;
use results::{MapLayer, StudyResult};
use tire::embedded::EmbeddedSolver;
use tire::mesh::tire_grid::MeshPlan;
use tire::mesh_error::coarser;
use tire::model::mesh_plan;

use eight_tires::{finer, study, tires};
use held_claims::{SHARE, held, over};

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

/// Levels with a coarser one that shows their error.
const LEVELS: [Level; 3] = [Level::Coarse, Level::Standard, Level::Reference];

const WHERE: [&str; 2] = ["P1 to P5", "map"];

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let asked: Vec<String> = std::env::args().skip(1).collect();
    let of = ["index", "place"].map(|by| format!(" by {by}: hold | over true | {SHARE} need |"));
    println!(
        "| tire | level | where | largest true error | claimed |{}",
        of.concat()
    );
    println!("| --- |{}", " --- |".repeat(10));
    let mut of_levels = LEVELS.map(|_| [Judged::default(), Judged::default()]);
    for (name, scene, depth) in tires() {
        if !asked.is_empty() && !asked.iter().any(|asked| name.contains(asked.as_str())) {
            continue;
        }
        let study = study(scene, depth)?;
        let truth = Indices::of(&answered(&study, |scene| {
            finer(mesh_plan(scene, Level::Reference))
        })?);
        let mut before = on_level(&study, Level::Draft)?;
        for (level, all) in LEVELS.into_iter().zip(&mut of_levels) {
            let own = on_level(&study, level)?;
            let mut scene = study.scene.clone();
            scene.model.level = level;
            let coarser = coarser(&scene).expect("a coarser level");
            let judged = [
                Judged::of(
                    coarser,
                    &own.at_locations,
                    &before.at_locations,
                    &truth.at_locations,
                ),
                Judged::of(coarser, &own.over_map, &before.over_map, &truth.over_map),
            ];
            for ((judged, all), at) in judged.into_iter().zip(all).zip(WHERE) {
                println!("| {name} | {} | {at} | {judged} |", level.as_str());
                all.add(judged);
            }
            before = own;
        }
    }
    for (level, all) in LEVELS.into_iter().zip(of_levels) {
        for (all, at) in all.iter().zip(WHERE) {
            println!("| **all** | {} | {at} | {all} |", level.as_str());
        }
    }
    Ok(())
}

fn on_level(study: &Study, level: Level) -> Result<Indices, RunError> {
    let plan = match level {
        Level::Draft => |scene: &Scene| mesh_plan(scene, Level::Draft),
        Level::Coarse => |scene: &Scene| mesh_plan(scene, Level::Coarse),
        Level::Standard => |scene: &Scene| mesh_plan(scene, Level::Standard),
        Level::Reference => |scene: &Scene| mesh_plan(scene, Level::Reference),
    };
    Ok(Indices::of(&answered(study, plan)?))
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
        threads: cores(),
        stop: &stop,
        pause: None,
        observer: &|_| (),
    };
    run(study, &Plan::new(study)?, context)
}

/// First-order indices of both strains at a place, one after the other.
struct Indices {
    at_locations: Vec<[Vec<f64>; 2]>,
    over_map: Vec<[Vec<f64>; 2]>,
}

impl Indices {
    fn of(result: &StudyResult) -> Self {
        let outputs: Vec<Vec<f64>> = result
            .outputs
            .iter()
            .map(|output| output.first_order.clone().unwrap_or_default())
            .collect();
        let at_locations = outputs
            .chunks(2)
            .map(|both| [both[0].clone(), both[1].clone()]);
        let layers = result.map.as_ref().map(|map| &map.layers);
        let cell = |layer: &MapLayer, cell: usize| -> Vec<f64> {
            let inputs = layer.first_order.iter();
            inputs
                .map(|cells| cells[cell].unwrap_or(f64::NAN))
                .collect()
        };
        let cells = layers.map_or(0, |layers| layers[0].strain.len());
        let both = |k: usize| layers.map(|layers| [cell(&layers[0], k), cell(&layers[1], k)]);
        Self {
            at_locations: at_locations.collect(),
            over_map: (0..cells).filter_map(both).collect(),
        }
    }
}

/// True errors of indices, and what is claimed of each.
#[derive(Default)]
struct Judged {
    errors: Vec<f64>,
    /// Claims by the difference of the index itself.
    by_index: Vec<f64>,
    /// Claims by the largest difference at its place, as a study makes them.
    by_place: Vec<f64>,
}

impl Judged {
    fn of(
        coarser: Coarser,
        own: &[[Vec<f64>; 2]],
        before: &[[Vec<f64>; 2]],
        truth: &[[Vec<f64>; 2]],
    ) -> Self {
        let mut judged = Self::default();
        for ((own, before), truth) in own.iter().zip(before).zip(truth) {
            let apart = [0, 1].map(|k| difference(&own[k], &before[k]));
            let of_place = coarser.of_largest * largest(apart.concat().into_iter());
            for k in 0..2 {
                let errors = difference(&own[k], &truth[k]);
                judged.by_place.extend(vec![of_place; errors.len()]);
                let by_index = apart[k].iter().map(|apart| coarser.factor * apart);
                judged.by_index.extend(by_index);
                judged.errors.extend(errors);
            }
        }
        judged
    }

    fn add(&mut self, other: Self) {
        self.errors.extend(other.errors);
        self.by_index.extend(other.by_index);
        self.by_place.extend(other.by_place);
    }
}

impl std::fmt::Display for Judged {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(
            f,
            "{:.4} | {:.4}",
            largest(self.errors.iter().copied()),
            largest(self.by_place.iter().copied())
        )?;
        for claims in [&self.by_index, &self.by_place] {
            write!(
                f,
                " | {:.1} % | {:.1} | {:.2}",
                held(&self.errors, claims),
                1.0 / over(&self.errors, claims, 0.5),
                over(&self.errors, claims, SHARE)
            )?;
        }
        Ok(())
    }
}

fn difference(a: &[f64], b: &[f64]) -> Vec<f64> {
    a.iter().zip(b).map(|(a, b)| (a - b).abs()).collect()
}
