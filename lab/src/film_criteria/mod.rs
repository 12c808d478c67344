//! Kinds of film by other criteria, beside what one film of each knows of angle and depth.
//!
//! - [`study_films`]: what a study's kinds of film read
//! - [`modes`]: the leading modes of what they read together
//! - [`pivots`]: which of them to take by pivoted QR, and how independent each is
//! - [`criteria`]: all criteria side by side, and how far they agree

pub mod criteria;
pub mod modes;
pub mod pivots;
pub mod study_films;
