//! Reads what layouts' figures rest on: the table `layouts.assumptions`.

// What users write is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

use document::Choice;
use document::fault::Fault;
use document::fields::{Fields, number};

use crate::layouts::assumptions::Assumptions;
use crate::layouts::layout_bounds::{
    CAMBER, DRIFT, FRICTION, GAIN, NOISE_FACTOR, PLACE, PRESSURE_FACTOR,
};
use crate::parts::film_model::FilmModel;

/// Reads `[layouts.assumptions]`; the usual ones without the table.
pub(super) fn assumptions(fields: &Fields<'_>, faults: &mut Vec<Fault>) -> Assumptions {
    let mut read = Assumptions::default();
    let Some((value, pointer)) = fields.get("assumptions") else {
        return read;
    };
    let known = [
        "noise_factor",
        "drift_share",
        "gain_std",
        "place_std_deg",
        "pressure_factor",
        "camber_deg",
        "friction",
        "film",
    ];
    let Some(table) = Fields::open(value, &pointer, &known, faults) else {
        return read;
    };
    let numbers = [
        ("noise_factor", NOISE_FACTOR, &mut read.noise_factor),
        ("drift_share", DRIFT, &mut read.drift_share),
        ("gain_std", GAIN, &mut read.gain_std),
        ("place_std_deg", PLACE, &mut read.place_std_deg),
    ];
    // Faults are in the list; the numbers stay as they are then.
    let _ = table.numbers(numbers, faults);
    let mut given = |name, range| {
        let (value, at) = table.get(name)?;
        number(value, &at, range, faults)
    };
    read.pressure_factor = given("pressure_factor", PRESSURE_FACTOR);
    read.camber_deg = given("camber_deg", CAMBER);
    read.friction = given("friction", FRICTION);
    if table.get("film").is_some() {
        read.film = table.choice("film", FilmModel::CHOICES, FilmModel::Bare, faults);
    }
    if read.takes_solves() && fields.get("contacts").is_some() {
        let detail = "changes the contact, of which layouts.contacts has laws: leave pressure_factor, camber_deg, friction and film out, or the laws";
        Fault::add(faults, &pointer, detail);
    }
    read
}

#[cfg(test)]
mod tests {
    use document::Format;

    use super::*;
    use crate::study::Study;

    fn read(tables: &str) -> Result<Study, String> {
        let text = format!(
            "name = \"assumed\"\nscene = {{ preset = \"foot-tire\" }}\n[[inputs]]\nname = \"p\"\nvary = \"pressure.internal_mpa\"\ndistribution = {{ kind = \"uniform\", min = 0.01, max = 0.02 }}\n[layouts]\nunits = [6]\ndepths_mm = [1]\n{tables}"
        );
        Study::from_document(&text, Format::Toml, &|path| Err(path.to_owned())).map_err(|faults| {
            let lines = faults
                .iter()
                .map(|fault| format!("{}: {}\n", fault.pointer, fault.detail));
            lines.collect()
        })
    }

    #[test]
    fn what_is_given_is_changed_and_the_rest_is_as_usual() {
        let study =
            read("[layouts.assumptions]\nnoise_factor = 3\ncamber_deg = -5\nfilm = \"coupled\"")
                .expect("reads");
        let expected = Assumptions {
            noise_factor: 3.0,
            camber_deg: Some(-5.0),
            film: Some(FilmModel::Coupled),
            ..Assumptions::default()
        };
        assert_eq!(study.layouts.assumptions, expected);
        let canonical = study.canonical();
        let again = Study::from_canonical(&canonical).expect("reads what it wrote");
        assert_eq!(again.layouts.assumptions, expected);
        let usual = read("").expect("reads");
        assert_eq!(usual.layouts.assumptions, Assumptions::default());
        assert!(!usual.canonical().contains("assumptions"));
    }

    #[test]
    fn what_cannot_be_is_named() {
        let laws = "[layouts.contacts]\ncamber_deg = { kind = \"uniform\", min = -5, max = 5 }";
        for (tables, expected) in [
            (
                "[layouts.assumptions]\nnoise_factor = 0".to_owned(),
                "/layouts/assumptions/noise_factor: ",
            ),
            (
                "[layouts.assumptions]\ncamber_deg = 31".to_owned(),
                "/layouts/assumptions/camber_deg: ",
            ),
            (
                "[layouts.assumptions]\nfriction = -1".to_owned(),
                "/layouts/assumptions/friction: ",
            ),
            (
                "[layouts.assumptions]\nfilm = \"stiff\"".to_owned(),
                "/layouts/assumptions/film: must be \"bare\"",
            ),
            (
                "[layouts.assumptions]\nwind = 1".to_owned(),
                "/layouts/assumptions/wind: ",
            ),
            (
                format!("[layouts.assumptions]\ncamber_deg = 5\n{laws}"),
                "/layouts/assumptions: changes the contact",
            ),
        ] {
            let found = read(&tables).expect_err(expected);
            assert!(found.contains(expected), "{found}");
        }
        assert!(read(&format!("[layouts.assumptions]\nnoise_factor = 3\n{laws}")).is_ok());
    }
}
