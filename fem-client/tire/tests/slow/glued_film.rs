//! Effect of a film on the tire and on the strain under it, and what it gives.

use std::sync::atomic::AtomicBool;

use fem_client::scene::{Film, FilmLayer, Glue, Level, Scene};
use fem_client::solver::{FilmCondition, FilmSignal, Readout, Response, SolveRequest, Solver};
use tire::embedded::EmbeddedSolver;

static RUNNING: AtomicBool = AtomicBool::new(false);

fn solve(level: Level, depths: [f64; 5], film: Option<Film>) -> Response {
    let mut scene = Scene::preset("foot-tire").expect("the preset ships");
    scene.model.level = level;
    scene.ground.depths_mm = depths.to_vec();
    scene.film = film;
    read(&scene, &Readout::default())
}

fn read(scene: &Scene, readout: &Readout) -> Response {
    let request = SolveRequest {
        scene,
        readout,
        start: None,
        watch: &RUNNING,
    };
    EmbeddedSolver::default()
        .solve(&request)
        .expect("an equilibrium")
        .response
}

fn film(modulus_mpa: f64) -> Film {
    Film::of_layer(FilmLayer {
        modulus_mpa,
        ..FilmLayer::default()
    })
}

/// 28 um of PVDF.
fn thin() -> Film {
    Film::of_layer(FilmLayer {
        thickness_mm: 0.028,
        ..FilmLayer::default()
    })
}

fn signal(response: &Response) -> FilmSignal {
    let film = response.film.expect("a film");
    film.signal
}

const FLAT: [f64; 5] = [1.0; 5];

/// Newton stops at a relative residual of 1e-8; the strains follow the forces with a factor of order 100 at most.
const SOLVER_TOLERANCE: f64 = 1e-6;

#[test]
fn a_film_without_stiffness_changes_nothing_and_reads_the_bare_wall() {
    let soft = Film {
        phi_deg: 30.0,
        angle_deg: 20.0,
        ..film(1e-6)
    };
    let mut scene = Scene::preset("foot-tire").expect("the preset ships");
    scene.model.level = Level::Draft;
    scene.film = Some(soft.clone());
    let readout = Readout {
        films: vec![soft],
        ..Readout::default()
    };
    // The film's scene is meshed for it: what follows the wall is read on the same mesh.
    let answer = read(&scene, &readout);
    let (glued, follows) = (signal(&answer), answer.films[0]);
    for (a, b) in [
        (glued.mean_strain_1, follows.mean_strain_1),
        (glued.mean_strain_2, follows.mean_strain_2),
        (
            glued.curvature_change_1_per_mm,
            follows.curvature_change_1_per_mm,
        ),
    ] {
        assert!((a - b).abs() < SOLVER_TOLERANCE, "{glued:?} {follows:?}");
    }
    assert!(glued.charge_nc.abs() < 1e-3);
    scene.film.as_mut().expect("a film").layers[0].modulus_mpa = 1e-5;
    let stiffer = read(&scene, &Readout::default());
    assert!((stiffer.reaction_n / answer.reaction_n - 1.0).abs() < SOLVER_TOLERANCE);
    for (a, b) in stiffer.locations.iter().zip(&answer.locations) {
        assert!((a.strain.x - b.strain.x).abs() < SOLVER_TOLERANCE);
        assert!((a.strain.y - b.strain.y).abs() < SOLVER_TOLERANCE);
    }
}

#[test]
fn a_film_is_the_same_on_the_quarter_and_on_the_half() {
    let quarter = solve(Level::Draft, FLAT, Some(film(2500.0)));
    // A difference of 1e-12 mm left to right asks for the half model and changes nothing else.
    let half = solve(
        Level::Draft,
        [1.0, 1.0, 1.0, 1.0, 1.0 + 1e-12],
        Some(film(2500.0)),
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
    same_signal(&half, &quarter);
}

/// Charges are differences of tensions, ten times smaller than they: their own tolerance is that of the tensions.
fn same_signal(one: &Response, other: &Response) {
    let [a, b] = [one, other].map(signal);
    let scale = b.open_circuit_v.abs().max(1.0);
    assert!(
        (a.open_circuit_v - b.open_circuit_v).abs() < SOLVER_TOLERANCE * scale,
        "{a:?} {b:?}"
    );
    assert!((a.capacitance_pf / b.capacitance_pf - 1.0).abs() < 1e-9);
}

#[test]
fn a_film_turned_or_moved_reads_as_its_mirror_image() {
    let at = |theta_deg, phi_deg, angle_deg| Film {
        theta_deg,
        phi_deg,
        angle_deg,
        ..thin()
    };
    let pairs = [
        // Before and behind the contact; on the left and on the right; across the middle plane, where the whole tire is meshed.
        (at(7.0, 45.0, 30.0), at(-7.0, 45.0, -30.0), "3d-half"),
        (at(7.0, -45.0, -30.0), at(7.0, 45.0, 30.0), "3d-half"),
        (at(5.0, 0.0, 90.0), at(-5.0, 0.0, 90.0), "3d-half"),
        (at(0.0, 3.0, 20.0), at(0.0, -3.0, -20.0), "3d"),
    ];
    for (film, image, dimension) in pairs {
        let [one, other] = [film, image].map(|film| solve(Level::Draft, FLAT, Some(film)));
        assert_eq!(one.model.dimension, dimension);
        same_signal(&one, &other);
    }
}

/// Half a turn is no turn, and a square film crosswise is the one lengthwise with its axes exchanged.
#[test]
fn a_quarter_turn_exchanges_the_axes() {
    let turned = |angle_deg| {
        let film = Film {
            angle_deg,
            ..thin()
        };
        signal(&solve(Level::Draft, FLAT, Some(film)))
    };
    let [none, quarter, half] = [0.0, 90.0, 180.0].map(turned);
    assert_eq!(none, half);
    assert_eq!(
        none.mean_tension_1_n_per_mm,
        quarter.mean_tension_2_n_per_mm
    );
    assert_eq!(
        none.mean_tension_2_n_per_mm,
        quarter.mean_tension_1_n_per_mm
    );
}

/// Nearly twice as stiff, nearly the same pull; and the standard mesh is within 5 % of the larger tension of the reference's.
#[test]
fn a_stiff_film_is_pulled_by_what_the_wall_gives_on_both_meshes() {
    let of = |level, length_mm, width_mm, film: Film| {
        let film = Film {
            length_mm,
            width_mm,
            ..film
        };
        signal(&solve(level, FLAT, Some(film)))
    };
    for (length, width) in [(5.0, 5.0), (30.0, 12.0)] {
        let [standard, reference] =
            [Level::Standard, Level::Reference].map(|level| of(level, length, width, thin()));
        let [a, b] =
            [standard, reference].map(|s| [s.mean_tension_1_n_per_mm, s.mean_tension_2_n_per_mm]);
        let larger = b[0].abs().max(b[1].abs());
        for k in 0..2 {
            assert!((a[k] - b[k]).abs() < 0.05 * larger, "{a:?} {b:?}");
        }
        if (length, width) == (5.0, 5.0) {
            let thick = of(Level::Standard, length, width, Film::default());
            let share = thick.mean_tension_2_n_per_mm / standard.mean_tension_2_n_per_mm;
            assert!((share - 1.0).abs() < 0.05, "{share}");
            assert!((thick.open_circuit_v / standard.open_circuit_v - 1.0).abs() < 0.05);
            // Half as thin, half the strain.
            let strains = thick.mean_strain_2 / standard.mean_strain_2;
            assert!((strains - 0.028 / 0.05).abs() < 0.05, "{strains}");
            // Seen on both meshes, and with nodes shared by film and wall where film and mesh end on one line.
            assert!(
                (reference.open_circuit_v / 13.4 - 1.0).abs() < 0.02,
                "{reference:?}"
            );
        }
    }
}

/// Softer glue passes on less, stiffer glue at last as much as none.
#[test]
fn glue_lowers_the_tension() {
    let on = |shear_modulus_mpa| {
        let film = Film {
            glue: Some(Glue {
                shear_modulus_mpa,
                ..Glue::default()
            }),
            ..thin()
        };
        signal(&solve(Level::Coarse, FLAT, Some(film))).mean_tension_2_n_per_mm
    };
    let without = signal(&solve(Level::Coarse, FLAT, Some(thin()))).mean_tension_2_n_per_mm;
    let [soft, usual, hard] = [0.01, 0.5, 500.0].map(on);
    assert!(0.0 < soft && soft < 0.3 * usual, "{soft} {usual}");
    assert!(usual < 0.9 * without && (hard / without - 1.0).abs() < 0.01);
}

/// A membrane that can't bend folds under this and finds no equilibrium.
#[test]
fn a_long_film_in_compression_has_an_equilibrium_and_says_that_it_would_fold() {
    let long = Film {
        length_mm: 30.0,
        width_mm: 12.0,
        ..Film::of_layer(FilmLayer {
            thickness_mm: 0.11,
            ..FilmLayer::default()
        })
    };
    let signal = signal(&solve(Level::Standard, FLAT, Some(long)));
    assert!(signal.mean_tension_1_n_per_mm < 0.0);
    assert_eq!(signal.state, FilmCondition::Wrinkled);
}

/// A film on polyester reads how the crown is flattened: other side up, other sign.
#[test]
fn a_laminate_reads_curvature_by_the_side_that_is_up() {
    let layer = |thickness_mm, piezo| FilmLayer {
        thickness_mm,
        piezo,
        ..FilmLayer::default()
    };
    let [pvdf, polyester] = [layer(0.028, true), layer(0.125, false)];
    let of = |layers| {
        let film = Film {
            layers,
            angle_deg: 90.0,
            ..Film::default()
        };
        signal(&solve(Level::Standard, FLAT, Some(film)))
    };
    let (inside, outside) = (of(vec![polyester, pvdf]), of(vec![pvdf, polyester]));
    let [a, b] = [&inside, &outside].map(|signal| signal.mean_tension_1_n_per_mm);
    // The same stiffness, summed in another order.
    assert!((a / b - 1.0).abs() < 1e-9, "{a} {b}");
    // Bare, the crown is flattened by 0.06 / mm; what lies further in is stretched by that.
    assert!(inside.curvature_change_1_per_mm < 0.0);
    assert!(inside.charge_nc > 0.0 && outside.charge_nc < 0.0);
    let bending = 0.5 * (inside.charge_nc - outside.charge_nc);
    assert!(
        bending > 2.0 * (inside.charge_nc - bending).abs(),
        "{inside:?} {outside:?}"
    );
}

/// A PVDF film resists 40 times as much as the rubber of the wall under it (modulus times thickness), so that it hardly strains
/// with it: what a film feels isn't the strain of the bare surface.
#[test]
fn the_stiffer_the_film_the_less_it_strains() {
    let strain_y = |response: &Response| response.locations[2].strain.y;
    let bare = solve(Level::Standard, FLAT, None);
    let mut before = strain_y(&bare);
    for (modulus, most) in [(1.0, 1.0), (100.0, 0.3), (2500.0, 0.02)] {
        let with = solve(Level::Standard, FLAT, Some(film(modulus)));
        assert!(strain_y(&with).abs() < before, "{modulus}");
        // Shares of the bare strain, set after seeing 0.95, 0.21 and less than 0.01.
        assert!(strain_y(&with).abs() < most * strain_y(&bare), "{modulus}");
        before = strain_y(&with).abs();
    }
}
