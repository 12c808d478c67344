//! Answers of one mesh about the films of one tire.

use fem_client::scene::Film;
use fem_client::solver::{FilmMeans, FilmSignal, Response};

use crate::signals::tension_transfer::TensionTransfer;
use documents::parts::film_model::FilmModel;
use documents::signals::series::{Place, Pressing, Series};
use documents::signals::signal_settings::SignalSettings;

/// An equilibrium, or why there is none.
pub type Answer = Result<Response, String>;

/// Reading of a film at an equilibrium.
#[derive(Debug, Clone, PartialEq)]
pub struct Reading {
    /// Height of the ground above the inflated outer radius, mm.
    pub depth_mm: f64,
    /// Signal of the film.
    pub signal: FilmSignal,
}

/// Answers of one mesh about one tire.
pub(crate) struct MeshAnswers<'s> {
    settings: &'s SignalSettings,
    bare_films: Vec<(Place, f64)>,
    /// Each series with its answers, in the order of its pressings.
    series: Vec<(Series, Vec<Answer>)>,
    transfers: Vec<(Place, Result<TensionTransfer, String>)>,
}

impl<'s> MeshAnswers<'s> {
    /// Collects the answers of each series; the loads of the transfers are those at this pressure, MPa.
    pub fn new(
        settings: &'s SignalSettings,
        series: Vec<(Series, Vec<Answer>)>,
        pressure_mpa: f64,
    ) -> Self {
        let mut answers = Self {
            settings,
            bare_films: settings.bare_films(),
            series,
            transfers: Vec::new(),
        };
        if settings.films.contains(&FilmModel::Transfer) {
            let of = |place| (place, answers.transfer(place, pressure_mpa));
            answers.transfers = settings.places().into_iter().map(of).collect();
        }
        answers
    }

    /// Returns what a film reads of a pressing.
    ///
    /// # Errors
    /// Why there is no reading.
    pub fn reading(
        &self,
        film: FilmModel,
        place: Place,
        pressing: &Pressing,
    ) -> Result<Reading, String> {
        match film {
            FilmModel::Bare => self.bare(place, pressing),
            FilmModel::Coupled => self.coupled(place, pressing),
            FilmModel::Transfer => self.transferred(place, pressing),
        }
    }

    /// The bare tire under a load.
    ///
    /// # Errors
    /// Why there is no equilibrium.
    pub fn response(&self, film: Option<Place>, pressing: &Pressing) -> Result<&Response, String> {
        let unsolved = || "it wasn't solved".to_owned();
        let (series, answers) = self
            .series
            .iter()
            .find(|(series, _)| series.film == film)
            .ok_or_else(unsolved)?;
        let asked = series.pressings.iter().position(|other| other == pressing);
        let answer = asked.and_then(|asked| answers.get(asked));
        answer.ok_or_else(unsolved)?.as_ref().map_err(Clone::clone)
    }

    fn bare(&self, place: Place, pressing: &Pressing) -> Result<Reading, String> {
        let centred = Pressing {
            contact_deg: 0.0,
            ..*pressing
        };
        let response = self.response(None, &centred)?;
        let film = (place, pressing.contact_deg);
        let asked = self.bare_films.iter().position(|other| *other == film);
        let signal = asked.and_then(|asked| response.films.get(asked));
        Ok(Reading {
            depth_mm: response.depth_mm,
            signal: *signal.ok_or("the solver gives no reading of a bare film")?,
        })
    }

    fn coupled(&self, place: Place, pressing: &Pressing) -> Result<Reading, String> {
        let response = self.response(Some(place), pressing)?;
        let signal = response.film.map(|film| film.signal);
        Ok(Reading {
            depth_mm: response.depth_mm,
            signal: signal.ok_or("the solver gives no reading of a glued film")?,
        })
    }

    fn transferred(&self, place: Place, pressing: &Pressing) -> Result<Reading, String> {
        let Reading { depth_mm, signal } = self.bare(place, pressing)?;
        let transfer = self.transfers.iter().find(|(other, _)| *other == place);
        let (_, transfer) = transfer.ok_or("it wasn't asked for")?;
        let tension = transfer
            .as_ref()
            .map_err(Clone::clone)?
            .tension(strain(&signal));
        Ok(Reading {
            depth_mm,
            signal: signal_of_tension(&self.settings.film, tension),
        })
    }

    /// Fits the transfer from the bare wall's strains to a glued film's tensions, by two loads.
    fn transfer(&self, place: Place, pressure_mpa: f64) -> Result<TensionTransfer, String> {
        check_transferable(&self.settings.film)?;
        let loads = self.settings.transfer_loads();
        let loads = loads.ok_or("two loads give a transfer; there is one")?;
        let pressings = loads.map(|load_n| Pressing {
            load_n,
            pressure_mpa,
            contact_deg: 0.0,
        });
        let [first, second] = pressings.map(|pressing| {
            let bare = self.bare(place, &pressing)?.signal;
            let coupled = self.coupled(place, &pressing)?.signal;
            Ok::<_, String>((strain(&bare), tension(&coupled)))
        });
        let ((strain_a, tension_a), (strain_b, tension_b)) = (first?, second?);
        TensionTransfer::of([strain_a, strain_b], [tension_a, tension_b])
    }
}

/// Whether a film's tensions tell what it reads.
///
/// # Errors
/// Why they don't.
pub(crate) fn check_transferable(film: &Film) -> Result<(), String> {
    if reads_bending(film) {
        return Err("the film's piezoelectric layer lies off the neutral plane: it reads how the film bends, which tensions don't tell".to_owned());
    }
    Ok(())
}

/// Whether a change of curvature makes charge, round-off of the neutral plane apart.
fn reads_bending(film: &Film) -> bool {
    film.laminate().piezo_height.abs() > 1e-9 * film.thickness_mm()
}

fn strain(signal: &FilmSignal) -> [f64; 2] {
    [signal.mean_strain_1, signal.mean_strain_2]
}

/// Mean tensions along and across, N/mm.
pub(crate) fn tension(signal: &FilmSignal) -> [f64; 2] {
    [
        signal.mean_tension_1_n_per_mm,
        signal.mean_tension_2_n_per_mm,
    ]
}

/// Returns what a flat film with these tensions along and across reads, N/mm.
pub(crate) fn signal_of_tension(film: &Film, [along, across]: [f64; 2]) -> FilmSignal {
    let [[a, b, _], [c, d, _], _] = film.laminate().membrane;
    let determinant = a * d - b * c;
    let strain = [
        (d * along - b * across) / determinant,
        (a * across - c * along) / determinant,
    ];
    let means = FilmMeans {
        area: film.length_mm * film.width_mm,
        strain,
        added: [strain[0], strain[1], 0.0],
        ..FilmMeans::default()
    };
    FilmSignal::of(film, &means)
}

#[cfg(test)]
mod tests {
    use fem_client::film::laminate::product;
    use fem_client::scene::{FilmLayer, Scene};

    use super::*;

    #[test]
    fn only_a_film_that_reads_no_bending_is_read_by_its_tension() {
        let layer = |piezo| FilmLayer {
            piezo,
            ..FilmLayer::default()
        };
        let of = |piezos: &[bool]| {
            reads_bending(&Film {
                layers: piezos.iter().map(|piezo| layer(*piezo)).collect(),
                ..Film::default()
            })
        };
        assert!(!of(&[true]) && !of(&[false, true, false]));
        assert!(of(&[false, true]) && of(&[true, false, false]));
    }

    #[test]
    fn a_tension_is_read_by_its_stress_in_a_single_layer() {
        let film = SignalSettings::on(&Scene::default()).film;
        let signal = signal_of_tension(&film, [0.07, 0.15]);
        assert!((signal.mean_tension_1_n_per_mm - 0.07).abs() < 1e-15);
        assert!((signal.mean_tension_2_n_per_mm - 0.15).abs() < 1e-15);
        let stress = [0.07 / 0.028, 0.15 / 0.028];
        let charge = film.piezo.charge_nc(stress, film.length_mm * film.width_mm);
        assert!((signal.charge_nc / charge - 1.0).abs() < 1e-12);
        let membrane = product(
            &film.laminate().membrane,
            &[signal.mean_strain_1, signal.mean_strain_2, 0.0],
        );
        assert!((membrane[0] - 0.07).abs() < 1e-15);
    }
}
