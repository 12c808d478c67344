//! Reads the film.

use serde_json::Value;

use super::inner_table::section;
use super::shared_ranges::{LENGTH, MODULUS};
use crate::document::fault::{Fault, member};
use crate::document::fields::{Fields, Range, plain};
use crate::film::amplifier::{Amplifier, Circuit};
use crate::film::piezo::Piezo;
use crate::scene::{Film, Geometry};

const POISSON: Range = Range::new(0.0, 0.5, "");
/// Poled films charge either way round.
const CHARGE_PER_FORCE: Range = Range::new(-1e4, 1e4, "pC/N");
const PERMITTIVITY: Range = Range::new(1.0, 1e6, "pF/m");
const FREQUENCY: Range = Range::new(1e-6, 1e6, "Hz");
const RESISTANCE: Range = Range::new(1e-6, 1e9, "megohm");
const CABLE: Range = Range::new(0.0, 1e6, "pF");
const CAPACITANCE: Range = Range::new(1e-6, 1e6, "nF");
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
    let known = [
        &["piezo", "amplifier"],
        &numbers.each_ref().map(|number| number.0)[..],
    ]
    .concat();
    let fields = Fields::open(value, pointer, &known, faults)?;
    let read = fields.numbers(numbers, faults);
    let piezo = section(&fields, "piezo", faults, piezo);
    let amplifier = section(&fields, "amplifier", faults, amplifier);
    read?;
    (film.piezo, film.amplifier) = (piezo?, amplifier?);
    Some(film)
}

fn piezo(value: &Value, pointer: &str, faults: &mut Vec<Fault>) -> Option<Piezo> {
    let mut piezo = Piezo::default();
    let numbers = [
        ("d31_pc_per_n", CHARGE_PER_FORCE, &mut piezo.d31_pc_per_n),
        ("d32_pc_per_n", CHARGE_PER_FORCE, &mut piezo.d32_pc_per_n),
        (
            "permittivity_pf_per_m",
            PERMITTIVITY,
            &mut piezo.permittivity_pf_per_m,
        ),
        ("yield_mpa", MODULUS, &mut piezo.yield_mpa),
    ];
    Fields::of_numbers(value, pointer, &[], numbers, faults)?;
    Some(piezo)
}

fn amplifier(value: &Value, pointer: &str, faults: &mut Vec<Fault>) -> Option<Amplifier> {
    let kinds = [
        ("open-circuit", Circuit::OpenCircuit),
        ("voltage", Circuit::VOLTAGE),
        ("charge", Circuit::CHARGE),
    ];
    let mut amplifier = Amplifier::default();
    let kind = value.get("kind").and_then(Value::as_str);
    if let Some((_, circuit)) = kinds.iter().find(|(name, _)| Some(*name) == kind) {
        amplifier.circuit = *circuit;
    }
    // The fields of its own kind; of an unknown kind, of none, so that the kind alone is at fault.
    let own: &[&str] = match amplifier.circuit {
        Circuit::Voltage { .. } => &["input_mohm", "cable_pf"],
        Circuit::Charge { .. } => &["feedback_nf", "feedback_mohm"],
        Circuit::OpenCircuit => &[],
    };
    let known = [&["kind", "press_hz"], own].concat();
    let fields = Fields::open(value, pointer, &known, faults)?;
    let kind = fields.choice("kind", &kinds, Circuit::OpenCircuit, faults);
    let press = fields.numbers([("press_hz", FREQUENCY, &mut amplifier.press_hz)], faults);
    let circuit = match &mut amplifier.circuit {
        Circuit::OpenCircuit => Some(()),
        Circuit::Voltage {
            input_mohm,
            cable_pf,
        } => fields.numbers(
            [
                ("input_mohm", RESISTANCE, input_mohm),
                ("cable_pf", CABLE, cable_pf),
            ],
            faults,
        ),
        Circuit::Charge {
            feedback_nf,
            feedback_mohm,
        } => fields.numbers(
            [
                ("feedback_nf", CAPACITANCE, feedback_nf),
                ("feedback_mohm", RESISTANCE, feedback_mohm),
            ],
            faults,
        ),
    };
    kind.and(press).and(circuit)?;
    Some(amplifier)
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
            Fault::add(faults, &member(pointer, name), detail);
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::film::amplifier::Circuit;
    use crate::scene::{Film, Scene};

    #[test]
    fn an_empty_film_table_is_the_default_film_and_none_is_no_film() {
        let read = |text| Scene::from_toml(text).expect("reads").film;
        assert_eq!(read("[film]"), Some(Film::default()));
        assert_eq!(read(""), None);
    }

    #[test]
    fn a_film_s_tables_have_defaults_of_their_kind_and_every_fault_has_its_place() {
        let film = |text: &str| Scene::from_toml(text).map(|scene| scene.film.expect("a film"));
        let charge = film("[film.amplifier]\nkind = \"charge\"\nfeedback_nf = 2").expect("reads");
        let expected = Circuit::Charge {
            feedback_nf: 2.0,
            feedback_mohm: 1000.0,
        };
        assert_eq!(charge.amplifier.circuit, expected);
        let scene = Scene {
            film: Some(charge),
            ..Scene::default()
        };
        assert_eq!(Scene::from_json(&scene.canonical_json()), Ok(scene));
        let pointers = |text: &str| -> Vec<String> {
            let faults = film(text).expect_err(text);
            faults.into_iter().map(|fault| fault.pointer).collect()
        };
        assert_eq!(
            pointers(
                "[film]\nmodulus_mpa = 0\n[film.piezo]\nd31_pc_per_n = nan\npermittivity_pf_per_m = -1\n[film.amplifier]\nkind = \"voltage\"\ncable_pf = -1\nfeedback_nf = 1"
            ),
            [
                "/film/modulus_mpa",
                "/film/piezo/d31_pc_per_n",
                "/film/piezo/permittivity_pf_per_m",
                "/film/amplifier/feedback_nf",
                "/film/amplifier/cable_pf"
            ]
        );
        assert_eq!(
            pointers("[film.amplifier]\nkind = \"tube\""),
            ["/film/amplifier/kind"]
        );
        assert_eq!(pointers("[film]\npiezo = 3"), ["/film/piezo"]);
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
