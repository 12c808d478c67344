//! The analysis of models in closed form, against extended precision and exact indices.

#[path = "../support/asking.rs"]
mod asking;
mod auto;
mod convergence;
mod error_bar;
mod models;
mod reference;
