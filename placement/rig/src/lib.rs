//! A virtual rig: what films and a force sensor record while a foot steps, and what can be learnt of it. Pure: a tire's answer and settings in, numbers out.
//!
//! - [`contact_response`]: what a rig asks of a tire with its films
//! - [`gait`]: strokes of a crank that press the tire onto the ground
//! - `even_clock`, `seeded_draws`: instants of a clock, and random numbers by seed, run and purpose
//! - [`relaxation`]: how much more the rubber bears at first
//! - [`electronics`]: from a film's charge to the number that is stored
//! - `pressed_tire`: charges and forces of one contact after another
//! - [`rig_run`]: one run, both clocks
//! - [`run_csv`]: a run as a recording that `strainsite force fit` reads
//! - [`force_error`]: how well forces are known by what a rig records

#[cfg(test)]
pub(crate) mod bump_response;
pub mod contact_response;
pub mod electronics;
pub(crate) mod even_clock;
pub mod force_error;
pub mod gait;
pub(crate) mod pressed_tire;
pub mod relaxation;
pub mod rig_run;
pub mod run_csv;
pub(crate) mod seeded_draws;
