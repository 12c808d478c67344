//! Inputs that matter for what else a study is about than strains: a film's volts, and a layout's error of the contact angle. To first order.

use documents::study::Study;
use layouts::arrangement::FilmKind;
use layouts::field::hermite::DEGREES;
use results::{InputShare, InputsBeside, RankedLayout, SignalsAnswer};

use super::layout_figures::three_digits;
use super::layout_words::words;
use crate::response_table::bare_film::bare_in_volts;
use crate::score::map_slopes::MapSlopes;
use crate::score::notes::listed;
use documents::layouts::layout_settings::{direction_of, section_of};

/// Sources that a sentence names.
const NAMED: usize = 3;
/// Name of what isn't an input: the noise of the readings.
const NOISE: &str = "noise";

/// Shares of the inputs in the volts of the film that gives most, with the contact at it, were it bare.
pub(super) fn of_volts(
    study: &Study,
    signals: &SignalsAnswer,
    slopes: &MapSlopes,
) -> Option<InputsBeside> {
    let film = &study.signals.as_ref()?.film;
    let size = Some([film.length_mm, film.width_mm]);
    let [phi_deg, angle_deg] = [
        section_of(&signals.position)?,
        direction_of(&signals.direction)?,
    ];
    let bare = FilmKind::sized(&study.scene.geometry, size, phi_deg, angle_deg);
    let kind = bare_in_volts(&bare, film);
    let at_contact = |input| Some(*slopes.of_signal(input, &kind)?.get(DEGREES / 2)?);
    let volts: Option<Vec<f64>> = (0..slopes.inputs()).map(at_contact).collect();
    let parts = names(study).zip(volts?).collect();
    let what = format!(
        "volts of a bare film along {} at the {}, with the contact at it",
        signals.direction, signals.position
    );
    told(parts, "V", |lead, std| {
        format!(
            "Of the {what}, {lead} of the variance; {} V in all, to first order.",
            three_digits(std)
        )
    })
    .map(|beside| InputsBeside {
        quantity: what.clone(),
        ..beside
    })
}

/// Shares of the inputs and of the noise in a layout's error of the contact angle, whose estimate takes the inputs at their means.
pub(super) fn of_layout(study: &Study, layout: &RankedLayout) -> Option<InputsBeside> {
    let sources = layout.error_sources.as_ref()?;
    let noise = sources.noise_deg;
    let inputs = names(study).zip(sources.inputs_deg.iter().copied());
    let parts = inputs.chain([(NOISE.to_owned(), noise)]).collect();
    let told = told(parts, "degrees", |lead, std| {
        format!(
            "Where all inputs vary these films know the angle to {} degrees rms, where noise alone leaves {}: {lead} of that variance, to first order.",
            three_digits(std),
            three_digits(noise)
        )
    });
    told.map(|beside| InputsBeside {
        quantity: format!("angle's error of {}", words(layout)),
        ..beside
    })
}

fn names(study: &Study) -> impl Iterator<Item = String> {
    study.inputs.iter().map(|input| input.name.clone())
}

/// Shares of independent parts by their deviations, and the sentence that `words` makes of the first ones and of all together; `None` where nothing varies.
fn told(
    parts: Vec<(String, f64)>,
    unit: &str,
    words: impl Fn(&str, f64) -> String,
) -> Option<InputsBeside> {
    let variance: f64 = parts.iter().map(|(_, off)| off * off).sum();
    if variance == 0.0 || !variance.is_finite() {
        return None;
    }
    let share = |(input, off): (String, f64)| InputShare {
        input,
        index: off * off / variance,
        error: None,
    };
    let mut shares: Vec<InputShare> = parts.into_iter().map(share).collect();
    shares.sort_by(|a, b| b.index.total_cmp(&a.index));
    let named: Vec<String> = shares
        .iter()
        .take(NAMED)
        .enumerate()
        .map(|(place, share)| {
            let makes = if place == 0 { " makes" } else { "" };
            format!("{}{makes} {:.0} %", share.input, 100.0 * share.index)
        })
        .collect();
    let named: Vec<&str> = named.iter().map(String::as_str).collect();
    Some(InputsBeside {
        quantity: String::new(),
        sentence: words(&listed(&named), variance.sqrt()),
        std: variance.sqrt(),
        unit: unit.to_owned(),
        shares,
    })
}

#[cfg(test)]
mod tests {
    use document::Format;
    use documents::study::presets;
    use results::ErrorSources;

    use super::*;

    #[test]
    fn noise_and_inputs_share_a_layout_s_error() {
        let refuse = |path: &str| Err(path.to_owned());
        let study = Study::from_document(presets()[0].1, Format::Toml, &refuse).expect("ships");
        let layout = RankedLayout {
            spacing_deg: Some(30.0),
            units: 12,
            film_count: 12,
            position: "crown".to_owned(),
            films: vec!["y".to_owned()],
            error_sources: Some(ErrorSources {
                noise_deg: 1.0,
                inputs_deg: vec![0.0, 2.0, 0.0, 2.0, 0.0],
            }),
            ..RankedLayout::default()
        };
        let found = of_layout(&study, &layout).expect("something varies");
        assert_eq!(
            found.sentence,
            "Where all inputs vary these films know the angle to 3.00 degrees rms, where noise alone leaves 1.00: P2 makes 44 %, P4 44 % and noise 11 % of that variance, to first order."
        );
        assert_eq!((found.std, found.shares.len()), (3.0, 6));
        assert_eq!(
            found.quantity,
            "angle's error of 12 films along y at the crown, one every 30 degrees"
        );
        let still = RankedLayout {
            error_sources: None,
            ..layout
        };
        assert_eq!(of_layout(&study, &still), None);
    }
}
