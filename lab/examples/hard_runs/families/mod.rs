//! Families of models whose indices are known, and how their runs are told.

pub mod develop;
mod draw;
mod frame;
pub mod held_out;
mod laws;
pub mod model;
mod printing;
