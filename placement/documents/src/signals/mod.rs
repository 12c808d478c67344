//! Films' signals, as a study asks for them.
//!
//! - [`signal_settings`]: what is asked, read by `signal_reader`
//! - [`series`]: the pressings and scenes that follow from it

pub mod series;
pub(crate) mod signal_reader;
pub mod signal_settings;
