//! Families that the constants of claims were set on: those of the beginning, a set that was held out then and looked at, and sections that are
//! singular.

mod early;
mod formerly_held_out;
mod singular;

use crate::families::frame::Families;

pub const SETS: [Families; 3] = [
    early::FAMILIES,
    formerly_held_out::FAMILIES,
    singular::FAMILIES,
];
