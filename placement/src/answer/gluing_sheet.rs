//! The sheet to glue by: every film of the answer with its distances on the inner surface.

use documents::layouts::film_rings::Ring;
use documents::layouts::film_room::FilmRoom;
use documents::layouts::layout_settings::{direction_name, direction_of, section_of};
use documents::parts::film_place::FilmPlace;
use fem_client::scene::Geometry;
use results::{RankedLayout, SheetFilm};

/// Films of a layout in the order of their angles; empty where the layout doesn't say where they lie.
pub(super) fn sheet(
    layout: &RankedLayout,
    geometry: &Geometry,
    size_mm: Option<[f64; 2]>,
) -> Vec<SheetFilm> {
    let room = FilmRoom::on(geometry, size_mm, 0.0);
    let mut places = places(layout).unwrap_or_default();
    for place in &mut places {
        place.theta_deg = place.theta_deg.rem_euclid(360.0);
    }
    places.sort_by(|a, b| a.theta_deg.total_cmp(&b.theta_deg));
    let film = |(k, place): (usize, &FilmPlace)| {
        let marks = room.marks(place);
        SheetFilm {
            number: k + 1,
            theta_deg: place.theta_deg,
            arc_mm: marks.arc_mm,
            circle_mm: marks.circle_mm,
            phi_deg: place.phi_deg,
            from_bead_mm: marks.from_bead_mm,
            from_crown_mm: marks.from_crown_mm,
            direction: direction_name(place.angle_deg),
            length_mm: size_mm.map(|size| size[0]),
            width_mm: size_mm.map(|size| size[1]),
        }
    };
    places.iter().enumerate().map(film).collect()
}

/// Returns where a layout's films lie: those of its units, or its own list.
fn places(layout: &RankedLayout) -> Option<Vec<FilmPlace>> {
    if layout.spacing_deg.is_none() {
        return Some(layout.places.clone());
    }
    let directions: Option<Vec<f64>> = layout.films.iter().map(|film| direction_of(film)).collect();
    let ring = Ring {
        units: layout.units,
        section_deg: section_of(&layout.position)?,
        directions: directions?,
        staggered: layout.staggered,
        of_menu: false,
    };
    let mut places = ring.places(layout.units);
    for place in &mut places {
        place.theta_deg += layout.turn_deg.unwrap_or_default();
    }
    Some(places)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ring(position: &str, staggered: bool) -> RankedLayout {
        RankedLayout {
            spacing_deg: Some(60.0),
            units: 6,
            position: position.to_owned(),
            films: vec!["x".to_owned(), "y".to_owned()],
            film_count: 12,
            staggered,
            ..RankedLayout::default()
        }
    }

    /// Inner surface of the reference tire: 47 mm at the crown, and 37.5 + 9.5 cos(phi) off it; the bead is 120 degrees from the crown.
    #[test]
    fn arcs_are_angles_times_radii() {
        let at = |position: &str, phi: f64| {
            let films = sheet(
                &ring(position, true),
                &Geometry::default(),
                Some([10.0, 5.0]),
            );
            assert_eq!(films.len(), 12);
            let radius = 37.5 + 9.5 * phi.to_radians().cos();
            for (k, film) in films.iter().enumerate() {
                assert_eq!((film.number, film.theta_deg), (k + 1, 30.0 * k as f64));
                assert!((film.arc_mm - film.theta_deg.to_radians() * radius).abs() < 1e-9);
                assert!((film.from_bead_mm - 9.5 * (120.0 - phi).to_radians()).abs() < 1e-9);
                assert_eq!((film.length_mm, film.width_mm), (Some(10.0), Some(5.0)));
                assert!((film.circle_mm - 360f64.to_radians() * radius).abs() < 1e-9);
                assert!((film.from_crown_mm - 9.5 * phi.to_radians()).abs() < 1e-9);
            }
            assert_eq!([&*films[0].direction, &*films[1].direction], ["x", "y"]);
        };
        at("crown", 0.0);
        at("shoulder", 45.0);
        at("30 deg", 30.0);
    }

    #[test]
    fn a_ring_that_is_turned_starts_off_the_mark() {
        let turned = RankedLayout {
            turn_deg: Some(8.75),
            ..ring("crown", true)
        };
        let films = sheet(&turned, &Geometry::default(), None);
        assert_eq!((films[0].theta_deg, films[11].theta_deg), (8.75, 338.75));
    }

    #[test]
    fn films_on_the_other_side_are_told_from_the_nearer_bead() {
        let layout = RankedLayout {
            places: vec![FilmPlace {
                theta_deg: -10.0,
                phi_deg: -45.0,
                angle_deg: 30.0,
            }],
            ..RankedLayout::default()
        };
        let films = sheet(&layout, &Geometry::default(), None);
        assert!((films[0].from_bead_mm - 9.5 * 75f64.to_radians()).abs() < 1e-9);
        assert!(
            (films[0].arc_mm - 350f64.to_radians() * (37.5 + 9.5 * 0.5f64.sqrt())).abs() < 1e-9
        );
        assert!((films[0].from_crown_mm + 9.5 * 45f64.to_radians()).abs() < 1e-9);
        assert_eq!((films[0].length_mm, &*films[0].direction), (None, "30"));
    }
}
