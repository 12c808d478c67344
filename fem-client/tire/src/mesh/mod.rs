//! The structured mesh of a tire, in reading order:
//!
//! - [`lines`]: where its bricks begin and end
//! - [`tire_grid`]: nodes and bricks
//! - `faces`: its surfaces, and points of them
//! - `mirror`: its states, left and right exchanged

mod faces;
pub mod lines;
mod mirror;
pub mod tire_grid;
