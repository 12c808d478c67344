//! Families of models whose indices are known, and how their runs are told.

pub mod develop;
mod draw;
pub mod held_out;
pub mod model;
mod printing;
