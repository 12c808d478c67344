//! Points of a study solved in several ways: work, time, and distance from a solution without compromise; prints Markdown.
//!
//! `cargo run --release -p lab --example variants`, a minute or two.

use fem::newton::iteration::NewtonSettings;
use fem_client::scene::{Level, Scene};
use fem_client::solver::{Solved, StartState};
use tire::embedded::EmbeddedSolver;
use tire::model::mesh_plan;

use lab::cpu::cpu_seconds;
use lab::reference_tire::{reference, solve};

/// Half ranges of the depths about their mean of 1 mm, mm.
const RANGES: [f64; 2] = [0.3, 1.0];
/// Outermost node of the Gauss rule of five points on -1 to 1.
const OUTERMOST: f64 = 0.906_179_845_938_664;
/// Stations whose depth is varied: the middle leaves left and right alike, the others are mirror images.
const STATIONS: [usize; 3] = [2, 1, 3];

/// Tolerance that is only limited by round-off.
const TIGHT: f64 = 1e-12;
/// Tolerance of the product.
const USUAL: f64 = 1e-8;

/// Settings with which the points are solved.
struct Variant {
    name: &'static str,
    settings: NewtonSettings,
    level: Level,
    /// Start at the cut point's equilibrium, with its tangent.
    is_warm: bool,
    /// Take a point's mirror image where that is known.
    is_mirrored: bool,
}

/// Cost of the points, and their answers.
struct Outcome {
    iterations: usize,
    factorisations: usize,
    set_up_s: f64,
    cpu_s: f64,
    points: Vec<Solved>,
}

fn main() {
    for range in RANGES {
        println!("### Depths 1 mm +-{range} mm\n");
        println!(
            "| variant | solves | iterations | factorisations | CPU s | shared before, CPU s | reaction, relative | strains, absolute |"
        );
        println!("| ---{} |", " | ---".repeat(7));
        let truth = run(&exact(), range);
        line("pure Newton from nothing, 1e-12", &truth, &truth);
        for variant in variants() {
            line(variant.name, &run(&variant, range), &truth);
        }
        println!();
    }
}

fn settings(tolerance: f64) -> NewtonSettings {
    NewtonSettings {
        tolerance,
        ..NewtonSettings::default()
    }
}

fn pure(tolerance: f64) -> NewtonSettings {
    NewtonSettings {
        renewal_cost: 0.0,
        ..settings(tolerance)
    }
}

fn exact() -> Variant {
    Variant {
        name: "",
        settings: pure(TIGHT),
        level: Level::Standard,
        is_warm: false,
        is_mirrored: false,
    }
}

fn variants() -> Vec<Variant> {
    let cold = |name, settings| Variant {
        name,
        settings,
        ..exact()
    };
    let warm = |name, settings| Variant {
        is_warm: true,
        ..cold(name, settings)
    };
    let product = |name, tolerance| Variant {
        is_mirrored: true,
        ..warm(name, settings(tolerance))
    };
    let plain = NewtonSettings {
        acceleration_depth: 0,
        ..settings(USUAL)
    };
    vec![
        cold("pure Newton from nothing, 1e-8", pure(USUAL)),
        cold("kept tangent from nothing, 1e-8", settings(USUAL)),
        warm("pure Newton from the cut point, 1e-8", pure(USUAL)),
        warm("kept tangent, not accelerated, 1e-8", plain),
        warm("kept tangent, 1e-8", settings(USUAL)),
        product("kept tangent, mirrored points, 1e-8: the product", USUAL),
        product("the same, 1e-6", 1e-6),
        product("the same, 1e-10", 1e-10),
        Variant {
            level: Level::Reference,
            ..product("the product on the reference mesh", USUAL)
        },
    ]
}

fn run(variant: &Variant, range: f64) -> Outcome {
    let begin = cpu_seconds();
    let solver = || EmbeddedSolver::with_settings(variant.settings);
    // Whatever one solver has seen it mirrors: another one makes mirror images anew.
    let (solver, other) = (solver(), solver());
    let solver_of = |station| match station {
        3 if !variant.is_mirrored => &other,
        _ => &solver,
    };
    let start = variant.is_warm.then(|| {
        let start = point(variant, &solver, None, &even()).state;
        for (station, shift) in [(2, 0.0), (1, f64::EPSILON), (3, f64::EPSILON)] {
            let neighbour = varied(station, shift);
            point(variant, solver_of(station), Some(&start), &neighbour);
        }
        start
    });
    let ready = cpu_seconds();
    let mut points = Vec::new();
    for station in STATIONS {
        for side in [-OUTERMOST, OUTERMOST] {
            let scene = varied(station, side * range);
            points.push(point(variant, solver_of(station), start.as_ref(), &scene));
        }
    }
    let total = |count: fn(&Solved) -> usize| points.iter().map(count).sum();
    Outcome {
        iterations: total(|solved| solved.cost.newton_iterations),
        factorisations: total(|solved| solved.cost.factorisations),
        set_up_s: ready - begin,
        cpu_s: cpu_seconds() - ready,
        points,
    }
}

fn even() -> Scene {
    reference(1.0)
}

fn varied(station: usize, shift: f64) -> Scene {
    let mut scene = even();
    scene.ground.depths_mm[station] += shift;
    scene
}

fn point(
    variant: &Variant,
    solver: &EmbeddedSolver,
    start: Option<&StartState>,
    scene: &Scene,
) -> Solved {
    solve(solver, scene, &mesh_plan(scene, variant.level), start)
}

fn line(name: &str, outcome: &Outcome, truth: &Outcome) {
    let (mut reaction, mut strain) = (0.0, 0.0);
    for (a, b) in outcome.points.iter().zip(&truth.points) {
        let (a, b) = (&a.response, &b.response);
        reaction = f64::max(reaction, (a.reaction_n / b.reaction_n - 1.0).abs());
        for (p, q) in a.locations.iter().zip(&b.locations) {
            let x = (p.strain.x - q.strain.x).abs();
            strain = f64::max(strain, x.max((p.strain.y - q.strain.y).abs()));
        }
    }
    println!(
        "| {name} | {} | {} | {} | {:.2} | {:.2} | {reaction:.0e} | {strain:.0e} |",
        outcome.points.len(),
        outcome.iterations,
        outcome.factorisations,
        outcome.cpu_s,
        outcome.set_up_s,
    );
}
