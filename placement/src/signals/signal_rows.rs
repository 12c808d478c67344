//! The rows of one tire: what each film reads of each pressing, with its errors.

use fem_client::scene::Scene;
use fem_client::solver::{FilmCondition, FilmSignal};

use crate::signals::answers::{MeshAnswers, Reading};
use documents::parts::film_model::FilmModel;
use documents::signals::series::{Place, Pressing};
use documents::signals::signal_settings::SignalSettings;
use results::SignalAxis;
use results::SignalError;
use results::SignalRow;

/// A tire, answered on its own mesh and, where there is one, on a coarser mesh with the factor of its error.
pub(crate) struct TireAnswers<'s> {
    /// Name of the tire in rows.
    pub name: &'s str,
    /// The tire.
    pub scene: &'s Scene,
    /// Answers on its own mesh.
    pub fine: MeshAnswers<'s>,
    /// Answers on the coarser mesh, with the factor.
    pub coarse: Option<(MeshAnswers<'s>, f64)>,
}

impl TireAnswers<'_> {
    /// Returns what a film reads, and its errors.
    ///
    /// # Errors
    /// Why there is no reading on the tire's own mesh.
    pub fn reading(
        &self,
        film: FilmModel,
        place: Place,
        pressing: &Pressing,
    ) -> Result<(Reading, Option<SignalError>), String> {
        let fine = self.fine.reading(film, place, pressing)?;
        let error = self.coarse.as_ref().and_then(|(coarse, factor)| {
            let coarse = coarse.reading(film, place, pressing).ok()?;
            finite_error(&fine.signal, &coarse.signal, *factor)
        });
        Ok((fine, error))
    }

    /// All rows: each film at each place over loads, pressures and contact angles.
    pub fn rows(&self, settings: &SignalSettings) -> Vec<SignalRow> {
        let mut rows = Vec::new();
        for film in &settings.films {
            for place in settings.places() {
                for over in SignalAxis::ALL {
                    let along = along(settings, self.scene, over).into_iter();
                    rows.extend(along.map(|(pressing, contact_deg)| {
                        self.row(*film, place, over, &pressing, contact_deg)
                    }));
                }
            }
        }
        rows
    }

    fn row(
        &self,
        film: FilmModel,
        place: Place,
        over: SignalAxis,
        pressing: &Pressing,
        contact_deg: f64,
    ) -> SignalRow {
        let (position, direction) = place;
        let unread = SignalRow {
            tire: self.name.to_owned(),
            film,
            position,
            direction,
            over,
            load_n: pressing.load_n,
            pressure_mpa: pressing.pressure_mpa,
            contact_deg,
            depth_mm: None,
            strain: None,
            tension_1_n_per_mm: None,
            charge_nc: None,
            open_circuit_v: None,
            output_v: None,
            output_std_v: None,
            state: None,
            error: None,
            reason: None,
        };
        match self.reading(film, place, pressing) {
            Ok((Reading { depth_mm, signal }, error)) => SignalRow {
                depth_mm: Some(depth_mm),
                strain: finite(signal.mean_strain_1),
                tension_1_n_per_mm: finite(signal.mean_tension_1_n_per_mm),
                charge_nc: finite(signal.charge_nc),
                open_circuit_v: finite(signal.open_circuit_v),
                output_v: finite(signal.output_v),
                output_std_v: finite(signal.output_std_v),
                state: known_state(film, signal.state),
                error,
                ..unread
            },
            Err(reason) => SignalRow {
                reason: Some(reason),
                ..unread
            },
        }
    }
}

/// The pressings of a curve, each with the contact angle that the document asks for.
fn along(settings: &SignalSettings, tire: &Scene, over: SignalAxis) -> Vec<(Pressing, f64)> {
    let centred = |pressings: Vec<Pressing>| pressings.into_iter().map(|p| (p, 0.0)).collect();
    match over {
        SignalAxis::Load => centred(settings.over_loads(tire)),
        SignalAxis::Pressure => centred(settings.over_pressures()),
        SignalAxis::Contact => {
            let angles = settings.contact_deg.iter().copied();
            settings
                .over_contact(tire)
                .into_iter()
                .zip(angles)
                .collect()
        }
    }
}

/// State as far as a model knows it. A transfer gives what contact adds: how far inflation stretches the film isn't in it; whether the amplifier shows it is.
fn known_state(film: FilmModel, state: FilmCondition) -> Option<FilmCondition> {
    let is_known = film != FilmModel::Transfer || state == FilmCondition::Saturated;
    is_known.then_some(state)
}

fn finite(number: f64) -> Option<f64> {
    number.is_finite().then_some(number)
}

fn finite_error(fine: &FilmSignal, coarse: &FilmSignal, factor: f64) -> Option<SignalError> {
    let of = |part: fn(&FilmSignal) -> f64| finite(factor * (part(fine) - part(coarse)).abs());
    Some(SignalError {
        strain: of(|signal| signal.mean_strain_1)?,
        charge_nc: of(|signal| signal.charge_nc)?,
        open_circuit_v: of(|signal| signal.open_circuit_v)?,
        output_v: of(|signal| signal.output_v)?,
    })
}
