//! Reads a scene from a document: the ranges, and the rules that tie fields together.
//!
//! The ranges are wide enough for tires from micrometres to ten metres, and narrow enough that no product of a few of
//! them overflows.

// What users write is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

pub mod circuit_reader;
pub(super) mod film_reader;
mod geometry_reader;
mod ground_reader;
mod inner_table;
mod material_reader;
mod shared_ranges;

use serde_json::Value;

use crate::document::fault::Fault;
use crate::document::fields::{Fields, Range, number};
use crate::document::{Format, parse};
use crate::scene::reader::film_reader::{check_film_on, film};
use crate::scene::reader::geometry_reader::geometry;
use crate::scene::reader::ground_reader::{check_grip, check_ground_under, ground};
use crate::scene::reader::inner_table::section;
use crate::scene::reader::material_reader::material;
use crate::scene::{Carcass, Contact, Level, Model, Pressure, Scene};

const FIBRE_ANGLE: Range = Range::new(0.0, 90.0, "degrees");
const FIBRE_STIFFNESS: Range = Range::new(0.0, 1e9, "N/mm");
const SHARE: Range = Range::new(0.0, 1.0, "");
const PRESSURE: Range = Range::new(0.0, 1e4, "MPa");
const PENALTY: Range = Range::new(1e-6, 1e9, "N/mm^3");
const FRICTION: Range = Range::new(0.0, 10.0, "");

impl Scene {
    /// Reads a scene from TOML.
    ///
    /// # Errors
    /// Every fault of the document.
    pub fn from_toml(text: &str) -> Result<Self, Vec<Fault>> {
        Self::from_text(text, Format::Toml)
    }

    /// Reads a scene from JSON.
    ///
    /// # Errors
    /// Every fault of the document.
    pub fn from_json(text: &str) -> Result<Self, Vec<Fault>> {
        Self::from_text(text, Format::Json)
    }

    /// Reads a scene from text in the given format.
    ///
    /// # Errors
    /// Every fault of the document.
    pub fn from_text(text: &str, format: Format) -> Result<Self, Vec<Fault>> {
        let value = parse(text, format)?;
        let mut faults = Vec::new();
        Self::from_value(&value, "", &mut faults).ok_or(faults)
    }

    /// Reads a scene from a value found at `pointer` of a larger document. Adds every fault to the list and returns
    /// None when there is one.
    pub fn from_value(value: &Value, pointer: &str, faults: &mut Vec<Fault>) -> Option<Self> {
        let before = faults.len();
        let known = [
            "geometry", "material", "carcass", "film", "pressure", "ground", "contact", "model",
        ];
        let fields = Fields::open(value, pointer, &known, faults)?;
        say_where_accuracy_is(&fields, faults);
        let geometry = section(&fields, "geometry", faults, geometry);
        let material = section(&fields, "material", faults, material);
        let carcass = optional(&fields, "carcass", faults, carcass);
        let film = optional(&fields, "film", faults, film);
        let pressure = section(&fields, "pressure", faults, pressure);
        let ground = section(&fields, "ground", faults, ground);
        let contact = section(&fields, "contact", faults, contact);
        let model = section(&fields, "model", faults, model);
        if let (Some(geometry), Some(ground)) = (&geometry, &ground) {
            check_ground_under(geometry, ground, &fields.at("ground"), faults);
        }
        if let (Some(ground), Some(contact)) = (&ground, &contact) {
            check_grip(ground, contact, &fields.at("ground"), faults);
        }
        if let (Some(geometry), Some(Some(film))) = (&geometry, &film) {
            check_film_on(geometry, film, &fields.at("film"), faults);
        }
        if faults.len() > before {
            return None;
        }
        Some(Self {
            geometry: geometry?,
            material: material?,
            carcass: carcass?,
            film: film?,
            pressure: pressure?,
            ground: ground?,
            contact: contact?,
            model: model?,
        })
    }
}

/// Accuracy is a study's: what it chooses for a scene is the mesh, which has its own place here.
fn say_where_accuracy_is(fields: &Fields<'_>, faults: &mut [Fault]) {
    let at = fields.at("accuracy");
    if let Some(fault) = faults.iter_mut().find(|fault| fault.pointer == at) {
        let detail = "belongs to a study; a scene says how finely it is modelled by model.level, as in [model] level = \"draft\"";
        fault.detail = detail.to_owned();
    }
}

/// Reads a part that a scene may lack. `null` is how an override takes it away.
fn optional<T>(
    fields: &Fields<'_>,
    name: &str,
    faults: &mut Vec<Fault>,
    read: fn(&Value, &str, &mut Vec<Fault>) -> Option<T>,
) -> Option<Option<T>> {
    match fields.get(name) {
        None | Some((Value::Null, _)) => Some(None),
        Some((value, pointer)) => read(value, &pointer, faults).map(Some),
    }
}

fn carcass(value: &Value, pointer: &str, faults: &mut Vec<Fault>) -> Option<Carcass> {
    let mut cords = Carcass::default();
    let numbers = [
        ("angle_deg", FIBRE_ANGLE, &mut cords.angle_deg),
        (
            "stiffness_n_per_mm",
            FIBRE_STIFFNESS,
            &mut cords.stiffness_n_per_mm,
        ),
        ("position", SHARE, &mut cords.position),
        ("compression_ratio", SHARE, &mut cords.compression_ratio),
    ];
    Fields::of_numbers(value, pointer, &[], numbers, faults)?;
    Some(cords)
}

fn pressure(value: &Value, pointer: &str, faults: &mut Vec<Fault>) -> Option<Pressure> {
    let mut pressure = Scene::default().pressure;
    let numbers = [("internal_mpa", PRESSURE, &mut pressure.internal_mpa)];
    Fields::of_numbers(value, pointer, &[], numbers, faults)?;
    Some(pressure)
}

fn contact(value: &Value, pointer: &str, faults: &mut Vec<Fault>) -> Option<Contact> {
    let fields = Fields::open(value, pointer, &["friction", "penalty_n_per_mm3"], faults)?;
    let friction = fields.number("friction", FRICTION, 0.0, faults);
    let penalty = match fields.get("penalty_n_per_mm3") {
        None => Some(None),
        Some((value, pointer)) => number(value, &pointer, PENALTY, faults).map(Some),
    };
    Some(Contact {
        friction: friction?,
        penalty_n_per_mm3: penalty?,
    })
}

fn model(value: &Value, pointer: &str, faults: &mut Vec<Fault>) -> Option<Model> {
    let fields = Fields::open(value, pointer, &["level"], faults)?;
    Some(Model {
        level: fields.choice("level", &Level::NAMES, Scene::default().model.level, faults)?,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn pointers(text: &str) -> Vec<String> {
        let faults = Scene::from_toml(text).expect_err(text);
        faults.into_iter().map(|fault| fault.pointer).collect()
    }

    #[test]
    fn an_empty_document_is_the_default() {
        assert_eq!(Scene::from_toml("").unwrap(), Scene::default());
        assert_eq!(Scene::from_json("{}").unwrap(), Scene::default());
    }

    #[test]
    fn a_scene_has_no_accuracy_and_says_what_it_has() {
        let faults = Scene::from_toml("accuracy = { preset = 'draft' }\ncolour = 1").unwrap_err();
        assert_eq!(faults.len(), 2);
        assert!(
            faults.iter().any(
                |fault| fault.pointer == "/accuracy" && fault.detail.contains("by model.level")
            )
        );
    }

    #[test]
    fn an_empty_carcass_table_has_the_reference_values() {
        assert_eq!(
            Scene::from_toml("[carcass]").unwrap().carcass,
            Some(Carcass::default())
        );
        assert_eq!(
            Scene::from_json("{\"carcass\": null}").unwrap().carcass,
            None
        );
    }

    #[test]
    fn all_faults_are_found_at_once() {
        let text = "colour = 1\n[geometry]\nwall_mm = -3\nbead_angle_deg = \"wide\"\n[material]\nc10_mpa = 0\n\
                    [carcass]\nangle_deg = 91\nposition = 1.5\n[pressure]\ninternal_mpa = -0.1\n\
                    [ground]\ndepths_mm = [1, -1, true]\nstation_functions = \"spline\"\n[contact]\nfriction = -0.5\n\
                    penalty_n_per_mm3 = 0\n[model]\nlevel = \"fine\"\n";
        assert_eq!(
            pointers(text),
            [
                "/colour",
                "/geometry/wall_mm",
                "/geometry/bead_angle_deg",
                "/material/c10_mpa",
                "/carcass/angle_deg",
                "/carcass/position",
                "/pressure/internal_mpa",
                "/ground/station_functions",
                "/ground/depths_mm/1",
                "/ground/depths_mm/2",
                "/contact/friction",
                "/contact/penalty_n_per_mm3",
                "/model/level"
            ]
        );
    }

    #[test]
    fn a_load_and_depths_exclude_each_other() {
        let read = |ground: &str| Scene::from_toml(&format!("[ground]\n{ground}"));
        let loaded = read("load_n = 13").unwrap().ground;
        assert_eq!((loaded.load_n, loaded.stations), (Some(13.0), 5));
        assert!(loaded.depths_mm.is_empty());
        assert_eq!(read("load_n = 0\nstations = 3").unwrap().ground.stations, 3);
        assert_eq!(
            pointers("[ground]\nload_n = 13\ndepths_mm = [1]"),
            ["/ground/load_n"]
        );
        assert_eq!(
            pointers("[ground]\nload_n = nan\nstations = 4"),
            ["/ground/load_n", "/ground/stations"]
        );
    }

    #[test]
    fn a_shift_is_two_ways_within_the_section_on_ground_with_friction() {
        let read = |shift: &str| format!("[ground]\nshift_mm = {shift}\n[contact]\nfriction = 0.5");
        let dragged = Scene::from_toml(&read("[0.5, -12.5]")).unwrap().ground;
        assert_eq!(dragged.shift_mm, [0.5, -12.5]);
        for shift in ["[]", "[0.5]", "[0.5, 0, 0]", "0.5", "\"far\"", "nan"] {
            assert_eq!(pointers(&read(shift)), ["/ground/shift_mm"], "{shift}");
        }
        assert_eq!(
            pointers(&read("[nan, \"far\"]")),
            ["/ground/shift_mm/0", "/ground/shift_mm/1"]
        );
        assert_eq!(
            pointers(&read("[-12.6, 13]")),
            ["/ground/shift_mm/0", "/ground/shift_mm/1"]
        );
        let faults = Scene::from_toml("[ground]\nshift_mm = [0.5, 0]").unwrap_err();
        assert_eq!(faults[0].pointer, "/ground/shift_mm");
        assert!(faults[0].detail.starts_with("needs contact.friction"));
        // Nowhere is where all ground was before.
        let still = Scene::from_toml("[ground]\nshift_mm = [0, -0.0]").unwrap();
        assert_eq!(still, Scene::default());
        assert_eq!(still.canonical_json(), Scene::default().canonical_json());
    }

    #[test]
    fn stations_follow_the_depths() {
        assert_eq!(
            Scene::from_toml("[ground]\ndepths_mm = [1, 2, 3]")
                .unwrap()
                .ground
                .stations,
            3
        );
        assert_eq!(
            Scene::from_toml("[ground]\nstations = 7.0")
                .unwrap()
                .ground
                .depths_mm,
            vec![1.0; 7]
        );
        assert_eq!(pointers("[ground]\nstations = 4"), ["/ground/stations"]);
        assert_eq!(
            pointers("[ground]\nstations = 3\ndepths_mm = [1, 1]"),
            ["/ground/stations"]
        );
        assert_eq!(pointers("[ground]\ndepths_mm = []"), ["/ground/depths_mm"]);
    }

    #[test]
    fn fields_that_contradict_each_other_are_refused() {
        assert_eq!(
            pointers("[geometry]\nwall_mm = 12.5"),
            ["/geometry/wall_mm"]
        );
        assert_eq!(
            pointers("[geometry]\nwall_mm = 0.01"),
            ["/geometry/wall_mm"]
        );
        assert_eq!(
            pointers("[geometry]\nsection_radius_mm = 34"),
            ["/geometry/section_radius_mm"]
        );
        assert_eq!(
            pointers("[ground]\nstation_spacing_mm = 26"),
            ["/ground/station_spacing_mm"]
        );
        assert_eq!(
            pointers("[ground]\ndepths_mm = [13]"),
            ["/ground/depths_mm/0"]
        );
    }

    #[test]
    fn other_kinds_of_bodies_are_refused_in_words() {
        let faults =
            Scene::from_toml("[geometry]\nkind = \"mesh\"\nfile = \"tire.inp\"").unwrap_err();
        assert_eq!(faults.len(), 1);
        assert_eq!(
            faults[0].detail,
            "this version models only \"tire\"; \"mesh\" isn't available yet"
        );
    }

    #[test]
    fn wrong_types_never_pass() {
        let names = [
            "geometry", "material", "carcass", "film", "pressure", "ground", "contact", "model",
        ];
        for (name, bad) in names
            .iter()
            .flat_map(|name| ["1", "\"x\"", "[]", "[[]]", "true"].map(|bad| (name, bad)))
        {
            assert_eq!(pointers(&format!("{name} = {bad}")), [format!("/{name}")]);
        }
    }
}
