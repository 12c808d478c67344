//! Studies at the ends of what their inputs can spread: a family of the cases of [`crate::extremes`].
//!
//! - **A small spread h** sees a linear model: with slopes g S_i = g_i^2 / sum of all g_k^2, and the difference from it falls like h at least.
//!   (On a mesh the slope jumps a little where a point of the contact opens or closes, so the slopes are secants over the spread.) Once h
//!   moves a strain by less than what the solver leaves open, nothing may be ranked, or the claimed error must say so.
//! - **A spread of all of the mean** lets stations lose contact: M-DRM's claimed error must cover the difference from a grid of
//!   all combinations.

use std::sync::atomic::AtomicBool;

use super::draft::{STRAIN_NOISE, tight_solver};
use super::trend::{Limit, Point};
use crate::family::{Family, Unsolved};
use crate::known_case::Case;
use fem_client::scene::{Level, Scene};
use fem_client::solver::direction::Direction;
use fem_client::solver::{Readout, Response, SolveError, SolveRequest, Solved, Solver, StartState};
use gsa::law::distribution::Distribution;
use gsa::method::analysis::Status;
use gsa::method::{Kind, Method};
use tire::embedded::EmbeddedSolver;

use documents::layouts::layout_settings::Layouts;
use documents::parts::directions::Directions;
use documents::study::plan::Plan;
use documents::study::question::Question;
use documents::study::{Accuracy, Input, Study};
use placement::points::RunContext;
use placement::points::memory::MemoryArchive;
use placement::run::run;
use results::{Output, StudyResult};

/// Spreads from nothing to all of the mean.
pub const FAMILY: Family = Family::new("spread", cases);

/// Half widths of uniform depths over their mean of 1 mm: those that show the rate, solved tightly (between 0.01 and 1e-3 single points of
/// the contact that open or close scatter the slopes by 1e-3, seen before the series was cut), and smaller ones, solved
/// as studies are, down to where the solver sees nothing.
const SMALL: [f64; 3] = [0.3, 0.1, 0.03];
/// See [`SMALL`].
const TINY: [f64; 5] = [1e-5, 1e-6, 1e-7, 1e-8, 1e-9];
/// Noise that the solver leaves of an index over 0.01 mm, relative: its noise in a strain over a change of some 1e-4.
const INDEX_NOISE: f64 = 1e4 * STRAIN_NOISE;
/// Step of the differences that give the gradient, mm: less than what a contact point takes to close.
const STEP: f64 = 1e-5;
/// Station that varies in the wide study, and its neighbour.
const WIDE: [usize; 2] = [2, 3];
/// Nodes of the grids that stand for the truth.
const TRUTH: [usize; 2] = [6, 8];

/// Solves on one mesh only: what these cases ask isn't a question of the mesh.
struct OneMesh(EmbeddedSolver);

impl Solver for OneMesh {
    fn version(&self) -> String {
        self.0.version()
    }

    fn solve(&self, request: &SolveRequest<'_>) -> Result<Solved, SolveError> {
        self.0.solve(request)
    }
}

fn draft() -> Scene {
    let mut scene = Scene::preset("foot-tire").unwrap_or_default();
    scene.model.level = Level::Draft;
    scene
}

/// A study of these stations' depths, uniform within a half width (mm) of their means in the scene.
fn study(
    scene: Scene,
    stations: &[usize],
    half_width: f64,
    method: Method,
) -> Result<Study, Unsolved> {
    let input = |&station: &usize| {
        let mean = scene.ground.depths_mm[station];
        let law = Distribution::uniform(mean - half_width, mean + half_width);
        Ok(Input {
            name: format!("P{}", station + 1),
            vary: format!("ground.depths_mm[{station}]"),
            distribution: law.map_err(|fault| Unsolved::Other(fault.to_string()))?,
        })
    };
    let inputs: Result<Vec<Input>, Unsolved> = stations.iter().map(input).collect();
    Ok(Study {
        name: format!("spread of {half_width} mm"),
        inputs: inputs?,
        level: scene.model.level,
        scene,
        directions: Directions::Both,
        grid: None,
        layouts: Layouts::none(),
        question: Question::default(),
        method,
        accuracy: Accuracy::Preset,
        signals: None,
        rig: None,
    })
}

fn answer(
    study: &Study,
    solver: EmbeddedSolver,
    stop: &AtomicBool,
) -> Result<StudyResult, Unsolved> {
    let plan = Plan::new(study).map_err(|fault| Unsolved::Other(fault.to_string()))?;
    let context = RunContext {
        solver: &OneMesh(solver),
        archive: &MemoryArchive::default(),
        threads: 1,
        stop,
        pause: None,
        observer: &|_| {},
    };
    run(study, &plan, context).map_err(|fault| Unsolved::Other(fault.to_string()))
}

/// Largest difference of two lists of indices.
fn distance(a: &[f64], b: &[f64]) -> f64 {
    let pairs = a.iter().zip(b);
    pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}

/// All spreads.
fn cases(stop: &AtomicBool) -> Result<Vec<Case>, Unsolved> {
    let mut cases = small(stop)?;
    cases.extend(wide(stop)?);
    Ok(cases)
}

/// Studies of five depths with a small spread against linear models, for the strains at the centre.
fn small(stop: &AtomicBool) -> Result<Vec<Case>, Unsolved> {
    let mut series = [Vec::new(), Vec::new()];
    for spread in SMALL {
        let linear = linear_indices(spread, stop)?;
        let result = answer(&five(spread)?, tight_solver(), stop)?;
        for (points, (output, linear)) in series.iter_mut().zip(at_centre(&result, &linear)) {
            let indices = output.first_order.as_deref().unwrap_or_default();
            points.push(Point {
                label: format!("spread {spread:e} of the mean"),
                parameter: 1.0 / spread,
                value: distance(indices, linear),
            });
        }
    }
    let law = Limit {
        value: 0.0,
        noise: INDEX_NOISE,
        order: 1.0,
        source: "secants over the spread; the difference falls at least like it",
    };
    let mut cases = Vec::new();
    for (direction, points) in Direction::ALL.iter().zip(&series) {
        let quantity = format!("largest error of an index, {direction} strain at P3");
        cases.extend(law.cases(&quantity, points));
    }
    let linear = linear_indices(STEP, stop)?;
    for spread in TINY {
        let result = answer(&five(spread)?, EmbeddedSolver::default(), stop)?;
        for (k, (output, linear)) in at_centre(&result, &linear).into_iter().enumerate() {
            cases.push(tiny_case(spread, Direction::ALL[k], output, linear));
        }
    }
    Ok(cases)
}

/// The study of all five depths.
fn five(spread: f64) -> Result<Study, Unsolved> {
    let scene = draft();
    let all: Vec<usize> = (0..scene.ground.depths_mm.len()).collect();
    study(scene, &all, spread, Method::of(Kind::Mdrm))
}

/// The strains at the centre, x and y, each with the indices that it should have.
fn at_centre<'r>(
    result: &'r StudyResult,
    linear: &'r [Vec<f64>; 2],
) -> Vec<(&'r Output, &'r [f64])> {
    let centre = result
        .outputs
        .iter()
        .filter(|output| output.location == "P3");
    centre.zip(linear.iter().map(Vec::as_slice)).collect()
}

/// Returns the case of one output of a study that sees little or nothing: where there are no indices, none is wrong.
fn tiny_case(spread: f64, direction: Direction, output: &Output, linear: &[f64]) -> Case {
    let name = format!("spread {spread:e} of the mean, {direction} strain at P3");
    let Some(indices) = &output.first_order else {
        let constant = f64::from(u8::from(output.status == Status::Constant));
        let name = format!("{name}: found constant");
        let case = Case::absolute(name, constant, 1.0);
        return case
            .within(0.0, "a spread that the solver doesn't see ranks nothing")
            .ended(output.status.as_str());
    };
    let claimed = output.error.of_method();
    let name = format!("{name}: largest error of an index");
    let case = Case::absolute(name, distance(indices, linear), 0.0)
        .within(claimed, "linearised model; tolerance: the error claimed");
    case.ended(format!(
        "{}, error claimed {claimed:.1e}",
        output.status.as_str()
    ))
}

/// Indices of the linear model with the slopes over a step (mm) to either side, for the x and the y strain at the centre: all depths have one
/// spread, which cancels.
fn linear_indices(step: f64, stop: &AtomicBool) -> Result<[Vec<f64>; 2], Unsolved> {
    let solver = tight_solver();
    let readout = Readout::default();
    let solve = |scene: &Scene, start: Option<&StartState>| {
        let request = SolveRequest {
            scene,
            readout: &readout,
            start,
            watch: stop,
        };
        solver.solve(&request)
    };
    let scene = draft();
    let start = solve(&scene, None)?.state;
    let centre = |response: &Response| <[f64; 2]>::from(response.locations[2].strain);
    let mut gradients = [Vec::new(), Vec::new()];
    for station in 0..scene.ground.depths_mm.len() {
        let at = |change: f64| {
            let mut moved = scene.clone();
            moved.ground.depths_mm[station] += change;
            solve(&moved, Some(&start)).map(|solved| centre(&solved.response))
        };
        let (up, down) = (at(step)?, at(-step)?);
        for (k, gradient) in gradients.iter_mut().enumerate() {
            gradient.push(up[k] - down[k]);
        }
    }
    Ok(gradients.map(|gradient| {
        let whole: f64 = gradient.iter().map(|g| g * g).sum();
        gradient.iter().map(|g| g * g / whole).collect()
    }))
}

/// Two neighbouring depths from nothing to twice their mean, the others at nothing: M-DRM against all combinations.
fn wide(stop: &AtomicBool) -> Result<Vec<Case>, Unsolved> {
    let scene = || {
        let mut scene = draft();
        for (station, depth) in scene.ground.depths_mm.iter_mut().enumerate() {
            *depth = if WIDE.contains(&station) { 1.0 } else { 0.0 };
        }
        scene
    };
    let solve = |method| {
        answer(
            &study(scene(), &WIDE, 1.0, method)?,
            EmbeddedSolver::default(),
            stop,
        )
    };
    let found = solve(Method::of(Kind::Mdrm))?;
    let grid = |nodes| {
        solve(Method {
            nodes,
            ..Method::of(Kind::Tensor)
        })
    };
    let (rough, truth) = (grid(TRUTH[0])?, grid(TRUTH[1])?);
    let mut cases = Vec::new();
    for ((found, rough), truth) in found.outputs.iter().zip(&rough.outputs).zip(&truth.outputs) {
        let lists = (&found.first_order, &rough.first_order, &truth.first_order);
        let (Some(indices), Some(rough), Some(true_ones)) = lists else {
            continue;
        };
        let claimed = found.error.of_method();
        let name = format!(
            "depths from 0 to 2 mm, {} strain at {}: largest error of an index",
            found.direction, found.location
        );
        let case = Case::absolute(name, distance(indices, true_ones), 0.0);
        let case = case.within(
            claimed + distance(rough, true_ones),
            "grid of 8 x 8 nodes; tolerance: the error claimed, and the grid's change from 6 x 6",
        );
        cases.push(case.ended(format!(
            "{} by {}",
            found.status.as_str(),
            found.method.as_str()
        )));
    }
    Ok(cases)
}
