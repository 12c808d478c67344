//! A scene in several units: no number in the solver may have a dimension.
//!
//! A document gives lengths in mm and stresses in MPa and has ranges for them; these scenes are made below its reader. With
//! lengths times l and stresses times s strains stay, and forces are times s l^2.

use std::sync::atomic::AtomicBool;

use super::draft::{Bench, reference};
use crate::family::Unsolved;
use crate::known_case::Case;
use fem_client::scene::{Carcass, Law, Scene};
use fem_client::solver::Response;

/// Tolerance of all answers. Newton's tolerance leaves a hundredth.
const SAME: f64 = 1e-9;
const SOURCE: &str = "the same scene in mm and MPa";

/// Unit names with the numbers of them in a mm and a MPa.
const UNITS: [(&str, f64, f64); 5] = [
    ("micrometres and pascals", 1e3, 1e6),
    ("micrometres and gigapascals", 1e3, 1e-3),
    ("metres and pascals", 1e-3, 1e6),
    ("metres and gigapascals", 1e-3, 1e-3),
    ("nanometres and gigapascals", 1e6, 1e-3),
];

/// The scene with all lengths and stresses multiplied.
fn scaled(scene: &Scene, length: f64, stress: f64) -> Scene {
    let mut scaled = scene.clone();
    let geometry = &mut scaled.geometry;
    geometry.outer_radius_mm *= length;
    geometry.section_radius_mm *= length;
    geometry.wall_mm *= length;
    if let Law::MooneyRivlin { c10_mpa, c01_mpa } = &mut scaled.material.law {
        *c10_mpa *= stress;
        *c01_mpa *= stress;
    }
    scaled.material.d1_per_mpa /= stress;
    if let Some(carcass) = &mut scaled.carcass {
        carcass.stiffness_n_per_mm *= stress * length;
    }
    scaled.pressure.internal_mpa *= stress;
    scaled.ground.station_spacing_mm *= length;
    for depth in &mut scaled.ground.depths_mm {
        *depth *= length;
    }
    scaled
}

/// Reaction in N (of the units), and the largest difference of a strain.
fn compare(answer: &Response, reference: &Response) -> f64 {
    let pairs = answer.locations.iter().zip(&reference.locations);
    let difference = |(a, b): (
        &fem_client::solver::LocationStrain,
        &fem_client::solver::LocationStrain,
    )| {
        let (x, y) = (a.strain.x - b.strain.x, a.strain.y - b.strain.y);
        x.abs().max(y.abs())
    };
    pairs.map(difference).fold(0.0, f64::max)
}

/// A pressed tire and a limit pressure in all units.
pub(super) fn cases(stop: &AtomicBool) -> Result<Vec<Case>, Unsolved> {
    let bench = Bench::tight(stop);
    let mut pressed = reference();
    pressed.material.d1_per_mpa = 0.01;
    pressed.ground.depths_mm = vec![0.7, 0.9, 1.2, 1.0, 0.8];
    let answer = bench.solve(&pressed)?.response;
    let mut slack = reference();
    slack.carcass = None::<Carcass>;
    slack.pressure.internal_mpa = 10.0;
    let limit = bench.refusal(&slack)?;
    let mut cases = Vec::new();
    for (units, length, stress) in UNITS {
        let other = bench.solve(&scaled(&pressed, length, stress))?.response;
        let reaction = other.reaction_n / (stress * length * length);
        let name = format!("in {units}: reaction, N");
        cases.push(Case::relative(name, reaction, answer.reaction_n).within(SAME, SOURCE));
        let name = format!("in {units}: largest difference of a strain at P1-P5");
        cases.push(Case::absolute(name, compare(&other, &answer), 0.0).within(SAME, SOURCE));
        let refusal = bench.refusal(&scaled(&slack, length, stress))?;
        let name = format!("in {units}: pressure that ends inflation, MPa");
        let pressure = refusal.reached.pressure_mpa / stress;
        let case = Case::relative(name, pressure, limit.reached.pressure_mpa).within(SAME, SOURCE);
        cases.push(case.ended(refusal.status.as_str()));
    }
    Ok(cases)
}
