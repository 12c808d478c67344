//! The reference tire and its variants against an independent code, digit by digit: same mesh, same contact law, same
//! readout.
//!
//! One thing is known to differ: its full stick isn't our friction. `reference_tire.rs` compares the two.

use crate::independent::finest::{SCALARS, finest};
use crate::independent::{Figures, figures, solve};

/// Both codes stop Newton's method at a small residual, not at none: a reaction at 2e-7 of itself, a strain at 4e-9 at most was
/// seen, and these bounds were set after it.
const REACTION_TOLERANCE: f64 = 1e-6;
const STRAIN_TOLERANCE: f64 = 1e-8;
/// Last digit of the tabulated radii and stretches of the inflated tire.
const INFLATED_TOLERANCE: f64 = 1e-9;
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
            compared += 1;
            let allowed = REACTION_TOLERANCE * a.reaction_n;
            assert_near(a.reaction_n, b.reaction_n, allowed, &what);
            for k in 0..3 {
                assert_near(a.x[k], b.x[k], STRAIN_TOLERANCE, &what);
                assert_near(a.y[k], b.y[k], STRAIN_TOLERANCE, &what);
            }
        }
    }
    compared
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
    // Q1-A, B and C, Q2-L0, L1 and L2, at three depths each.
    let seen = compare(|figures| figures.case.starts_with('Q'));
    assert_eq!(seen, 6 * 3);
}

#[test]
fn its_variants_are_too() {
    // Bare rubber at 8 depths, five variants at 4.
    let seen = compare(|figures| !figures.case.starts_with('Q'));
    assert_eq!(seen, 8 + 5 * 4);
}

/// Lengths and ratios that depend on single integration points, in the digits of the table.
const SCALAR_TOLERANCE: f64 = 1e-8;

#[test]
fn its_finest_mesh_agrees_all_along_the_crown() {
    let mut asked = finest();
    asked.retain(|asked| asked.figures.depth_mm == 1.0);
    let ours = crate::independent::finest::solve(&asked);
    let (theirs, ours) = (&asked[0], &ours[0]);
    let reaction = theirs.figures.solution.reaction_n;
    let allowed = REACTION_TOLERANCE * reaction;
    assert_near(reaction, ours.reaction_n, allowed, "reaction");
    assert_eq!(theirs.crown_line.len(), 47);
    for (a, b) in theirs.crown_line.iter().zip(&ours.crown_line) {
        for k in 1..4 {
            assert_near(a[k], b[k], STRAIN_TOLERANCE, &format!("{} rad", a[0]));
        }
    }
    for (k, name) in SCALARS.into_iter().enumerate() {
        assert_near(theirs.scalars[k], ours.scalars[k], SCALAR_TOLERANCE, name);
    }
}
