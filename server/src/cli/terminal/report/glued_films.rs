//! Glued films that were solved with the tire around the wheel, for people.

use document::visible::visible;
use results::FilmAnglesReport;

use crate::cli::terminal::wrapping::wrapped;

/// Says how far the volts of glued films are off beside the contact.
pub(super) fn glued(films: &FilmAnglesReport) -> String {
    let off = match (films.signal_worst, films.signal_rms) {
        (Some(worst), Some(rms)) => format!(
            "off by {:.1} % of full scale at most, {:.1} % rms, at {} solves between them",
            100.0 * worst,
            100.0 * rms,
            films.tested
        ),
        _ => "not tested".to_owned(),
    };
    wrapped(
        &format!(
            "Glued films are solved with the tire ({}) at {} angles from the contact: {off}; their transfer alone would be off by {:.1} %.",
            visible(&films.level),
            films.angles_deg.len(),
            100.0 * films.transfer_worst
        ),
        0,
    )
}
