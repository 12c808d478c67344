//! What takes seconds: the laws and their rules, and which form answers, and models with a symmetry.

mod decisions;
mod law_data;
mod law_properties;
mod laws;
mod probabilities;
mod rules;
mod symmetric;
