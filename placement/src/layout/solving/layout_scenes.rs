//! Scenes that are solved for layouts: a flat ground at every load, and a little beside it.

use fem_client::scene::{Level, Scene};
use fem_client::solver::{Readout, RingLine};

use crate::points::{SceneSeries, Starts};
use documents::layouts::layout_settings::{BEYOND, FEW_LOADS, LayoutLoads, Layouts};
use documents::signals::series::loads_of_transfer;
use layouts::arrangement::FilmKind;

/// Wheel angle from the contact up to which bricks grow slowly, degrees: slopes of strains 20 to 60 degrees from the contact decide how well its angle is known.
pub const FINE_DEG: f64 = 60.0;
/// Solves beside each load, over the load: slopes over the depth are central differences. On the foot tire half the distance changes them by 0.3 %.
const BESIDE: [f64; 2] = [0.9, 1.1];
/// The ground's shift over the section's radius: 0.02 mm on the foot tire, of the 0.7 mm at which it slides.
const SHIFT_OF_SECTION: f64 = 1.6e-3;
/// Solves nearer than this to another are left out, relative.
const TOO_NEAR: f64 = 0.04;

/// Pressing of a flat ground.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Pressed {
    /// Depth to press to, mm.
    Depth(f64),
    /// Force to press with, N.
    Force(f64),
}

/// The loads of a study, and all that is solved for them.
#[derive(Debug, Clone, PartialEq)]
pub struct LayoutScenes {
    /// The bare tire.
    tire: Scene,
    /// Loads at which layouts are scored, in the order of the document.
    pub loads: Vec<Pressed>,
    /// Loads that are solved: the one in the middle of those asked for, then these outwards from there, then those beside them.
    pub solved: Vec<Pressed>,
    /// Starts among these: a load asked for from its neighbour towards the middle, the others from the nearest load asked for.
    starts: Starts,
}

impl Pressed {
    /// Value of the depth, mm, or the force, N.
    pub(crate) fn value(self) -> f64 {
        match self {
            Self::Depth(value) | Self::Force(value) => value,
        }
    }

    fn times(self, factor: f64) -> Self {
        match self {
            Self::Depth(depth) => Self::Depth(factor * depth),
            Self::Force(force) => Self::Force(factor * force),
        }
    }
}

impl std::fmt::Display for Pressed {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Depth(depth) => write!(f, "{depth} mm"),
            Self::Force(force) => write!(f, "{force} N"),
        }
    }
}

impl LayoutScenes {
    /// Lists the scenes of a tire: a study's scene at its means.
    ///
    /// # Errors
    /// Why there is no load.
    pub fn of(settings: &Layouts, means: &Scene) -> Result<Self, String> {
        let mut tire = means.clone();
        tire.film = None;
        let loads = loads(settings, means)?;
        if let Some(load) = loads.iter().find(|load| !is_reachable(&tire, **load)) {
            return Err(format!(
                "Layouts have no scores: this tire can't be pressed by {load} as a scene can."
            ));
        }
        let mut sorted = loads.clone();
        sorted.sort_by(|a, b| a.value().total_cmp(&b.value()));
        let (least, largest) = (sorted[0], sorted[sorted.len() - 1]);
        let (mut solved, mut starts) = outwards(&sorted);
        let beside = sorted
            .iter()
            .flat_map(|load| BESIDE.map(|factor| load.times(factor)));
        let ends = [least.times(BEYOND[0]), largest.times(BEYOND[1])];
        let mut further: Vec<(usize, Pressed)> = Vec::new();
        for load in beside.chain(ends) {
            let is_near =
                |other: &Pressed| (other.value() - load.value()).abs() < TOO_NEAR * load.value();
            let mut known = solved.iter().chain(further.iter().map(|(_, load)| load));
            if !known.any(is_near) && is_reachable(&tire, load) {
                further.push((nearest(&solved, load), load));
            }
        }
        // Those with one start after each other: they share its tangent. The farther from it, the longer a solve takes: begun last it would leave all threads but its own
        // without work.
        let apart =
            |(start, load): &(usize, Pressed)| (load.value() - solved[*start].value()).abs();
        further.sort_by(|a, b| a.0.cmp(&b.0).then(apart(b).total_cmp(&apart(a))));
        starts.extend(further.iter().map(|(start, _)| *start));
        solved.extend(further.into_iter().map(|(_, load)| load));
        Ok(Self {
            tire,
            loads,
            solved,
            starts: Starts::of_each(starts),
        })
    }

    /// All that is solved on a level, read for these kinds of film.
    pub(crate) fn series(&self, level: Level, kinds: &[FilmKind]) -> SceneSeries {
        SceneSeries {
            scenes: self.scenes(level),
            starts: self.starts.clone(),
            readout: readout(kinds),
        }
    }

    /// The scenes of what is solved, on a level.
    pub fn scenes(&self, level: Level) -> Vec<Scene> {
        let loads = self.solved.iter();
        loads.map(|load| self.pressed_by(*load, level)).collect()
    }

    /// The tire under a flat ground, on a level.
    pub(crate) fn pressed_by(&self, load: Pressed, level: Level) -> Scene {
        let mut scene = pressed(&self.tire, load);
        scene.model.level = level;
        scene
    }

    /// A depth or a force of this value, as the loads are.
    pub(crate) fn like(&self, value: f64) -> Pressed {
        match self.loads[0] {
            Pressed::Depth(_) => Pressed::Depth(value),
            Pressed::Force(_) => Pressed::Force(value),
        }
    }

    /// Loads at which glued films are solved around the wheel, increasing: those asked for, and the least and the largest that are solved.
    pub(crate) fn loads_of_films(&self) -> Vec<Pressed> {
        let mut sorted = self.solved.clone();
        sorted.sort_by(|a, b| a.value().total_cmp(&b.value()));
        let ends = [sorted[0], sorted[sorted.len() - 1]];
        sorted.retain(|load| self.loads.contains(load) || ends.contains(load));
        sorted
    }

    /// The least and the largest load at which glued films are tested: of a single one asked for those solved beside it.
    pub(crate) fn ends_of_tests(&self) -> [f64; 2] {
        let [least, largest] = self.ends_asked();
        match self.loads.len() {
            1 => [BESIDE[0] * least, BESIDE[1] * largest],
            _ => [least, largest],
        }
    }

    /// The least and the largest load asked for.
    fn ends_asked(&self) -> [f64; 2] {
        let asked = self.asked().into_iter();
        asked.fold([f64::INFINITY, 0.0], |[low, high], value| {
            [f64::min(low, value), f64::max(high, value)]
        })
    }

    /// The loads asked for, each with the ground dragged along the wheel and across it at once, by [`LayoutScenes::shift_mm`].
    pub fn sheared(&self, level: Level) -> Vec<Scene> {
        let dragged = |load: &Pressed| {
            let mut scene = self.pressed_by(*load, level);
            scene.ground.shift_mm = [self.shift_mm(); 2];
            scene
        };
        self.loads.iter().map(dragged).collect()
    }

    /// The tire on flat ground at a depth, mm, on a level.
    pub(crate) fn flat(&self, depth_mm: f64, level: Level) -> Scene {
        let mut scene = self.tire.clone();
        scene.ground = scene.ground.at_depths(vec![depth_mm; self.stations()]);
        scene.model.level = level;
        scene
    }

    /// Number of the ground's stations.
    pub(crate) fn stations(&self) -> usize {
        self.tire.ground.stations
    }

    /// Values of the loads asked for, in the order of the document.
    pub(crate) fn asked(&self) -> Vec<f64> {
        self.loads.iter().map(|load| load.value()).collect()
    }

    /// Depths at which contacts are solved that differ from the usual one, mm: those asked for, the middle one first, and where these are fewer than three a little
    /// beyond them on both sides.
    pub(crate) fn depths_of_contacts(&self) -> Vec<f64> {
        let [least, largest] = self.ends_asked();
        let ends = match self.loads.len() {
            ..FEW_LOADS => vec![BEYOND[0] * least, BEYOND[1] * largest],
            _ => Vec::new(),
        };
        let is_wanted = |load: &&Pressed| self.loads.contains(load) || ends.contains(&load.value());
        let wanted = self.solved.iter().filter(is_wanted);
        wanted.map(|load| load.value()).collect()
    }

    /// Returns how far the ground is dragged for slopes over its shift, mm: so little that all but the contact's rim sticks.
    pub fn shift_mm(&self) -> f64 {
        SHIFT_OF_SECTION * self.tire.geometry.section_radius_mm
    }

    /// Coefficient of friction.
    pub fn friction(&self) -> f64 {
        self.tire.contact.friction
    }

    /// Returns which two of the solved loads give a glued film's transfer: of those asked for the nearest to a third and to two thirds of the largest, as
    /// of films' signals; of a single one those beside it count, too.
    pub(crate) fn of_transfer(&self) -> Option<[usize; 2]> {
        let values =
            |loads: &[Pressed]| -> Vec<f64> { loads.iter().map(|load| load.value()).collect() };
        let (asked, solved) = (values(&self.loads), values(&self.solved));
        let two = loads_of_transfer(&asked).or_else(|| loads_of_transfer(&solved))?;
        let [first, second] = two.map(|load| solved.iter().position(|other| *other == load));
        Some([first?, second?])
    }

    /// Returns which of the solved loads sets the noise.
    pub fn middle(&self) -> usize {
        0
    }
}

/// Whether a scene can be pressed so far.
fn is_reachable(tire: &Scene, load: Pressed) -> bool {
    let mut faults = Vec::new();
    Scene::from_value(&pressed(tire, load).to_value(), "", &mut faults).is_some()
}

/// The tire under a flat ground.
fn pressed(tire: &Scene, load: Pressed) -> Scene {
    let mut scene = tire.clone();
    match load {
        Pressed::Depth(depth) => {
            scene.ground.load_n = None;
            scene.ground.depths_mm = vec![depth; scene.ground.stations];
        }
        Pressed::Force(force) => {
            scene.ground.depths_mm.clear();
            scene.ground.load_n = Some(force);
        }
    }
    scene
}

/// The middle one of increasing loads, whose crown sets the noise, then the others outwards from it, the larger first; and which of these each starts from.
fn outwards(sorted: &[Pressed]) -> (Vec<Pressed>, Vec<usize>) {
    let middle = sorted.len() / 2;
    let (below, above) = (&sorted[..middle], &sorted[middle + 1..]);
    let (mut solved, mut starts) = (vec![sorted[middle]], vec![0]);
    let mut last = [0; 2];
    for step in 0..below.len().max(above.len()) {
        let larger = above.get(step);
        let smaller = below.len().checked_sub(step + 1).map(|load| &below[load]);
        for (load, last) in [larger, smaller].into_iter().zip(&mut last) {
            if let Some(load) = load {
                starts.push(*last);
                *last = solved.len();
                solved.push(*load);
            }
        }
    }
    (solved, starts)
}

/// Returns which load is nearest to another one.
fn nearest(loads: &[Pressed], to: Pressed) -> usize {
    let apart = |load: &Pressed| (load.value() - to.value()).abs();
    let by_distance = |a: &usize, b: &usize| apart(&loads[*a]).total_cmp(&apart(&loads[*b]));
    (0..loads.len()).min_by(by_distance).unwrap_or_default()
}

fn loads(settings: &Layouts, means: &Scene) -> Result<Vec<Pressed>, String> {
    Ok(match &settings.loads {
        LayoutLoads::Depths(depths) => depths.iter().map(|depth| Pressed::Depth(*depth)).collect(),
        LayoutLoads::Forces(forces) => forces.iter().map(|force| Pressed::Force(*force)).collect(),
        LayoutLoads::Mean => {
            let depths = &means.ground.depths_mm;
            let load = match means.ground.load_n {
                Some(force) => Pressed::Force(force),
                None => Pressed::Depth(depths.iter().sum::<f64>() / depths.len().max(1) as f64),
            };
            if load.value() <= 0.0 {
                return Err("The tire isn't pressed at the means, so that layouts have no load: layouts.depths_mm names some.".to_owned());
            }
            vec![load]
        }
    })
}

/// Returns where strains are read: a line around the wheel for every section angle at which a film has a point.
pub fn readout(kinds: &[FilmKind]) -> Readout {
    let mut rings: Vec<RingLine> = Vec::new();
    for kind in kinds {
        for point in kind.points() {
            let known = rings
                .iter()
                .position(|ring| ring.section_deg == point.section_deg);
            let ring = known.unwrap_or_else(|| {
                rings.push(RingLine::at(point.section_deg));
                rings.len() - 1
            });
            let turned = &mut rings[ring].turned_deg;
            for (angle_deg, _) in kind.reads.directions(kind.angle_deg) {
                if ![0.0, 90.0].contains(&angle_deg) && !turned.contains(&angle_deg) {
                    turned.push(angle_deg);
                }
            }
        }
    }
    Readout {
        rings,
        fine_deg: Some(FINE_DEG),
        ..Readout::default()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_load_has_a_solve_on_both_sides() {
        let settings = Layouts {
            loads: LayoutLoads::Depths(vec![0.5, 1.0, 2.0]),
            ..Layouts::default()
        };
        let scenes = LayoutScenes::of(&settings, &Scene::default()).expect("loads");
        let from: Vec<(f64, f64)> = (0..11)
            .map(|point| {
                let start = scenes.starts.of(point).unwrap_or(point);
                (scenes.solved[point].value(), scenes.solved[start].value())
            })
            .collect();
        assert_eq!(from[..3], [(1.0, 1.0), (2.0, 1.0), (0.5, 1.0)]);
        assert_eq!(from[3..5], [(1.1, 1.0), (0.9, 1.0)]);
        assert_eq!(from[5..8], [(2.5, 2.0), (2.2, 2.0), (1.8, 2.0)]);
        assert!(from[8..].iter().all(|(_, start)| *start == 0.5));
        assert_eq!(scenes.solved.len(), 11);
        let depths: Vec<f64> = scenes
            .scenes(Level::Draft)
            .iter()
            .map(|scene| scene.ground.depths_mm[0])
            .collect();
        assert!(depths.contains(&0.25) && depths.contains(&2.5) && depths.contains(&1.1));
        // One load alone: both sides, and both ends.
        let alone = LayoutScenes::of(&Layouts::default(), &Scene::default()).expect("the mean");
        assert_eq!(alone.solved.len(), 5);
    }

    #[test]
    fn forces_stay_forces_and_no_load_is_a_reason() {
        let mut scene = Scene::default();
        scene.ground.depths_mm.clear();
        scene.ground.load_n = Some(13.0);
        let scenes = LayoutScenes::of(&Layouts::default(), &scene).expect("a force");
        assert_eq!(scenes.loads, [Pressed::Force(13.0)]);
        assert!(
            scenes
                .scenes(Level::Draft)
                .iter()
                .all(|scene| scene.ground.load_n.is_some())
        );
        let mut unpressed = Scene::default();
        unpressed.ground.depths_mm = vec![0.0; 5];
        assert!(LayoutScenes::of(&Layouts::default(), &unpressed).is_err());
    }

    #[test]
    fn lines_are_read_once_for_all_directions() {
        let kind = FilmKind::point;
        let readout = readout(&[
            kind(0.0, 0.0),
            kind(0.0, 90.0),
            kind(30.0, 45.0),
            kind(30.0, 45.0),
            kind(30.0, 0.0),
        ]);
        assert_eq!(readout.rings.len(), 2);
        assert_eq!(readout.rings[1].turned_deg, [45.0]);
        assert_eq!(readout.fine_deg, Some(60.0));
    }
}
