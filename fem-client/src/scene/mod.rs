//! The scene document: what is pressed, and how.
//!
//! Units: mm, N, MPa, degrees. Every field has a default (the reference tire) and a checked range; see
//! [`crate::scene::reader`] for the ranges and [`crate::scene::edit`] for changing single fields.

pub mod edit;
mod material;
pub mod reader;
mod sensor_film;

use serde::Serialize;
use serde_json::Value;

pub use material::{Law, Material, OgdenTerm};
pub use sensor_film::{Film, FilmLayer, Glue};

/// What is pressed on which ground, by how much, and how finely it is modelled.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Scene {
    /// Shape of the tire.
    pub geometry: Geometry,
    /// Rubber.
    pub material: Material,
    /// Textile layer; absent when the scene has none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub carcass: Option<Carcass>,
    /// Sensor film glued to the inner surface; absent when it isn't modelled.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub film: Option<Film>,
    /// Internal pressure.
    pub pressure: Pressure,
    /// Rigid ground.
    pub ground: Ground,
    /// How tire and ground touch.
    pub contact: Contact,
    /// How finely to model.
    pub model: Model,
}

/// A toroidal tire whose wall is an arc of a ring section, clamped at the beads.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Geometry {
    /// Kind of body; only the tire is modelled so far.
    pub kind: GeometryKind,
    /// Radius of the uninflated tire at the crown, mm.
    pub outer_radius_mm: f64,
    /// Outer radius of the toroidal section, mm.
    pub section_radius_mm: f64,
    /// Wall thickness, mm.
    pub wall_mm: f64,
    /// Angle from the crown at which the wall ends and is clamped, degrees.
    pub bead_angle_deg: f64,
}

/// Kinds of bodies.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum GeometryKind {
    /// Pneumatic tire.
    Tire,
}

/// Textile layer: two fibre families at +-angle to the circumference, a membrane within the wall.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Carcass {
    /// Angle of both families to the circumferential direction, degrees.
    pub angle_deg: f64,
    /// Stiffness of each family in tension, N/mm.
    pub stiffness_n_per_mm: f64,
    /// Position through the wall: 0 inner surface, 1 outer surface.
    pub position: f64,
    /// Stiffness in compression over that in tension.
    pub compression_ratio: f64,
}

/// Loads of the cavity.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Pressure {
    /// Internal pressure, positive when it inflates, MPa.
    pub internal_mpa: f64,
}

/// Rigid height field over stations along the circumference, each pressed in by its own depth.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Ground {
    /// Number of stations, equal to the length of `depths_mm` where there is one; odd.
    pub stations: usize,
    /// Horizontal distance of neighbouring stations, mm.
    pub station_spacing_mm: f64,
    /// Shape functions of the height field.
    pub station_functions: StationFunctions,
    /// Depth of each station below the inflated outer radius, mm; none where a load is given.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub depths_mm: Vec<f64>,
    /// Vertical force with which a flat ground presses on the whole tire, N, in place of depths.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub load_n: Option<f64>,
    /// How far the ground is dragged once it presses, mm: along the wheel (x, rolling direction) and across it (y, along the axle).
    #[serde(skip_serializing_if = "is_nowhere")]
    pub shift_mm: [f64; 2],
}

impl Ground {
    /// Whether left and right of the contact centre are alike.
    pub fn is_symmetric(&self) -> bool {
        let depths = &self.depths_mm;
        let is_even = depths.iter().zip(depths.iter().rev()).all(|(a, b)| a == b);
        is_even && self.shift_mm[0] == 0.0
    }

    /// Whether it is dragged.
    pub fn is_dragged(&self) -> bool {
        !is_nowhere(&self.shift_mm)
    }

    /// The same stations at these depths, mm.
    pub fn at_depths(&self, depths_mm: Vec<f64>) -> Self {
        Self {
            depths_mm,
            load_n: None,
            ..self.clone()
        }
    }

    /// The same ground before it is dragged.
    pub fn undragged(&self) -> Self {
        Self {
            shift_mm: [0.0; 2],
            ..self.clone()
        }
    }
}

/// No way at all stays out of documents, as it did before there were any.
fn is_nowhere(shift_mm: &[f64; 2]) -> bool {
    *shift_mm == [0.0; 2]
}

/// Shape functions of the height field; they sum to one everywhere.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum StationFunctions {
    /// Uniform cubic B-splines.
    Bspline,
    /// Piecewise linear.
    Hat,
}

/// How tire and ground touch.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Contact {
    /// Coulomb friction coefficient.
    pub friction: f64,
    /// Contact stiffness, N/mm^3; absent: scaled from the rubber's stiffness and the wall.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub penalty_n_per_mm3: Option<f64>,
}

/// How finely to model.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Model {
    /// Mesh level.
    pub level: Level,
}

/// Mesh levels, coarse to fine.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Level {
    /// For a first look.
    Draft,
    /// For a look with an error; it shows the error of the standard level.
    Coarse,
    /// For placement decisions.
    Standard,
    /// For judging the others.
    Reference,
}

impl Default for Scene {
    /// The reference tire without its carcass: the scene of an empty document.
    fn default() -> Self {
        Self {
            geometry: Geometry::default(),
            material: Material::default(),
            carcass: None,
            film: None,
            pressure: Pressure { internal_mpa: 0.2 },
            ground: Ground::default(),
            contact: Contact {
                friction: 0.0,
                penalty_n_per_mm3: None,
            },
            model: Model {
                level: Level::Standard,
            },
        }
    }
}

impl Default for Geometry {
    fn default() -> Self {
        Self {
            kind: GeometryKind::Tire,
            outer_radius_mm: 50.0,
            section_radius_mm: 12.5,
            wall_mm: 3.0,
            bead_angle_deg: 120.0,
        }
    }
}

impl Default for Carcass {
    fn default() -> Self {
        Self {
            angle_deg: 55.0,
            stiffness_n_per_mm: 100.0,
            position: 0.5,
            compression_ratio: 0.01,
        }
    }
}

impl Default for Ground {
    fn default() -> Self {
        Self {
            stations: 5,
            station_spacing_mm: 5.5,
            station_functions: StationFunctions::Bspline,
            depths_mm: vec![1.0; 5],
            load_n: None,
            shift_mm: [0.0; 2],
        }
    }
}

impl Level {
    /// All levels with their names in documents.
    pub const NAMES: [(&'static str, Self); 4] = [
        ("draft", Self::Draft),
        ("coarse", Self::Coarse),
        ("standard", Self::Standard),
        ("reference", Self::Reference),
    ];

    /// The name in documents.
    pub fn as_str(self) -> &'static str {
        match self {
            Self::Draft => "draft",
            Self::Coarse => "coarse",
            Self::Standard => "standard",
            Self::Reference => "reference",
        }
    }

    /// Cells between the nodes of the reference tire's mesh, in a quarter of it.
    pub fn cells_of_reference_tire(self) -> usize {
        match self {
            Self::Draft => 300,
            Self::Coarse => 1024,
            Self::Standard => 3744,
            Self::Reference => 9216,
        }
    }
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
        Some(Self::from_toml(text).expect("shipped scenes are checked by a test"))
    }

    /// The scene as a document with every field, in a fixed order.
    pub fn to_value(&self) -> Value {
        serde_json::to_value(self)
            .expect("a scene is a plain tree with text keys and finite numbers")
    }

    /// The scene as JSON text: equal scenes have equal texts, and the text reads back as the same scene.
    pub fn canonical_json(&self) -> String {
        self.to_value().to_string()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shipped_scenes_read_without_faults() {
        for (name, _) in PRESETS {
            assert!(Scene::preset(name).is_some());
        }
        assert_eq!(Scene::preset("bicycle"), None);
    }

    #[test]
    fn the_shipped_tire_is_the_default_with_its_carcass() {
        let expected = Scene {
            carcass: Some(Carcass::default()),
            ..Scene::default()
        };
        assert_eq!(Scene::preset("foot-tire"), Some(expected));
    }

    #[test]
    fn the_canonical_text_reads_back_as_the_same_scene() {
        let mut scene = Scene::preset("foot-tire").unwrap();
        scene.film = Some(Film::default());
        scene.ground.depths_mm[3] = 0.1 + 0.2;
        scene.contact.penalty_n_per_mm3 = Some(1.0 / 3.0);
        assert!(!scene.canonical_json().contains("shift"));
        scene.contact.friction = 0.5;
        scene.ground.shift_mm = [0.0, -0.1];
        let text = scene.canonical_json();
        assert_eq!(Scene::from_json(&text).unwrap(), scene);
        assert_eq!(Scene::from_json(&text).unwrap().canonical_json(), text);
    }
}
