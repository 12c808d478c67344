//! Time that a glued film adds to a solve: each level bare and with a film, in turn, medians of a few rounds.

use std::sync::atomic::AtomicBool;
use std::time::Instant;

use fem_client::scene::{Film, FilmLayer, Level, Scene};
use fem_client::solver::{Readout, SolveRequest, Solver};
use tire::embedded::EmbeddedSolver;

const ROUNDS: usize = 5;

fn main() {
    let thin = Film::of_layer(FilmLayer {
        thickness_mm: 0.028,
        ..FilmLayer::default()
    });
    let films = [
        ("5 x 5 mm at P3", thin.clone()),
        (
            "10 x 10 mm at P3",
            Film {
                length_mm: 10.0,
                width_mm: 10.0,
                ..thin.clone()
            },
        ),
        (
            "30 x 12 mm at P3",
            Film {
                length_mm: 30.0,
                width_mm: 12.0,
                ..thin.clone()
            },
        ),
        (
            "5 x 5 mm on the shoulder",
            Film {
                phi_deg: 45.0,
                ..thin
            },
        ),
    ];
    println!(
        "| level | film | bare, s | with the film, s | ratio | iterations, bare and with it |"
    );
    println!("|---|---|---|---|---|---|");
    for level in [Level::Coarse, Level::Standard, Level::Reference] {
        for (name, film) in &films {
            let rounds: Vec<[(f64, usize); 2]> = (0..ROUNDS)
                .map(|_| [None, Some(film.clone())].map(|film| solve(level, film)))
                .collect();
            let median = |k: usize| {
                let mut times: Vec<f64> = rounds.iter().map(|round| round[k].0).collect();
                times.sort_by(f64::total_cmp);
                times[ROUNDS / 2]
            };
            let [bare, with] = [0, 1].map(median);
            println!(
                "| {} | {name} | {bare:.2} | {with:.2} | {:.2} | {}, {} |",
                level.as_str(),
                with / bare,
                rounds[0][0].1,
                rounds[0][1].1
            );
        }
    }
}

/// Seconds and Newton iterations of a solve at 1 mm.
fn solve(level: Level, film: Option<Film>) -> (f64, usize) {
    let mut scene = Scene::preset("foot-tire").expect("the preset ships");
    scene.model.level = level;
    scene.film = film;
    let (readout, stop) = (Readout::default(), AtomicBool::new(false));
    let request = SolveRequest {
        scene: &scene,
        readout: &readout,
        start: None,
        watch: &stop,
    };
    let begun = Instant::now();
    let solved = EmbeddedSolver::default()
        .solve(&request)
        .expect("an equilibrium");
    (
        begun.elapsed().as_secs_f64(),
        solved.response.newton_iterations,
    )
}
