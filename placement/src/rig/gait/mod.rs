//! How a foot steps: strokes of a crank that press a tire onto flat ground, at one wheel angle a stance.
//!
//! - [`gait_settings`]: how often, where and how hard
//! - [`gait_reader`]: reads them
//! - [`stance`]: one turn of the crank, and where the ground is at an instant of it
//! - [`drawn_gait`]: the stances of a run, and the contact at the instants of a clock

pub mod drawn_gait;
pub mod gait_reader;
pub mod gait_settings;
pub mod stance;
