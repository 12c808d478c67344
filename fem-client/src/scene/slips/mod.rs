//! Values that are allowed, and that the physics makes unlikely: a number typed in another unit, or by another convention.
//!
//! - `rubber_constants`: moduli, compressibility, Ogden's weights
//! - `filled_tire`: pressure and size
//! - `film_constants`: what a film is made of
//! - `slip`: what is said of one
//!
//! Nobody is refused for one: a note says what is unlikely, and what may have been meant.

mod filled_tire;
mod film_constants;
mod rubber_constants;
mod slip;

pub use slip::{Slip, noting};

use super::Scene;

impl Scene {
    /// Returns every value that is unlikely, with what may have been meant.
    pub fn slips(&self) -> Vec<Slip> {
        let film = self.film.iter().flat_map(|film| film.slips("film"));
        let rubber = rubber_constants::slips(&self.material);
        let tire = filled_tire::slips(self);
        rubber.into_iter().chain(tire).chain(film).collect()
    }
}
