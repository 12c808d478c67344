//! The scene document: what is pressed, and how.
//!
//! Units: mm, N, MPa, degrees. Every field has a default (the reference tire) and a checked range. The ranges are wide enough for tires from micrometres to ten
//! metres, and narrow enough that no product of a few of them overflows. [`edit`] changes single fields.

// What users write is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

mod carcass;
mod contact;
pub mod edit;
mod geometry;
mod ground;
mod ground_profile;
mod material;
mod mesh_level;
mod sensor_film;
mod shared_ranges;
pub mod slips;

use document::fault::{Fault, member};
use document::fields::Range;
use document::typed::field_value::Field;
use document::typed::table_fields::table_value;
use document::{Format, Table, Value, parse};

pub use carcass::Carcass;
pub use contact::Contact;
pub use geometry::{Geometry, GeometryKind};
pub use ground::{DEPTH, Ground, LOAD, StationFunctions};
pub use ground_profile::{GroundProfile, ProfileKind, Roughness};
pub use material::{Law, Material, OgdenTerm};
pub use mesh_level::{Level, Model};
pub use sensor_film::{Film, FilmLayer, Glue};

/// Internal pressures.
pub const PRESSURE: Range = Range::new(0.0, 1e4, "MPa");

/// Scene: what is pressed on which ground, by how much, and how finely it is modelled.
#[derive(Debug, Clone, PartialEq, Table)]
#[table(
    rule = ground::check_under(geometry, ground),
    rule = ground::check_grip(ground, contact),
    rule = sensor_film::check_on(geometry, film)
)]
pub struct Scene {
    /// Shape of the tire.
    pub geometry: Geometry,
    /// Rubber.
    pub material: Material,
    /// Textile layer; absent when the scene has none.
    #[field(nullable)]
    pub carcass: Option<Carcass>,
    /// Sensor film glued to the inner surface; absent when it isn't modelled.
    #[field(nullable)]
    pub film: Option<Film>,
    /// Internal pressure.
    pub pressure: Pressure,
    /// Rigid ground.
    pub ground: Ground,
    /// Contact of tire and ground.
    pub contact: Contact,
    /// Fineness of the model.
    pub model: Model,
}

/// Loads of the cavity.
#[derive(Debug, Clone, PartialEq, Table)]
pub struct Pressure {
    /// Internal pressure, positive when it inflates, MPa.
    #[field(default = 0.2, within = PRESSURE)]
    pub internal_mpa: f64,
}

/// Names and TOML texts of the scenes that ship.
pub const PRESETS: [(&str, &str); 2] = [
    ("foot-tire", include_str!("../../../scenes/foot-tire.toml")),
    (
        "foot-tire-soft",
        include_str!("../../../scenes/foot-tire-soft.toml"),
    ),
];

impl Scene {
    /// A scene that ships, by name.
    pub fn preset(name: &str) -> Option<Self> {
        let text = PRESETS.iter().find(|(preset, _)| *preset == name)?.1;
        // A test reads every one of them.
        Self::from_toml(text).ok()
    }

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
        let read = Self::read(value, pointer, &(), faults);
        say_where_accuracy_is(pointer, faults);
        read.filter(|_| faults.len() == before)
    }

    /// The scene as a document with every field, in a fixed order.
    pub fn to_value(&self) -> Value {
        table_value(self)
    }

    /// The scene as JSON text: equal scenes have equal texts, and the text reads back as the same scene.
    pub fn canonical_json(&self) -> String {
        self.to_value().to_string()
    }
}

/// Accuracy is a study's: what it chooses for a scene is the mesh, which has its own place here.
fn say_where_accuracy_is(pointer: &str, faults: &mut [Fault]) {
    let at = member(pointer, "accuracy");
    if let Some(fault) = faults.iter_mut().find(|fault| fault.pointer == at) {
        let detail = "belongs to a study; a scene says how finely it is modelled by model.level, as in [model] level = \"draft\"";
        fault.detail = detail.to_owned();
    }
}

#[cfg(test)]
mod film_tests;
#[cfg(test)]
mod material_tests;
#[cfg(test)]
mod tests;
