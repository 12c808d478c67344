//! The reference tire and its variants against an independent code, digit by digit: same mesh, same contact law, same
//! readout.
//!
//! Three things are known to differ. Below a cord stretch of 1.004 the other code rounds off the corner between taut and slack,
//! ours doesn't. It reads the meridional strain of 8-node bricks in a way unknown to us. Its full stick isn't our friction:
//! `reference_tire.rs` compares the two.

mod independent;

use independent::{Figures, figures, solve};

/// Both codes stop Newton's method at a small residual, not at none: a reaction at 2e-7 of itself, a strain at 4e-9 at most was
/// seen, and these bounds were set after it.
const REACTION_TOLERANCE: f64 = 1e-6;
const STRAIN_TOLERANCE: f64 = 1e-8;
/// Last digit of the tabulated radii and stretches of the inflated tire.
const INFLATED_TOLERANCE: f64 = 1e-9;
/// Where the other code's rounded corner ends.
const TAUT: f64 = 1.004;
/// Displacements of the meshes that are solved here: seconds each.
const QUICK: usize = 20_000;

/// Solves the quick cases among these and returns how many equilibria were compared in full.
fn compare(is_asked: impl Fn(&Figures) -> bool) -> usize {
    let quick = |figures: &Figures| figures.displacements() < QUICK;
    let stuck = |figures: &Figures| figures.scene.contact.friction > 0.0;
    let figures: Vec<Figures> = figures()
        .into_iter()
        .filter(|figures| quick(figures) && !stuck(figures) && is_asked(figures))
        .collect();
    let mut compared = 0;
    for case in figures.chunk_by(|a, b| a.case == b.case) {
        for (theirs, ours) in case.iter().zip(solve(case)) {
            let what = format!("{}, {} mm", theirs.case, theirs.depth_mm);
            let (a, b) = (&theirs.solution, &ours.solution);
            assert_near(
                a.inflated_radius_mm,
                b.inflated_radius_mm,
                INFLATED_TOLERANCE,
                &what,
            );
            for (a, b) in theirs
                .inflated_stretch
                .iter()
                .flatten()
                .zip(ours.inflated_stretch)
            {
                assert_near(*a, b, INFLATED_TOLERANCE, &what);
            }
            if ours.least_cord_stretch < TAUT {
                continue;
            }
            compared += 1;
            let allowed = REACTION_TOLERANCE * a.reaction_n;
            assert_near(a.reaction_n, b.reaction_n, allowed, &what);
            let points = if is_linear(theirs) { 1 } else { 3 };
            for k in 0..points {
                assert_near(a.x[k], b.x[k], STRAIN_TOLERANCE, &what);
                if !is_linear(theirs) {
                    assert_near(a.y[k], b.y[k], STRAIN_TOLERANCE, &what);
                }
            }
        }
    }
    compared
}

fn is_linear(figures: &Figures) -> bool {
    figures.plan.order == fem::element::Order::Linear
}

#[track_caller]
fn assert_near(theirs: f64, ours: f64, tolerance: f64, what: &str) {
    assert!(
        (theirs - ours).abs() < tolerance,
        "{what}: theirs {theirs}, ours {ours}"
    );
}

#[test]
fn the_reference_tire_is_the_independent_code_s_on_its_meshes() {
    // Q1-A at 0.5 and 1 mm, where all cords are taut, and Q1-B, Q1-C, Q2-L0, L1 and L2 at all three depths.
    let seen = compare(|figures| figures.case.starts_with('Q'));
    assert_eq!(seen, 2 + 5 * 3);
}

#[test]
fn its_variants_are_too() {
    // Bare rubber at 8 depths, four variants at 4, and 0.1 MPa at 0.5 mm, where all cords are taut.
    let seen = compare(|figures| !figures.case.starts_with('Q'));
    assert_eq!(seen, 8 + 4 * 4 + 1);
}
