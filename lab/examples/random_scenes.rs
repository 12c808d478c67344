//! Solves random scenes within the documented ranges, and says how each of them ended.
//!
//! `cargo run --release -p lab --example random_scenes -- [COUNT] [SEED]`
//!
//! Meshes are coarser than a draft's. Scene k of a seed is the same in every run; scenes that end without equilibrium and without a physical reason are
//! printed as documents that `strainsite solve` reads.
//!
//! Sizes are drawn so that all regimes occur: any scale, thin and thick walls, soft and stiff rubber, with and without
//! a carcass, pressures from nothing to far beyond what a wall can hold, depths up to the whole section. Each scene
//! must end in an equilibrium or with a named reason; a panic, a number that isn't finite or a solver that breaks is a
//! fault, and the run then ends with an error.

use std::collections::BTreeMap;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::process::ExitCode;
use std::sync::atomic::AtomicBool;
use std::sync::{Mutex, PoisonError};
use std::time::{Duration, Instant};

use fem_client::scene::Scene;
use fem_client::solver::{Readout, SolveError, SolveRequest, Solved};
use rand::{Rng, RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use rayon::iter::{ParallelBridge, ParallelIterator};
use serde_json::{Value, json};
use tire::embedded::EmbeddedSolver;
use tire::mesh::tire_grid::MeshPlan;
use tire::model::mesh_plan;

/// Scenes between two lines of progress.
const PROGRESS: u64 = 100;

fn main() -> ExitCode {
    let mut arguments = std::env::args().skip(1).map(|text| text.parse::<u64>());
    let count = arguments.next().and_then(Result::ok).unwrap_or(1000);
    let seed = arguments.next().and_then(Result::ok).unwrap_or(1);
    let mut draws = Draws::new(count, seed);
    let summary = Mutex::new(Summary::default());
    let solved = |(index, document, scene)| {
        let begin = Instant::now();
        let ending = ending(&scene);
        let mut summary = summary.lock().unwrap_or_else(PoisonError::into_inner);
        summary.add(index, &ending, begin.elapsed(), &document);
    };
    draws.by_ref().par_bridge().for_each(solved);
    let summary = summary.into_inner().unwrap_or_else(PoisonError::into_inner);
    summary.print();
    println!("{} draws refused before", draws.refused);
    if summary.faults == 0 {
        ExitCode::SUCCESS
    } else {
        ExitCode::FAILURE
    }
}

/// The scenes of a seed, in order.
struct Draws {
    random: ChaCha8Rng,
    next: u64,
    count: u64,
    refused: u64,
}

impl Draws {
    fn new(count: u64, seed: u64) -> Self {
        Self {
            random: ChaCha8Rng::seed_from_u64(seed),
            next: 0,
            count,
            refused: 0,
        }
    }
}

impl Iterator for Draws {
    type Item = (u64, Value, Scene);

    fn next(&mut self) -> Option<Self::Item> {
        while self.next < self.count {
            let document = document(&mut self.random);
            // Draws that break a rule between fields, a bead beyond the axle for one, are no scenes.
            match Scene::from_json(&document.to_string()) {
                Ok(scene) => {
                    self.next += 1;
                    return Some((self.next - 1, document, scene));
                }
                Err(_) => self.refused += 1,
            }
        }
        None
    }
}

#[derive(Default)]
struct Summary {
    scenes: u64,
    faults: u64,
    endings: BTreeMap<String, (u64, Duration)>,
    slowest: Duration,
    total: Duration,
}

impl Summary {
    fn add(&mut self, index: u64, ending: &Ending, took: Duration, document: &Value) {
        self.scenes += 1;
        self.total += took;
        self.slowest = self.slowest.max(took);
        if ending.is_fault {
            self.faults += 1;
        }
        if ending.is_fault || ending.name == "not-converged" {
            println!(
                "scene {index}, {}: {}\n    {document}",
                ending.name, ending.detail
            );
        }
        let (count, time) = self.endings.entry(ending.name.clone()).or_default();
        *count += 1;
        *time += took;
        if self.scenes.is_multiple_of(PROGRESS) {
            eprintln!("{} scenes, {:.3} s each", self.scenes, self.mean());
        }
    }

    fn mean(&self) -> f64 {
        self.total.as_secs_f64() / self.scenes as f64
    }

    fn print(&self) {
        println!("\n{} scenes", self.scenes);
        for (name, (count, time)) in &self.endings {
            let share = 100.0 * *count as f64 / self.scenes as f64;
            let mean = time.as_secs_f64() / *count as f64;
            println!("{name:>16} {count:>6}  {share:5.2} %  {mean:.3} s each");
        }
        let slowest = self.slowest.as_secs_f64();
        println!("mean {:.3} s, slowest {slowest:.2} s", self.mean());
    }
}

struct Ending {
    name: String,
    detail: String,
    is_fault: bool,
}

fn ending(scene: &Scene) -> Ending {
    let stop = AtomicBool::new(false);
    let request = SolveRequest {
        scene,
        readout: &Readout::default(),
        start: None,
        watch: &stop,
    };
    let fault = |name: &str, detail: String| Ending {
        name: name.to_owned(),
        detail,
        is_fault: true,
    };
    let solve = || EmbeddedSolver::default().solve_on(&request, &coarse(scene));
    match catch_unwind(AssertUnwindSafe(solve)) {
        Err(_) => fault("panic", String::new()),
        Ok(Ok(solved)) if !is_finite(&solved) => fault("not finite", String::new()),
        Ok(Ok(_)) => Ending {
            name: "converged".to_owned(),
            detail: String::new(),
            is_fault: false,
        },
        Ok(Err(SolveError::NoEquilibrium { status, detail, .. })) => Ending {
            name: status.as_str().to_owned(),
            detail,
            is_fault: false,
        },
        Ok(Err(error)) => fault("broken", error.to_string()),
    }
}

/// Half the divisions of a draft along each edge: thousands of scenes take minutes, and are hard on the solver.
fn coarse(scene: &Scene) -> MeshPlan {
    let draft = mesh_plan(scene, scene.model.level);
    MeshPlan {
        fine: draft.fine.div_ceil(2),
        coarse: draft.coarse.div_ceil(2),
        meridional: draft.meridional.div_ceil(2),
        ..draft
    }
}

/// JSON has no number for what isn't finite: it turns up as null.
fn is_finite(solved: &Solved) -> bool {
    fn has_null(value: &Value) -> bool {
        match value {
            Value::Null => true,
            Value::Array(list) => list.iter().any(has_null),
            Value::Object(table) => table
                .iter()
                .any(|(key, value)| key != "map" && has_null(value)),
            _ => false,
        }
    }
    let mut response = serde_json::to_value(&solved.response).unwrap_or(Value::Null);
    if let Some(table) = response.as_object_mut() {
        table.retain(|_, value| !value.is_null() || value.is_number());
    }
    !has_null(&response)
}

/// Uniform in the logarithm.
fn log_uniform(random: &mut impl Rng, low: f64, high: f64) -> f64 {
    random.random_range(low.ln()..high.ln()).exp()
}

fn document(random: &mut impl Rng) -> Value {
    let outer = log_uniform(random, 1e-1, 1e3);
    let section = outer * random.random_range(0.05..0.45);
    let wall = section * log_uniform(random, 0.01, 0.6);
    let shear = log_uniform(random, 1e-2, 1e2);
    let carcass = random.random_bool(0.7);
    let cords = if carcass {
        shear * wall * log_uniform(random, 0.1, 1e3)
    } else {
        0.0
    };
    let strength = (shear * wall + cords) / section;
    let pressure = if random.random_bool(0.1) {
        0.0
    } else {
        strength * log_uniform(random, 1e-3, 2.0)
    };
    let stations = 2 * random.random_range(0..4) + 1;
    let depth = section * log_uniform(random, 1e-3, 1.0);
    let depths: Vec<f64> = (0..stations)
        .map(|_| depth * random.random_range(0.0..1.0))
        .collect();
    let compressibility = if random.random_bool(0.5) {
        0.0
    } else {
        2.0 / (shear * log_uniform(random, 10.0, 1e9))
    };
    let mut scene = json!({
        "geometry": {
            "outer_radius_mm": outer,
            "section_radius_mm": section,
            "wall_mm": wall,
            "bead_angle_deg": random.random_range(60.0..150.0),
        },
        "material": material(random, shear, compressibility),
        "pressure": {"internal_mpa": pressure},
        "ground": {
            "stations": stations,
            "station_spacing_mm": outer * random.random_range(0.02..0.3),
            "station_functions": if random.random_bool(0.5) { "bspline" } else { "hat" },
            "depths_mm": depths,
        },
        "contact": {"friction": if random.random_bool(0.8) { 0.0 } else { random.random_range(0.0..1.0) }},
        "model": {"level": "draft"},
    });
    if carcass {
        scene["carcass"] = json!({
            "angle_deg": random.random_range(0.0..90.0),
            "stiffness_n_per_mm": cords,
            "position": random.random_range(0.0..1.0),
            "compression_ratio": random.random_range(0.0..1.0),
        });
    }
    scene
}

fn material(random: &mut impl Rng, shear: f64, compressibility: f64) -> Value {
    let c10 = 0.5 * shear;
    match random.random_range(0..4) {
        0 => json!({"model": "neo-hookean", "c10_mpa": c10, "d1_per_mpa": compressibility}),
        1 => json!({"model": "yeoh", "c10_mpa": c10, "c20_mpa": 0.01 * c10, "c30_mpa": 0.001 * c10,
                    "d1_per_mpa": compressibility}),
        2 => json!({"model": "ogden", "d1_per_mpa": compressibility,
                    "terms": [{"mu_mpa": 0.8 * shear, "alpha": 1.8}, {"mu_mpa": 0.2 * shear, "alpha": -2.0}]}),
        _ => {
            let share = random.random_range(0.0..0.5);
            json!({"model": "mooney-rivlin", "c10_mpa": (1.0 - share) * c10, "c01_mpa": share * c10,
                   "d1_per_mpa": compressibility})
        }
    }
}
