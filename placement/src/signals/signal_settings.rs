//! What a study asks of films' signals: the loads, pressures and contact angles over which they are read, and the films themselves.

use fem_client::scene::{Film, Scene};
use fem_client::solver::Position;
use fem_client::solver::direction::Direction;
use serde_json::{Value, json};

use crate::result::signal_words::FilmModel;

/// The study's own tire among those of its signals.
pub const OWN_TIRE: &str = "own";

/// Fields of a film that its place on the tire decides.
pub const PLACED: [&str; 3] = ["theta_deg", "phi_deg", "angle_deg"];

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
    /// Where the films lie in the section.
    pub positions: Vec<Position>,
    /// Along which direction their length lies.
    pub directions: Vec<Direction>,
    /// How they are modelled.
    pub films: Vec<FilmModel>,
    /// The film, wherever it is placed.
    pub film: Film,
    /// Further tires beside the study's own.
    pub tires: Vec<FurtherTire>,
}

/// A tire beside the study's own.
#[derive(Debug, Clone, PartialEq)]
pub struct FurtherTire {
    /// Its name, like no other's.
    pub name: String,
    /// The tire.
    pub scene: Scene,
}

impl SignalSettings {
    /// Those of an empty table on this scene: its film, or a common one.
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
        json!({"name": self.name, "scene": self.scene.to_value()})
    }
}

/// The film as a table without its place.
pub fn film_table(film: &Film) -> Value {
    let mut table = json!(film);
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
