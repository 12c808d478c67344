//! Settings of a table of responses: loads, shifts of the ground, and solves that only test it.

use fem_client::scene::Level;

/// Loads of the undragged ground. They are the cheap ones, a quarter of a tire each; two thirds as many left slopes over the depth off by 3.3 % where these leave 2.4 %.
const LOADS: usize = 36;
/// Loads grow with this power of their number: the depth is then about even, as a tire's force grows with the depth to the power of 4/3 to 3/2.
const LOAD_POWER: f64 = 1.4;
/// Every so-manyth load is dragged, too, and presses films beside the contact: half a tire or a whole one each, up to thirty times as dear on the coarse mesh.
const DEAR_EVERY: usize = 9;
/// The largest shift at a load grows with this power of the load, about as the depth does: ground that presses twice as deep slides twice as far before it slips.
const SHIFT_POWER: f64 = 0.75;
/// Largest shift at the largest load over the section's radius, with a coefficient of friction of one: three quarters of the pull at which the foot tire slides.
const SHIFT_OF_SECTION: f64 = 0.12;
/// Pairs of solves that test the table. The loads of a pair differ by this share, for slopes over the depth.
pub const PAIRS: usize = 10;
/// Half of that share.
pub(crate) const PAIR_SHARE: f64 = 0.05;

/// Solves that test each kind of glued film beside the contact.
pub(crate) const FILM_TESTS: usize = 5;

/// The loads and shifts of a table.
#[derive(Debug, Clone, PartialEq)]
pub struct TableSettings {
    /// The largest load, N.
    pub largest_load_n: f64,
    /// The largest shift at that load, mm; 0: the ground isn't dragged.
    pub largest_shift_mm: f64,
    /// Draws the solves that test the table.
    pub seed: u64,
    /// Mesh level of the bare tire.
    pub level: Level,
    /// Mesh level of the tire with a film glued on: where it is coarse, films beside the contact are off by a fifth.
    pub film_level: Level,
}

impl TableSettings {
    /// Chooses the settings for loads up to this one, N, on a section of this radius, mm, with this coefficient of friction, in a study of this level: the
    /// bare tire's strains are converged to 1 % on the coarse mesh, and dragged ones are dear.
    pub fn new(largest_load_n: f64, section_radius_mm: f64, friction: f64, level: Level) -> Self {
        Self {
            largest_load_n,
            largest_shift_mm: SHIFT_OF_SECTION * friction * section_radius_mm,
            seed: 1,
            level: level.min(Level::Coarse),
            film_level: level,
        }
    }

    /// Loads of the undragged ground, N, increasing.
    pub fn loads_n(&self) -> Vec<f64> {
        let share = |k: usize| (k as f64 / LOADS as f64).powf(LOAD_POWER);
        (1..=LOADS)
            .map(|k| self.largest_load_n * share(k))
            .collect()
    }

    /// Returns which of the loads are dragged.
    pub fn dragged(&self) -> impl Iterator<Item = usize> {
        let is_dragged = self.largest_shift_mm > 0.0;
        dear().filter(move |_| is_dragged)
    }

    /// Loads, N, of which glued films are solved around the wheel; increasing.
    pub(crate) fn film_loads_n(&self) -> Vec<f64> {
        let loads = self.loads_n();
        dear().map(|load| loads[load]).collect()
    }

    /// The shift at a load, N, that is one share, mm.
    pub fn shift_mm(&self, load_n: f64) -> f64 {
        let share = (load_n / self.largest_load_n).max(0.0);
        self.largest_shift_mm * share.powf(SHIFT_POWER)
    }
}

fn dear() -> impl Iterator<Item = usize> {
    (1..=LOADS).filter(|k| k % DEAR_EVERY == 0).map(|k| k - 1)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn loads_end_at_the_largest_and_four_are_dragged() {
        let settings = TableSettings::new(30.0, 12.5, 0.5, Level::Coarse);
        let loads = settings.loads_n();
        assert_eq!((loads.len(), loads[35]), (36, 30.0));
        assert!(loads.windows(2).all(|pair| pair[0] < pair[1]));
        assert_eq!(settings.dragged().collect::<Vec<_>>(), [8, 17, 26, 35]);
        assert_eq!(settings.shift_mm(30.0), 0.75);
        assert!(settings.shift_mm(15.0) < 0.5 && settings.shift_mm(0.0) == 0.0);
    }

    #[test]
    fn ground_without_friction_is_not_dragged() {
        let smooth = TableSettings::new(30.0, 12.5, 0.0, Level::Coarse);
        assert_eq!(smooth.dragged().count(), 0);
        assert_eq!(smooth.film_loads_n().len(), 4);
    }
}
