//! Changes of the signals of layouts' films by a study's inputs.

use documents::study::Study;
use layouts::arrangement::{Arrangement, FilmKind};
use layouts::field::film_field::{LoadField, Noise};
use layouts::field::hermite::{DEGREES, Turn};
use layouts::fisher::error_sources::error_sources;
use results::ErrorSources;

use crate::score::map_slopes::MapSlopes;

/// Changes of the signals of every kind of film per standard deviation of each input, at the study's own load.
pub(crate) struct InputShifts {
    /// Kinds that the map shows.
    known: Vec<bool>,
    /// Changes by input and kind; zeros of kinds that it doesn't show.
    of_inputs: Vec<Vec<Turn>>,
    /// Fields at that load.
    field: LoadField,
}

impl InputShifts {
    /// Reads them off the map's slopes. `None` of glued films, whose volts aren't strains of the bare wall.
    pub(crate) fn of(
        study: &Study,
        slopes: Option<&MapSlopes>,
        kinds: &[FilmKind],
        field: LoadField,
    ) -> Option<Self> {
        let slopes = slopes.filter(|_| study.layouts.glued.is_none())?;
        let signal = |input, kind| slopes.of_signal(input, kind);
        let known = kinds.iter().map(|kind| signal(0, kind).is_some());
        let of_input = |input| {
            let samples = kinds.iter().map(|kind| signal(input, kind));
            samples
                .map(|samples| Turn::new(samples.unwrap_or_else(|| vec![0.0; DEGREES])))
                .collect()
        };
        Some(Self {
            known: known.collect(),
            of_inputs: (0..slopes.inputs()).map(of_input).collect(),
            field,
        })
    }

    /// Sources of a layout's error; `None` where the map doesn't show its films, or they are blind.
    pub(crate) fn sources(&self, arrangement: &Arrangement, noise: &Noise) -> Option<ErrorSources> {
        let mut films = arrangement.films.iter();
        let is_known = films.all(|film| self.known[film.kind]);
        let sources = || error_sources(&self.field, arrangement, noise, &self.of_inputs);
        is_known.then(sources).flatten()
    }
}
