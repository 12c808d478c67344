//! Values to which what layouts' figures rest on is changed, one at a time: the table `layouts.assumptions`.

use serde_json::{Map, Value};

use crate::parts::film_model::FilmModel;

/// Changed assumptions. Noise and films are always looked at; the others are where they have a value, as they take solves.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Assumptions {
    /// Noise over the layouts' own.
    pub noise_factor: f64,
    /// Standard deviation of a drift of the readings beside the noise, over the crown's largest signal.
    pub drift_share: f64,
    /// Standard deviation of films' gains, relative.
    pub gain_std: f64,
    /// Standard deviation of films' places around the wheel, degrees.
    pub place_std_deg: f64,
    /// Internal pressure over the scene's, which an estimate doesn't know.
    pub pressure_factor: Option<f64>,
    /// Inclination of the wheel, degrees, which an estimate doesn't know.
    pub camber_deg: Option<f64>,
    /// Friction of the ground, which an estimate doesn't know.
    pub friction: Option<f64>,
    /// Model of the films, which an estimate knows.
    pub film: Option<FilmModel>,
}

impl Default for Assumptions {
    /// Twice the noise; a drift of 2 % and gains that differ by 10 %, as of films that nobody has calibrated; 2 degrees, as they are glued by hand: 1.6 mm on the
    /// foot tire.
    fn default() -> Self {
        Self {
            noise_factor: 2.0,
            drift_share: 0.02,
            gain_std: 0.1,
            place_std_deg: 2.0,
            pressure_factor: None,
            camber_deg: None,
            friction: None,
            film: None,
        }
    }
}

impl Assumptions {
    /// Whether a scene or a film is changed, which takes solves.
    pub(super) fn takes_solves(&self) -> bool {
        let scenes = [self.pressure_factor, self.camber_deg, self.friction];
        scenes.into_iter().any(|value| value.is_some()) || self.film.is_some()
    }

    /// The table as in a document.
    pub(super) fn to_value(self) -> Value {
        let fields = [
            ("noise_factor", Some(self.noise_factor)),
            ("drift_share", Some(self.drift_share)),
            ("gain_std", Some(self.gain_std)),
            ("place_std_deg", Some(self.place_std_deg)),
            ("pressure_factor", self.pressure_factor),
            ("camber_deg", self.camber_deg),
            ("friction", self.friction),
        ];
        let given = fields.into_iter();
        let given = given.filter_map(|(name, value)| Some((name.to_owned(), value?.into())));
        let film = self
            .film
            .map(|model| ("film".to_owned(), model.as_str().into()));
        Value::Object(given.chain(film).collect::<Map<_, _>>())
    }
}
