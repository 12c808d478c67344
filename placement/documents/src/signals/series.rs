//! Scenes that are solved for signals: a series for the bare tire, and one for each glued film.

use fem_client::scene::Scene;
use fem_client::solver::direction::Direction;
use fem_client::solver::gauge::Gauge;
use fem_client::solver::{Position, Readout};

use crate::parts::film_model::FilmModel;
use crate::signals::signal_settings::SignalSettings;

/// Half of the wheel angle between the two films of a pair, degrees.
pub const PAIR_DEG: f64 = 30.0;
/// Farthest angle around the wheel at which the stress of the crown is read, degrees.
const STRESS_DEG: i32 = 60;

/// Pressing of a film.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pressing {
    /// Vertical force of the ground, N.
    pub load_n: f64,
    /// Internal pressure, MPa.
    pub pressure_mpa: f64,
    /// Wheel angle between film and contact, degrees, not negative: the ground is flat, and a film ahead of the contact reads what one behind it reads.
    pub contact_deg: f64,
}

/// A film's place: in the section, and along which direction.
pub type Place = (Position, Direction);

/// Scenes of one tire that differ in how they are pressed.
#[derive(Debug, Clone, PartialEq)]
pub struct Series {
    /// The glued film; without one, the bare tire.
    pub film: Option<Place>,
    /// Each differs from all others. The first is the one from whose equilibrium the others start.
    pub pressings: Vec<Pressing>,
}

impl Series {
    /// Returns the number of the pressing with the least load, if that isn't the first.
    pub fn least_load(&self) -> Option<usize> {
        let load = |k: &usize| self.pressings[*k].load_n;
        let least = (0..self.pressings.len()).min_by(|a, b| load(a).total_cmp(&load(b)));
        least.filter(|least| *least > 0)
    }
}

/// An angle as a pressing has it, from 0 to 180 degrees.
pub fn apart_deg(angle_deg: f64) -> f64 {
    let turned = angle_deg.rem_euclid(360.0);
    turned.min(360.0 - turned)
}

impl SignalSettings {
    /// Every series of a tire, the bare one first.
    pub fn series(&self, tire: &Scene) -> Vec<Series> {
        let places = self.places();
        let glued = places
            .into_iter()
            .map(|place| (Some(place), self.coupled_pressings(place, tire)));
        let all = std::iter::once((None, self.bare_pressings(tire))).chain(glued);
        all.filter(|(_, pressings)| !pressings.is_empty())
            .map(|(film, pressings)| self.begun_in_the_middle(film, pressings, tire))
            .collect()
    }

    /// Returns the places of the films.
    pub fn places(&self) -> Vec<Place> {
        let of = |position: &Position| {
            let position = *position;
            self.directions
                .iter()
                .map(move |direction| (position, *direction))
        };
        self.positions.iter().flat_map(of).collect()
    }

    /// Returns a pressing at each load, with the tire's own pressure.
    pub fn over_loads(&self, tire: &Scene) -> Vec<Pressing> {
        let pressed = |load_n: &f64| own_pressure(tire, *load_n, 0.0);
        self.loads_n.iter().map(pressed).collect()
    }

    /// Returns a pressing at each pressure.
    pub fn over_pressures(&self) -> Vec<Pressing> {
        let pressed = |pressure_mpa: &f64| Pressing {
            load_n: self.at_load_n,
            pressure_mpa: *pressure_mpa,
            contact_deg: 0.0,
        };
        self.pressures_mpa.iter().map(pressed).collect()
    }

    /// Returns a pressing at each contact angle, with the tire's own pressure.
    pub fn over_contact(&self, tire: &Scene) -> Vec<Pressing> {
        let pressed = |angle: &f64| self.contact_at(*angle, tire);
        self.contact_deg.iter().map(pressed).collect()
    }

    /// Returns the pressing with the contact so many degrees from a film.
    pub fn contact_at(&self, angle_deg: f64, tire: &Scene) -> Pressing {
        own_pressure(tire, self.contact_load_n, apart_deg(angle_deg))
    }

    /// The two loads whose equilibria give a film's transfer: nearest to a third and to two thirds of the largest; `None` of a single load.
    pub fn transfer_loads(&self) -> Option<[f64; 2]> {
        loads_of_transfer(&self.loads_n)
    }

    fn bare_pressings(&self, tire: &Scene) -> Vec<Pressing> {
        let mut pressings = self.over_loads(tire);
        pressings.extend(self.over_pressures());
        pressings.push(self.contact_at(0.0, tire));
        different(pressings)
    }

    fn coupled_pressings(&self, (position, _): Place, tire: &Scene) -> Vec<Pressing> {
        if self.films.contains(&FilmModel::Coupled) {
            let mut pressings = self.over_loads(tire);
            pressings.extend(self.over_pressures());
            pressings.extend(self.over_contact(tire));
            if position == Position::Crown {
                let pairs = self.pair_angles();
                pressings.extend(pairs.map(|angle| self.contact_at(angle, tire)));
            }
            different(pressings)
        } else if self.films.contains(&FilmModel::Transfer) {
            let loads = self.transfer_loads().into_iter().flatten();
            loads.map(|load| own_pressure(tire, load, 0.0)).collect()
        } else {
            Vec::new()
        }
    }

    fn pair_angles(&self) -> impl Iterator<Item = f64> {
        let around = |angle: &f64| [angle - PAIR_DEG, angle + PAIR_DEG];
        self.contact_deg.iter().flat_map(around)
    }

    /// The pressing at the tire's own pressure that is nearest to the load of the pressures, first.
    fn begun_in_the_middle(
        &self,
        film: Option<Place>,
        mut pressings: Vec<Pressing>,
        tire: &Scene,
    ) -> Series {
        let off = |pressing: &Pressing| {
            let other =
                pressing.pressure_mpa != tire.pressure.internal_mpa || pressing.contact_deg != 0.0;
            (other, (pressing.load_n - self.at_load_n).abs())
        };
        let nearest = pressings.iter().enumerate().min_by(|(_, a), (_, b)| {
            let [(a, a_off), (b, b_off)] = [off(a), off(b)];
            a.cmp(&b).then(a_off.total_cmp(&b_off))
        });
        if let Some((first, _)) = nearest {
            pressings.swap(0, first);
        }
        Series { film, pressings }
    }

    /// Films that read the bare tire: at each place, for each angle that some row or pair asks for.
    pub fn bare_films(&self) -> Vec<(Place, f64)> {
        let mut angles: Vec<f64> = vec![0.0];
        let contact = self.contact_deg.iter().copied().chain(self.pair_angles());
        for angle in contact.map(apart_deg) {
            if !angles.contains(&angle) {
                angles.push(angle);
            }
        }
        let places = self.places().into_iter();
        places
            .flat_map(|place| angles.iter().map(move |angle| (place, *angle)))
            .collect()
    }

    /// Returns what is read of a series' equilibria.
    pub fn readout(&self, series: &Series) -> Readout {
        if series.film.is_some() {
            return Readout::default();
        }
        let films = self.bare_films().into_iter();
        let gauge = |theta: i32| Gauge {
            theta_deg: f64::from(theta),
            phi_deg: 0.0,
            angle_deg: 0.0,
        };
        Readout {
            gauges: (-STRESS_DEG..=STRESS_DEG).map(gauge).collect(),
            films: films
                .map(|((position, direction), angle)| self.placed(position, direction, angle))
                .collect(),
            ..Readout::default()
        }
    }

    /// The scenes of a series.
    pub fn scenes(&self, tire: &Scene, series: &Series) -> Vec<Scene> {
        let pressed = |pressing: &Pressing| {
            let mut scene = tire.clone();
            scene.film = series.film.map(|(position, direction)| {
                self.placed(position, direction, pressing.contact_deg)
            });
            scene.ground.depths_mm.clear();
            scene.ground.load_n = Some(pressing.load_n);
            scene.pressure.internal_mpa = pressing.pressure_mpa;
            scene
        };
        series.pressings.iter().map(pressed).collect()
    }
}

/// The two loads nearest to a third and to two thirds of the largest; `None` of a single load.
pub fn loads_of_transfer(loads: &[f64]) -> Option<[f64; 2]> {
    let largest = loads.iter().copied().fold(0.0, f64::max);
    let nearest = |aim: f64, but: Option<f64>| {
        let others = loads.iter().copied().filter(|load| Some(*load) != but);
        others.min_by(|a, b| (a - aim).abs().total_cmp(&(b - aim).abs()))
    };
    let first = nearest(largest / 3.0, None)?;
    Some([first, nearest(2.0 * largest / 3.0, Some(first))?])
}

/// Numbers of those two loads.
pub fn numbers_of_transfer(loads: &[f64]) -> Option<[usize; 2]> {
    let number = |load: f64| loads.iter().position(|other| *other == load);
    let [first, second] = loads_of_transfer(loads)?;
    Some([number(first)?, number(second)?])
}

fn own_pressure(tire: &Scene, load_n: f64, contact_deg: f64) -> Pressing {
    Pressing {
        load_n,
        pressure_mpa: tire.pressure.internal_mpa,
        contact_deg,
    }
}

fn different(pressings: Vec<Pressing>) -> Vec<Pressing> {
    let mut kept: Vec<Pressing> = Vec::new();
    for pressing in pressings {
        if !kept.contains(&pressing) {
            kept.push(pressing);
        }
    }
    kept
}

#[cfg(test)]
mod tests {
    use super::*;

    fn defaults() -> (SignalSettings, Scene) {
        let tire = Scene::default();
        (SignalSettings::on(&tire), tire)
    }

    #[test]
    fn the_shipped_lists_are_solved_once_each() {
        let (settings, tire) = defaults();
        let series = settings.series(&tire);
        // 7 loads, and 2 pressures beside the tire's own; 6 angles beside 0, and 6 more of the pairs at the crown.
        let counts: Vec<usize> = series.iter().map(|series| series.pressings.len()).collect();
        assert_eq!(counts, [9, 21, 21, 15, 15, 15, 15]);
        for series in &series {
            let first = series.pressings[0];
            assert_eq!(
                (first.load_n, first.pressure_mpa, first.contact_deg),
                (10.0, 0.2, 0.0)
            );
            let scenes = settings.scenes(&tire, series);
            assert!(
                scenes
                    .iter()
                    .all(|scene| scene.film.is_some() == series.film.is_some())
            );
        }
        let angles: Vec<f64> = settings
            .bare_films()
            .iter()
            .map(|film| film.1)
            .take(13)
            .collect();
        assert!(
            (0..13).all(|k| angles.contains(&(5.0 * f64::from(k)))),
            "{angles:?}"
        );
    }

    #[test]
    fn a_transfer_alone_takes_two_loads_of_each_film() {
        let (mut settings, tire) = defaults();
        settings.films = vec![FilmModel::Transfer];
        let series = settings.series(&tire);
        assert_eq!(settings.transfer_loads(), Some([10.0, 20.0]));
        assert!(series[1..].iter().all(|series| series.pressings.len() == 2));
        settings.loads_n = vec![29.0, 30.0];
        assert_eq!(settings.transfer_loads(), Some([29.0, 30.0]));
        settings.loads_n = vec![30.0];
        assert_eq!(settings.transfer_loads(), None);
        settings.films = vec![FilmModel::Bare];
        assert_eq!(settings.series(&tire).len(), 1);
    }

    #[test]
    fn a_scene_of_a_series_is_one_that_the_reader_takes() {
        let (settings, tire) = defaults();
        for series in settings.series(&tire) {
            for scene in settings.scenes(&tire, &series) {
                assert_eq!(Scene::from_json(&scene.canonical_json()), Ok(scene));
            }
        }
    }

    #[test]
    fn angles_are_counted_the_short_way_round() {
        assert_eq!(
            [-30.0, 0.0, 200.0, -180.0, 360.0].map(apart_deg),
            [30.0, 0.0, 160.0, 180.0, 0.0]
        );
    }
}
