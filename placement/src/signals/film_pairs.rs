//! Two films at the crown, 30 degrees before and behind a point of the wheel, read against each other: their difference says on which side the contact is, and how far.

use fem_client::solver::Position;

use crate::signals::curve_trend::{CurvePoint, trend};
use crate::signals::signal_curves::line;
use crate::signals::signal_rows::TireAnswers;
use documents::parts::film_model::FilmModel;
use documents::signals::series::PAIR_DEG;
use documents::signals::signal_settings::SignalSettings;
use results::FilmPair;

impl TireAnswers<'_> {
    /// The pairs of a tire: bare films and coupled ones, in each direction; none without a film at the crown.
    pub fn pairs(&self, settings: &SignalSettings) -> Vec<FilmPair> {
        if !settings.positions.contains(&Position::Crown) {
            return Vec::new();
        }
        let films = settings
            .films
            .iter()
            .filter(|film| **film != FilmModel::Transfer);
        let both = films.flat_map(|film| settings.directions.iter().map(move |d| (*film, *d)));
        both.map(|(film, direction)| {
            let place = (Position::Crown, direction);
            let value = |angle: f64| {
                let pressing = settings.contact_at(angle, self.scene);
                let (reading, _) = self.reading(film, place, &pressing).ok()?;
                Some(reading.signal.open_circuit_v)
            };
            let values = settings.contact_deg.iter().map(|contact| {
                let difference = value(contact - PAIR_DEG)? - value(contact + PAIR_DEG)?;
                difference.is_finite().then_some(difference)
            });
            let values: Vec<Option<f64>> = values.collect();
            let points = points(&settings.contact_deg, &values);
            FilmPair {
                tire: self.name.to_owned(),
                film,
                direction,
                contact_deg: settings.contact_deg.clone(),
                monotone: trend(&points).0,
                linear_r2: line(&points).and_then(|line| line.r2),
                values,
            }
        })
        .collect()
    }
}

fn points(angles: &[f64], values: &[Option<f64>]) -> Vec<CurvePoint> {
    let both = angles.iter().zip(values);
    let mut points: Vec<CurvePoint> = both
        .filter_map(|(at, value)| {
            Some(CurvePoint {
                at: *at,
                value: (*value)?,
                error: None,
            })
        })
        .collect();
    points.sort_by(|a, b| a.at.total_cmp(&b.at));
    points
}
