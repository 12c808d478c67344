//! Rules of several tables of a recipe.

use document::fault::Fault;
use document::fields::Fields;

/// Most rows of a window.
pub(super) const MOST_WINDOW: u64 = 10_000;

/// Adds a fault where a list has an entry twice.
pub(super) fn each_once<T: PartialEq>(
    items: &[T],
    name: &str,
    fields: &Fields<'_>,
    faults: &mut Vec<Fault>,
) {
    let is_there_before =
        |(place, item): (usize, &T)| items.iter().take(place).any(|other| other == item);
    if items.iter().enumerate().any(is_there_before) {
        Fault::add(faults, &fields.at(name), "must name each entry once");
    }
}
