//! What takes seconds: the laws and their rules, and which form answers.

mod decisions;
mod law_data;
mod law_properties;
mod laws;
mod probabilities;
mod rules;
