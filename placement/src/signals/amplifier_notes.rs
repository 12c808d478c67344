//! Notes on amplifiers that can't show what their films give.

use documents::signals::signal_settings::SignalSettings;
use fem_client::solver::FilmCondition;
use results::{GradedNote, SignalRow, Topic};

/// A note where readings saturate, and one where they would by any supply that amplifiers have.
pub(crate) fn amplifier_notes(settings: &SignalSettings, rows: &[SignalRow]) -> Vec<GradedNote> {
    let saturated = |row: &&SignalRow| row.state == Some(FilmCondition::Saturated);
    let saturated = match rows.iter().filter(saturated).count() {
        0 => None,
        count => Some(format!(
            "{count} of {} films' readings are beyond the amplifier's supply: it shows the supply there, whatever the film does.",
            rows.len()
        )),
    };
    let outputs = rows.iter().filter_map(|row| row.output_v);
    let largest = outputs.map(f64::abs).fold(0.0, f64::max);
    let unlikely = settings.film.amplifier.unlikely_output(largest);
    let unlikely =
        unlikely.map(|sentence| format!("Unlikely value: signals.film.amplifier: {sentence}."));
    let all = saturated.into_iter().chain(unlikely);
    all.map(|text| GradedNote::bearing(Topic::Signals, text))
        .collect()
}
