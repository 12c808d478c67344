//! Layouts and kinds of film that a document asks for.

use fem_client::scene::Geometry;

use crate::arrangement::{Arrangement, FilmKind, FilmReads, LaidFilm};
use crate::search::search_films::{Conflicts, SearchFilms};
use documents::layouts::film_extent::FilmExtent;
use documents::layouts::film_rings::Ring;
use documents::layouts::film_room::FilmRoom;
use documents::layouts::gluing_limits::GluingLimits;
use documents::layouts::layout_settings::{
    FreeLayout, Layouts, SearchSettings, direction_name, farthest_section_deg, section_name,
};
use documents::layouts::ring_turns::GluedRing;
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

    /// The number of the layouts' kind of film there, where a layout has one.
    pub fn known(&self, phi_deg: f64, angle_deg: f64) -> Option<usize> {
        let kind = self.of_size(self.size_mm, phi_deg, angle_deg);
        self.all.iter().position(|known| *known == kind)
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
    fn have_room(&self, ring: &Ring, room: &FilmRoom) -> bool {
        let farthest = farthest_section_deg(&self.geometry);
        let fits = |size, angle| {
            FilmExtent::on(&self.geometry, size, ring.section_deg, angle).fits(farthest)
        };
        let fit = |angle: &f64| self.size_mm.is_none_or(|size| fits(size, *angle));
        ring.directions.iter().all(fit) && room.crowded(&ring.places(2)).is_none()
    }

    /// The film at a place, whose kind is added where it is new.
    fn film(&mut self, place: &FilmPlace) -> LaidFilm {
        LaidFilm {
            theta_deg: place.theta_deg,
            kind: self.laid(place.phi_deg, place.angle_deg),
        }
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
    let room = FilmRoom::on(
        &kinds.geometry,
        kinds.size_mm,
        settings.limits.least_distance_mm,
    );
    for ring in settings.rings(directions) {
        let glued = ring.glued(&room, &settings.limits);
        let is_laid = !ring.of_menu || kinds.have_room(&ring, &room);
        if !is_laid || glued.films.is_empty() && glued.met == 0 {
            without_room += 1;
        } else if glued.films.len() == ring.films() && settings.limits.taken.is_empty() {
            layouts.push(regular(&ring, glued.turn_deg, kinds));
        } else {
            layouts.push(beside(&ring, &glued, &settings.limits.taken, kinds));
        }
    }
    layouts.extend(settings.free.iter().map(|layout| free(layout, kinds)));
    (layouts, without_room)
}

fn regular(ring: &Ring, turn_deg: f64, kinds: &mut Kinds) -> AskedLayout {
    let of_unit: Vec<usize> = ring
        .directions
        .iter()
        .map(|&angle_deg| kinds.laid(ring.section_deg, angle_deg))
        .collect();
    let directions = ring.directions.iter();
    AskedLayout {
        arrangement: Arrangement::regular(ring.units, &of_unit, ring.staggered).turned(turn_deg),
        label: RankedLayout {
            spacing_deg: Some(360.0 / ring.units as f64),
            turn_deg: (turn_deg > 0.0).then_some(turn_deg),
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

/// A ring beside films that are glued on already, or without those of its films that have no place.
fn beside(ring: &Ring, glued: &GluedRing, taken: &[FilmPlace], kinds: &mut Kinds) -> AskedLayout {
    let mut name = format!("{} of a ring of {}", glued.films.len(), ring.films());
    if ring.staggered {
        name.push_str(" in turn");
    }
    if !taken.is_empty() {
        name.push_str(&format!(", and {} glued on already", taken.len()));
    }
    let films = taken.iter().chain(&glued.films);
    let films = films.map(|place| kinds.film(place)).collect();
    let mut layout = listed(name, films, kinds);
    // In the order of the ring's, whichever film is left out.
    layout.label.films.sort();
    layout.of_menu = ring.of_menu;
    layout
}

/// A layout film by film, whose kinds are added where they are new.
pub fn free(layout: &FreeLayout, kinds: &mut Kinds) -> AskedLayout {
    let films = layout.films.iter().map(|place| kinds.film(place));
    let films = films.collect();
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

/// The films that a search chooses from: those that are glued on, then every direction at every section angle at every slot where a film may lie beside those.
pub fn search_films(
    search: &SearchSettings,
    limits: &GluingLimits,
    kinds: &mut Kinds,
) -> SearchFilms {
    let room = FilmRoom::on(&kinds.geometry, kinds.size_mm, limits.least_distance_mm);
    let is_free = |place: &FilmPlace| {
        room.keeps_out(place, &limits.forbidden_deg)
            && limits.taken.iter().all(|taken| room.has_both(taken, place))
            && !limits.taken.iter().any(|taken| taken.is_same(place))
    };
    let mut places = limits.taken.clone();
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
    SearchFilms {
        films: places.iter().map(|place| kinds.film(place)).collect(),
        fixed: limits.taken.len(),
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

    /// Every pair of films of every layout, and each film with every sector.
    #[test]
    fn nothing_on_the_menu_lies_where_it_may_not() {
        let taken = [(0.0, 90.0), (100.0, 0.0)].map(|(theta_deg, angle_deg)| FilmPlace {
            theta_deg,
            phi_deg: 0.0,
            angle_deg,
        });
        let limits = GluingLimits {
            taken: taken.to_vec(),
            forbidden_deg: vec![[170.0, 190.0]],
            least_distance_mm: 6.0,
        };
        let settings = Layouts {
            limits: limits.clone(),
            ..Layouts::default()
        };
        let size = Some([10.0, 5.0]);
        let mut kinds = Kinds::of_crown(&Geometry::default(), size, FilmReads::Strain);
        let (layouts, without_room) = asked_layouts(&settings, Directions::Both, &mut kinds);
        // 14 rings of each direction at three sections and the 11 in turn, but for those that are too dense; pairs in one place are nearer than 6 mm.
        assert_eq!(layouts.len() + without_room, 150);
        // 33 pairs in one place have no room, and at most half of the rest.
        assert!(layouts.len() > 117 / 2, "{}", layouts.len());
        let room = FilmRoom::on(&Geometry::default(), size, 6.0);
        for layout in &layouts {
            let places: Vec<FilmPlace> = layout
                .arrangement
                .films
                .iter()
                .map(|film| kinds.place(film))
                .collect();
            assert_eq!(places, layout.label.places);
            assert!(layout.of_menu && places.starts_with(&taken));
            assert_eq!(room.crowded(&places), None, "{:?}", layout.label.name);
            let mut new = places[2..].iter();
            assert!(new.all(|film| room.keeps_out(film, &limits.forbidden_deg)));
        }
        // A ring along y meets the one that is there: 12 films are 11 new ones and two, less the one at the valve and the one at 100 degrees.
        let twelve = layouts.iter().find(|layout| {
            layout.label.name.as_deref().is_some_and(|name| {
                name.contains("ring of 12,") && layout.label.position == "crown"
            })
        });
        let name = twelve.and_then(|layout| layout.label.name.clone());
        assert_eq!(
            name.as_deref(),
            Some("10 of a ring of 12, and 2 glued on already")
        );
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
