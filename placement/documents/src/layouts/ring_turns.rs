//! Rings turned to where their films keep clear of what a tire has already.

use crate::layouts::film_rings::Ring;
use crate::layouts::film_room::FilmRoom;
use crate::layouts::gluing_limits::GluingLimits;
use crate::parts::film_place::FilmPlace;

/// Turns that are tried within the angle of a unit, besides those onto films that are glued on already.
const TURNS: usize = 24;

/// A ring as it is glued.
#[derive(Debug, Clone, PartialEq)]
pub struct GluedRing {
    /// Angle by which it is turned from the mark, degrees.
    pub turn_deg: f64,
    /// Films of the ring that keep clear of what is there, without those that are there already.
    pub films: Vec<FilmPlace>,
    /// Films of the ring that are glued on already.
    pub met: usize,
}

impl Ring {
    /// Turns the ring so that as many of its films as possible keep clear, and leaves out those that don't; of such turns to the one that meets most films which are there, and the smallest.
    pub fn glued(&self, room: &FilmRoom, limits: &GluingLimits) -> GluedRing {
        let at = |turn_deg| self.turned(turn_deg, room, limits);
        let mut best = at(0.0);
        for turn_deg in self.turns_deg(limits) {
            let is_clear = best.films.len() == self.films();
            if is_clear && limits.taken.is_empty() {
                break;
            }
            let kept = |ring: &GluedRing| (ring.films.len() + ring.met, ring.met);
            let turned = at(turn_deg);
            if kept(&turned) > kept(&best) {
                best = turned;
            }
        }
        best
    }

    fn turned(&self, turn_deg: f64, room: &FilmRoom, limits: &GluingLimits) -> GluedRing {
        let mut films = self.places(self.units);
        for film in &mut films {
            film.theta_deg = (film.theta_deg + turn_deg).rem_euclid(360.0);
        }
        let all = films.len();
        let is_new = |film: &FilmPlace| !limits.taken.iter().any(|taken| taken.is_same(film));
        films.retain(is_new);
        let met = all - films.len();
        films.retain(|film| {
            room.keeps_out(film, &limits.forbidden_deg)
                && limits.taken.iter().all(|taken| room.has_both(taken, film))
        });
        GluedRing {
            turn_deg: turn_deg.rem_euclid(360.0 / self.units as f64),
            films,
            met,
        }
    }

    /// Turns that move it to other places, the smallest first, in front of each other.
    fn turns_deg(&self, limits: &GluingLimits) -> Vec<f64> {
        let unit_deg = 360.0 / self.units as f64;
        let within = |turn: f64| (turn + 0.5 * unit_deg).rem_euclid(unit_deg) - 0.5 * unit_deg;
        let of_unit = self.places(1);
        let onto = limits.taken.iter().flat_map(|taken| {
            let alike = of_unit.iter().filter(|film| {
                let moved = FilmPlace {
                    theta_deg: taken.theta_deg,
                    ..**film
                };
                moved.is_same(taken)
            });
            alike.map(|film| within(taken.theta_deg - film.theta_deg))
        });
        let steps = (1..TURNS).map(|k| within(unit_deg * k as f64 / TURNS as f64));
        let mut turns: Vec<f64> = onto.chain(steps).collect();
        turns.sort_by(|a, b| a.abs().total_cmp(&b.abs()).then(b.total_cmp(a)));
        turns
    }
}

#[cfg(test)]
mod tests {
    use fem_client::scene::Geometry;

    use super::*;

    fn ring(units: usize) -> Ring {
        Ring {
            units,
            section_deg: 0.0,
            directions: vec![90.0],
            staggered: false,
            of_menu: true,
        }
    }

    fn glued(units: usize, limits: &GluingLimits) -> GluedRing {
        let room = FilmRoom::on(&Geometry::default(), Some([10.0, 5.0]), 0.0);
        ring(units).glued(&room, limits)
    }

    fn y_at(theta_deg: f64) -> FilmPlace {
        FilmPlace {
            theta_deg,
            phi_deg: 0.0,
            angle_deg: 90.0,
        }
    }

    #[test]
    fn a_ring_that_is_clear_stays_and_one_at_a_valve_is_turned() {
        let none = GluingLimits::default();
        assert_eq!(glued(12, &none).turn_deg, 0.0);
        let valve = GluingLimits {
            forbidden_deg: vec![[355.0, 5.0]],
            ..none
        };
        let turned = glued(12, &valve);
        // Half of 5 mm is 3.05 degrees of the crown's 47 mm: 8.05 degrees off the valve, and steps are 1.25 degrees.
        assert_eq!(
            (turned.turn_deg, turned.films.len(), turned.met),
            (8.75, 12, 0)
        );
    }

    #[test]
    fn a_dense_ring_leaves_a_gap_at_the_valve() {
        let valve = GluingLimits {
            forbidden_deg: vec![[345.0, 15.0]],
            ..GluingLimits::default()
        };
        let turned = glued(24, &valve);
        // 36.1 degrees are barred: two of 15 degrees, or three.
        assert_eq!(turned.films.len(), 22);
        assert_eq!(turned.films.len(), brute_force(24, &valve));
    }

    #[test]
    fn a_ring_meets_films_that_are_glued_on_and_keeps_off_others() {
        let ring_of = |taken: Vec<FilmPlace>| {
            let limits = GluingLimits {
                taken,
                ..GluingLimits::default()
            };
            glued(12, &limits)
        };
        let met = ring_of(vec![y_at(7.0), y_at(37.0)]);
        assert_eq!((met.turn_deg, met.films.len(), met.met), (7.0, 10, 2));
        // Along x it is 10 mm long: 12.2 degrees, and 9.1 from the middle of one that crosses its end.
        let crossing = FilmPlace {
            angle_deg: 0.0,
            ..y_at(7.0)
        };
        let off = ring_of(vec![crossing]);
        assert_eq!((off.films.len(), off.met), (12, 0));
        assert!(off.films.iter().all(|film| {
            let apart = (film.theta_deg - 7.0 + 180.0).rem_euclid(360.0) - 180.0;
            apart.abs() >= (7.5f64 / 47.0).to_degrees()
        }));
    }

    /// The most films that keep out at any turn of a tenth of a degree.
    fn brute_force(units: usize, limits: &GluingLimits) -> usize {
        let room = FilmRoom::on(&Geometry::default(), Some([10.0, 5.0]), 0.0);
        let turns = (0..3600).map(|tenth| f64::from(tenth) / 10.0);
        let kept = turns.map(|turn| ring(units).turned(turn, &room, limits).films.len());
        kept.max().unwrap_or(0)
    }
}
