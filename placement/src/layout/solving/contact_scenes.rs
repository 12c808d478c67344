//! Contacts that are solved for the response surface of `layouts.contacts`: each quantity alone, at even steps and some depths, and a few of all at once.
//!
//! The two mirror planes of the upright wheel halve the solves: a camber or a pull to one side holds that to the other.

use fem_client::scene::{Level, Scene};

use crate::layout::solving::layout_scenes::LayoutScenes;
use crate::layout::solving::mirror_parts::mirrored;
use crate::points::{SceneSeries, Starts};
use documents::layouts::contact_laws::{ContactLaw, ContactQuantity, Contacts};
use gsa::design::sobol::Sobol;
use layouts::arrangement::FilmKind;

/// Seed of the scramble of the contacts that judge the surface.
const SEED: u64 = 1;
/// Ground's shift over the section's radius, for the depth as large as that, for a force along or across the wheel of the vertical one: on the foot tire 1.3 to 1.4 and 1.6 times
/// what it takes. What reaches far beyond costs accuracy: most of the contact slides there.
const SHIFT_OF_SECTION: [f64; 2] = [0.7, 2.0];
/// Powers of the depth by which it grows.
const SHIFT_POWERS: [f64; 2] = [0.75, 1.0];
/// Steps of contacts whose mirror images are the opposite ones, and of the others.
const ONE_SIDE: [f64; 2] = [0.5, 1.0];
const BOTH_SIDES: [f64; 2] = [-1.0, 1.0];
/// Steps of the outermost stations, which a deep contact meets and leaves within their law.
const OUTERMOST: [f64; 4] = [-1.0, -0.5, 0.5, 1.0];
/// Step of both quantities where two are solved at once.
pub(crate) const OF_PAIR: f64 = 0.75;

/// Step of a scene away from the usual contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Stepped {
    /// Inclination of the wheel.
    Camber,
    /// Shift of the ground along the wheel (0) or across it (1).
    Shift(usize),
    /// Depth of a station, by a share of the contact's.
    Station(usize),
    /// Height of a station, by a length.
    Height(usize),
    /// Internal pressure.
    Pressure,
    /// Friction of the ground.
    Friction,
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
    /// Number of contacts of all quantities at once that judge the surface.
    checks: u32,
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

impl Stepped {
    /// Station of the ground that is stepped.
    fn station(self) -> Option<usize> {
        match self {
            Self::Station(station) | Self::Height(station) => Some(station),
            Self::Camber | Self::Shift(_) | Self::Pressure | Self::Friction => None,
        }
    }

    /// Mirrors, fore and aft and left and right, that turn it into the opposite step; none where the opposite one is another contact.
    pub(crate) fn opposite(self) -> Option<[bool; 2]> {
        match self {
            Self::Camber | Self::Shift(1) => Some([false, true]),
            Self::Shift(_) => Some([true, false]),
            Self::Station(_) | Self::Height(_) | Self::Pressure | Self::Friction => None,
        }
    }

    /// Step of the station as far behind the middle of so many as this one is before it, where that is another one.
    fn image(self, stations: usize) -> Option<Self> {
        let other = stations - 1 - self.station()?;
        let image = match self {
            Self::Height(_) => Self::Height(other),
            _ => Self::Station(other),
        };
        (image != self).then_some(image)
    }
}

impl PlannedAxis {
    /// Steps that are solved.
    pub fn steps(&self) -> &'static [f64] {
        match self.stepped {
            Stepped::Camber | Stepped::Shift(_) => &ONE_SIDE,
            Stepped::Station(0) | Stepped::Height(0) => &OUTERMOST,
            Stepped::Station(_) | Stepped::Height(_) | Stepped::Pressure | Stepped::Friction => {
                &BOTH_SIDES
            }
        }
    }

    /// Steps a scene of a flat ground away from the usual contact.
    fn step(&self, scene: &mut Scene, depth_mm: f64, step: f64) {
        let by = step * self.reach;
        match self.stepped {
            Stepped::Camber => scene.ground.camber_deg = by,
            Stepped::Shift(way) => {
                let section_mm = scene.geometry.section_radius_mm;
                let share = (depth_mm / section_mm).powf(SHIFT_POWERS[way]);
                scene.ground.shift_mm[way] = by * SHIFT_OF_SECTION[way] * share * section_mm;
            }
            Stepped::Station(station) => scene.ground.depths_mm[station] *= 1.0 + by,
            Stepped::Height(station) => scene.ground.depths_mm[station] += by,
            Stepped::Pressure => scene.pressure.internal_mpa *= 1.0 + by,
            Stepped::Friction => scene.contact.friction *= 1.0 + by,
        }
    }
}

impl<'s> ContactScenes<'s> {
    /// Lists the scenes of a study's layouts; none where contacts don't differ.
    pub fn of(scenes: &'s LayoutScenes, contacts: &'s Contacts) -> Option<Self> {
        let laws = &contacts.laws;
        let depths = scenes.depths_of_contacts();
        let stations = scenes.stations();
        let planned = |(law, own): (usize, &ContactLaw)| {
            let stepped = match own.quantity {
                ContactQuantity::Camber => vec![Stepped::Camber],
                ContactQuantity::Traction => vec![Stepped::Shift(0)],
                ContactQuantity::SideTraction => vec![Stepped::Shift(1)],
                // Those behind the middle are images of those before it.
                ContactQuantity::Uneven => (0..=stations / 2).map(Stepped::Station).collect(),
                ContactQuantity::Rough => (0..=stations / 2).map(Stepped::Height).collect(),
                ContactQuantity::Pressure => vec![Stepped::Pressure],
                ContactQuantity::Friction => vec![Stepped::Friction],
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
            checks: contacts.checks,
            depths,
            axes: laws.iter().enumerate().flat_map(planned).collect(),
        })
    }

    /// Axes of the surface: those that are solved, each behind it with its image before or behind the middle, where it has one.
    pub fn components(&self) -> Vec<(usize, PlannedAxis)> {
        let stations = self.scenes.stations();
        let with_image = |(solved, axis): (usize, &PlannedAxis)| {
            let image = axis.stepped.image(stations).map(|stepped| PlannedAxis {
                stepped,
                ..axis.clone()
            });
            std::iter::once(axis.clone())
                .chain(image)
                .map(move |axis| (solved, axis))
        };
        self.axes.iter().enumerate().flat_map(with_image).collect()
    }

    /// Contacts that are solved of an axis on a level.
    fn of_axis(&self, axis: &PlannedAxis, level: Level, kinds: &[FilmKind]) -> SceneSeries {
        let step = |scene: &mut Scene, depth_mm, step| axis.step(scene, depth_mm, step);
        self.at_steps(axis.steps(), step, level, kinds)
    }

    /// Pairs of solved axes of which what both change at once is solved, too: those that matter most on the foot tire.
    pub fn pairs(&self) -> Vec<[usize; 2]> {
        let axes = 0..self.axes.len();
        let with = |first: usize| axes.clone().map(move |second| [first, second]);
        axes.clone()
            .flat_map(with)
            .filter(|pair| self.are_paired(*pair))
            .collect()
    }

    /// Whether two axes are a pair: the camber with each station, a traction with each but the middle one, the outermost station with each of its law up to the middle.
    fn are_paired(&self, pair: [usize; 2]) -> bool {
        let [first, second] = pair.map(|axis| self.axes[axis].stepped);
        let middle = self.scenes.stations() / 2;
        match (first, second) {
            (Stepped::Camber, _) => second.station().is_some(),
            (Stepped::Shift(0), _) => second.station().is_some_and(|station| station < middle),
            (Stepped::Station(0), Stepped::Station(other))
            | (Stepped::Height(0), Stepped::Height(other)) => other > 0,
            _ => false,
        }
    }

    /// Numbers of the surface's axes that a solved pair is about: its own, and those of its image before or behind the middle, where it has one.
    pub(crate) fn components_of(&self, pair: [usize; 2]) -> Vec<[usize; 2]> {
        let components = self.components();
        let numbers = pair.map(|solved| {
            let own = (0..components.len()).filter(|number| components[*number].0 == solved);
            own.collect::<Vec<usize>>()
        });
        let [first, second] = numbers.each_ref().map(Vec::len);
        let number = |k: usize| {
            let last = |own: &Vec<usize>| own[k.min(own.len() - 1)];
            numbers.each_ref().map(last)
        };
        (0..first.max(second)).map(number).collect()
    }

    /// Step that is solved of the first axis of a pair. A traction that is negative before the middle stands for both signs better than the other one, on the foot tire.
    pub(crate) fn step_of_first(&self, [first, _]: [usize; 2]) -> f64 {
        match self.axes[first].stepped {
            Stepped::Shift(_) => -OF_PAIR,
            _ => OF_PAIR,
        }
    }

    /// Contacts that are solved of a pair on a level.
    fn of_pair(&self, pair: [usize; 2], level: Level, kinds: &[FilmKind]) -> SceneSeries {
        let [first, second] = pair.map(|axis| &self.axes[axis]);
        let step = |scene: &mut Scene, depth_mm, step| {
            first.step(scene, depth_mm, step);
            second.step(scene, depth_mm, OF_PAIR);
        };
        self.at_steps(&[self.step_of_first(pair)], step, level, kinds)
    }

    /// Contacts at each depth, from the middle one on, at each of these steps.
    fn at_steps(
        &self,
        steps: &[f64],
        step: impl Fn(&mut Scene, f64, f64),
        level: Level,
        kinds: &[FilmKind],
    ) -> SceneSeries {
        let mut scenes = Vec::new();
        for depth_mm in &self.depths {
            for own in steps {
                let mut scene = self.scenes.flat(*depth_mm, level);
                step(&mut scene, *depth_mm, *own);
                scenes.push(scene);
            }
        }
        // The first contact of a depth starts from that of the middle one, the others from the one before.
        let start = |point: usize| match point.is_multiple_of(steps.len()) {
            true => 0,
            false => point - 1,
        };
        SceneSeries {
            starts: Starts::of_each((0..scenes.len()).map(start).collect()),
            readout: mirrored(kinds),
            scenes,
        }
    }

    /// Contacts of all quantities at once, evenly over their laws; `step_of` tells the step of an axis at a depth, mm, that gives a value of its quantity.
    pub fn checks(&self, step_of: impl Fn(f64, usize, f64) -> f64) -> Vec<CheckContact> {
        let components = self.components();
        let points = Sobol::new(components.len());
        // Those asked for alone: the others are there for the cubic.
        let asked = self.scenes.asked();
        let check = |k: u32| {
            let shares = points.point(k, SEED);
            let depth_mm = asked[k as usize % asked.len()];
            let step = |(number, ((_, axis), share)): (usize, (&(usize, PlannedAxis), f64))| {
                step_of(depth_mm, number, self.laws[axis.law].value_at(share))
            };
            let drawn = components.iter().zip(shares).enumerate();
            CheckContact {
                depth_mm,
                steps: drawn.map(step).collect(),
            }
        };
        let mut checks: Vec<CheckContact> = (0..self.checks).map(check).collect();
        // The deepest take longest: begun last they would leave all threads but their own without work.
        checks.sort_by(|a, b| b.depth_mm.total_cmp(&a.depth_mm));
        checks
    }

    /// Contacts of that kind while no surface tells what a traction takes: as far as the largest one's step.
    fn farthest_checks(&self) -> Vec<CheckContact> {
        let components = self.components();
        self.checks(|_, number, value| {
            let (_, axis) = &components[number];
            let usual = self.laws[axis.law].quantity.usual();
            (value - usual) / axis.reach
        })
    }

    /// Scenes of these contacts.
    fn check_scenes(&self, checks: &[CheckContact], level: Level) -> Vec<Scene> {
        let components = self.components();
        let scene = |check: &CheckContact| {
            let mut scene = self.scenes.flat(check.depth_mm, level);
            for ((_, axis), step) in components.iter().zip(&check.steps) {
                axis.step(&mut scene, check.depth_mm, *step);
            }
            scene
        };
        checks.iter().map(scene).collect()
    }

    /// All that is solved on a level, read for these kinds of film: a series for each pair, which take longest, then for each axis.
    pub fn series(&self, level: Level, kinds: &[FilmKind]) -> Vec<SceneSeries> {
        let of_pairs = self.pairs().into_iter();
        let of_pairs = of_pairs.map(|pair| self.of_pair(pair, level, kinds));
        let of_axes = self.axes.iter();
        let of_axes = of_axes.map(|axis| self.of_axis(axis, level, kinds));
        of_pairs.chain(of_axes).collect()
    }

    /// Contacts of all quantities at once on a level: a series each, as none is near another.
    pub(crate) fn check_series(
        &self,
        checks: &[CheckContact],
        level: Level,
        kinds: &[FilmKind],
    ) -> Vec<SceneSeries> {
        let scenes = self.check_scenes(checks, level).into_iter();
        let alone = |scene| SceneSeries::from_first(vec![scene], mirrored(kinds));
        scenes.map(alone).collect()
    }

    /// Series that are expected of them before the surface is there.
    pub(crate) fn expected_checks(&self, level: Level, kinds: &[FilmKind]) -> Vec<SceneSeries> {
        self.check_series(&self.farthest_checks(), level, kinds)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use documents::layouts::layout_settings::{LayoutLoads, Layouts};
    use gsa::law::distribution::Distribution;

    fn contacts() -> Contacts {
        let law = |quantity, low, high| ContactLaw {
            quantity,
            law: Distribution::uniform(low, high).expect("a law"),
        };
        Contacts {
            laws: vec![
                law(ContactQuantity::Camber, -10.0, 10.0),
                law(ContactQuantity::Traction, -0.2, 0.2),
                law(ContactQuantity::Uneven, -0.3, 0.3),
                law(ContactQuantity::Pressure, 0.9, 1.1),
            ],
            ..Contacts::default()
        }
    }

    #[test]
    fn each_quantity_is_stepped_alone_and_all_at_once() {
        let settings = Layouts {
            loads: LayoutLoads::Depths(vec![1.0, 2.0]),
            ..Layouts::default()
        };
        let tire = Scene::default();
        let scenes = LayoutScenes::of(&settings, &tire).expect("loads");
        let asked = contacts();
        let contacts = ContactScenes::of(&scenes, &asked).expect("laws");
        // The middle one of two loads is the second; both ends are beside them.
        assert_eq!(contacts.depths, [2.0, 1.0, 2.5, 0.5]);
        // The camber with three of five stations, a traction and the outermost station with two. Then a camber, a traction, three stations and a pressure alone: two steps
        // each, four of the outermost station.
        let all = contacts.series(Level::Draft, &[]);
        let counts: Vec<usize> = all.iter().map(|series| series.scenes.len()).collect();
        assert_eq!(counts, [4, 4, 4, 4, 4, 4, 4, 8, 8, 16, 8, 8, 8]);
        // Axes of the surface: the camber, the traction, five stations, the pressure.
        assert_eq!(contacts.components().len(), 8);
        let differ = |scene: &Scene| {
            let ground = &scene.ground;
            let depths = &ground.depths_mm;
            [
                ground.camber_deg != 0.0,
                ground.shift_mm[0] != 0.0,
                depths.iter().any(|depth| *depth != depths[2]),
                scene.pressure != tire.pressure,
            ]
        };
        for (series, differing) in [
            (0, [true, false, true, false]),
            (3, [false, true, true, false]),
            (5, [false, false, true, false]),
            (7, [true, false, false, false]),
            (8, [false, true, false, false]),
            (9, [false, false, true, false]),
            (12, [false, false, false, true]),
        ] {
            let scenes = &all[series].scenes;
            assert!(
                scenes.iter().all(|scene| differ(scene) == differing),
                "{series}"
            );
        }
        // The outermost station with the next one, 0.75 of 0.3 more of the depth; a thousandth of the law beyond either end isn't drawn.
        let depths = &all[5].scenes[0].ground.depths_mm;
        for (found, expected) in depths.iter().zip([2.45, 2.45, 2.0, 2.0, 2.0]) {
            assert!((found - expected).abs() < 2.0 * 0.3 * 1e-2, "{depths:?}");
        }
        // The camber with the outermost stations, those before the middle and behind it, and the middle one; a traction with all but the middle one; outermost stations
        // with the ones next to them and with the middle one.
        let numbers: Vec<_> = contacts
            .pairs()
            .into_iter()
            .map(|pair| contacts.components_of(pair))
            .collect();
        let expected = [
            vec![[0, 2], [0, 3]],
            vec![[0, 4], [0, 5]],
            vec![[0, 6]],
            vec![[1, 2], [1, 3]],
            vec![[1, 4], [1, 5]],
            vec![[2, 4], [3, 5]],
            vec![[2, 6], [3, 6]],
        ];
        assert_eq!(numbers, expected);
        for scene in contacts.check_scenes(&contacts.farthest_checks(), Level::Draft) {
            assert_eq!(differ(&scene), [true; 4]);
        }
        assert_eq!(ContactScenes::of(&scenes, &Contacts::default()), None);
    }

    #[test]
    fn a_station_of_uneven_ground_goes_with_the_depth_and_one_of_rough_ground_does_not() {
        let axis = |stepped| PlannedAxis {
            law: 0,
            stepped,
            reach: 0.2,
        };
        for (stepped, image, expected) in [
            (Stepped::Station(1), Stepped::Station(3), [0.55, 1.1]),
            (Stepped::Height(1), Stepped::Height(3), [0.6, 1.1]),
        ] {
            let stepped_at = |depth_mm: f64| {
                let mut scene = Scene::default();
                scene.ground.depths_mm = vec![depth_mm; 5];
                axis(stepped).step(&mut scene, depth_mm, 0.5);
                scene.ground.depths_mm[1]
            };
            let found = [0.5, 1.0].map(stepped_at);
            for (found, expected) in found.into_iter().zip(expected) {
                assert!((found - expected).abs() < 1e-12, "{stepped:?}: {found}");
            }
            assert_eq!(stepped.image(5), Some(image));
        }
        assert_eq!(Stepped::Height(2).image(5), None);
    }
}
