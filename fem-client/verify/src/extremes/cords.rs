//! Cords from nothing to steel: the stiffer they are, the less the tire grows and the harder it is to press.
//!
//! With stiff cords their stretch is the tension, which the pressure sets, over the stiffness.

use std::sync::atomic::AtomicBool;

use fem::newton::volume_control::LIMIT_TOLERANCE;

use super::draft::{Bench, REACTION_NOISE, STRAIN_NOISE, reference};
use super::trend::{Limit, Point, rises};
use crate::family::Unsolved;
use crate::known_case::Case;
use fem_client::scene::Scene;

/// Stiffness of each family, N/mm. Steel cords of 0.2 mm^2, one to the mm, have 40 000.
const STIFFNESSES: [f64; 7] = [0.0, 1.0, 10.0, 1e2, 1e3, 1e4, 4e4];
/// The first of them whose cords carry nearly all of the pressure.
const STIFF: usize = 3;
/// A pressure that the rubber alone can carry, MPa.
const LOW: f64 = 0.05;

fn scene(stiffness: f64, pressure: f64) -> Scene {
    let mut scene = reference();
    if let Some(carcass) = &mut scene.carcass {
        carcass.stiffness_n_per_mm = stiffness;
    }
    scene.pressure.internal_mpa = pressure;
    scene
}

/// All stiffnesses at a low pressure, and none at a high one.
pub(super) fn cases(stop: &AtomicBool) -> Result<Vec<Case>, Unsolved> {
    let bench = Bench::tight(stop);
    let solve = |stiffness: &f64| bench.solve(&scene(*stiffness, LOW));
    let answers: Result<Vec<_>, _> = STIFFNESSES.iter().map(solve).collect();
    let answers: Vec<_> = answers?.into_iter().map(|solved| solved.response).collect();
    let reactions: Vec<f64> = answers.iter().map(|answer| answer.reaction_n).collect();
    let smaller = answers
        .iter()
        .map(|answer| -answer.inflated.outer_radius_mm);
    let smaller: Vec<f64> = smaller.collect();
    let last = reactions.last().copied().unwrap_or_default();
    let mut cases = vec![
        rises(
            "cords from 0 to 40 000 N/mm: reaction",
            &reactions,
            REACTION_NOISE * last,
            "stiffer cords resist more",
        ),
        rises(
            "cords from 0 to 40 000 N/mm: fall of the inflated radius",
            &smaller,
            STRAIN_NOISE * reference().geometry.outer_radius_mm,
            "stiffer cords stretch less",
        ),
    ];
    let mut points = Vec::new();
    for stiffness in &STIFFNESSES[STIFF..] {
        let mut inflated = scene(*stiffness, LOW);
        inflated.ground.depths_mm.fill(0.0);
        let cords = bench.solve(&inflated)?.response.carcass;
        points.push(Point {
            label: format!("inflated, cords of {stiffness} N/mm"),
            parameter: *stiffness,
            value: cords.map_or(f64::NAN, |cords| cords.fibre_stretch.max - 1.0),
        });
    }
    let law = Limit {
        value: 0.0,
        noise: STRAIN_NOISE,
        order: 1.0,
        source: "tension over stiffness, at a tension that the pressure sets",
    };
    cases.extend(law.cases("largest strain of a cord", &points));
    cases.extend(without_stiffness(&bench, reactions[0])?);
    Ok(cases)
}

/// Cords without stiffness are no cords.
fn without_stiffness(bench: &Bench<'_>, reaction: f64) -> Result<[Case; 2], Unsolved> {
    let bare = |pressure| Scene {
        carcass: None,
        ..scene(0.0, pressure)
    };
    let expected = bench.solve(&bare(LOW))?.response.reaction_n;
    let case = Case::relative("cords of 0 N/mm: reaction, N", reaction, expected);
    let same = case.within(2.0 * REACTION_NOISE, "the same tire without cords");
    let high = reference().pressure.internal_mpa;
    let refusal = bench.refusal(&scene(0.0, high))?;
    let expected = bench.refusal(&bare(high))?.reached.pressure_mpa;
    let name = format!("cords of 0 N/mm at {high} MPa: pressure that ends inflation, MPa");
    let case = Case::relative(name, refusal.reached.pressure_mpa, expected);
    let case = case.within(2.0 * LIMIT_TOLERANCE, "the same tire without cords");
    Ok([same, case.ended(refusal.text())])
}
