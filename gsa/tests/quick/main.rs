//! Tests that take seconds: the laws and their rules, and which form answers, models with a symmetry, and polynomials.

mod decisions;
mod law_data;
mod law_properties;
mod laws;
mod polynomial_models;
mod probabilities;
mod rules;
mod symmetric;
