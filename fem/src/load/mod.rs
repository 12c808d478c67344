//! Loads of a body from outside, in reading order:
//!
//! - [`pressure`]: live pressure on a surface
//! - [`traction`]: dead forces on a surface
//! - [`obstacle`] and the [`ground_shape`] on it, [`friction`], [`contact`]: rigid ground and contact with it

pub mod contact;
pub mod friction;
pub mod ground_shape;
pub mod obstacle;
pub mod pressure;
pub mod traction;
