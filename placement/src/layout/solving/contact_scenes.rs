//! Contacts that are solved for the response surface of `layouts.contacts`: each quantity alone, at even steps and some depths, and a few of all at once.
//!
//! The two mirror planes of the upright wheel halve the solves: a camber or a pull to one side holds that to the other.

use fem_client::scene::{Level, Scene};

use crate::layout::solving::layout_scenes::LayoutScenes;
use crate::layout::solving::mirror_parts::mirrored;
use crate::points::{SceneSeries, Starts};
use documents::layouts::contact_laws::{ContactLaw, ContactQuantity};
use gsa::design::sobol::Sobol;
use layouts::arrangement::FilmKind;

/// Contacts of all quantities at once that the surface is judged by.
const CHECKS: u32 = 3;
/// Seed of their scramble.
const SEED: u64 = 1;
/// Ground's shift over the depth for a force along or across the wheel of the vertical one: on the foot tire 1.7 times what it takes.
const SHIFT_OF_DEPTH: [f64; 2] = [1.5, 2.0];
/// Steps of contacts whose mirror images are the opposite ones, and of the others.
const ONE_SIDE: [f64; 2] = [0.5, 1.0];
const BOTH_SIDES: [f64; 2] = [-1.0, 1.0];

/// Step of a scene away from the usual contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Stepped {
    /// Inclination of the wheel.
    Camber,
    /// Shift of the ground along the wheel (0) or across it (1).
    Shift(usize),
    /// Depth of a station.
    Station(usize),
    /// Internal pressure.
    Pressure,
}

/// Axis of the surface, as it is solved.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct PlannedAxis {
    /// Number of its law.
    pub law: usize,
    pub stepped: Stepped,
    /// Largest distance of a value from the usual one.
    pub reach: f64,
}

/// Scenes of a response surface.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct ContactScenes<'s> {
    scenes: &'s LayoutScenes,
    /// The laws.
    pub laws: &'s [ContactLaw],
    /// Depths at which quantities are stepped, mm.
    pub depths: Vec<f64>,
    /// Axes that are solved.
    pub axes: Vec<PlannedAxis>,
}

/// Contact of all quantities at once.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct CheckContact {
    /// Depth, mm.
    pub depth_mm: f64,
    /// Steps by station of the uneven ground and by axis: see [`ContactScenes::components`].
    pub steps: Vec<f64>,
}

impl PlannedAxis {
    /// Steps that are solved.
    pub fn steps(&self) -> [f64; 2] {
        match self.stepped {
            Stepped::Camber | Stepped::Shift(_) => ONE_SIDE,
            Stepped::Station(_) | Stepped::Pressure => BOTH_SIDES,
        }
    }

    /// Steps a scene of a flat ground away from the usual contact.
    fn step(&self, scene: &mut Scene, depth_mm: f64, step: f64) {
        let by = step * self.reach;
        match self.stepped {
            Stepped::Camber => scene.ground.camber_deg = by,
            Stepped::Shift(way) => {
                scene.ground.shift_mm[way] = by * SHIFT_OF_DEPTH[way] * depth_mm;
            }
            Stepped::Station(station) => scene.ground.depths_mm[station] *= 1.0 + by,
            Stepped::Pressure => scene.pressure.internal_mpa *= 1.0 + by,
        }
    }
}

impl<'s> ContactScenes<'s> {
    /// Lists the scenes of a study's layouts; none where contacts don't differ.
    pub fn of(scenes: &'s LayoutScenes, laws: &'s [ContactLaw]) -> Option<Self> {
        let depths = scenes.depths_of_contacts();
        let stations = scenes.stations();
        let planned = |(law, own): (usize, &ContactLaw)| {
            let stepped = match own.quantity {
                ContactQuantity::Camber => vec![Stepped::Camber],
                ContactQuantity::Traction => vec![Stepped::Shift(0)],
                ContactQuantity::SideTraction => vec![Stepped::Shift(1)],
                // Those behind the middle are images of those before it.
                ContactQuantity::Uneven => (0..=stations / 2).map(Stepped::Station).collect(),
                ContactQuantity::Pressure => vec![Stepped::Pressure],
            };
            let reach = own.reach();
            let axis = move |stepped| PlannedAxis {
                law,
                stepped,
                reach,
            };
            stepped.into_iter().map(axis)
        };
        (!laws.is_empty()).then(|| Self {
            scenes,
            laws,
            depths,
            axes: laws.iter().enumerate().flat_map(planned).collect(),
        })
    }

    /// Axes of the surface: those that are solved, each behind it with its image before or behind the middle, where it has one.
    pub fn components(&self) -> Vec<(usize, PlannedAxis)> {
        let stations = self.scenes.stations();
        let with_image = |(solved, axis): (usize, &PlannedAxis)| {
            let image = match axis.stepped {
                Stepped::Station(station) if 2 * station + 1 < stations => Some(PlannedAxis {
                    stepped: Stepped::Station(stations - 1 - station),
                    ..axis.clone()
                }),
                _ => None,
            };
            std::iter::once(axis.clone())
                .chain(image)
                .map(move |axis| (solved, axis))
        };
        self.axes.iter().enumerate().flat_map(with_image).collect()
    }

    /// Contacts that are solved of an axis on a level: by depth, from the middle one on, the steps of each.
    fn of_axis(&self, axis: &PlannedAxis, level: Level) -> Vec<Scene> {
        let scene = |(depth_mm, step): (f64, f64)| {
            let mut scene = self.scenes.flat(depth_mm, level);
            axis.step(&mut scene, depth_mm, step);
            scene
        };
        let depths = self.depths.iter();
        depths
            .flat_map(|depth| axis.steps().map(|step| scene((*depth, step))))
            .collect()
    }

    /// Contacts of all quantities at once, evenly over their laws.
    pub fn checks(&self) -> Vec<CheckContact> {
        let components = self.components();
        let points = Sobol::new(components.len());
        // Those asked for alone: the others are there for the cubic.
        let asked = self.scenes.asked();
        let check = |k: u32| {
            let shares = points.point(k, SEED);
            let step = |((_, axis), share): (&(usize, PlannedAxis), f64)| {
                let law = &self.laws[axis.law];
                (law.value_at(share) - law.quantity.usual()) / axis.reach
            };
            CheckContact {
                depth_mm: asked[k as usize % asked.len()],
                steps: components.iter().zip(shares).map(step).collect(),
            }
        };
        (0..CHECKS).map(check).collect()
    }

    /// Scenes of the contacts of all quantities at once.
    fn check_scenes(&self, level: Level) -> Vec<Scene> {
        let components = self.components();
        let scene = |check: &CheckContact| {
            let mut scene = self.scenes.flat(check.depth_mm, level);
            for ((_, axis), step) in components.iter().zip(&check.steps) {
                axis.step(&mut scene, check.depth_mm, *step);
            }
            scene
        };
        self.checks().iter().map(scene).collect()
    }

    /// All that is solved on a level, read for these kinds of film: a series for each axis.
    pub fn series(&self, level: Level, kinds: &[FilmKind]) -> Vec<SceneSeries> {
        let axes = self.axes.iter();
        // The first contact of a depth starts from that of the middle one, the second from the first.
        let start = |point: usize| {
            if point.is_multiple_of(2) {
                0
            } else {
                point - 1
            }
        };
        let of_axis = |axis| {
            let scenes = self.of_axis(axis, level);
            SceneSeries {
                starts: Starts::of_each((0..scenes.len()).map(start).collect()),
                readout: mirrored(kinds),
                scenes,
            }
        };
        axes.map(of_axis).collect()
    }

    /// The contacts of all quantities at once on a level.
    pub(crate) fn check_series(&self, level: Level, kinds: &[FilmKind]) -> SceneSeries {
        SceneSeries::from_first(self.check_scenes(level), mirrored(kinds))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use documents::layouts::layout_settings::{LayoutLoads, Layouts};
    use gsa::law::distribution::Distribution;

    fn laws() -> Vec<ContactLaw> {
        let law = |quantity, low, high| ContactLaw {
            quantity,
            law: Distribution::uniform(low, high).expect("a law"),
        };
        vec![
            law(ContactQuantity::Camber, -10.0, 10.0),
            law(ContactQuantity::Uneven, -0.3, 0.3),
            law(ContactQuantity::Pressure, 0.9, 1.1),
        ]
    }

    #[test]
    fn each_quantity_is_stepped_alone_and_all_at_once() {
        let settings = Layouts {
            loads: LayoutLoads::Depths(vec![1.0, 2.0]),
            ..Layouts::default()
        };
        let tire = Scene::default();
        let scenes = LayoutScenes::of(&settings, &tire).expect("loads");
        let laws = laws();
        let contacts = ContactScenes::of(&scenes, &laws).expect("laws");
        // Two loads and both ends; a camber, three of five stations and a pressure, two steps each.
        // The middle one of two is the second.
        assert_eq!(contacts.depths, [2.0, 1.0, 2.5, 0.5]);
        let all = contacts.series(Level::Draft, &[]);
        let counts: Vec<usize> = all.iter().map(|series| series.scenes.len()).collect();
        assert_eq!(counts, [8; 5]);
        // Axes of the surface: the camber, five stations, the pressure.
        assert_eq!(contacts.components().len(), 7);
        let differ = |scene: &Scene| {
            let ground = &scene.ground;
            let [first, last] = [0, 4].map(|station| ground.depths_mm[station]);
            [
                ground.camber_deg != 0.0,
                first != last,
                scene.pressure != tire.pressure,
            ]
        };
        assert_eq!(differ(&all[0].scenes[0]), [true, false, false]);
        assert_eq!(differ(&all[1].scenes[0]), [false, true, false]);
        assert_eq!(differ(&all[4].scenes[0]), [false, false, true]);
        for scene in contacts.check_scenes(Level::Draft) {
            assert_eq!(differ(&scene), [true; 3]);
        }
        assert_eq!(ContactScenes::of(&scenes, &[]), None);
    }
}
