//! Gait of a foot: strokes of a crank that press a tire onto flat ground, at one wheel angle a stance.
//!
//! - [`stance`]: one turn of the crank, and where the ground is at an instant of it
//! - `drawn_gait`: the stances of a run, and the contact at the instants of a clock

pub(crate) mod drawn_gait;
pub mod stance;
