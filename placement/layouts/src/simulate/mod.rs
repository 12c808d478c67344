//! Estimates from readings: the `posterior` of angle and depth, errors by [`simulation`] with [`draws`] of noise from [`normal_pairs`] and [`drawn_contacts`], and the contacts that look most [`alike`].
//!
//! The posterior is that of a `reading_likelihood` on a `posterior_grid`, by a `reading_density`: a `separated_density`, with products that are turned to each angle in `turned_products` and added up by `lanes`, or a `joint_density` of films that scatter together or by their signals.

pub mod alike;
pub mod drawn_contacts;
pub mod draws;
mod joint_density;
mod lanes;
pub mod normal_pairs;
mod posterior;
mod posterior_grid;
mod reading_density;
pub(crate) mod reading_likelihood;
mod separated_density;
pub mod simulation;
mod turned_products;
