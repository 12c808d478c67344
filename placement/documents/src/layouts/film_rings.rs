//! Rings of films: the regular layouts of a study, those that it names and those of the menu.

use crate::layouts::layout_settings::Layouts;
use crate::parts::directions::Directions;
use crate::parts::film_place::FilmPlace;

/// Units of films at equal distances around the wheel.
#[derive(Debug, Clone, PartialEq)]
pub struct Ring {
    /// Number of units.
    pub units: usize,
    /// Section angle from the crown, degrees.
    pub section_deg: f64,
    /// Directions of the films of a unit, degrees to the circumference.
    pub directions: Vec<f64>,
    /// Whether the films of a unit are spread evenly between two units.
    pub staggered: bool,
    /// Whether the menu offers it: the document names no units.
    pub of_menu: bool,
}

/// Wheel angles of films of some units, degrees, unit after unit, with the film's number in its unit; staggered, those of a unit are spread evenly up to the next one.
pub fn ring_angles(
    units: usize,
    films: usize,
    staggered: bool,
) -> impl Iterator<Item = (usize, f64)> {
    let spacing = 360.0 / units as f64;
    let offset = move |film: usize| match staggered {
        true => spacing * film as f64 / films as f64,
        false => 0.0,
    };
    let of_unit =
        move |unit| (0..films).map(move |film| (film, unit as f64 * spacing + offset(film)));
    (0..units).flat_map(of_unit)
}

impl Ring {
    /// Number of films.
    pub fn films(&self) -> usize {
        self.units * self.directions.len()
    }

    /// The films of its first units, one by one.
    pub fn places(&self, units: usize) -> Vec<FilmPlace> {
        let of_unit = self.directions.len();
        let angles = ring_angles(self.units, of_unit, self.staggered);
        let place = |(film, theta_deg): (usize, f64)| {
            self.directions.get(film).map(|angle_deg| FilmPlace {
                theta_deg,
                phi_deg: self.section_deg,
                angle_deg: *angle_deg,
            })
        };
        angles.take(units * of_unit).filter_map(place).collect()
    }

    /// Whether both lay the same films.
    fn is_same(&self, other: &Self) -> bool {
        let Self {
            units,
            section_deg,
            directions,
            staggered,
            of_menu: _,
        } = other;
        (self.units, self.section_deg, self.staggered) == (*units, *section_deg, *staggered)
            && self.directions == *directions
    }
}

impl Layouts {
    /// All rings, each once: at every section angle those of each set of directions, and then those of the menu.
    pub fn rings(&self, asked: Directions) -> Vec<Ring> {
        let mut rings: Vec<Ring> = Vec::new();
        let mut add = |ring: Ring| {
            if !rings.iter().any(|known| known.is_same(&ring)) {
                rings.push(ring);
            }
        };
        for section_deg in self.sections_deg() {
            let ring = |directions: &[f64], units, staggered, of_menu| Ring {
                units,
                section_deg,
                directions: directions.to_vec(),
                staggered,
                of_menu,
            };
            for set in self.sets(asked) {
                for units in self.unit_counts() {
                    add(ring(&set, units, false, false));
                    if self.staggered && set.len() > 1 {
                        add(ring(&set, units, true, false));
                    }
                }
            }
            for set in self.menu_sets(asked) {
                let whole = self.films.iter().filter(|films| *films % set.len() == 0);
                for units in whole.map(|films| films / set.len()) {
                    add(ring(&set, units, false, true));
                    if set.len() > 1 {
                        add(ring(&set, units, true, true));
                    }
                }
            }
        }
        rings
    }

    /// Sets of directions of the menu: those that the document names; else each direction that the study asks for, and all of them together.
    fn menu_sets(&self, asked: Directions) -> Vec<Vec<f64>> {
        let named = self.sets(asked);
        if !self.directions.is_empty() {
            return named;
        }
        let all = named.concat();
        let mut sets: Vec<Vec<f64>> = all.iter().map(|angle| vec![*angle]).collect();
        if all.len() > 1 {
            sets.push(all);
        }
        sets
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_common_menu_has_x_y_both_and_both_in_turn_at_three_sections() {
        let rings = Layouts::default().rings(Directions::Both);
        assert!(rings.iter().all(|ring| ring.of_menu));
        // 14 numbers of films of one direction, 11 even ones of both.
        assert_eq!(rings.len(), 3 * (14 + 14 + 2 * 11));
        let twelve = rings.iter().filter(|ring| ring.films() == 12);
        let told: Vec<_> = twelve
            .filter(|ring| ring.section_deg == 0.0)
            .map(|ring| (ring.units, ring.directions.len(), ring.staggered))
            .collect();
        assert_eq!(
            told,
            [(12, 1, false), (12, 1, false), (6, 2, false), (6, 2, true)]
        );
        let of_y = Layouts::default().rings(Directions::Y);
        assert_eq!(of_y.len(), 3 * 14);
    }

    #[test]
    fn a_ring_that_is_named_is_not_of_the_menu() {
        let layouts = Layouts {
            units: vec![12],
            films: vec![12, 5],
            directions: vec![vec![90.0]],
            ..Layouts::default()
        };
        let rings = layouts.rings(Directions::Both);
        let at_crown = rings.iter().filter(|ring| ring.section_deg == 0.0);
        let told: Vec<_> = at_crown.map(|ring| (ring.units, ring.of_menu)).collect();
        assert_eq!(told, [(12, false), (5, true)]);
    }

    #[test]
    fn films_of_a_unit_lie_together_or_in_turn() {
        let ring = |staggered| Ring {
            units: 3,
            section_deg: 45.0,
            directions: vec![0.0, 90.0],
            staggered,
            of_menu: false,
        };
        let angles = |staggered| -> Vec<f64> {
            let films = ring(staggered).places(2);
            films.iter().map(|film| film.theta_deg).collect()
        };
        assert_eq!(angles(false), [0.0, 0.0, 120.0, 120.0]);
        assert_eq!(angles(true), [0.0, 60.0, 120.0, 180.0]);
        assert_eq!(ring(true).places(9).len(), 6);
    }
}
