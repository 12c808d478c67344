//! Layouts: which films around the wheel tell how much of contact angle and depth.
//!
//! - [`layout_settings`]: what a document asks for
//! - [`arrangement`]: films around the wheel; [`film_extent`]: the rectangle that a film covers
//! - [`solving`]: what is solved for layouts, on a mesh that is fine as far as films see
//! - [`field`]: what films read around the wheel
//! - [`fisher`]: bounds of errors
//! - [`simulate`]: errors of estimates from noisy readings
//! - [`search`]: the best of many layouts
//! - [`opinions`]: other criteria, and how far they agree
//! - [`ranking`]: layouts in their order
//! - [`by_hand`]: layouts that somebody moves, from what is stored

pub mod arrangement;
pub mod by_hand;
pub mod field;
pub mod film_extent;
pub mod fisher;
pub mod layout_settings;
pub mod opinions;
pub mod ranking;
pub mod search;
pub mod simulate;
pub mod solving;
