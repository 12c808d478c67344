//! A virtual rig, as a study asks for it.
//!
//! - [`gait_settings`]: how often, where and how hard it steps
//! - [`rig_settings`]: all else that can be set

pub mod gait_settings;
pub mod rig_settings;
