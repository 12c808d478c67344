//! Layouts of films around the wheel: which tell how much of contact angle and depth. Pure: what films read in, scores out.
//!
//! - [`arrangement`]: films around the wheel
//! - [`field`]: what films read around the wheel
//! - [`fisher`]: bounds of errors, and what each kind of film knows
//! - [`simulate`]: errors of estimates from noisy readings
//! - [`search`]: the best of many layouts
//! - [`ranking`]: layouts in their order

pub mod arrangement;
pub mod field;
pub mod fisher;
pub mod ranking;
pub mod search;
pub mod simulate;
