//! Estimates from readings: the [`posterior`] of angle and depth, errors by [`simulation`] with noise of [`normal_pairs`], and the contacts that look most [`alike`].

pub mod alike;
pub mod normal_pairs;
pub mod posterior;
pub mod simulation;
