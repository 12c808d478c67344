//! The scenes of a table: flat ground at every load, dragged at some, and where it is only tested.

use fem_client::scene::Scene;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};

use crate::layout::solving::glued::film_angles::FARTHEST_TEST_DEG;
use crate::response_table::drag_basis::{DRAGS, SHARES};
use crate::response_table::table_settings::{FILM_TESTS, PAIR_SHARE, PAIRS, TableSettings};
use documents::rig::rig_settings::TireVariant;

/// The least load at which a table is tested, over the largest.
const LEAST_TESTED: f64 = 0.1;
/// Tested shifts stay within this share of the largest along and across together.
const FARTHEST_TESTED: f64 = 0.95;

/// Pressing of the ground, and how far it is dragged.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pressing {
    /// Force, N; the ground keeps it while it is dragged.
    pub load_n: f64,
    /// Shift along the wheel and across it, as shares of the largest at this load.
    pub shares: [f64; 2],
}

impl Pressing {
    /// Presses with ground that isn't dragged.
    pub fn undragged(load_n: f64) -> Self {
        Self {
            load_n,
            shares: [0.0; 2],
        }
    }
}

/// All that is solved for a table.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct TableScenes {
    /// The bare tire.
    tire: Scene,
    settings: TableSettings,
    /// Whether other solves test the table.
    tested: bool,
}

impl TableScenes {
    /// Lists the scenes of a tire: a study's scene at its means.
    pub fn new(means: &Scene, settings: TableSettings) -> Self {
        let mut tire = means.clone();
        tire.film = None;
        tire.model.level = settings.level;
        tire.ground.depths_mm.clear();
        Self {
            tire,
            settings,
            tested: true,
        }
    }

    /// Lists the scenes of another tire, whose table isn't tested.
    pub(crate) fn untested(&self, variant: &TireVariant) -> Self {
        let mut other = Self {
            tested: false,
            ..self.clone()
        };
        if let Some(level) = variant.level {
            (other.settings.level, other.settings.film_level) = (level, level);
            other.tire.model.level = level;
        }
        other.tire.geometry.wall_mm *= variant.wall_factor;
        other.tire.pressure.internal_mpa *= variant.pressure_factor;
        other.tire.contact.friction *= variant.friction_factor;
        other.settings.largest_shift_mm *= variant.friction_factor;
        other
    }

    /// Returns what was asked for.
    pub fn settings(&self) -> &TableSettings {
        &self.settings
    }

    /// Undragged ground, a load in the middle first: all others start from its equilibrium.
    pub fn undragged(&self) -> Vec<Pressing> {
        let loads = self.settings.loads_n().into_iter();
        let mut pressings: Vec<Pressing> = loads.map(Pressing::undragged).collect();
        let middle = pressings.len() / 2;
        pressings.swap(0, middle);
        pressings
    }

    /// Dragged ground, by load and drag, and then the pairs that test the table.
    pub fn dragged(&self) -> Vec<Pressing> {
        let loads = self.settings.loads_n();
        let of_load = |load: usize| {
            let load_n = loads[load];
            DRAGS.iter().map(move |drag| {
                let share = |axis: usize| match drag[axis] {
                    0 => 0.0,
                    node => SHARES[node - 1],
                };
                Pressing {
                    load_n,
                    shares: [share(0), share(1)],
                }
            })
        };
        self.settings.dragged().flat_map(of_load).collect()
    }

    /// Pairs of pressings that differ by their load alone, drawn by the seed: no node of the table.
    pub fn tested(&self) -> Vec<[Pressing; 2]> {
        let mut even = self.draws(0);
        let is_dragged = self.settings.dragged().next().is_some();
        let pair = |_| {
            let share = LEAST_TESTED + (1.0 - LEAST_TESTED - PAIR_SHARE) * even();
            let (turn, reach) = (std::f64::consts::TAU * even(), FARTHEST_TESTED * even());
            let shares = match is_dragged {
                true => [reach * turn.cos(), reach * turn.sin()],
                false => [0.0; 2],
            };
            [-PAIR_SHARE, PAIR_SHARE].map(|beside| Pressing {
                load_n: self.settings.largest_load_n * share * (1.0 + beside),
                shares,
            })
        };
        let pairs = if self.tested { PAIRS } else { 0 };
        (0..pairs).map(pair).collect()
    }

    /// Wheel angles from the contact, degrees, and loads, N, at which a kind of glued film is tested.
    pub(crate) fn tested_films(&self, kind: usize) -> Vec<(f64, f64)> {
        let mut even = self.draws(1 + kind as u64);
        let count = if self.tested { FILM_TESTS } else { 0 };
        let film = |_| {
            let theta_deg = FARTHEST_TEST_DEG * (2.0 * even() - 1.0);
            let share = LEAST_TESTED + (1.0 - LEAST_TESTED) * even();
            (theta_deg, self.settings.largest_load_n * share)
        };
        (0..count).map(film).collect()
    }

    /// Even draws from 0 to 1 by the seed, independent for each stream.
    fn draws(&self, stream: u64) -> impl FnMut() -> f64 {
        let mut rng = ChaCha8Rng::seed_from_u64(self.settings.seed);
        rng.set_stream(stream);
        move || (rng.next_u64() >> 11) as f64 / (1u64 << 53) as f64
    }

    /// Whether a tire can be asked for all that.
    ///
    /// # Errors
    /// What can't be asked for.
    pub fn check(&self) -> Result<(), String> {
        let load_n = self.settings.largest_load_n;
        if load_n <= 0.0 {
            return Err("The rig never presses: gait.load_n has no load above zero.".to_owned());
        }
        let farthest = Pressing {
            load_n,
            shares: [1.0; 2],
        };
        let scene = self.scene(&farthest);
        match Scene::from_json(&scene.canonical_json()) {
            Ok(_) => Ok(()),
            Err(faults) => {
                let faults: Vec<String> = faults.iter().map(ToString::to_string).collect();
                Err(format!(
                    "This tire can't be pressed by {load_n} N as the rig asks: {}",
                    faults.join("; ")
                ))
            }
        }
    }

    /// The tire that films are glued on, pressed by a load, N.
    pub(crate) fn film_scene(&self, load_n: f64) -> Scene {
        let mut scene = self.scene(&Pressing::undragged(load_n));
        scene.model.level = self.settings.film_level;
        scene
    }

    /// The scene of a pressing.
    pub fn scene(&self, pressing: &Pressing) -> Scene {
        let mut scene = self.tire.clone();
        let largest = self.settings.shift_mm(pressing.load_n);
        scene.ground.load_n = Some(pressing.load_n);
        scene.ground.shift_mm = pressing.shares.map(|share| share * largest + 0.0);
        scene
    }
}

#[cfg(test)]
mod tests {
    use fem_client::scene::Level;

    use super::*;

    fn scenes(friction: f64) -> TableScenes {
        let settings = TableSettings::new(30.0, 12.5, friction, Level::Coarse);
        TableScenes::new(&Scene::default(), settings)
    }

    #[test]
    fn every_scene_is_one_that_the_reader_takes() {
        let table = scenes(0.5);
        let tested = table.tested().concat();
        let all = [table.undragged(), table.dragged(), tested].concat();
        assert_eq!(all.len(), 36 + 32 + 20);
        for pressing in &all {
            let mut scene = table.scene(pressing);
            scene.contact.friction = 0.5;
            assert_eq!(Scene::from_json(&scene.canonical_json()), Ok(scene));
        }
    }

    #[test]
    fn another_tire_is_pressed_alike_and_not_tested() {
        let own = scenes(0.5);
        let other = own.untested(&TireVariant {
            level: Some(Level::Draft),
            wall_factor: 1.05,
            pressure_factor: 0.9,
            friction_factor: 0.8,
            learnt: false,
        });
        assert_eq!(
            (other.undragged(), other.dragged()),
            (own.undragged(), own.dragged())
        );
        assert!(other.tested().is_empty());
        let scene = other.scene(&other.undragged()[0]);
        let own = own.scene(&own.undragged()[0]);
        assert_eq!(scene.model.level, Level::Draft);
        assert!((scene.geometry.wall_mm - 1.05 * own.geometry.wall_mm).abs() < 1e-12);
        assert!((scene.pressure.internal_mpa / own.pressure.internal_mpa - 0.9).abs() < 1e-12);
        assert_eq!(scene.ground, own.ground);
        // Ground that holds by less slides after less.
        let drag = other.scene(&other.dragged()[0]).ground.shift_mm[0];
        let farther = scenes(0.5).scene(&other.dragged()[0]);
        assert!((drag / farther.ground.shift_mm[0] - 0.8).abs() < 1e-12);
    }

    #[test]
    fn pairs_lie_within_the_table_and_are_drawn_by_the_seed() {
        let table = scenes(0.5);
        for [low, high] in table.tested() {
            assert_eq!(low.shares, high.shares);
            assert!((high.load_n / low.load_n - 1.05 / 0.95).abs() < 1e-12);
            assert!(
                low.load_n > 0.0 && high.load_n <= 30.0 && low.shares[0].hypot(low.shares[1]) < 1.0
            );
        }
        assert_eq!(table.tested(), scenes(0.5).tested());
        let smooth = scenes(0.0);
        assert!(smooth.dragged().is_empty());
        assert!(
            smooth
                .tested()
                .concat()
                .iter()
                .all(|pressing| pressing.shares == [0.0; 2])
        );
    }
}
