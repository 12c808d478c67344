//! Reads the film.

use serde_json::Value;

use super::shared_ranges::{LENGTH, MODULUS};
use crate::document::fault::Fault;
use crate::document::fields::{Fields, Range, plain};
use crate::scene::{Film, Geometry};

const POISSON: Range = Range::new(0.0, 0.5, "");
/// Thickest film, in walls: a membrane has no bending stiffness.
const THICKEST: f64 = 0.1;

pub(super) fn film(value: &Value, pointer: &str, faults: &mut Vec<Fault>) -> Option<Film> {
    let mut film = Film::default();
    let numbers = [
        ("modulus_mpa", MODULUS, &mut film.modulus_mpa),
        ("poisson_ratio", POISSON, &mut film.poisson_ratio),
        ("thickness_mm", LENGTH, &mut film.thickness_mm),
        ("length_mm", LENGTH, &mut film.length_mm),
        ("width_mm", LENGTH, &mut film.width_mm),
    ];
    Fields::of_numbers(value, pointer, &[], numbers, faults)?;
    Some(film)
}

/// The film is thin, and it ends within the inner surface.
pub(super) fn check_film_on(
    geometry: &Geometry,
    film: &Film,
    pointer: &str,
    faults: &mut Vec<Fault>,
) {
    let section = geometry.section_radius_mm - geometry.wall_mm;
    let crown = geometry.outer_radius_mm - geometry.wall_mm;
    let bead_to_bead = 2.0 * geometry.bead_angle_deg.to_radians() * section;
    for (name, value, most, what) in [
        (
            "thickness_mm",
            film.thickness_mm,
            THICKEST * geometry.wall_mm,
            "a tenth of the wall",
        ),
        (
            "length_mm",
            film.length_mm,
            std::f64::consts::TAU * crown,
            "the inner circumference at the crown",
        ),
        (
            "width_mm",
            film.width_mm,
            bead_to_bead,
            "the inner surface from bead to bead",
        ),
    ] {
        if value > most {
            let detail = format!(
                "must be at most {} mm, {what}; it is {}",
                plain(most),
                plain(value)
            );
            Fault::add(
                faults,
                &crate::document::fault::member(pointer, name),
                detail,
            );
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::scene::{Film, Scene};

    #[test]
    fn an_empty_film_table_is_the_default_film_and_none_is_no_film() {
        let read = |text| Scene::from_toml(text).expect("reads").film;
        assert_eq!(read("[film]"), Some(Film::default()));
        assert_eq!(read(""), None);
    }

    #[test]
    fn a_film_fits_on_the_inner_surface_and_is_thin() {
        let pointers = |text: &str| -> Vec<String> {
            let faults = Scene::from_toml(text).expect_err(text);
            faults.into_iter().map(|fault| fault.pointer).collect()
        };
        assert_eq!(
            pointers("[film]\nthickness_mm = 0.31\nlength_mm = 296\nwidth_mm = 40"),
            ["/film/thickness_mm", "/film/length_mm", "/film/width_mm"]
        );
        assert_eq!(
            pointers("[film]\nmodulus_mpa = 0\npoisson_ratio = 0.6\nangle = 1"),
            ["/film/angle", "/film/modulus_mpa", "/film/poisson_ratio"]
        );
    }
}
