//! Films of a layout, and where they lie.

use fem_client::scene::Geometry;

use documents::layouts::film_extent::{FilmExtent, FilmPoint};
use documents::layouts::film_rings::ring_angles;
use documents::layouts::layout_settings::Layouts;

/// A kind of film: where it lies in the section, along which direction, and how large it is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FilmKind {
    /// Section angle from the crown, degrees.
    pub phi_deg: f64,
    /// Angle of its length to the circumferential direction, degrees: 0 is x, 90 is y.
    pub angle_deg: f64,
    /// Rectangle on the inner surface; none: the film reads the strain at a point.
    pub extent: Option<FilmExtent>,
    /// Reading of the mean strains under it.
    pub reads: FilmReads,
}

/// Reading of a film: what it makes of the bare wall's mean strains over its area.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum FilmReads {
    /// The one along it: it follows the wall and resists nothing.
    Strain,
    /// Volts of the open circuit by the strains along and across: it is glued on, with its stiffness. Nothing until the mesh's transfer is known.
    Volts([f64; 2]),
}

impl FilmReads {
    /// Returns what layouts' films read; volts come with each mesh's transfer.
    pub fn of(layouts: &Layouts) -> Self {
        match layouts.glued {
            Some(_) => Self::Volts([0.0; 2]),
            None => Self::Strain,
        }
    }

    /// Directions in which strains are read for a film in this direction, degrees, each with what a strain there is in its signal.
    pub fn directions(self, angle_deg: f64) -> Vec<(f64, f64)> {
        match self {
            Self::Strain => vec![(angle_deg, 1.0)],
            Self::Volts([along, across]) => {
                vec![
                    (angle_deg, along),
                    ((angle_deg + 90.0).rem_euclid(180.0), across),
                ]
            }
        }
    }
}

impl FilmKind {
    /// Makes a film that reads the strain at a point.
    pub fn point(phi_deg: f64, angle_deg: f64) -> Self {
        Self {
            phi_deg,
            angle_deg,
            extent: None,
            reads: FilmReads::Strain,
        }
    }

    /// Makes a film of this length and width, mm, on the inner surface of a tire; without a size a point.
    pub fn sized(
        geometry: &Geometry,
        size_mm: Option<[f64; 2]>,
        phi_deg: f64,
        angle_deg: f64,
    ) -> Self {
        let extent = |size| FilmExtent::on(geometry, size, phi_deg, angle_deg);
        Self {
            extent: size_mm.map(extent),
            ..Self::point(phi_deg, angle_deg)
        }
    }

    /// Returns the points where strains are read for it, with their shares in the mean.
    pub fn points(&self) -> Vec<FilmPoint> {
        let middle = || FilmPoint {
            share: 1.0,
            wheel_deg: 0.0,
            section_deg: self.phi_deg,
        };
        self.extent
            .map_or_else(|| vec![middle()], |extent| extent.points())
    }
}

/// A film of a layout.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LaidFilm {
    /// Wheel angle, degrees.
    pub theta_deg: f64,
    /// Number among the study's kinds.
    pub kind: usize,
}

/// Films around the wheel.
#[derive(Debug, Clone, PartialEq)]
pub struct Arrangement {
    /// The films.
    pub films: Vec<LaidFilm>,
    /// Period: the least turn, degrees, by which it is the same again; 360 where it has no such symmetry.
    pub period_deg: f64,
}

impl Arrangement {
    /// Units of one film of each kind at equal distances; `staggered` ones have their films spread evenly between two units.
    pub fn regular(units: usize, kinds: &[usize], staggered: bool) -> Self {
        let film = |(k, theta_deg): (usize, f64)| LaidFilm {
            theta_deg,
            kind: kinds[k],
        };
        Self {
            films: ring_angles(units, kinds.len(), staggered)
                .map(film)
                .collect(),
            period_deg: 360.0 / units as f64,
        }
    }

    /// Turns it from the mark, degrees.
    pub fn turned(mut self, turn_deg: f64) -> Self {
        for film in &mut self.films {
            film.theta_deg += turn_deg;
        }
        self
    }

    /// Films at any places.
    pub fn free(films: Vec<LaidFilm>) -> Self {
        Self {
            films,
            period_deg: 360.0,
        }
    }

    /// Returns the arrangement without one of its films. What is left has no symmetry.
    pub fn without(&self, film: usize) -> Self {
        let mut films = self.films.clone();
        films.remove(film);
        Self::free(films)
    }

    /// Counts those of its first films that are no image of another by its symmetry.
    pub(crate) fn different_films(&self) -> usize {
        let sectors = (360.0 / self.period_deg).round() as usize;
        self.films.len() / sectors.max(1)
    }

    /// Contact angles in one period, degrees: each in the middle of its share.
    pub fn contacts(&self, count: usize) -> impl Iterator<Item = f64> {
        let step = self.period_deg / count as f64;
        (0..count).map(move |c| (c as f64) * step)
    }

    /// Whole degrees in one period.
    pub fn degrees(&self) -> impl Iterator<Item = f64> + Clone {
        (0..self.period_deg.ceil() as usize).map(|degree| degree as f64)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_are_evenly_spaced_and_their_films_together_or_between() {
        let angles = |arrangement: Arrangement| -> Vec<f64> {
            arrangement
                .films
                .iter()
                .map(|film| film.theta_deg)
                .collect()
        };
        assert_eq!(
            angles(Arrangement::regular(3, &[0, 1], false)),
            [0.0, 0.0, 120.0, 120.0, 240.0, 240.0]
        );
        assert_eq!(
            angles(Arrangement::regular(2, &[0, 1], true)),
            [0.0, 90.0, 180.0, 270.0]
        );
        assert_eq!(Arrangement::regular(7, &[0], false).films.len(), 7);
    }

    #[test]
    fn one_film_less_has_no_symmetry() {
        let whole = Arrangement::regular(4, &[0, 1], false);
        assert_eq!((whole.period_deg, whole.different_films()), (90.0, 2));
        let rest = whole.without(1);
        assert_eq!(
            (rest.films.len(), rest.period_deg, rest.different_films()),
            (7, 360.0, 7)
        );
    }
}
