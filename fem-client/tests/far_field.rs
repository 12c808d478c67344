//! The tire's far part taken as linear, against the whole tire.

use std::sync::atomic::AtomicBool;

use fem_client::embedded::EmbeddedSolver;
use fem_client::far_field::{About, FarField};
use fem_client::scene::{Level, Scene};
use fem_client::solver::{Readout, SolveRequest, Solved, Solver, StartState};

static RUNNING: AtomicBool = AtomicBool::new(false);

fn scene(depths: [f64; 5]) -> Scene {
    let mut scene = Scene::preset("foot-tire").expect("the preset ships");
    scene.model.level = Level::Draft;
    scene.ground.depths_mm = depths.to_vec();
    scene
}

fn solve(solver: &EmbeddedSolver, depths: [f64; 5], start: Option<&StartState>) -> Solved {
    let readout = Readout::default();
    let request = SolveRequest {
        scene: &scene(depths),
        readout: &readout,
        start,
        stop: &RUNNING,
    };
    solver.solve(&request).expect("an equilibrium")
}

fn linear(beyond_deg: f64, about: About) -> EmbeddedSolver {
    EmbeddedSolver::default().with_far_field(FarField::Linear { beyond_deg, about })
}

/// Largest difference of the signals at P1 to P5 where the depth at one station is changed by this much, mm.
fn error(solver: &EmbeddedSolver, station: usize, shift: f64) -> f64 {
    let cut_point = solve(solver, [1.0; 5], None).state;
    let mut depths = [1.0; 5];
    depths[station] += shift;
    let found = solve(solver, depths, Some(&cut_point)).response;
    let exact = solve(&EmbeddedSolver::default(), depths, Some(&cut_point)).response;
    let pairs = found.locations.iter().zip(&exact.locations);
    let differences = pairs.flat_map(|(a, b)| [a.strain_x - b.strain_x, a.strain_y - b.strain_y]);
    differences.map(f64::abs).fold(0.0, f64::max)
}

#[test]
fn linear_about_the_cut_point_errs_by_the_square_of_the_distance() {
    // P3 is solved on a quarter of the tire, P2 on a half.
    for station in [1, 2] {
        let solver = linear(18.0, About::Start);
        let [far, near] = [0.4, 0.2].map(|shift| error(&solver, station, shift));
        // Contact opens and closes on the way, so that the order is only about two.
        assert!(far < 1e-5, "{far:e}");
        assert!((2.5..6.5).contains(&(far / near)), "{far:e} {near:e}");
    }
}

#[test]
fn the_further_the_border_the_smaller_the_error() {
    let errors = [18.0, 30.0, 50.0].map(|angle| error(&linear(angle, About::Start), 2, 0.4));
    assert!(
        errors[0] > 2.0 * errors[1] && errors[1] > 2.0 * errors[2],
        "{errors:?}"
    );
    let inflated = error(&linear(18.0, About::Inflated), 2, 0.4);
    assert!(inflated > errors[0], "{inflated:e} {errors:?}");
}

#[test]
fn a_far_part_on_the_ground_is_solved_like_the_rest() {
    // At 1 mm the tire touches the ground up to 11 degrees from the contact centre.
    assert_eq!(error(&linear(3.0, About::Start), 2, 0.2), 0.0);
}
