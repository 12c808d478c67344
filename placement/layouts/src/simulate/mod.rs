//! Estimates from readings: the [`posterior`] of angle and depth, errors by [`simulation`] with [`draws`] of noise from [`normal_pairs`] and [`drawn_contacts`], and the contacts that look most [`alike`].
//!
//! The posterior is that of a `reading_likelihood`, with products that are turned to each angle in `turned_products`, on a `posterior_grid`; `lanes` adds them up.

pub mod alike;
pub mod drawn_contacts;
pub mod draws;
mod lanes;
pub mod normal_pairs;
pub mod posterior;
mod posterior_grid;
pub(crate) mod reading_likelihood;
pub mod simulation;
mod turned_products;
