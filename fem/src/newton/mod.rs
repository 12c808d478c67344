//! Equilibrium, in reading order:
//!
//! - `focus`, `condensed_contact`, `pressing_ground`, [`tangent`]: linear body, nonlinear contact
//! - `acceleration`, [`iteration`]: Newton's method under given loads
//! - [`volume_control`]: equilibrium at a given volume of a cavity, and limit points
//! - [`watch`]: who hears how far a solve is, and may stop it
//! - [`state_rate`]: derivative of an equilibrium by a parameter
//! - [`path`]: load stepping with automatic cut-back

pub(crate) mod acceleration;
pub(crate) mod condensed_contact;
pub(crate) mod focus;
pub mod iteration;
pub mod path;
pub(crate) mod pressing_ground;
pub mod state_rate;
pub mod tangent;
pub mod volume_control;
pub mod watch;
