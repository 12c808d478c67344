//! Glued films of layouts beside the contact: what they are pressed by, and where what their transfer misses is added.

use fem_client::scene::Level;
use gsa::design::sobol::Sobol;

use crate::layout::solving::glued::angle_residual::AngleResidual;
use crate::layout::solving::glued::film_angles::{
    FARTHEST_TEST_DEG, FilmLoad, FilmLoads, FilmTest, TurnedSignals,
};
use crate::layout::solving::layout_scenes::{LayoutScenes, Pressed};
use documents::signals::series::numbers_of_transfer;
use layouts::field::film_field::DepthFields;

/// Solves that test each kind of film: with friction one takes as long as ten others.
const TESTS: u32 = 2;

/// Lists what so many kinds of film are pressed by on a level: the loads asked for, the least and the largest that are solved; `tested` by others or not.
pub(crate) fn film_loads(
    scenes: &LayoutScenes,
    kinds: usize,
    level: Level,
    tested: bool,
) -> FilmLoads {
    let loads = scenes.loads_of_films();
    let values: Vec<f64> = loads.iter().map(|load| load.value()).collect();
    let tests = |kind: usize| match tested {
        true => tests(scenes, kind, level),
        false => Vec::new(),
    };
    let first = loads.iter().position(|load| *load == scenes.solved[0]);
    FilmLoads {
        level: level.as_str().to_owned(),
        first: first.unwrap_or_default(),
        of_transfer: numbers_of_transfer(&values),
        tests: (0..kinds).map(tests).collect(),
        loads: loads
            .into_iter()
            .map(|load| {
                let tire = scenes.pressed_by(load, level);
                FilmLoad {
                    name: load.to_string(),
                    bare: tire.clone(),
                    tire,
                }
            })
            .collect(),
    }
}

/// Tests of a kind of film, evenly over the wheel angle and the loads asked for.
fn tests(scenes: &LayoutScenes, kind: usize, level: Level) -> Vec<FilmTest> {
    let points = Sobol::new(2);
    let [least, largest] = scenes.ends_of_tests();
    let test = |k| {
        let shares = points.point(k, kind as u64);
        let load = scenes.like(least + (largest - least) * shares[1]);
        FilmTest {
            angle_deg: FARTHEST_TEST_DEG * (2.0 * shares[0] - 1.0),
            pressing: load.value(),
            tire: scenes.pressed_by(load, level),
        }
    };
    (0..TESTS).map(test).collect()
}

/// Fields of one mesh, whose pressings are as the study's loads are.
pub(crate) struct PressedFields<'f> {
    pub fields: &'f mut DepthFields,
    pub scenes: &'f LayoutScenes,
}

impl PressedFields<'_> {
    /// Depths of the loads at which films are solved, mm.
    pub fn depths_mm(&self) -> Vec<f64> {
        let loads = self.scenes.loads_of_films().into_iter();
        loads.map(|load| self.depth_mm(load)).collect()
    }

    fn depth_mm(&self, load: Pressed) -> f64 {
        match load {
            Pressed::Depth(depth_mm) => depth_mm,
            Pressed::Force(force_n) => self.fields.depth_mm(force_n),
        }
    }
}

impl TurnedSignals for PressedFields<'_> {
    fn add(&mut self, kind: usize, missing: &AngleResidual) {
        let depths = self.fields.depths.places().iter();
        for (samples, depth_mm) in self.fields.signals[kind].iter_mut().zip(depths) {
            missing.add_to(*depth_mm, samples);
        }
    }

    fn signal(&self, kind: usize, angle_deg: f64, pressing: f64) -> f64 {
        let depth_mm = self.depth_mm(self.scenes.like(pressing));
        self.fields.at(depth_mm).kinds[kind].signal.at(angle_deg)
    }

    fn largest_signal(&self, kind: usize) -> f64 {
        let samples = self.fields.signals[kind].iter().flatten();
        samples.fold(0.0, |largest: f64, sample| largest.max(sample.abs()))
    }
}
