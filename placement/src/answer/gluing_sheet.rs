//! The sheet to glue by: every film of the answer with its distances on the inner surface.

use documents::layouts::film_rings::Ring;
use documents::layouts::film_room::FilmRoom;
use documents::layouts::layout_settings::{
    STRAIN_UNIT, VOLT_UNIT, direction_name, direction_of, section_of,
};
use documents::parts::film_place::FilmPlace;
use fem_client::scene::Geometry;
use results::{LayoutFindings, RankedLayout, SheetFilm};

/// Place of the contact among the samples of a ring, which begin half a turn before it.
const AT_CONTACT: usize = 180;

/// Films of a layout in the order of their angles; empty where the layout doesn't say where they lie.
pub(super) fn sheet(
    layout: &RankedLayout,
    geometry: &Geometry,
    size_mm: Option<[f64; 2]>,
    findings: Option<&LayoutFindings>,
) -> Vec<SheetFilm> {
    let room = FilmRoom::on(geometry, size_mm, 0.0);
    let mut places = places(layout).unwrap_or_default();
    for place in &mut places {
        place.theta_deg = place.theta_deg.rem_euclid(360.0);
    }
    places.sort_by(|a, b| a.theta_deg.total_cmp(&b.theta_deg));
    let film = |(k, place): (usize, &FilmPlace)| {
        let (marks, connector) = (room.marks(place), room.connector(place));
        let expected = findings.and_then(|findings| expected(place, findings));
        let in_unit = |unit: &str| expected.filter(|_| findings.is_some_and(|f| f.unit == unit));
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
            connector_arc_mm: Some(connector.arc_mm),
            connector_from_bead_mm: Some(connector.from_bead_mm),
            lead_mm: Some(connector.lead_mm),
            expected_strain: in_unit(STRAIN_UNIT).map(|(signal, _)| signal),
            expected_v: in_unit(VOLT_UNIT).map(|(signal, _)| signal),
            expected_depth_mm: expected.map(|(_, depth_mm)| depth_mm),
        }
    };
    places.iter().enumerate().map(film).collect()
}

/// The signal of a film with the contact at it, and the contact's depth, mm.
fn expected(place: &FilmPlace, findings: &LayoutFindings) -> Option<(f64, f64)> {
    let direction = direction_name(place.angle_deg);
    let mut rings = findings.rings.iter();
    let ring = rings.find(|ring| {
        // The tire is its own mirror image.
        ring.section_deg.abs() == place.phi_deg.abs() && ring.direction == direction
    })?;
    Some((*ring.strain.get(AT_CONTACT)?, ring.depth_mm))
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
    use results::StrainRing;

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
                None,
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
    fn a_film_expects_what_its_ring_reads_at_the_contact() {
        let ring_of = |section_deg: f64, direction: &str, strain: f64| StrainRing {
            section_deg,
            direction: direction.to_owned(),
            depth_mm: 1.0,
            strain: (-180..180)
                .map(|theta| strain / f64::from(1 + i32::abs(theta)))
                .collect(),
            by_depth: Vec::new(),
            strain_error: None,
            by_depth_error: None,
        };
        let found = |unit: &str| LayoutFindings {
            unit: unit.to_owned(),
            rings: vec![ring_of(0.0, "x", 0.02), ring_of(0.0, "y", 0.08)],
            ..LayoutFindings::default()
        };
        let films = |findings: &LayoutFindings| {
            sheet(
                &ring("crown", true),
                &Geometry::default(),
                None,
                Some(findings),
            )
        };
        let expected = |film: &SheetFilm| {
            (
                film.expected_strain,
                film.expected_v,
                film.expected_depth_mm,
            )
        };
        let bare = films(&found(STRAIN_UNIT));
        assert_eq!(expected(&bare[0]), (Some(0.02), None, Some(1.0)));
        assert_eq!(expected(&bare[1]), (Some(0.08), None, Some(1.0)));
        let glued = films(&found(VOLT_UNIT));
        assert_eq!(expected(&glued[1]), (None, Some(0.08), Some(1.0)));
    }

    #[test]
    fn a_ring_that_is_turned_starts_off_the_mark() {
        let turned = RankedLayout {
            turn_deg: Some(8.75),
            ..ring("crown", true)
        };
        let films = sheet(&turned, &Geometry::default(), None, None);
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
        let films = sheet(&layout, &Geometry::default(), None, None);
        assert!((films[0].from_bead_mm - 9.5 * 75f64.to_radians()).abs() < 1e-9);
        assert!(
            (films[0].arc_mm - 350f64.to_radians() * (37.5 + 9.5 * 0.5f64.sqrt())).abs() < 1e-9
        );
        assert!((films[0].from_crown_mm + 9.5 * 45f64.to_radians()).abs() < 1e-9);
        assert_eq!((films[0].length_mm, &*films[0].direction), (None, "30"));
    }
}
