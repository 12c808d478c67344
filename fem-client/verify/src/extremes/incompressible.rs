//! Bulk over shear modulus from 10 to infinity: everything goes to the exactly incompressible tire like mu / kappa.
//!
//! The equilibrium is an analytic function of the compliance 1/kappa, which the incompressible one has at 0.

use std::sync::atomic::AtomicBool;

use fem::solid::SolidGeometry;

use super::draft::{Bench, REACTION_NOISE, STRAIN_NOISE, TOLERANCE, reference};
use super::trend::{Limit, Point, rises};
use crate::family::Unsolved;
use crate::known_case::Case;
use fem_client::scene::Scene;
use fem_client::solver::Response;
use tire::mesh::tire_grid::Extent;
use tire::model::{TireModel, mesh_plan};

/// Bulk over shear modulus.
const RATIOS: [f64; 6] = [1e1, 1e2, 1e3, 1e5, 1e7, 1e9];

const SOURCE: &str = "exactly incompressible (d1 = 0); the difference falls like mu / kappa";

fn scene(compliance: f64) -> Scene {
    let mut scene = reference();
    scene.material.d1_per_mpa = 2.0 * compliance;
    scene
}

/// Returns what the volume's tolerance leaves of a brick's volume ratio: the residual's norm is relative to that of all volumes.
fn volume_noise(scene: &Scene) -> Result<f64, Unsolved> {
    let plan = mesh_plan(scene, scene.model.level);
    let mesh = TireModel::new(scene, &plan, Extent::Quarter).problem.mesh;
    let geometry = SolidGeometry::new(&mesh).map_err(fem::linear::setup::SetupError::from)?;
    let volumes: Vec<f64> = (0..mesh.brick_count())
        .map(|e| geometry.volume(e))
        .collect();
    let norm = volumes.iter().map(|v| v * v).sum::<f64>().sqrt();
    let smallest = volumes.into_iter().fold(f64::INFINITY, f64::min);
    Ok(TOLERANCE * norm / smallest)
}

/// A quantity of the answer, and what the solver leaves of it.
type Quantity = (&'static str, fn(&Response) -> f64, f64);

/// Reaction, strains at the centre and largest change of volume at all ratios.
pub(super) fn cases(stop: &AtomicBool) -> Result<Vec<Case>, Unsolved> {
    let bench = Bench::tight(stop);
    let limit = bench.solve(&scene(0.0))?.response;
    let modulus = reference().material.law.shear_modulus_mpa();
    let solve = |ratio: &f64| bench.solve(&scene(1.0 / (ratio * modulus)));
    let answers: Result<Vec<_>, _> = RATIOS.iter().map(solve).collect();
    let answers: Vec<Response> = answers?.into_iter().map(|solved| solved.response).collect();
    let volume_noise = volume_noise(&scene(0.0))?;
    let quantities: [Quantity; 4] = [
        (
            "reaction, N",
            |r| r.reaction_n,
            REACTION_NOISE * limit.reaction_n,
        ),
        ("x strain at P3", |r| r.locations[2].strain.x, STRAIN_NOISE),
        ("y strain at P3", |r| r.locations[2].strain.y, STRAIN_NOISE),
        ("largest |J - 1|", |r| r.max_volume_change, volume_noise),
    ];
    let mut cases = Vec::new();
    for (quantity, read, noise) in quantities {
        let exact = read(&limit);
        // Nothing changes its volume in the limit.
        let incompressible = exact.abs() <= volume_noise;
        let law = Limit {
            value: if incompressible { 0.0 } else { exact },
            noise,
            order: 1.0,
            source: SOURCE,
        };
        let point = |(ratio, answer): (&f64, &Response)| Point {
            label: format!("kappa / mu = {ratio:e}"),
            parameter: *ratio,
            value: read(answer),
        };
        let points: Vec<Point> = RATIOS.iter().zip(&answers).map(point).collect();
        cases.extend(law.cases(quantity, &points));
    }
    let reactions = answers.iter().map(|answer| answer.reaction_n);
    let reactions: Vec<f64> = reactions.chain([limit.reaction_n]).collect();
    let noise = REACTION_NOISE * limit.reaction_n;
    cases.push(rises(
        "reaction as kappa / mu grows from 10 to infinity",
        &reactions,
        noise,
        "a stiffer body of the same shape resists more",
    ));
    let name = "exactly incompressible: largest |J - 1|";
    let case = Case::absolute(name, limit.max_volume_change, 0.0);
    cases.push(case.within(
        volume_noise,
        "exact: no change; tolerance: Newton's, on the smallest brick",
    ));
    Ok(cases)
}
