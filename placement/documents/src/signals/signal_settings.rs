//! Settings of films' signals: the loads, pressures and contact angles over which they are read, and the films themselves.

use document::typed::table_fields::table_value;
use fem_client::scene::{Film, Scene};
use fem_client::solver::Position;
use fem_client::solver::direction::Direction;
use serde_json::{Value, json};

use crate::parts::film_model::FilmModel;

/// The study's own tire among those of its signals.
pub const OWN_TIRE: &str = "own";

/// Fields of a film that its place on the tire decides.
pub(crate) const PLACED: [&str; 3] = ["theta_deg", "phi_deg", "angle_deg"];

/// The `[signals]` of a study.
#[derive(Debug, Clone, PartialEq)]
pub struct SignalSettings {
    /// Loads at the tire's own pressure, N.
    pub loads_n: Vec<f64>,
    /// Internal pressures, MPa.
    pub pressures_mpa: Vec<f64>,
    /// Load of the pressures, N.
    pub at_load_n: f64,
    /// Load of the contact angles, N.
    pub contact_load_n: f64,
    /// Wheel angles from a film to the contact, degrees.
    pub contact_deg: Vec<f64>,
    /// Positions of the films in the section.
    pub positions: Vec<Position>,
    /// Directions along which their length lies.
    pub directions: Vec<Direction>,
    /// Models of the films.
    pub films: Vec<FilmModel>,
    /// The film, wherever it is placed.
    pub film: Film,
    /// Further tires beside the study's own.
    pub tires: Vec<FurtherTire>,
}

/// A tire beside the study's own.
#[derive(Debug, Clone, PartialEq)]
pub struct FurtherTire {
    /// Name of the tire, like no other's.
    pub name: String,
    /// The tire.
    pub scene: Scene,
    /// Loads and pressures of its own, where it bears others.
    pub own: OwnLoads,
}

/// Loads and pressures of a further tire, in place of those of all.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct OwnLoads {
    /// Loads at the tire's own pressure, N.
    pub loads_n: Option<Vec<f64>>,
    /// Internal pressures, MPa.
    pub pressures_mpa: Option<Vec<f64>>,
    /// Load of the pressures, N.
    pub at_load_n: Option<f64>,
    /// Load of the contact angles, N.
    pub contact_load_n: Option<f64>,
}

impl SignalSettings {
    /// Returns the settings of an empty table on this scene: its film, or a common one.
    pub fn on(scene: &Scene) -> Self {
        let mut thin = Film::default();
        for layer in &mut thin.layers {
            layer.thickness_mm = 0.028;
        }
        Self {
            loads_n: vec![1.0, 2.0, 5.0, 10.0, 15.0, 20.0, 30.0],
            pressures_mpa: vec![0.1, 0.2, 0.3],
            at_load_n: 10.0,
            contact_load_n: 20.0,
            contact_deg: (0..7).map(|k| 5.0 * f64::from(k)).collect(),
            positions: vec![Position::Crown, Position::Shoulder, Position::Sidewall],
            directions: Direction::ALL.to_vec(),
            films: FilmModel::ALL.to_vec(),
            film: unplaced(scene.film.clone().unwrap_or(thin)),
            tires: Vec::new(),
        }
    }

    /// The film in a direction at a position, so many degrees around the wheel from the contact. Ahead of it or behind is the same: the ground is flat.
    pub fn placed(&self, position: Position, direction: Direction, theta_deg: f64) -> Film {
        Film {
            theta_deg: -theta_deg,
            phi_deg: position.angle_deg(),
            angle_deg: match direction {
                Direction::X => 0.0,
                Direction::Y => 90.0,
            },
            ..self.film.clone()
        }
    }

    /// Returns the settings of a further tire.
    pub fn of_tire(&self, tire: &FurtherTire) -> Self {
        let mut settings = self.clone();
        let own = tire.own.clone();
        settings.loads_n = own.loads_n.unwrap_or(settings.loads_n);
        settings.pressures_mpa = own.pressures_mpa.unwrap_or(settings.pressures_mpa);
        settings.at_load_n = own.at_load_n.unwrap_or(settings.at_load_n);
        settings.contact_load_n = own.contact_load_n.unwrap_or(settings.contact_load_n);
        settings
    }

    /// Whether any of its films is glued on.
    pub(crate) fn has_glued(&self) -> bool {
        self.films.iter().any(|film| *film != FilmModel::Bare)
    }

    /// The table as in a document, every default filled in.
    pub fn to_value(&self) -> Value {
        json!({
            "loads_n": self.loads_n,
            "pressures_mpa": self.pressures_mpa,
            "at_load_n": self.at_load_n,
            "contact_load_n": self.contact_load_n,
            "contact_deg": self.contact_deg,
            "positions": self.positions,
            "directions": self.directions,
            "films": self.films,
            "film": film_table(&self.film),
            "tires": self.tires.iter().map(FurtherTire::to_value).collect::<Vec<_>>(),
        })
    }
}

impl FurtherTire {
    fn to_value(&self) -> Value {
        let mut value = json!({"name": self.name, "scene": self.scene.to_value()});
        let own = [
            (
                "loads_n",
                self.own.loads_n.as_ref().map(|loads| json!(loads)),
            ),
            (
                "pressures_mpa",
                self.own.pressures_mpa.as_ref().map(|p| json!(p)),
            ),
            ("at_load_n", self.own.at_load_n.map(|load| json!(load))),
            (
                "contact_load_n",
                self.own.contact_load_n.map(|load| json!(load)),
            ),
        ];
        for (name, given) in own {
            if let Some(given) = given {
                value[name] = given;
            }
        }
        value
    }
}

/// The film as a table without its place.
pub(crate) fn film_table(film: &Film) -> Value {
    let mut table = table_value(film);
    if let Some(fields) = table.as_object_mut() {
        for name in PLACED {
            fields.shift_remove(name);
        }
    }
    table
}

fn unplaced(film: Film) -> Film {
    let Film {
        theta_deg,
        phi_deg,
        angle_deg,
        ..
    } = Film::default();
    Film {
        theta_deg,
        phi_deg,
        angle_deg,
        ..film
    }
}
