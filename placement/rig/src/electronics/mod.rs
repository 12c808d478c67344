//! Electronics from a film's charge to the number that is stored.
//!
//! - `high_pass`: a signal whose held part leaks away
//! - `film_circuit`: a film's charge on its circuit
//! - `film_noise`: what is read beside the film
//! - `quantiser`: a converter to whole steps
//! - `film_chain`: all of that for all films of a run

pub(crate) mod film_chain;
pub(crate) mod film_circuit;
pub(crate) mod film_noise;
pub(crate) mod high_pass;
pub(crate) mod quantiser;
