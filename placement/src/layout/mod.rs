//! Layouts: which films around the wheel tell how much of contact angle and depth.
//!
//! - [`layout_settings`]: what a document asks for
//! - [`arrangement`]: films around the wheel
//! - [`solving`]: what is solved for layouts, on a mesh that is fine as far as films see
//! - [`field`]: what films read around the wheel
//! - [`fisher`]: bounds of errors
//! - [`simulate`]: errors of estimates from noisy readings
//! - [`search`]: the best of many layouts
//! - [`opinions`]: other criteria, and how far they agree
//! - [`ranking`]: layouts in their order

pub mod arrangement;
pub mod field;
pub mod fisher;
pub mod layout_settings;
pub mod opinions;
pub mod ranking;
pub mod search;
pub mod simulate;
pub mod solving;
