//! Laws of the inputs and their Gauss rules, in reading order:
//!
//! - `recurrence`, `golub_welsch`, `basis`, [`rule`]: orthogonal polynomials and the rules that follow from them
//! - `density`, `panel`, `discretisation`, `probability`: laws without a closed recurrence
//! - [`distribution`], [`catalogue`]: the laws, and their names in documents
//! - `polynomials`: orthonormal polynomials of a law

pub(crate) mod basis;
pub mod catalogue;
pub(crate) mod density;
pub(crate) mod discretisation;
pub mod distribution;
pub(crate) mod golub_welsch;
pub(crate) mod panel;
pub(crate) mod polynomials;
pub(crate) mod probability;
pub(crate) mod recurrence;
pub mod rule;
