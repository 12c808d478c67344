//! Layouts and kinds of film that a document asks for.

use fem_client::scene::Geometry;

use crate::arrangement::{Arrangement, FilmKind, FilmReads, LaidFilm};
use crate::search::search_films::{Conflicts, SearchFilms};
use documents::layouts::film_extent::FilmExtent;
use documents::layouts::film_rings::Ring;
use documents::layouts::film_room::FilmRoom;
use documents::layouts::layout_settings::{
    FreeLayout, Layouts, SearchSettings, direction_name, farthest_section_deg, section_name,
};
use documents::parts::directions::Directions;
use documents::parts::film_place::FilmPlace;
use results::RankedLayout;

/// Distance of the candidates' section angles, degrees.
const SECTION_STEP_DEG: f64 = 15.0;

/// Kinds of film on a tire, each once; a layout's films name them by number.
#[derive(Debug, Clone, PartialEq)]
pub struct Kinds {
    all: Vec<FilmKind>,
    geometry: Geometry,
    /// Length and width of the layouts' films, mm; none: points.
    size_mm: Option<[f64; 2]>,
    reads: FilmReads,
}

/// A layout to be scored.
#[derive(Debug, Clone, PartialEq)]
pub struct AskedLayout {
    /// Films of the layout.
    pub arrangement: Arrangement,
    /// Row of the layout in the answer, without scores.
    pub label: RankedLayout,
    /// Whether the menu offers it: it is simulated only where it may be the best of as few films.
    pub of_menu: bool,
}

impl Kinds {
    /// The two of the crown, whose signals set the noise: points, so that films of any size have the same, unless they are glued. Layouts have films of this length
    /// and width on this tire, mm, that read this.
    pub fn of_crown(geometry: &Geometry, size_mm: Option<[f64; 2]>, reads: FilmReads) -> Self {
        let mut kinds = Self {
            all: Vec::new(),
            geometry: geometry.clone(),
            size_mm,
            reads,
        };
        kinds.all = [0.0, 90.0]
            .map(|angle| match reads {
                FilmReads::Strain => FilmKind::point(0.0, angle),
                FilmReads::Volts(_) => kinds.of_size(size_mm, 0.0, angle),
            })
            .to_vec();
        kinds
    }

    /// Returns all kinds.
    pub fn all(&self) -> &[FilmKind] {
        &self.all
    }

    /// The number of the layouts' kind of film at a section angle along a direction, degrees.
    pub fn laid(&mut self, phi_deg: f64, angle_deg: f64) -> usize {
        let kind = self.of_size(self.size_mm, phi_deg, angle_deg);
        self.number(kind)
    }

    /// Whether a kind is one of the layouts' own films: of their size.
    pub fn is_laid(&self, kind: usize) -> bool {
        let FilmKind {
            phi_deg, angle_deg, ..
        } = self.all[kind];
        self.all[kind] == self.of_size(self.size_mm, phi_deg, angle_deg)
    }

    fn of_size(&self, size_mm: Option<[f64; 2]>, phi_deg: f64, angle_deg: f64) -> FilmKind {
        FilmKind {
            reads: self.reads,
            ..FilmKind::sized(&self.geometry, size_mm, phi_deg, angle_deg)
        }
    }

    /// The number of a kind, which is added where it is new.
    fn number(&mut self, kind: FilmKind) -> usize {
        self.all
            .iter()
            .position(|known| *known == kind)
            .unwrap_or_else(|| {
                self.all.push(kind);
                self.all.len() - 1
            })
    }

    /// Whether a ring's films fit in the section and beside each other.
    fn have_room(&self, ring: &Ring) -> bool {
        let Some(size_mm) = self.size_mm else {
            return true;
        };
        let farthest = farthest_section_deg(&self.geometry);
        let extent = |angle| FilmExtent::on(&self.geometry, size_mm, ring.section_deg, angle);
        let room = FilmRoom::on(&self.geometry, self.size_mm, 0.0);
        let mut directions = ring.directions.iter();
        directions.all(|angle| extent(*angle).fits(farthest))
            && room.crowded(&ring.places(2)).is_none()
    }

    /// Returns the place of a film.
    pub fn place(&self, film: &LaidFilm) -> FilmPlace {
        let kind = self.all[film.kind];
        FilmPlace {
            theta_deg: film.theta_deg,
            phi_deg: kind.phi_deg,
            angle_deg: kind.angle_deg,
        }
    }

    /// Adds those that are compared as candidates: x and y every 15 degrees up to an angle off the crown, degrees, of the layouts' size and of others, mm,
    /// where they reach no farther. Of glued films those that there are: each further one would take two solves more.
    pub fn candidates(&mut self, farthest_deg: f64, sizes_mm: &[[f64; 2]]) -> Vec<usize> {
        if self.reads != FilmReads::Strain {
            return (0..self.all.len()).collect();
        }
        let mut sizes = vec![self.size_mm];
        sizes.extend(sizes_mm.iter().map(|size| Some(*size)));
        let sections = (0..)
            .map(|k| f64::from(k) * SECTION_STEP_DEG)
            .take_while(|section| *section <= farthest_deg);
        let mut numbers = Vec::new();
        for phi_deg in sections {
            for angle_deg in [0.0, 90.0] {
                for size in &sizes {
                    let kind = self.of_size(*size, phi_deg, angle_deg);
                    let fits = kind.extent.is_none_or(|extent| extent.fits(farthest_deg));
                    let number = fits.then(|| self.number(kind));
                    numbers.extend(number.filter(|number| !numbers.contains(number)));
                }
            }
        }
        numbers
    }
}

/// Every layout that a study asks for, in the order of its document, and the number of those on its menu whose films have no room.
pub fn asked_layouts(
    settings: &Layouts,
    directions: Directions,
    kinds: &mut Kinds,
) -> (Vec<AskedLayout>, usize) {
    let mut layouts = Vec::new();
    let mut without_room = 0;
    for ring in settings.rings(directions) {
        if ring.of_menu && !kinds.have_room(&ring) {
            without_room += 1;
        } else {
            layouts.push(regular(&ring, kinds));
        }
    }
    layouts.extend(settings.free.iter().map(|layout| free(layout, kinds)));
    (layouts, without_room)
}

fn regular(ring: &Ring, kinds: &mut Kinds) -> AskedLayout {
    let of_unit: Vec<usize> = ring
        .directions
        .iter()
        .map(|&angle_deg| kinds.laid(ring.section_deg, angle_deg))
        .collect();
    let directions = ring.directions.iter();
    AskedLayout {
        arrangement: Arrangement::regular(ring.units, &of_unit, ring.staggered),
        label: RankedLayout {
            spacing_deg: Some(360.0 / ring.units as f64),
            units: ring.units,
            position: section_name(ring.section_deg),
            films: directions.map(|angle| direction_name(*angle)).collect(),
            staggered: ring.staggered,
            film_count: ring.films(),
            ..RankedLayout::default()
        },
        of_menu: ring.of_menu,
    }
}

/// A layout film by film, whose kinds are added where they are new.
pub fn free(layout: &FreeLayout, kinds: &mut Kinds) -> AskedLayout {
    let film = |place: &FilmPlace| LaidFilm {
        theta_deg: place.theta_deg,
        kind: kinds.laid(place.phi_deg, place.angle_deg),
    };
    let films = layout.films.iter().map(film).collect();
    listed(layout.name.clone(), films, kinds)
}

/// A layout without units, film by film.
pub fn listed(name: String, films: Vec<LaidFilm>, kinds: &Kinds) -> AskedLayout {
    let places: Vec<FilmPlace> = films.iter().map(|film| kinds.place(film)).collect();
    let section = places.first().map(|place| place.phi_deg);
    let position =
        match section.filter(|section| places.iter().all(|place| place.phi_deg == *section)) {
            Some(section) => section_name(section),
            None => "mixed".to_owned(),
        };
    let mut directions: Vec<String> = Vec::new();
    for direction in places.iter().map(|place| direction_name(place.angle_deg)) {
        if !directions.contains(&direction) {
            directions.push(direction);
        }
    }
    AskedLayout {
        arrangement: Arrangement::free(films),
        label: RankedLayout {
            name: Some(name),
            units: places.len(),
            position,
            films: directions,
            film_count: places.len(),
            places,
            ..RankedLayout::default()
        },
        of_menu: false,
    }
}

/// The films that a search chooses from: those that are fixed, then every direction at every section angle at every slot where a film may lie beside those.
pub fn search_films(search: &SearchSettings, kinds: &mut Kinds) -> SearchFilms {
    let room = FilmRoom::on(&kinds.geometry, kinds.size_mm, search.least_distance_mm);
    let is_free = |place: &FilmPlace| {
        room.keeps_out(place, &search.forbidden_deg)
            && search.fixed.iter().all(|fixed| room.has_both(fixed, place))
    };
    let mut places = search.fixed.clone();
    for slot in 0..search.slots {
        let theta_deg = slot as f64 * 360.0 / search.slots as f64;
        for &phi_deg in &search.section_deg {
            for &angle_deg in &search.directions {
                let place = FilmPlace {
                    theta_deg,
                    phi_deg,
                    angle_deg,
                };
                places.extend(Some(place).filter(is_free));
            }
        }
    }
    let laid = |place: &FilmPlace| LaidFilm {
        theta_deg: place.theta_deg,
        kind: kinds.laid(place.phi_deg, place.angle_deg),
    };
    SearchFilms {
        films: places.iter().map(laid).collect(),
        fixed: search.fixed.len(),
        conflicts: Conflicts::of(places.len(), |one, other| {
            !room.has_both(&places[one], &places[other])
        }),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_default_document_asks_for_the_common_menu() {
        let asked = |size_mm| {
            let mut kinds = Kinds::of_crown(&Geometry::default(), size_mm, FilmReads::Strain);
            let asked = asked_layouts(&Layouts::default(), Directions::Both, &mut kinds);
            (asked, kinds.all().len())
        };
        let ((layouts, without_room), kinds) = asked(None);
        assert_eq!((layouts.len(), without_room, kinds), (150, 0, 6));
        assert_eq!(
            (layouts[0].label.units, layouts[0].label.film_count),
            (3, 3)
        );
        assert_eq!(layouts[149].label.position, "sidewall");
        assert!(layouts.iter().all(|layout| layout.of_menu));
        // 25 mm of the crown's 295: 11 films along x at most, 29 along y of 10 mm width.
        let ((layouts, without_room), _) = asked(Some([25.0, 10.0]));
        let most = |films: &[&str], position: &str| {
            let counts = layouts
                .iter()
                .filter(|layout| layout.label.films == films && layout.label.position == position)
                .map(|layout| layout.label.units);
            counts.max()
        };
        assert_eq!(
            (most(&["x"], "crown"), most(&["y"], "crown")),
            (Some(10), Some(24))
        );
        assert_eq!(layouts.len() + without_room, 150);
    }

    #[test]
    fn sets_staggered_and_free_ones_are_named() {
        let settings = Layouts {
            films: Vec::new(),
            units: vec![6],
            positions: Vec::new(),
            section_deg: vec![30.0],
            directions: vec![vec![0.0, 90.0], vec![45.0]],
            staggered: true,
            free: vec![FreeLayout {
                name: "mine".to_owned(),
                films: vec![
                    FilmPlace {
                        theta_deg: 0.0,
                        phi_deg: 0.0,
                        angle_deg: 0.0,
                    },
                    FilmPlace {
                        theta_deg: 10.0,
                        phi_deg: -20.0,
                        angle_deg: 90.0,
                    },
                ],
            }],
            ..Layouts::default()
        };
        let mut kinds = Kinds::of_crown(&Geometry::default(), None, FilmReads::Strain);
        let (layouts, _) = asked_layouts(&settings, Directions::Both, &mut kinds);
        let shown: Vec<(String, Vec<String>, bool, usize)> = layouts
            .iter()
            .map(|layout| {
                (
                    layout.label.position.clone(),
                    layout.label.films.clone(),
                    layout.label.staggered,
                    layout.label.film_count,
                )
            })
            .collect();
        let texts = |names: &[&str]| -> Vec<String> {
            names.iter().map(|name| (*name).to_owned()).collect()
        };
        assert_eq!(
            shown,
            [
                ("30 deg".to_owned(), texts(&["x", "y"]), false, 12),
                ("30 deg".to_owned(), texts(&["x", "y"]), true, 12),
                ("30 deg".to_owned(), texts(&["45"]), false, 6),
                ("mixed".to_owned(), texts(&["x", "y"]), false, 2),
            ]
        );
        // Crown x and y, three at 30 degrees, and y at -20.
        assert_eq!(kinds.all().len(), 6);
    }
}
