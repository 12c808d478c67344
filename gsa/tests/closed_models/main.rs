//! The analysis of models in closed form, against extended precision and exact indices.

mod auto;
mod error_bar;
mod models;
mod reference;
