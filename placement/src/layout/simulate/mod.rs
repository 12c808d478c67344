//! What readings tell in truth: the [`posterior`] of angle and depth, errors by [`simulation`], and the contacts that look most [`alike`].

pub mod alike;
pub mod posterior;
pub mod simulation;
