//! The answer in few characters, as lists of studies show it.

use layouts::simulate::simulation::LOST_DEG;
use results::{InputsAnswer, PlaceAnswer, RankedLayout, SignalsAnswer, TradeAnswer};

use super::layout_figures::{Figures, three_digits};
use crate::score::notes::listed;

/// `12 y films, 10.7 degrees`, `24 x and y films, 1.92 degrees`, `6 y films lose the contact`.
pub(super) fn of_layout(layout: &RankedLayout, trade: &TradeAnswer) -> String {
    let mut directions: Vec<&str> = layout.films.iter().map(String::as_str).collect();
    directions.sort_unstable();
    directions.dedup();
    let kinds = match directions.as_slice() {
        [] | [_, _, _, ..] => String::new(),
        few => format!("{} ", listed(few)),
    };
    let plural = if layout.film_count == 1 {
        "film"
    } else {
        "films"
    };
    let what = format!("{} {kinds}{plural}", layout.film_count);
    let figures = Figures::of(layout);
    let is_lost = figures.angle.is_some_and(|angle| angle.value > LOST_DEG);
    match is_lost {
        true => format!("{what} lose the contact"),
        false => format!("{what}, {}", figures.brief(&trade.question)),
    }
}

/// `y at the crown, 35.8 V`.
pub(super) fn of_signals(signals: &SignalsAnswer) -> String {
    let volts = three_digits(signals.open_circuit_v);
    format!(
        "{} at the {}, {volts} V",
        signals.direction, signals.position
    )
}

/// `cord position, 81 % of y`.
pub(super) fn of_inputs(inputs: &InputsAnswer) -> String {
    let first = inputs.shares.iter().take(1);
    let told = first.map(|share| {
        let percent = 100.0 * share.index;
        format!("{}, {percent:.0} % of {}", share.input, inputs.direction)
    });
    told.collect()
}

/// `P3, 73 % of x`; `P2 and P4, 12 % of x`.
pub(super) fn of_place(place: &PlaceAnswer) -> String {
    let names: Vec<&str> = place.names.iter().map(String::as_str).collect();
    format!(
        "{}, {:.0} % of {}",
        listed(&names),
        100.0 * place.index,
        place.direction
    )
}
