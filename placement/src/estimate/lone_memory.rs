//! Peak memory of a process that solves one scene from nothing.
//!
//! An upper bound rather than a mean, because a scene is refused by it: measured peaks are half to all of it.

use fem_client::scene::Scene;
use fem_client::solver::sides::Sides;
use fem_client::solver::{Readout, Solver};

use super::peak_memory::PROGRAM;
use super::solve_time::CELLS;

/// Memory of half the tire: bytes on the draft mesh, exponent of the cells.
const HALF: (f64, f64) = (18e6, 1.25);
/// Memory of a quarter, where the ground is alike on all sides.
const QUARTER: f64 = 0.5;
/// Memory of the whole tire: a wheel that leans or is dragged across, on ground that isn't alike before and behind it, or with a film askew.
const WHOLE: f64 = 4.0;
/// Memory of a solve whose answer is differentiated, in those of the solve: the inflated and the pressed tangent are held, and both sides of a number.
const DIFFERENTIATED: f64 = 2.2;
/// Memory of the tangents about a larger part, which a number takes that breaks the symmetry, in those of a solve of that part.
const WIDENED: f64 = 1.5;

/// Largest memory of a process that solves a scene once, bytes.
pub fn solve_memory_bytes(scene: &Scene, readout: &Readout, solver: &dyn Solver) -> u64 {
    let (draft, exponent) = HALF;
    let half = draft * (solver.cells(scene) as f64 / CELLS).powf(exponent);
    (PROGRAM + solves(scene, readout) * half) as u64
}

/// Memory in that of solves of half the tire.
fn solves(scene: &Scene, readout: &Readout) -> f64 {
    let own = part(scene);
    if readout.derivatives.is_empty() {
        return own;
    }
    let sides = readout
        .derivatives
        .iter()
        .flat_map(|by| Sides::of(scene, by));
    let parts = sides.flat_map(|sides| sides.scenes.map(|side| part(&side)));
    let widened = parts.filter(|part| *part > own).fold(0.0, f64::max);
    f64::max(DIFFERENTIATED * own, WIDENED * widened)
}

/// Memory of the meshed part of the tire, in that of half of it.
fn part(scene: &Scene) -> f64 {
    let film = scene.film.as_ref();
    let is_askew = film.is_some_and(|film| film.angle_deg % 90.0 != 0.0);
    let is_aside = film.is_some_and(|film| film.theta_deg != 0.0);
    let is_alike_along = !is_aside && scene.ground.is_symmetric();
    let is_alike_across = scene.ground.is_alike_across();
    match (is_askew, is_alike_along, is_alike_across) {
        (true, _, _) | (_, false, false) => WHOLE,
        (_, true, true) => QUARTER,
        _ => 1.0,
    }
}

#[cfg(test)]
mod tests {
    use serde_json::{Value, json};
    use tire::embedded::EmbeddedSolver;

    use super::*;

    /// Asserts that the bound is met and not far off a measured peak, MB.
    fn assert_bounds(changes: &[(&str, Value)], derivatives: &[&str], peak: f64) {
        let mut scene = Scene::default();
        let changed: Vec<(&str, &Value)> =
            changes.iter().map(|(path, value)| (*path, value)).collect();
        scene.set_all(&changed).expect("a scene");
        let readout = Readout {
            derivatives: derivatives.iter().map(|path| (*path).to_owned()).collect(),
            ..Readout::default()
        };
        let bytes = solve_memory_bytes(&scene, &readout, &EmbeddedSolver::default());
        let ratio = bytes as f64 / 1e6 / peak;
        assert!(
            (1.0..2.2).contains(&ratio),
            "{changes:?}: {ratio:.2} times {peak} MB"
        );
    }

    #[test]
    fn a_lone_solve_takes_no_more_than_was_said() {
        // Largest resident memory of `strainsite solve foot-tire`, bare and with three derivatives.
        for (level, peak, differentiated) in [
            ("draft", 25.7, 34.2),
            ("coarse", 62.2, 116.2),
            ("standard", 153.4, 307.1),
            ("reference", 373.6, 808.7),
        ] {
            let changes = [("model.level", json!(level))];
            assert_bounds(&changes, &[], peak);
            assert_bounds(&changes, &["geometry.wall_mm"], differentiated);
        }
    }

    #[test]
    fn a_number_that_breaks_the_symmetry_takes_a_larger_part() {
        let paths = [
            "ground.depths_mm[0]",
            "pressure.internal_mpa",
            "geometry.wall_mm",
        ];
        for (level, peak) in [("coarse", 224.8), ("reference", 1715.1)] {
            assert_bounds(&[("model.level", json!(level))], &paths, peak);
        }
    }

    #[test]
    fn a_wheel_that_leans_takes_half_of_the_tire() {
        let leaning = |level: &str| {
            [
                ("model.level", json!(level)),
                ("ground.camber_deg", json!(10)),
            ]
        };
        for (level, peak) in [
            ("draft", 31.3),
            ("coarse", 137.4),
            ("standard", 385.8),
            ("reference", 945.8),
        ] {
            assert_bounds(&leaning(level), &[], peak);
        }
        let uneven = ("ground.depths_mm", json!([1, 1, 1, 1, 1.1]));
        let changes = [leaning("coarse").as_slice(), &[uneven]].concat();
        assert_bounds(&changes, &[], 413.9);
    }

    #[test]
    fn a_larger_part_of_the_tire_takes_more() {
        let coarse = ("model.level", json!("coarse"));
        let friction = ("contact.friction", json!(0.6));
        let uneven = ("ground.depths_mm", json!([0.8, 1, 1.1, 1.2, 0.7]));
        assert_bounds(&[coarse.clone(), uneven.clone()], &[], 125.8);
        assert_bounds(&[coarse.clone(), uneven], &["pressure.internal_mpa"], 188.9);
        let dragged = |shift: Value| [coarse.clone(), friction.clone(), ("ground.shift_mm", shift)];
        assert_bounds(&dragged(json!([0.3, 0])), &[], 164.4);
        assert_bounds(&dragged(json!([0, 0.3])), &[], 155.3);
        assert_bounds(&dragged(json!([0.3, 0.3])), &[], 433.5);
        let film = |field: &'static str, value: f64| [coarse.clone(), (field, json!(value))];
        assert_bounds(&film("film.theta_deg", 0.0), &[], 66.9);
        assert_bounds(&film("film.theta_deg", 10.0), &[], 135.4);
        assert_bounds(&film("film.angle_deg", 30.0), &[], 321.7);
    }
}
