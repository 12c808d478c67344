//! Films' signals over load, pressure and contact angle: what a published study measured, computed.
//!
//! - `measuring`: solves them, on the study's mesh and the coarser one
//! - `answers`: what one mesh answers, read as bare, transferred and coupled films; `tension_transfer` is the matrix between them
//! - `signal_rows`, `signal_curves`, `signal_claims`: readings with their errors, their curves, and what holds of what is claimed
//! - `amplifier_notes`: readings that an amplifier can't show
//! - `film_pairs`, `stress_widths`: two films against each other, and how wide the contact is felt
//! - `line_fit`, `gaussian_fit`, `curve_trend`: the mathematics

mod amplifier_notes;
pub(crate) mod answers;
pub(crate) mod curve_trend;
pub(crate) mod film_pairs;
pub(crate) mod gaussian_fit;
pub(crate) mod line_fit;
pub(crate) mod measuring;
pub(crate) mod signal_claims;
pub(crate) mod signal_curves;
pub(crate) mod signal_rows;
pub(crate) mod stress_widths;
pub(crate) mod tension_transfer;
