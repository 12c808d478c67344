//! What a film does to the tire and to the strain under it.

use std::sync::atomic::AtomicBool;

use fem_client::scene::{Film, Level, Scene};
use fem_client::solver::{FilmSignal, Readout, Response, SolveRequest, Solver};
use tire::embedded::EmbeddedSolver;

static RUNNING: AtomicBool = AtomicBool::new(false);

fn solve(level: Level, depths: [f64; 5], film: Option<Film>) -> Response {
    let mut scene = Scene::preset("foot-tire").expect("the preset ships");
    scene.model.level = level;
    scene.ground.depths_mm = depths.to_vec();
    scene.film = film;
    let readout = Readout::default();
    let request = SolveRequest {
        scene: &scene,
        readout: &readout,
        start: None,
        stop: &RUNNING,
    };
    EmbeddedSolver::default()
        .solve(&request)
        .expect("an equilibrium")
        .response
}

fn film(modulus_mpa: f64) -> Option<Film> {
    Some(Film {
        modulus_mpa,
        ..Film::default()
    })
}

const FLAT: [f64; 5] = [1.0; 5];

/// Newton stops at a relative residual of 1e-8; the strains follow the forces with a factor of order 100 at most.
const SOLVER_TOLERANCE: f64 = 1e-6;

#[test]
fn a_film_without_stiffness_changes_nothing() {
    let bare = solve(Level::Draft, FLAT, None);
    assert!(bare.film.is_none());
    let soft = solve(Level::Draft, FLAT, film(1e-6));
    assert!((soft.reaction_n / bare.reaction_n - 1.0).abs() < SOLVER_TOLERANCE);
    for (a, b) in soft.locations.iter().zip(&bare.locations) {
        assert!((a.strain.x - b.strain.x).abs() < SOLVER_TOLERANCE);
        assert!((a.strain.y - b.strain.y).abs() < SOLVER_TOLERANCE);
    }
    // It just follows: its stretch is that of the surface, P3's among it.
    let state = soft.film.expect("a film");
    let centre = &soft.locations[2];
    let stretch_y = (1.0 + centre.strain.y) * soft.inflated.crown_stretch.y;
    let error = centre.error.expect("an estimate").strain.y;
    assert!(state.stretch.y.min < stretch_y + error && stretch_y - error < state.stretch.y.max);
    assert!(state.stretch.y.max < 1.2 && state.stretch.x.min > 1.0);
}

#[test]
fn a_film_is_the_same_on_the_quarter_and_on_the_half() {
    let quarter = solve(Level::Draft, FLAT, film(2500.0));
    // A difference of 1e-12 mm left to right asks for the half model and changes nothing else.
    let half = solve(
        Level::Draft,
        [1.0, 1.0, 1.0, 1.0, 1.0 + 1e-12],
        film(2500.0),
    );
    assert_eq!(
        (
            quarter.model.dimension.as_str(),
            half.model.dimension.as_str()
        ),
        ("3d-quarter", "3d-half")
    );
    assert!((half.reaction_n / quarter.reaction_n - 1.0).abs() < SOLVER_TOLERANCE);
    for (a, b) in half.locations.iter().zip(&quarter.locations) {
        assert!((a.strain.y - b.strain.y).abs() < SOLVER_TOLERANCE);
    }
    let [a, b] = [&half, &quarter].map(signal);
    assert!(
        (a.charge_nc / b.charge_nc - 1.0).abs() < 1e-4,
        "{a:?} {b:?}"
    );
    assert!((a.capacitance_pf / b.capacitance_pf - 1.0).abs() < 1e-12);
}

fn signal(response: &Response) -> FilmSignal {
    let film = response.film.expect("a film");
    film.signal.expect("what the contact adds")
}

/// Without stiffness the film reads the bare surface, and has neither tension nor charge.
#[test]
fn a_film_without_stiffness_reads_the_bare_surface() {
    let bare = solve(Level::Draft, FLAT, film(1e-6));
    let softer = solve(Level::Draft, FLAT, film(1e-5));
    let [bare_means, softer_means] = [&bare, &softer].map(signal);
    let change = (bare_means.mean_strain_2 - softer_means.mean_strain_2).abs();
    assert!(change < SOLVER_TOLERANCE, "{change}");
    assert!(bare_means.mean_tension_2_n_per_mm.abs() < 1e-6 && bare_means.charge_nc.abs() < 1e-3);
    // The crown's strain falls away from the centre: the mean over 5 x 5 mm is two thirds of it, the least at the corners.
    let centre = bare.locations[2].strain.y;
    assert!(
        (0.5..1.0).contains(&(bare_means.mean_strain_2 / centre)),
        "{bare_means:?}"
    );
}

/// Figures of an independent reading of the program's own reference mesh: 0.150 N/mm across, 0.070 along, 19 V.
#[test]
fn a_stiff_film_is_pulled_by_what_the_wall_gives() {
    let film_of = |thickness_mm| {
        let film = Film {
            thickness_mm,
            ..Film::default()
        };
        signal(&solve(Level::Reference, FLAT, Some(film)))
    };
    let [thin, thick] = [0.028, 0.05].map(film_of);
    assert!(
        (thin.mean_tension_2_n_per_mm / 0.150 - 1.0).abs() < 0.05,
        "{thin:?}"
    );
    assert!(
        (thin.mean_tension_1_n_per_mm / 0.070 - 1.0).abs() < 0.05,
        "{thin:?}"
    );
    assert!((thin.open_circuit_v / 19.0 - 1.0).abs() < 0.1, "{thin:?}");
    // Nearly twice as stiff, nearly the same pull.
    assert!((thick.mean_tension_2_n_per_mm / thin.mean_tension_2_n_per_mm - 1.0).abs() < 0.05);
    assert!((thick.open_circuit_v / thin.open_circuit_v - 1.0).abs() < 0.05);
    assert!((thick.mean_strain_2 / thin.mean_strain_2 - 0.028 / 0.05).abs() < 0.05);
}

/// A PVDF film resists 40 times as much as the rubber of the wall under it (modulus times thickness), so that it hardly strains
/// with it: what a film feels isn't the strain of the bare surface.
#[test]
fn the_stiffer_the_film_the_less_it_strains() {
    let strain_y = |response: &Response| response.locations[2].strain.y;
    let bare = solve(Level::Standard, FLAT, None);
    let mut before = strain_y(&bare);
    for (modulus, most) in [(1.0, 1.0), (100.0, 0.3), (2500.0, 0.02)] {
        let with = solve(Level::Standard, FLAT, film(modulus));
        let state = with.film.expect("a film");
        println!(
            "{modulus} MPa: strain y at P3 {:.5} instead of {:.5}, x {:.5} instead of {:.5}, reaction {:.3} N instead of {:.3}, P4 y {:.5}, \
             largest film tension {:.3} N/mm",
            strain_y(&with),
            strain_y(&bare),
            with.locations[2].strain.x,
            bare.locations[2].strain.x,
            with.reaction_n,
            bare.reaction_n,
            with.locations[3].strain.y,
            state.tension_n_per_mm.y.max,
        );
        assert!(strain_y(&with).abs() < before, "{modulus}");
        // Shares of the bare strain, set after seeing 0.95, 0.21 and less than 0.01.
        assert!(strain_y(&with).abs() < most * strain_y(&bare), "{modulus}");
        before = strain_y(&with).abs();
    }
}
