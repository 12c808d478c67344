//! Number of points that stand for a film: means over films of the foot tire at 1 mm against those by many points.

use std::sync::atomic::AtomicBool;

use documents::layouts::film_extent::{FilmExtent, FilmPoint};
use fem_client::scene::{Level, Scene};
use fem_client::solver::direction::Direction;
use fem_client::solver::{Readout, Response, Ring, RingLine, SolveRequest, Solver};
use layouts::field::hermite::Turn;
use placement::layout::solving::layout_scenes::FINE_DEG;
use tire::embedded::EmbeddedSolver;

/// Points that count as all.
const MANY: [usize; 2] = [48, 36];
/// Fewer points along length and width, for the table.
const COUNTS: [[usize; 2]; 6] = [[1, 1], [3, 3], [5, 3], [7, 5], [13, 7], [33, 8]];

/// Sizes, and section angles in degrees.
const FILMS: [([f64; 2], f64); 5] = [
    ([25.0, 10.0], 0.0),
    ([25.0, 10.0], 15.0),
    ([25.0, 10.0], 45.0),
    ([10.0, 5.0], 0.0),
    ([10.0, 5.0], 45.0),
];

struct Film {
    name: String,
    extent: FilmExtent,
    direction: Direction,
}

/// Returns those of the table, where they fit.
fn films(scene: &Scene) -> Vec<Film> {
    let mut films = Vec::new();
    for (size, phi) in FILMS {
        for (direction, angle) in [(Direction::X, 0.0), (Direction::Y, 90.0)] {
            films.push(Film {
                name: format!("{} x {} mm, {direction} at {phi} deg", size[0], size[1]),
                extent: FilmExtent::on(&scene.geometry, size, phi, angle),
                direction,
            });
        }
    }
    films.retain(|film| film.extent.fits(101.0));
    films
}

/// The tire at its means, with a line wherever one of these films has a point.
fn response(scene: &Scene, films: &[Film]) -> Response {
    let mut rings: Vec<RingLine> = Vec::new();
    for film in films {
        let all = COUNTS.into_iter().chain([MANY]);
        let all = all.flat_map(|counts| film.extent.points_by(counts));
        for point in all.chain(film.extent.points()) {
            if rings
                .iter()
                .all(|ring| ring.section_deg != point.section_deg)
            {
                rings.push(RingLine::at(point.section_deg));
            }
        }
    }
    let readout = Readout {
        rings,
        fine_deg: Some(FINE_DEG),
        ..Readout::default()
    };
    let request = SolveRequest {
        scene,
        readout: &readout,
        start: None,
        watch: &AtomicBool::new(false),
    };
    let solved = EmbeddedSolver::default().solve(&request);
    solved.expect("an equilibrium").response
}

fn mean(response: &Response, points: &[FilmPoint], direction: Direction) -> Vec<f64> {
    let mut mean = vec![0.0; 360];
    for point in points {
        let ring = |ring: &&Ring| ring.section_deg == point.section_deg;
        let ring = response.rings.iter().find(ring).expect("was read");
        let turn = Turn::new(ring.strain[direction].clone());
        for (sum, degree) in mean.iter_mut().zip(-180..180) {
            *sum += point.share * turn.at(f64::from(degree) + point.wheel_deg);
        }
    }
    mean
}

/// The largest error around the wheel is 0.7 % of the largest signal of films of 25 x 10 mm, 1.04 % of 10 x 5 mm: strains have kinks where bricks meet, which any rule of points feels.
#[test]
fn the_points_of_a_film_give_its_mean_within_a_percent() {
    let mut scene = Scene::preset("foot-tire").expect("ships");
    scene.model.level = Level::Standard;
    let films = films(&scene);
    let response = response(&scene, &films);
    let heads = COUNTS.map(|[a, b]| format!("{a} x {b}")).join(" | ");
    println!("| film | largest | {heads} | as many as there are |");
    for film in &films {
        let of = |points: &[FilmPoint]| mean(&response, points, film.direction);
        let many = of(&film.extent.points_by(MANY));
        let largest = many
            .iter()
            .fold(0.0, |largest: f64, x| largest.max(x.abs()));
        let off = |points: &[FilmPoint]| {
            let pairs = of(points).into_iter().zip(&many);
            100.0 * pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max) / largest
        };
        let cells = COUNTS.map(|counts| format!("{:.2}", off(&film.extent.points_by(counts))));
        let chosen = film.extent.points();
        let error = off(&chosen);
        println!(
            "| {} | {largest:.4} | {} | {error:.2} ({}) |",
            film.name,
            cells.join(" | "),
            chosen.len()
        );
        assert!(error < 1.2, "{}: {error} %", film.name);
    }
}
