//! Depths from a millionth of a millimetre until the tire touches itself.

use std::sync::atomic::AtomicBool;

use super::draft::{Bench, REACTION_NOISE, reference};
use super::first_touch::hertz_force;
use super::trend::rises;
use crate::body::SHEAR_MODULUS;
use crate::family::Unsolved;
use crate::known_case::Case;
use fem_client::scene::Scene;
use fem_client::solver::{LocationStrain, NoEquilibrium, Response};

/// Depths of all stations, mm.
const DEPTHS: [f64; 13] = [
    1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 0.1, 0.3, 1.0, 2.0, 4.0, 8.0, 11.0, 12.0,
];
/// Bounds of the depths, mm: from the first on the contact is more than two of the draft mesh's bricks long, and up to the second the section keeps
/// its shape. (Set after a look at 0.1 to 0.3 mm: the power is 1.74 there, on one brick.)
const SEEN: f64 = 0.3;
/// See [`SEEN`].
const SHALLOW: f64 = 4.0;
/// Largest relative residual of a study's equilibria.
const STUDY_TOLERANCE: f64 = 1e-8;
/// Depths at which left and right are compared.
const LOPSIDED: [f64; 4] = [0.01, 0.3, 2.0, 8.0];
/// Depths beyond self-contact, mm.
const TOO_DEEP: [f64; 2] = [12.5, 14.0];
/// Share of the way to a depth within which self-contact is found.
const BRACKET: f64 = 1.0 / 128.0;
/// Tolerance of mirrored strains.
const SYMMETRIC: f64 = 1e-9;

fn scene(depths: &[f64]) -> Scene {
    let mut scene = reference();
    scene.ground.depths_mm = depths.to_vec();
    scene
}

/// Rising reactions, symmetric strains, and the end.
pub(super) fn cases(stop: &AtomicBool) -> Result<Vec<Case>, Unsolved> {
    let bench = Bench::tight(stop);
    let solve = |depth: &f64| bench.solve(&scene(&[*depth; 5]));
    let answers: Result<Vec<_>, _> = DEPTHS.iter().map(solve).collect();
    let answers: Vec<Response> = answers?.into_iter().map(|solved| solved.response).collect();
    let reactions: Vec<f64> = answers.iter().map(|answer| answer.reaction_n).collect();
    let scale = reactions.last().copied().unwrap_or_default();
    let mut cases = vec![rises(
        "depths from 1e-6 to 12 mm: reaction",
        &reactions,
        REACTION_NOISE * scale,
        "a stable body resists more, the deeper it is pressed",
    )];
    cases.push(untouched(reactions[0]));
    cases.extend(exponents(&reactions));
    for depth in LOPSIDED {
        cases.push(symmetry(&bench, depth)?);
    }
    cases.extend(self_contact(stop)?);
    Ok(cases)
}

/// The smallest depth is far below what the mesh shows: what it should press with is below the tolerance of the forces.
fn untouched(reaction: f64) -> Case {
    let scene = reference();
    let section = scene.geometry.section_radius_mm;
    let radii = [scene.geometry.outer_radius_mm, section];
    let expected = hertz_force(DEPTHS[0], radii, 4.0 * SHEAR_MODULUS);
    let name = format!("depth {:e} mm, draft mesh: reaction, N", DEPTHS[0]);
    let case = Case::absolute(name, reaction, expected);
    let load = scene.pressure.internal_mpa * section * section;
    case.within(
        STUDY_TOLERANCE * load,
        "Hertz; tolerance: 1e-8 of pressure times section radius squared, as of all forces",
    )
}

/// Powers of the depth by which the reaction grows.
fn exponents(reactions: &[f64]) -> Vec<Case> {
    let pairs = DEPTHS.windows(2).zip(reactions.windows(2));
    let pairs = pairs.filter(|(depth, _)| depth[0] >= SEEN && depth[1] <= SHALLOW);
    let case = |(depth, reaction): (&[f64], &[f64])| {
        let exponent = (reaction[1] / reaction[0]).ln() / (depth[1] / depth[0]).ln();
        let name = format!(
            "depths {} to {} mm: power of the depth in the reaction",
            depth[0], depth[1]
        );
        let source = "between 1, a membrane under pressure, and 3/2, a Hertz contact";
        Case::absolute(name, exponent, 1.25).within(0.25, source)
    };
    pairs.map(case).collect()
}

/// Mirrored ground: the half model, which it needs not for this ground but for the next number to one depth.
fn symmetry(bench: &Bench<'_>, depth: f64) -> Result<Case, Unsolved> {
    let depths = [0.8, 0.9, 1.0, 0.9, 0.8].map(|share| share * depth);
    let mut nearly = depths;
    nearly[4] = depths[4].next_up();
    let half = bench.solve(&scene(&nearly))?.response;
    let quarter = bench.solve(&scene(&depths))?.response;
    let pairs = half.locations.iter().zip(half.locations.iter().rev());
    let pairs = pairs.chain(half.locations.iter().zip(&quarter.locations));
    let difference = |(a, b): (&LocationStrain, &LocationStrain)| {
        let (x, y) = (a.strain.x - b.strain.x, a.strain.y - b.strain.y);
        x.abs().max(y.abs())
    };
    let largest = pairs.map(difference).fold(0.0, f64::max);
    let name = format!("symmetric depths up to {depth} mm: largest difference of mirrored strains");
    let case = Case::absolute(name, largest, 0.0);
    Ok(case.within(
        SYMMETRIC,
        "exact: symmetry; left against right, and half against quarter model",
    ))
}

/// Two ways that end where the tire touches itself, and the equilibrium just before.
fn self_contact(stop: &AtomicBool) -> Result<Vec<Case>, Unsolved> {
    let bench = Bench::usual(stop);
    let mut ends = Vec::new();
    for depth in TOO_DEEP {
        let refusal = bench.refusal(&scene(&[depth; 5]))?;
        let named = matches!(
            refusal.status,
            NoEquilibrium::SelfContact | NoEquilibrium::Crushed
        );
        let reached = refusal.reached.depths_mm.first().copied();
        match reached.filter(|_| named) {
            Some(reached) => ends.push((reached, refusal.text())),
            None => return Err(Unsolved::Other(refusal.text())),
        }
    }
    let [(first, text), (second, _)] = &ends[..] else {
        return Ok(Vec::new());
    };
    let name = format!(
        "depth {} mm: depth at which the tire touches itself, mm",
        TOO_DEEP[0]
    );
    let case = Case::absolute(name, *first, *second).within(
        BRACKET * TOO_DEEP[1],
        "the same from 14 mm; tolerance: the width of that search",
    );
    let before = bench.solve(&scene(&[*first; 5]))?.response;
    let finite = before.reaction_n.is_finite();
    let name = "the depth before it: reaction is finite";
    let found = Case::absolute(name, f64::from(u8::from(finite)), 1.0);
    Ok(vec![
        case.ended(text),
        found.within(0.0, "an equilibrium that doesn't touch itself"),
    ])
}
