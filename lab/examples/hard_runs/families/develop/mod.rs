//! Families that the constants of claims were set on: those of the beginning, two sets that were held out then and looked at, and sections that
//! are singular.

mod early;
mod formerly_held_out;
mod second_held_out;
mod singular;

use crate::families::frame::Families;

pub const SETS: [Families; 4] = [
    early::FAMILIES,
    formerly_held_out::FAMILIES,
    second_held_out::FAMILIES,
    singular::FAMILIES,
];
