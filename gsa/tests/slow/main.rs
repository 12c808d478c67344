//! Tests that take a minute or two: methods on many models, and whether claimed errors cover the true ones.

mod asking;
mod attack;
mod closed_models;
mod coverage;
mod known;
mod methods;
mod models;
mod properties;
mod random_study;
