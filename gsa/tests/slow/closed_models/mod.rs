//! The analysis of models in closed form, against extended precision and exact indices.

mod closed_model;
mod error_bar;
mod orders;
mod reference;
mod tolerance;
