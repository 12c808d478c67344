//! Glued films of a table: what they are pressed by, and where what their transfer misses is added.

use crate::layout::solving::glued::angle_residual::AngleResidual;
use crate::layout::solving::glued::film_angles::{FilmLoad, FilmLoads, FilmTest, TurnedSignals};
use crate::response_table::solved_table::ResponseTable;
use crate::response_table::table_scenes::{Pressing, TableScenes};
use documents::signals::series::numbers_of_transfer;

/// Number of the load that is solved first.
const FIRST_LOAD: usize = 2;

/// Lists what so many kinds of film are pressed by on the tires of a table.
pub(crate) fn film_loads(scenes: &TableScenes, kinds: usize) -> FilmLoads {
    let settings = scenes.settings();
    let loads = settings.film_loads_n();
    let load = |load_n: &f64| FilmLoad {
        name: format!("{load_n} N"),
        bare: scenes.scene(&Pressing::undragged(*load_n)),
        tire: scenes.film_scene(*load_n),
    };
    let test = |(angle_deg, load_n)| FilmTest {
        angle_deg,
        pressing: load_n,
        tire: scenes.film_scene(load_n),
    };
    let tests = |kind| scenes.tested_films(kind).into_iter().map(test).collect();
    FilmLoads {
        level: settings.film_level.as_str().to_owned(),
        loads: loads.iter().map(load).collect(),
        first: FIRST_LOAD,
        of_transfer: numbers_of_transfer(&loads),
        tests: (0..kinds).map(tests).collect(),
    }
}

/// Pressings are loads, N.
impl TurnedSignals for ResponseTable {
    fn add(&mut self, kind: usize, missing: &AngleResidual) {
        self.add_undragged(kind, missing);
    }

    fn signal(&self, kind: usize, angle_deg: f64, load_n: f64) -> f64 {
        let weights = self.weights(self.depth_of_load_mm(load_n), [0.0; 2]);
        let film = self.film_nodes(std::iter::once((kind, angle_deg)));
        film.signal(0, &weights)
    }

    fn largest_signal(&self, kind: usize) -> f64 {
        self.largest_of_kind(kind)
    }
}
